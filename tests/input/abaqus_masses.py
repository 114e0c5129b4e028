#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Masses and sizes of sets that `brunt check` prints for Abaqus input files, against a parser written from the rules alone.
Usage: abaqus_masses.py --brunt PROGRAM --count N"""
import argparse
import os
import random
import re
import subprocess
import sys
import tempfile

import abaqus_decks
import abaqus_model

DENSITY = 1000.0
SIX_DIGITS = 1e-5  # as printed


def scene(mesh):
    kind = lambda elements: "tet4" if len(elements[0]) == 4 else "hex8"  # noqa: E731
    parts = ", ".join(f"p{k}: {{block: '{name}', material: m, element: {kind(elements)}}}" for k, (name, elements) in enumerate(mesh.blocks.items()))
    return (f"units: SI\nmesh: {{file: {abaqus_decks.MAIN}}}\nmaterials: {{m: {{model: elastic, density: {DENSITY}, young: 1.0e6, poisson: 0}}}}\n"
            f"parts: {{{parts}}}\nrun: {{steps: 1}}\n")


def fault_of(brunt, folder, seed):
    rng = random.Random(f"mass/{seed}")
    for name, text in abaqus_decks.disguise(rng, abaqus_decks.right_deck(rng)[0]).items():
        with open(os.path.join(folder, name), "wb") as stream:
            stream.write(text)
    mesh = abaqus_model.read(os.path.join(folder, abaqus_decks.MAIN))
    path = os.path.join(folder, "scene.yaml")
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(scene(mesh))
    run = subprocess.run([brunt, "check", path], capture_output=True, text=True)
    if run.returncode:
        return f"exit code {run.returncode}: {run.stderr}{run.stdout[-300:]}"
    for k, (name, elements) in enumerate(mesh.blocks.items()):
        row = re.search(rf"^p{k} .*$", run.stdout, re.M)
        count, mass = (float(w) for w in row.group().split()[-2:]) if row else (0, 0)
        expected = DENSITY * mesh.volumes[name]
        if count != len(elements) or abs(mass - expected) > SIX_DIGITS * expected:
            return f"block {name}: {row.group() if row else 'no row'} for {len(elements)} elements of mass {expected}\n{run.stdout}"
    return ""


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--brunt", required=True)
    options.add_argument("--count", type=int, default=8)
    options = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        faults = [f"deck {k}: {fault}" for k in range(options.count) if (fault := fault_of(options.brunt, folder, k))]
    for fault in faults:
        print(fault)
    print(f"{options.count} decks, {len(faults)} fault(s)")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
