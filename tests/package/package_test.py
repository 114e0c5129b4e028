#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A program outside of the tree, built against the installed package, on one to three ranks. Needs BRUNT_BUILD (the build folder) and
BRUNT_CASES in the environment."""
import json
import os
import subprocess
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))


def call(*words, **more):
    done = subprocess.run(words, capture_output=True, text=True, timeout=500, check=False, **more)
    assert done.returncode == 0, f"{' '.join(words)}\n{done.stdout}{done.stderr}"
    return done.stdout


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory()
        cls.folder = cls.keeper.name
        cls.prefix, built = os.path.join(cls.folder, "prefix"), os.path.join(cls.folder, "built")
        call("cmake", "--install", os.environ["BRUNT_BUILD"], "--prefix", cls.prefix)
        call("cmake", "-S", os.path.join(HERE, "outside"), "-B", built, f"-DCMAKE_PREFIX_PATH={cls.prefix}")
        call("cmake", "--build", built)
        cls.program = os.path.join(built, "outside")

    @classmethod
    def tearDownClass(cls):
        cls.keeper.cleanup()

    def figures(self, ranks):
        """Values by name; a name that repeats has them in a list."""
        scene = os.path.join(os.environ["BRUNT_CASES"], "two_blocks", "scene.yaml")
        told = call("mpirun", "-np", str(ranks), self.program, scene, os.path.join(self.folder, f"o{ranks}"), cwd=self.folder)
        figures = {}
        for line in told.splitlines():
            words = line.split()
            if len(words) == 2 and words[0].split("_")[0] in ("search", "depth", "contact", "run"):
                figures.setdefault(words[0], []).append(float(words[1]))
        return figures

    def test_what_another_program_gets(self):
        states, contacts = set(), set()
        for ranks in (1, 2, 3):
            with self.subTest(ranks=ranks):
                f = self.figures(ranks)
                self.assertEqual(f["search_right"], [1, 1, 1])
                self.assertEqual(f["search_odd"], [1])
                self.assertAlmostEqual(f["depth"][0], 0.1, delta=1e-6)
                self.assertGreaterEqual(f["depth_moved"][0], 1)
                self.assertGreater(f["depth_bound"][0], 0.09)
                self.assertEqual(f["depth_refused"], [1])
                # eight masses of .25 at speed -1 on eight at rest: momentum -2 is kept, what one gets the other gives
                self.assertAlmostEqual(f["contact_momentum"][0], -2, delta=1e-12)
                self.assertAlmostEqual(f["contact_impulses"][0], 0, delta=1e-12)
                # of the four nodes on each side of the seam, free mass points: 4 * .25 * 1/2
                self.assertAlmostEqual(f["contact_impulse"][0], 0.5, delta=1e-3)
                self.assertAlmostEqual(f["contact_slowest"][0], -0.5, delta=1e-3)
                self.assertAlmostEqual(f["contact_fastest"][0], -0.5, delta=1e-3)
                self.assertGreater(f["contact_active"][0], 0)
                self.assertEqual(f["contact_refused"], [1])
                self.assertEqual(f["run"], [0])
                self.assertEqual(f["run_wrong"], [2])
                contacts.add((*f["contact_slowest"], *f["contact_fastest"]))
                with open(os.path.join(self.folder, f"o{ranks}", "summary.json"), encoding="utf-8") as stream:
                    states.add(json.load(stream)["state_hash"])
        self.assertEqual(len(states), 1)
        self.assertEqual(len(contacts), 1)

    def test_what_is_installed(self):
        """The program, the headers of include/brunt, and none of the rooms' own."""
        headers = sorted(os.listdir(os.path.join(self.prefix, "include", "brunt")))
        self.assertEqual(headers, ["contact_step.hpp", "penetration_depth.hpp", "run.hpp", "search.hpp", "session.hpp"])
        self.assertEqual(os.listdir(os.path.join(self.prefix, "include")), ["brunt"])
        self.assertTrue(os.path.isfile(os.path.join(self.prefix, "share", "brunt", "scene.schema.json")))
        self.assertIn("brunt", call(os.path.join(self.prefix, "bin", "brunt"), "--help"))


if __name__ == "__main__":
    unittest.main()
