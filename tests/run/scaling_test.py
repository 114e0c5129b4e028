#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""scripts/scaling, strong and weak. Needs BRUNT, BRUNT_RUN (scripts/run) and BRUNT_CASES in the environment."""
import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest

SCRIPTS, CASES = os.path.dirname(os.environ["BRUNT_RUN"]), os.environ["BRUNT_CASES"]
sys.path.append(os.path.join(SCRIPTS, "lib"))
from weak_growth import factors_of  # noqa: E402

CORES = len(os.sched_getaffinity(0))
GROWTH = """
scaling:
  weak:
    - {counts: [mesh.*.box.elements.1], lengths: [mesh.*.box.size.1, mesh.*.box.at.1]}
    - {counts: [mesh.*.box.elements.2], lengths: [mesh.*.box.size.2, mesh.*.box.at.2]}
"""


class Scaling(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory()
        self.addCleanup(keeper.cleanup)
        self.folder = keeper.name

    def scaling(self, *options, growth=GROWTH):
        with open(f"{CASES}/bar_impact/scene.yaml", encoding="utf-8") as scene, \
             open(os.path.join(self.folder, "bars.yaml"), "w", encoding="utf-8") as copy:
            copy.write(scene.read() + growth)
        return subprocess.run([os.path.join(SCRIPTS, "scaling"), "bars.yaml", *options], cwd=self.folder,
                              capture_output=True, text=True, timeout=300, check=False)

    def table(self, *options, folder="bars.scaling.out"):
        done = self.scaling(*options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(os.path.getsize(os.path.join(self.folder, folder, "plot.png")), 10_000)
        with open(os.path.join(self.folder, folder, "table.csv"), encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def test_strong(self):
        one, together, other, many = self.table("-np", f"1,2,{CORES + 2}", "--at-once", "2", "--repeat", "2", "--set", "run.steps=6")
        self.assertEqual([(row["ranks"], row["runs_at_once"]) for row in (one, together, other, many)],
                         [("1", "1"), ("1", "2"), ("2", "1"), (str(CORES + 2), "1")])
        self.assertEqual({row["elements"] for row in (one, together, other, many)}, {"200"})
        self.assertEqual(float(one["efficiency"]), 1)
        if CORES > 1:
            self.assertAlmostEqual(float(other["speed-up"]), float(one["s_per_step"]) / float(other["s_per_step"]), delta=5e-3 * float(other["speed-up"]) + 1e-3)
            self.assertAlmostEqual(float(other["efficiency"]), float(other["speed-up"]) / 2, delta=1e-3)
            phases = sum(float(other[f"{phase}_s"]) for phase in ("element", "search", "enforcement", "halo", "other"))
            self.assertAlmostEqual(phases, float(other["s_per_step"]), delta=0.01 * phases)
        self.assertEqual((many["s_per_step"], many["efficiency"]), ("-", "-"))  # more ranks than cores
        self.assertEqual(len({row["state_hash"] for row in (one, together, other, many)}), 1)
        self.assertEqual((one["messages"], one["bytes"], one["neighbours"]), ("0", "0", "0"))
        self.assertGreater(float(other["messages"]), 0)
        self.assertGreater(float(many["neighbours"]), 0)
        self.assertGreater(float(one["memory_MB"]), 10)

    def test_what_a_rank_sends_is_what_the_partition_says(self):
        # messages of steps alone: an estimate of the assembled mesh sends some more
        free = ("--set", "contact=null", "--set", "probes=null", "--set", "run.step_bound=element")
        self.table("-np", "3", "--repeat", "1", "--set", "run.steps=6", *free)
        said = subprocess.run([os.environ["BRUNT"], "partition", "bars.yaml", "-n", "3", *free], cwd=self.folder,
                              capture_output=True, text=True, check=True).stdout
        forces, = (int(line.split()[3]) for line in said.splitlines() if line.startswith("corner forces sent"))
        with open(os.path.join(self.folder, "bars.scaling.out", "ranks_3", "summary.json"), encoding="utf-8") as stream:
            parallel = json.load(stream)["parallel"]
        self.assertGreater(forces, 0)
        self.assertAlmostEqual(3 * parallel["halo"]["bytes"]["mean"], 4 * 8 * forces)  # four doubles each
        self.assertAlmostEqual(parallel["halo"]["messages"]["mean"], parallel["neighbours"]["mean"])

    def test_weak(self):
        rows = self.table("--weak", "-np", "1,2,4", "--repeat", "1", "--set", "run.steps=6", "--set", "mesh.0.box.elements=[40, 1, 1]", folder="bars.weak.out")
        self.assertEqual([int(row["elements"]) for row in rows], [140, 280, 560])
        if CORES > 1:
            one, two = rows[:2]
            self.assertAlmostEqual(float(two["efficiency"]), float(one["s_per_step"]) / float(two["s_per_step"]), delta=5e-3)

    def test_growth_of_directions(self):
        self.assertEqual([factors_of(ranks, 3) for ranks in (1, 2, 8, 12, 64)], [[1, 1, 1], [2, 1, 1], [2, 2, 2], [3, 2, 2], [4, 4, 4]])
        self.assertEqual(factors_of(6, 1), [6])

    def assert_refused(self, phrase, *options, growth=GROWTH):
        done = self.scaling(*options, growth=growth)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertIn(phrase, done.stderr)

    def test_says_what_is_wrong(self):
        for options, phrase in ((("-np", "1,0"), "invalid number of ranks '0'"), (("-np", "2,2"), "given twice"),
                                (("--set", "steps"), "KEY.PATH=VALUE"), (("--fast",), "unknown option"),
                                (("--at-once", "-1"), "-1"), (("--weak", "--restart", "x"), "a checkpoint has one size"),
                                (("-np", "1", "--set", "run.stps=1"), "did you mean 'steps'")):
            with self.subTest(options=options):
                self.assert_refused(phrase, *options)

    def test_says_what_is_wrong_with_the_growth(self):
        self.assert_refused("scaling.weak: missing", "--weak", growth="")
        for growth, phrase in (("{counts: [mesh.7.box.elements.0]}", "scaling.weak.0.counts.0: unknown path 'mesh.7.box.elements.0'"),
                               ("{counts: [mesh.0.box.size.0]}", "scaling.weak.0.counts.0: invalid path 'mesh.0.box.size.0': not a number of elements"),
                               ("{counts: []}", "scaling.weak.0.counts: missing entries"),
                               ("{counts: [mesh.1.box.at.0]}", "invalid path 'mesh.1.box.at.0': not a number of elements"),
                               ("{count: [mesh.0.box.elements.0]}", "scaling.weak.0")):
            with self.subTest(growth=growth):
                self.assert_refused(phrase, "--weak", "-np", "1", growth=f"\nscaling: {{weak: [{growth}]}}\n")
                self.assert_refused("scaling.weak.0", "-np", "1", "--repeat", "1", growth=f"\nscaling: {{weak: [{growth}]}}\n")  # brunt itself
        self.assertFalse(os.path.exists(os.path.join(self.folder, "bars.weak.out")))


if __name__ == "__main__":
    unittest.main()
