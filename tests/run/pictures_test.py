#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""scripts/render and scripts/plot on a result: what they draw, and one line and exit code 2 where they cannot. Needs BRUNT and
BRUNT_RUN (scripts/run) in the environment."""
import os
import subprocess
import unittest

import scenes
from run_test import PATIENCE, RUN, Program

SCRIPTS = os.path.dirname(RUN)


class Pictures(Program):
    def setUp(self):
        super().setUp()
        self.write("rod.yaml", scenes.ROD)
        self.run_scene(1, "rod.yaml", "--out", "out", "--set", "output.every=1e-5", "--set",
                       "output.fields=[displacement, velocity, gap]")
        self.before = sorted(os.listdir(os.path.join(self.folder, "out")))

    def script(self, name, *arguments):
        return subprocess.run([os.path.join(SCRIPTS, name), *arguments], cwd=self.folder, capture_output=True, text=True,
                              timeout=PATIENCE, check=False)

    def assert_refused(self, phrases, name, *arguments):
        done = self.script(name, *arguments)
        self.assertEqual(done.returncode, 2, done.stderr + done.stdout)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for phrase in (f"{name}: ", "accepted", *phrases):
            self.assertIn(phrase, done.stderr)
        self.assertEqual(sorted(os.listdir(os.path.join(self.folder, "out"))), self.before)

    def test_pictures_where_none_can_be(self):
        for name in ("render", "plot"):
            self.assert_refused(["nodir/x.png", "no folder"], name, "out", "-o", "nodir/x.png")
            self.assert_refused(["out: is a folder"], name, "out", "-o", "out")
            done = self.script(name, "out", "-o", "x.fooo")
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1), done.stderr)

    def test_times_and_fields_that_are_not_there(self):
        self.assert_refused(["--time 99", "from 0 to 0.0001"], "render", "out", "--time", "99")
        self.assert_refused(["--time -1"], "render", "out", "--time", "-1")
        self.assert_refused(["no field velocty", "velocity"], "render", "out", "--field", "velocty")
        self.assert_refused(["no component w"], "render", "out", "--field", "velocity.w")
        self.assert_refused(["without a component"], "render", "out", "--field", "gap.x")

    def test_pictures_are_drawn(self):
        end = self.summary("out")["end_time"]
        for name, *options in (("render",), ("render", "--time", "0"), ("render", "--time", str(end)), ("plot",)):
            done = self.script(name, "out", "-o", "x.png", *options)
            self.assertEqual((done.returncode, done.stdout), (0, "x.png\n"), done.stderr)
            self.assertGreater(os.path.getsize(os.path.join(self.folder, "x.png")), 10_000)
            os.remove(os.path.join(self.folder, "x.png"))


if __name__ == "__main__":
    unittest.main()
