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

    def test_a_history_of_other_columns_is_refused_on_all_ranks(self):
        self.run_scene(1, "rod.yaml", "--out", "out", "--set", "run.steps=6")
        self.write("out/history.csv", self.text("out", "history.csv").replace("kinetic", "kinetisch"))
        for ranks in (1, 2, 3):
            lines = self.faults(ranks, "--restart", "out")
            self.assertEqual(len(lines), 1, lines)
            self.assertIn("history.csv:1: the columns differ", lines[0])

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
                self.assertRegex(line, rf"^brunt: --set prescribed=.*: prescribed\.{k}: node \d+ is in fixed\.0 too")


if __name__ == "__main__":
    unittest.main()
