#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Implicit scenes as a user runs them: the same bits on any number of ranks and after a restart, a parallel solver that agrees, steps that
are halved, bodies that float, what such scenes may not ask for. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import csv
import glob
import os
import unittest

from run_test import Program, of_all

# Hexahedra and tetrahedra-free: a block of two parts that share nodes' places only by a gap, under pressure, weight and a drive.
BENT = """\
units: none
mesh: {box: {part: bar, size: [1, 1, 4], elements: [3, 2, 8]}}
materials: {m: {model: MODEL, density: 2, young: 100, poisson: 0.3YIELD}}
parts: {bar: {material: m, element: hex8_full}}
fixed: [{set: bar_zmin, dofs: [x, y, z]}]
sets: {corner: {part: bar, box: [[0, 0, 4], [0, 0, 4]]}}
curves: {ramp: [[0, 0], [1, 1]], pull: [[0, 0], [1, 0.3]]}
pressure: [{set: bar_xmax, value: 0.3, curve: ramp}]
prescribed: [{set: corner, dof: y, displacement: pull}]
gravity: {vector: [0, 0, -0.1]}
solver: {scheme: SCHEME, step: 0.1}
run: {end: 1}
output: {every: 0.5, fields: [displacement, velocity, stress]}
probes: [{name: foot, set: bar_zmin, field: reaction}, {name: tip, near: [1, 1, 4], field: displacement}]
"""


def scene(model="neo_hookean", scheme="contact_implicit", step="0.1"):
    text = BENT.replace("MODEL", model).replace("SCHEME", scheme).replace("step: 0.1", f"step: {step}")
    return text.replace("YIELD", ", yield: 3, hardening: 10" if model == "j2" else "")


class Implicit(Program):
    def rows(self, result):
        return list(csv.DictReader(self.text(result, "history.csv").splitlines()))

    def test_same_bits_on_any_number_of_ranks(self):
        for model, scheme in (("neo_hookean", "contact_implicit"), ("j2", "static"), ("j2", "hht")):
            self.write("bent.yaml", scene(model, scheme))
            for ranks in of_all((1, 2, 3, 4), (1, 3)):
                self.run_scene(ranks, "bent.yaml", "--out", f"out{ranks}", "--force")
            first = self.summary("out1")
            self.assertGreaterEqual(first["steps"], 10)
            self.assertGreater(first["implicit"]["iterations_mean"], 1.5)
            self.assertLess(first["momentum_error"], 1e-9)
            for ranks in of_all((2, 3, 4), (3,)):
                self.assertEqual(self.summary(f"out{ranks}")["state_hash"], first["state_hash"])
                self.assertEqual(self.text(f"out{ranks}", "history.csv"), self.text("out1", "history.csv"))
            if scheme != "hht":
                self.assertLess(first["energy"]["error_ratio"], 1e-9)

    def test_restart_on_other_ranks_gives_the_same_bits(self):
        for scheme in ("contact_implicit", "newmark", "hht", "static"):
            self.write("bent.yaml", scene(scheme=scheme))
            self.run_scene(1, "bent.yaml", "--out", "whole", "--force")
            self.run_scene(2, "bent.yaml", "--out", "part", "--force", "--set", "run.end=0.5")
            self.run_scene(3, "bent.yaml", "--out", "part", "--restart", "part")
            self.assertEqual(self.summary("part")["state_hash"], self.summary("whole")["state_hash"])
            self.assertEqual(self.text("part", "history.csv"), self.text("whole", "history.csv"))

    def test_a_restart_keeps_a_step_that_followed_from_the_end(self):
        """A hundredth of run.end: with another end the same scene alone would have another step."""
        for scheme in ("contact_implicit", "static"):
            small = scene(scheme=scheme, step="0.002").replace("elements: [3, 2, 8]", "elements: [1, 1, 2]")
            self.write("given.yaml", small)
            self.write("none.yaml", small.replace(", step: 0.002", ""))
            self.run_scene(1, "given.yaml", "--out", "given", "--force", "--set", "run.end=0.6")
            self.run_scene(1, "none.yaml", "--out", "none", "--force", "--set", "run.end=0.2")
            self.run_scene(2, "none.yaml", "--out", "none", "--restart", "none", "--set", "run.end=0.6")
            self.assertIn("with the step 0.002 of its beginning", self.text("none", "log.txt"))
            self.assertEqual(self.summary("none")["steps"], 300)
            self.assertEqual(self.summary("none")["state_hash"], self.summary("given")["state_hash"])

    def test_a_rank_without_unknowns(self):
        self.write("one.yaml", scene().replace("elements: [3, 2, 8]", "elements: [1, 1, 1]"))
        for ranks in (1, 4):
            self.run_scene(ranks, "one.yaml", "--out", f"one{ranks}")
        self.assertEqual(self.summary("one4")["state_hash"], self.summary("one1")["state_hash"])

    def test_records_are_of_the_ends_of_steps_and_the_end_is_met(self):
        self.write("bent.yaml", scene(scheme="static"))
        self.run_scene(1, "bent.yaml", "--out", "out")
        rows = self.rows("out")
        self.assertEqual([int(row["step"]) for row in rows], list(range(11)))
        self.assertAlmostEqual(float(rows[-1]["time [1]"]), 1, delta=1e-12)
        self.assertEqual(self.summary("out")["stopped_by"], "end")
        self.assertLess(float(rows[-1]["tip.x [1]"]), -0.1)
        self.assertEqual(float(rows[-1]["kinetic [1]"]), 0)

    def test_check_tells_of_the_solver_and_not_of_stable_steps(self):
        self.write("bent.yaml", scene(scheme="static"))
        told = self.brunt("check", "bent.yaml").stdout
        self.assertRegex(told, r"(?m)^solver +static, step 0\.1 ")
        self.assertRegex(told, r"(?m)^unknowns +324 displacements, 0 multipliers")
        self.assertRegex(told, r"(?m)^steps +10 of that size")
        self.assertRegex(told, r"(?m)^estimated cost .* iterations a step")
        self.assertNotIn("cfl", told)

    def test_the_foot_carries_the_weight(self):
        self.write("hang.yaml", scene(scheme="static"))
        self.run_scene(1, "hang.yaml", "--out", "out", "--set", "pressure=null", "--set", "prescribed=null")
        weight = 0.1 * 2 * 4
        for row in self.rows("out")[1:]:  # a run begins without loads
            self.assertAlmostEqual(float(row["foot.z [1]"]), weight, delta=1e-9 * weight)

    def test_a_parallel_solver_agrees(self):
        self.write("bent.yaml", scene())
        self.run_scene(1, "bent.yaml", "--out", "direct")
        for ranks in of_all((1, 2, 3), (1, 3)):
            self.run_scene(ranks, "bent.yaml", "--out", "mumps", "--force", "--set", "solver.linear=mumps")
            self.assertFalse(self.summary("mumps")["implicit"]["same_bits_on_any_ranks"])
            # of the history the total is rounding alone
            told = self.brunt("compare", "direct", "mumps", "--tol", "1e-8").stdout
            fields = [line.split() for line in told.splitlines() if line.startswith(("node/", "element/"))]
            self.assertEqual(len(fields), 3)
            for _, _, relative, *_ in fields:
                self.assertLess(float(relative), 1e-8)

    def test_steps_are_halved_where_the_iteration_fails(self):
        # a cube pressed to a third within one step: the first iterate turns elements inside out
        self.write("press.yaml", scene(scheme="static", step="1").replace("value: 0.3", "value: 0.1").replace(
            "prescribed: [{set: corner, dof: y, displacement: pull}]",
            "prescribed: [{set: bar_zmax, dof: z, displacement: down}]").replace("pull: [[0, 0], [1, 0.3]]", "down: [[0, 0], [1, -3.0]]"))
        self.run_scene(1, "press.yaml", "--out", "out")
        told = self.summary("out")["implicit"]
        self.assertGreater(told["halved"], 0)
        self.assertAlmostEqual(self.summary("out")["end_time"], 1, delta=1e-12)
        self.run_scene(2, "press.yaml", "--out", "part", "--set", "run.steps=3")
        self.run_scene(1, "press.yaml", "--out", "part", "--restart", "part", "--set", "run.steps=10000")
        self.assertEqual(self.summary("part")["state_hash"], self.summary("out")["state_hash"])

    def test_no_step_is_small_enough(self):
        self.write("crush.yaml", scene(scheme="static").replace("displacement: pull}", "displacement: pull}, {set: bar_zmax, dof: z, displacement: down}").replace(
            "pull: [[0, 0], [1, 0.3]]", "pull: [[0, 0], [1, 0.3]], down: [[0, 0], [1, -6]]"))
        for ranks in (1, 2):
            told = self.run_scene(ranks, "crush.yaml", "--out", f"out{ranks}", code=3)
            self.assertRegex(told, r"Newton's method fails at t = 0\.\d+, step \d+, with the smallest step \S+ \(solver.min_step \S+\): ")
            self.assertEqual(self.summary(f"out{ranks}")["stopped_by"], "guard")
            self.assertEqual(len(glob.glob(os.path.join(self.folder, f"out{ranks}", "checkpoint_*.h5"))), 1)
        self.assertEqual(self.summary("out1")["state_hash"], self.summary("out2")["state_hash"])

    def test_a_body_that_floats_is_named(self):
        self.write("float.yaml", scene(scheme="static").replace("mesh: {box: {part: bar", "mesh:\n  - {box: {part: loose, size: [1, 1, 1], elements: [1, 1, 2], at: [5, 0, 0]}}\n  - {box: {part: bar").replace(
            "parts: {bar:", "parts: {loose: {material: m, element: hex8_full}, bar:"))
        for ranks in (1, 2):
            told = self.run_scene(ranks, "float.yaml", "--out", f"out{ranks}", code=3)
            self.assertIn("part loose, node", told)
            self.assertIn("can move freely at t = 0, step 0", told)

    def test_what_implicit_scenes_may_not_ask_for(self):
        wrong = {
            "element: hex8_full": ("element: hex8", "bar.element: invalid element hex8: it has no stiffness against hourglass modes"),
            "run: {end: 1}": ("run: {end: 1, cfl: 0.5}", "run.cfl: invalid in an implicit scene, which has no stable step; expected solver.step"),
            "gravity:": ("damping: {alpha: 1}\ngravity:", "damping: invalid in an implicit scene; expected solver.scheme: hht"),
            "solver: {scheme: contact_implicit, step: 0.1}":
                ("solver: {scheme: contact_implicit, step: 0.1, alpha: 0.1}", "solver.alpha: invalid without scheme: hht"),
            "step: 0.1}": ("step: 0.1, min_step: 0.2}", "solver.min_step: out of range: larger than step; expected a number > 0, at most step"),
            "scheme: contact_implicit": ("scheme: implicit", "solver.scheme: unknown value 'implicit'; expected one of static, contact_implicit, hht, newmark"),
            "fixed:": ("contact: [{between: all}]\nfixed:", "contact.0: invalid contact in an implicit scene"),
            "probes:": ("rigid_walls: [{point: [0, 0, -1], normal: [0, 0, 1], friction: {static: 0.3, kinetic: 0.2}}]\nprobes:", "invalid friction of a wall in an implicit scene"),
        }
        for old, (new, message) in wrong.items():
            self.write("wrong.yaml", scene().replace(old, new))
            told = self.run_scene(1, "wrong.yaml", "--out", "wrong", code=2)
            self.assertIn(message, told)
            self.assertEqual(len(told.strip().splitlines()), 1, told)


if __name__ == "__main__":
    unittest.main()
