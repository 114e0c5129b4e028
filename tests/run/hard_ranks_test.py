#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Hard cases E1, E11 and E16 have the same bits on one and three ranks. Their criteria are held in tests/hard.

Needs BRUNT_RUN (scripts/run) in the environment."""
import csv
import json
import math
import os
import subprocess
import tempfile
import unittest

RUN = os.environ["BRUNT_RUN"]
PATIENCE = 120  # s


def box(part, size, elements, at):
    return f"{{box: {{part: {part}, size: {list(size)}, elements: {list(elements)}, at: {list(at)}}}}}"


def moved(origin, *offset):
    return [a + b for a, b in zip(origin, offset)]


# E1: a heavy body meets one of a millionth of its mass, which lies askew of its mesh
MASS_RATIO = """\
units: none
mesh: [{heavy_box}, {light_box}]
materials:
  h: {{model: elastic, density: {heavy_density}, young: {young}, poisson: 0.3}}
  l: {{model: elastic, density: {light_density}, young: {young}, poisson: 0.3}}
parts: {{heavy: {{material: h}}, light: {{material: l}}}}
initial: [{{part: heavy, velocity: [0, 0, {speed}]}}]
contact: [{{between: all}}]
run: {{end: {end}}}
history: {{every: {every}}}
"""
BY_DENSITY = MASS_RATIO.format(heavy_box=box("heavy", (1, 1, 1), (3, 3, 3), (0, 0, -1)), heavy_density=1e6, light_density=1,
                               light_box=box("light", (1, 1, 1), (3, 3, 3), (0.13, -0.21, 1e-4)), young=1e10, speed=1,
                               end=3e-4, every=5e-6)
BY_SIZE = MASS_RATIO.format(heavy_box=box("heavy", (1, 1, 1), (4, 4, 4), (0, 0, -1)), heavy_density=7800, light_density=7800,
                            light_box=box("light", (0.01, 0.01, 0.01), (2, 2, 2), (0.3, 0.245, 1e-5)), young=2e11,
                            speed=math.sqrt(2 * 9.81 * 0.1), end=3e-5, every=1e-6)

# E11: a block sticks while its load along the plane swings to 99 % of the limit of friction
SWING = """\
units: none
mesh: {mesh}
materials: {{m: {{model: elastic, density: 1000, young: 1.0e7, poisson: 0.3}}}}
parts: {parts}
damping: {{alpha: 1000}}
{below}
curves: {{press: [[0, 0], [0.01, 1]], swing: {swing}}}
pressure: [{{set: block_zmax, value: 1000, curve: press}}]
gravity: {{vector: [24.75, 0, 0], curve: swing}}
probes: [{{name: block, part: block, field: position}}]
run: {{end: {end}}}
history: {{every: 1.0e-3}}
"""
BLOCK = box("block", (0.1, 0.1, 0.02), (4, 4, 2), (0, 0, 0))
PLATE = box("plate", (0.14, 0.14, 0.02), (5, 5, 1), (-0.02, -0.02, -0.02))


def swing(mesh, parts, below, cycles):
    rest, period = 0.02, 0.01
    points = [[0, 0], [rest, 0]]
    points += [[rest + (k + 1) * period / 24, math.sin(2 * math.pi * (k + 1) / 24)] for k in range(24 * cycles)]
    return SWING.format(mesh=mesh, parts=parts, below=below, swing=points, end=rest + cycles * period)


ON_WALL = swing(f"[{BLOCK}]", "{block: {material: m}}",
                "rigid_walls: [{name: floor, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.5}]", 3)
ON_PLATE = swing(f"[{BLOCK}, {PLATE}]", "{block: {material: m}, plate: {material: m}}",
                 "fixed: [{set: plate_zmin, dofs: [x, y, z]}]\ncontact: [{between: [block, plate], friction: 0.5}]", 3)

# E16: an impact, and two blocks pressed together, 1e6 m from the origin with elements of 1 mm
FAR = (1e6, -1e6, 1e6)
FAR_IMPACT = f"""\
units: SI
mesh: [{box("left", (0.02, 0.001, 0.001), (20, 1, 1), FAR)}, {box("right", (0.02, 0.001, 0.001), (20, 2, 2), moved(FAR, 0.02, 0, 0))}]
materials: {{m: {{model: elastic, density: 8000, young: 2.0e11, poisson: 0}}}}
parts: {{left: {{material: m}}, right: {{material: m}}}}
initial: [{{part: left, velocity: [10, 0, 0]}}]
contact: [{{between: all}}]
run: {{end: 1.2e-5}}
history: {{every: 4.0e-7}}
"""
UNIT = 1 / 4096  # multiples are exact 1e6 m away
FAR_PRESS = f"""\
units: none
mesh:
  - {box("lower", (12 * UNIT, 6 * UNIT, 2 * UNIT), (3, 3, 1), FAR)}
  - {box("upper", (12 * UNIT, 6 * UNIT, 2 * UNIT), (4, 3, 1), moved(FAR, 0, 6 * UNIT, 0))}
materials: {{m: {{model: elastic, density: 1, young: 1, poisson: 0.3}}}}
parts: {{lower: {{material: m, element: hex8_full}}, upper: {{material: m, element: hex8_full}}}}
fixed: [{{set: lower_ymin, dofs: [y]}}]
symmetry:
  - {{point: {list(FAR)}, normal: [1, 0, 0]}}
  - {{point: {list(FAR)}, normal: [0, 0, 1]}}
  - {{point: {moved(FAR, 0, 0, 2 * UNIT)}, normal: [0, 0, -1]}}
curves: {{ramp: [[0, 0], [0.073, 1]]}}
pressure: [{{set: upper_ymax, value: 1.0e-4, curve: ramp}}]
damping: {{alpha: 680}}
contact: [{{between: [lower, upper], slave: upper, tolerance: 1.0e-6}}]
run: {{end: 0.09}}
history: {{every: 1.0e-3}}
"""


class HardCases(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory()
        self.addCleanup(keeper.cleanup)
        self.folder = keeper.name

    def rows(self, out):
        with open(os.path.join(self.folder, out, "history.csv"), encoding="utf-8") as stream:
            return [{head.split("[")[0].strip(): value for head, value in row.items()} for row in csv.DictReader(stream)]

    def same_bits(self, scene):
        """Runs on one and three ranks; rows of the history, which show that something touches."""
        with open(os.path.join(self.folder, "scene.yaml"), "w", encoding="utf-8") as stream:
            stream.write(scene)
        hashes = []
        for ranks in (1, 3):
            done = subprocess.run([RUN, "-np", str(ranks), "scene.yaml", "--out", f"r{ranks}", "--force", "--quiet"],
                                  cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(os.path.join(self.folder, f"r{ranks}", "summary.json"), encoding="utf-8") as stream:
                summary = json.load(stream)
            self.assertEqual(summary["ranks"], ranks)
            hashes.append(summary["state_hash"])
        self.assertEqual(hashes[0], hashes[1])
        rows = self.rows("r1")
        self.assertEqual(rows, self.rows("r3"))
        touching = sum(float(row["active_contacts"]) > 0 for row in rows)
        self.assertGreater(touching, 3, "nothing touches: the test proves nothing")
        return rows

    def test_masses_a_million_apart(self):
        for name, scene in (("densities 1 and 1e6", BY_DENSITY), ("sides 1 m and 1 cm", BY_SIZE)):
            with self.subTest(name):
                self.assertEqual(float(self.same_bits(scene)[-1]["active_contacts"]), 0)  # met and parted

    def test_sticking_under_a_load_that_swings(self):
        for name, scene in (("on a wall", ON_WALL), ("on a plate", ON_PLATE)):
            with self.subTest(name):
                rows = self.same_bits(scene)
                places = [float(row["block.x"]) for row in rows]
                self.assertGreater(max(places) - min(places), 1e-6)  # to and fro
                self.assertGreater(float(rows[-1]["active_contacts"]), 15)

    def test_far_from_the_origin(self):
        for name, scene in (("an impact", FAR_IMPACT), ("blocks pressed together", FAR_PRESS)):
            with self.subTest(name):
                self.same_bits(scene)


if __name__ == "__main__":
    unittest.main()
