#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Hard implicit cases of motion: long steps, mass ratios, coincident meshes, friction at its limit, rigid bodies between walls, tied pairs
that turn. Criteria: tests/hard/IMPLICIT.md. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import math
import unittest

from implicit_hard import WORSE, HardCase, of_all

import hard_scenes

SOLVER = "solver: {{scheme: contact_implicit, step: {}}}\n"


class Motion(HardCase):
    THROWN = """\
units: mm-ms-kg
mesh:
  - {box: {part: a, size: [10, 10, THICK], elements: [4, 4, LAYERS], at: [0, 0, -THICK]}}
  - {box: {part: b, size: [6, 6, 4], elements: [4, 4, 2], at: [2, 2, 0.05]}}
materials: {m: {model: elastic, density: 7.85e-6, young: 210, poisson: 0.3}}
parts: {a: {material: m, element: hex8_full}, b: {material: m, element: hex8_full}}
initial: [{part: b, velocity: [0, 0, -SPEED]}]
HELD
contact: [{between: [a, b], method: mortar}]
probes: [{name: a, part: a, field: position}, {name: b, part: b, field: position}, {name: v, part: b, field: velocity}]
solver: SOLVER
run: {end: END}
"""

    def test_nothing_passes_in_long_steps(self):
        """A block at 1 to 100 m/s, with steps that move it by a third of an element to 2.5 elements and more; a plate that is held, and one that is free."""
        cases = ((4, 2, 100, "implicit", 5, True), (4, 2, 100, "{step: 0.01}", 0.3, True), (0.5, 1, 100, "{step: 0.05}", 0.5, False), (0.5, 1, 10, "{step: 0.2}", 2, False),
                 (0.1, 1, 1, "{step: 1}", 10, False))
        for thick, layers, speed, solver, end, held in of_all(cases, cases[::2]):
            with self.subTest(thick=thick, speed=speed, solver=solver, held=held):
                text = self.THROWN.replace("THICK", str(thick)).replace("LAYERS", str(layers)).replace("SPEED", str(speed)).replace("SOLVER", solver).replace(
                    "END", str(end)).replace("HELD", "fixed: [{set: a_zmin, dofs: [x, y, z]}]" if held else "")
                rows, told = self.judged(text, code=(0, 3))
                for row in rows:
                    self.assertGreater(row["b.z"] - row["a.z"], 0.5 * (thick + 4) - 0.1 * thick, row["time"])
                self.assertLess(abs(rows[-1]["v.z"]), 1.01 * speed)
                if not held:
                    self.assertLess(self.summary("out")["momentum_error"], 1e-10)
                self.assertEqual(told, "")

    STRIP = """\
units: mm-ms-kg
mesh:
  - {box: {part: a, size: [20, 10, 0.5], elements: [8, 4, 2]}}
  - {box: {part: b, size: [6, 6, 0.5], elements: [3, 3, 2], at: [7, 2, 1.5]}}
materials: {m: {model: neo_hookean, density: 1.1e-6, bulk: 0.1, shear: 0.001}}
parts: {a: {material: m, element: hex8_full}, b: {material: m, element: hex8_full}}
curves: {d: [[0, 0], [1, -20]]}
prescribed: [{set: b_zmax, dof: z, displacement: d}]
fixed: [{set: a_xmin, dofs: [x, y, z]}, {set: a_xmax, dofs: [x, y, z]}, {set: b_zmax, dofs: [x, y]}]
contact: [{between: [a, b], method: mortar}]
probes: [{name: a, near: [10, 5, 0.25], part: a, field: position}, {name: b, near: [10, 5, 1.75], part: b, field: position}]
solver: {scheme: static, step: STEP}
run: {end: 1}
"""

    def test_a_strip_does_not_pass_a_plate_in_static_steps(self):
        for step in (1, 0.1):
            with self.subTest(step=step):
                rows, _ = self.judged(self.STRIP.replace("STEP", str(step)), code=(0, 3), missed={"nodes": 0.372, "edges": 0.496, "given": 0.026})
                for row in rows:
                    self.assertGreater(row["b.z"] - row["a.z"], 0.3, row["time"])

    def test_masses_a_million_apart(self):
        """The criteria of E1 (mass_ratio_test)."""
        base = hard_scenes.BY_DENSITY.replace("heavy: {material: h}, light: {material: l}", "heavy: {material: h, element: hex8_full}, light: {material: l, element: hex8_full}")
        size = hard_scenes.BY_SIZE.replace("heavy: {material: h}, light: {material: l}", "heavy: {material: h, element: hex8_full}, light: {material: l, element: hex8_full}")
        for text, side, speed, step, heavy in ((base, 1, 1, 5e-6, True), (base.replace("part: heavy, velocity: [0, 0, 1", "part: light, velocity: [0, 0, -1"), 1, 1, 5e-6, False),
                                               (size, 0.01, math.sqrt(2 * 9.81 * 0.1), 1e-6, True)):
            with self.subTest(heavy=heavy, side=side):
                text = text.replace("contact: [{between: all}]", "contact: [{between: [heavy, light], method: mortar}]\nprobes: [{name: l, part: light, field: velocity}]")
                rows = self.judged(text.split("history:")[0] + SOLVER.format(step))
                self.assertGreater(max(row["active_contacts"] for row in rows), 0)
                self.assertEqual(rows[-1]["active_contacts"], 0)
                self.assertLessEqual(max(abs(row["l.z"]) for row in rows), (2.01 if heavy else 1.01) * speed)
                self.assertGreaterEqual(abs(rows[-1]["l.z"]), (1 if heavy else 0.1) * speed)
                self.assertLess(self.summary("out")["momentum_error"], 1e-10)

    def test_coincident_meshes_meet_as_at_a_mirror(self):
        text = """\
units: none
mesh:
  - {box: {part: a, size: [1, 1, 1], elements: [3, 3, 3], at: [0, 0, -1.001]}}
  - {box: {part: b, size: [1, 1, 1], elements: [3, 3, 3], at: [0, 0, 0.001]}}
materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}
parts: {a: {material: m, element: hex8_full}, b: {material: m, element: hex8_full}}
initial: [{part: a, velocity: [0, 0, 0.5]}, {part: b, velocity: [0, 0, -0.5]}]
contact: [{between: [a, b], method: mortarMORE}]
probes: [{name: a, part: a, field: velocity}, {name: b, part: b, field: velocity}, {name: pa, near: [1, 1, -0.001], part: a, field: displacement}, {name: pb, near: [1, 1, 0.001], part: b, field: displacement}]
run: {end: 0.8}
""" + SOLVER.format(0.01)
        cases = (("", 6.8e-6), (", slave: a", 6.8e-6), (", friction: 0.3", 4.7e-6))  # criterion 1e-8
        for more, apart in of_all(cases, cases[1:]):
            with self.subTest(more=more):
                rows = self.judged(text.replace("MORE", more))
                self.assertEqual(rows[-1]["active_contacts"], 0)
                self.assertGreater(rows[-1]["b.z"], 0.1)
                for row in rows:
                    self.assertLess(abs(row["a.z"] + row["b.z"]), 1e-10)
                    for axis, sign in (("x", -1), ("y", -1), ("z", 1)):
                        self.assertAlmostEqual(row[f"pa.{axis}"] + sign * row[f"pb.{axis}"], 0, delta=WORSE * apart)
                self.assertLess(self.summary("out")["momentum_error"], 1e-10)
        self.same_bits(text.replace("MORE", ", friction: 0.3"))

    LIMIT = """\
units: none
mesh:
  - {box: {part: plate, size: [3, 1.2, 0.2], elements: [9, 4, 1], at: [-0.1, -0.1, -0.2]}}
  - {box: {part: block, size: [1, 1, 0.2], elements: [4, 4, 1], at: [0.1, 0, 0]}}
materials: {m: {model: neo_hookean, density: 1, young: 1.0e4, poisson: 0.3}}
parts: {plate: {material: m, element: hex8_full}, block: {material: m, element: hex8_full}}
fixed: [{set: plate_zmin, dofs: [x, y, z]}, {set: plate_zmax, dofs: [y]}]
curves: {press: [[0, 0.1], [0.5, 1]], pull: [[0, 0], [0.5, 0], [1, 1], [2, 1]]}
traction: [{set: block_zmax, value: [0, 0, -1], curve: press}]
gravity: {vector: [PULL, 0, 0], curve: pull}
contact: [{between: [block, plate], method: mortar, friction: 0.3}]
probes: [{name: c, contact: [block, plate]}, {name: d, part: block, field: displacement}, {name: v, part: block, field: velocity}]
solver: {scheme: SCHEME, step: 0.05}
run: {end: 2}
"""

    def limit(self, share, scheme, code=0):
        """A block under a traction is pulled by a body force of so much of what friction holds."""
        return self.judged(self.LIMIT.replace("PULL", str(0.3 * 1 / 0.2 * share)).replace("SCHEME", scheme), code=code)

    def test_friction_below_its_limit_holds(self):
        shares = (0.5, 0.9, 0.99)
        for share, scheme in of_all([(share, scheme) for scheme in ("static", "contact_implicit") for share in shares], [(0.99, "static"), (0.5, "contact_implicit")]):
            with self.subTest(share=share, scheme=scheme):
                rows = self.limit(share, scheme)
                self.assertAlmostEqual(rows[-1]["c.x"] / (-0.3 * share), 1, delta=1e-6 if scheme == "static" else 1e-2)
                self.assertLess(max(abs(row["d.x"]) for row in rows), 1e-3 * 0.25)

    def test_friction_above_its_limit_slides(self):
        told = self.limit(1.01, "static", code=(0, 3))[1]
        self.assertIn("stopped", told)
        rows = self.limit(1.2, "contact_implicit")
        a, b = [row for row in rows if row["time"] > 1.2][0], rows[-1]
        self.assertAlmostEqual((b["v.x"] - a["v.x"]) / (b["time"] - a["time"]) / (0.2 * 0.3 / 0.2), 1, delta=0.01)

    WALLS = """\
units: none
mesh:
  - {box: {part: r, size: [1, 1, 1], elements: [2, 2, 2], rotate: {axis: [1, 2, 0.5], degrees: TURN}, at: [0.3, 0.2, 1]}}
materials: {r: {model: rigid, density: 1}}
parts: {r: {material: r}}
rigid_walls: [{name: low, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.3}, {name: top, point: [0, 0, 4], normal: [0, 0, -1], friction: 0.3}]
initial: [{part: r, velocity: [0.2, 0, -1]}]
probes: [{name: r, part: r, field: position}]
run: {end: 20}
""" + SOLVER.format("STEP")

    def test_a_rigid_body_between_walls(self):
        cases = ((0, 0.02, WORSE * 0.0154), (20, 0.02, WORSE * 0.0293), (20, 0.2, WORSE * 0.238))  # criterion 1e-2
        for turn, step, depth in of_all(cases, cases[::2]):
            with self.subTest(turn=turn, step=step):
                rows = self.judged(self.WALLS.replace("TURN", str(turn)).replace("STEP", str(step)))
                self.assertLessEqual(self.summary("out")["max_penetration"], depth * 0.5)
                for row in rows:
                    self.assertGreater(row["walls"] + row["friction"], -1e-3 * rows[0]["kinetic"])
                    self.assertLess(row["kinetic"], 1.001 * rows[0]["kinetic"])

    DRIVEN = """\
units: none
mesh:
  - {box: {part: r, size: [1, 1, 1], elements: [2, 2, 2], at: [0, 0, 1.5]}}
  - {box: {part: soft, size: [0.8, 0.8, 1], elements: [3, 3, 3], at: [0.1, 0.1, 0.2]}}
materials: {r: {model: rigid, density: 1}, m: {model: neo_hookean, density: 1, young: 10, poisson: 0.3}}
parts: {r: {material: r}, soft: {material: m, element: hex8_full}}
rigid_walls: [{name: low, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.3}]
curves: {down: [[0, 0], [4, -STROKE], [6, -STROKE]]}
fixed: [{part: r, dofs: [x, y, rx, ry, rz]}]
prescribed: [{part: r, dof: z, displacement: down}]
contact: [{between: [r, soft], method: mortar, friction: 0.3}]
probes: [{name: low, wall: low}, {name: r, part: r, field: reaction}, {name: c, contact: [soft, r]}]
run: {end: 6}
""" + SOLVER.format(0.02)

    def test_a_driven_rigid_body_presses_a_free_one_against_a_wall(self):
        """The soft body falls to none: it is pushed on the wall and pressed to 4/5; when all rests, wall and drive have the same force."""
        rows = self.judged(self.DRIVEN.replace("STROKE", "0.7"))
        last = [row for row in rows if row["time"] > 5]
        wall, drive = (sum(row[name] for row in last) / len(last) for name in ("low.z", "c.z"))
        self.assertGreater(wall, 0.8)
        self.assertAlmostEqual(wall / -drive, 1, delta=WORSE * 0.0268)  # criterion 0.02
        self.assertLessEqual(self.summary("out")["max_penetration"], 1e-2 * 0.5)

    def test_a_rigid_body_that_is_driven_into_a_wall_is_told(self):
        text = self.WALLS.replace("TURN", "0").replace("STEP", "0.02").replace("initial: [{part: r, velocity: [0.2, 0, -1]}]", "prescribed: [{part: r, dof: z, velocity: -1}]").replace("end: 20", "end: 1.5")
        self.write("scene.yaml", text)
        told = self.run_scene(1, "scene.yaml", "--out", "out", "--force", code=(0, 3))
        log = self.text("out", "log.txt")
        self.assertTrue("stopped" in told or ("of an element behind a rigid wall" in log and "and to a prescribed motion: drive it less far" in log), told)

    def test_a_rigid_body_that_cannot_turn_is_driven_through_a_wall(self):
        """The depth is what the motion says; no smaller step would help."""
        text = self.WALLS.replace("TURN", "0").replace("STEP", "0.02").replace("initial: [{part: r, velocity: [0.2, 0, -1]}]", "prescribed: [{part: r, dof: z, velocity: -1}]\nfixed: [{part: r, dofs: [rx, ry, rz]}]").replace("end: 20", "end: 1.5")
        rows = self.go(text)
        log, summary = self.text("out", "log.txt"), self.summary("out")
        self.assertIn("supports move part 'r' and rigid wall", log)
        self.assertNotIn("use a smaller solver.step", log)
        self.assertGreater(summary["driven_penetration"], 0.1)
        self.assertAlmostEqual(summary["driven_penetration"], summary["max_penetration"], delta=1e-9)
        self.assertEqual(rows[-1]["time"], 1.5)

    SPIN = """\
units: none
mesh:
  - {box: {part: a, size: [1, 1, 1], elements: [2, 2, 2]}}
  - {box: {part: b, size: [1, 1, 1], elements: [3, 3, 2], at: [0.1, 0.05, GAP]}}
materials: {m: {model: neo_hookean, density: 1, young: 1000, poisson: 0.3}}
parts: {a: {material: m, element: hex8_full}, b: {material: m, element: hex8_full}}
initial: [{part: a, rotation: {axis: [0.3, 1, 0.2], point: [0.5, 0.5, 1], rate: 1}}, {part: b, rotation: {axis: [0.3, 1, 0.2], point: [0.5, 0.5, 1], rate: 1}}]
contact: [{between: [a, b], method: mortar, tied: true}]
run: {end: 12.6}
""" + SOLVER.format(0.1)

    def test_a_tied_pair_spins_twice(self):
        for gap in (1.0, 1.05):
            with self.subTest(gap=gap):
                rows = self.go(self.SPIN.replace("GAP", str(gap)))
                for row in rows:
                    self.assertLess(abs(row["total"] / rows[0]["total"] - 1), 1e-9)
                    self.assertLess(abs(row["contact"]), 1e-9 * rows[0]["total"])
                self.assertLess(self.summary("out")["angular_momentum_error"], 1e-10)
                self.assertLess(self.summary("out")["momentum_error"], 1e-10)

    TURNED = """\
units: none
mesh:
  - {box: {part: hub, size: [1, 1, 1], elements: [2, 2, 2]}}
  - {box: {part: arm, size: [2, 0.8, 0.8], elements: [4, 3, 3], at: [GAP, 0.1, 0.1]}}
materials: {r: {model: rigid, density: 1}, m: {model: neo_hookean, density: 1, young: 1000, poisson: 0.3}}
parts: {hub: {material: r}, arm: {material: m, element: hex8_full}}
curves: {turn: [[0, 0], [1, 6.283185307179586]]}
fixed: [{part: hub, dofs: [x, y, z, rx, ry]}]
prescribed: [{part: hub, dof: rz, displacement: turn}]
contact: [{between: [hub, arm], method: mortar, tied: true}]
probes: [{name: tip, near: [3, 0.9, 0.9], part: arm, field: displacement}, {name: m, part: hub, field: reaction_moment}]
solver: {scheme: static, step: 0.025}
run: {end: 1}
"""

    def test_a_tied_arm_is_turned_once_round(self):
        for gap in (1.0, 1.05):
            with self.subTest(gap=gap):
                rows = self.go(self.TURNED.replace("GAP", str(gap)))
                for row in rows:
                    self.assertLess(abs(row["internal"]), 1e-9 * 1000)
                    self.assertLess(max(abs(row[f"m.{axis}"]) for axis in "xyz"), 1e-8 * 1000)
                self.assertLess(max(abs(rows[-1][f"tip.{axis}"]) for axis in "xyz"), 1e-8)


if __name__ == "__main__":
    unittest.main()
