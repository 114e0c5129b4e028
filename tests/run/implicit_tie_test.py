#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Mortar ties over a gap in implicit scenes: seeded pairs of bodies that spin freely, seams that are curved, static patches, turned supports.
A tie neither takes nor gives energy, momentum or angular momentum. --variants N: pairs of each kind. Needs BRUNT and BRUNT_RUN (scripts/run)
in the environment."""
import math
import unittest

import numpy

from run_test import of_all, variants_asked
from scene_program import SceneProgram

VARIANTS = 3
LAWS = "materials: {m: {model: neo_hookean, density: 1000, young: 1.0e7, poisson: 0.3}, hard: {model: rigid, density: 1000}}\n"
SOFT = "parts: {a: {material: m, element: hex8_full}, b: {material: m, element: hex8_full}}\n"


def listed(values):
    return "[" + ", ".join(repr(float(value)) for value in values) + "]"


def counted(values):
    return "[" + ", ".join(str(int(value)) for value in values) + "]"


def boxes(random, gap):
    """Two boxes over each other, of any meshes; the upper one may overhang."""
    size, other = random.uniform(0.6, 1.2, 3), random.uniform(0.6, 1.2, 3)
    at = numpy.append(random.uniform(-0.1, 0.1, 2), size[2] + gap)
    return (f"mesh:\n  - {{box: {{part: a, size: {listed(size)}, elements: {counted(random.integers(1, 4, 3))}}}}}\n"
            f"  - {{box: {{part: b, size: {listed(other)}, elements: {counted(random.integers(1, 4, 3))}, at: {listed(at)}}}}}\n")


def tubes(random, gap):
    """A tube in another: chords of either lie here apart and there in each other, apart from the gap."""
    inner, outer = random.integers(12, 20), random.integers(10, 24)
    turn = random.uniform(0, 30)
    return (f"mesh:\n  - {{tube: {{part: a, inner_radius: 0.7, outer_radius: 1, length: 0.8, elements: [1, {inner}, 2]}}}}\n"
            f"  - {{tube: {{part: b, inner_radius: {1 + gap!r}, outer_radius: 1.4, length: 0.6, elements: [1, {outer}, 3],"
            f" rotate: {{axis: [0, 0, 1], degrees: {turn!r}}}, at: [0, 0, 0.1]}}}}\n")


def spin(axis, rate, velocity=(0, 0, 0)):
    return "initial:\n" + "".join(
        f"  - {{part: {part}, velocity: {listed(velocity)}, rotation: {{axis: {listed(axis)}, point: [0.4, 0.5, 0.9], rate: {rate!r}}}}}\n" for part in "ab")


def tie(slave="auto"):
    return f"contact: [{{between: [a, b], tied: true, method: mortar, slave: {slave}}}]\n"


def solver(step, end, scheme="contact_implicit"):
    return f"solver: {{scheme: {scheme}, step: {step!r}, tolerance: 1.0e-12}}\nrun: {{end: {end!r}}}\n"


class Ties(SceneProgram):
    def free_flight(self, scene, ranks=1, out="out"):
        rows = self.go(scene, ranks, out)
        told = self.summary(out)
        start = rows[0]["kinetic"]
        self.assertGreater(rows[-1]["active_contacts"], 2)
        self.assertEqual(told["implicit"]["halved"], 0)
        self.assertLess(max(abs(row["contact"]) for row in rows), 1e-11 * start, scene)
        self.assertLess(told["angular_momentum_error"], 1e-11, scene)
        self.assertLess(told["momentum_error"], 1e-11, scene)
        return rows

    def test_pairs_that_spin_keep_energy_and_angular_momentum(self):
        random = numpy.random.default_rng(1)
        axes = list(numpy.eye(3))
        for k in range(VARIANTS):
            axis = axes[k] if k < 3 else random.normal(size=3)
            mesh = boxes(random, 10 ** random.uniform(-3, math.log10(0.2)))
            scene = "units: none\n" + mesh + LAWS + SOFT + spin(axis, random.uniform(2, 10), random.uniform(-1, 1, 3))
            self.free_flight(scene + tie(random.choice(["first", "second", "auto"])) + solver(10 ** random.uniform(-3, -2), 0.1))

    def test_curved_seams_that_spin_keep_them_too(self):
        random = numpy.random.default_rng(2)
        for k in range(max(2, VARIANTS // 3)):
            axis = [0, 0, 1] if k == 0 else random.normal(size=3)
            mesh = tubes(random, (0, 0.02, 0.05)[k % 3])
            scene = "units: none\n" + mesh + LAWS + SOFT + spin(axis, random.uniform(2, 10))
            self.free_flight(scene + tie(random.choice(["first", "second"])) + solver(0.005, 0.05))

    def test_a_rigid_side_and_every_step(self):
        random = numpy.random.default_rng(3)
        mesh = boxes(random, 0.1)
        hard = SOFT.replace("b: {material: m, element: hex8_full}", "b: {material: hard}")
        for parts in (SOFT, hard):
            for step in (0.02, 0.01, 0.005):
                self.free_flight("units: none\n" + mesh + LAWS + parts + spin([1, 2, 3], 6) + tie() + solver(step, 0.2))

    def test_the_same_bits_on_ranks_and_after_a_restart(self):
        random = numpy.random.default_rng(4)
        for mesh in (boxes(random, 0.1), tubes(random, 0.02)):
            scene = "units: none\n" + mesh + LAWS + SOFT + spin([1, 2, 3], 6) + tie() + solver(0.005, 0.05)
            self.free_flight(scene)
            whole = self.summary("out")["state_hash"]
            for ranks in of_all((2, 3, 4), (3,)):
                self.go(scene, ranks, "ranks")
                self.assertEqual(self.summary("ranks")["state_hash"], whole)
                self.assertEqual(self.text("ranks", "history.csv"), self.text("out", "history.csv"))
            self.run_scene(2, "scene.yaml", "--out", "part", "--force", "--set", "run.end=0.02")
            self.run_scene(3, "scene.yaml", "--out", "part", "--restart", "part")
            self.assertEqual(self.summary("part")["state_hash"], whole)

    def test_velocities_that_a_tie_cannot_keep_are_told(self):
        scene = "units: SI\n" + boxes(numpy.random.default_rng(7), 0.1) + LAWS + SOFT + tie() + solver(0.005, 0.01)
        for initial, differs in ((spin([1, 2, 3], 6, (1, 2, 3)), ""), (spin([1, 2, 3], 6).replace("rate: 6", "rate: 5", 1), "differ by "),
                                 ("initial: [{part: b, velocity: [0, 0, 2]}]\n", "differ by 2 m/s at their seam")):
            told = self.go(scene + initial) and self.text("out", "log.txt")
            self.assertIn(differs, told)
            self.assertEqual("the initial velocities of the tied parts" in told, bool(differs))

    def test_a_bar_over_a_gap_is_a_bar(self):
        # uniaxial stress in both halves, of meshes that do not match; the gap carries it as if it were filled
        halves = ("units: none\nmesh:\n  - {box: {part: a, size: [1, 1, 0.5], elements: [3, 3, 2]}}\n"
                  "  - {box: {part: b, size: [1, 1, 0.5], elements: [4, 2, 2], at: [0, 0, GAP]}}\n").replace("GAP", "0.6")
        rest = """\
symmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}, {point: [0, 0, 0], normal: [0, 1, 0]}]
fixed: [{set: a_zmin, dofs: [z]}]
traction: [{set: b_zmax, value: [0, 0, 1.0e6]}]
output: {every: 1, fields: [stress]}
probes: [{name: end, set: b_zmax, field: displacement}, {name: seam, set: a_zmax, field: displacement}, {name: under, set: b_zmin, field: displacement}]
"""
        last = self.go(halves + LAWS + SOFT + rest + tie() + solver(1.0, 1.0, "static"))[-1]
        self.assertGreater(last["seam.z"], 0.04)
        self.assertAlmostEqual(last["under.z"] / last["seam.z"], 1, delta=1e-10)
        self.assertAlmostEqual(last["end.z"] / (2 * last["seam.z"]), 1, delta=1e-10)
        self.assertAlmostEqual(last["end.x"] / last["seam.x"], 1, delta=1e-9)

    def test_newton_is_quadratic_and_supports_feel_force_and_moment(self):
        # bent, sheared and twisted across a gap: the supports carry the load and its moment about any point
        random = numpy.random.default_rng(5)
        scene = "units: none\n" + boxes(random, 0.15) + LAWS + SOFT + """\
fixed: [{set: a_zmin, dofs: [x, y, z]}]
forces: [{set: b_zmax, total: [3.0e4, -2.0e4, 1.0e4]}]
probes:
  - {name: top, section: {part: b, point: [0, 0, 1.4], normal: [0, 0, 1], about: [0.2, 0.3, 0.4]}}
  - {name: foot, section: {part: a, point: [0, 0, 0.1], normal: [0, 0, 1], about: [0.2, 0.3, 0.4]}}
"""
        for slave in ("first", "second"):
            last = self.go(scene + tie(slave) + solver(0.5, 1.0, "static"))[-1]
            told = self.summary("out")["implicit"]["newton"]
            self.assertEqual(told["quadratic"], told["judged"])
            self.assertLess(max(len(step["residuals"]) for step in told["steps"]), 9)
            for column in ("top.x", "top.y", "top.z"):
                self.assertAlmostEqual(last[column] / last[column.replace("top", "foot")], 1, delta=1e-9)
            for axis in "xyz":
                size = max(abs(last[f"moment_foot.{c}"]) for c in "xyz")
                self.assertAlmostEqual(last[f"moment_top.{axis}"] / size, last[f"moment_foot.{axis}"] / size, delta=1e-9)

    def test_supports_that_turn_strain_nothing(self):
        # a rigid head turns by 80 degrees in four static steps and takes a block over a gap with it
        for axis in ("rx", "ry", "rz"):
            scene = "units: none\n" + boxes(numpy.random.default_rng(6), 0.1) + LAWS + SOFT.replace("b: {material: m, element: hex8_full}", "b: {material: hard}")
            held = ", ".join(dof for dof in ("x", "y", "z", "rx", "ry", "rz") if dof != axis)
            scene += (f"fixed: [{{part: b, dofs: [{held}]}}]\ncurves: {{turn: [[0, 0], [1, 1.4]]}}\nprescribed: [{{part: b, dof: {axis}, displacement: turn}}]\n"
                      "probes: [{name: a, part: a, field: center}]\n")
            last = self.go(scene + tie() + solver(0.25, 1.0, "static"))[-1]
            self.assertLess(abs(last["internal"]), 1e-9, axis)  # of some 1e6


if __name__ == "__main__":
    VARIANTS = variants_asked(VARIANTS)
    unittest.main()
