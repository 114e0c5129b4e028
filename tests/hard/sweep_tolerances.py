#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Which numbers of contact do the tests hold, and within which range? Usage:

  sweep_tolerances.py BINARY [BINARY...] [--name N]... [--factors F,F...] [--tests SPEC] [--minutes M] [--jobs N]

Runs each test binary (hard, unit_contact_detection) with one number of src/contact/data/tolerances.hpp
multiplied by each factor (default 0.1,0.25,0.5,2,4,10), and prints a markdown table: for each number the range of its
values in which all tests pass, and the first test that fails below and above. Factors are tried outwards from 1; past
the first that fails none is tried. SPEC chooses tests of a binary whose name begins with hard: a Catch2 specification.
Tests that fail with no number changed are left out of the judgement. Exit code 0; 2 for wrong usage.
"""
import argparse
import os
import re
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
HEADER = os.path.join(ROOT, "src", "contact", "data", "tolerances.hpp")
FACTORS = "0.1,0.25,0.5,2,4,10"
ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_pml": "ob1",
               "OMPI_MCA_btl": "self,vader", "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
               "OMPI_MCA_hwloc_base_binding_policy": "none"}


def numbers():
    """Name: value, in the order of the header."""
    text = open(HEADER, encoding="utf-8").read()
    return {name: float(value) for name, value in re.findall(r"^  double (\w+) = ([^;]+);", text, re.M)}


def failures(binary, specification, overrides, limit=900):
    """Names of the test cases that fail."""
    environment = {**os.environ, **ENVIRONMENT, "BRUNT_TOLERANCES": overrides}
    command = [binary, "-r", "xml"] + ([specification] if specification and os.path.basename(binary).startswith("hard") else [])
    try:
        done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=limit)
    except subprocess.TimeoutExpired:
        return {f"{os.path.basename(binary)}: no end after {limit} s"}
    found = set()
    for case in re.finditer(r'<TestCase name="([^"]*)"(.*?)</TestCase>', done.stdout, re.S):
        if 'success="false"' in case.group(2).rsplit("<OverallResult", 1)[-1]:
            found.add(case.group(1))
    if done.returncode != 0 and not found:
        found.add(f"{os.path.basename(binary)}: ended with code {done.returncode}")
    return found


class Sweep:
    def __init__(self, arguments):
        self.arguments = arguments
        self.end = time.monotonic() + 60 * arguments.minutes
        self.known = self.run("")
        for name in sorted(self.known):
            print(f"fails as it is: {name}", file=sys.stderr)

    def run(self, overrides):
        found = set()
        for binary in self.arguments.binaries:
            found |= failures(binary, self.arguments.tests, overrides)
            if found - getattr(self, "known", found):
                break  # one is enough
        return found

    def side(self, name, value, factors):
        """Outwards: the last value that passes, and the test that stops the next one."""
        last = value
        for factor in factors:
            if time.monotonic() > self.end:
                return last, "(not tried further)"
            found = self.run(f"{name}={value * factor!r}") - self.known
            print(f"{name} = {value * factor:g}: {'; '.join(sorted(found)) or 'passes'}", file=sys.stderr, flush=True)
            if found:
                return last, sorted(found)[0]
            last = value * factor
        return last, ""

    def row(self, item):
        name, value = item
        factors = [float(f) for f in self.arguments.factors.split(",")]
        low, below = self.side(name, value, sorted((f for f in factors if f < 1), reverse=True))
        high, above = self.side(name, value, sorted(f for f in factors if f > 1))
        return f"| `{name}` | {value:g} | {low:g} to {high:g} | {below or '-'} | {above or '-'} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("binaries", nargs="+")
    parser.add_argument("--name", action="append", default=[])
    parser.add_argument("--factors", default=FACTORS)
    parser.add_argument("--tests", default="~[long]")
    parser.add_argument("--minutes", type=float, default=1e9)
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    known = numbers()
    for name in arguments.name:
        if name not in known:
            sys.exit(f"sweep_tolerances: unknown --name {name}; expected one of {', '.join(known)}")
    chosen = [(name, value) for name, value in known.items() if not arguments.name or name in arguments.name]
    sweep = Sweep(arguments)
    print("| number | value | all tests pass | fails below | fails above |\n|---|---|---|---|---|", flush=True)
    with ThreadPoolExecutor(arguments.jobs) as pool:
        for line in pool.map(sweep.row, chosen):
            print(line, flush=True)


if __name__ == "__main__":
    main()
