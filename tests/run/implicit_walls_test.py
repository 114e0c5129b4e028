#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Rigid walls in implicit scenes: what they carry, moving ones, impact, friction, corners, ranks, restarts. Needs BRUNT and BRUNT_RUN."""
import math
import unittest

from run_test import of_all
from scene_program import SceneProgram

BLOCK = """\
units: none
mesh: {box: {part: a, size: [1, 1, 2], elements: [2, 2, 4]}}
materials: {m: {model: neo_hookean, density: 2, young: 100, poisson: 0.25}}
parts: {a: {material: m, element: hex8_full}}
"""
MIRRORS = "symmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}, {point: [0, 0, 0], normal: [0, 1, 0]}]\n"
STATIC = "solver: {scheme: static, step: 0.25, tolerance: 1.0e-12}\nrun: {end: 1}\n"
SLIDE = BLOCK.replace("elements: [2, 2, 4]", "elements: [3, 3, 2], rotate: {axis: [0, 0, 1], degrees: 20}").replace("young: 100", "young: 1000").replace(
    "[1, 1, 2]", "[1, 1, 0.5]") + """\
gravity: {vector: [0, 0, -10]}
initial: [{part: a, velocity: [1.0, 0.5, 0]}]
rigid_walls: [{name: floor, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.3}]
solver: {scheme: contact_implicit, step: 0.01}
run: {end: 0.3}
probes: [{name: floor, wall: floor}]
"""


class Walls(SceneProgram):
    def test_a_floor_and_a_corner_carry_the_weight(self):
        floor = "{name: floor, point: [0, 0, 0], normal: [0, 0, 1]}"
        rows = self.go(BLOCK + MIRRORS + f"gravity: {{vector: [0, 0, -1]}}\nrigid_walls: [{floor}]\nprobes: [{{name: w, wall: floor}}]\n" + STATIC)
        for row in rows[1:]:  # a run begins without loads
            self.assertAlmostEqual(row["w.z"], 4, delta=1e-10)
        corner = f"rigid_walls: [{floor}, {{name: x, point: [0, 0, 0], normal: [1, 0, 0]}}, {{name: y, point: [0, 0, 0], normal: [0, 1, 0]}}]\n"
        rows = self.go(BLOCK + corner + "gravity: {vector: [-0.3, -0.2, -1]}\nprobes: [{name: w, wall: floor}, {name: x, wall: x}, {name: y, wall: y}]\n" + STATIC)
        for name, weight in (("w.z", 4), ("x.x", 1.2), ("y.y", 0.8)):
            self.assertAlmostEqual(rows[-1][name], weight, delta=1e-10)

    def test_a_moving_wall_does_what_prescribed_displacements_do(self):
        walls = "rigid_walls: [{name: floor, point: [0, 0, 0], normal: [0, 0, 1]}, {name: top, point: [0, 0, 2], normal: [0, 0, -1], motion: down}]\n"
        pressed = self.go(BLOCK + MIRRORS + walls + "curves: {down: [[0, 0], [1, 0.8]]}\nprobes: [{name: f, wall: floor}, {name: t, wall: top}]\n" + STATIC)
        driven = self.go(BLOCK + MIRRORS + "fixed: [{set: a_zmin, dofs: [z]}]\nprescribed: [{set: a_zmax, dof: z, displacement: down}]\n"
                         "curves: {down: [[0, 0], [0.25, -0.025], [0.5, -0.1], [0.75, -0.225], [1, -0.4]]}\nprobes: [{name: f, set: a_zmin, field: reaction}]\n" + STATIC, out="driven")
        for one, other in zip(pressed[1:], driven[1:]):
            self.assertAlmostEqual(one["f.z"], other["f.z"], delta=1e-9 * abs(other["f.z"]))
            self.assertAlmostEqual(one["t.z"], -one["f.z"], delta=1e-9 * abs(one["f.z"]))
        self.assertAlmostEqual(pressed[-1]["walls"], -pressed[-1]["internal"], delta=1e-12)
        self.assertGreater(pressed[-1]["internal"], 1)

    def test_a_bar_meets_a_wall_with_rho_c_v(self):
        bar = BLOCK.replace("[1, 1, 2]", "[0.1, 0.1, 10]").replace("[2, 2, 4]", "[1, 1, 100]").replace("neo_hookean", "elastic").replace(
            "young: 100, poisson: 0.25", "young: 200, poisson: 0")
        rows = self.go(bar + "initial: [{part: a, velocity: [0, 0, -0.1]}]\nrigid_walls: [{name: w, point: [0, 0, -0.005], normal: [0, 0, 1]}]\n"
                       "probes: [{name: w, wall: w}]\nsolver: {step: 0.005}\nrun: {end: 2.5}\n")
        force = [row["w.z"] for row in rows if 0.2 < row["time"] < 1.8]  # the wave comes back at 2.05
        self.assertAlmostEqual(sum(force) / len(force) / (2 * 10 * 0.1 * 0.01), 1, delta=1e-3)
        total = [row["total"] for row in rows]
        self.assertLess(max(abs(value / total[0] - 1) for value in total), 1e-11)
        self.assertLess(rows[-1]["walls"] / total[0], 0.01)  # the layer that meets the wall
        self.assertTrue(all(b["walls"] >= a["walls"] - 1e-14 for a, b in zip(rows, rows[1:])))
        self.assertLess(self.summary("out")["momentum_error"], 1e-10)

    def test_friction_is_coulombs(self):
        rows = self.go(SLIDE)
        normal = along = 0
        for row in rows[1:]:
            if math.hypot(row["momentum_x"], row["momentum_y"]) < 0.3:
                break  # some nodes stick
            normal += row["floor.z"]
            along += math.hypot(row["floor.x"], row["floor.y"])
        self.assertGreater(normal, 0)
        self.assertAlmostEqual(along / normal, 0.3, delta=3e-3)  # nodes that rock slide in other directions
        start, end = rows[0], rows[-1]
        self.assertAlmostEqual(end["total"], start["total"], delta=1e-9 * start["kinetic"])
        self.assertGreater(end["friction"], 0.8 * start["kinetic"])
        self.assertLess(self.summary("out")["momentum_error"], 1e-10)
        stands = SLIDE.replace("[0, 0, -10]", "[2, 0, -10]").replace("velocity: [1.0, 0.5, 0]", "velocity: [0, 0, 0]").replace("contact_implicit", "static")
        rows = self.go(stands)
        self.assertAlmostEqual(rows[-1]["floor.x"], -2, delta=1e-9)
        self.assertAlmostEqual(rows[-1]["floor.z"], 10, delta=1e-9)
        self.assertIn("the stiffness matrix is singular: the body has lost its stability or lacks supports", self.go(stands.replace("[2, 0, -10]", "[0, 0, 1]"), code=3))

    def test_friction_in_statics_converges_whatever_slides(self):
        # under weight alone all feet of a soft block slide at once; a load that grows makes them slide one by one
        block = BLOCK.replace("[1, 1, 2]", "[1, 1, 1]").replace("young: 100", "young: 1000") + "gravity: {vector: [SIDE, 0, -10]}\n"
        floor = "rigid_walls: [{name: w, point: [0, 0, 0], normal: [0, 0, 1], friction: MU}]\nprobes: [{name: w, wall: w}]\n"
        for elements, friction, side in ((1, 0.1, 0), (3, 0.1, 0), (2, 0.1, 0.9), (3, 0.3, 2.7), (4, 0.6, 5.4)):
            scene = block.replace("[2, 2, 4]", f"[{elements}, {elements}, {elements}]").replace("SIDE", str(side))
            rows = self.go(scene + floor.replace("MU", str(friction)) + "solver: {scheme: static, step: 0.5}\nrun: {end: 1.5}\n")
            self.assertAlmostEqual(rows[-1]["w.x"], -2 * side, delta=1e-6)
            self.assertAlmostEqual(rows[-1]["w.z"], 20, delta=1e-6)
            self.assertEqual(self.summary("out")["implicit"]["halved"], 0)
        for load in (3, 5.4):
            scene = block.replace("[2, 2, 4]", "[2, 2, 2]").replace("SIDE", "0") + floor.replace("MU", "0.3")
            rows = self.go(scene + f"traction: [{{set: a_zmin, value: [{load}, 0, 0], curve: c}}]\ncurves: {{c: [[0, 0], [1, 1]]}}\n"
                           "solver: {scheme: static, step: 0.1}\nrun: {end: 1}\n")
            self.assertAlmostEqual(rows[-1]["w.x"], -load, delta=1e-6)
            self.assertLess(self.summary("out")["implicit"]["iterations_mean"], 7)

    def test_a_rigid_block_does_not_fall_behind_a_wall(self):
        """Walls hold rigid bodies by springs; at 10 m/s and a step of 0.1 s the block of 0.1 m lay wholly behind the wall."""
        scene = ("units: SI\nmesh: [{box: {part: b, size: [0.1, 0.1, 0.1], elements: [1, 1, 1], at: [0, 0, 0.05]}}]\n"
                 "materials: {r: {model: rigid, density: 1100}}\nparts: {b: {material: r}}\ninitial: [{part: b, velocity: [0, 0, -10]}]\n"
                 "rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1]}]\nprobes: [{name: foot, near: [0, 0, 0.05], field: position}]\n"
                 "history: {every: 1.0e-6}\nsolver: {scheme: contact_implicit, step: STEP}\nrun: {end: END}\n")
        for step in (0.1, 0.04, 0.004):
            for ranks in (1, 2):
                rows = self.go(scene.replace("STEP", str(step)).replace("END", str(max(2 * step, 0.05))), ranks=ranks)
                depth = max(-row["foot.z"] for row in rows)
                self.assertLess(depth, 0.03)
                self.assertAlmostEqual(self.summary("out")["max_penetration"], depth, delta=1e-12)
                self.assertEqual("behind a rigid wall" in self.text("out", "log.txt"), depth > 0.1 * 0.1)

    def test_friction_of_driven_nodes_and_of_bilateral_walls(self):
        block = BLOCK.replace("[1, 1, 2]", "[1, 1, 1]").replace("[2, 2, 4]", "[1, 1, 1]") + "probes: [{name: w, wall: w}, {name: r, set: a_zmin, field: reaction}]\n"
        rows = self.go(block + "rigid_walls: [{name: w, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.3}]\ngravity: {vector: [0, 0, -10]}\n"
                       "prescribed: [{set: a_zmin, dof: x, displacement: c}]\nfixed: [{set: a_zmin, dofs: [y]}]\ncurves: {c: [[0, 0], [1, 0.8]]}\n" + STATIC)
        self.assertAlmostEqual(rows[-1]["w.x"], -6, delta=1e-9)
        self.assertAlmostEqual(rows[-1]["r.x"], 6, delta=1e-9)
        rows = self.go(block + "rigid_walls: [{name: w, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.5, bilateral: true}]\n"
                       "gravity: {vector: [0.5, 0, 10]}\n" + STATIC)
        self.assertAlmostEqual(rows[-1]["w.x"], -1, delta=1e-9)
        self.assertAlmostEqual(rows[-1]["w.z"], -20, delta=1e-9)

    def test_an_approach_without_forces_is_no_fault_of_energy(self):
        rows = self.go(BLOCK + "rigid_walls: [{name: w, point: [0, 0, -0.3], normal: [0, 0, 1]}]\nfixed: [{set: a_zmax, dofs: [x, y]}]\n"
                       "prescribed: [{set: a_zmax, dof: z, displacement: c}]\ncurves: {c: [[0, 0], [1, -0.4]]}\nprobes: [{name: w, wall: w}]\n"
                       "solver: {scheme: static, step: 0.05}\nrun: {end: 1}\n")
        self.assertEqual(rows[10]["w.z"], 0)
        self.assertGreater(rows[-1]["w.z"], 1)

    def test_newmark_is_stopped_where_walls_at_rest_give(self):
        told = self.go(BLOCK + "initial: [{part: a, velocity: [0, 0, -0.1]}]\nrigid_walls: [{point: [0, 0, -0.001], normal: [0, 0, 1]}]\n"
                       "solver: {scheme: newmark, step: 0.01}\nrun: {end: 1}\n", code=3)
        self.assertIn("walls at rest have supplied", told)
        self.assertIn("contact_implicit", told)

    def test_a_restart_between_rows_gives_the_same_means(self):
        scene = SLIDE.replace("run: {end: 0.3}", "run: {end: 0.1}\nhistory: {every: 0.05}\noutput: {every: 0.05}")
        self.go(scene)
        self.run_scene(1, "scene.yaml", "--out", "part", "--set", "run.end=0.07")
        self.run_scene(2, "scene.yaml", "--out", "part", "--restart", "part")
        self.assertEqual(self.text("part", "history.csv"), self.text("out", "history.csv"))

    def test_same_bits_on_any_ranks_and_after_a_restart(self):
        self.go(SLIDE)
        whole = self.summary("out")["state_hash"]
        for ranks in of_all((2, 3, 4), (3,)):
            self.go(SLIDE, ranks, f"out{ranks}")
            self.assertEqual(self.summary(f"out{ranks}")["state_hash"], whole)
        self.run_scene(2, "scene.yaml", "--out", "part", "--set", "run.end=0.1")
        self.run_scene(3, "scene.yaml", "--out", "part", "--restart", "part")
        self.assertEqual(self.summary("part")["state_hash"], whole)
        self.assertEqual(self.text("part", "history.csv"), self.text("out", "history.csv"))

    def test_a_stack_on_a_floor_and_what_its_parts_exert(self):
        # meshes that do not match; the upper block is pushed, friction holds it on the lower one, and that on the floor
        stack = """\
units: none
mesh: [{box: {part: low, size: [1, 1, 0.5], elements: [2, 2, 1]}}, {box: {part: top, size: [0.9, 1.1, 0.5], elements: [3, 3, 1], at: [0.02, -0.03, 0.5]}}]
materials: {m: {model: neo_hookean, density: 2, young: 1000, poisson: 0.3}}
parts: {low: {material: m, element: hex8_full}, top: {material: m, element: hex8_full}}
gravity: {vector: [1, -0.5, -10]}
contact: [{between: [low, top], method: mortar, friction: 0.4}]
rigid_walls: [{name: floor, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.4}]
probes: [{name: on_top, contact: [top, low]}, {name: on_low, contact: low}, {name: floor, wall: floor}]
solver: {scheme: static, step: 0.5, tolerance: 1.0e-11}
run: {end: 2}
"""
        rows = self.go(stack)
        top, low, last = 2 * 0.9 * 1.1 * 0.5, 2 * 0.5, rows[-1]
        for axis, pull in (("x", 1), ("y", -0.5), ("z", -10)):
            self.assertAlmostEqual(last[f"on_top.{axis}"], -pull * top, delta=1e-8)
            self.assertAlmostEqual(last[f"on_low.{axis}"], pull * top, delta=1e-8)
            self.assertAlmostEqual(last[f"floor.{axis}"], -pull * (top + low), delta=1e-8)
        self.assertAlmostEqual(math.hypot(last["on_top.friction_x"], last["on_top.friction_y"]), math.hypot(1, 0.5) * top, delta=0.02 * top)
        self.assertAlmostEqual(last["on_top.normal"], 10 * top, delta=0.02 * top)
        self.assertLess(self.summary("out")["implicit"]["iterations_mean"], 8)
        whole = self.summary("out")["state_hash"]
        for ranks in (2, 3):
            self.go(stack, ranks, f"out{ranks}")
            self.assertEqual(self.summary(f"out{ranks}")["state_hash"], whole)
            self.assertEqual(self.text(f"out{ranks}", "history.csv"), self.text("out", "history.csv"))
        self.run_scene(3, "scene.yaml", "--out", "part", "--set", "run.end=1")
        self.run_scene(2, "scene.yaml", "--out", "part", "--restart", "part")
        self.assertEqual(self.text("part", "history.csv"), self.text("out", "history.csv"))

    def test_a_bilateral_wall_pulls(self):
        walls = "rigid_walls: [{name: w, point: [0, 0, 0], normal: [0, 0, 1], bilateral: true}]\nprobes: [{name: w, wall: w}]\n"
        rows = self.go(BLOCK + MIRRORS + walls + "gravity: {vector: [0, 0, 1]}\n" + STATIC)
        self.assertAlmostEqual(rows[-1]["w.z"], -4, delta=1e-10)


if __name__ == "__main__":
    unittest.main()
