#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Moments of the supports of turning rigid bodies, against the angular momentum of motions that are known: seeded bodies of any orientation
and inertia, with axes held, driven and free, in explicit and implicit steps. --variants N: bodies of each kind. Needs BRUNT and BRUNT_RUN
(scripts/run) in the environment."""
import csv
import unittest

import numpy

from run_test import Program, of_all, variants_asked

VARIANTS = 5
END = 0.2
AXES = numpy.eye(3)
NAMES = ("rx", "ry", "rz")


def turn(vector):
    """The rotation about this axis by its length."""
    angle = numpy.linalg.norm(vector)
    if angle == 0:
        return numpy.eye(3)
    k = vector / angle
    hat = numpy.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    return numpy.eye(3) + numpy.sin(angle) * hat + (1 - numpy.cos(angle)) * hat @ hat


class Body:
    """A box, and how its rotations are supported. given(t), angle(t): the driven angular velocity, and its integral where no axis is free."""

    def __init__(self, number, kind, random):
        self.name, self.kind = f"b{number}", kind
        self.size, self.at = random.uniform(0.3, 2, 3), random.uniform(-5, 5, 3)
        self.axis, self.degrees = random.normal(size=3), random.uniform(-180, 180)
        self.density = 10 ** random.uniform(0, 4)
        mass = self.density * numpy.prod(self.size)
        square = self.size**2
        rotated = turn(self.axis / numpy.linalg.norm(self.axis) * numpy.radians(self.degrees))
        self.inertia = rotated @ numpy.diag(mass / 12 * (square.sum() - square)) @ rotated.T
        self.is_given = random.random() < 0.5  # off its own axes, with products of inertia
        if self.is_given:
            moments = mass * random.uniform(0.5, 1, 3)  # no moment above the sum of the others
            other = turn(random.normal(size=3))
            self.inertia = other @ numpy.diag(moments) @ other.T
        self.order = random.permutation(3)
        self.rates = random.uniform(1, 6, 3) * random.choice([-1, 1], 3)
        self.set_supports()

    def set_supports(self):
        a, b, c = self.order
        first, second = self.rates[0] * AXES[a], self.rates[1] * AXES[b]
        self.fixed, self.driven, self.start = [], {}, numpy.zeros(3)
        if self.kind == "axle":  # one axis free, two held
            self.start, self.fixed = first, [b, c]
            self.spin = lambda t: self.start
            self.angle = lambda t: self.start * t
        elif self.kind == "driven":  # from rest at once
            self.driven, self.fixed = {a: ("velocity", self.rates[0])}, [b, c]
            self.spin, self.angle = (lambda t: first), (lambda t: first * t)
        elif self.kind == "two driven":
            self.driven, self.fixed = {a: ("velocity", self.rates[0]), b: ("velocity", self.rates[1])}, [c]
            self.spin, self.angle = (lambda t: first + second), (lambda t: (first + second) * t)
        elif self.kind == "accelerated":
            self.driven, self.fixed = {a: ("acceleration", 5 * self.rates[0])}, [b, c]
            self.spin, self.angle = (lambda t: 5 * first * t), (lambda t: 2.5 * first * t**2)
        elif self.kind == "one held":  # two axes free
            self.start, self.fixed = first + second, [c]
        elif self.kind == "driven and free":
            self.driven, self.fixed, self.start = {a: ("velocity", self.rates[0])}, [c], second  # the drive begins at t = 0

    def scene(self):
        x = lambda v: "[" + ", ".join(repr(float(k)) for k in v) + "]"
        lines = {"mesh": [], "materials": [], "parts": [], "fixed": [], "prescribed": [], "initial": [], "probes": []}
        lines["mesh"] = [f"  - {{box: {{part: {self.name}, size: {x(self.size)}, elements: [1, 1, 1], at: {x(self.at)}, "
                         f"rotate: {{axis: {x(self.axis)}, degrees: {self.degrees!r}}}}}}}"]
        lines["materials"] = [f"  {self.name}: {{model: rigid, density: {self.density!r}}}"]
        i = self.inertia
        given = f", rigid: {{inertia: {x([i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[1, 2], i[2, 0]])}}}" if self.is_given else ""
        lines["parts"] = [f"  {self.name}: {{material: {self.name}{given}}}"]
        dofs = ", ".join(["x", "y", "z"] + [NAMES[k] for k in self.fixed])
        lines["fixed"] = [f"  - {{part: {self.name}, dofs: [{dofs}]}}"]
        lines["prescribed"] = [f"  - {{part: {self.name}, dof: {NAMES[k]}, {what}: {rate!r}}}" for k, (what, rate) in self.driven.items()]
        if self.start.any():
            rate = float(numpy.linalg.norm(self.start))
            lines["initial"] = [f"  - {{part: {self.name}, velocity: [0, 0, 0], rotation: {{axis: {x(self.start)}, rate: {rate!r}}}}}"]
        lines["probes"] = [f"  - {{name: {self.name}, part: {self.name}, field: reaction_moment}}"]
        return lines

    def momentum_at(self, times):
        """The angular momentum at these times, by the known rotation or from l along free axes, which no support changes."""
        if hasattr(self, "angle"):
            states = [(turn(self.angle(t)), self.spin(t)) for t in times]
            return numpy.array([r @ self.inertia @ r.T @ w for r, w in states])
        free = numpy.diag([0.0 if k in self.fixed or k in self.driven else 1.0 for k in range(3)])
        given = sum((rate * AXES[k] for k, (_, rate) in self.driven.items()), numpy.zeros(3))
        along = free @ self.inertia @ self.start
        held = numpy.eye(3) - free

        def spin(r):
            i = r @ self.inertia @ r.T
            return given + free @ numpy.linalg.solve(free @ i @ free + held, along - free @ i @ given)

        def rate(r):
            w = spin(r)
            return numpy.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]]) @ r

        momenta, r, now = [], numpy.eye(3), 0.0
        for t in times:  # Runge and Kutta, in steps that leave nothing
            pieces = max(1, int(numpy.ceil((t - now) / 1e-3)))
            h = (t - now) / pieces
            for _ in range(pieces):
                k1 = rate(r)
                k2 = rate(r + h / 2 * k1)
                k3 = rate(r + h / 2 * k2)
                r = r + h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(r + h * k3))
            now = t
            momenta.append(r @ self.inertia @ r.T @ spin(r))
        return numpy.array(momenta)


def bodies(kinds, seed, count):
    random = numpy.random.default_rng(seed)
    return [Body(i, kinds[i % len(kinds)], random) for i in range(count * len(kinds))]


def scene_of(some, step, more=""):
    text = {}
    for body in some:
        for section, lines in body.scene().items():
            text.setdefault(section, []).extend(lines)
    return "units: none\n" + "".join(f"{section}:\n" + "\n".join(lines) + "\n" for section, lines in text.items() if lines) + more + \
        f"run: {{end: {END}, step: {step!r}}}\nhistory: {{every: {step!r}}}\n"


class Reactions(Program):
    def rows(self, result):
        lines = self.text(result, "history.csv").splitlines()
        lines[0] = ",".join(head.split("[")[0].strip() for head in lines[0].split(","))
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(lines)]

    def moments(self, some, step, text, ranks=1):
        self.write("scene.yaml", text)
        self.run_scene(ranks, "scene.yaml", "--out", "out", "--force")
        rows = self.rows("out")
        return numpy.array([row["time"] for row in rows]), \
            {body.name: numpy.array([[row[f"{body.name}.{c}"] for c in "xyz"] for row in rows]) for body in some}

    def errors(self, some, step, text, late=0.5):
        """Of each body the largest error of a row over the largest moment of the body."""
        times, found = self.moments(some, step, text)
        errors = {}
        for body in some:
            momentum = body.momentum_at(times + late * step)
            wanted = (momentum[2:] - momentum[1:-1]) / (times[2:] - times[1:-1])[:, None]
            errors[body.name] = numpy.abs(found[body.name][2:] - wanted).max() / numpy.abs(wanted).max()
        return errors

    def test_exact_motions_have_the_exact_moment(self):
        some = bodies(("axle", "driven", "two driven"), 41, VARIANTS)
        errors = self.errors(some, 2e-3, scene_of(some, 2e-3))
        for body in some:
            self.assertLess(errors[body.name], 1e-9, f"{body.kind} {body.name}")
        self.assertLess(self.summary("out")["energy"]["error_ratio"], 1e-12)

    def test_a_free_axle_gets_no_moment_along_it(self):
        some = bodies(("axle",), 42, VARIANTS)
        _, found = self.moments(some, 2e-3, scene_of(some, 2e-3))
        for body in some:
            self.assertLess(numpy.abs(found[body.name][:, body.order[0]]).max(), 1e-9 * numpy.abs(found[body.name]).max(), body.name)

    def test_accelerated_and_partly_free_bodies_converge_with_the_square_of_the_step(self):
        some = bodies(("accelerated", "one held", "driven and free"), 43, VARIANTS)
        coarse, fine = (self.errors(some, step, scene_of(some, step)) for step in (2e-3, 1e-3))
        for body in some:
            self.assertLess(fine[body.name], 2e-3, f"{body.kind} {body.name}")
            self.assertLess(fine[body.name], 0.3 * coarse[body.name], f"{body.kind} {body.name}")

    def test_the_work_of_drives_balances_with_the_square_of_the_step(self):
        some = bodies(("driven and free",), 44, VARIANTS)
        errors = []
        for step in (2e-3, 1e-3):
            self.moments(some, step, scene_of(some, step))
            errors.append(self.summary("out")["energy"]["error_ratio"])
        self.assertLess(errors[1], 1e-4)
        self.assertLess(errors[1], 0.3 * errors[0])

    def test_implicit_steps_have_the_same_moments(self):
        some = bodies(("axle", "driven", "accelerated", "one held", "driven and free"), 45, VARIANTS)
        errors = []
        for step in (4e-3, 2e-3):
            text = scene_of(some, step).replace(f", step: {step!r}}}", f"}}\nsolver: {{scheme: contact_implicit, step: {step!r}}}")
            errors.append(self.errors(some, step, text, late=0))
        for body in some:
            self.assertLess(errors[1][body.name], 5e-3, f"{body.kind} {body.name}")
            self.assertLess(errors[1][body.name], max(0.3 * errors[0][body.name], 1e-9), f"{body.kind} {body.name}")

    def test_a_plane_of_symmetry_holds_like_an_axle(self):
        plate = Body(0, "axle", numpy.random.default_rng(46))
        plate.order, plate.fixed, plate.is_given = numpy.array([2, 0, 1]), [], True
        plate.size, plate.at, plate.degrees = numpy.array([1.0, 2.0, 0.5]), numpy.array([-0.5, -1.0, 0.0]), 0.0
        plate.start = plate.rates[0] * AXES[2]
        text = scene_of([plate], 2e-3, "symmetry: [{point: [0, 0, 0], normal: [0, 0, 1]}]\n").replace("dofs: [x, y, z]", "dofs: [x, y]")
        self.assertLess(self.errors([plate], 2e-3, text)[plate.name], 1e-9)

    def test_the_same_bits_on_any_ranks_and_over_a_restart(self):
        some = bodies(("axle", "driven", "two driven", "accelerated", "one held", "driven and free"), 47, 2)
        self.write("scene.yaml", scene_of(some, 2e-3))
        for ranks in of_all((1, 2, 3, 4), (1, 4)):
            self.run_scene(ranks, "scene.yaml", "--out", f"r{ranks}")
            self.assertEqual(self.summary(f"r{ranks}")["state_hash"], self.summary("r1")["state_hash"])
            self.assertEqual(self.text(f"r{ranks}", "history.csv"), self.text("r1", "history.csv"))
        self.run_scene(2, "scene.yaml", "--out", "part", "--set", "run.end=0.1")
        self.run_scene(3, "scene.yaml", "--out", "part", "--restart", "part")
        self.assertEqual(self.summary("part")["state_hash"], self.summary("r1")["state_hash"])
        self.assertEqual(self.text("part", "history.csv"), self.text("r1", "history.csv"))

    def test_with_damping_and_another_moment_the_supports_give_the_rest(self):
        """A pressure on a side turns the plate about its axle; the columns moment and reaction_moment add up to the change of l."""
        self.write("scene.yaml", """\
units: none
mesh: {box: {part: plate, size: [3, 2, 0.4], elements: [2, 2, 1], at: [-1.5, -1, -0.2], rotate: {axis: [1, 2, 0.5], degrees: 30}}}
materials: {hard: {model: rigid, density: 100}}
parts: {plate: {material: hard}}
fixed: [{part: plate, dofs: [x, y, z, rx, ry]}]
initial: [{part: plate, velocity: [0, 0, 0], rotation: {axis: [0, 0, 1], rate: 5}}]
forces: [{set: plate_xmax, force: [10, 200, 30]}]
damping: {alpha: 0.5}
probes:
  - {name: m, part: plate, field: moment}
  - {name: r, part: plate, field: reaction_moment}
  - {name: l, part: plate, field: angular_momentum}
run: {end: 0.5, step: 1.0e-3}
history: {every: 1.0e-3}
""")
        self.run_scene(1, "scene.yaml", "--out", "out")
        rows = self.rows("out")
        largest = max(abs(row["r.x"]) for row in rows[2:])
        self.assertGreater(largest, 100)
        self.assertLess(self.summary("out")["energy"]["error_ratio"], 1e-12)
        for before, now in zip(rows[2:-1], rows[3:]):  # l of a row has the spin of t_{n+1/2} at the orientation of t_n: first order
            for c in "xyz":
                change = (now[f"l.{c}"] - before[f"l.{c}"]) / (now["time"] - before["time"])
                self.assertLess(abs(now[f"m.{c}"] + now[f"r.{c}"] - change), 1e-2 * largest)


if __name__ == "__main__":
    VARIANTS = variants_asked(VARIANTS)
    unittest.main()
