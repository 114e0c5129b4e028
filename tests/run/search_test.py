#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`brunt search` on 1, 2, 3, 4 and 8 ranks and by every method, against brute force. Needs BRUNT in the environment."""
import json
import os
import random
import subprocess
import tempfile
import unittest

BRUNT = os.environ["BRUNT"]
WORD = 2**64 - 1


def pair_hash(face, node):
    """As the contract gives it."""
    z = ((face << 32) + node) * 0x9E3779B97F4A7C15 & WORD
    z ^= z >> 29
    z = z * 0xBF58476D1CE4E5B9 & WORD
    return z ^ (z >> 32)


def spread(chance, scale):
    return [chance.uniform(0, scale) for _ in range(3)]


def scene_of(kind, nodes, faces):
    """Nodes, boxes and the nodes of each face."""
    chance = random.Random(kind)
    points = [spread(chance, 1.0) for _ in range(nodes)]
    if kind == "plane":
        points = [[x, y, 0.5] for x, y, _ in points]
    if kind == "one place":
        points = [list(points[0]) if i % 3 else p for i, p in enumerate(points)]
    if kind == "outliers":
        points = [[1e9 * c for c in p] if i % 50 == 0 else p for i, p in enumerate(points)]
    boxes, own = [], []
    for f in range(faces):
        size = 0.1 if kind != "graded" else 10 ** chance.uniform(-4, -1)
        low = chance.choice(points) if f % 2 else spread(chance, 1.0)
        boxes.append((low, [c + chance.uniform(0, size) for c in low]))
        own.append([chance.randrange(nodes), chance.randrange(nodes), -1, -1])
    return points, boxes, own


def brute_force(points, boxes, own):
    return [(f, n) for f, (low, high) in enumerate(boxes) for n, p in enumerate(points)
            if n not in own[f] and all(a <= c <= b for a, c, b in zip(low, p, high))]


class Search(unittest.TestCase):
    def setUp(self):
        self.keeper = tempfile.TemporaryDirectory()
        self.addCleanup(self.keeper.cleanup)
        self.file = os.path.join(self.keeper.name, "scene.txt")

    def write(self, points, boxes, own):
        with open(self.file, "w", encoding="utf-8") as stream:
            print("scene1 test", len(points), len(boxes), file=stream)
            for point in points:
                print(*map(repr, point), file=stream)
            for (low, high), nodes in zip(boxes, own):
                print(*map(repr, low), *map(repr, high), *nodes, file=stream)

    def search(self, ranks, *options):
        done = subprocess.run(["mpirun", "-np", str(ranks), BRUNT, "search", self.file, *options], capture_output=True,
                              text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.splitlines()

    def check(self, scene, ranks, *options):
        expected = brute_force(*scene)
        *listed, result = self.search(ranks, "--list", *options)
        self.assertEqual([tuple(map(int, line.split())) for line in listed], sorted(expected))
        result = json.loads(result)
        self.assertEqual(result["ranks"], ranks)
        self.assertEqual(result["pairs"], len(expected))
        self.assertEqual(int(result["pairs_hash"], 16), sum(pair_hash(f, n) for f, n in expected) & WORD)
        return result

    def test_pairs_are_those_of_brute_force_on_any_number_of_ranks(self):
        for kind in ("random", "plane", "one place", "outliers", "graded"):
            scene = scene_of(kind, 300, 200)
            self.write(*scene)
            for ranks in (1, 2, 3, 4, 8):
                with self.subTest(kind=kind, ranks=ranks):
                    self.check(scene, ranks)

    def test_every_method(self):
        scene = scene_of("random", 300, 200)
        self.write(*scene)
        for method in ("blocks", "bucket", "binary"):
            for ranks in (1, 3):
                with self.subTest(method=method, ranks=ranks):
                    self.assertEqual(self.check(scene, ranks, "--method", method)["method"], method)

    def test_ranks_with_nothing(self):
        points, boxes, own = scene_of("random", 3, 2)
        self.write(points, boxes, own)
        self.check((points, boxes, own), 8)
        self.write([], [], [])
        self.check(([], [], []), 4)

    def test_what_is_far_is_not_sent(self):
        points = [[float(i), 0.0, 0.0] for i in range(100)]
        boxes = [([i - 0.25, -1.0, -1.0], [i + 0.25, 1.0, 1.0]) for i in range(100)]
        own = [[-1] * 4 for _ in boxes]
        self.write(points, boxes, own)
        result = self.check((points, boxes, own), 4)
        self.assertLess(result["most_ghosts"], 10)


if __name__ == "__main__":
    unittest.main()
