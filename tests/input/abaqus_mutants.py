#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Abaqus input files, right ones in many ways of writing and damaged ones, against a parser written from the rules alone.

A right one is read. A damaged one is refused with a line, or both readers agree on nodes, elements, volumes, sets and
faces. The table of keywords in src/io/README.md is that of the program. Usage: abaqus_mutants.py --reader PROGRAM --length short|long"""
import argparse
import collections
import json
import os
import random
import re
import subprocess
import sys
import tempfile

import abaqus_damage
import abaqus_decks
import abaqus_model
from abaqus_parser import Invalid, volume

ROUNDING = 1e-9  # of coordinates and volumes, relative to the largest: decks have ten digits
COUNTS = {"short": (150, 500), "long": (2000, 10000)}  # right decks, damaged ones
README = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../src/io/README.md")


class Program:
    def __init__(self, reader, folder):
        self.process = subprocess.Popen([reader], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8", errors="replace")
        self.folder = folder

    def read(self, texts):
        for name, text in texts.items():
            with open(os.path.join(self.folder, name), "wb") as stream:
                stream.write(text)
        path = os.path.join(self.folder, abaqus_decks.MAIN)
        self.process.stdin.write(path + "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline()
        return path, json.loads(answer) if answer else {"failed": "the reader has ended"}


def differences(answer, mesh):
    """What the program reads otherwise than the parser."""
    found = []
    scale = max([1.0] + [abs(x) for place in mesh.nodes for x in place])
    near = len(answer["nodes"]) == len(mesh.nodes) and all(
        abs(a - b) <= ROUNDING * scale for one, other in zip(answer["nodes"], mesh.nodes) for a, b in zip(one, other))
    if not near:
        found.append(f"nodes: {len(answer['nodes'])} for {len(mesh.nodes)}, or other places")
    counts, volumes = collections.Counter(), collections.Counter()
    for block in answer["blocks"]:
        counts[block["name"]] += len(block["elements"])
        volumes[block["name"]] += sum(volume([answer["nodes"][n] for n in e]) for e in block["elements"])
    if dict(counts) != {name: len(elements) for name, elements in mesh.blocks.items()}:
        found.append(f"elements: {dict(counts)} for { {n: len(e) for n, e in mesh.blocks.items()} }")
    elif any(abs(volumes[name] - size) > ROUNDING * max(1.0, size) for name, size in mesh.volumes.items()):
        found.append(f"volumes: {dict(volumes)} for {mesh.volumes}")
    if answer["node_sets"] != mesh.node_sets:
        found.append(f"node sets: {answer['node_sets']} for {mesh.node_sets}")
    sides = {name: sorted(sorted(set(face)) for face in faces) for name, faces in answer["side_sets"].items()}
    if sides != mesh.side_sets:
        found.append(f"faces: {sides} for {mesh.side_sets}")
    foreign = collections.Counter()
    for _, kind, count in answer["left_out"]:
        foreign[kind] += count
    if dict(foreign) != mesh.foreign:
        found.append(f"other elements: {dict(foreign)} for {mesh.foreign}")
    return found


def fault_of(program, texts, right, size=None):
    """(a fault of the program or '', whether it read the deck)"""
    path, answer = program.read(texts)
    if "failed" in answer:
        return "failed: " + answer["failed"], False
    if "refused" in answer:
        placed = all(re.match(re.escape(program.folder) + r"/[a-z.]+:", line) for line in answer["refused"].splitlines()[:1])
        if right:
            return "a right deck is refused: " + answer["refused"], False
        return "" if placed and "; expected" in answer["refused"] else "a message without place or cure: " + answer["refused"], False
    try:
        mesh = abaqus_model.read(path)
    except Invalid as error:
        return f"read, but the rules give no meaning: {error}", True
    found = differences(answer, mesh)
    if size is not None and abs(sum(mesh.volumes.values()) - size) > ROUNDING * max(1.0, size):
        found.append(f"volume {sum(mesh.volumes.values())} for {size} by hand")
    return "; ".join(found), True


def table_faults(reader):
    """Rows of src/io/README.md: | `*KEYWORD` | read | without effect | refused |."""
    known = json.loads(subprocess.run([reader, "--keywords"], capture_output=True, text=True, check=True).stdout)
    rows = {}
    with open(README, encoding="utf-8") as stream:
        for line in stream:
            cells = [c.strip() for c in line.split("|")]
            if len(cells) == 6 and cells[1].startswith("`*"):
                for word in re.findall(r"`\*([A-Z ]+)`", cells[1]):
                    rows[word] = [sorted(re.findall(r"`([A-Z ]+)`", c)) for c in cells[2:5]]
    with open(README, encoding="utf-8") as stream:
        text = stream.read()
    faults = [f"src/io/README.md: no row of *{word}" for word in known if word not in rows and known[word]["effect"] != "refused"]
    faults += [f"src/io/README.md: nothing about *{word}" for word in known if f"`*{word}`" not in text]
    for word, row in rows.items():
        of = known.get(word, {"parameters": {}})["parameters"]
        for effect, written in zip(("read", "none", "refused"), row):
            if sorted(w.replace(" ", "") for w in written) != sorted(p for p, e in of.items() if e == effect):
                faults.append(f"src/io/README.md: *{word}, {effect}: {written}")
    return faults


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--reader", required=True)
    options.add_argument("--length", choices=COUNTS, default="short")
    options.add_argument("--seed", type=int)
    options.add_argument("--show", type=int, default=5)
    options = options.parse_args()
    right, damaged = COUNTS[options.length]
    seed = options.seed if options.seed is not None else {"short": 1, "long": 2}[options.length]
    faults, read, of_kind = table_faults(options.reader), collections.Counter(), collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        program = Program(options.reader, folder)
        for k in range(right + damaged):
            rng = random.Random(f"{seed}/{k}")
            deck, size = abaqus_decks.right_deck(rng)
            kind, texts = ("right", abaqus_decks.disguise(rng, deck)) if k < right else abaqus_damage.damage(rng, deck)
            fault, is_read = fault_of(program, texts, k < right, size if k < right else None)
            of_kind[kind] += 1
            read[kind] += is_read
            if fault:
                faults.append(f"{kind}, seed {seed}/{k}: {fault[:600]}")
                if len(faults) <= options.show:
                    for name, text in texts.items():
                        print(f"--- {name}\n" + text.decode("latin-1").replace("\r", "\n"))
        program.process.stdin.close()
        program.process.wait()
    for kind, count in sorted(of_kind.items()):
        print(f"{kind}: {count} decks, {read[kind]} read and equal or faulty, {count - read[kind]} refused")
    for fault in faults[:50]:
        print(fault)
    print(f"{len(faults)} fault(s)")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
