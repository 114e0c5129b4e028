#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""brunt depth on several ranks: files of poses, sequences, certificates, limits, killed runs, names with commas."""
import csv
import json
import os
import random
import subprocess
import unittest

from run_test import PATIENCE, RUN, Program

NAME = 'bar, 5" long.obj'  # what a table has to quote
L = [(0, 0), (2, 0), (2, .6), (.6, .6), (.6, 2), (0, 2)]
BAR = [(-.5, -.2), (.5, -.2), (.5, .2), (-.5, .2)]


def prism(polygon, low, high):
    """OBJ of a polygon, seen counter-clockwise, from z = low to high."""
    n = len(polygon)
    lines = [f"v {x} {y} {z}" for z in (low, high) for x, y in polygon]
    faces = [range(n, 0, -1), range(n + 1, 2 * n + 1)]
    faces += [(i + 1, (i + 1) % n + 1, n + (i + 1) % n + 1, n + i + 1) for i in range(n)]
    return "\n".join(lines + ["f " + " ".join(map(str, face)) for face in faces]) + "\n"


def poses(count):
    """A bar that goes and turns through the L, and beyond it."""
    steps = random.Random(7)
    rows = ["x,y,z,axis_x,axis_y,axis_z,degrees"]
    for k in range(count):
        s = k / count
        rows.append(f"{.3 + 3.4 * s},{.4 + .2 * steps.random()},{.1 * s},{1},{2},{3},{90 * s}")
    return "\n".join(rows) + "\n"


class Depth(Program):
    def setUp(self):
        super().setUp()
        self.write(NAME, prism(BAR, -.3, .3))
        self.write("l.obj", prism(L, -.5, .5))

    def ask(self, ranks, out, *words, code=0):
        done = subprocess.run([RUN, "-np", str(ranks), "depth", NAME, "l.obj", "--out", out, *words], cwd=self.folder,
                              capture_output=True, text=True, timeout=4 * PATIENCE)
        self.assertEqual(done.returncode, code, done.stderr + done.stdout)
        return done.stderr

    def depth(self, ranks, out, *words):
        """Rows of depth.csv without their time."""
        self.ask(ranks, out, *words)
        return self.rows(out)

    def rows(self, out):
        with open(os.path.join(self.folder, out, "depth.csv"), encoding="utf-8", newline="") as stream:
            rows = list(csv.DictReader(stream))
        for row in rows:
            self.assertNotIn(None, row)  # more fields than columns
            self.assertGreaterEqual(float(row.pop("time_ms")), 0)
        return rows

    def answers(self, out):
        with open(os.path.join(self.folder, out, "depth.json"), encoding="utf-8") as stream:
            return json.load(stream)["answers"]

    def assert_same_on_ranks(self, *words):
        one = self.depth(1, "np1", *words)
        for ranks in (2, 3):
            self.assertEqual(self.depth(ranks, f"np{ranks}", *words), one, f"on {ranks} ranks")
        return one

    def test_poses_are_the_same_bits_on_any_number_of_ranks(self):
        self.write("poses.csv", poses(24))
        rows = self.assert_same_on_ranks("--poses", "poses.csv", "--metric", "translation", "--metric", "object_norm")
        self.assertEqual([row["pose"] for row in rows], [str(k) for k in range(24) for _ in range(2)])
        self.assertEqual({row["a"] for row in rows}, {NAME})
        self.assertEqual({row["overlap"] for row in rows}, {"0", "1"}, "some poses overlap and some do not")
        for translation, norm in zip(rows[::2], rows[1::2]):
            self.assertLessEqual(float(norm["depth"]), float(translation["depth"]) * (1 + 1e-6))

    def test_sequences_are_the_same_bits_on_any_number_of_ranks(self):
        self.write("poses.csv", poses(70))  # three chains
        rows = self.assert_same_on_ranks("--poses", "poses.csv", "--sequence")
        self.write("again.csv", poses(70))
        alone = self.depth(1, "alone", "--poses", "again.csv")
        # until the final contact walks keep a clearance of 1e-6 of A's radius, which is above 1: no finer ranking of two
        longer = [row["pose"] for row, other in zip(rows, alone) if float(row["depth"]) > float(other["depth"]) + 5e-6]
        self.assertEqual(longer, [], "a start from the pose before comes on top of all others")
        self.assertTrue(any(int(row["walks"]) > int(other["walks"]) for row, other in zip(rows, alone)))

    def test_samples_are_the_same_bits_on_any_number_of_ranks(self):
        self.write("poses.csv", poses(24))
        rows = self.assert_same_on_ranks("--poses", "poses.csv", "--metric", "displacement", "--samples", "200")
        self.write("again.csv", poses(24))
        alone = self.depth(1, "alone", "--poses", "again.csv")
        longer = [row["pose"] for row, other in zip(rows, alone) if float(row["depth"]) > float(other["depth"]) + 5e-6]
        self.assertEqual(longer, [], "starts from samples come on top of all others")
        overlapping = [(int(row["walks"]), int(other["walks"])) for row, other in zip(rows, alone) if row["overlap"] == "1"]
        self.assertTrue(all(with_samples > without for with_samples, without in overlapping), overlapping)
        self.assertIn("--poses", self.ask(1, "none", "--at", "0.5,0.4,0.1", "--samples", "200", code=2))

    def test_certificates_are_the_same_bits_on_any_number_of_ranks(self):
        self.write("poses.csv", poses(2))
        self.write("pieces.yaml", json.dumps({"b": [[[x, y, z] for x in (0, w) for y in (0, h) for z in (-.5, .5)]
                                                    for w, h in ((2, .6), (.6, 2))]}))
        words = "--poses", "poses.csv", "--metric", "translation", "--pieces", "pieces.yaml"
        rows = self.assert_same_on_ranks(*words, "--certify", "0.05")
        plain = self.depth(1, "plain", *words)
        for row, without in zip(rows, plain):
            self.assertGreaterEqual(float(row["bound"]), 0.95 * float(row["depth"]))
            self.assertLessEqual(float(row["bound"]), float(row["depth"]))
            self.assertGreaterEqual(float(row["bound"]), float(without["bound"]))
            self.assertLessEqual(float(row["depth"]), float(without["depth"]))

    def test_a_limit_ends_a_certificate_on_all_ranks(self):
        for ranks in (1, 3):
            row, = self.depth(ranks, f"limit{ranks}", "--at", "0.5,0.4,0.1", "--metric", "object_norm", "--certify", "1e-6",
                              "--boxes", "1000000000", "--limit", "1s")
            self.assertGreater(float(row["bound"]), 0)
            self.assertLessEqual(float(row["bound"]), float(row["depth"]))

    def test_a_run_that_was_killed_goes_on_and_tells_all_rows(self):
        self.write("poses.csv", poses(8))
        words = "--poses", "poses.csv", "--metric", "displacement", "--metric", "translation"
        whole = self.depth(1, "whole", *words)
        self.assertEqual(self.depth(2, "part", *words), whole)
        os.remove(os.path.join(self.folder, "part", "depth.json"))
        table = self.text("part", "depth.csv")
        for name in os.listdir(os.path.join(self.folder, "part")):
            if name.endswith(".ply"):
                os.remove(os.path.join(self.folder, "part", name))
        self.write("part/depth.csv", table[: int(0.6 * len(table))])
        self.assertEqual(self.depth(2, "part", *words), whole)
        one, other = self.answers("whole"), self.answers("part")
        self.assertEqual(len(other), 16)
        for row, again in zip(one, other):
            for answer in (row, again):
                answer.pop("time_s")
                answer.pop("contacts", None)  # the table holds their number only
                placement = answer.pop("placement", None)
                self.assertEqual(placement is None, not answer["overlap"])
            self.assertEqual(row, again)
        surfaces = [sorted(n for n in os.listdir(os.path.join(self.folder, out)) if n.endswith(".ply")) for out in ("whole", "part")]
        self.assertEqual(surfaces[0], surfaces[1])

    def test_a_table_that_is_none_of_ours_is_refused(self):
        self.depth(1, "out", "--at", "0.5,0.4,0.1")
        os.remove(os.path.join(self.folder, "out", "depth.json"))
        for row, said in (("1,2,3", "3 fields"), (",".join(["x"] * 31), "'x'")):
            self.write("out/depth.csv", self.text("out", "depth.csv").splitlines()[0] + "\n" + row + "\n")
            errors = self.ask(1, "out", "--at", "0.5,0.4,0.1", code=2)
            self.assertIn("depth.csv", errors)
            self.assertIn(said, errors)


if __name__ == "__main__":
    unittest.main()
