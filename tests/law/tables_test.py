#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Tables of the READMEs from stored results: what is written, what counts as stale, which faults are named."""
import json
import os
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [os.path.join(ROOT, "scripts/lib"), os.path.join(ROOT, "cases/support")]
import result_tables  # noqa: E402
import results  # noqa: E402
import stored_studies  # noqa: E402


def check(quantity, computed, expected=1.0, tolerance=0.01, **more):
    return {"quantity": quantity, "expected": expected, "computed": computed, "error": abs(computed - expected) if expected != "same" else None,
            "tolerance": tolerance, "source": "", "passed": True, **more}


def record(*checks, **tables):
    return {"commit": "0123abc", "date": "2026-01-31", "command": "cases/bar/check.py", "checks": list(checks), "runs": [],
            "tables": {name: {"header": ["elements", "error", "loop [s]"], "rows": rows} for name, rows in tables.items()}}


class Stale(unittest.TestCase):
    def test_the_same_results(self):
        one = record(check("a: force", 1.001), mesh=[["10", "0.25 %", "3.1"]])
        self.assertEqual(results.differences(one, one), [])

    def test_a_figure_that_differs_in_its_printed_digits(self):
        self.assertEqual(len(results.differences(record(check("force", 1.001)), record(check("force", 1.0015)))), 1)
        self.assertEqual(len(results.differences(record(mesh=[["10", "0.25 %", ""]]), record(mesh=[["10", "0.27 %", ""]]))), 1)

    def test_the_last_digit_may_differ_by_one(self):
        self.assertEqual(results.differences(record(mesh=[["10", "0.25 %", ""]]), record(mesh=[["10", "0.26 %", ""]])), [])

    def test_times_may_differ(self):
        self.assertEqual(results.differences(record(mesh=[["10", "0.25 %", "3.1"]]), record(mesh=[["10", "0.25 %", "7.4"]])), [])

    def test_rounding_errors_may_differ(self):
        noise = {"expected": 0, "tolerance": 1e-10, "absolute": True}
        self.assertEqual(results.differences(record(check("energy", 1e-15, **noise)), record(check("energy", 7e-15, **noise))), [])

    def test_state_hashes_may_differ(self):
        bits = {"expected": "same", "tolerance": "equal", "source": results.SAME_BITS}
        one, other = (record({**check("state on 3 ranks", 0, "same"), **bits, "computed": text}) for text in ("ab", "cd"))
        self.assertEqual(results.differences(one, other), [])

    def test_a_check_of_every_run(self):
        self.assertEqual(results.differences(record(check("e", 1.0), check("e", 2.0, 2.0)), record(check("e", 1.0), check("e", 2.0, 2.0))), [])
        self.assertEqual(len(results.differences(record(check("e", 1.0), check("e", 2.0, 2.0)), record(check("e", 1.1), check("e", 2.0, 2.0)))), 1)

    def test_other_checks_and_rows(self):
        self.assertEqual(len(results.differences(record(check("force", 1.0)), record(check("speed", 1.0)))), 2)
        self.assertEqual(len(results.differences(record(mesh=[["10", "", ""]]), record(mesh=[]))), 1)


class Blocks(unittest.TestCase):
    def setUp(self):
        self.root = tempfile.mkdtemp()
        self.forms = {"short": record(check("coarse: force", 1.001), check("fine: force", 1.0001), check("mass", 2.0, 2.0), mesh=[["10", "1 %", "3"]]),
                      "long": record(check("mass", 2.5, 2.5))}
        results.save(os.path.join(self.root, "results.json"), self.forms)

    def block(self, spec):
        return result_tables.block(self.root, self.root, spec)

    def test_stored_results_are_read_as_written(self):
        self.assertEqual(results.load(os.path.join(self.root, "results.json")), json.loads(json.dumps(self.forms)))

    def test_a_table_with_its_origin(self):
        self.assertEqual(self.block("mesh"), "| elements | error | loop [s] |\n| --- | --- | --- |\n| 10 | 1 % | 3 |\n\n"
                                             "`cases/bar/check.py`, commit 0123abc, 2026-01-31.\n")

    def test_checks_by_label_and_form(self):
        self.assertIn("| force | 1 | 1.001 | 0.001 | 0.01 |", self.block("checks coarse"))
        self.assertIn("| mass | 2.5 | 2.5 |", self.block("long/checks"))
        self.assertIn("| force | 1 | 1.001 (0.1 %) | 1.0001 (0.01 %) | 0.01 |", self.block("beside"))
        self.assertIn("| fine | 1.0001 (0.01 %) |", self.block("by_run f*"))
        self.assertIn("| force | 2 | 0.001 | 0.01 |", self.block("worst"))

    def test_a_check_of_every_run_is_one_row(self):
        self.forms["short"]["checks"] += [check("balance", 1.001), check("balance", 1.002)]
        results.save(os.path.join(self.root, "results.json"), self.forms)
        self.assertIn("| balance (largest of 2) | 1 | 1.002 | 0.002 | 0.01 |", self.block("checks"))

    def test_an_overview_of_all_folders(self):
        os.makedirs(os.path.join(self.root, "bar"))
        results.save(os.path.join(self.root, "bar", "results.json"), self.forms)
        self.assertIn("| [bar](bar/README.md) | 3 | 3 | 10 | 0 | 0 | 0123abc | 2026-01-31 |", self.block("overview"))

    def test_what_is_missing_is_named(self):
        for spec, what in (("none", "no stored results"), ("medium/mesh", "form 'medium'"), ("checks x", "'x: ...'"), ("far:mesh", "not there")):
            with self.assertRaisesRegex(result_tables.Missing, what):
                self.block(spec)

    def test_a_page_is_filled_and_stays_so(self):
        page = os.path.join(self.root, "README.md")
        with open(page, "w", encoding="utf-8") as stream:
            stream.write("before\n<!-- results: mesh -->\nold\n<!-- end of results -->\nafter\n")
        old, new, faults, _ = result_tables.filled(self.root, "README.md")
        self.assertEqual((faults, old == new), ([], False))
        with open(page, "w", encoding="utf-8") as stream:
            stream.write(new)
        old, again, faults, _ = result_tables.filled(self.root, "README.md")
        self.assertEqual((old, faults), (again, []))

    def test_results_that_are_not_stored_yet_are_no_fault(self):
        text = "<!-- results: far:mesh -->\n<!-- end of results -->\n"
        with open(os.path.join(self.root, "README.md"), "w", encoding="utf-8") as stream:
            stream.write(text)
        old, new, faults, empty = result_tables.filled(self.root, "README.md")
        self.assertEqual((old, new, faults, len(empty)), (text, text, [], 1))

    def test_a_block_without_end(self):
        with open(os.path.join(self.root, "README.md"), "w", encoding="utf-8") as stream:
            stream.write("<!-- results: mesh -->\n")
        self.assertEqual(len(result_tables.filled(self.root, "README.md")[2]), 1)


class Studies(unittest.TestCase):
    def test_meshes_of_a_setting_stand_in_one_row(self):
        header = [*stored_studies.HEADS_OF_PARETO, "force"]
        rows = [["rate", "10", "100", "5", "0.1", "0.01", "1.000e-02"], ["rate", "20", "200", "9", "0.4", "0.02", "-2.500e-03"],
                ["rate", "order", "", "", "", "", "2.00"], ["penalty", "10", "exit code 3"]]
        table = stored_studies.of_pareto(header, rows)
        self.assertEqual(table["header"], ["setting", "force, error [%] with 10, 20", "order", "loop [s]", "contact [s]"])
        self.assertEqual(table["rows"], [["rate", "1, -0.25", "2.00", "0.1, 0.4", "0.01, 0.02"], ["penalty", "stopped", "", "", ""]])


    def test_tables_that_a_program_prints(self):
        self.assertEqual(stored_studies.printed("loading\n| a | b |\n| --- | ---: |\n| 1 | |\ntext\n| no | table |\n"),
                         [{"header": ["a", "b"], "rows": [["1", ""]]}])


if __name__ == "__main__":
    unittest.main()
