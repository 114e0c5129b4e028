#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Implicit scenes whose constraints say the same or contradict each other: ties and contact on rigid walls, a slave over two masters,
supports that drive ties apart and bodies through each other. Needs BRUNT and BRUNT_RUN in the environment."""
import csv
import unittest

from run_test import Program, of_all

PARTS = """\
materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}
parts: {a: {material: m, element: hex8_full}, b: {material: m, element: hex8_full}}
"""
# Two blocks side by side on a floor, 2 in weight; meshes do not match.
SEAM = """\
units: none
mesh: [{box: {part: a, size: [1, 1, 1], elements: [2, 2, 2]}}, {box: {part: b, size: [1, 1, 1], elements: [3, 3, 3], at: [1, 0, 0]}}]
""" + PARTS + """\
symmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}, {point: [0, 0, 0], normal: [0, 1, 0]}]
gravity: {vector: [0, 0, -1]}
rigid_walls: [{name: w, point: [0, 0, 0], normal: [0, 0, 1]}]
contact: [{between: [a, b], method: mortar, tied: true}]
probes: [{name: w, wall: w}, {name: c, contact: [b, a]}]
solver: {scheme: static, step: 0.5, tolerance: 1.0e-11}
run: {end: 1}
"""
# Two blocks, one on the other, the foot and the top held.
STACK = """\
units: none
mesh: [{box: {part: a, size: [1, 1, 1], elements: [2, 2, 2]}}, {box: {part: b, size: [1, 1, 1], elements: [3, 3, 3], at: [0, 0, 1]}}]
""" + PARTS + """\
sets: {top: {part: a, box: [[0, 0, 1], [1, 1, 1]]}, sole: {part: b, box: [[0, 0, 1], [1, 1, 1]]}}
curves: {late: [[0, 0], [0.4, 0], [1, 0.03]], early: [[0, 0], [1, -0.03]]}
contact: [{between: [a, b], method: mortar}]
solver: {scheme: static, step: 0.1}
run: {end: 1}
"""
# A plate, the slave, that is tied to two blocks which abut, drawn up by a stress of 1.
BRIDGE = """\
units: none
mesh:
  - {box: {part: a, size: [1, 1, 0.5], elements: [2, 2, 1]}}
  - {box: {part: b, size: [1, 1, 0.5], elements: [2, 3, 1], at: [1, 0, 0]}}
  - {box: {part: plate, size: [2, 1, 0.25], elements: [NX, NY, 1], at: [0, 0, 0.5]}}
materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}
parts: {a: {material: m, element: hex8_full}, b: {material: m, element: hex8_full}, plate: {material: m, element: hex8_full}}
symmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}, {point: [0, 0, 0], normal: [0, 1, 0]}, {point: [0, 0, 0], normal: [0, 0, 1]}]
contact: [{between: [plate, a], method: mortar, tied: true, slave: first}, {between: [plate, b], method: mortar, tied: true, slave: first}]
traction: [{set: plate_zmax, value: [0, 0, 1]}]
probes: [{name: f, set: a_zmin, field: reaction}, {name: g, set: b_zmin, field: reaction}]
solver: {scheme: static, step: 0.5, tolerance: 1.0e-12}
run: {end: 1}
output: {every: 1, fields: [displacement, stress]}
"""


class Redundant(Program):
    def go(self, scene, ranks=1, out="out", code=0):
        """What is told, or the rows of the history."""
        self.write("scene.yaml", scene)
        told = self.run_scene(ranks, "scene.yaml", "--out", out, "--force", code=code)
        if code:
            return told
        table = csv.DictReader(self.text(out, "history.csv").splitlines())
        return [{name.split(" [")[0]: float(value) for name, value in row.items()} for row in table]

    def test_a_tied_seam_on_a_floor(self):
        for elements in ("[3, 3, 3]", "[2, 2, 2]"):
            scene = SEAM.replace("[3, 3, 3]", elements)
            rows = self.go(scene)
            self.assertAlmostEqual(rows[-1]["w.z"], 2, delta=1e-10)
            whole = self.summary("out")["state_hash"]
            for ranks in of_all((2, 3, 4), (3,)):
                self.go(scene, ranks)
                self.assertEqual(self.summary("out")["state_hash"], whole)
        # one block is drawn up by more than its weight: it leaves the floor and hangs on the other
        rows = self.go(SEAM + "traction: [{set: b_zmax, value: [0, 0, 1.2]}]\n")
        self.assertAlmostEqual(rows[-1]["w.z"], 0.8, delta=1e-9)

    def test_a_support_lifts_its_tied_neighbour_off_the_floor(self):
        # of the pair the finer b is the slave, and it is a that is driven: up together, and down again
        scene = SEAM + "curves: {c: [[0, 0], [0.5, 0.1], [1, 0]]}\nprescribed: [{part: a, dof: z, displacement: c}]\nfixed: [{part: a, dofs: [x, y]}]\n"
        rows = self.go(scene.replace("step: 0.5", "step: 0.25"))
        self.assertEqual([round(row["w.z"], 9) for row in rows[1:4]], [0, 0, 0])
        self.assertLess(self.summary("out")["driven_penetration"], 1e-12)

    def test_contact_of_blocks_on_a_floor(self):
        # squeezed to a dead load of 1
        loaded = SEAM.replace(", tied: true", "FRICTION") + "traction: [{set: b_xmax, value: [-1, 0, 0]}]\n"
        for friction in ("", ", friction: 0.3"):
            scene = loaded.replace("FRICTION", friction)
            rows = self.go(scene)
            self.assertAlmostEqual(rows[-1]["w.z"], 2, delta=1e-9)
            self.assertAlmostEqual(rows[-1]["c.x"], 1, delta=1e-9)
            whole = self.summary("out")["state_hash"]
            for ranks in of_all((2, 3, 4), (3,)):
                self.go(scene, ranks)
                self.assertEqual(self.summary("out")["state_hash"], whole)

    def test_a_tie_that_supports_drive_apart(self):
        scene = STACK.replace("mortar}", "mortar, tied: true}") + "symmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}, {point: [0, 0, 0], normal: [0, 1, 0]}]\n"
        scene, fixed = (scene + "prescribed: [{set: top, dof: z, displacement: early}, {set: sole, dof: z, displacement: late}]\n",
                        scene + "prescribed: [{set: top, dof: z, displacement: late}]\nfixed: [{set: sole, dofs: [z]}]\n")
        told = self.go(scene, code=2)
        self.assertRegex(told, r"^brunt: scene.yaml:\d+: contact\.0: invalid tie: at \[\S+, \S+, 1\] part 'b', moved by prescribed\.1, and part 'a', moved by prescribed\.0, "
                         r"are separated by 0\.012 at t = 0\.4, and the tie cannot hold there; expected the same motion on both sides\n$")
        together = scene.replace("late}]", "early}]")
        self.go(together)
        self.assertEqual(self.summary("out")["warnings"], 0)
        self.assertIn("part 'b', moved by fixed.0, and part 'a', moved by prescribed.0", self.go(fixed, code=2))
        # without an end the run stops when it comes to that
        for ranks in (1, 2):
            told = self.go(fixed.replace("run: {end: 1}", "run: {steps: 8}"), ranks, code=3)
            self.assertIn("part 'a', moved by prescribed.0, are separated by 0.005 at t = 0.5", told)
            self.assertEqual(len(self.checkpoints("out")), 1)

    def test_bodies_that_supports_drive_through_each_other(self):
        scene = STACK + "prescribed: [{set: sole, dof: z, displacement: early}]\nfixed: [{set: top, dofs: [x, y, z]}, {set: a_zmin, dofs: [x, y, z]}, {set: sole, dofs: [x, y]}]\n"
        for ranks in (1, 2):
            self.write("scene.yaml", scene)
            self.run_scene(ranks, "scene.yaml", "--out", "out", "--force")
            told = self.text("out", "log.txt")
            self.assertEqual(told.count("supports move part 'b' and part 'a' through each other: since t = 0.1 "), 1, told)
            self.assertAlmostEqual(self.summary("out")["driven_penetration"], 0.03, delta=1e-12)
            self.assertEqual(self.summary("out")["warnings"], 1)
        self.run_scene(1, "scene.yaml", "--out", "out", "--force", "--set", "run.end=0.5")
        self.run_scene(2, "scene.yaml", "--out", "out", "--restart", "out", "--set", "run.end=1")
        self.assertEqual(self.text("out", "log.txt").count("through each other"), 1)  # told before
        self.assertAlmostEqual(self.summary("out")["driven_penetration"], 0.03, delta=1e-12)

    def test_a_wall_that_is_driven_through_held_nodes(self):
        scene = SEAM.split("contact:")[0].replace("normal: [0, 0, 1]}]", "normal: [0, 0, 1], motion: up}]") + (
            "curves: {up: [[0, 0.05], [1, 0.05]]}\nfixed: [{set: a_zmin, dofs: [z]}]\nsolver: {scheme: static, step: 0.1}\nrun: {end: 1}\n").replace(
                "fixed: [{set: a_zmin", "fixed: [{part: b, dofs: [x, y, z]}, {set: a_zmin")
        for ranks in (1, 2):
            self.write("scene.yaml", scene)
            self.run_scene(ranks, "scene.yaml", "--out", "out", "--force")
            told = self.text("out", "log.txt")
            self.assertEqual(told.count("supports move part"), 1, told)
            self.assertIn("and rigid wall 'w' through each other: since t = 0.1 ", told)
            self.assertAlmostEqual(self.summary("out")["driven_penetration"], 0.05, delta=1e-12)

    def test_a_slave_over_two_masters(self):
        for nx, ny in ((5, 3), (4, 6), (3, 1), (8, 8)):
            scene = BRIDGE.replace("NX", str(nx)).replace("NY", str(ny))
            rows = self.go(scene)
            self.assertAlmostEqual(rows[-1]["f.z"] + rows[-1]["g.z"], -2, delta=1e-9)
            stress = self.stress("out")
            self.assertLess(max(abs(value / stress[0] - 1) for value in stress), 1e-8)
        whole = self.summary("out")["state_hash"]
        for ranks in of_all((2, 3, 4), (3,)):
            self.go(scene, ranks)
            self.assertEqual(self.summary("out")["state_hash"], whole)

    def test_three_bodies_tied_at_one_edge(self):
        rows = self.go(BRIDGE.replace("NX", "5").replace("NY", "3").replace("contact: [", "contact: [{between: [a, b], method: mortar, tied: true}, "))
        self.assertAlmostEqual(rows[-1]["f.z"] + rows[-1]["g.z"], -2, delta=1e-9)
        stress = self.stress("out")
        self.assertLess(max(abs(value / stress[0] - 1) for value in stress), 1e-8)

    def stress(self, result):
        import h5py
        with h5py.File(f"{self.folder}/{result}/state.h5") as states:
            last = max(name for name in states if name.startswith("record_"))
            return [float(row[2]) for row in states[last]["element/stress"]]

    def test_what_is_told_of_walls_overlaps_and_steps(self):
        behind = SEAM.replace("point: [0, 0, 0], normal: [0, 0, 1]}]", "point: [1, 0, 0], normal: [1, 0, 0]}]")
        told = self.go(behind, code=2)
        self.assertRegex(told, r"^brunt: scene.yaml:\d+: rigid_walls\.0: invalid wall: a body of part 'a' lies behind it by up to 1, .*; expected .*\n$")
        for wrong, phrase in ((SEAM.replace("{scheme: static, step: 0.5, tolerance: 1.0e-11}", "static"), "solver: invalid value 'static', which is a scheme; expected {scheme: static}, implicit or explicit"),
                              (STACK.replace("between: [a, b]", "between: a"), "contact.0.between: unknown value 'a'"),
                              (STACK.replace("between: [a, b]", "between: [a]"), "contact.0.between: invalid list of 1 entries; expected all, or two parts [a, b]"),
                              (STACK.replace("between: [a, b], ", ""), "contact.0.between: missing"),
                              (STACK.replace("between: [a, b]", "between: all"), "contact.0.between: invalid between for method: mortar; expected two parts [a, b]"),
                              (STACK.replace("between: [a, b]", "between: [a, a], tied: true"), "contact.0.tied: invalid tied: a part cannot be tied to itself"),
                              (STACK.replace("between: [a, b]", "between: all, tied: true"), "contact.0.tied: invalid tied for between: all")):
            told = self.go(wrong, code=2)
            self.assertIn(phrase, told)
            self.assertEqual(len(told.splitlines()), 1, told)
        overlap = STACK.replace("at: [0, 0, 1]", "at: [0, 0, 0.99]").replace("method: mortar", "method: mortar, initial_overlap: warn")
        overlap = overlap.replace("scheme: static", "scheme: contact_implicit")
        self.write("scene.yaml", overlap)
        self.run_scene(1, "scene.yaml", "--out", "out")
        self.assertIn("contact.0.initial_overlap: an initial overlap remains", self.text("out", "log.txt"))
        self.go(SEAM)
        self.assertEqual(self.summary("out")["contact"]["steps"], 2)
        self.go(SEAM.split("rigid_walls")[0] + "fixed: [{part: a, dofs: [z]}, {part: b, dofs: [z]}]\nsolver: {scheme: static, step: 0.5}\nrun: {end: 1}\n")
        self.assertEqual(self.summary("out")["contact"]["steps"], 0)


if __name__ == "__main__":
    unittest.main()
