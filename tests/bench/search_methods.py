#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Seconds a search by method: in the runs of all explicit cases, whose hashes must not depend on it, and by the number of nodes.

usage: search_methods.py [--brunt PROGRAM] [--cases | --nodes] [--most N] > table.md
    --cases: a table over the scenes of cases/*/scene.yaml with contact between bodies, each for 1 % of its time, one rank
    --nodes: plates of 10^4 to N nodes (default 10^6) on each other, by `brunt search`
"""
import argparse
import glob
import json
import os
import random
import re
import subprocess
import sys
import tempfile

PROJECT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
METHODS = ("blocks", "binary", "bucket")


def seconds_of_run(brunt, scene, method, end, out):
    """(microseconds a search, searches, hash) of a run, or None where it has no search."""
    done = subprocess.run([brunt, "run", scene, "--set", f"search.method={method}", "--set", f"run.end={end}", "--out", out, "--force", "--quiet"],
                          capture_output=True, text=True, check=False)
    if done.returncode:
        return None
    with open(os.path.join(out, "summary.json"), encoding="utf-8") as stream:
        summary = json.load(stream)
    searches = summary["contact"]["searches"]
    if not searches or not summary["contact"]["pairs"]:
        return None
    return 1e6 * summary["share"]["search"] * summary["loop_s"] / searches, searches, summary["state_hash"], summary["nodes"]


def cases(brunt):
    print("| case | nodes | searches | " + " | ".join(f"{m} [us]" for m in METHODS) + " |")
    print("|---|---:|---:|" + "---:|" * len(METHODS))
    with tempfile.TemporaryDirectory() as folder:
        for scene in sorted(glob.glob(os.path.join(PROJECT, "cases", "*", "scene.yaml"))):
            with open(scene, encoding="utf-8") as stream:
                end = re.search(r"^run:.*?\bend: ([0-9.e+-]+)", stream.read(), re.M | re.S)
            if not end:
                continue
            found = [seconds_of_run(brunt, scene, m, float(end.group(1)) / 100, os.path.join(folder, "o")) for m in METHODS]
            if None in found:
                continue
            if len({f[2] for f in found}) > 1:
                sys.exit(f"{scene}: the state depends on the method")
            name = os.path.basename(os.path.dirname(scene))
            print(f"| {name} | {found[0][3]} | {found[0][1]} | " + " | ".join(f"{f[0]:.0f}" for f in found) + " |", flush=True)


def write_plates(path, side):
    """Two plates of side^2 nodes in all: nodes of the upper one, capture boxes of the faces of the lower one."""
    chance = random.Random(side)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(f"scene1 plates {side * side} {(side - 1) ** 2}\n")
        for i in range(side):
            for j in range(side):
                stream.write(f"{i + chance.uniform(0, 0.3):.6f} {j + chance.uniform(0, 0.3):.6f} {chance.uniform(0, 0.3):.6f}\n")
        for i in range(side - 1):
            for j in range(side - 1):
                stream.write(f"{i - 0.2} {j - 0.2} -0.2 {i + 1.2} {j + 1.2} 0.2 -1 -1 -1 -1\n")


def nodes(brunt, most):
    print("| nodes | " + " | ".join(f"{m}: sort, find [ms]" for m in METHODS) + " |")
    print("|---:|" + "---:|" * len(METHODS))
    with tempfile.TemporaryDirectory() as folder:
        side = 100
        while side * side <= most:
            path = os.path.join(folder, "plates.txt")
            write_plates(path, side)
            cells, hashes = [], set()
            for method in METHODS:
                told = json.loads(subprocess.run([brunt, "search", path, "--method", method, "--repeat", "5"], capture_output=True, text=True, check=True).stdout)
                cells.append(f"{1e3 * told['build_s']:.2f}, {1e3 * told['query_s']:.2f}")
                hashes.add(told["pairs_hash"])
            if len(hashes) > 1:
                sys.exit(f"{side}: the pairs depend on the method")
            print(f"| {side * side} | " + " | ".join(cells) + " |", flush=True)
            side = round(side * 10**0.5)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--brunt", default=os.path.join(PROJECT, "build/release/brunt"))
    parser.add_argument("--cases", action="store_true")
    parser.add_argument("--nodes", action="store_true")
    parser.add_argument("--most", type=int, default=1_000_000)
    options = parser.parse_args()
    if options.cases or not options.nodes:
        cases(options.brunt)
    if options.nodes or not options.cases:
        nodes(options.brunt, options.most)


if __name__ == "__main__":
    main()
