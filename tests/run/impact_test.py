#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Return at opening (enforcement.impact: elastic). Elastic bars rebound as in theory with few elements; plastic flow gets nothing back;
contact never gives more than it took; a body at rest stays at rest; the same bits on any ranks and over a restart; without the key nothing
changes. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import unittest

import scenes
from run_test import of_all
from scene_program import SceneProgram

SPEED = 2e-3  # over the speed of sound
BARS = """units: none
mesh:
  - {{box: {{part: a, size: [1, {h}, {h}], elements: [{n}, {across}, {across}]}}}}
  - {{box: {{part: b, size: [1, {h}, {h}], elements: [{n}, {other}, {other}], at: [{place}, 0, 0]}}}}
materials: {{m: {{model: {model}, density: 1, young: 1, poisson: 0}}}}
parts: {{a: {{material: m, bulk: {{linear: 0, quadratic: 0}}}}, b: {{material: m, bulk: {{linear: 0, quadratic: 0}}}}}}
initial: [{{part: a, velocity: [{speed}, 0, 0]}}]
contact: [{{between: [a, b], passes: {passes}}}]
enforcement: {{impact: {impact}}}
symmetry: [{{point: [0, 0, 0], normal: [0, 1, 0]}}, {{point: [0, 0, 0], normal: [0, 0, 1]}}]
probes: [{{name: a, part: a, field: velocity}}, {{name: b, part: b, field: velocity}}]
run: {{end: 8, step: {step}, cfl: 0.95}}
history: {{every: {step}}}
"""
# A block of plastic metal and one of rubber fall askew on a floor and on each other, slide and rub.
FALL = """units: SI
mesh:
  - {box: {part: floor, size: [0.3, 0.3, 0.04], elements: [7, 7, 1], at: [-0.1, -0.1, -0.04]}}
  - {box: {part: metal, size: [0.1, 0.08, 0.06], elements: [4, 3, 2], rotate: {axis: [1, 0.4, 0], degrees: 4}, at: [0, 0, 0.006]}}
  - {box: {part: soft, size: [0.07, 0.08, 0.06], elements: [3, 4, 3], rotate: {axis: [0.2, 1, 0.5], degrees: 8}, at: [0.01, 0.01, 0.085]}}
  - {box: {part: hard, size: [0.05, 0.05, 0.05], elements: [1, 1, 1], at: [0.12, 0.02, 0.001]}}
materials:
  steel: {model: elastic, density: 7800, young: 2.0e9, poisson: 0.3}
  lead: {model: j2, density: 11000, young: 1.6e9, poisson: 0.4, yield: 2.0e6, hardening: 1.0e7}
  rubber: {model: neo_hookean, density: 1000, young: 1.0e8, poisson: 0.3}
  rigid: {model: rigid, density: 7800}
parts: {floor: {material: steel}, metal: {material: lead}, soft: {material: rubber, element: hex8_full}, hard: {material: rigid}}
fixed: [{set: floor_zmin, dofs: [x, y, z]}]
initial: [{part: metal, velocity: [4, 0, -8]}, {part: soft, velocity: [0, 3, -20]}, {part: hard, velocity: [-5, 0, -10]}]
contact: [{between: all, friction: 0.2, passes: PASSES}]
rigid_walls: [{name: side, point: [0.205, 0, 0], normal: [-1, 0, 0], friction: 0.1}]
enforcement: {impact: elastic}
run: {end: 0.012}
history: {every: 1.0e-4}
output: {every: 0.006, fields: [displacement]}
checkpoint: {every: 0.006}
"""
PRESSED = """units: SI
mesh:
  - {box: {part: low, size: [1, 1, 1], elements: [2, 2, 2]}}
  - {box: {part: top, size: [1, 1, 1], elements: [3, 3, 3], at: [0.02, -0.03, 1]}}
materials: {m: {model: elastic, density: 1000, young: 1.0e7, poisson: 0.3}}
parts: {low: {material: m}, top: {material: m}}
gravity: {vector: [0, 0, -10]}
damping: {alpha: 40, from: 0, to: 1}
contact: [{between: all, friction: 0.5}]
rigid_walls: [{name: floor, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.5}]
enforcement: {impact: elastic}
run: {end: 2}
history: {every: 0.01}
"""


def taken(row):
    return row["contact"] + row["walls"] + row["friction"] + row["driven"]


class Impacts(SceneProgram):
    def bars(self, impact, n, courant, phase, model="elastic", passes="auto", across=1, other=1):
        """Restitution, and the least energy that contact has taken up to a time over that of the start."""
        step = courant / n
        rows = self.go(BARS.format(n=n, h=1 / n, place=1 + SPEED * step * (1 + phase), speed=SPEED, step=step, impact=impact, model=model,
                                   passes=passes, across=across, other=other))
        return (rows[-1]["b.x"] - rows[-1]["a.x"]) / SPEED, min(taken(row) for row in rows) / rows[0]["kinetic"]

    def test_elastic_bars_rebound_with_few_elements(self):
        for n, plastic_theory in ((1, 0.50), (2, 0.74), (4, 0.86)):
            found = {}
            for impact in ("plastic", "elastic"):
                runs = [self.bars(impact, n, courant, phase) for courant in (0.9, 0.5) for phase in (0.1, 0.38, 0.66, 0.94)]
                self.assertGreater(min(given for _, given in runs), -1e-12)
                found[impact] = [restitution for restitution, _ in runs]
            message = f"N = {n}: {found}"
            self.assertGreater(sum(found["elastic"]) / 8, 0.965, message)
            self.assertGreater(min(found["elastic"]), 0.91, message)
            self.assertLess(max(found["elastic"]), 1 + 1e-9, message)
            self.assertAlmostEqual(sum(found["plastic"]) / 8, plastic_theory, delta=0.03, msg=message)

    def test_meshes_that_do_not_match_in_all_passes(self):
        for passes in ("one", "two", "mortar"):
            with self.subTest(passes=passes):
                plastic, _ = self.bars("plastic", 2, 0.5, 0.4, passes=passes, across=3, other=2)
                elastic, given = self.bars("elastic", 2, 0.5, 0.4, passes=passes, across=3, other=2)
                self.assertGreater(elastic, plastic + 0.1)
                self.assertGreater(elastic, 0.88)
                self.assertLess(elastic, 1 + 1e-9)
                self.assertGreater(given, -1e-9)

    def test_plastic_plates_get_nothing_back(self):
        model = f"j2, yield: {SPEED / 4}, hardening: 0"
        for n in (4, 8):
            plastic, elastic = (self.bars(impact, n, 0.9, 0.5, model)[0] for impact in ("plastic", "elastic"))
            self.assertLess(elastic, plastic + 0.01, f"N = {n}")

    def test_same_bits_on_any_ranks_and_over_a_restart(self):
        for passes in ("auto", "mortar"):
            with self.subTest(passes=passes):
                self.write("fall.yaml", FALL.replace("PASSES", passes))
                hashes = {}
                for ranks in of_all((1, 2, 3, 4), (1, 3)):
                    self.run_scene(ranks, "fall.yaml", "--out", f"r{ranks}", "--force")
                    hashes[ranks] = self.summary(f"r{ranks}")["state_hash"]
                self.assertEqual(len(set(hashes.values())), 1, hashes)
                self.run_scene(2, "fall.yaml", "--out", "part", "--force", "--set", "run.end=0.006")
                self.run_scene(3, "fall.yaml", "--out", "part", "--restart", "part")
                self.assertEqual(self.summary("part")["state_hash"], hashes[1])
                rows = self.rows("r1")
                self.assertGreater(min(taken(row) for row in rows), -1e-9 * rows[0]["kinetic"])
                self.run_scene(1, "fall.yaml", "--out", "other", "--force", "--set", "enforcement.impact=plastic")
                self.assertNotEqual(self.summary("other")["state_hash"], hashes[1], "the scene has no return")

    def test_without_the_key_nothing_changes(self):
        self.write("mixed.msh", scenes.mixed_mesh())
        self.write("scene.yaml", scenes.MIXED)
        hashes = set()
        for name, extra in (("none", ()), ("plastic", ("--set", "enforcement.impact=plastic"))):
            self.run_scene(1, "scene.yaml", "--out", name, *extra)
            hashes.add(self.summary(name)["state_hash"])
        self.assertEqual(len(hashes), 1)

    def test_bodies_at_rest_stay_at_rest(self):
        """Nothing is given once the weight has settled (t > 1): the kinetic energy vanishes."""
        rows = self.go(PRESSED)
        work = 1000 * 10 * 2 * 1e-3  # that of the weight over what it compresses, some 1e-3 [J]
        still = [row for row in rows if row["time"] > 1.2]
        self.assertGreater(len(still), 50)
        self.assertLess(max(row["kinetic"] for row in still), 1e-12 * work)
        self.assertLess(max(taken(row) for row in still) - min(taken(row) for row in still), 1e-9 * work)

    def test_what_cannot_return_energy_is_refused(self):
        for setting, words in (("enforcement.method=penalty", "invalid impact elastic with method penalty"),
                               ("contact.0.passes=averaged", "invalid impact elastic with passes averaged")):
            self.write("fall.yaml", FALL.replace("PASSES", "two"))
            told = self.run_scene(1, "fall.yaml", "--out", "out", "--force", "--set", setting, code=2)
            self.assertIn(words, told)


if __name__ == "__main__":
    unittest.main()
