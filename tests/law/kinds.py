#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Every test case says what it is compared with. Usage: kinds.py ROOT

[oracle]      an exact, published, measured or brute-force value that the program did not make
[law]         what must hold: momentum, energy, symmetry, objectivity, bits, a criterion set in advance
[regression]  our own earlier figure plus a margin; only in tests/regression, where every case is one and has a line
              "ours:" with the figure beside its gates
"""
import re
import sys

import tree

KINDS = ("oracle", "law", "regression")
FOLDERS = ("tests/hard", "tests/verification", "tests/regression")
CASE = re.compile(r"^(?:TEMPLATE_)?TEST_CASE\s*\(", re.M)
STRING = re.compile(r'\s*"((?:\\.|[^"\\])*)"')


def strings(text, position):
    """The first two string arguments at `position`; neighbouring literals are one."""
    found, current = [], None
    while len(found) < 2:
        match = STRING.match(text, position)
        if match:
            current = (current or "") + match.group(1)
            position = match.end()
            continue
        if current is not None:
            found.append(current)
            current = None
        comma = re.compile(r"\s*,").match(text, position)
        if not comma:
            break
        position = comma.end()
    return (found + ["", ""])[:2]


def cases(text):
    """(name, tags, line, text from the end of what comes before to the end of the case)."""
    starts = list(CASE.finditer(text))
    for match in starts:
        name, tags = strings(text, match.end())
        before = text.rfind("\n}", 0, match.start())
        end = text.find("\n}", match.start())
        yield name, tags, text.count("\n", 0, match.start()) + 1, text[max(before, 0):end]


def check_case(path, name, tags, line, text):
    kinds = [kind for kind in KINDS if f"[{kind}]" in tags]
    place = f"{path}:{line}: '{name}'"
    if "[table]" in tags:
        return []  # prints figures, judges nothing
    if not kinds:
        return [f"{place} has none of the tags " + ", ".join(f"[{kind}]" for kind in KINDS)]
    if path.startswith("tests/regression/"):
        faults = [] if kinds == ["regression"] else [f"{place} is in tests/regression, and no [regression] alone"]
        return faults + ([] if "ours:" in text else [f"{place} has no line 'ours:' with our figure and the margin"])
    return [f"{place} belongs to tests/regression"] if "regression" in kinds else []


def check(root):
    faults, count = [], 0
    for path in tree.files(root, FOLDERS, ("_test.cpp",)):
        for case in cases(tree.read(root, path)):
            faults += check_case(path, *case)
            count += 1
    return faults, f"{count} cases"


if __name__ == "__main__":
    sys.exit(tree.report("kinds of tests", *check(sys.argv[1])))
