#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Static states before t = 0, dead loads and sums over parts, as a user runs them: the same bits on any number of ranks and after a restart
within the phase, the exit code where nothing comes to rest. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import csv
import unittest

from run_test import Program, of_all

PILE = """\
units: none
mesh:
  - {box: {part: low, size: [1, 1, 0.5], elements: [5, 5, 3]}}
  - {box: {part: top, size: [0.6, 0.6, 0.5], elements: [4, 4, 3], at: [0.2, 0.15, 0.5]}}
  - {box: {part: hat, size: [0.4, 0.4, 0.2], elements: [2, 2, 1], at: [0.3, 0.3, 1]}}
materials:
  m: {model: elastic, density: 1000, young: 1.0e7, poisson: 0.3}
  p: {model: j2, density: 1000, young: 1.0e7, poisson: 0.3, yield: 5.0e3, hardening: 1.0e6}
parts: {low: {material: m}, top: {material: p, element: hex8_full}, hat: {material: m}}
fixed: [{set: low_zmin, dofs: [x, y, z]}]
sets: {side: {part: low, box: [[0, 1, 0.1], [1, 1, 0.5]]}}
curves: {pulse: [[0, 1], [0.02, 1], [0.03, 0]], pull: [[0, 0], [0.02, 1.0e-3]]}
gravity: {vector: [0, 0, -10]}
forces: [{set: hat_zmax, total: [0, 0, -100], curve: pulse}, {part: low, force: [0.1, 0, 0]}]
traction: [{set: top_xmax, value: [0, 5, 0]}]
prescribed: [{set: side, dof: y, displacement: pull}]
contact: [{between: [low, top], friction: 0.2}, {between: [top, hat], tied: true}]
relaxation: {tolerance: 1.0e-3}
run: {end: 0.03}
history: {every: 1.0e-3}
probes:
  - {name: e, part: top, field: energy}
  - {name: l, part: hat, field: angular_momentum}
  - {name: p, part: hat, field: momentum}
  - {name: c, part: top, field: center}
  - {name: m, part: low, field: mass}
  - {name: cut, section: {part: low, point: [0, 0, 0.25], normal: [0, 0, 1]}}
  - {name: press, contact: [top, low]}
  - {name: foot, set: low_zmin, field: reaction}
"""

# A rigid tray tied under a block that hangs from above, with a rigid weight on it, off the middle.
TRAY = """\
units: none
mesh:
  - {box: {part: block, size: [1, 1, 0.5], elements: [4, 4, 3], at: [0, 0, 0.2]}}
  - {box: {part: tray, size: [1.6, 1, 0.2], elements: [6, 4, 1], at: [-0.3, 0, 0]}}
  - {box: {part: weight, size: [0.2, 0.3, 0.2], elements: [2, 3, 2], at: [1.05, 0.3, 0.2]}}
materials: {m: {model: elastic, density: 1000, young: 1.0e7, poisson: 0.3}, hard: {model: rigid, density: 2000}}
parts: {block: {material: m, element: hex8_full}, tray: {material: hard}, weight: {material: hard}}
fixed: [{set: block_zmax, dofs: [x, y, z]}]
gravity: {vector: [0, 0, -10]}
contact: [{between: [tray, weight], friction: 0.5}, {between: [block, tray], tied: true}]
relaxation: {tolerance: 1.0e-3}
run: {end: 0.03}
history: {every: 1.0e-3}
probes:
  - {name: press, contact: [weight, tray]}
  - {name: hang, contact: [tray, block]}
  - {name: foot, set: block_zmax, field: reaction}
  - {name: turn, part: tray, field: rotation}
"""


class Static(Program):
    def setUp(self):
        super().setUp()
        self.write("pile.yaml", PILE)

    def rows(self, result):
        return list(csv.DictReader(self.text(result, "history.csv").splitlines()))

    def test_same_bits_on_any_number_of_ranks(self):
        for ranks in of_all((1, 2, 3, 4), (1, 4)):
            self.run_scene(ranks, "pile.yaml", "--out", f"out{ranks}")
        first = self.summary("out1")
        self.assertGreater(first["relaxation"]["steps"], 50)
        self.assertLess(first["relaxation"]["residual"], 1e-3)
        self.assertRegex(self.text("out1", "log.txt"), r"at rest after \d+ steps; .*, the largest displacement is \d\S*")
        for ranks in of_all((2, 3, 4), (4,)):
            self.assertEqual(self.summary(f"out{ranks}")["state_hash"], first["state_hash"])
            self.assertEqual(self.text(f"out{ranks}", "history.csv"), self.text("out1", "history.csv"))
        self.assertLess(first["momentum_error"], 1e-12)
        self.assertLess(first["energy"]["error_ratio"], 1e-11)

    def test_weights_are_carried_from_the_first_step(self):
        self.run_scene(1, "pile.yaml", "--out", "out", "--set", "forces=null", "--set", "traction=null", "--set", "prescribed=null")
        rows = self.rows("out")
        masses = [0.5e3, 0.18e3, 0.032e3]
        weight = 10 * sum(masses[1:])
        for row in rows:
            self.assertAlmostEqual(float(row["press.z [1]"]), weight, delta=5e-3 * weight)
            cut = float(row["cut.z [1]"])  # what is above the nodes behind the plane, which lie at z = 0 and 1/6
            self.assertAlmostEqual(cut, -weight - 10 * 500 * (1 - 0.5), delta=5e-3 * weight)
        kinetic = max(float(row["kinetic [1]"]) for row in rows)
        self.assertLess(kinetic, 1e-5 * float(rows[0]["internal [1]"]))

    def test_rigid_parts_hang_and_lie_at_rest(self):
        self.write("tray.yaml", TRAY)
        for ranks in (1, 3):
            self.run_scene(ranks, "tray.yaml", "--out", f"tray{ranks}")
        first, rows = self.summary("tray1"), self.rows("tray1")
        self.assertEqual(self.summary("tray3")["state_hash"], first["state_hash"])
        # of the momentum that is left at rest, while the supports' impulse grows to thousands of times that
        self.assertLess(first["momentum_error"], 1e-11)
        self.assertLess(first["energy"]["error_ratio"], 1e-11)
        weight, tray, block = 10 * 2000 * 0.012, 10 * 2000 * 0.32, 10 * 1000 * 0.5
        for row in rows:
            self.assertAlmostEqual(float(row["press.z [1]"]), weight, delta=5e-3 * weight)
            self.assertAlmostEqual(float(row["hang.z [1]"]), weight + tray, delta=5e-3 * tray)
            self.assertAlmostEqual(float(row["foot.z [1]"]), weight + tray + block, delta=5e-3 * tray)
        self.assertLess(max(float(row["kinetic [1]"]) for row in rows), 1e-5 * float(rows[0]["internal [1]"]))
        turns = [float(row["turn.y [rad]"]) for row in rows]
        self.assertGreater(min(turns), 1e-5)  # down where the weight lies
        self.assertLess(max(turns) - min(turns), 1e-2 * max(turns))

    def test_restart_within_the_phase(self):
        self.check_restart_within_the_phase("pile.yaml")

    def test_restart_within_the_phase_with_rigid_parts(self):
        self.write("tray.yaml", TRAY)
        self.check_restart_within_the_phase("tray.yaml")

    def check_restart_within_the_phase(self, scene):
        self.run_scene(2, scene, "--out", "whole")
        for limit in range(1, 200):  # until one falls into the phase
            self.run_scene(1, scene, "--out", "part", "--force", "--set", f"run.wall_limit={0.02 * limit}", code=5)
            part = self.summary("part")
            if part["relaxation"]["steps"] > 20:
                break
        self.assertEqual(part["stopped_by"], "wall_limit")
        self.assertEqual(part["end_time"], 0)
        self.run_scene(3, scene, "--out", "part", "--restart", "part")
        self.assertEqual(self.summary("part")["state_hash"], self.summary("whole")["state_hash"])
        self.assertEqual(self.text("part", "history.csv"), self.text("whole", "history.csv"))

    def test_restart_after_the_phase(self):
        self.run_scene(1, "pile.yaml", "--out", "whole")
        self.run_scene(2, "pile.yaml", "--out", "part", "--set", "run.end=0.011")
        self.run_scene(1, "pile.yaml", "--out", "part", "--restart", "part")
        self.assertEqual(self.summary("part")["state_hash"], self.summary("whole")["state_hash"])

    def test_what_nothing_supports(self):
        self.run_scene(1, "pile.yaml", "--out", "out", "--set", "fixed=null", "--set", "prescribed=null", "--set", "relaxation.max_steps=300", code=3)
        self.assertIn("not at rest after 300 steps", self.text("out", "log.txt"))


if __name__ == "__main__":
    unittest.main()
