#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Mortar contact of a part with itself: two boxes of one part are a pair of parts, a ring pressed flat and a bellows have the forces of
their explicit twins, the same bits on any number of ranks and after a restart, nothing passes. Needs BRUNT and BRUNT_RUN (scripts/run) in
the environment. --variants N: random scenes of each kind."""
import os
import random
import unittest

import numpy

import true_depth
from run_test import of_all, variants_asked
from scene_program import SceneProgram
from self_meshes import bellows, box, deck

VARIANTS = 3
RUBBER = "materials: {rubber: {model: neo_hookean, density: 1.0e-3, young: 10, poisson: 0.3}}\n"

# Two boxes, pressed on each other and then drawn along. PARTS: of one part or of two.
BLOCKS = """\
units: none
mesh: {file: blocks.inp}
materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}
parts: {PARTS}
sets: {foot: {part: low, box: [[-1, -1, -0.01], [2, 2, 0.01]]}, head: {part: TOP, box: [[-1, -1, 0.99], [2, 2, 1.01]]}}
fixed: [{set: foot, dofs: [x, y, z]}]
curves: {down: [[0, 0], [0.2, -0.05], [1, -0.05]], along: [[0, 0], [0.2, 0], [1, 0.2]]}
prescribed: [{set: head, dof: z, displacement: down}, {set: head, dof: x, displacement: along}, {set: head, dof: y, displacement: along, scale: 0}]
contact: [{between: [TOP, low], method: mortar, FORM}]
solver: {scheme: static, step: 0.1, tolerance: 1.0e-12}
run: {end: 1}
probes: [{name: c, contact: [TOP, low]}, {name: hold, set: head, field: reaction}]
"""
ONE = "low: {material: m, element: hex8_full}"

# A ring pressed flat between two walls: they go 18 of 21 quickly, and then slowly until the two halves are 12 % thinner.
RING = """\
units: mm-ms-g
mesh: {tube: {part: ring, inner_radius: 9.5, outer_radius: 10.5, length: 0.5, elements: [2, 80, 1]}}
""" + RUBBER + """\
parts: {ring: {material: rubber, element: hex8_full}}
symmetry: [{point: [0, 0, 0], normal: [0, 0, 1]}, {point: [0, 0, 0.5], normal: [0, 0, -1]}]
sets: {top: {part: ring, box: [[-0.01, 0, 0], [0.01, 11, 1]]}, bottom: {part: ring, box: [[-0.01, -11, 0], [0.01, 0, 1]]}}
fixed: [{set: top, dofs: [x]}, {set: bottom, dofs: [x]}]
rigid_walls:
  - {name: below, point: [0, -10.5, 0], normal: [0, 1, 0], motion: press}
  - {name: above, point: [0, 10.5, 0], normal: [0, -1, 0], motion: press}
probes: [{name: below, wall: below}, {name: above, wall: above}, {name: self, contact: [ring, ring]}]
"""
RING_STATIC = RING + """\
curves: {press: [[0, 9.0], [1, 9.0], [1.0001, 0.62], [3, 0.62]]}
contact: [{between: [ring, ring], method: mortar}]
solver: {scheme: static, step: 0.04}
run: {end: 2}
"""
RING_EXPLICIT = RING + """\
curves: {press: [[0, 0], [2, 0.3], [30.7, 0.3], [34.7, 0.01], [44.7, 0.01]]}
contact: [{between: [ring, ring]}]
damping: {alpha: 0.2}
run: {end: 44}
history: {every: 0.1}
"""

# Two folds pressed together until all layers touch.
BELLOWS = """\
units: mm-ms-g
mesh: {file: bellows.inp}
""" + RUBBER + """\
parts: {seal: {material: rubber, element: hex8_full}}
symmetry: [{point: [0, 0, 0], normal: [0, 0, 1]}, {point: [0, 0, 0.5], normal: [0, 0, -1]}]
sets: {foot: {part: seal, box: [[-1, -0.51, -1], [6.01, -0.49, 1]]}, head: {part: seal, box: [[-0.01, 4.49, -1], [7, 4.51, 1]]}}
fixed: [{set: foot, dofs: [x, y]}, {set: head, dofs: [x]}]
prescribed: [{set: head, dof: y, displacement: press}]
probes: [{name: foot, set: foot, field: reaction}, {name: head, set: head, field: reaction}, {name: self, contact: [seal, seal]}]
"""
BELLOWS_STATIC = BELLOWS + """\
curves: {press: [[0, 0], [1, -2.2]]}
contact: [{between: [seal, seal], method: mortar, friction: MU}]
solver: {scheme: static, step: 0.04}
run: {end: 1}
"""
BELLOWS_EXPLICIT = BELLOWS + """\
curves: {press: [[0, 0], [40, -2.2]]}
contact: [{between: [seal, seal], friction: MU}]
damping: {alpha: 0.3}
run: {end: 40}
history: {every: 0.05}
"""


# Three boxes whose faces are a triangle around the axis fly towards it: each of the three faces meets both others.
LOBES = """\
units: none
mesh: {file: lobes.inp}
materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}
parts: {a: {material: m, element: hex8_full}}
sets: {s0: {part: a, box: [[0.31, -0.6, -1], [3, 2, 2]]}, s1: {part: a, box: [[-3, 0.05, -1], [0.3, 3, 2]]}, s2: {part: a, box: [[-3, -3, -1], [0.3, -0.05, 2]]}}
initial: [INITIAL]
contact: [{between: [a, a], method: mortar, friction: 0.2}]
solver: {scheme: contact_implicit, step: 0.01, tolerance: 1.0e-12}
probes: [{name: s0, set: s0, field: displacement}, {name: s1, set: s1, field: displacement}, {name: s2, set: s2, field: displacement}]
run: {end: 0.5}
"""

# Two boxes of one part: the first is thrown, or pushed, at the second along an axis.
THROWN = """\
units: none
mesh: {file: thrown.inp}
materials: {m: {model: neo_hookean, density: 1000, young: 1.0e7, poisson: 0.3}}
parts: {a: {material: m, element: hex8_full}}
sets: {SETS}
MOTION
contact: [{between: [a, a], method: mortar}]
probes: [{name: one, set: one, field: displacement}, {name: two, set: two, field: displacement}]
"""


def around(points, low, high):
    """A box that holds the points with shares low to high of each axis."""
    first, size, margin = points.min(axis=0), numpy.ptp(points, axis=0), 1e-6
    return f"{{part: a, box: [{(first + low * size - margin).tolist()}, {(first + high * size + margin).tolist()}]}}"


def thrown(seed, scheme):
    """The deck, the scene, the axis along which the first box meets the second, and how far their middles are apart."""
    rng = random.Random(seed)
    axis = rng.randrange(3)
    unit, sizes = numpy.eye(3)[axis], [numpy.array([rng.uniform(0.3, 1) for _ in range(3)]) for _ in range(2)]
    for size in sizes:
        if rng.random() < 0.4:
            size[axis] *= 0.1  # a plate
    counts = [[rng.randint(1, 3) for _ in range(3)] for _ in range(2)]
    gap = rng.uniform(0.01, 2) * sizes[0][axis]
    aside = numpy.array([rng.uniform(-0.3, 0.3) for _ in range(3)]) * sizes[1] * (1 - unit)
    bodies = [box(sizes[k], counts[k]) for k in range(2)]
    apart = 0.5 * (sizes[0] + sizes[1]) * unit + gap * unit
    middles = [numpy.zeros(3), apart + aside]
    bodies = [("a", points - 0.5 * sizes[k] + middles[k], hexes) for k, (points, hexes) in enumerate(bodies)]
    path = gap + 1.5 * sizes[1][axis] + sizes[0][axis]  # beyond the second, were it not there
    step = 10 ** rng.uniform(-1, 1) * min(sizes[k][axis] / counts[k][axis] for k in range(2))  # of the path
    speed = 1.0 if scheme == "static" else 10 ** rng.uniform(0, 1.7)
    whole = numpy.zeros(3), numpy.ones(3)
    ends = [(0 * unit, 1 - unit), (unit, whole[1])]  # the near face of the first, the far one of the second
    sets = {"one": around(bodies[0][1], *whole), "two": around(bodies[1][1], *whole), "push": around(bodies[0][1], *ends[0]), "end": around(bodies[1][1], *ends[1])}
    if scheme == "static":
        others = ", ".join(c for k, c in enumerate("xyz") if k != axis)
        motion = (f"fixed: [{{set: end, dofs: [x, y, z]}}, {{set: push, dofs: [{others}]}}]\ncurves: {{push: [[0, 0], [{path:.9g}, {path:.9g}]]}}\n"
                  f"prescribed: [{{set: push, dof: {'xyz'[axis]}, displacement: push}}]")
    else:
        motion = f"initial: [{{set: one, velocity: {(speed * unit).tolist()}}}]"
    scene = THROWN.replace("SETS", ", ".join(f"{name}: {what}" for name, what in sets.items())).replace("MOTION", motion)
    scene += f"solver: {{scheme: {scheme}, step: {step / speed:.9g}}}\nrun: {{end: {max(path, 2 * step) / speed:.9g}}}\n"
    return deck(bodies), scene, "xyz"[axis], apart[axis]


def mean_around(rows, column, time, width):
    """Mean of a column over rows around a time: vibrations of an explicit run."""
    near = [row[column] for row in rows if abs(row["time"] - time) <= width]
    return sum(near) / len(near)


def between(rows, column, time):
    """A column at a time, linear between two rows."""
    return float(numpy.interp(time, [row["time"] for row in rows], [row[column] for row in rows]))


class SelfMortar(SceneProgram):
    def blocks(self, form, parts, alike=False):
        low, top = box([1, 1, 0.5], [3, 3, 2]), box([0.6, 0.7, 0.5], [3, 4, 2], [0.2, 0.1, 0.5])
        if alike:
            top = box([1, 1, 0.5], [3, 3, 2], [0.1, 0.05, 0.5])
        name = "low" if parts == 1 else "top"
        self.write("blocks.inp", deck([("low", *low), (name, *top)]))
        both = ONE if parts == 1 else ONE + ", " + ONE.replace("low", "top")
        return self.go(BLOCKS.replace("PARTS", both).replace("TOP", name).replace("FORM", form))

    def test_two_boxes_of_one_part_have_the_forces_of_two_parts(self):
        # the finer box is the slave, of boxes alike the first; stiffness of penalties and of sticking is E over the mean edge of the part
        forms = (("friction: 0", False), ("multiplier: standard", False), ("consistent: true", False), ("friction: 0", True),
                 ("friction: 0.3", True), ("enforce: penalty", True), ("enforce: penalty, friction: 0.3", True))
        for form, alike in of_all(forms, forms[1:3] + forms[4::2]):
            with self.subTest(form=form, alike=alike):
                slave = "low" if alike else "top"
                pair, itself = self.blocks(f"{form}, slave: {slave}", 2, alike), self.blocks(form, 1, alike)
                for one, other in zip(pair, itself):
                    for column in ("hold.x", "hold.z", "c.normal", "c.friction"):
                        self.assertAlmostEqual(one[column], other[column], delta=1e-8)
                self.assertGreater(itself[-1]["c.normal"], 1)

    def test_friction_is_coulombs(self):
        rows = self.blocks("friction: 0.3", 1)
        self.assertAlmostEqual(rows[-1]["c.friction"] / rows[-1]["c.normal"], 0.3, delta=1e-6)

    def test_a_flat_ring_has_the_force_of_its_explicit_twin(self):
        explicit, static = self.go(RING_EXPLICIT, out="explicit"), self.go(RING_STATIC)
        for gap in (1.88, 1.84, 1.78):
            # walls have gone 9.53 each at t = 34.7, and then go 0.01 a unit of time
            slow = mean_around(explicit, "below.y", 34.7 + (1.94 - gap) / 0.02, 0.5)
            force = between(static, "below.y", 1 + (3 - gap) / 1.24)
            self.assertAlmostEqual(force / slow, 1, delta=0.02, msg=f"gap {gap}")
        last = static[-1]
        self.assertAlmostEqual(last["below.y"], -last["above.y"], delta=1e-8)
        self.assertGreater(last["self.normal"], 15)
        told = self.summary("out")
        self.assertLess(abs(last["contact"]), 1e-3 * last["internal"])
        self.assertLess(told["deepest_penetration"]["elements"], 0.011)  # the deepest point of an edge of a curved wall

    def pressed(self, mu):
        self.write("bellows.inp", deck([("seal", *bellows(2, 6, 2, 1, 0.5))]))
        return self.go(BELLOWS_EXPLICIT.replace("MU", mu), out="explicit"), self.go(BELLOWS_STATIC.replace("MU", mu))

    def test_a_bellows_has_the_force_of_its_explicit_twin(self):
        for mu in of_all(("0", "0.3"), ("0.3",)):
            explicit, static = self.pressed(mu)
            for time in (0.6, 0.72, 0.84, 0.96):
                slow = mean_around(explicit, "head.y", 40 * time, 0.5)
                self.assertAlmostEqual(between(static, "head.y", time) / slow, 1, delta=0.02, msg=f"friction {mu}, t {time}")
            self.assertLess(max(abs(row["head.y"] + row["foot.y"]) for row in static), 1e-8)
            self.assertGreater(static[-1]["active_contacts"], 20)

    def test_the_same_bits_on_any_ranks_and_after_a_restart(self):
        self.write("bellows.inp", deck([("seal", *bellows(2, 6, 2, 1, 0.5))]))
        self.write("scene.yaml", BELLOWS_STATIC.replace("MU", "0.3").replace("step: 0.04", "step: 0.1"))
        for ranks in of_all((1, 2, 3, 4), (1, 3)):
            self.run_scene(ranks, "scene.yaml", "--out", f"out{ranks}")
            self.assertEqual(self.summary(f"out{ranks}")["state_hash"], self.summary("out1")["state_hash"])
            self.assertEqual(self.text(f"out{ranks}", "history.csv"), self.text("out1", "history.csv"))
        self.run_scene(2, "scene.yaml", "--out", "part", "--set", "run.end=0.8")
        self.assertGreater(self.summary("part")["contact"]["active"], 3)
        self.run_scene(3, "scene.yaml", "--out", "part", "--restart", "part")
        self.assertEqual(self.summary("part")["state_hash"], self.summary("out1")["state_hash"])
        self.assertEqual(self.text("part", "history.csv"), self.text("out1", "history.csv"))

    def test_three_walls_that_meet_have_a_slave_in_each_pair_and_a_warning(self):
        bodies, starts = [], []
        for k in range(3):
            angle = 2 * numpy.pi * k / 3 + 0.1
            turn = numpy.array([[numpy.cos(angle), -numpy.sin(angle), 0], [numpy.sin(angle), numpy.cos(angle), 0], [0, 0, 1]])
            points, hexes = box([1.6, 0.85, 1.6], [1, 1, 1], [0.35, -0.425, 0])
            bodies.append(("a", points @ turn.T, hexes))
            starts.append(f"{{set: s{k}, velocity: {(turn @ [-1, 0, 0]).tolist()}}}")
        self.write("lobes.inp", deck(bodies))
        for ranks in (1, 3):
            rows = self.go(LOBES.replace("INITIAL", ", ".join(starts)), ranks=ranks, out=f"out{ranks}")
        self.assertEqual(self.summary("out3")["state_hash"], self.summary("out1")["state_hash"])
        self.assertIn("contact.0: near [", self.text("out1", "log.txt"))
        self.assertIn("no choice of slave and master suits all facets that face each other", self.text("out1", "log.txt"))
        self.assertGreater(max(row["active_contacts"] for row in rows), 3)
        self.assertLess(self.summary("out1")["momentum_error"], 1e-12)
        self.assertLess(self.summary("out1")["energy"]["error_ratio"], 1e-11)
        # corners of single elements meet edge on edge, where mean gaps hold them loosely
        self.assertLess(self.summary("out1")["deepest_penetration"]["elements"], 0.3)

    def test_nothing_passes(self):
        stopped = 0
        for scheme in ("contact_implicit", "static"):
            for seed in range(1, of_all(2, 1) * VARIANTS + 1):
                with self.subTest(seed=seed, scheme=scheme):
                    mesh, scene, axis, apart = thrown(seed, scheme)
                    self.write("thrown.inp", mesh)
                    self.write("scene.yaml", scene)
                    told = self.run_scene(1, "scene.yaml", "--out", "out", "--force", code=(0, 3))
                    stopped += 1 if scheme == "contact_implicit" and "stopped" in told else 0
                    left = [apart + row[f"two.{axis}"] - row[f"one.{axis}"] for row in self.rows("out")]
                    if min(left) <= 0:  # nothing has passed where a box is crushed around the other until the run stops
                        self.assertIn("stopped", told, min(left))
                        self.assertLess(true_depth.deepest(os.path.join(self.folder, "out", "state.h5")).share, 0.5, min(left))
        self.assertLessEqual(stopped, 0.4 * VARIANTS)


if __name__ == "__main__":
    VARIANTS = variants_asked(VARIANTS)
    unittest.main()
