#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Elements that leave the model: the same bits on any number of ranks and after a restart between two removals, contact
on faces that were inside, ties that let go, what files and log tell.

Needs BRUNT_RUN (scripts/run) in the environment."""
import csv
import os
import re
import unittest

import h5py
import numpy

from run_test import Program, of_all


# A block of rubber on a floor loses its upper layer with its nodes, and later a corner; another one falls on what is left.
# A third is tied to its side and loses the tied layer: it falls off.
FALL = """\
units: SI
mesh:
  - {box: {part: low, size: [1, 1, 1], elements: [4, 4, 4]}}
  - {box: {part: top, size: [0.7, 0.7, 0.4], elements: [3, 3, 2], at: [0.13, 0.17, 1.01]}}
  - {box: {part: side, size: [0.5, 1, 0.5], elements: [2, 3, 2], at: [1, 0, 0.4]}}
materials:
  rubber: {model: neo_hookean, density: 1000, young: 1.0e8, poisson: 0.3}
parts:
  low: {material: rubber}
  top: {material: rubber, element: hex8_full}
  side: {material: rubber}
sets:
  layer: {part: low, box: [[0, 0, 0.75], [1, 1, 1]]}
  corner: {part: low, box: [[0, 0, 0], [0.25, 0.25, 0.25]]}
  foot: {part: side, box: [[1, 0, 0.4], [1.25, 1, 0.9]]}
initial: [{part: top, velocity: [0.3, 0, -8]}]
gravity: {vector: [0, 0, -9.81]}
rigid_walls: [{name: floor, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.2}]
contact:
  - {between: all, friction: 0.2}
  - {between: [low, side], tied: true}
remove:
  - {set: layer, at: 1.0e-3, nodes: drop}
  - {set: corner, at: 0.05}
  - {set: foot, at: 0.03}
probes:
  - {name: blow, contact: [top, low]}
  - {name: side, part: side, field: velocity}
run: {end: 0.09}
output: {every: 0.01, fields: [displacement, velocity]}
history: {every: 1.0e-4}
"""
ELEMENTS, GONE = 64 + 18 + 12, 16 + 1 + 6


# All of one part leaves with its nodes while it is driven, pressed and damped; parts that stay do so at rest.
GONE_WHOLLY = """\
units: none
mesh:
  - {box: {part: gone, size: [0.1, 0.1, 0.1], elements: [2, 2, 2]}}
  - {box: {part: half, size: [0.1, 0.1, 0.1], elements: [2, 2, 2], at: [1, 0, 0]}}
  - {box: {part: stays, size: [0.1, 0.1, 0.1], elements: [2, 2, 2], at: [2, 0, 0]}}
materials: {steel: {model: elastic, density: 8000, young: 2.0e9, poisson: 0.3}}
parts: {gone: {material: steel}, half: {material: steel}, stays: {material: steel}}
sets:
  up: {part: gone, box: [[0, 0, 0.09], [1, 1, 1]]}
  upper: {part: half, box: [[1, 0, 0.05], [2, 1, 1]]}
damping: {alpha: 100}
initial: [{part: half, velocity: [0, 0, 10]}]
pressure: [{set: gone_zmin, value: 1.0e5}]
prescribed: [{set: up, dof: z, acceleration: 1000.0}]
remove: [{part: gone, at: 1.0e-3, nodes: drop}, {set: upper, at: 1.0e-3, nodes: drop}]
probes:
  - {name: r, part: gone, field: reaction}
  - {name: m, part: gone, field: mass}
  - {name: k, part: gone, field: energy}
  - {name: p, part: gone, field: momentum}
  - {name: mh, part: half, field: mass}
  - {name: ph, part: half, field: momentum}
  - {name: kh, part: half, field: energy}
run: {end: 3.0e-3}
history: {every: 1.0e-5}
"""

# The middle of a block goes; the upper half falls on the lower one, which is the same part.
CUT = """\
units: none
mesh: {box: {part: block, size: [1, 1, 0.6], elements: [5, 5, 6]}}
materials: {rubber: {model: neo_hookean, density: 1000, young: 1.0e7, poisson: 0.3}}
parts: {block: {material: rubber}}
sets: {cut: {part: block, box: [[0, 0, 0.3], [1, 1, 0.4]]}}
initial: [{part: block, velocity: [0, 0, -1]}]
rigid_walls: [{name: floor, point: [0, 0, 0], normal: [0, 0, 1]}]
contact: [{between: all, friction: 0.1}]
remove: [{set: cut, at: 0.02, nodes: drop}]
probes: [{name: meets, contact: [block, block]}, {name: top, near: [0.5, 0.5, 0.6], field: displacement}]
run: {end: 0.25}
gravity: {vector: [0, 0, -9.81]}
history: {every: 1.0e-3}
"""


class Removal(Program):
    def go(self, scene, ranks, out, *options):
        self.write("scene.yaml", scene)
        self.run_scene(ranks, "scene.yaml", "--out", out, *options)
        return self.summary(out)

    def rows(self, out):
        rows = list(csv.DictReader(self.text(out, "history.csv").splitlines()))
        return {head.split("[")[0].strip(): numpy.array([float(row[head]) for row in rows]) for head in rows[0]}

    def test_nothing_acts_on_dropped_nodes(self):
        self.go(GONE_WHOLLY, 1, "np1")
        rows = self.rows("np1")
        after = rows["time"] > 1.1e-3  # steps are of 5e-5
        for name in ("eroded", "external"):
            self.assertGreater(abs(rows[name][-1]), 1, name)
            self.assertEqual(numpy.ptp(rows[name][after]), 0, name)
        for name in ("r.x", "r.y", "r.z", "m.mass", "p.x", "p.y", "p.z", "k.kinetic"):
            self.assertEqual(abs(rows[name][after]).max(), 0, name)
        self.assertAlmostEqual(rows["m.mass"][0], 8, delta=1e-12)
        self.assertAlmostEqual(rows["mh.mass"][-1], 6, delta=1e-12)  # nodes keep the mass that removed elements gave them
        # parts are the model: the third is at rest
        self.assertLess(abs(rows["ph.z"] + rows["p.z"] - rows["momentum_z"]).max(), 1e-10)
        self.assertLess(abs(rows["kh.kinetic"] + rows["k.kinetic"] - rows["kinetic"]).max(), 1e-9)
        self.assertLess(self.summary("np1")["energy"]["error_ratio"], 1e-12)
        self.assertEqual(self.go(GONE_WHOLLY, 2, "np2")["state_hash"], self.summary("np1")["state_hash"])

    def test_a_part_falls_on_itself_where_it_was_cut(self):
        whole = self.go(CUT, 1, "np1")
        self.assertEqual(whole["removed_elements"], 25)
        rows = self.rows("np1")
        self.assertLess(rows["top.z"].min(), -0.09)  # it falls by the cut
        self.assertGreater(rows["top.z"].min(), -0.2)  # and no deeper than what it presses in
        self.assertLess(whole["max_penetration"], 1e-3)
        self.assertLess(whole["energy"]["error_ratio"], 1e-10)
        for ranks in (2, 4):
            self.assertEqual(self.go(CUT, ranks, f"np{ranks}")["state_hash"], whole["state_hash"])
        self.go(CUT, 2, "stopped", "--set", "run.end=0.1")
        self.assertEqual(self.go(CUT, 3, "stopped", "--restart", os.path.join(self.folder, "stopped"))["state_hash"],
                         whole["state_hash"])

    def test_a_fall_on_a_face_that_was_inside(self):
        whole = self.go(FALL, 1, "np1")
        for ranks in of_all((2, 3, 4), (4,)):
            self.assertEqual(self.go(FALL, ranks, f"np{ranks}")["state_hash"], whole["state_hash"])
        stopped = self.go(FALL, 2, "stopped", "--set", "run.end=0.04", "--set", "checkpoint.every=0.04")
        self.assertEqual(stopped["removed_elements"], 16 + 6)
        continued = self.go(FALL, 3, "stopped", "--restart", os.path.join(self.folder, "stopped"), "--set",
                                   "checkpoint.every=0.04")
        self.assertEqual(continued["state_hash"], whole["state_hash"])

        self.assertEqual(whole["removed_elements"], GONE)
        told = re.findall(r"removed at t = .*", self.text("np1", "log.txt"))
        self.assertEqual(len(told), 3, told)
        self.assertIn("16 elements of low; nodes dropped: 25", told[0])
        self.assertIn("6 elements of side; mass points now: 12; nodes dropped: 25", told[1])
        self.assertIn("1 element of low; mass points now: 13; nodes dropped: 25", told[2])

        rows = self.rows("np1")
        energy = numpy.abs(rows["total"] - rows["total"][0]).max() / rows["kinetic"].max()
        self.assertLess(energy, 1e-10)
        self.assertLess(whole["momentum_error"], 1e-12)
        self.assertGreater(rows["eroded"][-1], 0)
        blow = rows["time"][rows["impulse_blow.z"] > 0][0]
        self.assertGreater(blow, 0.25 / 8.3)  # not on the layer, which was 0.01 away
        self.assertLess(blow, 0.27 / 8)
        self.assertLess(whole["max_penetration"], 0.01 * 0.25)
        self.assertLess(rows["side.z"][-1], rows["side.z"][rows["time"] < 0.03][-1] - 0.3)  # it falls

    def test_what_the_records_tell(self):
        self.go(FALL, 2, "out")
        with h5py.File(os.path.join(self.folder, "out", "state.h5")) as file:
            records = [file[name] for name in sorted(file) if name.startswith("record_")]
            alive = {float(record.attrs["time"]): record["element/alive"][...] for record in records}
        for time, flags in alive.items():
            gone = 16 * (time >= 1e-3) + 6 * (time >= 0.03) + (time >= 0.05)
            self.assertEqual((flags == 0).sum(), gone, time)
            self.assertEqual(len(flags), ELEMENTS)
        with open(os.path.join(self.folder, "out", "state.xdmf"), encoding="utf-8") as stream:
            self.assertEqual(stream.read().count('Attribute Name="alive" AttributeType="Scalar" Center="Cell"'), len(alive))

    def test_nothing_is_left(self):
        gone = FALL[:FALL.index("remove:")] + "remove: [{part: low, at: 0}, {part: side, at: 0.01}, {part: top, at: 0.01}]\n"
        gone += FALL[FALL.index("probes:"):]
        one = self.go(gone, 1, "np1")
        self.assertEqual(one["removed_elements"], ELEMENTS)
        self.assertEqual(self.go(gone, 3, "np3")["state_hash"], one["state_hash"])
        rows = self.rows("np1")
        self.assertLess(abs(rows["internal"][-1]), 1e-9 * rows["kinetic"][-1])
        self.assertLess(numpy.abs(rows["total"] - rows["total"][0]).max() / rows["kinetic"].max(), 1e-10)


if __name__ == "__main__":
    unittest.main()
