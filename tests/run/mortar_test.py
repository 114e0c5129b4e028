#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Mortar contact as a user runs it: the same bits on any number of ranks and after a restart, energy and momentum of an impact, friction,
ties, what such contact may not ask for. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import csv
import unittest

from run_test import Program, of_all

# A block thrown on another, both free: meshes do not match, and the upper one comes askew and spinning.
IMPACT = """\
units: none
mesh:
  - {box: {part: low, size: [1, 1, 0.5], elements: [3, 3, 2]}}
  - {box: {part: top, size: [0.6, 0.7, 0.5], elements: [2, 4, 2], at: [0.2, 0.1, 0.52]}}
materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}
parts: {low: {material: m, element: hex8_full}, top: {material: m, element: hex8_full}}
initial: [{part: top, velocity: [0.5, 0, -1]}]
contact: [{between: [low, top], method: mortar}]
solver: {scheme: contact_implicit, step: 0.01, tolerance: 1.0e-12}
run: {end: 0.3}
output: {every: 0.05, fields: [displacement, velocity, contact_pressure, gap]}
probes: [{name: low, part: low, field: angular_momentum}, {name: top, part: top, field: angular_momentum}]
"""

# A block that is pressed down and then drawn along another.
DRAWN = """\
units: none
mesh:
  - {box: {part: low, size: [2, 1, 0.5], elements: [8, 3, 2]}}
  - {box: {part: top, size: [0.8, 0.8, 0.4], elements: [3, 4, 2], at: [0.2, 0.1, 0.5]}}
materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}
parts: {low: {material: m, element: hex8_full}, top: {material: m, element: hex8_full}}
fixed: [{set: low_zmin, dofs: [x, y, z]}, {set: top_zmax, dofs: [y]}]
curves: {down: [[0, 0], [0.2, -0.01], [1, -0.01]], along: [[0, 0], [0.2, 0], [1, 0.3]]}
prescribed: [{set: top_zmax, dof: z, displacement: down}, {set: top_zmax, dof: x, displacement: along}]
contact: [{between: [low, top], method: mortar, slave: top, friction: 0.3}]
solver: {scheme: static, step: 0.05}
run: {end: 1}
probes: [{name: hold, set: top_zmax, field: reaction}]
"""


# Two equal elastic bars, end on: reference cases.md A1a, rho c v A of force for 2 L / c.
BARS = """\
units: none
mesh:
  - {box: {part: a, size: [0.1, 0.1, 1], elements: [1, 1, 40]}}
  - {box: {part: b, size: [0.1, 0.1, 1], elements: [1, 1, 40], at: [0, 0, 1]}}
materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}
parts: {a: {material: m, element: hex8_full}, b: {material: m, element: hex8_full}}
initial: [{part: a, velocity: [0, 0, 1.0e-3]}, {part: b, velocity: [0, 0, -1.0e-3]}]
contact: [{between: [a, b], method: mortar}]
solver: {scheme: contact_implicit, step: 0.025, tolerance: 1.0e-12}
run: {end: 3}
probes: [{name: a, part: a, field: momentum}]
"""

# A bar that falls on a finer die, which is held all through.
DIE = """\
units: none
mesh: [{box: {part: die, size: [1, 1, 0.2], elements: [5, 5, 1]}}, {box: {part: bar, size: [0.8, 0.8, 1], elements: [2, 2, 3], at: [0.1, 0.1, 0.22]}}]
materials: {m: {model: neo_hookean, density: 1, young: 1000, poisson: 0.3}}
parts: {die: {material: m, element: hex8_full}, bar: {material: m, element: hex8_full}}
fixed: [{part: die, dofs: [x, y, z]}]
initial: [{part: bar, velocity: [0, 0, -1]}]
contact: [{between: [die, bar], method: mortar}]
probes: [{name: c, contact: [bar, die]}]
solver: {scheme: contact_implicit, step: 0.01}
run: {end: 0.2}
"""

# A block pressed on another, drawn over its end.
SLIDE = """\
units: none
mesh:
  - {box: {part: low, size: [1.5, 1, 0.5], elements: [6, 3, 2]}}
  - {box: {part: top, size: [0.8, 0.8, 0.4], elements: [4, 4, 2], at: [0.6, 0.1, 0.5]}}
materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}
parts: {low: {material: m, element: hex8_full}, top: {material: m, element: hex8_full}}
fixed: [{set: low_zmin, dofs: [x, y, z]}, {set: top_zmax, dofs: [y]}]
curves: {down: [[0, 0], [0.1, -0.01], [1, -0.01]], along: [[0, 0], [0.1, 0], [1, 0.5]]}
prescribed: [{set: top_zmax, dof: z, displacement: down}, {set: top_zmax, dof: x, displacement: along}]
contact: [{between: [low, top], method: mortar, slave: top}]
solver: {scheme: static, step: 0.02}
run: {end: 1}
probes: [{name: hold, set: top_zmax, field: reaction}]
"""

# A block on another, drawn down and aside by dead loads of .5 and .1.
REST = """\
units: none
mesh:
  - {box: {part: low, size: [1, 1, 0.5], elements: [3, 3, 2]}}
  - {box: {part: top, size: [0.5, 1, 0.5], elements: [2, 4, 2], at: [0.2, 0, 0.5]}}
materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}
parts: {low: {material: m, element: hex8_full}, top: {material: m, element: hex8_full}}
fixed: [{set: low_zmin, dofs: [x, y, z]}]
traction: [{set: top_zmax, value: [0.2, 0, -1]}]
contact: [{between: [low, top], method: mortar, friction: 0.5}]
solver: {scheme: static, step: 0.5}
run: {end: 1}
probes: [{name: foot, set: low_zmin, field: reaction}]
"""

# A tie of which the slave, the finer side, is driven as a whole; a dead load of .5 hangs on the master.
DRIVEN = """\
units: none
mesh:
  - {box: {part: low, size: [1, 1, 0.5], elements: [3, 3, 2]}}
  - {box: {part: top, size: [1, 1, 0.5], elements: [4, 3, 1], at: [0, 0, 0.5]}}
materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}
parts: {low: {material: m, element: hex8_full}, top: {material: m, element: hex8_full}}
sets: {whole: {part: top, box: [[0, 0, 0.5], [1, 1, 1]]}}
curves: {ramp: [[0, 0], [1, 0.01]]}
fixed: [{set: whole, dofs: [y]}]
prescribed: [{set: whole, dof: z, displacement: ramp}, {set: whole, dof: x, displacement: ramp, scale: 2}]
traction: [{set: low_zmin, value: [0, 0, -0.5]}]
contact: [{between: [low, top], method: mortar, tied: true, slave: top}]
solver: {scheme: static, step: 0.5}
run: {end: 1}
probes: [{name: end, set: low_zmin, field: displacement}, {name: hold, set: whole, field: reaction}]
"""


class Mortar(Program):
    def rows(self, result):
        return list(csv.DictReader(self.text(result, "history.csv").splitlines()))

    def test_an_impact_on_any_number_of_ranks(self):
        self.write("impact.yaml", IMPACT)
        for ranks in of_all((1, 2, 3, 4), (1, 3)):
            self.run_scene(ranks, "impact.yaml", "--out", f"out{ranks}")
        first = self.summary("out1")
        for ranks in of_all((2, 3, 4), (3,)):
            self.assertEqual(self.summary(f"out{ranks}")["state_hash"], first["state_hash"])
            self.assertEqual(self.summary(f"out{ranks}")["contact"]["steps"], first["contact"]["steps"])
            self.assertEqual(self.text(f"out{ranks}", "history.csv"), self.text("out1", "history.csv"))
        self.assertLess(first["momentum_error"], 1e-11)
        self.assertLess(first["energy"]["error_ratio"], 1e-11)
        rows = self.rows("out1")
        start = float(rows[0]["kinetic [1]"])
        contact = [float(row["contact [1]"]) for row in rows]
        self.assertGreater(max(int(row["active_contacts"]) for row in rows), 5)
        self.assertGreater(contact[-1], 1e-3 * start)  # the impacting layer's share
        # a step may give back, up to what contact has taken before
        self.assertGreaterEqual(min(contact), 0)
        self.assertLess(max(float(row["kinetic [1]"]) + float(row["internal [1]"]) for row in rows), (1 + 1e-12) * start)
        self.assertEqual(int(rows[-1]["active_contacts"]), 0)
        # what slides goes along chords; half of that is taken back in each step
        self.assertLess(max(float(row["max_penetration [1]"]) for row in rows), 1e-3)

    def test_restart_in_contact_and_friction(self):
        for name, text, end in (("impact.yaml", IMPACT, 0.1), ("drawn.yaml", DRAWN, 0.5)):
            self.write(name, text)
            self.run_scene(1, name, "--out", "whole", "--force")
            self.run_scene(2, name, "--out", "part", "--force", "--set", f"run.end={end}")
            self.assertGreater(self.summary("part")["contact"]["active"], 3)
            self.run_scene(3, name, "--out", "part", "--restart", "part")
            self.assertEqual(self.summary("part")["state_hash"], self.summary("whole")["state_hash"])
            self.assertEqual(self.text("part", "history.csv"), self.text("whole", "history.csv"))

    def test_the_spin_that_contact_adds_is_told_and_of_first_order(self):
        self.write("impact.yaml", IMPACT)
        told, drift = [], []
        for step in (0.01, 0.005):
            self.run_scene(1, "impact.yaml", "--out", "out", "--force", "--set", f"solver.step={step}")
            rows = self.rows("out")
            spin = [sum(float(row[f"{part}.{axis} [1.1]"]) for part in ("low", "top")) for row in (rows[0], rows[-1]) for axis in "xyz"]
            drift.append(sum((b - a) ** 2 for a, b in zip(spin[:3], spin[3:])) ** 0.5)
            told.append(self.summary("out")["angular_momentum_error"])
        self.assertGreater(drift[0], 1e-5)
        self.assertAlmostEqual(drift[1] / drift[0], 0.5, delta=0.1)  # notes-mortar.md, section 8
        # the bodies themselves turn by what the trapezoidal rule leaves, of second order: some 1 % of the drift here
        self.assertAlmostEqual(told[1] / told[0] / (drift[1] / drift[0]), 1, delta=0.05)

    def test_bars_meet_with_the_force_of_the_theory(self):
        self.write("bars.yaml", BARS)
        for step in (0.025, 0.00625):  # h/c, a quarter of it
            self.run_scene(1, "bars.yaml", "--out", "out", "--force", "--set", f"solver.step={step}")
            rows = self.rows("out")
            momentum = [(float(row["time [1]"]), float(row["a.z [1]"])) for row in rows if 0.2 <= float(row["time [1]"]) <= 1.8]
            force = (momentum[0][1] - momentum[-1][1]) / (momentum[-1][0] - momentum[0][0])
            self.assertAlmostEqual(force / (1e-3 * 0.01), 1, delta=0.01)
            impulse = float(rows[0]["a.z [1]"]) - float(rows[-1]["a.z [1]"])
            self.assertAlmostEqual(impulse / (2 * 0.01 * 1e-3), 1, delta=0.02)  # the rest is vibration behind the front
            start = float(rows[0]["total [1]"])
            self.assertLess(max(float(row["total [1]"]) for row in rows), (1 + 1e-12) * start)
            self.assertEqual(int(rows[-1]["active_contacts"]), 0)

    def test_friction_is_coulombs(self):
        self.write("drawn.yaml", DRAWN)
        self.run_scene(1, "drawn.yaml", "--out", "out")
        last = self.rows("out")[-1]  # slides since long: the supports feel the coefficient times the pressure
        down, along = -float(last["hold.z [1]"]), float(last["hold.x [1]"])
        self.assertGreater(down, 0.1)
        self.assertAlmostEqual(along / down, 0.3, delta=0.003)
        self.assertGreater(float(last["friction [1]"]), 0.5 * along * 0.2)
        self.assertLess(self.summary("out")["energy"]["error_ratio"], 0.02)

    def slid(self, travel, step):
        """The block drawn until its facets' edges have gone by `travel` over the end of the lower block."""
        self.write("slide.yaml", SLIDE)
        self.run_scene(1, "slide.yaml", "--out", "slide", "--force", "--set", f"curves.along=[[0, 0], [0.1, 0], [1, {travel!r}]]",
                       "--set", f"solver.step={step}", "--set", f"solver.min_step={step}")
        return self.rows("slide")

    def test_sliding_over_a_rim(self):
        # M3: three of the upper block's four facets in a row leave the lower block one after the other
        rows = self.slid(0.6, 0.02)
        force = [-float(row["hold.z [1]"]) for row in rows[7:]]  # pressed since t = .1
        steps = self.summary("slide")["implicit"]["newton"]["steps"]
        self.assertEqual(self.summary("slide")["implicit"]["halved"], 0)
        self.assertLessEqual(max(len(step["residuals"]) - 1 for step in steps), 8)
        self.assertLess(force[-1], 0.6 * force[0])  # .8 in length lies on the lower block at the start, .3 at the end
        for before, after in zip(force, force[1:]):
            self.assertLess(after, before * (1 + 1e-9))  # less is covered in every step, and no facet jumps
            self.assertGreater(after, 0.9 * before)
        # a facet's edge passes the rim at .3: the force goes on without a jump
        size = 1e-6
        less, more = (-float(self.slid(0.3 + side * size / 2, 0.1)[-1]["hold.z [1]"]) for side in (-1, 1))
        self.assertLess(abs(more - less), 1e-5 * less)
        self.assertGreater(abs(more - less), 1e-8 * less)

    def test_a_body_that_contact_alone_holds(self):
        # a block that lies on another under its dead weight: a penalty holds it down, friction sideways
        self.write("rest.yaml", REST)
        for contact in ("enforce: penalty, friction: 0.5", "friction: 0.5", "enforce: penalty, friction: 0.5, slave: second"):
            self.write("rest.yaml", REST.replace("friction: 0.5", contact))
            self.run_scene(1, "rest.yaml", "--out", "out", "--force")
            last = self.rows("out")[-1]
            self.assertAlmostEqual(float(last["foot.z [1]"]), 0.5, delta=1e-9)
            self.assertAlmostEqual(float(last["foot.x [1]"]), -0.1, delta=1e-9)
        self.write("rest.yaml", REST.replace("friction: 0.5", "enforce: penalty"))  # nothing holds it sideways
        self.assertIn("can move freely", self.run_scene(1, "rest.yaml", "--out", "out", "--force", code=3))

    def test_a_driven_slave_draws_its_tied_master(self):
        # all nodes of the slave are prescribed; the master hangs on it
        self.write("driven.yaml", DRIVEN)
        self.run_scene(1, "driven.yaml", "--out", "out")
        last = self.rows("out")[-1]
        self.assertAlmostEqual(float(last["hold.z [1]"]), 0.5, delta=1e-9)
        self.assertAlmostEqual(float(last["end.x [1]"]), 0.02, delta=1e-4)
        # the load stretches the lower block by stress / E times its height, less what the held upper face keeps from narrowing
        self.assertAlmostEqual(0.01 - float(last["end.z [1]"]), 0.5 / 100 * 0.5, delta=0.5e-3)

    def test_a_die_that_is_held_is_the_master(self):
        self.write("scene.yaml", DIE)
        self.run_scene(1, "scene.yaml", "--out", "out")
        rows = self.text("out", "history.csv").splitlines()
        names = [name.split(" [")[0] for name in rows[0].split(",")]
        values = [dict(zip(names, map(float, row.split(",")))) for row in rows[1:]]
        self.assertGreater(max(row["c.z"] for row in values), 10)
        start, end = values[0]["momentum_z"], values[-1]["momentum_z"]
        self.assertLess(end / start, -0.7)
        pushed = sum(row["c.z"] * (row["time"] - before["time"]) for before, row in zip(values, values[1:]))
        self.assertAlmostEqual(pushed, end - start, delta=1e-9 * abs(start))
        self.assertLess(self.summary("out")["energy"]["error_ratio"], 1e-10)
        self.write("scene.yaml", DIE.replace("mortar}", "mortar, initial_overlap: offset}"))
        self.assertIn("initial_overlap: invalid initial_overlap: offset in an implicit scene", self.run_scene(1, "scene.yaml", "--out", "off", code=2))

    def test_redundant_multipliers_are_told(self):
        # nodes of planes of symmetry on both sides of a tie
        self.write("tie.yaml", DRIVEN.replace("prescribed:", "symmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}]\nprescribed:")
                   .replace(", {set: whole, dof: x, displacement: ramp, scale: 2}", ""))
        self.run_scene(1, "tie.yaml", "--out", "out")
        self.assertIn("of 20 tied nodes have no multiplier in directions that supports constrain on both sides", self.text("out", "log.txt"))

    def test_newmark_that_makes_energy_is_stopped(self):
        self.write("bars.yaml", BARS)
        told = self.run_scene(1, "bars.yaml", "--out", "out", "--set", "solver.scheme=newmark", "--set", "solver.step=0.0125", code=3)
        self.assertIn("use scheme: contact_implicit", told)

    def test_ties_carry_tension(self):
        # two halves of a bar of one material, pulled: the stress is that of a whole bar
        text = IMPACT.split("initial:")[0].replace("size: [0.6, 0.7, 0.5]", "size: [1, 1, 0.5]").replace("at: [0.2, 0.1, 0.52]", "at: [0, 0, 0.5]")
        self.write("tie.yaml", text + """\
symmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}, {point: [0, 0, 0], normal: [0, 1, 0]}]
fixed: [{set: low_zmin, dofs: [z]}]
traction: [{set: top_zmax, value: [0, 0, 5]}]
contact: [{between: [low, top], method: mortar, tied: true}]
solver: {scheme: static, step: 1, tolerance: 1.0e-12}
run: {end: 1}
output: {every: 1, fields: [stress]}
probes: [{name: end, set: top_zmax, field: displacement}, {name: foot, set: low_zmin, field: reaction}]
""")
        for ranks in (1, 2):
            self.run_scene(ranks, "tie.yaml", "--out", f"out{ranks}")
        self.assertEqual(self.summary("out2")["state_hash"], self.summary("out1")["state_hash"])
        # neo-Hooke, free sides: nominal stress 5 of E = 100, by bisection of the two equations
        mu, lame = 100 / 2.6, 100 * 0.3 / (1.3 * 0.4)
        from math import log

        def side(stretch):  # lateral stretch without lateral stress
            low, high = 0.5, 1.5
            for _ in range(200):
                mid = 0.5 * (low + high)
                stress = mu * (mid - 1 / mid) + lame * log(stretch * mid * mid) / mid
                low, high = (mid, high) if stress < 0 else (low, mid)
            return mid

        low, high = 1.0, 1.2
        for _ in range(200):
            mid = 0.5 * (low + high)
            nominal = mu * (mid - 1 / mid) + lame * log(mid * side(mid) ** 2) / mid
            low, high = (mid, high) if nominal < 5 else (low, mid)
        self.assertAlmostEqual(float(self.rows("out1")[-1]["end.z [1]"]), mid - 1, delta=1e-9)

    def test_what_mortar_contact_may_not_ask_for(self):
        wrong = {
            "between: [low, top], method: mortar": {
                "between: all, method: mortar": "invalid between for method: mortar",
                "between: [low, low], method: mortar, slave: low": "contact.0.slave: invalid for a part with itself",
                "between: [low, low], method: mortar, initial_overlap: warn": "contact.0.initial_overlap: invalid for method: mortar of a part with itself",
                "between: [low, low], method: mortar, tied: true": "contact.0.tied: invalid tied: a part cannot be tied to itself",
                "between: [low, top]": "contact.0: invalid contact in an implicit scene",
                "between: [low, top], method: mortar, friction: -1": "contact.0.friction: out of range: -1; expected a number >= 0",
                "between: [low, top], method: mortar, softness: 0.1": "contact.0.softness: invalid with method: mortar",
                "between: [low, top], method: mortar, multiplier: quad": "contact.0.multiplier: unknown value 'quad'",
                "between: [low, top], method: rate, multiplier: dual": "contact.0.multiplier: invalid without method: mortar",
                "between: [low, top], method: rate, consistent: true": "contact.0.consistent: invalid without method: mortar",
                "between: [low, top], method: mortar, consistent: exact": "contact.0.consistent: invalid value 'exact'; expected true or false",
                "between: [low, top], method: mortar, consistent: true": "contact.0.consistent: invalid without scheme: static",
                "between: [low, top], method: rate, edges: true": "contact.0.edges: invalid without method: mortar",
                "between: [low, top], method: mortar, edges: sharp": "contact.0.edges: invalid value 'sharp'; expected true or false",
                "between: [low, top], method: mortar, tied: true, edges: true": "contact.0.edges: invalid with tied: true",
                "between: [low, top], method: mortar, tied: true, consistent: true": "contact.0.consistent: invalid with tied: true",
            },
            "solver: {scheme: contact_implicit, step: 0.01, tolerance: 1.0e-12}": {
                "solver: explicit": "contact.0.method: invalid method: mortar contact exists in implicit scenes only"},
            "initial:": {"fixed: [{part: low, dofs: [x, y, z]}, {part: top, dofs: [x, y, z]}]\ninitial:":
                         "wrong.yaml:9: contact.0: invalid pair: all surface nodes of top and low are constrained"},
            "at: [0.2, 0.1, 0.52]": {"at: [0.2, 0.1, 0.42]": "wrong.yaml:8: contact.0: initial overlap: node 42 of part 'low' lies 0.08 inside part 'top'"},
        }
        for old, changes in wrong.items():
            for new, message in changes.items():
                self.write("wrong.yaml", IMPACT.replace(old, new).replace("element: hex8_full", "element: hex8_full"))
                told = self.run_scene(1, "wrong.yaml", "--out", "wrong", code=2)
                self.assertIn(message, told)


if __name__ == "__main__":
    unittest.main()
