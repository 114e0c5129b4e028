#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Random impacts of coarse boxes, judged by the positions in state.h5: a run leaves no node deep in another body, or it
says so. Needs BRUNT (the program) and BRUNT_RUN (scripts/run) in the environment. --all: three hundred scenes."""
import json
import os
import sys
import unittest

import falling_boxes
import true_depth
from run_test import Program

# Share of an element from which the program warns (src/app/watch/depth_watch.hpp), and what two ways to measure it may differ
# by: it takes six tetrahedra for a warped hexahedron, whose faces are not bilinear.
WARNED, DIFFERENCE, WARP = 0.1, 0.05, 0.01
SHORT = (20, 27, 34, 42, 54, 64, 67, 68, 70, 81)  # the fastest, with each law and with folds
ALL = range(1, 301)

# Two bars of long elements, from a scene in which the nodes of the second came to lie 2.3 elements deep in the first:
# by mean areas it is the coarser one, but not across the long elements of the first.
LONG_ELEMENTS = """units: mm-ms-kg
mesh:
  - {box: {part: p0, size: [3.54213, 4.78379, 6.06086], elements: [6, 4, 1], rotate: {axis: [-0.445845694, 0.849583324, 0.281832916], degrees: 125.590715628}, at: [1.846455, -4.441254, 6.017069]}}
  - {box: {part: p1, size: [7.24957, 5.12789, 5.62320], elements: [5, 3, 1], at: [-4.465412, -3.785238, 6.144726]}}
materials: {st: {model: j2, density: 7.85e-6, young: 210, poisson: 0.3, yield: 0.4, hardening: 1}}
parts: {p0: {material: st, element: hex8_full}, p1: {material: st, element: hex8}}
initial: [{part: p0, velocity: [1.55, -0.37, -63.97]}, {part: p1, velocity: [-0.25, -6.81, -217.35]}]
contact: [{between: all, friction: 0}]
rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1], friction: 0.2}]
run: {end: 0.03}
output: {every: 0.002, fields: [displacement]}
"""
MISSED = {277: 0.008}  # of 300: .0295 of an element deep beside bent edges, told as .0108 (cases/LIMITS.md)


class Falls(Program):
    def run_text(self, text, name, ranks=1, code=0):
        self.write(name + ".yaml", text)
        self.run_scene(ranks, name + ".yaml", "--out", name, code=code)
        return self.summary(name), self.text(name, "log.txt")

    def judge(self, seed, end, records):
        name = f"seed{seed}"
        summary, log = self.run_text(falling_boxes.scene(seed, end, records), name, code=(0, 3))
        found = true_depth.deepest(os.path.join(self.folder, name, "state.h5"))
        message = f"seed {seed}: {found}, {summary['deepest_penetration']}\n{log}"
        self.assertLess(summary["energy"]["error_ratio"], 1e-10, message)
        if found.share > WARNED + DIFFERENCE:
            told = "leaves penetration" in log or "lost nodes" in log or "folded" in log
            self.assertTrue(told, message)
        if summary["folded_elements"] == 0:  # a folded element has no inside
            least = found.share * (1 - DIFFERENCE) - WARP - MISSED.get(seed, 0)
            self.assertGreaterEqual(summary["deepest_penetration"]["elements"], least, message)
        return found.share, summary["folded_elements"]

    def test_ten_falls(self):
        for seed in SHORT:
            with self.subTest(seed=seed):
                self.judge(seed, 0.06, records=8)

    def test_nodes_between_those_of_long_elements_are_held(self):
        """G20: a node 2.3 elements deep, exit 0, no warning."""
        summary, log = self.run_text(LONG_ELEMENTS, "long")
        found = true_depth.deepest(os.path.join(self.folder, "long", "state.h5"))
        self.assertLess(found.share, 0.05, f"{found}\n{log}")
        self.assertLess(summary["energy"]["error_ratio"], 1e-10)

    def test_lost_nodes_stop_the_run_on_any_number_of_ranks(self):
        """In one pass nothing holds the master's nodes: the same scene as it was."""
        found = set()
        for ranks in (1, 2, 3):
            text = LONG_ELEMENTS.replace("friction: 0}", "friction: 0, passes: one}")
            summary, log = self.run_text(text, f"one{ranks}", ranks, code=3)
            self.assertRegex(log, r"warning: contact leaves penetration: (an edge at )?node \d+ of part 'p\d' lies \S+ mm deep in part 'p\d'")
            self.assertRegex(log, r"contact has lost (nodes: |edges: an edge at )node \d+ of part 'p\d' lies \S+ mm deep in part 'p\d'")
            found.add((summary["state_hash"], json.dumps(summary["deepest_penetration"])))
        self.assertEqual(len(found), 1, found)


class ManyFalls(Falls):
    def test_three_hundred_falls(self):
        deep = 0
        for seed in ALL:
            with self.subTest(seed=seed):
                share, folds = self.judge(seed, 0.1, records=20)
                deep += share > WARNED and folds == 0
        self.assertLessEqual(deep, 10)  # of those in which no element folds: ours 1 of the first 81


if __name__ == "__main__":
    if "--all" in sys.argv:
        sys.argv.remove("--all")
    else:
        del ManyFalls
    unittest.main()
