#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What a result folder goes through: restarts, limits, files that do not fit. Needs BRUNT and BRUNT_RUN (scripts/run)."""
import os
import subprocess
import time
import unittest

import plain_files
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

    def test_a_restart_with_another_mesh_is_refused(self):
        """The scene's text is the same, but not the file that it names."""
        nodes, cubes = plain_files.bar(4)
        moved = [(x, y, 1.5 * z) for x, y, z in nodes]
        turned = [cube[4:] + cube[:4] for cube in cubes]
        text = plain_files.SCENE.replace("FILE", "bar.msh").replace("BLOCK", "1").replace("steps: 2", "steps: 4")
        self.write("mesh.yaml", text + "initial: [{part: bar, velocity: [0, 0, 1e-3]}]\n")
        original = plain_files.msh2(nodes, cubes).decode()
        for name, other in (("moved", plain_files.msh2(moved, cubes)), ("more", plain_files.msh2(*plain_files.bar(5))),
                            ("order", plain_files.msh2(nodes, cubes[::-1])), ("inverted", plain_files.msh2([(x, y, -z) for x, y, z in nodes], turned))):
            self.write("bar.msh", original)
            self.run_scene(1, "mesh.yaml", "--out", name)
            hashed = self.summary(name)["state_hash"]
            self.write("bar.msh", other.decode())
            for ranks in (1, 2):
                done = subprocess.run([RUN, "-np", str(ranks), "mesh.yaml", "--out", name, "--restart", name, "--set", "run.steps=8"],
                                      cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE, check=False)
                self.assertEqual(done.returncode, 2, name + done.stderr + done.stdout)
                lines = done.stderr.splitlines()
                self.assertEqual(len(lines), 1, lines)
                self.assertRegex(lines[0], "checkpoint_000000004.h5: invalid for this mesh: .* expected unchanged mesh files, or a new run")
            self.write("bar.msh", plain_files.msh4(nodes, cubes).decode())  # the same mesh in another format
            self.run_scene(2, "mesh.yaml", "--out", name, "--restart", name, "--set", "run.steps=5")
            self.assertNotEqual(self.summary(name)["state_hash"], hashed)

    def test_a_request_to_stop_of_an_earlier_run_has_no_effect(self):
        every = ("--set", "run.steps=40")
        self.run_scene(1, "rod.yaml", "--out", "whole", *every)
        self.run_scene(1, "rod.yaml", "--out", "out", "--set", "run.steps=20")
        ahead = time.time() + 86400  # of another machine, whose clock is ahead
        for more in (["--force"], ["--restart", "out"]):
            self.write("out/stop", "")
            os.utime(os.path.join(self.folder, "out", "stop"), (ahead, ahead))
            self.run_scene(1, "rod.yaml", "--out", "out", *more, *(every if "--restart" in more else ("--set", "run.steps=20")))
            self.assertFalse(os.path.exists(os.path.join(self.folder, "out", "stop")))
            self.assertIn("removed out/stop, which is older than this run", self.text("out", "log.txt"))
        self.assertEqual(self.summary("out")["state_hash"], self.summary("whole")["state_hash"])
        self.assertEqual(self.summary("out")["stopped_by"], "steps")
        os.mkdir(os.path.join(self.folder, "new"))
        self.write("new/stop", "")
        self.run_scene(2, "rod.yaml", "--out", "new", *every)
        self.assertEqual(self.summary("new")["stopped_by"], "steps")

    def test_a_request_to_stop_during_the_run_stops_it(self):
        run = subprocess.Popen([RUN, "-np", "1", "rod.yaml", "--out", "out", "--quiet", "--set", "run.steps=100000000", "--set", "run.end=1e9"], cwd=self.folder)
        try:
            self.wait_for("out", "history.csv")
            self.write("out/stop", "")
            self.assertEqual(run.wait(timeout=PATIENCE), 5)
        finally:
            run.kill()
            run.wait()
        self.assertEqual(self.summary("out")["stopped_by"], "control")
        self.assertFalse(os.path.exists(os.path.join(self.folder, "out", "stop")))

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
