#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Steps bounded by the assembled mesh: fewer of them, the same bits on any number of ranks and after a restart, messages. Needs BRUNT and
BRUNT_RUN (scripts/run) in the environment."""
import unittest

from run_test import Program

# Two bodies of unlike elements and laws meet; estimates at steps 0 and 1000; some elements go on the way.
SCENE = """\
units: none
mesh:
  - {box: {part: a, size: [1, 1, 1], elements: [5, 5, 5]}}
  - {box: {part: b, size: [1.2, 0.8, 0.9], elements: [4, 4, 4], at: [1.01, 0.1, 0.05]}}
materials:
  steel: {model: j2, density: 1, young: 100, poisson: 0.3, yield: 0.5, hardening: 1}
  rubber: {model: neo_hookean, density: 1, young: 50, poisson: 0.4}
parts: {a: {material: steel}, b: {material: rubber, element: hex8_bbar}}
sets: {corner: {part: a, box: [[0, 0, 0], [0.4, 0.4, 0.4]]}}
initial: [{part: a, velocity: [0.3, 0, 0]}]
contact: [{between: all, friction: 0.2}]
remove: [{set: corner, at: 2.0}]
run: {steps: 1100, step_bound: assembled}
"""


class StepBound(Program):
    def go(self, ranks, out, *options):
        self.write("scene.yaml", SCENE)
        self.run_scene(ranks, "scene.yaml", "--out", out, *options)
        return self.summary(out)

    def test_same_bits_on_any_number_of_ranks_and_after_a_restart(self):
        whole = self.go(1, "np1")
        for ranks in (2, 3, 4):
            self.assertEqual(self.go(ranks, f"np{ranks}")["state_hash"], whole["state_hash"], ranks)
        # before, at and after an estimate
        for steps in (3, 731, 1000):
            self.go(2, f"first{steps}", "--set", f"run.steps={steps}")
            again = self.go(3, f"first{steps}", "--restart", f"first{steps}")
            self.assertEqual(again["state_hash"], whole["state_hash"], steps)

    def test_fewer_steps_with_the_energy_kept(self):
        end = ("--set", "run.steps=null", "--set", "run.end=3")
        mesh = self.go(2, "mesh", *end)
        element = self.go(2, "element", *end, "--set", "run.step_bound=element")
        self.assertLess(1.15 * mesh["steps"], element["steps"])
        self.assertLess(mesh["energy"]["error_ratio"], 1e-10)

    def test_another_word_is_refused(self):
        self.write("scene.yaml", SCENE.replace("assembled", "global"))
        told = self.run_scene(1, "scene.yaml", "--out", "out", code=2)
        for phrase in ("scene.yaml:13: run.step_bound", "'global'", "element", "assembled"):
            self.assertIn(phrase, told)


if __name__ == "__main__":
    unittest.main()
