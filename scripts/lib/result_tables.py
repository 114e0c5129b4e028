# SPDX-License-Identifier: Apache-2.0
"""Marked tables of markdown pages from stored results (cases/support/results.py has the format).

    <!-- results: [FOLDER:][FORM/]TABLE [LABEL] -->
    ... what scripts/tables writes ...
    <!-- end of results -->

FOLDER (from the project's root; default: the page's own) has the results.json, FORM is one of its records (default: the first of short,
long, others that has the table). TABLE is one of the record's own tables, or

    checks   every check; with a LABEL only those called 'LABEL: quantity'
    beside   a row for each quantity, a column for each label; with LABELS (separated by ';', may hold *) only these
    by_run   the same, a row for each label
    worst    one row a quantity over all labels: how many checks, the largest error, the tolerance
    runs     what each run reports: elements, steps, iterations of contact, balance of energy, time
    overview one row for each folder below FOLDER: how many checks and runs, the error nearest to its tolerance, time, commit
"""
import fnmatch
import os
import re

import results
from results import SAME_BITS, figure

BLOCK = re.compile(r"(<!-- results: ([^>]+?) -->\n)(.*?)(<!-- end of results -->)", re.S)
FORMS = ("short", "long")
TABLES_OF_RECORDS = ("checks", "beside", "by_run", "worst", "runs")
UNNAMED_RUNS = ("hash_", "restart_")  # runs whose only outcome is a state hash


class Missing(Exception):
    """What a block asks for and the stored results have not."""


class NotStored(Missing):
    """No results of this kind have been stored yet: the block stays as it is."""


def markdown(header, rows):
    lines = [list(header), ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(str(cell).replace("|", "\\|") for cell in line) + " |" for line in lines)


def _number(value):
    """A figure of a check: enough digits to compare it with its reference."""
    return figure(value, results.DIGITS)


def _parts(check):
    label, colon, quantity = check["quantity"].partition(": ")
    return (label, quantity) if colon else ("", label)


def _bits(checks):
    """Checks of equal bits, as one row."""
    ranks = [word for c in checks for word in re.findall(r"^state on (\d+) ranks", c["quantity"])]
    restarts = [c["quantity"].removeprefix("state after ") for c in checks if "restart" in c["quantity"]]
    names = ([f"state on {', '.join(dict.fromkeys(ranks))} ranks"] if ranks else []) + \
            ([f"state after {', '.join(dict.fromkeys(restarts))}"] if restarts else [])
    others = len(checks) - len(ranks) - len(restarts)
    return "; ".join(names or [f"{others} comparisons of states"])


def _checks(record, label):
    chosen = [c for c in record["checks"] if not label or _parts(c)[0] == label]
    if not chosen:
        raise Missing(f"no check is called '{label}: ...'")
    rows, bits = [], [c for c in chosen if c["source"] == SAME_BITS]
    groups = {}
    for c in chosen:
        if c["source"] != SAME_BITS:
            groups.setdefault(c["quantity"], []).append(c)
    for group in sorted(groups.values(), key=lambda group: len(group) > 1):  # those of every run come last
        c = max(group, key=lambda c: c["error"] or 0)
        name = (_parts(c)[1] if label else c["quantity"]) + (f" (largest of {len(group)})" if len(group) > 1 else "")
        small = c["expected"] == 0 and c.get("absolute")
        computed = figure(c["computed"], 2) if small and isinstance(c["computed"], float) else _number(c["computed"])
        error = "" if small or not isinstance(c["error"], float) or isinstance(c["expected"], str) else figure(c["error"], 2)
        tolerance = "within" if isinstance(c["expected"], str) and c["tolerance"] == 0 else figure(c["tolerance"], 3)
        rows.append([name, _number(c["expected"]), computed, error, tolerance, c["source"]])
    if bits:
        rows.append([_bits(bits), "same bits", "same bits", "", "equal", ""])
    header = ["quantity", "reference", "computed", "error", "tolerance", "source"]
    if not any(row[-1] for row in rows):
        header, rows = header[:-1], [row[:-1] for row in rows]
    return header, rows


def _labelled(record, patterns):
    """Checks called 'LABEL: quantity' of the labels that fit: labels, quantities, and the check of each pair."""
    fits = [pattern.strip() for pattern in patterns.split(";") if pattern.strip()] or ["*"]
    found = {}
    for c in record["checks"]:
        label, quantity = _parts(c)
        if label and c["source"] != SAME_BITS and any(fnmatch.fnmatchcase(label, fit) for fit in fits):
            found[label, quantity] = c
    if not found:
        raise Missing(f"no check has a label like '{patterns}'")
    return list(dict.fromkeys(l for l, _ in found)), list(dict.fromkeys(q for _, q in found)), found


def _cell(check, with_reference):
    """A computed figure; behind it its reference, or its error where the reference stands elsewhere."""
    if check is None:
        return ""
    small = check["expected"] == 0 and check.get("absolute")
    if small or isinstance(check["computed"], str):
        return figure(check["computed"], 2)
    if isinstance(check["expected"], str):
        return _number(check["computed"])
    reference = [_number(check["expected"])] if with_reference else []
    share = abs(check["computed"] / check["expected"] - 1) if check["expected"] else 0
    error = [f"{figure(100 * share, 2)} %"] if share > results.ROUNDING else []
    behind = "; ".join(reference + error)
    return _number(check["computed"]) + (f" ({behind})" if behind else "")


def _tolerance(checks):
    """The tolerance, or the smallest and the largest; nothing for bounds, which the reference has."""
    found = [c["tolerance"] for c in checks if isinstance(c["tolerance"], (int, float)) and not isinstance(c["expected"], str)]
    return " to ".join(dict.fromkeys(figure(t, 3) for t in (min(found), max(found)))) if found else ""


def _beside(record, patterns):
    labels, quantities, found = _labelled(record, patterns)
    rows = []
    for quantity in quantities:
        checks = [found.get((label, quantity)) for label in labels]
        there = [c for c in checks if c]
        references = list(dict.fromkeys(_number(c["expected"]) for c in there))
        own = len(references) > 1
        rows.append([quantity, "in brackets" if own else references[0], *(_cell(c, own) for c in checks), _tolerance(there)])
    return ["quantity", "reference", *labels, "tolerance"], rows


def _by_run(record, patterns):
    labels, quantities, found = _labelled(record, patterns)
    columns = []
    for quantity in quantities:
        checks = [found.get((label, quantity)) for label in labels]
        there = [c for c in checks if c]
        references = list(dict.fromkeys(_number(c["expected"]) for c in there))
        own = len(references) > 1
        head = quantity + (" (reference)" if own else "" if there[0].get("absolute") and there[0]["expected"] == 0 else f"; reference {references[0]}")
        columns.append([head, *(_cell(c, own) for c in checks), _tolerance(there)])
    return ["run", *(column[0] for column in columns)], [[name, *(column[i + 1] for column in columns)]
                                                           for i, name in enumerate([*labels, "tolerance"])]


def _worst(record):
    groups, bits = {}, [c for c in record["checks"] if c["source"] == SAME_BITS]
    for c in record["checks"]:
        if c["source"] != SAME_BITS:
            groups.setdefault(_parts(c)[1], []).append(c)
    rows = []
    for quantity, checks in groups.items():
        errors = [c["error"] for c in checks if isinstance(c["error"], (int, float))]
        tolerances = sorted({c["tolerance"] for c in checks if isinstance(c["tolerance"], (int, float))})
        if len(checks) == 1 and isinstance(checks[0]["expected"], str):  # a bound or an equality: its figure says more
            error, tolerance = _number(checks[0]["computed"]), checks[0]["expected"]
        elif isinstance(checks[0]["expected"], str):
            values = [c["computed"] for c in checks]
            numbers = all(isinstance(v, (int, float)) for v in values)
            error = f"{figure(min(values))} .. {figure(max(values))}" if numbers else ", ".join(dict.fromkeys(map(str, values)))
            tolerance = ", ".join(dict.fromkeys(c["expected"] for c in checks))
        else:
            error = figure(max(errors, default=None), 2)
            tolerance = " to ".join(dict.fromkeys(figure(t, 3) for t in tolerances[:1] + tolerances[-1:]))
        rows.append([quantity, str(len(checks)), error, tolerance])
    if bits:
        rows.append([_bits(bits), str(len(bits)), "same bits", "equal"])
    return ["quantity", "checks", "largest error, or range", "tolerance, or bounds"], rows


def _runs(record):
    rows = []
    for run in record["runs"]:
        if run["name"].startswith(UNNAMED_RUNS):
            continue
        iterations = "" if not run["iterations_max"] else f"{figure(run['iterations_mean'], 3)}, {run['iterations_max']}"
        name = "the scene as it is" if re.fullmatch(r"np\d+", run["name"]) else run["name"].replace("_", " ")
        rows.append([name, run["scene"], str(run["ranks"]), str(run["elements"]), str(run["steps"]), iterations,
                     figure(run["energy_error"], 1), figure(run["loop_s"], 2)])
    header = ["run", "scene", "ranks", "elements", "steps", "iterations of contact, mean and most", "balance of energy", "loop [s]"]
    if len({row[1] for row in rows}) == 1:
        header, rows = header[:1] + header[2:], [row[:1] + row[2:] for row in rows]
    return header, rows


def _overview(root, folder):
    rows = []
    for name in sorted(os.listdir(folder)):
        record = results.load(os.path.join(folder, name, "results.json")).get("short")
        if record:
            checks = record["checks"]
            shares = [c["error"] / c["tolerance"] for c in checks if isinstance(c["error"], (int, float)) and isinstance(c["tolerance"], (int, float))
                      and c["tolerance"] > 0]
            passed = sum(c["passed"] for c in checks)
            rows.append([f"[{name}]({name}/README.md)", str(len(checks)), str(passed), f"{100 * max(shares, default=0):.0f}", str(len(record["runs"])),
                         figure(sum(run["loop_s"] for run in record["runs"]), 2), record["commit"], record["date"]])
    if not rows:
        raise Missing(f"no folder below {os.path.relpath(folder, root)} has results")
    header = ["case", "checks", "passed", "largest error / its tolerance [%]", "runs", "loop of all runs [s]", "commit", "date"]
    return f"{markdown(header, rows)}\n\n`scripts/tables --run`, short form.\n"


def _record_with(forms, form, table):
    if form:
        if form not in forms:
            raise NotStored(f"no results of the form '{form}' are stored")
        return form, forms[form]
    order = [f for f in FORMS if f in forms] + sorted(set(forms) - set(FORMS))
    for name in order:
        if table in forms[name]["tables"] or (table in TABLES_OF_RECORDS and forms[name]["checks"]):
            return name, forms[name]
    kind = Missing if "short" in forms else NotStored
    raise kind(f"no stored results have a table '{table}'")


def block(root, page_folder, spec):
    """The text between the two marks: a table and where it comes from."""
    words, _, label = spec.strip().partition(" ")
    folder, colon, words = words.rpartition(":")
    folder = os.path.join(root, folder) if colon else page_folder
    form, slash, table = words.rpartition("/")
    if table == "overview":
        return _overview(root, folder)
    path = os.path.join(folder, "results.json")
    if not os.path.exists(path):
        raise NotStored(f"{os.path.relpath(path, root)} is not there")
    form, record = _record_with(results.load(path), form if slash else "", table)
    makers = {"checks": lambda: _checks(record, label), "beside": lambda: _beside(record, label),
              "by_run": lambda: _by_run(record, label), "worst": lambda: _worst(record), "runs": lambda: _runs(record)}
    if table in makers:
        header, rows = makers[table]()
    elif table in record["tables"]:
        header, rows = record["tables"][table]["header"], record["tables"][table]["rows"]
    else:
        raise Missing(f"the results of the form '{form}' have no table '{table}'")
    return f"{markdown(header, rows)}\n\n`{record['command']}`, commit {record['commit']}, {record['date']}.\n"


def filled(root, page):
    """The page's text, the text with every block written anew, faults, and blocks whose results have not been stored: a line each."""
    with open(os.path.join(root, page), encoding="utf-8") as stream:
        text = stream.read()
    faults, empty = [], []

    def write(match):
        try:
            return match[1] + block(root, os.path.dirname(os.path.join(root, page)), match[2]) + match[4]
        except Missing as missing:
            lines = empty if isinstance(missing, NotStored) else faults
            lines.append(f"{page}: results: {match[2]}: {missing}")
            return match[0]

    new = BLOCK.sub(write, text)
    marks = text.count("<!-- results: "), text.count("<!-- end of results -->")
    if marks[0] != marks[1]:
        faults.append(f"{page}: {marks[0]} blocks of results begin and {marks[1]} end")
    return text, new, faults, empty


def pages(root):
    """All markdown pages of the project that have a block, relative to the root."""
    for here, below, names in os.walk(root):
        below[:] = sorted(b for b in below if not b.startswith(("build", ".", "__pycache__")) and not b.endswith(".out"))
        for name in sorted(names):
            if name.endswith(".md"):
                path = os.path.join(here, name)
                with open(path, encoding="utf-8") as stream:
                    if "<!-- results: " in stream.read():
                        yield os.path.relpath(path, root)
