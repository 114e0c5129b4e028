#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The scaling model of tests/bench/scaling: closed forms, and the counts that stand beside it. Runs nothing."""
import math
import os
import sys
import unittest

BENCH = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "bench", "scaling")
sys.path.append(BENCH)
import model  # noqa: E402
import prediction  # noqa: E402
import tables  # noqa: E402


class Model(unittest.TestCase):
    def test_counts_that_stand_beside_it_are_met(self):
        rows = tables.read(os.path.join(BENCH, tables.COUNTED))
        text, missed = tables.check(rows)
        self.assertGreaterEqual(text.count("\n"), 20)
        self.assertEqual(missed, 0, text)  # 10 % without contact, 25 % with

    def test_a_miss_is_seen(self):
        rows = tables.read(os.path.join(BENCH, tables.COUNTED))
        row = next(row for row in rows if row["scene"] == "blocks without contact" and row["ranks"] == "8")
        text, missed = tables.check([{**row, "bytes": str(1.2 * float(row["bytes"]))}])
        self.assertEqual(missed, 1)
        self.assertIn("(!)", text)

    def test_a_cube_in_cubes(self):
        """27 parts of 30^3 elements: but for METIS's excess, what a grid of boxes sends, node by node."""
        forces, neighbours = model.internal(model.Scene([(30, 30, 30)], [], False, model.Work()), 27)
        holders = [2 if i in (10, 20) else 1 for i in range(31)]
        elements = [1 if i in (0, 30) else 2 for i in range(31)]  # at a node, along each direction
        grid = (sum(h * e for h, e in zip(holders, elements)) ** 3) - sum(elements) ** 3
        self.assertAlmostEqual(forces / model.of("partition")["excess"], grid, delta=1e-6 * grid)
        self.assertAlmostEqual(neighbours, (1 + model.of("partition")["neighbours"] * 2 / 3) ** 3 - 1)

    def test_thin_bodies_are_cut_into_plates_and_rods(self):
        self.assertEqual(model.divisions((100, 100, 1), 100), [10, 10, 1])
        self.assertEqual(model.divisions((1000, 2, 2), 400), [10, 1, 1])
        for cuts in (model.divisions((40, 30, 20), 3000), model.divisions((90, 20, 5), 700)):
            self.assertGreaterEqual(min(cuts), 1)

    def test_sides_of_boxes_that_touch(self):
        boxes = {"mesh": [{"box": {"size": [1, 1, 1], "elements": [4, 4, 4]}}, {"box": {"size": [2, 1, 1], "elements": [6, 3, 3], "at": [0, 0, 1]}},
                          {"box": {"size": [1, 1, 1], "elements": [2, 2, 2], "at": [5, 0, 0]}}]}
        scene = model.box_scene(boxes, model.Work())
        self.assertEqual(sorted(scene.sides), [(4, 4), (5, 5)])  # the unit square: 3 x 3 of the upper one's elements, 4 x 4 of the lower's
        self.assertEqual(model.box_scene(boxes, model.Work(), with_contact=False).sides, [])

    def test_one_rank_sends_nothing_and_is_efficient(self):
        for with_contact in (False, True):
            for name, line in prediction.series(with_contact).items():
                shares = [share for _, _, share in line]
                self.assertEqual(shares[0], 1, name)
                self.assertTrue(all(0 < share <= 1 for share in shares), name)
                if "strong" in name:
                    self.assertEqual(shares, sorted(shares, reverse=True), name)
        sent = model.counts(prediction.blocks(1e6, True), 1)
        self.assertEqual((sent.messages, sent.bytes), (0, 0))

    def test_constants_of_a_measurement(self):
        rows = [{"scene": "blocks without contact", "ranks": "1", "runs_at_once": "1", "elements": "1000", "element_s": "4e-5", "halo_s": "0", "other_s": "1e-5"},
                {"scene": "blocks", "ranks": "1", "runs_at_once": "1", "rows": "100", "iterations": "5", "searches": "0.1", "enforcement_s": "1e-4", "search_s": "0"}]
        found = prediction.measured(rows)
        self.assertAlmostEqual(found["element"], 50e-9)
        self.assertAlmostEqual(found["row"], 200e-9)
        self.assertEqual(prediction.measured(rows[:1]), {})
        self.assertTrue(math.isclose(found["iterations"], 5))


if __name__ == "__main__":
    unittest.main()
