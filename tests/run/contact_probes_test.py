#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Forces of contact as probes give them: of a part against another one, against all others and against itself, along and
across the normals; and pressures on walls. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import csv
import os
import unittest

import h5py
import numpy

from run_test import Program, of_all

# Two blocks strike a third one from above and from the side; nothing else acts on them.
THREE = """\
units: none
mesh:
  - {box: {part: low, size: [2, 2, 1], elements: [4, 4, 2]}}
  - {box: {part: top, size: [1, 1, 1], elements: [3, 3, 3], at: [0.4, 0.3, 1.01]}}
  - {box: {part: side, size: [1, 1, 1.5], elements: [2, 2, 3], at: [2.02, 0.5, 0.1]}}
materials: {m: {model: elastic, density: 2, young: 100, poisson: 0.3}}
parts: {low: {material: m}, top: {material: m, element: hex8_full}, side: {material: m}}
initial: [{part: top, velocity: [0.7, 0.2, -1]}, {part: side, velocity: [-1, 0.3, 0]}]
contact: [{between: all, friction: 0.3}]
run: {end: 0.4}
history: {every: 0.01}
probes:
  - {name: l, contact: low}
  - {name: t, contact: top}
  - {name: s, contact: side}
  - {name: tl, contact: [top, low]}
  - {name: lt, contact: [low, top]}
  - {name: ts, contact: [top, side]}
  - {name: own, contact: [low, low]}
  - {name: p, part: top, field: momentum}
"""

# A block on a fixed one: it stays, or slides along x.
PRESSED = """\
units: none
mesh:
  - {box: {part: low, size: [3, 1, 0.5], elements: [9, 3, 2]}}
  - {box: {part: top, size: [1, 0.8, 0.5], elements: [4, 4, 3], at: [0.2, 0.1, 0.5]}}
materials: {m: {model: elastic, density: 1000, young: 1.0e7, poisson: 0.3}}
parts: {low: {material: m}, top: {material: m}}
fixed: [{part: low, dofs: [x, y, z]}]
gravity: {vector: [0, 0, -10]}
contact: [{between: [low, top], friction: FRICTION}]
relaxation: {tolerance: 1.0e-4}
run: {end: 0.02}
history: {every: 1.0e-3}
probes: [{name: t, contact: top}]
"""

# One part of two cubes, the upper one falls on the lower.
CUBES = """\
*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
11, 0, 0, 1.01
12, 1, 0, 1.01
13, 1, 1, 1.01
14, 0, 1, 1.01
15, 0, 0, 2.01
16, 1, 0, 2.01
17, 1, 1, 2.01
18, 0, 1, 2.01
*ELEMENT, TYPE=C3D8, ELSET=cubes
1, 1, 2, 3, 4, 5, 6, 7, 8
2, 11, 12, 13, 14, 15, 16, 17, 18
*NSET, NSET=upper
11, 12, 13, 14, 15, 16, 17, 18
"""
ITSELF = """\
units: none
mesh: {file: cubes.inp}
materials: {m: {model: elastic, density: 3, young: 100, poisson: 0}}
parts: {cubes: {material: m}}
initial: [{set: upper, velocity: [0, 0, -1]}]
contact: [{between: all}]
run: {end: 0.6}
history: {every: 0.01}
probes: [{name: own, contact: [cubes, cubes]}, {name: up, set: upper, field: velocity}]
"""

# A block at rest on a wall, with no way to bulge.
ON_WALL = """\
units: none
mesh: {box: {part: b, size: [1, 2, 0.5], elements: [3, 4, 2]}}
materials: {m: {model: elastic, density: 1000, young: 1.0e7, poisson: 0}}
parts: {b: {material: m}}
gravity: {vector: [0, 0, -10]}
rigid_walls: [{name: w, point: [0, 0, 0], normal: [0, 0, 1]}]
relaxation: {tolerance: 1.0e-6}
run: {steps: 20}
output: {fields: [contact_pressure]}
probes: [{name: w, wall: w}]
"""

AXES = ("x", "y", "z")


class ContactProbes(Program):
    def rows(self, result):
        """Rows of history.csv, by names without units."""
        with open(self.path(result, "history.csv"), encoding="utf-8") as stream:
            lines = list(csv.reader(stream))
        names = [name.split(" ")[0] for name in lines[0]]
        return [dict(zip(names, map(float, line))) for line in lines[1:]]

    def path(self, result, name):
        return os.path.join(self.folder, result, name)

    def vector(self, row, probe, part=""):
        return numpy.array([row[f"{probe}.{part}{axis}"] for axis in AXES])

    def test_forces_of_parts(self):
        self.write("three.yaml", THREE)
        self.run_scene(1, "three.yaml", "--out", "out")
        rows = self.rows("out")
        last = rows[-1]
        size = last["impulse_t.normal"]
        self.assertGreater(size, 0.5)
        for row in rows:
            parts = [self.vector(row, f"impulse_{name}") for name in ("l", "t", "s")]
            self.assertLess(numpy.linalg.norm(sum(parts)), 1e-12 * size)  # action and reaction
            numpy.testing.assert_array_equal(self.vector(row, "impulse_tl"), -self.vector(row, "impulse_lt"))
            of_pairs = self.vector(row, "impulse_tl") + self.vector(row, "impulse_ts")
            self.assertLess(numpy.linalg.norm(parts[1] - of_pairs), 1e-12 * size)
            for name in ("l", "t", "s", "tl"):
                split = self.vector(row, f"impulse_{name}", "normal_") + self.vector(row, f"impulse_{name}", "friction_")
                self.assertLess(numpy.linalg.norm(split - self.vector(row, f"impulse_{name}")), 1e-12 * size)
            given = self.vector(row, "p") - self.vector(rows[0], "p")
            given += self.vector(rows[0], "impulse_t")  # the first row holds the first step
            self.assertLess(numpy.linalg.norm(given - parts[1]), 1e-12 * size)
            self.assertEqual(row["own.normal"], 0)  # a block that does not fold
        self.assertLessEqual(last["impulse_t.friction"], 0.3 * last["impulse_t.normal"] * (1 + 1e-12))
        self.assertGreater(last["impulse_t.friction"], 0.1 * last["impulse_t.normal"])
        self.assertNotIn("own.x", last)
        # a force is the impulse since the last row over the time between them
        for before, after in zip(rows[1:], rows[2:]):
            passed = after["time"] - before["time"]
            self.assertAlmostEqual(after["t.normal"] * passed, after["impulse_t.normal"] - before["impulse_t.normal"], delta=0.2 * size)

    def test_same_on_ranks_and_after_a_restart(self):
        self.write("three.yaml", THREE)
        for ranks in of_all((1, 2, 3, 4), (1, 3)):
            self.run_scene(ranks, "three.yaml", "--out", f"out{ranks}")
            self.assertEqual(self.summary(f"out{ranks}")["state_hash"], self.summary("out1")["state_hash"])
            self.assertEqual(self.text(f"out{ranks}", "history.csv"), self.text("out1", "history.csv"))
        self.run_scene(2, "three.yaml", "--out", "part", "--set", "run.end=0.17")
        self.run_scene(3, "three.yaml", "--out", "part", "--restart", "part")
        self.assertEqual(self.summary("part")["state_hash"], self.summary("out1")["state_hash"])
        self.assertEqual(self.text("part", "history.csv"), self.text("out1", "history.csv"))

    def test_weight_of_a_block(self):
        self.write("pressed.yaml", PRESSED.replace("FRICTION", "0.2"))
        self.run_scene(1, "pressed.yaml", "--out", "out")
        weight = 10 * 1000 * 0.4
        for row in self.rows("out"):
            numpy.testing.assert_allclose(self.vector(row, "t"), [0, 0, weight], atol=2e-4 * weight)
            self.assertAlmostEqual(row["t.normal"], weight, delta=2e-4 * weight)

    def test_friction_of_a_sliding_block(self):
        self.write("slides.yaml", PRESSED.replace("FRICTION", "0.2").replace("run:", "initial: [{part: top, velocity: [2, 0, 0]}]\nrun:"))
        self.run_scene(1, "slides.yaml", "--out", "out")
        for row in self.rows("out"):
            self.assertAlmostEqual(row["t.friction"], 0.2 * row["t.normal"], delta=1e-9 * row["t.normal"])
            self.assertLess(row["t.friction_x"], -0.19 * row["t.normal_z"])
            numpy.testing.assert_allclose(self.vector(row, "t", "normal_")[:2], 0, atol=1e-9 * row["t.normal"])

    def test_a_part_against_itself(self):
        self.write("cubes.inp", CUBES)
        self.write("itself.yaml", ITSELF)
        self.run_scene(1, "itself.yaml", "--out", "out")
        rows = self.rows("out")
        lost = 3 * (rows[-1]["up.z"] - rows[0]["up.z"])
        self.assertGreater(lost, 1)  # they are apart again: velocities are those of the step before
        self.assertAlmostEqual(rows[-1]["impulse_own.normal"], lost, delta=1e-12)
        self.assertEqual(rows[-1]["impulse_own.friction"], 0)

    def test_pressure_on_a_wall(self):
        self.write("wall.yaml", ON_WALL)
        pressures = []
        for ranks in (1, 3):
            self.run_scene(ranks, "wall.yaml", "--out", f"out{ranks}")
            with h5py.File(self.path(f"out{ranks}", "state.h5")) as file:
                found = {}
                file.visititems(lambda name, item: found.__setitem__(name, item[()]) if isinstance(item, h5py.Dataset) else None)
            pressures.append([value for name, value in sorted(found.items()) if "contact_pressure" in name][-1].ravel())
        numpy.testing.assert_array_equal(pressures[0], pressures[1])
        on_wall = pressures[0][pressures[0] != 0]
        self.assertEqual(len(on_wall), 4 * 5)
        numpy.testing.assert_allclose(on_wall, 10 * 1000 * 0.5, rtol=1e-4)  # weight of what stands above, per area

    def test_bad_input(self):
        self.write("cubes.inp", CUBES)
        def fault(scene):
            self.write("bad.yaml", scene)
            return self.run_scene(1, "bad.yaml", "--out", "bad", code=2)
        own = fault(ITSELF.replace("between: all", "between: all, self: false"))
        self.assertIn("bad.yaml:9: probes.0.contact: invalid probe: part 'cubes' has no contact with itself; expected ", own)
        self.assertIn("part 'cubes' has no contact with any other part; expected ", fault(ITSELF.replace("[cubes, cubes]", "cubes")))
        self.assertIn("unknown part 'cube' (did you mean 'cubes'?); expected one of cubes", fault(ITSELF.replace("[cubes, cubes]", "cube")))
        self.assertIn("the scene has no contact; expected ", fault(ITSELF.replace("contact: [{between: all}]\n", "")))
        self.assertIn("expected a part a, two parts [a, b], or [a, a]", fault(ITSELF.replace("[cubes, cubes]", "[cubes]")))


if __name__ == "__main__":
    unittest.main()
