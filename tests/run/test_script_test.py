#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What scripts/test starts: a copy of it in a folder of its own, with cmake and ctest that only note how they are called. Needs BRUNT_RUN in the environment."""
import os
import shutil
import subprocess
import tempfile
import unittest

SCRIPTS = os.path.dirname(os.environ["BRUNT_RUN"])
NOTE = '#!/bin/sh\necho "${0##*/} $*" >> "$CALLS"\n'


class TestScript(unittest.TestCase):
    def calls(self, *options):
        """How scripts/test with these options calls scripts/setup, cmake and ctest."""
        with tempfile.TemporaryDirectory() as folder:
            os.makedirs(os.path.join(folder, "scripts", "lib"))
            os.mkdir(os.path.join(folder, "bin"))
            for name in ("test", "lib/common.sh"):
                shutil.copy(os.path.join(SCRIPTS, name), os.path.join(folder, "scripts", name))
            for name in ("scripts/setup", "bin/cmake", "bin/ctest"):
                with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
                    stream.write(NOTE)
                os.chmod(os.path.join(folder, name), 0o755)
            noted = os.path.join(folder, "calls")
            environment = {**os.environ, "CALLS": noted, "PATH": os.path.join(folder, "bin") + os.pathsep + os.environ["PATH"]}
            done = subprocess.run([os.path.join(folder, "scripts", "test"), *options], env=environment, capture_output=True,
                                  text=True, timeout=60, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(noted, encoding="utf-8") as stream:
                return stream.read().splitlines()

    def test_tests_are_built_and_run(self):
        for options, preset in (((), "release"), (("--sanitize",), "asan"), (("--long", "-R", "unit"), "release")):
            with self.subTest(options=options):
                calls = self.calls(*options)
                self.assertEqual(calls[:2], ["setup ", f"cmake --preset {preset}"])
                self.assertTrue(calls[2].startswith(f"cmake --build --preset {preset} "), calls)
                self.assertTrue(calls[3].startswith("ctest "), calls)
                self.assertEqual(len(calls), 4)

    def test_a_list_builds_nothing(self):
        for options in (("-N",), ("--show-only",), ("--sanitize", "-N", "-R", "unit")):
            with self.subTest(options=options):
                calls = self.calls(*options)
                self.assertFalse([call for call in calls if "--build" in call], calls)
                self.assertTrue(calls[-1].startswith("ctest ") and options[-1] in calls[-1], calls)


if __name__ == "__main__":
    unittest.main()
