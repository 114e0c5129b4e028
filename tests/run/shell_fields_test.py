#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Generated shells in whole runs: masses of the bodies, and the stresses of the state file in the axes of the scene, against closed forms.
Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import math
import os
import unittest

import h5py
import numpy as np
from scene_program import SceneProgram

MATERIAL = "materials: {m: {model: elastic, density: 2, young: 1000, poisson: POISSON}}\n"
BODIES = """units: none
mesh:
  - {plate: {part: plate, size: [2, 3], elements: [4, 5], shell: true}}
  - {tube: {part: tube, inner_radius: 0.9, outer_radius: 1.1, length: 3, elements: [1, 12, 4], shell: true, at: [5, 0, 0]}}
  - {box: {part: box, size: [1, 2, 3], elements: [2, 3, 4], shell: true, open: [zmax, xmin], at: [10, 0, 0]}}
  - {sphere: {part: sphere, radius: 1, elements: 12, shell: true, half: [z], at: [15, 0, 0]}}
""" + MATERIAL.replace("POISSON", "0.3") + """parts:
  plate: {material: m, thickness: 0.1, element: KIND}
  tube: {material: m, thickness: 0.2, element: KIND}
  box: {material: m, thickness: 0.05, element: KIND}
  sphere: {material: m, thickness: 0.01, element: KIND}
run: {steps: 1}
"""
# Of a strip between two moments: constant curvature. One element across, so that its two nodes share the moment.
STRIP = """units: none
mesh: [{plate: {part: p, size: [8, 1], elements: [8, 1], shell: true, rotate: {axis: [1, 2, 3], degrees: 50}}}]
""" + MATERIAL.replace("POISSON", "0") + """parts: {p: {material: m, element: KIND, thickness: 0.2, points: POINTS, rule: RULE}}
fixed: [{set: p_xmin, dofs: [x, y, z, rx, ry, rz]}]
forces: [{set: p_xmax, moment: [AXIS]}]
relaxation: {tolerance: 1.0e-7}
run: {steps: 1}
output: {fields: [stress, stress_bottom, stress_top, thickness]}
"""
# Of a sphere under pressure, p R / (2 t) in all directions of its surface; an eighth of it between planes of symmetry.
SPHERE = """units: none
mesh: [{sphere: {part: s, radius: 1, elements: 16, shell: true, half: [x, y, z]}}]
""" + MATERIAL.replace("POISSON", "0.3") + """parts: {s: {material: m, element: KIND, thickness: 0.02}}
symmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}, {point: [0, 0, 0], normal: [0, 1, 0]}, {point: [0, 0, 0], normal: [0, 0, 1]}]
pressure: [{set: s_surface, value: -1.0e-3}]
relaxation: {tolerance: 1.0e-4}
run: {steps: 1}
output: {fields: [stress, stress_bottom, stress_top]}
"""
KINDS = ("shell4", "shell4_full", "shell3")


def rotation(axis, degrees):
    k = np.array(axis) / np.linalg.norm(axis)
    cross = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    return np.eye(3) + math.sin(math.radians(degrees)) * cross + (1 - math.cos(math.radians(degrees))) * cross @ cross


def tensors(table):
    """xx, yy, zz, xy, yz, zx as matrices."""
    return np.array(table)[:, [[0, 3, 5], [3, 1, 4], [5, 4, 2]]]


class ShellFields(SceneProgram):
    def state(self, scene):
        self.go(scene)
        return h5py.File(os.path.join(self.folder, "out", "state.h5"), "r")

    def test_masses(self):
        ring = 12 * 2 * math.sin(math.pi / 12)  # around the polygon of the tube
        wanted = {"plate": 6 * 0.1, "tube": ring * 3 * 0.2, "box": (2 * 3 + 2 * 1 * 3 + 2) * 0.05}
        for kind in KINDS:
            self.write("scene.yaml", BODIES.replace("KIND", kind))
            lines = self.brunt("check", "scene.yaml").stdout.splitlines()
            mass = {line.split()[0]: float(line.split()[4]) for line in lines if len(line.split()) == 5 and line.split()[1] == kind}
            for part, volume in wanted.items():
                self.assertAlmostEqual(mass[part] / (2 * volume), 1, delta=1e-5, msg=f"{kind} {part}")  # six digits are shown
            self.assertAlmostEqual(mass["sphere"] / (2 * 2 * math.pi * 0.01), 1, delta=0.01, msg=kind)

    def test_stress_over_the_thickness_of_a_strip(self):
        turn = rotation([1, 2, 3], 50)
        moment, thickness = 1.0e-5, 0.2  # turns the end by 1.2e-4
        face = 6 * moment / thickness**2
        along = np.outer(turn[:, 0], turn[:, 0])  # top in tension under a moment about the axis of the width
        for rule, points, place in (("gauss", 5, 0.9061798459386640), ("gauss", 2, 1 / math.sqrt(3)), ("lobatto", 4, 1)):
            for kind in KINDS:
                axis = ", ".join(repr(float(a)) for a in moment / 2 * turn[:, 1])
                scene = STRIP.replace("KIND", kind).replace("POINTS", str(points)).replace("RULE", rule).replace("AXIS", axis)
                with self.state(scene) as file:
                    record = file[sorted(name for name in file if name.startswith("record"))[0]]["element"]
                    for name, sign in (("stress_top", 1), ("stress", 0), ("stress_bottom", -1)):
                        error = np.abs(tensors(record[name]) - sign * place * face * along).max() / face
                        self.assertLess(error, 2e-4, msg=f"{kind} {rule} {points} {name}")
                    self.assertTrue(np.allclose(record["thickness"], thickness, rtol=1e-6))

    def test_stress_of_a_sphere(self):
        wanted = 1.0e-3 / (2 * 0.02)
        for kind in KINDS:
            with self.state(SPHERE.replace("KIND", kind)) as file:
                corners = file["mesh/connectivity"][...]
                centre = file["mesh/coordinates"][...][corners].mean(axis=1)
                normal = centre / np.linalg.norm(centre, axis=1)[:, None]
                record = file[sorted(name for name in file if name.startswith("record"))[0]]["element"]
                stress = tensors(record["stress"])
                surface = wanted * (np.eye(3) - normal[:, :, None] * normal[:, None, :])
                error = np.abs(stress - surface).max(axis=(1, 2)) / wanted
                self.assertLess(np.median(error), 0.01, msg=kind)  # of flat elements: 0.0017, 0.0028, 0.0061


if __name__ == "__main__":
    unittest.main()
