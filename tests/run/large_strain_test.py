#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Large strains: the logarithmic rate and the hourglass potential over ranks and restarts, a crushed rubber body.

Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import csv
import json
import os
import subprocess
import tempfile
import unittest

BRUNT, RUN = os.environ["BRUNT"], os.environ["BRUNT_RUN"]
PATIENCE = 300  # s

# A rubber cube between blocks that follow the logarithmic rate, with every kind of element; all of them strain by tenths.
PILE = """\
units: none
mesh:
  - {box: {part: foot, size: [1, 1, 1], elements: [3, 3, 3], at: [-0.5, -0.5, 0]}}
  - {box: {part: rubber, size: [0.9, 0.9, 0.9], elements: [4, 4, 4], at: [-0.41, -0.43, 1.001]}}
  - {box: {part: stiff, size: [1, 1, 0.5], elements: [3, 3, 2], at: [-0.5, -0.5, 1.902]}}
  - {box: {part: top, size: [1, 1, 0.5], elements: [2, 2, 2], at: [-0.47, -0.52, 2.403]}}
materials:
  metal: {model: j2, density: 1, young: 100, poisson: 0.3, yield: 1, hardening: 10, kinematic: 0.5, stress_rate: logarithmic}
  spring: {model: elastic, density: 1, young: 40, poisson: 0.3, stress_rate: logarithmic}
  gum: {model: neo_hookean, density: 1, bulk: 30, shear: 3}
parts:
  foot: {material: metal}
  rubber: {material: gum}
  stiff: {material: spring, element: hex8_full}
  top: {material: spring, element: hex8_bbar}
initial: [{part: top, velocity: [0.6, 0, -4]}, {part: stiff, velocity: [0.6, 0, -4]}]
rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1], friction: 0.5}]
contact: [{between: all, friction: 0.2}]
run: {end: 0.3}
history: {every: 0.01}
"""

CRUSH = """\
units: SI
mesh:
  - BODY
  - {box: {part: plate, size: [0.06, 0.06, 0.01], elements: [2, 2, 1], at: [-0.028, -0.031, TOP]}}
materials:
  r: {model: neo_hookean, density: 1100, bulk: 3.0e7, shear: 1.0e7}
  w: {model: elastic, density: 19000, young: 4.0e11, poisson: 0.28}
parts: {a: {material: r}, plate: {material: w, element: hex8_full}}
rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1], friction: 0.2}]
initial: [{part: plate, velocity: [0, 0, -SPEED]}]
contact: [{between: PAIR, friction: 0.1}]
run: {end: END}
"""


class LargeStrain(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory()
        self.addCleanup(keeper.cleanup)
        self.folder = keeper.name

    def run_scene(self, scene, out, ranks, *options):
        path = os.path.join(self.folder, "scene.yaml")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(scene)
        done = subprocess.run([RUN, "-np", str(ranks), path, "--out", out, "--quiet", *options], cwd=self.folder,
                              capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        with open(os.path.join(self.folder, out, "summary.json"), encoding="utf-8") as stream:
            return json.load(stream)

    def rows(self, out):
        with open(os.path.join(self.folder, out, "history.csv"), encoding="utf-8") as stream:
            return [{head.split("[")[0].strip(): float(value) for head, value in row.items()} for row in csv.DictReader(stream)]

    def test_ranks_and_restart_keep_every_bit(self):
        whole = self.run_scene(PILE, "whole", 1)
        self.assertEqual(self.run_scene(PILE, "three", 3)["state_hash"], whole["state_hash"])
        self.run_scene(PILE, "parts", 2, "--set", f"run.steps={whole['steps'] // 2}")
        continued = self.run_scene(PILE, "parts", 3, "--restart", "parts")
        self.assertEqual(continued["steps"], whole["steps"])
        self.assertEqual(continued["state_hash"], whole["state_hash"])
        rows = self.rows("whole")
        self.assertGreater(max(row["active_contacts"] for row in rows), 20)

    def test_a_crushed_rubber_body_makes_no_energy(self):
        bodies = {"box": "{box: {part: a, size: [0.02, 0.02, 0.02], elements: [4, 4, 4], at: [-0.01, -0.01, 1.0e-5]}}",
                  "cylinder": "{cylinder: {part: a, radius: 0.01, length: 0.02, elements: [4, 5], at: [0, 0, 1.0e-5]}}",
                  "sphere": "{sphere: {part: a, radius: 0.01, elements: 4, at: [0, 0, 0.01001]}}"}
        for (name, body), speed, pair in zip(bodies.items(), (12, 15, 15), ("all", "[a, plate]", "[plate, a]")):
            with self.subTest(name):
                scene = CRUSH.replace("BODY", body).replace("TOP", "0.02002").replace("SPEED", str(speed))
                scene = scene.replace("END", "3.0e-3").replace("PAIR", pair)
                summary = self.run_scene(scene, name, 2)
                self.assertLess(summary["energy"]["error_ratio"], 1e-10)
                rows = self.rows(name)
                initial = rows[0]["kinetic"]
                self.assertGreaterEqual(min(row["hourglass"] for row in rows), 0)
                self.assertGreater(min(row["internal"] for row in rows), -1e-3 * initial)
                self.assertGreater(max(row["internal"] for row in rows), 0.3 * initial)
                self.assertGreater(rows[-1]["momentum_z"], 0)  # thrown back

    def test_check_names_the_element_for_rubber_that_is_crushed(self):
        scene = CRUSH.replace("BODY", "{box: {part: a, size: [0.02, 0.02, 0.02], elements: [2, 2, 2], at: [0, 0, 0]}}")
        for old, new in (("TOP", "0.03"), ("SPEED", "1"), ("END", "1.0e-4"), ("PAIR", "all")):
            scene = scene.replace(old, new)
        path = os.path.join(self.folder, "scene.yaml")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(scene)
        for element, advice in (("hex8", True), ("hex8_full", False)):
            done = subprocess.run([BRUNT, "check", path, "--set", f"parts.a.element={element}"], capture_output=True,
                                  text=True, timeout=PATIENCE)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual("part a: use element hex8_full" in done.stdout, advice, done.stdout)


if __name__ == "__main__":
    unittest.main()
