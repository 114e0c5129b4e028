#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Rigid bodies that supports and moving walls squeeze without a way out: the run stops with a message before the depth matters, no body is
shot out, and the balance stays closed. Where there is a way out it ends as usual. Judged by positions of nodes in other bodies, momentum and
the work of the drive. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment; `--all` runs 300 scenes instead of one of each kind."""
import os
import random
import sys
import unittest

import h5py
import numpy

import driven_scenes
from run_test import Program, of_all

SEEDS = range(len(driven_scenes.KINDS))
MASSES = range(10)

SQUEEZED = """\
units: mm-ms-kg
mesh:
  - {box: {part: a, size: [4,4,4], elements: [1,1,1]}}
  - {box: {part: b, size: [4,4,4], elements: [1,1,1], at: [0,0,4.1]}}
  - {box: {part: c, size: [4,4,4], elements: [1,1,1], at: [0,0,8.2]}}
materials: {m: {model: rigid, density: 7.85e-6}}
parts: {a: {material: m}, b: {material: m}, c: {material: m}}
fixed: [{part: a, dofs: [x,y,z,rx,ry,rz]}]
prescribed: [{part: c, dof: z, velocity: -5}]
contact: [{between: all, friction: 0.2}]
run: {end: 0.6, step: 1.0e-3}
history: {every: 2.0e-3}
output: {every: 1.0e-3}
"""

PLATE = """\
units: mm-ms-kg
mesh:
  - {box: {part: a, size: [10,10,4], elements: [4,4,2]}}
materials: {m: {model: rigid, density: 7.85e-6}}
parts: {a: {material: m}}
"""
WALLS = PLATE + """\
curves: {v: [[0,0],[0.001,100]]}
rigid_walls: [{point: [0,0,0], normal: [0,0,1]}, {point: [0,0,4], normal: [0,0,-1], motion: v}]
run: {end: 0.02, step: 1.0e-4}
output: {every: 1.0e-4}
"""

INTO_WALL = PLATE + """\
prescribed: [{part: a, dof: z, velocity: -20}]
rigid_walls: [{point: [0,0,-0.1], normal: [0,0,1]}]
run: {end: 0.1, step: 1.0e-3}
output: {every: 1.0e-3}
"""


# a driven bar meets the end of a free pivoted one beside the line to its pivot
GEAR = """\
units: mm-ms-kg
mesh:
  - {box: {part: a, size: [30, 4, 5], elements: [6, 1, 1], at: [-15, -2, 0]}}
  - {box: {part: b, size: [30, 4, 5], elements: [6, 1, 1], at: [9, 2.5, 0]}}
materials: {h: {model: rigid, density: 7.85e-6}}
parts: {a: {material: h}, b: {material: h}}
fixed: [{part: a, dofs: [x,y,z,rx,ry]}, {part: b, dofs: [x,y,z,rx,ry]}]
curves: {w: [[0,0],[2,0.5]]}
prescribed: [{part: a, dof: rz, velocity: w}]
contact: [{between: all, friction: 0}]
probes: [{name: b, part: b, field: angular_velocity}]
run: {end: 6.5, step: 2.0e-3}
history: {every: 0.004}
"""


def place_of(reference, now):
    """Rotation and translation of a rigid body (Kabsch)."""
    a, b = reference.mean(axis=0), now.mean(axis=0)
    u, _, vt = numpy.linalg.svd((reference - a).T @ (now - b))
    turn = vt.T @ numpy.diag([1, 1, numpy.sign(numpy.linalg.det(vt.T @ u.T))]) @ u.T
    return turn, b - turn @ a


# a hammer falls on a pin, and something else is driven elsewhere
HAMMER = """\
units: SI
mesh:
  - {box: {part: base, size: [2, 2, 0.5], elements: [3, 3, 1], at: [-1, -1, -0.5]}}
  - {box: {part: pin, size: [0.4, 0.4, 0.4], elements: [N, N, 2], at: [-0.2, -0.2, 0]}}
  - {box: {part: hammer, size: [1, 1, 1], elements: [2, 2, 2], at: [-0.5, -0.5, 0.42]}}
  - {box: {part: far, size: [1, 1, 1], elements: [1, 1, 1], at: [10, 0, 0]}}
materials: {h: {model: rigid, density: 7800}, l: {model: rigid, density: 50}}
parts: {base: {material: l}, pin: {material: l}, hammer: {material: h}, far: {material: l}}
fixed: [{part: base, dofs: [x, y, z, rx, ry, rz]}]
prescribed: [{part: far, dof: x, velocity: 0.1}]
initial: [{part: hammer, velocity: [0, 0, -10]}]
contact: [{between: all, friction: 0.3}]
run: {end: 0.004, step: 1.0e-5}
"""


class Driven(Program):
    def stops(self, name, text, *more, ranks=1):
        """The line that the run ends with."""
        self.write(name + ".yaml", text)
        said = self.run_scene(ranks, name + ".yaml", "--out", name, *more, code=3)
        lines = [line for line in said.splitlines() if line.startswith("brunt: stopped")]
        self.assertEqual(len(lines), 1, said)
        self.assertIn("into each other: the driven penetration is", lines[0])
        self.assertEqual(self.summary(name)["stopped_by"], "guard")
        self.assertGreater(self.summary(name)["driven_penetration"], 0)
        self.assertLess(self.summary(name)["energy"]["error_ratio"], 1e-10)
        return lines[0]

    def motion(self, result):
        """Reference positions, the nodes of each part, and (time, positions, velocities) of each record."""
        with h5py.File(os.path.join(self.folder, result, "state.h5"), "r") as state:
            reference = state["mesh/coordinates"][:]
            cells = numpy.reshape(state["mesh/connectivity"][:], (-1, 8))
            block = state["mesh/element_block"][:]
            parts = {}
            for b in range(int(state.attrs["blocks"])):
                part = state[f"mesh/block_{b}"].attrs["part"]
                parts[part.decode() if isinstance(part, bytes) else str(part)] = numpy.unique(cells[block == b])
            records = []
            for key in sorted(key for key in state if key.startswith("record")):
                node = state[f"{key}/node"]
                records.append((float(state[key].attrs["time"]), reference + node["displacement"][:], node["velocity"][:]))
        return reference, parts, records

    def deepest(self, reference, parts, x, sizes):
        """Depth of nodes of rigid boxes, and of points on their edges, in others: each is a box of given sides, placed by its nodes."""
        boxes = {part: box_of(reference[parts[part]], x[parts[part]], size) for part, size in sizes.items()}
        depth = 0.0
        for one, nodes in parts.items():
            points = x[nodes] if one not in boxes else numpy.concatenate([x[nodes], points_on_edges(*boxes[one])])
            for other, (centre, axes, half) in boxes.items():
                if one != other:
                    depth = max(depth, (half - numpy.abs((points - centre) @ axes.T)).min(axis=1).max())
        return depth


def box_of(reference, now, size):
    """Centre, axes and half sides of a box from its nodes."""
    turn, shift = place_of(reference, now)
    centre, first = reference.mean(axis=0), reference[0]  # the first node is a corner
    d = reference - first
    lines = []
    for k in numpy.argsort(numpy.linalg.norm(d, axis=1))[1:]:
        u = d[k] / numpy.linalg.norm(d[k])
        if all(abs(u @ v) < 1e-9 for v in lines):
            lines.append(u)
        if len(lines) == 3:
            break
    axes = numpy.array(lines)
    half = 0.5 * (d @ axes.T).max(axis=0)
    return turn @ centre + shift, axes @ turn.T, half


def points_on_edges(centre, axes, half):
    t = numpy.linspace(-1, 1, 41)
    points = []
    for c in range(3):
        a, b = (c + 1) % 3, (c + 2) % 3
        for p in (-1, 1):
            for q in (-1, 1):
                line = numpy.zeros((len(t), 3))
                line[:, c], line[:, a], line[:, b] = t * half[c], p * half[a], q * half[b]
                points.append(centre + line @ axes)
    return numpy.concatenate(points)


class Named(Driven):
    """The scenes in which bodies were shot out, or passed a wall, without a word."""

    def test_a_free_body_between_a_fixed_and_a_driven_one_stays_there(self):
        said = self.stops("squeezed", SQUEEZED)
        self.assertIn("a hundredth of the rigid body", said)
        reference, parts, records = self.motion("squeezed")
        sizes = {part: [4, 4, 4] for part in "abc"}
        time, x, _ = records[-1]
        self.assertLess(time, (0.2 + 3 * 0.04) / 5 + 0.01)
        self.assertLess(self.deepest(reference, parts, x, sizes), 0.04 + 0.01)
        for _, x, v in records:
            self.assertLess(numpy.abs(v[parts["b"]]).max(), 10)  # twice the speed of the drive
        for row in self.history("squeezed"):
            self.assertLessEqual(row["kinetic"], row["external"] + 0.5 * 7.85e-6 * 64 * 25 * 1.001)

    def test_a_body_between_two_walls(self):
        self.assertIn("rigid wall", self.stops("walls", WALLS))
        reference, parts, records = self.motion("walls")
        for _, x, v in records:
            self.assertGreater(x[:, 2].min(), -0.05)
            self.assertLess(numpy.abs(v).max(), 200)

    def test_a_driven_body_that_may_turn_in_front_of_a_wall(self):
        self.assertIn("rigid wall", self.stops("into", INTO_WALL))
        summary = self.summary("into")
        self.assertLess(abs(summary["energy"]["external"]), 1000 * 0.5 * 7.85e-6 * 400 * 400)  # 3e7 J were booked
        reference, parts, records = self.motion("into")
        self.assertGreater(records[-1][1][:, 2].min(), -0.1 - 0.061)

    def test_a_bar_that_is_pushed_at_its_dead_point(self):
        # the corner comes at 7.1 mm/ms, .29 mm beside the line to the pivot: 24 rad/ms, and more while the lever is shorter within a step
        for step in (2.0e-3, 1.0e-3, 4.0e-4):
            with self.subTest(step=step):
                self.stops(f"gear{step}", GEAR.replace("step: 2.0e-3", f"step: {step}"))
                for row in self.history(f"gear{step}"):
                    self.assertLess(abs(row["b.z"]), 2 * 24.5)
                    self.assertLess(row["kinetic"], 0.5 * 0.357 * (2 * 24.5)**2)

    def test_a_free_hammer_on_a_pin_has_a_way_out(self):
        for count in (3, 12):
            with self.subTest(count=count):
                self.write(f"pin{count}.yaml", HAMMER.replace("N, N", f"{count}, {count}"))
                self.run_scene(1, f"pin{count}.yaml", "--out", f"pin{count}")
                self.assertEqual(self.summary(f"pin{count}")["driven_penetration"], 0)
                self.assertEqual(self.summary(f"pin{count}")["energy"]["driven"], 0)

    def test_same_bits_on_any_number_of_ranks_and_after_a_restart(self):
        hashes, text = [], SQUEEZED.replace("output: {every: 1.0e-3}", "output: {every: 0.1}")
        for ranks in of_all((1, 2, 3, 4), (1, 3)):
            self.stops(f"r{ranks}", text, ranks=ranks)
            hashes.append((self.summary(f"r{ranks}")["steps"], self.summary(f"r{ranks}")["state_hash"]))
        self.assertEqual(len(set(hashes)), 1, hashes)
        self.write("part.yaml", text)
        self.run_scene(2, "part.yaml", "--out", "part", "--set", "run.steps=45")  # in contact on both sides, and not yet too deep
        self.assertGreater(self.summary("part")["driven_penetration"], 0)
        self.stops("part", text, "--restart", "part", ranks=3)
        self.assertEqual((self.summary("part")["steps"], self.summary("part")["state_hash"]), hashes[0])


MISSED = {("masses", 280): 1.5}  # of 600: stopped 1.43 times as deep as admitted (cases/LIMITS.md)


class Varied(Driven):
    def run_to_its_end(self, scene, name, ranks, *more):
        self.write(name + ".yaml", scene.text)
        if scene.stuck and scene.kind != "turned":
            self.stops(name, scene.text, *more, ranks=ranks)
            return
        said = self.run_scene(ranks, name + ".yaml", "--out", name, *more, code=(0, 3) if scene.stuck else 0)
        if self.summary(name)["stopped_by"] == "guard":  # of "turned": the arm may also push the body aside
            self.assertIn("into each other: the driven penetration is", said)

    def check_restart(self, scene, name, rnd):
        """On any number of ranks up to a random step and from there on it ends with the same bits."""
        steps = rnd.randint(1, self.summary(name)["steps"] - 1)
        self.run_scene(rnd.choice((1, 2, 3)), name + ".yaml", "--out", name + "_part", "--set", f"run.steps={steps}", code=(0, 3))
        if self.summary(name + "_part")["stopped_by"] == "guard":  # at its end a run examines rows that are not missed at present, too
            return
        self.run_to_its_end(scene, name + "_part", rnd.choice((1, 2, 4)), "--restart", name + "_part")
        for key in ("steps", "state_hash"):
            self.assertEqual(self.summary(name + "_part")[key], self.summary(name)[key], key)

    def check(self, seed, kind=None):
        scene, rnd = driven_scenes.scene_of(seed, kind), random.Random(f"ranks {seed}")
        name = f"{kind or 's'}{seed}"
        self.run_to_its_end(scene, name, rnd.choice((1, 1, 2, 3)))
        if seed % 4 == 3:
            self.check_restart(scene, name, rnd)
        summary, rows = self.summary(name), self.history(name)
        reference, parts, records = self.motion(name)
        self.assertLess(summary["energy"]["error_ratio"], 1e-10)
        travel = scene.speed * scene.step
        bound = (scene.limit + 2 * travel) * MISSED.get((kind, seed), 1)
        for time, x, v in records:
            self.assertLess(self.deepest(reference, parts, x, scene.sizes), bound, f"t = {time}")
            for part in scene.free:  # a body between inclined sides slides out the faster the less they are inclined
                if part in scene.sizes and scene.kind in ("chain", driven_scenes.MASSES, "walls", "way_out"):
                    self.assertLess(numpy.linalg.norm(v[parts[part]], axis=1).max(), 6 * scene.speed, f"{part} at t = {time}")
        for row in rows:
            drive = row["external"] - min(row["walls"], 0.0) - min(row.get("driven", 0.0), 0.0) + rows[0]["kinetic"]
            self.assertLessEqual(row["kinetic"], 1.001 * drive + 1e-9 * scene.speed**2)
        if scene.stuck and scene.kind in ("chain", driven_scenes.MASSES, "walls", "into_wall"):  # others may first turn and slide
            self.assertLess(scene.speed * summary["end_time"], scene.slack + 1.5 * scene.rows * scene.limit + 20 * travel)
        elif not scene.stuck:
            self.assertEqual(summary["driven_penetration"], 0)

    def test_scenes(self):
        for seed in SEEDS:
            with self.subTest(seed=seed, kind=driven_scenes.KINDS[seed % len(driven_scenes.KINDS)]):
                self.check(seed)

    def test_masses(self):
        for seed in MASSES:
            with self.subTest(seed=seed):
                self.check(seed, driven_scenes.MASSES)


if __name__ == "__main__":
    if "--all" in sys.argv:
        sys.argv.remove("--all")
        SEEDS = MASSES = range(300)
    unittest.main()
