#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Partitions from measured times: same bits, better balance, bad input in one line. Needs BRUNT and BRUNT_RUN in the environment."""
import os
import re
import unittest

from run_test import Program

# Two long bars side by side, and cubes that fall on the left end of one of them: contact sits there alone.
SCENE = """\
units: none
mesh:
  - {box: {part: table, size: [16, 4, 1], elements: [48, 12, 3]}}
  - {box: {part: load, size: [4, 4, 1], elements: [14, 14, 4], at: [0, 0, 1.0005]}}
materials: {m: {model: elastic, density: 1, young: 1000, poisson: 0.3}}
parts: {table: {material: m}, load: {material: m}}
initial: [{part: load, velocity: [0, 0, -0.2]}]
contact: [{between: all}]
run: {steps: 60}
"""


class Partition(Program):
    def setUp(self):
        super().setUp()
        self.write("scene.yaml", SCENE)

    def refused(self, *arguments):
        done = self.brunt(*arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        return done.stderr

    def test_a_restart_with_measured_weights_has_the_same_bits(self):
        self.run_scene(1, "scene.yaml", "--out", "one", "--set", "run.steps=90")
        self.assertGreater(self.summary("one")["contact"]["steps"], 0, "nothing touches: the test proves nothing")
        self.run_scene(2, "scene.yaml", "--out", "two")
        for parts in (2, 3):
            done = self.brunt("partition", "scene.yaml", "-n", str(parts), "--from", "two", "--write", f"p{parts}")
            self.assertEqual(done.returncode, 0, done.stderr)
            before, after = map(float, re.search(r"imbalance of contact time +([\d.]+) as measured, ([\d.]+)", done.stdout).groups())
            self.assertGreaterEqual(before, 1)
            self.assertLess(after, 1.1, done.stdout)
            self.run_scene(parts, "scene.yaml", "--out", f"on{parts}", "--restart", "two", "--partition", f"p{parts}", "--set", "run.steps=90")
            self.assertEqual(self.summary(f"on{parts}")["state_hash"], self.summary("one")["state_hash"])
        self.run_scene(2, "scene.yaml", "--out", "fresh", "--partition", "p2", "--set", "run.steps=90")
        self.assertEqual(self.summary("fresh")["state_hash"], self.summary("one")["state_hash"])

    def test_start_up_is_told(self):
        self.run_scene(2, "scene.yaml", "--out", "out")
        stages = self.summary("out")["start_up"]
        self.assertEqual(list(stages), ["reading", "ordering", "checking", "partitioning", "distributing", "building", "opening"])
        peaks = [stage["peak_bytes"] for stage in stages.values()]
        self.assertEqual(peaks, sorted(peaks))
        self.assertGreaterEqual(self.summary("out")["parallel"]["peak_memory"]["max"], peaks[-1])
        self.assertLess(sum(stage["seconds"] for stage in stages.values()), self.summary("out")["wall_s"])

    def test_bad_input_is_one_line(self):
        self.run_scene(1, "scene.yaml", "--out", "out", "--set", "run.steps=10")
        self.write("text.h5", "no HDF5\n")
        partition = ("partition", "scene.yaml", "-n", "2")
        self.assertIn("nothing", self.refused(*partition, "--from", "nothing"))
        self.assertIn("text.h5", self.refused(*partition, "--from", "text.h5"))
        self.assertIn("invalid checkpoint", self.refused(*partition, "--from", "out/state.h5"))
        self.assertIn("another one: materials.m.young", self.refused(*partition, "--from", "out", "--set", "materials.m.young=2"))
        self.assertEqual(self.brunt(*partition, "--write", "p").returncode, 0)
        self.assertIn("p: invalid folder: it exists", self.refused(*partition, "--write", "p"))
        run = ("run", "scene.yaml", "--out", "new", "--partition")
        self.assertIn("invalid partition of 2 parts", self.refused(*run, "p"))
        self.assertIn("none", self.refused(*run, "none"))
        self.assertIn("invalid partition", self.refused(*run, "out"))
        self.assertIn("another one: materials.m.young", self.refused(*run, "p", "--set", "materials.m.young=2"))
        self.assertFalse(os.path.exists(os.path.join(self.folder, "new")))


if __name__ == "__main__":
    unittest.main()
