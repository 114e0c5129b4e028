#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Shells in whole runs: momentum, angular momentum and energy of free plates that bend, turn and flow; a rigid rotation gives no strain;
beams and supports against closed forms; the same bits on any number of ranks and over a restart, with erosion.
Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import math
import unittest

from scene_program import SceneProgram

KINDS = ("shell4", "shell4_full", "shell3")
# A thin plate, half of which is struck: it bends with large rotations, flows, and turns as a whole.
FREE = """units: none
mesh: [{plate: {part: p, size: [1, 0.8], elements: [7, 6], shell: true, rotate: {axis: [1, 2, 0.5], degrees: 40}}}]
materials: {m: {model: j2, density: 1, young: 1000, poisson: 0.3, yield: 8, hardening: 50}}
parts: {p: {material: m, element: KIND, thickness: 0.03, points: 4}}
initial: [{part: p, rotation: {axis: [1, -0.3, 2], point: [0.2, 0.1, 0], rate: 4}}, {set: p_xmin, velocity: [2, 4, 6]}]
probes: [{name: l, part: p, field: angular_momentum}, {name: e, part: p, field: energy}]
run: {end: 1.0}
history: {every: 0.01}
"""
# A strip on a rigid spinning frame of nodes would need forces; a free strip that spins about any axis does not but for the centripetal ones.
SPIN = """units: none
mesh: [{plate: {part: p, size: [1, 1], elements: [4, 4], shell: true, at: [-0.5, -0.5, 0], rotate: {axis: [1, 1, 0.2], degrees: 25}}}]
materials: {m: {model: elastic, density: 1, young: 1.0e6, poisson: 0.3}}
parts: {p: {material: m, element: KIND, thickness: 0.05}}
initial: [{part: p, rotation: {axis: [AXIS], rate: 1.0e-3}}]
probes: [{name: l, part: p, field: angular_momentum}, {name: w, part: p, field: angular_velocity}]
run: {end: 1.0}
history: {every: 0.05}
"""
# Plates of several kinds that share nothing, one with erosion, loads of all kinds, supports of rotations.
MIXED = """units: none
mesh:
  - {plate: {part: a, size: [1, 1], elements: [8, 7], shell: true}}
  - {tube: {part: b, inner_radius: 0.38, outer_radius: 0.42, length: 1, elements: [1, 12, 6], shell: true, at: [2, 0, 0]}}
  - {plate: {part: c, size: [1, 1], elements: [6, 6], shell: true, at: [0, 2, 0]}}
  - {box: {part: d, size: [0.5, 0.5, 0.5], elements: [3, 3, 3], at: [4, 0, 0]}}
materials:
  m: {model: j2, density: 1, young: 1000, poisson: 0.3, yield: 4, hardening: 20}
  e: {model: elastic, density: 1, young: 1000, poisson: 0.3}
parts:
  a: {material: m, element: shell4, thickness: 0.03, erosion: {plastic_strain: 0.02}}
  b: {material: m, element: shell4_full, thickness: 0.04, points: 3}
  c: {material: e, element: shell3, thickness: 0.03}
  d: {material: e}
fixed: [{set: a_xmin, dofs: [x, y, z, rx, ry, rz]}, {set: b_bottom, dofs: [x, y, z]}, {set: c_xmin, dofs: [x, y, z, ry]}]
prescribed: [{set: c_xmin, dof: rx, velocity: ramp}]
curves: {ramp: [[0, 0], [1, 2]]}
initial: [{part: d, velocity: [0, 0, 1]}, {set: a_xmax, velocity: [0, 0, 14]}, {set: b_top, velocity: [3, 0, 0]}]
gravity: {vector: [0, 0, -3]}
damping: {alpha: 0.2}
probes: [{name: turn, set: c_xmin, field: rotation}, {name: hold, set: a_xmin, field: reaction_moment}]
run: {end: 0.4}
history: {every: 0.01}
checkpoint: {every: 0.2}
output: {every: 0.1, fields: [displacement]}
"""
STRIP = """units: none
mesh: [{plate: {part: p, size: [10, 1], elements: [N, 2], shell: true}}]
materials: {m: {model: elastic, density: 1, young: 1.2e6, poisson: 0}}
parts: {p: {material: m, element: KIND, thickness: 0.1}}
fixed: [{set: p_xmin, dofs: [x, y, z, rx, ry, rz]}]
initial: [{set: p_xmax, velocity: [0, 0, 1.0e-6]}]
probes: [{name: tip, set: p_xmax, field: displacement}]
run: {end: 40}
history: {every: 0.02}
"""


def norm(row, name):
    return math.sqrt(sum(row[f"{name}.{c}"]**2 for c in "xyz"))


def apart(first, second, name):
    return math.sqrt(sum((first[f"{name}.{c}"] - second[f"{name}.{c}"])**2 for c in "xyz"))


class Shells(SceneProgram):
    def test_free_plates_keep_momentum_and_energy(self):
        for kind in KINDS:
            with self.subTest(kind=kind):
                rows = self.go(FREE.replace("KIND", kind))
                self.assertLess(max(apart(row, rows[0], "l") for row in rows), 1e-10 * norm(rows[0], "l"))
                summary = self.summary("out")
                self.assertLess(summary["momentum_error"], 1e-12)
                self.assertLess(summary["energy"]["error_ratio"], 1e-10)
                self.assertGreater(rows[-1]["internal"], 0.05 * rows[0]["total"], "it does not bend")

    def test_a_slow_rotation_gives_no_strain(self):
        for kind in KINDS:
            for axis in ("0, 0, 1", "1, 0, 0", "1, -2, 0.7"):
                with self.subTest(kind=kind, axis=axis):
                    rows = self.go(SPIN.replace("KIND", kind).replace("AXIS", axis))
                    self.assertLess(rows[-1]["internal"], 1e-6 * rows[0]["kinetic"])
                    # the free precession of a plate that does not turn about a principal axis: rate^2 in the unit of time
                    self.assertLess(apart(rows[-1], rows[0], "w"), 1e-6)

    def test_first_frequency_of_a_strip(self):
        """Clamped beam: omega = 1.8751^2 sqrt(E h^2/(12 rho))/L^2; the rotary inertia lowers it by less than a permille here."""
        exact = 1.87510407**2 * math.sqrt(1.2e6 * 0.01 / 12) / 100
        for kind in KINDS:
            with self.subTest(kind=kind):
                rows = self.go(STRIP.replace("KIND", kind).replace("N,", "32,"))
                count = len(rows) - len(rows) % 2
                values = [row["tip.z"] for row in rows[:count]]
                crossings = [rows[i]["time"] - values[i] * (rows[i + 1]["time"] - rows[i]["time"]) / (values[i + 1] - values[i])
                             for i in range(1, count - 1) if values[i] < 0 <= values[i + 1]]
                periods = [b - a for a, b in zip(crossings, crossings[1:])]
                long = [p for p in periods if p > math.pi / exact]
                found = 2 * math.pi * len(long) / (crossings[-1] - crossings[0])
                self.assertAlmostEqual(found / exact, 1, delta=0.02)

    def test_same_bits_on_any_ranks_and_over_a_restart_with_erosion(self):
        self.write("mixed.yaml", MIXED)
        hashes = {}
        for ranks in (1, 2, 3, 4):
            self.run_scene(ranks, "mixed.yaml", "--out", f"r{ranks}", "--force")
            hashes[ranks] = self.summary(f"r{ranks}")["state_hash"]
        self.assertEqual(len(set(hashes.values())), 1, hashes)
        rows = self.rows("r1")
        self.assertGreater(rows[-1]["eroded"], 0, "nothing erodes")
        self.assertLess(self.summary("r1")["energy"]["error_ratio"], 1e-10)
        self.assertAlmostEqual(rows[-1]["turn.x"], rows[-1]["time"]**2, delta=2e-3)
        self.run_scene(2, "mixed.yaml", "--out", "part", "--force", "--set", "run.end=0.2")
        self.run_scene(3, "mixed.yaml", "--out", "part", "--restart", "part")
        self.assertEqual(self.summary("part")["state_hash"], hashes[1])


if __name__ == "__main__":
    unittest.main()
