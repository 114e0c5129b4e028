#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Scenes of the cases, stopped on two ranks and continued on three, are the run on one rank that never stopped.

usage: restart_test.py [--all] [--whole] [--scene WORD]
    --all: all scenes of each case, with more steps, not just as many as have together what the first of each case have
    --whole: scenes to their end, stopped in the middle of contact and again shortly before it ends
    --scene: only those with the word in CASE/FILE
Needs BRUNT, BRUNT_RUN (scripts/run) and BRUNT_CASES (the folder cases/) in the environment.
"""
import argparse
import csv
import glob
import json
import os
import subprocess
import sys
import tempfile
import unittest

import yaml

from scene_features import covering, features

BRUNT, RUN, CASES = os.environ["BRUNT"], os.environ["BRUNT_RUN"], os.environ["BRUNT_CASES"]
STEPS = 450  # of a run in short, with --all: nearly all cases have met their wall or each other by then
FEW_STEPS = 110  # the same without --all
IMPLICIT_STEPS = 8  # the same of implicit scenes, whose steps are some hundred times as long and cost as much more
MOST_STEPS = 3600  # of those that have not
PATIENCE = 600  # [s] for one run


def scenes():
    """The scenes of all cases by name, CASE/FILE; other YAML files (studies) have no `run`."""
    found = {}
    for path in sorted(glob.glob(os.path.join(CASES, "*", "*.yaml"))):
        with open(path, encoding="utf-8") as stream:
            tree = yaml.safe_load(stream)
        scene = os.path.relpath(path, CASES)
        if isinstance(tree, dict) and "run" in tree and WORD in scene:
            found[scene] = tree
    if ALL:
        return found
    first = {}
    for scene in sorted(found, key=lambda name: (not name.endswith("/scene.yaml"), name)):
        first.setdefault(os.path.dirname(scene), scene)
    return {scene: found[scene] for scene in covering({scene: found[scene] for scene in first.values()})}


def meets(tree):
    """Is something to touch in this scene? Not where parts are placed apart at the start, with nothing that moves them."""
    entries = tree.get("contact", [])
    placed = any(isinstance(entry, dict) and entry.get("initial_overlap") == "place" for entry in entries)
    return bool(entries or "rigid_walls" in tree) and not (placed and "initial" not in tree)


class Features(unittest.TestCase):
    def test_names_and_numbers_are_none(self):
        scene = {"parts": {"ball": {"element": "tet4"}}, "mesh": [{"box": {"at": [0, 0, 0]}}], "probes": [{"part": "ball"}],
                 "contact": [{"between": ["ball", "plate"], "friction": 0.2, "passes": "two"}]}
        self.assertEqual(features(scene), {"parts", "parts.*", "parts.*.element", "parts.*.element=tet4", "mesh", "mesh.box",
                                           "contact", "contact.between", "contact.friction", "contact.passes",
                                           "contact.passes=two"})

    def test_few_scenes_have_all(self):
        scenes = {"a": {"contact": "all"}, "b": {"contact": "all", "gravity": 1, "damping": 2}, "c": {"fixed": 1}}
        self.assertEqual(covering(scenes), ["b", "c"])


class Restart(unittest.TestCase):
    def setUp(self):
        self.keeper = tempfile.TemporaryDirectory()
        self.addCleanup(self.keeper.cleanup)

    def run_scene(self, ranks, scene, out, steps, *options):
        command = [RUN, "-np", str(ranks), os.path.join(CASES, scene), "--out", self.path(out), "--quiet", *options]
        command += ["--set", f"run.steps={steps}"] if steps else []
        done = subprocess.run(command, cwd=self.keeper.name, capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)

    def path(self, *names):
        return os.path.join(self.keeper.name, *names)

    def summary(self, out):
        with open(self.path(out, "summary.json"), encoding="utf-8") as stream:
            return json.load(stream)

    def rows(self, out):
        with open(self.path(out, "history.csv"), encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def touching(self, out):
        """Steps of the history in which something touches."""
        return [int(row["step"]) for row in self.rows(out) if float(row["active_contacts"]) > 0]

    def run_whole(self, scene, tree, whole):
        """On one rank, in short as many steps as it takes until something touches, and as many again."""
        limit = None if WHOLE else IMPLICIT_STEPS if tree.get("solver", "explicit") != "explicit" else STEPS if ALL else FEW_STEPS
        self.run_scene(1, scene, whole, limit)
        while limit and limit < MOST_STEPS and meets(tree) and not self.touching(whole):
            limit *= 2
            self.run_scene(1, scene, whole, limit, "--force")
        return limit

    def stops(self, tree, whole, shares):
        """Steps to stop at: shares of those in which something touches, so that contact is part of what is continued."""
        rows, touching = self.rows(whole), self.touching(whole)
        if meets(tree):
            self.assertTrue(touching, "nothing touches: the test would prove nothing about contact")
        steps = touching or [int(row["step"]) for row in rows]
        return {max(1, steps[int(share * len(steps))]) for share in shares}

    def assert_continued(self, scene, steps, whole, stop):
        part = f"{whole}_{stop}"
        self.run_scene(2, scene, part, stop)
        self.assertEqual(self.summary(part)["steps"], stop)
        self.run_scene(3, scene, part, steps, "--restart", self.path(part))
        self.assertEqual(self.summary(part)["state_hash"], self.summary(whole)["state_hash"])
        self.assertEqual(self.rows(part), self.rows(whole))
        compared = subprocess.run([BRUNT, "compare", "--tol", "0", self.path(whole), self.path(part)], capture_output=True,
                                  text=True, timeout=PATIENCE)
        self.assertEqual(compared.returncode, 0, compared.stdout + compared.stderr)

    def test_all_cases(self):
        found = scenes()
        self.assertTrue(found, f"no scene in {CASES}")
        for scene, tree in found.items():
            with self.subTest(scene=scene):
                whole = scene.replace("/", "_")
                limit = self.run_whole(scene, tree, whole)
                for stop in self.stops(tree, whole, (0.5, 0.97) if WHOLE else (0.5,)):
                    self.assert_continued(scene, limit, whole, stop)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--whole", action="store_true")
    parser.add_argument("--scene", default="")
    given, others = parser.parse_known_args()
    WHOLE, WORD, ALL = given.whole, given.scene, given.all or given.whole or given.scene
    unittest.main(argv=[sys.argv[0], *others])
