#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Where static states lose their stability and regain it: columns against Euler's load and against their own growth under a lateral force,
parts that ties, contact, walls and rigid bodies hold, and states that are stable. Needs BRUNT and BRUNT_RUN (scripts/run)."""
import math
import random
import re
import unittest

from run_test import number_asked, of_all
from scene_program import SceneProgram

LOST = re.compile(r"loses its stability between t = (\S+) and t = ([^\s:]+): (\w+) ")
REGAINED = re.compile(r"regained between t = (\S+) and t = ([^\s:]+)")
COUNT, SEED = 2, 1


class Column:
    """A prismatic bar under a dead axial load, clamped at its foot; its top is free, or cannot move sideways (but turn)."""

    def __init__(self, random_):
        self.width = random_.uniform(0.8, 1.2)
        self.depth = self.width * random_.choice([1, 1, random_.uniform(1.2, 1.6)])
        self.held_top = random_.random() < 0.4
        self.length = random_.uniform(8, 12) * (2 if self.held_top else 1)
        self.poisson = random_.uniform(0, 0.3)
        self.element = random_.choice(["hex8_full", "hex8_bbar"])
        self.model = random_.choice(["elastic", "neo_hookean"])
        self.tied = random_.random() < 0.4  # of two parts
        self.turn = 0 if self.held_top else random_.choice([0, 90, random_.uniform(0, 90)])
        self.young = 10 ** random_.uniform(1, 11)
        self.across, self.along = 2, 2 * math.ceil(self.length / min(self.width, self.depth))

    def euler(self):
        """With the shear of Engesser, and the parasitic shear of elements of length l, which adds G A l^2/12 to E I."""
        small, large = sorted((self.width, self.depth))
        inertia, area = large * small**3 / 12, small * large
        parasitic = area * (self.length / self.along) ** 2 / 24 / (1 + self.poisson)
        load = math.pi**2 * self.young * (inertia + parasitic) / ((0.6992 if self.held_top else 2) * self.length) ** 2
        shear = self.young / (2 * (1 + self.poisson)) * area / 1.2
        return load / (1 + load / shear)

    def scene(self, load, steps, lateral=0.0, start=None):
        half = self.length / 2
        rotate = f"rotate: {{axis: [0, 1, 0], degrees: {self.turn}}}"
        at = [half * math.sin(math.radians(self.turn)), 0, half * math.cos(math.radians(self.turn))]
        size = f"size: [{self.width}, {self.depth}, {half if self.tied else self.length}]"
        elements = f"elements: [{self.across}, {self.across}, {self.along // 2 if self.tied else self.along}]"
        boxes = [f"  - {{box: {{part: low, {size}, {elements}, {rotate}}}}}\n"]
        if self.tied:
            boxes.append(f"  - {{box: {{part: top, {size}, {elements}, {rotate}, at: {at}}}}}\n")
        end = "top_zmax" if self.tied else "low_zmax"
        axis = [math.sin(math.radians(self.turn)), 0, math.cos(math.radians(self.turn))]
        across = [math.cos(math.radians(self.turn)), 0, -math.sin(math.radians(self.turn))]
        if self.width > self.depth:
            across = [0, 1, 0]
        down = [-load * value for value in axis]
        side = [lateral * value for value in across]
        held = f", {{set: {end}, dofs: [x, y]}}" if self.held_top else ""
        elastic = f"young: {self.young}, poisson: {self.poisson}" if self.model == "elastic" else \
            f"bulk: {self.young / 3 / (1 - 2 * self.poisson)}, shear: {self.young / 2 / (1 + self.poisson)}"
        return f"""\
units: none
mesh:
{''.join(boxes)}materials: {{m: {{model: {self.model}, density: 1, {elastic}}}}}
parts: {{low: {{material: m, element: {self.element}}}{', top: {material: m, element: ' + self.element + '}' if self.tied else ''}}}
fixed: [{{set: low_zmin, dofs: [x, y, z]}}{held}]
curves: {{ramp: [[0, 0], {f'[{1 / steps}, {start}], ' if start else ''}[1, 1]], push: [[0, 0], [1.0e-9, 1], [1, 1]]}}
forces: [{{set: {end}, total: {down}, curve: ramp}}{f', {{set: {end}, total: {side}, curve: push}}' if lateral else ''}]
{'contact: [{between: [low, top], method: mortar, tied: true}]' if self.tied else ''}
probes: [{{name: tip, set: {end}, field: displacement}}]
solver: {{scheme: static, step: {1 / steps}}}
run: {{end: 1}}
"""


class Stability(SceneProgram):
    def changes(self, scene, ranks=1, out="out", restart=None, extra=()):
        """What log.txt says of this run."""
        self.write("scene.yaml", scene)
        before = len(self.text(out, "log.txt")) if restart else 0
        self.run_scene(ranks, "scene.yaml", "--out", out, *(("--restart", restart) if restart else ("--force",)), *extra)
        told = self.text(out, "log.txt")
        told = told[before:] if len(told) > before else told
        found = [("lost", *match.groups()) for match in LOST.finditer(told)]
        return found + [("regained", *match.groups()) for match in REGAINED.finditer(told)]

    def test_columns_lose_it_at_the_load_of_their_mesh(self):
        random_ = random.Random(SEED)
        for number in range(COUNT):
            column = Column(random_)
            with self.subTest(number=number, column=vars(column)):
                load, steps = 1.25 * column.euler(), 20
                found = self.changes(column.scene(load, steps, start=0.64))
                self.assertEqual([change[0] for change in found], ["lost"], found)
                low, high = (load * (0.64 + 0.36 * (float(time) - 1 / steps) / (1 - 1 / steps)) for time in found[0][1:3])
                self.assertEqual(found[0][3] == "2", column.width == column.depth)
                # linear strains of hex8_bbar within an element are deviatoric: a quarter of E I with two elements across
                least, most = (0.97, 1.12) if column.element == "hex8_full" else (0.86, 1.03)
                self.assertLess(least, high / column.euler())
                self.assertLess(low / column.euler(), most)
                if not column.held_top:  # deflections by a small lateral force grow as 1/(1 - F/F_mesh)
                    self.assertEqual(self.changes(column.scene(0.95 * low, 8, 1e-5 * load)), [])
                    rows = self.rows("out")[-2:]
                    (w1, f1), (w2, f2) = ((self.sideways(column, row), 0.95 * low * row["time"]) for row in rows)
                    of_mesh = (w2 * f2 - w1 * f1) / (w2 - w1)
                    self.assertLess(0.995 * low, of_mesh)
                    self.assertLess(of_mesh, 1.005 * high)

    @staticmethod
    def sideways(column, row):
        if column.width > column.depth:
            return row["tip.y"]
        turn = math.radians(column.turn)
        return row["tip.x"] * math.cos(turn) - row["tip.z"] * math.sin(turn)

    BAR = """\
units: none
mesh: {box: {part: bar, size: [1, 1, 16], elements: [2, 2, 12]}}
materials: {m: {model: neo_hookean, density: 1, young: 1000, poisson: 0.3}}
parts: {bar: {material: m, element: hex8_bbar}}
fixed: [{set: bar_zmin, dofs: [x, y, z]}]
curves: {there: [[0, 0], [0.5, -0.2], [1, 0]]}
prescribed: [{set: bar_zmax, dof: z, displacement: there}]
solver: {scheme: static, step: 0.05}
run: {end: 1}
"""

    def test_lost_and_regained_are_told_once_on_any_ranks_and_after_a_restart(self):
        first = self.changes(self.BAR)
        self.assertEqual([change[0] for change in first], ["lost", "regained"])
        self.assertAlmostEqual(float(first[0][2]) + float(first[1][1]), 1, delta=1e-9)  # the way back is the way there
        whole = self.summary("out")
        for ranks in of_all((2, 3, 4), (4,)):
            self.assertEqual(self.changes(self.BAR, ranks, "more"), first)
            self.assertEqual(self.summary("more")["state_hash"], whole["state_hash"])
        self.assertEqual(self.changes(self.BAR, 2, "part", extra=("--set", "run.end=0.6"))[0], first[0])
        self.assertEqual(self.changes(self.BAR, 3, "part", restart="part"), first[1:])
        self.assertEqual(self.summary("part")["state_hash"], whole["state_hash"])
        self.assertEqual(self.changes(self.BAR.replace("static,", "static, linear: mumps,"), 2), first)
        self.assertEqual(self.changes(self.BAR.replace("static,", "static, stability: ignore,"), 1), [])
        self.assertEqual(self.summary("out")["state_hash"], whole["state_hash"])
        self.write("scene.yaml", self.BAR.replace("static,", "contact_implicit, stability: warn,"))
        told = self.run_scene(1, "scene.yaml", "--out", "none", code=2)
        self.assertIn("solver.stability: invalid without scheme: static", told)

    PRESSED = """\
units: none
mesh:
  - {box: {part: foot, size: [2, 2, 0.5], elements: [5, 5, 2], at: [-0.5, -0.5, -0.5]}}
  - {box: {part: bar, size: [1, 1, LENGTH], elements: [2, 2, 8]}}
  - {box: {part: cap, size: [1.6, 1.6, 0.4], elements: [3, 3, 1], at: [-0.3, -0.3, LENGTH]}}
materials: {m: {model: neo_hookean, density: 1, young: 1000, poisson: 0.3}, r: {model: rigid, density: 1}}
parts: {foot: {material: m, element: hex8_bbar}, bar: {material: m, element: hex8_bbar}, cap: {material: CAP}}
contact:
  - {between: [foot, bar], method: mortar, friction: 0.5}
  - {between: [cap, bar], method: mortar, tied: true}
SUPPORT
curves: {ramp: [[0, 0], [1, -PRESS]]}
PUSH
solver: {scheme: static, step: 0.1}
run: {end: 1}
"""

    def pressed(self, length, press, cap, wall):
        support = "rigid_walls: [{name: floor, point: [0, 0, -0.5], normal: [0, 0, 1], friction: 0.4, parts: [foot]}]" if wall else \
            "fixed: [{set: foot_zmin, dofs: [x, y, z]}]"
        push = "prescribed: [{set: cap_zmax, dof: z, displacement: ramp}]" if cap == "m" else \
            "prescribed: [{part: cap, dof: z, displacement: ramp}]"
        text = self.PRESSED.replace("LENGTH", str(length)).replace("PRESS", str(press)).replace("CAP", cap + (", element: hex8_bbar" if cap == "m" else ""))
        return text.replace("SUPPORT", support).replace("PUSH", push)

    def test_contact_ties_walls_and_rigid_caps(self):
        for cap in ("m", "r"):
            for wall in (False, True):
                with self.subTest(cap=cap, wall=wall):
                    self.assertEqual(self.changes(self.pressed(1, 0.04, cap, wall)), [])  # stout: stable
                    slender = self.changes(self.pressed(14, 1.4, cap, wall), 2)
                    self.assertEqual([change[0] for change in slender], ["lost"])


if __name__ == "__main__":
    COUNT, SEED = number_asked("--count", COUNT), number_asked("--seed", SEED)
    unittest.main()
