#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Ties of explicit scenes. Uniform tension passes between meshes that do not match, askew to each other, across gaps and where
the slave's facets hang over; spinning pairs keep momentum and angular momentum; a run gives the same bits on any ranks and over a
restart, also when elements of a joint are removed. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment. --all: sixty
random pairs of meshes and sixty random spins."""
import os
import random
import sys
import unittest

import h5py

from mortar_contact_test import KINDS, brick, input_file
from run_test import of_all
from scene_program import SceneProgram

TENSION = 1e-7  # of Young's modulus: geometry changes by as much
TENSILE = """units: none
mesh: {{file: pair.inp}}
sets: {{foot: {{box: [[-1, -1, -0.001], [1, 1, 0.001]]}}}}
materials: {{m: {{model: elastic, density: 1, young: 1, poisson: 0.3}}}}
parts: {{lower: {{material: m, element: {elements[0]}}}, upper: {{material: m, element: {elements[1]}}}}}
symmetry: [{{point: [-0.5, 0, 0], normal: [1, 0, 0]}}, {{point: [0, -0.5, 0], normal: [0, 1, 0]}}, {{point: [0, 0, 0], normal: [0, 0, 1]}}]
traction: [{{set: head, value: [0, 0, {tension}]}}]
contact: [{{between: [lower, upper], slave: {slave}, tied: true, tolerance: 1.0e-9}}]
relaxation: {{tolerance: {rest}}}
run: {{end: 0.01}}
output: {{fields: [stress]}}
"""
SPIN = """units: SI
mesh:
  - {{box: {{part: a, size: [1, 1, 0.3], elements: {na}}}}}
  - {{box: {{part: b, size: {size}, elements: {nb}, at: {at}, rotate: {{axis: [0, 0, 1], degrees: {degrees}}}}}}}
materials: {{m: {{model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}}, r: {{model: rigid, density: 7800}}}}
parts: {{a: {{material: m}}, b: {{material: {b}}}}}
initial:
  - {{part: a, velocity: {velocity}, rotation: {{axis: {axis}, point: [0.4, 0.5, 0.3], rate: {rate}}}}}
  - {{part: b, velocity: {velocity}, rotation: {{axis: {axis}, point: [0.4, 0.5, 0.3], rate: {rate}}}}}
contact: [{{between: [a, b], tied: true, slave: {slave}}}]
run: {{end: 2.0e-3}}
output: {{every: 1.0e-3, fields: [displacement]}}
checkpoint: {{every: 1.0e-3}}
"""


def pair(seed, twisted):
    """Two meshes with flush rims: their text, the scene's fields."""
    rng = random.Random(seed)
    bodies, kinds = [], [rng.choice(KINDS), rng.choice(KINDS)]
    gap, first = rng.choice((0, 0, 0.005)), 1
    for name, bottom, kind in (("lower", 0, kinds[0]), ("upper", 0.5, kinds[1])):
        n = (rng.randint(2, 6), rng.randint(2, 6))
        twist = rng.uniform(-0.7, 0.7) if twisted else 0
        nodes, elements = brick(n, 2, bottom, bottom + 0.5, twist, first, rng.uniform(-0.05, 0.05) if twisted else 0)
        first += len(nodes)
        if bodies:  # after it is twisted, so that the loaded end is not
            nodes = [(x, y, z + gap) for x, y, z in nodes]
        bodies.append((name, nodes, elements, kind == "tet4"))
    rest = 3e-7 if gap else 1e-9  # pins across a gap turn by the rounding of positions, 1e-7 of these loads
    return input_file(bodies), {"elements": kinds, "slave": rng.choice(("lower", "upper")), "rest": rest}


def spin(seed):
    rng = random.Random(seed)
    rigid = rng.random() < 0.25
    return {"na": [rng.randint(2, 7), rng.randint(2, 7), 2], "nb": [rng.randint(2, 7), rng.randint(2, 7), 2],
            "size": [rng.uniform(0.4, 1), rng.uniform(0.4, 1), 0.3],
            "at": [rng.uniform(0, 0.4), rng.uniform(-0.1, 0.4), 0.3 + rng.choice((0, rng.uniform(0, 0.01)))],
            "degrees": rng.uniform(0, 90), "velocity": [rng.uniform(-40, 40) for _ in range(3)],
            "axis": [rng.uniform(-1, 1) for _ in range(3)], "rate": rng.choice((30, 300, 1000)), "b": "r" if rigid else "m",
            "slave": "auto" if rigid else rng.choice("ab")}


class MortarTies(SceneProgram):
    pairs, spins = range(1, 5), range(1, 5)

    def worst_stress(self):
        with h5py.File(os.path.join(self.folder, "out", "state.h5")) as file:
            last = sorted(name for name in file if name.startswith("record_"))[-1]
            stress = file[last]["element/stress"][:] / TENSION
        stress[:, 2] -= 1
        return abs(stress).max()

    def test_uniform_tension_passes_between_meshes_that_do_not_match(self):
        for seed in self.pairs:
            for twisted in (False, True):  # parallelograms, whose integrals are exact, or not
                with self.subTest(seed=seed, twisted=twisted):
                    mesh, fields = pair(seed, twisted)
                    self.write("pair.inp", mesh)
                    self.go(TENSILE.format(tension=TENSION, **fields))
                    self.assertLess(self.worst_stress(), 1e-5 if twisted else 1e-6, fields)

    def test_spinning_pairs_keep_momentum_and_energy(self):
        for seed in self.spins:
            with self.subTest(seed=seed):
                fields = spin(seed)
                self.go(SPIN.format(**fields))
                told = self.summary("out")
                self.assertLess(told["momentum_error"], 1e-12, fields)
                self.assertLess(told["angular_momentum_error"], 1e-12, fields)
                self.assertLess(told["energy"]["error_ratio"], 1e-10, fields)

    def test_the_same_bits_on_any_ranks_and_over_a_restart(self):
        scene = SPIN.format(**{**spin(1), "b": "m"})
        self.go(scene)
        wanted = self.summary("out")["state_hash"]
        for ranks in of_all((2, 3, 4), (2, 3)):
            self.go(scene, ranks=ranks, out=f"on{ranks}")
            self.assertEqual(self.summary(f"on{ranks}")["state_hash"], wanted, ranks)
        half = os.path.join("on2", min(self.checkpoints("on2")))
        self.run_scene(3, "scene.yaml", "--restart", half, "--out", "again")
        self.assertEqual(self.summary("again")["state_hash"], wanted)

    def test_elements_of_a_joint_are_removed(self):
        fields = {**spin(2), "b": "m", "at": [0.1, 0.1, 0.3], "size": [0.6, 0.6, 0.3], "degrees": 10, "na": [8, 8, 2], "nb": [7, 7, 2]}
        scene = SPIN.format(**fields) + "sets: {bit: {box: [[0.2, 0.2, 0.14], [0.6, 0.5, 0.31]], part: a}}\n"
        scene += "remove: [{set: bit, at: 5.0e-4, nodes: drop}]\n"
        hashes = set()
        for ranks in (1, 3):
            self.go(scene, ranks=ranks)
            told = self.summary("out")
            self.assertGreater(told["removed_elements"], 0)
            self.assertLess(told["momentum_error"], 1e-12)
            self.assertLess(told["energy"]["error_ratio"], 1e-10)
            hashes.add(told["state_hash"])
        half = os.path.join("out", min(self.checkpoints("out")))
        self.run_scene(2, "scene.yaml", "--restart", half, "--out", "again")
        hashes.add(self.summary("again")["state_hash"])
        self.assertEqual(len(hashes), 1)


if __name__ == "__main__":
    if "--all" in sys.argv:
        sys.argv.remove("--all")
        MortarTies.pairs = MortarTies.spins = range(1, 61)
    unittest.main()
