#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Every key, column and table that a run writes is told in src/io/README.md, and every one told there is written. Needs BRUNT, BRUNT_RUN
(scripts/run) and BRUNT_CASES (the folder cases/) in the environment."""
import csv
import os
import re
import unittest

import h5py

import scenes
from run_test import Program

TOLD = os.path.join(os.path.dirname(os.environ["BRUNT_CASES"]), "src", "io", "README.md")
PROBES = """\
rigid_walls: [{point: [0, 0, -3], normal: [0, 0, 1]}]
probes:
  - {name: tip, node: 1, field: velocity}
  - {name: face, set: head, field: displacement}
  - {name: body, part: table, field: position}
  - {name: foot, set: foot, field: reaction}
  - {name: press, contact: [rod, table]}
  - {name: wall, wall: wall0}
  - {name: load, part: rod, field: mass}
  - {name: store, part: rod, field: energy}
  - {name: push, part: rod, field: momentum}
  - {name: spin, part: rod, field: angular_momentum}
  - {name: cut, section: {part: rod, set: head}}
output: {every: 1.0e-5, fields: [displacement, velocity, stress, plastic_strain, contact_pressure, gap, mass, stress_bottom, stress_top, thickness]}
"""
UNITS = {"time": "s", "energy": "J", "mass": "kg", "momentum": "N.s", "length": "m", "velocity": "m/s", "force": "N", "moment": "N.m",
         "angular momentum": "N.s.m", "1": ""}


def told(heading):
    """Names in the first column of the heading's table, with the second."""
    with open(TOLD, encoding="utf-8") as stream:
        section = re.search(rf"^## {re.escape(heading)}\n(.*?)(?=^## |\Z)", stream.read(), re.M | re.S).group(1)
    rows = [row.split("|") for row in section.splitlines() if row.startswith("| `")]
    return {name: row[2].strip() for row in rows for name in re.findall(r"`([^`]+)`", row[1])}


def paths(tree, before=""):
    for key, value in tree.items():
        yield from paths(value, f"{before}{key}.") if isinstance(value, dict) else [before + key]


def names_in(file):
    found = {f":{name}" for name in file.attrs}

    def visit(path, entry):
        path = re.sub(r"record_\d+", "record_R", re.sub(r"block_\d+", "block_B", path))
        found.update(f"{path}:{name}" for name in entry.attrs)
        if isinstance(entry, h5py.Dataset):
            found.add(path)

    file.visititems(visit)
    return found


class Told(Program):
    def setUp(self):
        super().setUp()
        self.write("rod.yaml", scenes.ROD + PROBES)
        self.run_scene(1, "rod.yaml", "--out", "out", "--set", "materials.steel.model=j2", "--set", "materials.steel.yield=4e8")

    def test_summary(self):
        self.assertEqual(set(paths(self.summary("out"))), set(told("summary.json")))

    def test_history(self):
        header = next(csv.reader(self.text("out", "history.csv").splitlines()))
        probes = "tip|face|body|foot|press|wall|load|store|push|spin|cut"
        written = {}
        for cell in header:
            name, _, unit = cell.partition(" [")
            written.setdefault(re.sub(rf"^(impulse_|moment_)?({probes})\.", r"\1PROBE.", name), set()).add(unit.rstrip("]"))
        columns = told("history.csv")
        self.assertEqual(set(written), set(columns))
        for name, units in written.items():
            self.assertEqual(units, {UNITS[unit] for unit in re.split(r", | or ", columns[name])}, name)

    def test_state(self):
        with h5py.File(os.path.join(self.folder, "out", "state.h5"), "r") as file:
            self.assertEqual(names_in(file), set(told("state.h5")))


if __name__ == "__main__":
    unittest.main()
