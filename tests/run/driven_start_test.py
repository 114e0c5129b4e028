#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Directions that `initial` and `prescribed` both move: a body that already has its prescribed velocity needs no push at t = 0.
Needs BRUNT and BRUNT_RUN in the environment."""
import random
import unittest

from run_test import Program

SCENE = """\
units: none
mesh: {box: {part: b, size: SIZE, elements: [2, 2, 2]}}
materials: {m: {model: MODEL}}
parts: {b: {material: m}}
CURVES
initial: [{part: b, velocity: VELOCITY, rotation: {axis: [0, 0, 1], point: CENTRE, rate: RATE}}]
prescribed: [DRIVES]
probes: [{name: f, part: b, field: reaction}]
run: {end: 1.0e-3, step: 1.0e-5}
history: {every: 1.0e-5}
SOLVER
"""
MODELS = {"rigid": "rigid, density: 2", "elastic": "elastic, density: 2, young: 1.0e6, poisson: 0.0"}


def drive(dof, kind, value, name):
    """A prescribed motion with the velocity `value` from the start on, and its curve."""
    if kind == "velocity":
        return f"{{part: b, dof: {dof}, velocity: {value}}}", ""
    if kind == "displacement":
        return f"{{part: b, dof: {dof}, displacement: {name}}}", f"{name}: [[0, 0], [1, {value}]]"
    return f"{{part: b, dof: {dof}, acceleration: 0}}", ""


class DrivenStart(Program):
    def rows(self, name):
        header, *lines = self.text(name, "history.csv").splitlines()
        names = [word.split("[")[0].strip() for word in header.split(",")]
        return [dict(zip(names, map(float, line.split(",")))) for line in lines]

    def scene(self, model, size, velocity, rate, drives, solver=""):
        curves = [curve for _, curve in drives if curve]
        return (SCENE.replace("SIZE", str(size)).replace("MODEL", MODELS[model]).replace("VELOCITY", str(velocity))
                .replace("CENTRE", str([0.5 * s for s in size])).replace("RATE", str(rate)).replace("DRIVES", ", ".join(text for text, _ in drives))
                .replace("CURVES", f"curves: {{{', '.join(curves)}}}" if curves else "").replace("SOLVER", solver))

    def test_a_body_that_moves_as_prescribed_is_not_pushed(self):
        for variant in range(10):
            dice = random.Random(f"start {variant}")
            model, kind = dice.choice(sorted(MODELS)), ("velocity", "displacement", "acceleration")[variant % 3]
            size = [round(dice.uniform(0.5, 3), 3) for _ in range(3)]
            velocity = [round(dice.uniform(-9, 9), 4) for _ in range(3)]
            dofs = dice.sample("xyz", dice.randint(1, 3))
            drives = [drive(dof, kind, velocity["xyz".index(dof)], f"c{dof}") for dof in dofs]
            rate = 0
            if model == "rigid" and dice.random() < 0.7:
                rate = round(dice.uniform(-20, 20), 3)
                drives.append(drive("rz", kind, rate, "turn"))
            ranks = 1 + variant % 2
            name = f"v{variant}"
            with self.subTest(variant=variant, model=model, kind=kind, dofs=dofs, rate=rate):
                self.write("scene.yaml", self.scene(model, size, velocity, rate, drives))
                self.run_scene(ranks, "scene.yaml", "--out", name, "--force")
                mass = 2 * size[0] * size[1] * size[2]
                energy = 0.5 * mass * sum(v * v for v in velocity) + 0.5 * mass * (size[0] ** 2 + size[1] ** 2) / 12 * rate ** 2
                for row in self.rows(name):
                    self.assertAlmostEqual(row["kinetic"] / energy, 1, delta=1e-9)
                    self.assertAlmostEqual(row["external"] / energy, 0, delta=1e-9)
                    self.assertAlmostEqual(row["total"] / energy, 1, delta=1e-10)
                    for c in "xyz":
                        self.assertAlmostEqual(row[f"f.{c}"] * 1e-3 / mass, 0, delta=1e-7)  # of 9, over the whole run
                self.assertNotIn("starts with the velocity", self.text(name, "log.txt"))

    def test_an_implicit_run_begins_in_the_same_way(self):
        solver = "solver: {scheme: contact_implicit, step: 1.0e-4}"
        for model in sorted(MODELS):
            with self.subTest(model=model):
                text = self.scene(model, [1, 1, 1], [0, 0, 5], 0, [drive("z", "velocity", 5, "")], solver).replace("end: 1.0e-3, step: 1.0e-5", "end: 1.0e-3").replace(
                    "material: m}", "material: m, element: hex8_full}" if model == "elastic" else "material: m}")
                self.write("scene.yaml", text)
                self.run_scene(1, "scene.yaml", "--out", model, "--force")
                for row in self.rows(model):
                    self.assertAlmostEqual(row["kinetic"], 25, delta=1e-8)
                    self.assertAlmostEqual(row["external"], 0, delta=1e-8)

    def test_another_initial_velocity_is_told(self):
        for model in sorted(MODELS):
            for ranks in (1, 2):
                with self.subTest(model=model, ranks=ranks):
                    self.write("scene.yaml", self.scene(model, [1, 1, 1], [1, 0, 5], 0, [drive("z", "velocity", 3, "")]))
                    self.run_scene(ranks, "scene.yaml", "--out", "told", "--force")
                    log = self.text("told", "log.txt")
                    self.assertRegex(log, r"prescribed\.0: 'b' starts with the velocity of its prescribed motion in z at t = 0, 3, not with 5 of initial")
                    self.assertEqual(log.count("starts with the velocity"), 1)
                    for row in self.rows("told"):
                        self.assertAlmostEqual(row["kinetic"], 10, delta=1e-8)
                        self.assertAlmostEqual(row["external"], 0, delta=1e-8)

    def test_a_body_at_rest_is_brought_to_its_velocity(self):
        """By an impulse in the first step: reaction, work and energy agree."""
        self.write("scene.yaml", self.scene("rigid", [1, 1, 1], [0, 0, 0], 0, [drive("z", "velocity", 5, "")]))
        self.run_scene(1, "scene.yaml", "--out", "rest", "--force")
        first, *_, last = self.rows("rest")
        self.assertEqual(first["kinetic"], 0)
        self.assertAlmostEqual(last["kinetic"], 25, delta=1e-9)
        self.assertAlmostEqual(last["external"], 25, delta=1e-9)
        self.assertAlmostEqual(last["total"], first["total"], delta=1e-10)
        self.assertNotIn("starts with the velocity", self.text("rest", "log.txt"))


if __name__ == "__main__":
    unittest.main()
