# SPDX-License-Identifier: Apache-2.0
"""Stored results: what a check or a study computed, as data from which scripts/tables writes the tables of the READMEs.

A file results.json holds one record for each form of a check or study ("short", "long", or the name of a study):

    {"short": {"commit": "00ef19d", "date": "2026-11-26", "command": "cases/NAME/check.py",
               "checks": [{"quantity", "expected", "computed", "error", "tolerance", "source", "passed"}, ...],
               "runs": [{"name", "scene", "ranks", "elements", "steps", ...}, ...],
               "tables": {TABLE: {"header": [...], "rows": [[...], ...]}}}}
"""
import datetime
import json
import math
import os
import re
import subprocess

PROGRAM_FOLDERS = ("src", "include", "partition", "CMakeLists.txt")  # a commit that changes none of them has the same results
DIGITS = 5  # significant digits of a computed figure in a table
ROUNDING = 1e-10  # figures below this are rounding errors: their digits depend on the processor and the compiler
SHARE_OF_TOLERANCE = 0.01  # a change by less than this share of its tolerance does not make a figure stale
TIME = re.compile(r"\b(times?|loop|contact)\b[^|]*\[(s|ms|us|ns)\]|\btime\b$", re.I)  # columns with measured times
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?", re.I)


def commit_of(project):
    """The last commit that changed the program; BRUNT_COMMIT overrides it, for a binary of another commit."""
    given = os.environ.get("BRUNT_COMMIT")
    if given:
        return given
    command = ["git", "-C", project, "log", "-1", "--abbrev=7", "--format=%h", "--", *PROGRAM_FOLDERS]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    return run.stdout.strip() or "unknown"


def record(project, command, checks=(), runs=(), tables=None):
    return {"commit": commit_of(project), "date": datetime.date.today().isoformat(), "command": command,
            "checks": list(checks), "runs": list(runs), "tables": tables or {}}


def load(path):
    if not os.path.exists(path):
        return {}
    with open(path, encoding="utf-8") as stream:
        return json.load(stream)


def save(path, forms):
    """Sorted keys; one line a check, a run and a row, so that a difference between two versions can be read."""
    def dump(value, depth):
        inner = (lambda texts, ends: ends[0] + ",".join("\n" + " " * (depth + 1) + t for t in texts) + "\n" + " " * depth + ends[1])
        if isinstance(value, dict) and value and (depth < 2 or any(isinstance(v, (dict, list)) for v in value.values())):
            return inner([f"{json.dumps(k)}: {dump(v, depth + 1)}" for k, v in sorted(value.items())], "{}")
        if isinstance(value, list) and any(isinstance(v, (dict, list)) for v in value):
            return inner([dump(v, depth + 1) for v in value], "[]")
        return json.dumps(value, sort_keys=True, ensure_ascii=False)

    with open(path, "w", encoding="utf-8") as stream:
        stream.write(dump(forms, 0) + "\n")


def rounded(value, digits=DIGITS + 1):
    """A number with so many significant digits, an integer as it is; a text for what JSON has no number for."""
    if isinstance(value, (bool, int, str)) or value is None:
        return value
    value = float(value)
    return float(f"{value:.{digits}g}") if math.isfinite(value) else str(value)


def figure(value, digits=4):
    """A cell of a table: a number with so many significant digits, a text as it is."""
    if value is None:
        return ""
    if isinstance(value, (str, int)):
        return str(value)
    value = float(value)
    if not 1e-3 <= abs(value) < 1e7:
        return f"{value:.{digits}g}"
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(value))))
    text = f"{value:.{decimals}f}"
    return text.rstrip("0").rstrip(".") if decimals else text


def unit_of_last_digit(text):
    mantissa, _, exponent = text.lower().partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 10.0**(int(exponent or 0) - decimals)


def same_cell(stored, fresh):
    """Equal texts but for numbers, which may differ by one unit of their last printed digit."""
    if NUMBER.split(stored) != NUMBER.split(fresh):
        return False
    for a, b in zip(NUMBER.findall(stored), NUMBER.findall(fresh)):
        allowed = max(unit_of_last_digit(a), unit_of_last_digit(b), ROUNDING)
        if abs(float(a) - float(b)) > 1.001 * allowed:
            return False
    return True


def same_check(stored, fresh):
    a, b = stored["computed"], fresh["computed"]
    if isinstance(a, str) or isinstance(b, str) or a is None or b is None:
        return a == b
    scale = 10.0**(math.floor(math.log10(abs(a))) - DIGITS + 1) if a else 0.0
    tolerance = fresh["tolerance"] if isinstance(fresh["tolerance"], (int, float)) else 0.0
    if isinstance(fresh["expected"], (int, float)) and fresh["expected"] and not fresh.get("absolute"):
        tolerance *= abs(fresh["expected"])
    return abs(a - b) <= max(1.001 * scale, SHARE_OF_TOLERANCE * tolerance, ROUNDING)


def _by_name(checks):
    """Checks by quantity; one that is made several times by its number, too. Not those of equal bits."""
    found = {}
    for check in checks:
        if check["source"] != SAME_BITS:
            same = sum(name == check["quantity"] or name.startswith(check["quantity"] + " #") for name in found)
            found[check["quantity"] + (f" #{same + 1}" if same else "")] = check
    return found


def differences(stored, fresh):
    """What a fresh record has otherwise than the stored one, times aside: a line each."""
    found = []
    old, new = _by_name(stored["checks"]), _by_name(fresh["checks"])
    found += [f"{name}: a check {'no longer made' if name in old else 'not stored'}" for name in sorted(old.keys() ^ new.keys())]
    found += [f"{name}: stored {old[name]['computed']}, now {new[name]['computed']}"
              for name in old if name in new and not same_check(old[name], new[name])]
    for name in sorted(stored["tables"].keys() | fresh["tables"].keys()):
        a, b = stored["tables"].get(name), fresh["tables"].get(name)
        if not a or not b or a["header"] != b["header"] or len(a["rows"]) != len(b["rows"]):
            found.append(f"table {name}: other rows or columns")
            continue
        for old_row, new_row in zip(a["rows"], b["rows"]):
            found += [f"table {name}, {old_row[0]}, {head}: stored {x}, now {y}" for head, x, y in zip(a["header"], old_row, new_row)
                      if not TIME.search(head) and not same_cell(x, y)]
    return found


SAME_BITS = "same bits"  # source of checks on state hashes: they say that two are equal, their digits mean nothing
