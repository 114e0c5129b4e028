#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Rigid parts in implicit scenes: what they stand on, punches, joints, walls, ranks, restarts, messages. Needs BRUNT and BRUNT_RUN."""
import math
import unittest

import numpy

from rigid_test import joined_mesh
from run_test import of_all
from scene_program import SceneProgram

LAWS = "materials: {m: {model: neo_hookean, density: 2, young: 1000, poisson: 0.3}, hard: {model: rigid, density: 20}}\n"
# Meshes that do not match, off every axis of symmetry.
PAIR = "units: none\nmesh: [{box: {part: low, size: [1, 1, 0.5], elements: [3, 3, 2]}}, {box: {part: top, size: [0.9, 0.8, 0.4], elements: [2, 3, 1], PLACE}}]\n" + LAWS + """\
parts: {low: {material: m, element: hex8_full}, top: {material: hard}}
contact: [{between: [top, low], method: mortar, friction: 0}]
"""
ON = PAIR.replace("PLACE", "at: [0.03, 0.05, 0.5]")
STATIC = "solver: {scheme: static, step: 0.25, tolerance: 1.0e-12}\nrun: {end: 1}\n"
# A block that falls obliquely on one that deforms, and slides and turns there.
FALL = PAIR.replace("PLACE", "rotate: {axis: [0, 1, 0], degrees: 8}, at: [0.03, 0.05, 0.63]").replace("friction: 0", "friction: 0.3") + """\
fixed: [{set: low_zmin, dofs: [x, y, z]}]
initial: [{part: top, velocity: [0.5, 0.1, -1]}]
gravity: {vector: [0, 0, -10]}
probes: [{name: w, contact: [top, low]}, {name: turn, part: top, field: rotation}, {name: f, part: top, field: force}, {name: e, part: top, field: energy}]
solver: {step: 0.01}
run: {end: 0.24}
"""
ALONE = "units: none\nmesh: {box: {part: a, size: [1, 0.8, 0.5], elements: [2, 2, 1]}}\n" + LAWS + "parts: {a: {material: hard}}\n"
# A rigid head and a bar that deforms, with the nodes between in common, which turn, fall and are pushed.
JOINED = """\
units: none
mesh: {file: joined.msh}
materials: {hard: {model: rigid, density: 3000}, soft: {model: neo_hookean, density: 1000, young: 1.0e6, poisson: 0.3}}
parts: {head: {material: hard}, bar: {material: soft, element: hex8_full, bulk: {linear: 0, quadratic: 0}}}
initial:
  - {part: bar, velocity: [0, 0, 0], rotation: {axis: [0.3, 1, 0.5], rate: 20}}
  - {part: head, velocity: [0, 0, 0], rotation: {axis: [0.3, 1, 0.5], rate: 20}}
curves: {pulse: [[0, 0], [0.01, 1], [0.02, 0]]}
pressure: [{set: tip, value: 2.0e3, curve: pulse}]
gravity: {vector: [0, 3, -9.81]}
probes: [{name: turn, part: head, field: rotation}, {name: push, part: head, field: force}, {name: p, part: head, field: momentum}]
run: {end: 0.05}
"""


class Rigid(SceneProgram):
    def refused(self, scene, *told):
        lines = [line for line in self.go(scene, code=2).splitlines() if "scene.yaml" in line]
        self.assertEqual(len(lines), 1, lines)
        for text in told:
            self.assertIn(text, lines[0])

    def same_on_ranks(self, scene, stop, done=True):
        """As on one rank: that run is in `out` where it is done."""
        if not done:
            self.go(scene)
        whole = self.summary("out")["state_hash"]
        for ranks in of_all((2, 3, 4), (3,)):
            self.go(scene, ranks, f"out{ranks}")
            self.assertEqual(self.summary(f"out{ranks}")["state_hash"], whole)
            self.assertEqual(self.text(f"out{ranks}", "history.csv"), self.text("out", "history.csv"))
        self.run_scene(2, "scene.yaml", "--out", "part", "--set", f"run.end={stop}")
        self.run_scene(3, "scene.yaml", "--out", "part", "--restart", "part")
        self.assertEqual(self.summary("part")["state_hash"], whole)
        self.assertEqual(self.text("part", "history.csv"), self.text("out", "history.csv"))

    def test_a_block_rests_on_one_that_deforms(self):
        rest = ON + "fixed: [{set: low_zmin, dofs: [x, y, z]}, {part: top, dofs: [x, y, rz]}]\ngravity: {vector: [0, 0, -10]}\n" + \
            "probes: [{name: w, contact: [top, low]}, {name: foot, set: low_zmin, field: reaction}, {name: f, part: top, field: force}, {name: r, part: top, field: reaction}]\n" + STATIC
        weight = 10 * 20 * 0.9 * 0.8 * 0.4
        for row in self.go(rest)[2:]:  # the first step begins without loads
            self.assertAlmostEqual(row["w.z"], weight, delta=1e-10 * weight)
            self.assertAlmostEqual(row["foot.z"], weight + 10, delta=1e-10 * weight)
            self.assertAlmostEqual(row["f.z"], 0, delta=1e-10 * weight)
            self.assertAlmostEqual(row["r.x"], -row["w.x"], delta=1e-10 * weight)
        self.same_on_ranks(rest, 0.5)

    def test_a_punch_does_what_prescribed_nodes_do(self):
        punch = ON.replace("between: [top, low]", "between: [top, low], slave: low").replace("size: [0.9, 0.8, 0.4]", "size: [0.5, 0.5, 0.4]").replace(
            "at: [0.03", "at: [0.2") + "curves: {go: [[0, 0], [1, -0.03]]}\nfixed: [{set: low_zmin, dofs: [x, y, z]}, {part: top, dofs: [x, y, rx, ry, rz]}]\n" + \
            "prescribed: [{part: top, dof: z, displacement: go}]\nprobes: [{name: w, contact: [top, low]}, {name: r, part: top, field: reaction}]\n" + STATIC
        rigid = self.go(punch)
        nodes = self.go(punch.replace("top: {material: hard}", "top: {material: m, element: hex8_full}").replace(", rx, ry, rz", ""), out="nodes")
        self.assertGreater(rigid[-1]["w.z"], 10)
        for one, other in zip(rigid, nodes):
            for name in ("w.z", "r.z", "r.x", "external", "internal"):
                self.assertAlmostEqual(one[name], other[name], delta=1e-11 * abs(rigid[-1]["w.z"]))

    def test_a_beam_with_a_mass_at_its_end_has_the_frequency_of_the_formula(self):
        young, inertia, length, area, shear, density = 1e5, 1 / 12, 10, 1, 5e4, 0.01
        rows = self.go("units: none\nmesh: [{box: {part: beam, size: [10, 1, 1], elements: [60, 1, 4]}}, {box: {part: tip, size: [1, 1, 1], elements: [2, 1, 3], at: [10, 0, 0]}}]\n"
                       "materials: {m: {model: elastic, density: 0.01, young: 1.0e5, poisson: 0}, hard: {model: rigid, density: 20}}\n"
                       "parts: {beam: {material: m, element: hex8_full}, tip: {material: hard}}\n"
                       "fixed: [{set: beam_xmin, dofs: [x, y, z]}, {part: tip, dofs: [y, rx, rz]}]\ninitial: [{part: tip, velocity: [0, 0, 0.01]}]\n"
                       "contact: [{between: [beam, tip], method: mortar, tied: true}]\nprobes: [{name: d, part: tip, field: displacement}]\nsolver: {step: 0.05}\nrun: {end: 6}\n")
        # Timoshenko's beam with consistent masses, a cube of mass 20 behind its end
        phi, mass = 12 * young * inertia / (5 / 6 * shear * area * length**2), 20.0
        stiffness = young * inertia / ((1 + phi) * length**3) * numpy.array([[12, -6 * length], [-6 * length, (4 + phi) * length**2]])
        masses = numpy.array([[mass, mass / 2], [mass / 2, mass / 6 + mass / 4]]) + density * area * length / 420 * numpy.array(
            [[156, -22 * length], [-22 * length, 4 * length**2]])
        low, high = sorted(math.sqrt(w) for w in numpy.linalg.eigvals(numpy.linalg.solve(masses, stiffness)))
        time, moved = (numpy.array([row[name] for row in rows]) for name in ("time", "d.z"))

        def misfit(w):
            waves = numpy.column_stack([f(rate * time) for rate in (w, high) for f in (numpy.cos, numpy.sin)])
            return numpy.linalg.norm(waves @ numpy.linalg.lstsq(waves, moved, rcond=None)[0] - moved)

        found = min(numpy.linspace(0.95 * low, 1.05 * low, 1001), key=misfit)
        found = 2 / 0.05 * math.tan(found * 0.05 / 2)  # the trapezoidal rule is slower
        # hexahedra lock in bending by shear (edge/height)^2/2 = 1.4 % of the stiffness, 0.7 % of the frequency
        self.assertAlmostEqual(found / low, 1.007, delta=0.002)

    def test_a_free_fall_is_kept_by_the_ledger_and_the_same_on_any_ranks(self):
        rows = self.go(FALL)
        self.assertGreater(max(row["w.normal"] for row in rows), 100)
        self.assertGreater(abs(rows[-1]["turn.y"]), 0.01)
        for row in rows:  # what Newton's iteration leaves
            self.assertAlmostEqual(row["total"], rows[0]["total"], delta=1e-8 * rows[0]["total"])
        self.assertGreater(rows[-1]["contact"] + rows[-1]["friction"], 0)
        self.same_on_ranks(FALL, 0.1)

    def test_a_head_on_a_bar_moves_as_in_an_explicit_run(self):
        self.write("joined.msh", joined_mesh())
        explicit = self.go(JOINED.replace("end: 0.05", "end: 0.06") + "history: {every: 1.0e-4}\n", out="explicit")
        rows = self.go(JOINED + "solver: {step: 1.0e-3}\n")
        for row in rows:  # what Newton's iteration leaves
            self.assertAlmostEqual(row["total"], rows[0]["total"], delta=1e-9 * rows[0]["total"])
        times = [row["time"] for row in explicit]
        for name in ("turn.x", "turn.y", "turn.z", "p.x", "external"):  # steps of 1.6e-3, second order in both
            self.assertAlmostEqual(rows[-1][name] / numpy.interp(0.05, times, [row[name] for row in explicit]), 1, delta=2e-3)
        self.same_on_ranks(JOINED + "solver: {step: 1.0e-3}\n", 0.02)

    def test_a_block_on_a_wall_stands_slides_and_tips(self):
        floor = "rigid_walls: [{name: floor, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.3}]\ngravity: {vector: [GX, 0, -10]}\n" + \
            "probes: [{name: w, wall: floor}, {name: d, part: a, field: velocity}, {name: turn, part: a, field: rotation}]\nsolver: {step: 0.01}\nrun: {end: 0.5}\n"
        weight = 20 * 1 * 0.8 * 0.5 * 10
        stands = self.go(ALONE + floor.replace("GX", "2"))
        self.assertAlmostEqual(stands[-1]["w.z"], weight, delta=1e-6 * weight)
        self.assertAlmostEqual(stands[-1]["w.x"], -0.2 * weight, delta=1e-6 * weight)
        self.assertLess(abs(stands[-1]["d.x"]), 1e-6)
        slides = self.go(ALONE + floor.replace("GX", "5"))
        self.assertAlmostEqual(slides[-1]["w.x"], -0.3 * weight, delta=1e-6 * weight)
        self.assertAlmostEqual(slides[-1]["d.x"], (5 - 3) * 0.5, delta=5e-3)
        for rows in (stands, slides):
            for row in rows:
                self.assertGreater(row["walls"] + row["friction"], -1e-9)
        # tips where gx > g 0.2/0.8 and friction holds; what the fall on the springs rocks is of second order in the step
        tall = ALONE.replace("[1, 0.8, 0.5]", "[0.2, 0.8, 0.8]") + floor.replace("step: 0.01", "step: 0.0025")
        self.assertGreater(self.go(tall.replace("GX", "2.8"))[-1]["turn.y"], 0.05)
        self.assertLess(max(abs(row["turn.y"]) for row in self.go(tall.replace("GX", "2.2"))), 1e-3)
        self.same_on_ranks(ALONE + floor.replace("GX", "5").replace("end: 0.5", "end: 0.1"), 0.05, done=False)

    def test_a_weight_on_a_wall_under_one_that_deforms(self):
        stack = "units: none\nmesh: [{box: {part: low, size: [1, 1, 0.5], elements: [2, 2, 1]}}, {box: {part: top, size: [0.9, 0.8, 0.4], elements: [2, 3, 2], at: [0.03, 0.05, 0.5]}}]\n" + LAWS + """\
parts: {low: {material: hard}, top: {material: m, element: hex8_full}}
contact: [{between: [low, top], method: mortar, friction: 0.4}]
rigid_walls: [{name: floor, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.4}]
gravity: {vector: [1, 0, -10]}
probes: [{name: w, wall: floor}, {name: p, contact: [top, low]}]
""" + STATIC
        mass, top = 20 * 0.5 + 2 * 0.288, 2 * 0.288
        row = self.go(stack)[-1]
        for name, force in (("w.z", 10 * mass), ("w.x", -mass), ("p.z", 10 * top), ("p.x", -top)):
            self.assertAlmostEqual(row[name], force, delta=1e-8 * mass)

    def test_what_cannot_be_is_refused_in_one_line(self):
        both = ON.replace("low: {material: m, element: hex8_full}", "low: {material: hard}") + "solver: implicit\nrun: {end: 1}\n"
        self.refused(both, "both rigid", "expected")
        self.refused(ON.replace("method: mortar", "method: mortar, slave: top") + "solver: implicit\nrun: {end: 1}\n", "it is rigid", "slave: low")
        for scheme in ("newmark", "hht"):
            self.refused(ALONE + f"solver: {{scheme: {scheme}}}\nrun: {{end: 1}}\n", "solver.scheme", "contact_implicit or static")
        self.refused(ALONE + STATIC, "all parts are rigid")
        told = self.go(ON + "fixed: [{set: low_zmin, dofs: [x, y, z]}]\ngravity: {vector: [0, 0, -10]}\n" + STATIC, code=3)
        self.assertIn("part top", told)
        self.assertIn("can move freely", told)


if __name__ == "__main__":
    unittest.main()
