#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What a result folder goes through: restarts, limits, files that do not fit. Needs BRUNT and BRUNT_RUN (scripts/run)."""
import os
import subprocess
import unittest

import scenes
from run_test import PATIENCE, RUN, Program


class Folder(Program):
    def setUp(self):
        super().setUp()
        self.write("rod.yaml", scenes.ROD)

    def faults(self, ranks, *arguments):
        """The lines of a run that is refused."""
        done = subprocess.run([RUN, "-np", str(ranks), "rod.yaml", "--out", "out", *arguments], cwd=self.folder, capture_output=True,
                              text=True, timeout=PATIENCE, check=False)
        self.assertEqual(done.returncode, 2, done.stderr + done.stdout)
        return done.stderr.splitlines()

    def test_a_restart_by_force_keeps_what_it_goes_on_from(self):
        self.run_scene(1, "rod.yaml", "--out", "whole")
        self.run_scene(1, "rod.yaml", "--out", "out", "--set", "run.steps=6")
        self.run_scene(1, "rod.yaml", "--out", "out", "--restart", "out", "--force")
        self.assertIn("checkpoint_000000006.h5", os.listdir(os.path.join(self.folder, "out")))
        self.assertEqual(self.text("out", "history.csv"), self.text("whole", "history.csv"))

    def test_the_scene_as_it_was_run_is_the_same_run(self):
        changes = ("--set", "run.steps=7", "--set", "parts.rod.element=hex8_full", "--set", 'title="a: rod, [steel] # \\"quoted\\""')
        self.run_scene(1, "rod.yaml", "--out", "out", *changes)
        text = self.text("out", "scene_as_run.yaml")
        self.assertIn("element: hex8_full", text)
        self.assertTrue(text.startswith(f"# rod.yaml as read by {self.summary('out')['version']}"), text)
        self.write("again.yaml", text)
        self.run_scene(2, "again.yaml", "--out", "again")
        for key in ("title", "steps", "state_hash"):
            self.assertEqual(self.summary("again")[key], self.summary("out")[key])
        self.run_scene(1, "again.yaml", "--out", "out", "--restart", "out", "--set", "run.steps=9")
        self.assertIn("steps: 9", self.text("out", "scene_as_run.yaml"))

    def test_a_history_of_other_columns_is_refused_on_all_ranks(self):
        self.run_scene(1, "rod.yaml", "--out", "out", "--set", "run.steps=6")
        self.write("out/history.csv", self.text("out", "history.csv").replace("kinetic", "kinetisch"))
        for ranks in (1, 2, 3):
            lines = self.faults(ranks, "--restart", "out")
            self.assertEqual(len(lines), 1, lines)
            self.assertIn("history.csv:1: invalid columns", lines[0])

    def test_missing_rows_of_the_history_are_told(self):
        every = ("--set", "history.every=1e-9")  # a row each step
        self.run_scene(1, "rod.yaml", "--out", "out", "--set", "run.steps=8", *every)
        lines = self.text("out", "history.csv").splitlines(keepends=True)
        self.assertEqual(len(lines), 10)
        self.write("out/history.csv", "".join(lines[:4] + lines[7:]))
        for ranks, steps, told in ((1, 10, True), (2, 12, False)):  # told once, where it is new
            self.run_scene(ranks, "rod.yaml", "--out", "out", "--restart", "out", "--set", f"run.steps={steps}", *every)
            last = self.text("out", "log.txt").rpartition("restart from")[2]
            times = [float(lines[k].split(",")[1]) for k in (3, 7)]
            wanted = f"history.csv: 3 of the 8 rows up to this checkpoint are missing (largest gap: from t = {times[0]:g} to t = {times[1]:g})"
            self.assertEqual(wanted in last, told, last)
            self.assertEqual("rows" in last, told, last)

    def test_a_damaged_checkpoint_points_to_the_one_before(self):
        for steps in (4, 6):
            self.run_scene(1, "rod.yaml", "--out", "out", "--set", f"run.steps={steps}", *(("--restart", "out") if steps > 4 else ()))
        path = os.path.join(self.folder, "out", "checkpoint_000000006.h5")
        os.truncate(path, os.path.getsize(path) // 2)
        for ranks in (1, 2):
            lines = self.faults(ranks, "--restart", "out")
            self.assertEqual(len(lines), 1, lines)
            self.assertIn("the previous checkpoint is intact and of this scene: --restart out/checkpoint_000000004.h5", lines[0])
        self.run_scene(1, "rod.yaml", "--out", "out", "--restart", "out/checkpoint_000000004.h5", "--set", "run.steps=8")

    def test_a_restart_with_another_scene_says_which_keys_differ(self):
        self.run_scene(1, "rod.yaml", "--out", "out", "--set", "run.steps=4", "--set", "run.cfl=0.8")
        for ranks in (1, 2):
            lines = self.faults(ranks, "--restart", "out", "--set", "materials.steel.density=7801", "--set", "run.cfl=0.5", "--set", "run.steps=9")
            self.assertEqual(len(lines), 1, lines)
            self.assertRegex(lines[0], r"checkpoint_000000004.h5: invalid for this scene: written by another one: materials.steel.density is \S+ in the earlier run and 7801 in this scene; "
                             r"run.cfl is 0.8 in the earlier run and 0.5 in this scene; expected")

    def test_the_wall_limit_counts_from_the_start_of_the_program(self):
        """A batch system counts reading and splitting of the mesh as well, which takes more than this; five steps are never looked at."""
        self.run_scene(1, "rod.yaml", "--out", "out", "--set", "run.steps=5", "--set", "run.wall_limit=0.001s", code=5)
        self.assertEqual(self.summary("out")["stopped_by"], "wall_limit")

    def test_every_fault_of_the_model_has_a_line_of_its_own(self):
        wrong = ("--set", "fixed=[{part: table, dofs: [x, y, z]}]", "--set", "prescribed=[{set: table_xmax, dof: x, velocity: ramp}, "
                 "{set: table_ymax, dof: y, velocity: ramp}]")
        for ranks in (1, 2):
            lines = self.faults(ranks, *wrong)
            self.assertEqual(len(lines), 2, lines)
            for k, line in enumerate(lines):
                self.assertRegex(line, rf"^brunt: --set prescribed=.*: prescribed\.{k}: invalid constraint: node \d+ is also constrained in the same direction by fixed\.0")


if __name__ == "__main__":
    unittest.main()
