#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Hard cases have the same bits on one and three ranks. Their criteria are held in tests/hard.

Needs BRUNT_RUN (scripts/run) in the environment."""
import csv
import json
import os
import subprocess
import tempfile
import unittest

import hard_scenes as scenes

RUN = os.environ["BRUNT_RUN"]
PATIENCE = 120  # s


class HardCases(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory()
        self.addCleanup(keeper.cleanup)
        self.folder = keeper.name

    def rows(self, out):
        with open(os.path.join(self.folder, out, "history.csv"), encoding="utf-8") as stream:
            return [{head.split("[")[0].strip(): value for head, value in row.items()} for row in csv.DictReader(stream)]

    def same_bits(self, scene):
        """Runs on one and three ranks; rows of the history, which show that something touches."""
        with open(os.path.join(self.folder, "scene.yaml"), "w", encoding="utf-8") as stream:
            stream.write(scene)
        hashes = []
        for ranks in (1, 3):
            done = subprocess.run([RUN, "-np", str(ranks), "scene.yaml", "--out", f"r{ranks}", "--force", "--quiet"],
                                  cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(os.path.join(self.folder, f"r{ranks}", "summary.json"), encoding="utf-8") as stream:
                summary = json.load(stream)
            self.assertEqual(summary["ranks"], ranks)
            hashes.append(summary["state_hash"])
        self.assertEqual(hashes[0], hashes[1])
        rows = self.rows("r1")
        self.assertEqual(rows, self.rows("r3"))
        touching = sum(float(row["active_contacts"]) > 0 for row in rows)
        self.assertGreater(touching, 3, "nothing touches: the test proves nothing")
        return rows

    def test_every_search_finds_the_same(self):
        """Not a key of the restart's fingerprint either, since results do not depend on it."""
        hashes = {}
        for method in ("auto", "blocks", "binary", "bucket"):
            with open(os.path.join(self.folder, "scene.yaml"), "w", encoding="utf-8") as stream:
                stream.write(scenes.ON_PLATE)
            for ranks in (1, 3):
                done = subprocess.run([RUN, "-np", str(ranks), "scene.yaml", "--set", f"search.method={method}", "--out", "o", "--force", "--quiet"],
                                      cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE)
                self.assertEqual(done.returncode, 0, done.stderr)
                with open(os.path.join(self.folder, "o", "summary.json"), encoding="utf-8") as stream:
                    hashes[method, ranks] = json.load(stream)["state_hash"]
            self.assertGreater(float(self.rows("o")[-1]["active_contacts"]), 15)
        self.assertEqual(len(set(hashes.values())), 1, hashes)

    def test_masses_a_million_apart(self):
        for name, scene in (("densities 1 and 1e6", scenes.BY_DENSITY), ("sides 1 m and 1 cm", scenes.BY_SIZE)):
            with self.subTest(name):
                self.assertEqual(float(self.same_bits(scene)[-1]["active_contacts"]), 0)  # met and parted

    def test_sticking_under_a_load_that_swings(self):
        for name, scene in (("on a wall", scenes.ON_WALL), ("on a plate", scenes.ON_PLATE)):
            with self.subTest(name):
                rows = self.same_bits(scene)
                places = [float(row["block.x"]) for row in rows]
                self.assertGreater(max(places) - min(places), 1e-6)  # to and fro
                self.assertGreater(float(rows[-1]["active_contacts"]), 15)

    def test_far_from_the_origin(self):
        for name, scene in (("an impact", scenes.FAR_IMPACT), ("blocks pressed together", scenes.FAR_PRESS)):
            with self.subTest(name):
                self.same_bits(scene)

    def test_vertices_and_edges_that_meet(self):
        for name, scene in (("vertex on vertex", scenes.CORNERS), ("edge on edge", scenes.CROSSED)):
            with self.subTest(name):
                self.same_bits(scene)

    def test_overlaps_and_gaps_at_rounding(self):
        for name, scene in (("a tenth of an element inside", scenes.OVERLAPPING), ("flush", scenes.FLUSH)):
            with self.subTest(name):
                self.same_bits(scene)

    def test_meshes_of_unlike_sizes(self):
        for name, scene in (("1 : 100", scenes.HUNDREDTH), ("a small block slides over facets", scenes.FACETS)):
            with self.subTest(name):
                self.same_bits(scene)

    def test_a_tied_pair_that_spins(self):
        self.same_bits(scenes.TIED_SPIN)


if __name__ == "__main__":
    unittest.main()
