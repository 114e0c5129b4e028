#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Contact of rigid parts: with deformable parts, with each other, with walls, ties; exact impulses, balances, the same bits on any number of
ranks and after a restart. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import csv
import os
import unittest

from run_test import Program, of_all

# A rigid box falls on its corner on a rubber block that is tied to a rigid plate, which slides on a rigid wall; another one follows it.
PILE = """\
units: none
mesh:
  - {box: {part: plate, size: [1.2, 1.2, 0.2], elements: [4, 4, 1], at: [-0.1, -0.1, -0.2]}}
  - {box: {part: block, size: [1, 1, 0.5], elements: [5, 5, 3]}}
  - {box: {part: tool, size: [0.4, 0.4, 0.4], elements: [2, 2, 2], rotate: {axis: [1, 0.3, 0], degrees: 40}, at: [0.4, 0.5, 0.6]}}
  - {box: {part: other, size: [0.3, 0.3, 0.3], elements: [3, 3, 3], rotate: {axis: [0, 1, 0.2], degrees: 20}, at: [0.35, 0.3, 1.25]}}
materials:
  hard: {model: rigid, density: 2000}
  soft: {model: neo_hookean, density: 1000, young: 1.0e6, poisson: 0.3}
parts: {plate: {material: hard}, block: {material: soft, element: hex8_full}, tool: {material: hard}, other: {material: hard}}
initial:
  - {part: tool, velocity: [0.5, 0, -3], rotation: {axis: [0, 0, 1], point: [0.5, 0.5, 0], rate: 4}}
  - {part: other, velocity: [0, 0, -8]}
gravity: {vector: [0, 0, -9.81]}
rigid_walls: [{name: floor, point: [0, 0, -0.2], normal: [0, 0, 1], friction: 0.2}]
contact: [{between: all, friction: 0.3}, {between: [plate, block], tied: true}]
probes:
  - {name: floor, wall: floor}
  - {name: squeeze, contact: [tool, block]}
  - {name: meet, contact: [tool, other]}
  - {name: push, part: tool, field: force}
  - {name: turn, part: tool, field: rotation}
run: {end: 0.12}
history: {every: 1.0e-3}
"""

BLOCK = """\
units: none
mesh:
  - {box: {part: a, size: [0.2, 0.1, 0.1], elements: [2, 2, 2]}}
  - {box: {part: b, size: [0.2, 0.1, 0.1], elements: [3, 2, 1], at: [0.21, 0.01, 0]}}
materials: {hard: {model: rigid, density: 1000}}
parts: {a: {material: hard}, b: {material: hard}}
run: {end: 0.1, step: 1.0e-3}
history: {every: 1.0e-3}
"""


# A block slides down a longer plate, both rigid: lists that are made less often hold more of the plate's points.
SLOPE = """\
units: none
mesh:
  - {box: {part: block, size: [0.1, 0.08, 0.05], elements: [3, 2, 2], at: [0.05, 0.06, 0]}}
  - {box: {part: plate, size: [0.7, 0.2, 0.05], elements: [8, 3, 1], at: [0, 0, -0.05]}}
materials: {hard: {model: rigid, density: 1000}}
parts: {block: {material: hard, rigid: {centre: [0.1, 0.1, 0.01]}}, plate: {material: hard}}
fixed: [{part: plate, dofs: [x, y, z, rx, ry, rz]}]
gravity: {vector: [4.905, 0, -8.4957]}
contact: [{between: all, friction: 0.3}]
run: {end: 0.4, step: 1.0e-4}
"""


# A heavy box falls on a lighter one that stands on a fixed plate.
RAM = """\
units: SI
mesh:
  - {box: {part: anvil, size: [2, 2, 1], elements: [2, 2, 1], at: [-1, -1, -1]}}
  - {box: {part: pin, size: [0.4, 0.4, 0.4], elements: [1, 1, 1], at: [-0.2, -0.2, 0]}}
  - {box: {part: ram, size: [1, 1, 1], elements: [1, 1, 1], at: [-0.5, -0.5, 0.45]}}
materials: {light: {model: rigid, density: 15625}, heavy: {model: rigid, density: 1000}}
parts: {anvil: {material: heavy}, pin: {material: light}, ram: {material: heavy}}
fixed: [{part: anvil, dofs: [x, y, z, rx, ry, rz]}]
initial: [{part: ram, velocity: [0, 0, -10]}]
contact: [{between: all}]
probes: [{name: ram, part: ram, field: velocity}, {name: pin, part: pin, field: displacement}]
run: {end: 0.05, step: 0.001}
history: {every: 0.001}
"""


class RigidContact(Program):
    def setUp(self):
        super().setUp()
        self.write("pile.yaml", PILE)

    def rows(self, result):
        lines = self.text(result, "history.csv").splitlines()
        lines[0] = ",".join(head.split("[")[0].strip() for head in lines[0].split(","))
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(lines)]

    def run_block(self, more, energy=1e-12):
        self.write("block.yaml", BLOCK + more)
        self.run_scene(1, "block.yaml", "--out", "block", "--force")
        self.assertLess(self.summary("block")["energy"]["error_ratio"], energy)
        self.assertLess(self.summary("block")["momentum_error"], 1e-12)
        return self.rows("block")

    def test_same_bits_on_any_number_of_ranks(self):
        for ranks in of_all((1, 2, 3, 4), (1, 4)):
            self.run_scene(ranks, "pile.yaml", "--out", f"out{ranks}")
        first, rows = self.summary("out1"), self.rows("out1")
        self.assertLess(first["energy"]["error_ratio"], 1e-12)
        self.assertLess(first["momentum_error"], 1e-12)
        for name in ("floor", "squeeze", "meet"):
            self.assertGreater(abs(rows[-1][f"impulse_{name}.z"]), 1, name)
        for ranks in of_all((2, 3, 4), (4,)):
            self.assertEqual(self.summary(f"out{ranks}")["state_hash"], first["state_hash"])
            self.assertEqual(self.text(f"out{ranks}", "history.csv"), self.text("out1", "history.csv"))

    def test_no_result_depends_on_when_lists_are_rebuilt(self):
        for rebuild in ("auto", "1", "random"):
            self.run_scene(1, "pile.yaml", "--out", rebuild, "--set", f"contact.1.rebuild={rebuild}", "--set", "run.end=0.05")
            self.assertEqual(self.summary(rebuild)["state_hash"], self.summary("auto")["state_hash"], rebuild)

    def test_nor_on_which_points_of_a_body_they_hold(self):
        self.write("slope.yaml", SLOPE)
        for rebuild in ("auto", "1", "20"):
            self.run_scene(1, "slope.yaml", "--out", f"slope{rebuild}", "--set", f"enforcement.rebuild={rebuild}")
            self.assertEqual(self.summary(f"slope{rebuild}")["state_hash"], self.summary("slopeauto")["state_hash"], rebuild)

    def test_restart_from_two_ranks_on_three(self):
        self.run_scene(1, "pile.yaml", "--out", "whole")
        self.run_scene(2, "pile.yaml", "--out", "half", "--set", "run.end=0.06")
        self.run_scene(3, "pile.yaml", "--out", "half", "--restart", "half")
        self.assertEqual(self.summary("half")["state_hash"], self.summary("whole")["state_hash"])

    def test_a_stack_at_rest_has_the_same_bits_on_any_ranks_and_over_a_restart(self):
        with open(os.path.join(os.path.dirname(__file__), "..", "..", "cases", "rigid_stack", "scene.yaml"), encoding="utf-8") as scene:
            self.write("stack.yaml", scene.read())
        steps = ("--set", "run.steps=60")
        for ranks in of_all((1, 2, 4), (1, 4)):
            self.run_scene(ranks, "stack.yaml", "--out", f"stack{ranks}", *steps)
            self.assertEqual(self.summary(f"stack{ranks}")["state_hash"], self.summary("stack1")["state_hash"])
        self.run_scene(2, "stack.yaml", "--out", "again", "--set", "run.steps=30")
        self.run_scene(3, "stack.yaml", "--out", "again", "--restart", "again", *steps)
        self.assertEqual(self.summary("again")["state_hash"], self.summary("stack1")["state_hash"])

    def test_two_bodies_that_meet_go_on_together(self):
        rows = self.run_block("initial: [{part: a, velocity: [2, 0, 0]}]\n"
                              "fixed: [{part: a, dofs: [ry, rz]}, {part: b, dofs: [ry, rz]}]\ncontact: [{between: [a, b], tolerance: 1.0e-9, max_iterations: 5000, softness: 0}]\n"
                              "probes: [{name: a, part: a, field: velocity}, {name: b, part: b, field: velocity}, {name: f, contact: [a, b]}]\n")
        last = rows[-1]
        self.assertAlmostEqual(last["a.x"], 1, delta=1e-9)
        self.assertAlmostEqual(last["b.x"], 1, delta=1e-9)
        self.assertAlmostEqual(last["impulse_f.x"], -2, delta=1e-9)  # 2 kg each
        self.assertAlmostEqual(last["contact"], 2, delta=1e-8)  # half of the energy

    def test_bodies_that_part_after_a_plastic_impact_are_no_warning(self):
        self.run_block("initial: [{part: a, velocity: [2, 0, 0], rotation: {axis: [0, 0, 1], point: [0.1, 0.05, 0], rate: 20}}]\n"
                       "contact: [{between: [a, b]}]\n")
        self.assertGreater(self.summary("block")["energy"]["contact"], 0.1)
        self.assertEqual(self.summary("block")["warnings"], 0)

    def test_a_light_body_between_heavy_ones_is_no_spring(self):
        self.write("ram.yaml", RAM)
        for ratio in (1, 10, 100, 1000):
            with self.subTest(ratio=ratio):
                self.run_scene(1, "ram.yaml", "--out", "ram", "--force", "--set", f"materials.light.density={15625 / ratio}")
                rows, summary = self.rows("ram"), self.summary("ram")
                self.assertLess(max(row["ram.z"] for row in rows), 0.04 * 10)  # of the speed of the impact
                self.assertGreater(min(row["pin.z"] for row in rows), -0.02 * 0.4)
                self.assertLess(summary["max_penetration"], 0.02 * 0.4)
                self.assertEqual(summary["contact"]["steps_scaled"], 0)

    def test_a_step_that_ends_early_gives_no_energy(self):
        self.write("ram.yaml", RAM.replace("at: [-0.5, -0.5, 0.45]", "at: [-0.5, -0.5, 0.4]"))
        for iterations in (1, 3, 10, 50, 200):
            for ranks in (1, 3):
                with self.subTest(iterations=iterations, ranks=ranks):
                    self.run_scene(ranks, "ram.yaml", "--out", f"cut{ranks}", "--force", "--set", "contact.0.softness=0", "--set",
                                   f"contact.0.max_iterations={iterations}")
                    kinetic = [row["kinetic"] for row in self.rows(f"cut{ranks}")]
                    self.assertLessEqual(max(kinetic), 0.5 * 1000 * 10**2 * (1 + 1e-9))
                    contact, log = self.summary(f"cut{ranks}")["contact"], self.text(f"cut{ranks}", "log.txt")
                    self.assertEqual(contact["steps_scaled"] > 0, "would have generated energy" in log)
                    self.assertLessEqual(contact["steps_scaled"], contact["steps_at_limit"])
            self.assertEqual(self.summary("cut3")["state_hash"], self.summary("cut1")["state_hash"])

    def test_a_body_slides_on_a_wall_with_coulombs_acceleration(self):
        rows = self.run_block("initial: [{part: a, velocity: [0.5, 0, 0]}]\ngravity: {vector: [0, 0, -10]}\n"
                              "rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1], friction: 0.2}]\nenforcement: {tolerance: 1.0e-6}\n"
                              "probes: [{name: a, part: a, field: velocity}, {name: b, part: b, field: displacement}, {name: w, wall: wall0}]\n",
                              energy=1e-10)
        for row in rows[2:]:
            # v of the half step before; the first step is one of half its length for forces
            self.assertAlmostEqual(row["a.x"], max(0, 0.5 - 2 * (row["time"] - 0.5e-3)), delta=1e-4)
            self.assertAlmostEqual(row["w.z"], 40, delta=0.04)
            self.assertLess(abs(row["b.x"]) + abs(row["b.z"]), 1e-9)  # tolerance g dt^2 / recovery = 2e-10

    def test_a_driven_body_pushes_another_and_its_supports_take_the_force(self):
        rows = self.run_block("fixed: [{part: a, dofs: [y, z, rx, ry, rz]}]\nprescribed: [{part: a, dof: x, acceleration: 5}]\n"
                              "contact: [{between: [a, b]}]\nfixed: [{part: a, dofs: [y, z, rx, ry, rz]}, {part: b, dofs: [y, z, rx, ry, rz]}]\n"
                              .replace("fixed: [{part: a, dofs: [y, z, rx, ry, rz]}]\n", "", 1) +
                              "probes: [{name: r, part: a, field: reaction}, {name: f, part: b, field: force}, {name: p, part: a, field: force}]\n")
        for row in rows[80:]:
            self.assertAlmostEqual(row["r.x"], 20, delta=1e-2)  # 4 kg together
            self.assertAlmostEqual(row["f.x"], 10, delta=1e-2)
            self.assertAlmostEqual(row["p.x"], -10, delta=1e-2)

    def test_a_driven_body_that_may_turn_is_told_of_where_a_wall_stops_it(self):
        self.write("block.yaml", BLOCK + "prescribed: [{part: a, dof: z, velocity: -1}]\nrigid_walls: [{point: [0, 0, -0.0105], normal: [0, 0, 1]}]\n")
        said = self.run_scene(1, "block.yaml", "--out", "block", "--set", "run.steps=20", code=3)
        self.assertIn("supports or moving walls drive part 'a' and rigid wall 'wall0' into each other", said)
        self.assertLess(self.summary("block")["steps"], 14)  # it meets the wall in step 11, and a hundredth of it is one step's motion

    def test_other_methods_are_refused(self):
        self.write("wrong.yaml", BLOCK + "contact: [{between: [a, b], method: penalty}]\n")
        done = self.brunt("check", "wrong.yaml")
        self.assertEqual(done.returncode, 2)
        self.assertIn("expected rate or row_sum", done.stderr)


if __name__ == "__main__":
    unittest.main()
