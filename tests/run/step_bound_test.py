#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Steps bounded by the assembled mesh: fewer of them, the same bits on any number of ranks and after a restart, messages. Needs BRUNT and
BRUNT_RUN (scripts/run) in the environment."""
import os
import struct
import unittest

import h5py
from run_test import Program, of_all

# Two bodies of unlike elements and laws meet; estimates at steps 0 and 1000; some elements go on the way.
SCENE = """\
units: none
mesh:
  - {box: {part: a, size: [1, 1, 1], elements: [5, 5, 5]}}
  - {box: {part: b, size: [1.2, 0.8, 0.9], elements: [4, 4, 4], at: [1.01, 0.1, 0.05]}}
materials:
  steel: {model: j2, density: 1, young: 100, poisson: 0.3, yield: 0.5, hardening: 1}
  rubber: {model: neo_hookean, density: 1, young: 50, poisson: 0.4}
parts: {a: {material: steel}, b: {material: rubber, element: hex8_bbar}}
sets: {corner: {part: a, box: [[0, 0, 0], [0.4, 0.4, 0.4]]}}
initial: [{part: a, velocity: [0.3, 0, 0]}]
contact: [{between: all, friction: 0.2}]
remove: [{set: corner, at: 2.0}]
run: {steps: 1100, step_bound: assembled}
"""


def hash_of_text(text):
    """As model::hash_text: FNV-1a, then the finaliser of SplitMix64."""
    mask, h = 2**64 - 1, 0xcbf29ce484222325
    for byte in text.encode():
        h = (h ^ byte) * 0x100000001b3 & mask
    h = (h ^ h >> 30) * 0xbf58476d1ce4e5b9 & mask
    h = (h ^ h >> 27) * 0x94d049bb133111eb & mask
    return h ^ h >> 31


def make_format_3(path):
    """What a program wrote that knew neither measured times nor the bound of the mesh."""
    with h5py.File(path, "a") as file:
        del file["measured"]
        for group in (file["globals"], *(file["elements/block"][part] for part in file["elements/block"])):
            for name in [name for name in group if name.startswith("assembled")]:
                del group[name]
        time = struct.unpack("<Q", struct.pack("<d", file.attrs["time"]))[0]
        header = f"3 {file.attrs['step']} {time} {file.attrs['nodes']} {file.attrs['fingerprint'].decode()}"
        file.attrs.modify("format", 3)
        file.attrs.modify("hash", struct.unpack("<q", struct.pack("<Q", hash_of_text(header)))[0])


class StepBound(Program):
    def go(self, ranks, out, *options):
        self.write("scene.yaml", SCENE)
        self.run_scene(ranks, "scene.yaml", "--out", out, *options)
        return self.summary(out)

    def test_same_bits_on_any_number_of_ranks_and_after_a_restart(self):
        whole = self.go(1, "np1")
        for ranks in of_all((2, 3, 4), (3,)):
            self.assertEqual(self.go(ranks, f"np{ranks}")["state_hash"], whole["state_hash"], ranks)
        with h5py.File(os.path.join(self.folder, "np1", "checkpoint_000001100.h5")) as file:
            # the second one when elements had gone and it was paid for
            self.assertEqual([file[f"globals/assembled_{name}"][0] for name in ("estimates", "step")], [2, 1000])
        # before, at and after an estimate
        for steps in (3, 731, 1000):
            self.go(2, f"first{steps}", "--set", f"run.steps={steps}")
            again = self.go(3, f"first{steps}", "--restart", f"first{steps}")
            self.assertEqual(again["state_hash"], whole["state_hash"], steps)

    def test_fewer_steps_with_the_energy_kept(self):
        end = ("--set", "run.steps=null", "--set", "run.end=3")
        mesh = self.go(2, "mesh", *end)
        element = self.go(2, "element", *end, "--set", "run.step_bound=element")
        self.assertLess(1.15 * mesh["steps"], element["steps"])
        self.assertLess(mesh["energy"]["error_ratio"], 1e-10)

    def test_a_checkpoint_without_estimates_goes_on_with_a_new_one(self):
        for ranks in (1, 3):
            out = f"old{ranks}"
            self.go(2, out, "--set", "run.steps=40")
            make_format_3(os.path.join(self.folder, out, "checkpoint_000000040.h5"))
            self.go(ranks, out, "--restart", out, "--set", "run.steps=41")
            with h5py.File(os.path.join(self.folder, out, "checkpoint_000000041.h5")) as file:
                self.assertEqual(file["globals/assembled_step"][0], 40)
                self.assertEqual(file["globals/assembled_estimates"][0], 1)
        self.assertEqual(self.summary("old1")["state_hash"], self.summary("old3")["state_hash"])

    def test_another_word_is_refused(self):
        self.write("scene.yaml", SCENE.replace("assembled", "global"))
        told = self.run_scene(1, "scene.yaml", "--out", "out", code=2)
        for phrase in ("scene.yaml:13: run.step_bound", "'global'", "element", "assembled"):
            self.assertIn(phrase, told)


if __name__ == "__main__":
    unittest.main()
