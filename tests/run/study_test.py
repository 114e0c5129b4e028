#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""scripts/study and scripts/pareto. Needs BRUNT, BRUNT_RUN (scripts/run) and BRUNT_CASES in the environment."""
import csv
import os
import subprocess
import tempfile
import unittest

SCRIPTS, CASES = os.path.dirname(os.environ["BRUNT_RUN"]), os.environ["BRUNT_CASES"]

PARETO = f"""\
case: {CASES}/bar_impact
meshes:
  coarse: {{size: 1e-2, mesh.0.box.elements: [10, 1, 1], mesh.1.box.elements: [10, 1, 1]}}
  fine: {{size: 0.25e-2, mesh.0.box.elements: [40, 1, 1], mesh.1.box.elements: [40, 1, 1]}}
settings:
  as it is: {{}}
  small steps: {{run.cfl: 0.5}}
errors: [energy taken, velocity of the target]
others: {{by hand: {{seconds: 1e3, energy taken: 0.02}}}}
"""

STUDY = f"""\
scene: {CASES}/bar_impact/scene.yaml
runs:
  short: {{run.steps: 5}}
  long: {{run.steps: 9, ranks: 2}}
columns: [steps, energy.error_ratio, last striker.x]
"""

# All is linear: what is left of the striker's velocity after some steps is a share of it.
BISECT = f"""\
scene: {CASES}/bar_impact/scene.yaml
runs:
  short: {{run.steps: 5}}
  shorter: {{run.steps: 3, ranks: 2}}
columns: [steps, last striker.x]
bisect: {{key: initial.0.velocity.0, between: [1, 9], column: last striker.x, threshold: 3.3, within: 0.5}}
"""


class Studies(unittest.TestCase):
    def setUp(self):
        self.keeper = tempfile.TemporaryDirectory()
        self.addCleanup(self.keeper.cleanup)
        self.folder = self.keeper.name

    def run_study(self, program, text, *options):
        with open(os.path.join(self.folder, "s.yaml"), "w", encoding="utf-8") as stream:
            stream.write(text)
        return subprocess.run([os.path.join(SCRIPTS, program), "s.yaml", *options], cwd=self.folder, capture_output=True,
                              text=True, timeout=120, check=False)

    def table(self):
        with open(os.path.join(self.folder, "s.out", "table.csv"), encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def assert_refused(self, program, text, *phrases):
        done = self.run_study(program, text)
        self.assertEqual(done.returncode, 2, done.stderr + done.stdout)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for phrase in ("s.yaml", "expected", *phrases):
            self.assertIn(phrase, done.stderr)

    def test_pareto(self):
        done = self.run_study("pareto", PARETO)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = self.table()
        self.assertEqual([(row["setting"], row["mesh"]) for row in rows],
                         [(s, m) for s in ("as it is", "small steps") for m in ("coarse", "fine")]
                         + [(s, "order") for s in ("as it is", "small steps")])
        self.assertEqual([row["elements"] for row in rows[:4]], ["20", "80", "20", "80"])
        self.assertGreater(int(rows[2]["steps"]), 1.5 * int(rows[0]["steps"]))
        for coarse, fine, order in ((0, 1, 4), (2, 3, 5)):  # contact takes 1/(4N) of the energy: first order
            self.assertAlmostEqual(float(rows[coarse]["energy taken"]), 1 / 40, delta=0.005)
            self.assertLess(float(rows[fine]["energy taken"]), float(rows[coarse]["energy taken"]) / 3)
            self.assertAlmostEqual(float(rows[order]["energy taken"]), 1, delta=0.15)
            self.assertGreater(float(rows[coarse]["loop [s]"]), float(rows[coarse]["contact [s]"]))
        self.assertGreater(os.path.getsize(os.path.join(self.folder, "s.out", "pareto.png")), 10_000)

    def test_pareto_says_what_is_wrong(self):
        for change, phrases in ((("bar_impact", "no_case"), ("case", "no_case")),
                                (("settings", "setings"), ("setings", "unknown key")),
                                (("size: 1e-2, ", ""), ("meshes.coarse.size",)),
                                (("size: 1e-2", "size: -1"), ("meshes.coarse.size",)),
                                (("small steps: {run.cfl: 0.5}", "small steps: 0.5"), ("settings.small steps",)),
                                (("errors: [", "errors: [cost, "), ("'cost'", "mean force")),
                                (("seconds: 1e3, ", ""), ("others.by hand", "seconds")),
                                (("seconds: 1e3, energy", "seconds: 1e3, colour"), ("others", "'colour taken'")),
                                (("errors:", "repeat: 0\nerrors:"), ("repeat",)),
                                (("errors:", "ranks: two\nerrors:"), ("ranks",))):
            with self.subTest(change=change):
                self.assert_refused("pareto", PARETO.replace(*change), *phrases)
        self.assert_refused("pareto", f"case: {CASES}/beam\nmeshes: {{short: {{size: 1, run.steps: 2}}}}\n",
                            "cannot report the errors")

    def test_pareto_goes_on_past_a_run_that_fails(self):
        done = self.run_study("pareto", PARETO.replace("run.cfl: 0.5", "run.cfl: 5"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("exit code 2", self.table()[2]["elements"])
        self.assertEqual(self.table()[1]["elements"], "80")

    def test_study(self):
        done = self.run_study("study", STUDY)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = self.table()
        self.assertEqual([(row["run"], row["steps"]) for row in rows], [("short", "5"), ("long", "9")])
        self.assertLess(float(rows[1]["last striker.x"]), float(rows[0]["last striker.x"]))

    def test_study_with_a_column_that_no_run_has_ends_with_the_first(self):
        for change, phrases in ((("steps,", "stps,"), ("'stps'", "unknown key of summary.json", "nearest is 'steps'", "energy.total")),
                                (("energy.error_ratio", "energy"), ("'energy'", "energy.kinetic")),
                                (("last striker.x", "last striker.y2"), ("'striker.y2'", "unknown column of history.csv", "striker.x"))):
            with self.subTest(change=change):
                self.assert_refused("study", STUDY.replace(*change), "columns", *phrases)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "s.out", "long")))

    def test_study_with_columns_of_some_runs(self):
        probe = "probes: [{name: tip, part: striker, field: position}]"
        text = STUDY.replace("short: {run.steps: 5}", f"short: {{run.steps: 5, {probe}}}").replace("last striker.x", "last tip.x")
        done = self.run_study("study", text)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([bool(row["last tip.x"]) for row in self.table()], [True, False])
        self.assert_refused("study", text.replace("last tip.x", "last top.x"), "'top.x'", "tip.x")

    def test_study_of_several_scenes(self):
        scene = STUDY.split("scene: ", 1)[1].split("\n", 1)[0]
        done = self.run_study("study", STUDY.replace(f"scene: {scene}", f"scenes: {{one: {scene}, other: {scene}}}"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([(row["scene"], row["run"], row["steps"]) for row in self.table()],
                         [("one", "short", "5"), ("one", "long", "9"), ("other", "short", "5"), ("other", "long", "9")])

    def test_study_bisects(self):
        done = self.run_study("study", BISECT)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = self.table()
        self.assertEqual([row["initial.0.velocity.0"] for row in rows[:5]], ["1", "9", "5", "3", "4"])
        with open(os.path.join(self.folder, "s.out", "brackets.csv"), encoding="utf-8") as stream:
            brackets = list(csv.DictReader(stream))
        self.assertEqual([bracket["run"] for bracket in brackets], ["short", "shorter"])
        for bracket in brackets:
            share = next(float(row["last striker.x"]) for row in rows if row["run"] == bracket["run"])
            low, high = float(bracket["initial.0.velocity.0 from"]), float(bracket["to"])
            self.assertEqual(high - low, 0.5)
            self.assertLess(low, 3.3 / share)
            self.assertGreater(high, 3.3 / share)

    def test_study_without_a_bracket(self):
        done = self.run_study("study", BISECT.replace("threshold: 3.3", "threshold: 33"))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(len(self.table()), 4)
        self.assertIn("| short | no bracket |", done.stdout)

    def test_study_says_what_is_wrong_with_a_bisection(self):
        for change, phrases in ((("within: 0.5", "width: 0.5"), ("bisect.width", "unknown key")),
                                ((", within: 0.5", ""), ("bisect.within", "missing")),
                                (("within: 0.5", "within: 0"), ("bisect.within", "> 0")),
                                (("[1, 9]", "[1, 1]"), ("bisect.between", "two different numbers")),
                                (("[1, 9]", "[1, fast]"), ("bisect.between", "fast")),
                                (("[1, 9]", "[1, .nan]"), ("bisect.between", "finite")),
                                (("column: last striker.x", "column: state_hash"), ("bisect.column", "invalid column 'state_hash'", "a column of numbers")),
                                (("column: last striker.x", "column: last striker.y2"), ("bisect.column", "'striker.y2'"))):
            with self.subTest(change=change):
                self.assert_refused("study", BISECT.replace(*change), *phrases)

    def test_study_says_what_is_wrong(self):
        for change, phrases in ((("scene: ", "scen: "), ("scen", "unknown key")),
                                (("scene: ", "scenes: "), ("scenes", "a map of name: file")),
                                (("scene: ", "scenes: {a: b}\nscene: "), ("scene:", "one of the two")),
                                (("columns: [steps", "ranks: 0\ncolumns: [steps"), ("ranks",)),
                                (("{run.steps: 5}", "5"), ("runs.short",)),
                                (("bar_impact/scene", "bar_impact/scen"), ("scene:", "does not exist")),
                                (("ranks: 2", "ranks: 0"), ("runs.long.ranks",)),
                                (("columns:", "runs: ["), ("s.yaml",)),):
            with self.subTest(change=change):
                done = self.run_study("study", STUDY.replace(*change))
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                for phrase in phrases:
                    self.assertIn(phrase, done.stderr)


if __name__ == "__main__":
    unittest.main()
