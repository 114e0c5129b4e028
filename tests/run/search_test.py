#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`brunt search` on 1, 2, 3, 4 and 8 ranks and by every method, against brute force. Needs BRUNT in the environment."""
import json
import math
import os
import random
import subprocess
import tempfile
import unittest

from run_test import of_all

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


SLABS = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1)]


def facet_scene(nodes, facets, distance):
    """Nodes, facets with their sides, and a distance. Some facets are triangles."""
    chance = random.Random(nodes)
    points = [spread(chance, 1.0) for _ in range(nodes)]
    corners = []
    for _ in range(facets):
        near = sorted(range(nodes), key=lambda i, at=spread(chance, 1.0): math.dist(points[i], at))[:4]
        corners.append((chance.randrange(2), near[:3] + [-1] if chance.random() < 0.3 else near))
    return points, corners, distance


def kdop_pairs(points, corners, distance):
    """Slave and master facets whose 18-DOPs overlap, in plain sums."""
    def interval(facet, slab):
        along = [sum(a * b for a, b in zip(slab, points[n])) for n in facet if n >= 0]
        margin = distance * math.sqrt(sum(a * a for a in slab))
        return min(along) - margin, max(along) + margin

    bounds = [[interval(facet, slab) for slab in SLABS] for _, facet in corners]
    return [(s, m) for s, (side, _) in enumerate(corners) if side == 0 for m, (other, _) in enumerate(corners)
            if other == 1 and all(a[0] <= b[1] and b[0] <= a[1] for a, b in zip(bounds[s], bounds[m]))]


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
            for ranks in of_all((1, 2, 3, 4, 8), (1, 4)):
                with self.subTest(kind=kind, ranks=ranks):
                    self.check(scene, ranks)

    def test_every_method(self):
        scene = scene_of("random", 300, 200)
        self.write(*scene)
        for method in ("blocks", "bucket", "binary", "kdop"):
            for ranks in (1, 3):
                with self.subTest(method=method, ranks=ranks):
                    self.assertEqual(self.check(scene, ranks, "--method", method)["method"], method)

    def write_facets(self, points, corners, distance):
        with open(self.file, "w", encoding="utf-8") as stream:
            print("facets1 test", len(points), len(corners), distance, file=stream)
            for point in points:
                print(*map(repr, point), file=stream)
            for side, nodes in corners:
                print(side, *nodes, file=stream)

    def test_pairs_of_facets_are_those_of_all_pairs_on_any_number_of_ranks(self):
        for nodes, facets, distance in ((200, 120, 0.0), (300, 200, 0.01), (40, 60, 0.1), (3, 0, 0.1), (0, 0, 0.0)):
            scene = facet_scene(nodes, facets, distance)
            expected = kdop_pairs(*scene)
            self.write_facets(*scene)
            self.assertTrue(expected or facets == 0)
            for ranks in of_all((1, 2, 3, 4), (1, 3)):
                with self.subTest(facets=facets, ranks=ranks):
                    *listed, result = self.search(ranks, "--list", "--method", "kdop")
                    self.assertEqual([tuple(map(int, line.split())) for line in listed], expected)
                    result = json.loads(result)
                    self.assertEqual((result["nodes"], result["faces"], result["ranks"]), (nodes, facets, ranks))
                    self.assertEqual(result["pairs"], len(expected))
                    self.assertEqual(int(result["pairs_hash"], 16), sum(pair_hash(*p) for p in expected) & WORD)
                    self.assertGreaterEqual(result["tests"], result["pairs"])

    def test_tests_of_two_tori_are_those_of_the_reference(self):
        points, corners = [], []  # reference-mortar.md M9: on each other, 2 x 800, d = 1
        for side, shift in ((0, (0, 0, 0)), (1, (6, 4, 46))):
            first = len(points)
            for i in range(40):
                for j in range(20):
                    u, w = math.tau * i / 40, math.tau * j / 20
                    x = ((76 + 24 * math.cos(w)) * math.cos(u), (76 + 24 * math.cos(w)) * math.sin(u), 24 * math.sin(w))
                    points.append([a + b for a, b in zip(x, shift)])
                    corners.append((side, [first + a % 40 * 20 + b % 20
                                           for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]))
        self.write_facets(points, corners, 1.0)
        for ranks in (1, 3):
            result = json.loads(self.search(ranks, "--method", "kdop", "--repeat", "2")[-1])
            self.assertEqual(result["pairs"], 820)
        self.write_facets(*(points, corners, 0.0))
        result = json.loads(self.search(1, "--method", "kdop")[-1])
        self.assertLess(result["tests"], 6711)

    def test_wrong_scenes_of_facets(self):
        good = ["facets1 test 3 1 0.5", "0 0 0", "1 0 0", "0 1 0", "0 0 1 2 -1"]
        for line, text, accepted in ((1, "facets1 test 3 1", "1: invalid scene of facets; expected facets1 NAME n m d"),
                                     (1, "facets1 test 3 1 -0.5", "a distance d >= 0"),
                                     (1, "facets1 test -3 1 0.5", "1: invalid scene of facets"),
                                     (3, "1 nan 0", "3: invalid line; expected three finite coordinates"),
                                     (5, "2 0 1 2 -1", "5: invalid line; expected side n0 n1 n2 n3"),
                                     (5, "0 0 1 2 3", "5: invalid line; expected node ids from 0 to n - 1"),
                                     (5, "0 0 1 -1 2", "5: invalid line; expected node ids from 0 to n - 1"),
                                     (5, "0 0 1 2", "5: invalid line; expected side n0 n1 n2 n3")):
            with self.subTest(text=text):
                lines = good[:line - 1] + [text] + good[line:]
                self.refused("\n".join(lines) + "\n", accepted, "--method", "kdop")
        self.refused("\n".join(good) + "\n", "1: invalid --method blocks for facets; expected --method kdop")
        self.refused("facets2 test 3 1 0.5\n", "invalid search scene", "--method", "kdop")
        self.refused("", "kdo not in", "--method", "kdo")

    def refused(self, text, says, *options):
        """One line, exit code 2."""
        with open(self.file, "w", encoding="utf-8") as stream:
            stream.write(text)
        done = subprocess.run([BRUNT, "search", self.file, *options], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn(says, done.stderr)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

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
