#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Two builds of the program, array by array: proves that a change which only moves code changes no bit.

Usage: same_bits.py OLD NEW [--steps N] [--whole] [-np N] [SCENE.yaml ...]

Runs each scene (default: every scene of the cases) for N steps (default 300; --whole: to its end) with both programs and
compares the arrays of their last checkpoints bit by bit: displacement, velocity, stresses, histories, records of contact.
A table: scene, steps, arrays that are equal, those that differ with the largest difference, those that one of the two
alone has. A scene of the cases that OLD cannot read is named and left out. Exit codes: 0 all the same, 1 some array
differs or a run ended otherwise, 2 wrong usage.
"""
import argparse
import glob
import json
import os
import subprocess
import sys
import tempfile

import h5py
import numpy

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def scenes_of_cases():
    paths = sorted(glob.glob(os.path.join(ROOT, "cases", "*", "*.yaml")))
    return [p for p in paths if any(line.startswith("mesh:") for line in open(p, encoding="utf-8"))]


def reads(program, scene):
    """Has the program the words that this scene uses? An older one may not."""
    as_root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    return subprocess.run([os.path.abspath(program), "check", scene], capture_output=True, env=os.environ | as_root).returncode != 2


def run(program, scene, folder, arguments):
    command = [os.path.join(ROOT, "scripts", "run"), "-np", str(arguments.np), scene, "--out", folder, "--quiet"]
    if not arguments.whole:
        command += ["--set", f"run.steps={arguments.steps}"]
    done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "BRUNT": program})
    if done.returncode not in (0, 3):
        sys.exit(f"same_bits: {program} {scene}: exit code {done.returncode}\n{done.stderr}")
    return done.returncode


def arrays(folder):
    """Name: array of the last checkpoint."""
    found = {}
    with h5py.File(sorted(glob.glob(os.path.join(folder, "checkpoint_*.h5")))[-1]) as file:
        file.visititems(lambda name, item: found.__setitem__(name, item[()]) if isinstance(item, h5py.Dataset) else None)
    return found


def difference(one, other):
    """Text that tells how two arrays differ; empty where all bits are the same."""
    if one.shape != other.shape:
        return f"{one.shape} and {other.shape}"
    if one.tobytes() == other.tobytes():
        return ""
    with numpy.errstate(invalid="ignore"):
        return f"{numpy.nanmax(numpy.abs(one - other)):.2g} of {numpy.nanmax(numpy.abs(one)):.2g}"


def compare(old, new):
    """(number of equal arrays, texts of those that are not)."""
    equal, faults = 0, []
    for name in sorted(set(old) | set(new)):
        if name.startswith("measured/"):  # times
            continue
        if name not in old or name not in new:
            faults.append(f"{name}: in the {'new' if name in new else 'old'} one alone")
            continue
        text = difference(old[name], new[name])
        if text:
            faults.append(f"{name}: {text}")
        else:
            equal += 1
    return equal, faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--steps", type=int, default=300)
    parser.add_argument("--whole", action="store_true")
    parser.add_argument("-np", type=int, default=1)
    arguments = parser.parse_intermixed_args()
    differ = False
    for scene in arguments.scenes or scenes_of_cases():
        if not arguments.scenes and not reads(arguments.old, scene):
            print(f"{os.path.relpath(scene, ROOT):40} not for the old program")
            continue
        with tempfile.TemporaryDirectory() as folder:
            codes = [run(os.path.abspath(p), scene, os.path.join(folder, n), arguments)
                     for n, p in (("old", arguments.old), ("new", arguments.new))]
            equal, faults = compare(arrays(os.path.join(folder, "old")), arrays(os.path.join(folder, "new")))
            with open(os.path.join(folder, "new", "summary.json"), encoding="utf-8") as stream:
                steps = json.load(stream)["steps"]
        if codes[0] != codes[1]:
            faults.append(f"exit codes {codes[0]} and {codes[1]}")
        print(f"{os.path.relpath(scene, ROOT):40} {steps:7} steps  {equal:3} arrays the same"
              + "".join(f"\n    {fault}" for fault in faults), flush=True)
        differ = differ or bool(faults)
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
