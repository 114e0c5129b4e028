#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Mortar contact where Newton's method stalled: blocks that slide with friction over facets, which their edges begin to cover; press fits of
rings against Lame's pressure, with either slave and any numbers of facets. --count N: variants of each. Needs BRUNT and BRUNT_RUN."""
import math
import random
import re
import unittest

from run_test import number_asked, of_all
from scene_program import SceneProgram

COUNT, SEED = 3, 1


def sliding(random_):
    """A soft block is pressed on a plate and dragged across it."""
    a, b = random_.randint(3, 6), random_.randint(2, 4)
    size = random_.uniform(0.4, 0.7)
    x, y = random_.uniform(0.05, 0.95 - size), random_.uniform(0.05, 0.95 - size)
    far = random_.uniform(0.02, 0.3 * (1 - size))
    direction = random_.uniform(0, 2 * math.pi)
    slave = random_.choice(["", "", ", slave: a", ", slave: b"])
    hard = random_.choice(["{model: j2, density: 2000, young: 1.0e7, poisson: 0.3, yield: 1.0e5, hardening: 1.0e6}",
                           "{model: elastic, density: 2000, young: 1.0e7, poisson: 0.3}"])
    return f"""\
units: none
mesh:
  - {{box: {{part: a, size: [1, 1, 0.4], elements: [{a}, {a}, 2]}}}}
  - {{box: {{part: b, size: [{size}, {size}, 0.4], elements: [{b}, {b}, 2], at: [{x}, {y}, 0.4]}}}}
materials: {{m: {hard}, n: {{model: neo_hookean, density: 1000, young: 1.0e6, poisson: {random_.uniform(0.2, 0.4)}}}}}
parts: {{a: {{material: m, element: hex8_bbar}}, b: {{material: n, element: hex8_full}}}}
fixed: [{{set: a_zmin, dofs: [x, y, z]}}]
curves: {{d: [[0, 0], [1, -{random_.uniform(0.01, 0.03)}], [2, -0.03]], x: [[0, 0], [1, 0], [2, {far}]]}}
prescribed:
  - {{set: b_zmax, dof: z, displacement: d}}
  - {{set: b_zmax, dof: x, displacement: x, scale: {math.cos(direction)}}}
  - {{set: b_zmax, dof: y, displacement: x, scale: {math.sin(direction)}}}
contact: [{{between: [a, b], method: mortar, friction: {random_.uniform(0.1, 0.5)}{slave}}}]
solver: {{scheme: static, step: {random_.choice([0.025, 0.04, 0.05])}}}
probes: [{{name: top, set: b_zmax, field: reaction}}, {{name: foot, set: a_zmin, field: reaction}}]
run: {{end: 2}}
"""


class PressFit:
    """A quarter of a shaft in a hub, in plane strain."""

    def __init__(self, random_):
        self.bore, self.seat, self.rim = random_.uniform(4, 12), 20, random_.uniform(35, 60)
        self.shaft, self.hub = (4 * random_.randint(20, 34) for _ in range(2))
        self.tight = random_.uniform(0.03, 0.06)
        self.young, self.poisson = (210000, 70000), (0.3, 0.33)
        self.length, self.along = random_.uniform(1, 5), random_.choice([1, 1, 2])
        self.slave = random_.choice(["", ", slave: shaft", ", slave: hub"])

    def scene(self):
        return f"""\
units: none
mesh:
  - {{tube: {{part: shaft, inner_radius: {self.bore}, outer_radius: {self.seat + self.tight}, length: {self.length}, elements: [6, {self.shaft}, {self.along}], quarter: [x, y]}}}}
  - {{tube: {{part: hub, inner_radius: {self.seat}, outer_radius: {self.rim}, length: {self.length}, elements: [8, {self.hub}, {self.along}], quarter: [x, y]}}}}
materials: {{s: {{model: elastic, density: 1, young: {self.young[0]}, poisson: {self.poisson[0]}}}, h: {{model: elastic, density: 1, young: {self.young[1]}, poisson: {self.poisson[1]}}}}}
parts: {{shaft: {{material: s, element: hex8_bbar}}, hub: {{material: h, element: hex8_bbar}}}}
symmetry: [{{point: [0, 0, 0], normal: [1, 0, 0]}}, {{point: [0, 0, 0], normal: [0, 1, 0]}}]
fixed: [{{part: shaft, dofs: [z]}}, {{part: hub, dofs: [z]}}]
contact: [{{between: [shaft, hub], method: mortar, initial_overlap: warn{self.slave}}}]
solver: {{scheme: static, step: 1}}
probes: [{{name: c, contact: [hub, shaft]}}]
run: {{end: 2}}
"""

    def force(self):
        """Lame, with the interference that facets leave: chords lie inside of a circle by two thirds of their sagitta in the mean."""
        def sagitta(facets):
            return self.seat * (1 - math.cos(math.pi / facets))

        interference = self.tight + 2 / 3 * (sagitta(self.hub) - sagitta(self.shaft))
        (es, eh), (ps, ph) = self.young, self.poisson
        es, eh, ps, ph = es / (1 - ps**2), eh / (1 - ph**2), ps / (1 - ps), ph / (1 - ph)
        c, b, a = self.seat, self.rim, self.bore
        hub, shaft = ((b * b + c * c) / (b * b - c * c) + ph) / eh, ((c * c + a * a) / (c * c - a * a) - ps) / es
        return interference / (hub + shaft) * self.length

    def uneven(self):
        """Polygons with other numbers of corners lie closer here than there, by what their sagittas differ."""
        shaft, hub = (self.seat * (1 - math.cos(math.pi / facets)) for facets in (self.shaft, self.hub))
        return 0.04 + 0.5 * abs(shaft - hub) / self.tight


class Seats(SceneProgram):
    def test_blocks_slide_over_facets(self):
        random_, stopped, slow = random.Random(SEED), [], []
        for number in range(COUNT):
            scene = sliding(random_)
            with self.subTest(number=number, scene=scene):
                self.write("scene.yaml", scene)
                told = self.run_scene(1, "scene.yaml", "--out", "out", "--force", code=(0, 3))
                if told:
                    stopped.append(told)
                    continue
                last, summary = self.rows("out")[-1], self.summary("out")
                self.assertAlmostEqual(last["time"], 2, delta=1e-9)
                for axis in "xyz":
                    self.assertAlmostEqual(last[f"top.{axis}"], -last[f"foot.{axis}"], delta=1e-6 * abs(last["top.z"]))
                if summary["implicit"]["newton"]["share_quadratic"] <= 0.2:  # they converge in steps that are not quadratic
                    slow.append(number)
                self.assertLess(summary["max_penetration"], 0.01)  # of rows that are hardly covered
        self.assertLessEqual(len(stopped), COUNT // 10, stopped)  # the limits say of which
        self.assertLessEqual(len(slow), 0.02 * COUNT, slow)  # 4 of 300, .1 to .2: plastic blocks that stick and slip

    def test_press_fits(self):
        random_ = random.Random(SEED)
        for number in range(COUNT):
            fit = PressFit(random_)
            with self.subTest(number=number, fit=vars(fit)):
                last = self.go(fit.scene())[-1]
                for axis in "xy":
                    self.assertLess(abs(last[f"c.{axis}"] / fit.force() - 1), fit.uneven())

    TOLD = re.compile(r"Pressures are from (\d+) % too (\w+) \(where all is pressed\) to (\d+) % too (\w+) ")

    def told(self):
        """Least and largest change of pressure [%] that a warning names, or None."""
        found = self.TOLD.findall(self.text("out", "log.txt"))
        self.assertLessEqual(len(found), 1)
        return [int(value) * (1 if word == "high" else -1) for value, word in (found[0][:2], found[0][2:])] if found else None

    def test_chords_that_take_of_the_interference_are_told(self):
        # mean overlap: 2/3 of the difference of sagittas; deepest: the shaft's node at the middle of a chord of the hub, where there is one
        cases = ((48, 60, -34, 91), (60, 48, 34, 137), (48, 48, None, None), (240, 300, None, None), (48, 144, -84, 0))
        for shaft, hub, mean, most in of_all(cases, cases[:3]):
            fit = PressFit(random.Random(SEED))
            fit.shaft, fit.hub, fit.tight, fit.slave = shaft, hub, 0.03, ""
            self.go(fit.scene())
            told = self.told()
            self.assertEqual(told is None, mean is None, told)
            if told:
                self.assertAlmostEqual(told[0], mean, delta=6)  # facets at planes of symmetry have half their curvature
                self.assertAlmostEqual(told[1], most, delta=12)

    def test_pressures_lie_between_the_limits_that_are_told(self):
        """Light fits feel the deepest overlap, heavy ones the mean."""
        cases = ((160, 80, 8, 22), (160, 80, 8, 45), (52, 132, 19, 37), (144, 72, 7, 40), (80, 160, 8, 22))
        for shaft, hub, bore, rim in of_all(cases, cases[2::2]):
            fit = PressFit(random.Random(SEED))
            fit.shaft, fit.hub, fit.bore, fit.rim, fit.tight, fit.slave = shaft, hub, bore, rim, 0.02, ""
            last = self.go(fit.scene())[-1]
            fit.shaft = fit.hub = 10000
            pressure = 100 * math.hypot(last["c.x"], last["c.y"]) / math.sqrt(2) / fit.force() - 100
            low, high = self.told()
            self.assertLess(low - 8, pressure)
            self.assertLess(pressure, high + 8)

    def test_the_finer_side_at_the_seat_is_the_slave(self):
        fit = PressFit(random.Random(SEED))
        fit.slave, fit.shaft, fit.hub, fit.bore = "", 96, 120, 4  # the shaft has the finer facets as a whole
        self.go(fit.scene())
        chosen = self.rows("out")[-1]["c.x"]
        fit.slave = ", slave: hub"
        self.go(fit.scene())
        self.assertEqual(self.rows("out")[-1]["c.x"], chosen)


if __name__ == "__main__":
    COUNT, SEED = number_asked("--count", COUNT), number_asked("--seed", SEED)
    unittest.main()
