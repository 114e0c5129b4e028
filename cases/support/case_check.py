# SPDX-License-Identifier: Apache-2.0
"""What the checks of all cases share: run a scene, read its results, compare them with references.

A check reads like this (run by hand: cases/NAME/check.py, after a build):

    case = Case(__file__)
    result = case.run("scene.yaml", ranks=2)
    case.assert_close("length after impact [mm]", 21.42, result.last("tip.displacement_z"), 0.01, source="Wilkins 1973")
    case.assert_energy(result)
    case.finish()

`case.table(NAME, header, rows)` adds a table of its own. All of it is kept in the work folder's results.json, from which scripts/tables writes
the tables of the case's README (see results.py).

A check that says `case.answer(errors)` before it runs anything also gives the errors of one run made elsewhere, as JSON
(cases/NAME/check.py --errors RESULT [--scene FILE] [--set KEY=VALUE]...): scripts/pareto asks so.
"""
import argparse
import csv
import json
import math
import os
import re
import shutil
import subprocess
import sys

import numpy
import yaml

import results

PROJECT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SKIP_CODE = 77  # ctest reports the case as skipped
SHOWN_DIFFERENCES = 8  # from the stored results, in lines
STALE_RESULTS_FAIL = False  # whether a check fails where its figures differ from the stored ones; else it warns


class SceneLoader(yaml.SafeLoader):
    """Reads 2.0e11 and 1e3 as the numbers they are; YAML 1.1 takes them for text."""


SceneLoader.add_implicit_resolver("tag:yaml.org,2002:float", re.compile(r"^[-+]?(\d+\.?\d*|\.\d+)[eE][-+]?\d+$"),
                                  list("-+.0123456789"))


class Result:
    """A result folder: summary (a dict), history (a column of numbers by name), seconds of wall time of the run."""

    def __init__(self, folder):
        self.folder = folder
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as stream:
            self.summary = json.load(stream)
        self._history = None

    @property
    def history(self):
        if self._history is None:
            with open(os.path.join(self.folder, "history.csv"), encoding="utf-8") as stream:
                lines = [line for line in stream if line.strip() and not line.startswith("#")]
            # A column's head may carry its unit: "time [s]" is found as "time".
            names = [head.split("[")[0].strip() for head in lines[0].split(",")]
            rows = numpy.array([[float(value) for value in line.split(",")] for line in lines[1:]])
            self._history = {name: rows[:, i] for i, name in enumerate(names)}
        return self._history

    def last(self, column):
        return float(self.history[column][-1])

    def at(self, column, time):
        """The column's value at a time, linear between rows."""
        return float(numpy.interp(time, self.history["time"], self.history[column]))


def _override(tree, path, value):
    """As --set does: lists are entered by index, a missing key is made, null takes one away."""
    if path[:2] == ["mesh", "0"] and isinstance(tree["mesh"], dict):
        path = path[:1] + path[2:]  # a mesh of one body may be written without the list
    *heads, last = path
    for head in heads:
        tree = tree[int(head)] if isinstance(tree, list) else tree.setdefault(head, {})
    if isinstance(tree, list):
        tree[int(last)] = value
    elif value is None:
        tree.pop(last, None)
    else:
        tree[last] = value


class Case:
    def __init__(self, check_file):
        self.folder = os.path.dirname(os.path.abspath(check_file))
        self.name = os.path.basename(self.folder)
        parser = argparse.ArgumentParser(description=f"Checks the case {self.name} against its references.")
        parser.add_argument("--brunt", default=os.path.join(PROJECT, "build/release/brunt"), help="the program")
        parser.add_argument("--work", default=os.path.join(PROJECT, "build/cases", self.name), help="folder for results")
        parser.add_argument("--long", action="store_true", help="the thorough form of the check")
        parser.add_argument("--brief", action="store_true", help="as an ordinary test: without what takes longest (of_all); keeps no results")
        parser.add_argument("--one-rank", action="store_true", help="one rank, no comparisons of bits")
        parser.add_argument("--renew", action="store_true", help="do not compare with the stored results: they are to be written anew")
        parser.add_argument("--errors", metavar="RESULT", help="print the errors of this result as JSON, run nothing")
        parser.add_argument("--scene", default="scene.yaml", help="with --errors: the scene of the result")
        parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="with --errors: its overrides")
        given = self.given = parser.parse_args()
        self.brunt, self.work, self.long = os.path.abspath(given.brunt), os.path.abspath(given.work), given.long
        self.checks, self.tables = [], {}  # as results.py has them
        self.results = {}  # by the name of the run

    def of_all(self, cases, few):
        """All of them, with --brief those that stand for them."""
        return few if self.given.brief else cases

    def scene(self, name="scene.yaml", overrides=None):
        """The scene as plain data, with overrides {key path: value}: references are computed from its numbers."""
        with open(os.path.join(self.folder, name), encoding="utf-8") as stream:
            tree = yaml.load(stream, SceneLoader)
        for path, value in (overrides or {}).items():
            _override(tree, path.split("."), value)
        return tree

    def answer(self, errors):
        """With --errors: prints errors(scene, result), {quantity: error}, and ends the program."""
        if not self.given.errors:
            return
        pairs = (pair.partition("=") for pair in self.given.set)
        scene = self.scene(self.given.scene, {path: yaml.load(value, SceneLoader) for path, _, value in pairs})
        found = errors(scene, Result(self.given.errors))
        print(json.dumps({quantity: float(error) for quantity, error in found.items()}))
        sys.exit(0)

    def run(self, scene="scene.yaml", overrides=None, ranks=1, name=None, options=(), expected_code=0):
        """Runs the scene (a path relative to the case) into work/name with --set overrides {key path: value}."""
        if self.given.errors:
            sys.exit(f"{self.name}: its check does not answer --errors")
        name = name or f"np{ranks}"
        ranks = 1 if self.given.one_rank else ranks
        out = os.path.join(self.work, name)
        shutil.rmtree(out, ignore_errors=True)
        os.makedirs(self.work, exist_ok=True)
        command = [os.path.join(PROJECT, "scripts/run"), "-np", str(ranks), os.path.join(self.folder, scene)]
        command += ["--out", out, "--quiet", *options]
        for key, value in (overrides or {}).items():
            command += ["--set", f"{key}={json.dumps(value)}"]
        run = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "BRUNT": self.brunt})
        if run.returncode != expected_code:
            print(" ".join(command), run.stdout, run.stderr, sep="\n")
            sys.exit(f"{self.name}: exit code {run.returncode}, expected {expected_code}")
        self.results[name] = result = Result(out)
        result.scene, result.ranks = scene, ranks
        return result

    def depth(self, *words, ranks=1, name=None, fresh=True, expected_code=0):
        """Runs `brunt depth` with these words into work/name; the rows of its depth.csv as dicts of numbers and texts."""
        out = os.path.join(self.work, name or f"np{ranks}")
        if fresh:
            shutil.rmtree(out, ignore_errors=True)
        os.makedirs(self.work, exist_ok=True)
        command = [os.path.join(PROJECT, "scripts/run"), "-np", str(ranks), "depth", *map(str, words), "--out", out]
        run = subprocess.run(command, capture_output=True, text=True, cwd=self.work, env={**os.environ, "BRUNT": self.brunt})
        if run.returncode != expected_code:
            print(" ".join(command), run.stdout, run.stderr, sep="\n")
            sys.exit(f"{self.name}: exit code {run.returncode}, expected {expected_code}")
        with open(os.path.join(out, "depth.csv"), encoding="utf-8", newline="") as stream:
            return [{key: value if key in ("a", "b", "metric") else float(value) for key, value in row.items()}
                    for row in csv.DictReader(stream)]

    def assert_close(self, quantity, reference, ours, gate, source="", absolute=False):
        """|ours - reference| <= gate, as a share of |reference| unless absolute."""
        error = abs(ours - reference)
        if not absolute:
            error = error / abs(reference) if reference else math.inf
        self._check(quantity, reference, ours, error, gate, error <= gate, source, absolute)

    def assert_below(self, quantity, ours, gate, source=""):
        self._check(quantity, 0, ours, abs(ours), gate, abs(ours) <= gate, source, True)

    def assert_within(self, quantity, low, high, ours, source=""):
        """low <= ours <= high, for references that are bounds."""
        outside = max(low - ours, ours - high, 0.0)
        self._check(quantity, f"{low:.6g} .. {high:.6g}", ours, outside, 0, low <= ours <= high, source)

    def assert_equal(self, quantity, reference, ours, source=""):
        self._check(quantity, str(reference), str(ours), None, "equal", reference == ours, source)

    def table(self, name, header, rows):
        """A table for the README, printed too: cells are texts, or numbers that get four digits (times two). A head with a time in [s] says
        that its column is measured, and differs from run to run."""
        for cells in rows:
            self.row(name, header, cells)

    def row(self, name, header, cells):
        """One row of a table, which grows by it."""
        if name not in self.tables:
            self.tables[name] = {"header": list(header), "rows": []}
            print("\n| " + " | ".join(header) + " |\n" + "|---" * len(header) + "|")
        assert list(header) == self.tables[name]["header"] and len(cells) == len(header), f"table {name}: a row does not fit its header"
        cells = [results.figure(cell, 2 if results.TIME.search(head) else 4) for head, cell in zip(header, cells)]
        self.tables[name]["rows"].append(cells)
        print("| " + " | ".join(cells) + " |")

    def assert_energy(self, result, energy_gate=1e-2, momentum_gate=1e-9):
        """Balance of energy and momentum, asserted on every case."""
        self.assert_below("energy error ratio", result.summary["energy"]["error_ratio"], energy_gate)
        self.assert_below("momentum error", result.summary["momentum_error"], momentum_gate)

    def assert_same_state(self, quantity, reference, ours):
        """Two results end with the same bits."""
        if self.given.one_rank:
            return
        self.assert_equal(quantity, reference.summary["state_hash"], ours.summary["state_hash"], results.SAME_BITS)

    def assert_same_on_ranks(self, counts=(1, 2, 3), restarted=False, **run_arguments):
        """The state has the same bits on every number of ranks; with --brief on one and three, and nothing is run where it is
        restarted on other ranks as well (assert_same_after_restart)."""
        if self.given.one_rank or self.given.brief and restarted:
            return
        counts = self.of_all(counts, (1, 3))
        first, *others = [self.run(ranks=n, name=f"hash_np{n}", **run_arguments) for n in counts]
        for count, other in zip(counts[1:], others):
            self.assert_same_state(f"state on {count} ranks", first, other)

    def assert_same_after_restart(self, reference, middle, before=2, after=3, **run_arguments):
        """Stopped at the time `middle` on some ranks and continued on others: the state of the result `reference`."""
        if self.given.one_rank:
            return
        overrides = run_arguments.pop("overrides", None) or {}
        half = {**overrides, "run.end": middle, "checkpoint.every": middle}
        first = self.run(ranks=before, name="restart_before", overrides=half, **run_arguments)
        second = self.run(ranks=after, name="restart_after", overrides={**overrides, "checkpoint.every": middle},
                          options=("--restart", first.folder), **run_arguments)
        self.assert_same_state(f"state after a restart from {before} on {after} ranks", reference, second)

    def skip(self, why):
        print(f"{self.name}: skipped, {why}")
        sys.exit(SKIP_CODE)

    def finish(self):
        """Prints the table of checks, keeps the results in the work folder and ends the check."""
        print("| quantity | reference | ours | error | gate | ok | source |\n|---|---|---|---|---|---|---|")
        for check in self.checks:
            cells = [check["quantity"], results.figure(check["expected"], 6), results.figure(check["computed"], 6),
                     results.figure(check["error"], 3), results.figure(check["tolerance"], 2), "yes" if check["passed"] else "**NO**"]
            print("| " + " | ".join(cells) + f" | {check['source']} |")
        stale = self._keep()
        failed = [check["quantity"] for check in self.checks if not check["passed"]]
        if stale and STALE_RESULTS_FAIL:
            failed.append("the stored results are stale")
        if not self.checks:
            failed = ["nothing was checked"]
        print(f"{self.name}: {len(self.checks)} checks, {len(failed)} failed" + "".join(f"; {f}" for f in failed))
        sys.exit(1 if failed else 0)

    def _keep(self):
        """Writes results.json into the work folder, and names where it differs from the stored results; how many differences."""
        if self.given.brief:
            return 0
        form = "long" if self.long else "short"
        options = " --long" * self.long + " --one-rank" * self.given.one_rank
        fresh = results.record(PROJECT, f"cases/{self.name}/check.py{options}", self.checks,
                               [_figures_of(name, result) for name, result in self.results.items()], self.tables)
        os.makedirs(self.work, exist_ok=True)
        results.save(os.path.join(self.work, "results.json"), {form: fresh})
        stored = results.load(os.path.join(self.folder, "results.json")).get(form)
        found = results.differences(stored, fresh) if stored and not self.given.renew else []
        for line in found[:SHOWN_DIFFERENCES]:
            print(f"warning: {line}")
        if found:
            print(f"warning: {len(found)} figures differ from the stored results; run scripts/tables --run {self.name}"
                  + (" --long" if self.long else ""))
        return len(found)

    def _check(self, quantity, expected, computed, error, tolerance, passed, source, absolute=False):
        # A NaN is never below a gate, so it fails without a word of its own.
        keep = results.rounded
        if absolute and abs(expected) < 1e-9 * tolerance:
            expected = 0  # a reference that is zero but for rounding
        self.checks.append({"quantity": quantity, "expected": keep(expected), "computed": keep(computed), "error": keep(error, 3),
                            "tolerance": keep(tolerance), "passed": bool(passed), "source": source,
                            **({"absolute": True} if absolute else {})})


def _figures_of(name, result):
    """What a run says of itself, for the table of runs."""
    summary, keep = result.summary, results.rounded
    contact, implicit = summary.get("contact", {}), summary.get("implicit", {})
    return {"name": name, "scene": result.scene, "ranks": result.ranks, "elements": summary["elements"], "steps": summary["steps"],
            "iterations_mean": keep(implicit.get("iterations_mean", contact.get("iterations_mean")), 3),
            "iterations_max": implicit.get("iterations_max", contact.get("iterations_max")),
            "max_penetration": keep(summary.get("max_penetration"), 3), "energy_error": keep(summary["energy"]["error_ratio"], 2),
            "loop_s": keep(summary["loop_s"], 3)}
