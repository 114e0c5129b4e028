#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Licence line in every source file, nothing unfinished left in the tree, one format. Usage: text.py ROOT licence|leftovers|format"""
import re
import shutil
import subprocess
import sys

import tree

SOURCES = ("include", "src", "partition", "tests", "scripts", "cases", "CMakeLists.txt")
LICENCE = "SPDX-License-Identifier: Apache-2.0"
LEFTOVER = re.compile(r"\b(TODO|FIXME|XXX)\b|/tmp/")
SKIP_CODE = 77  # ctest reports the test as skipped


def check_licence(root):
    paths = tree.files(root, SOURCES, (".cpp", ".hpp", ".h", ".py", "CMakeLists.txt", ".cmake", ".sh"))
    paths = sorted(set(paths) | {p for p in tree.files(root, ("scripts", ".ci"), ("",)) if tree.read(root, p).startswith("#!")})
    faults = [f"{p}: '{LICENCE}' is missing at its top" for p in paths
              if not any(LICENCE in line for line in tree.read(root, p).splitlines()[:2])]
    return faults, f"{len(paths)} files"


def check_leftovers(root):
    faults = []
    folders = ("include", "src", "partition", "cases", "scripts", "README.md", "CHANGELOG.md")
    text_files = (".cpp", ".hpp", ".py", ".md", ".yaml", ".txt", ".sh", ".cmake")
    paths = set(tree.files(root, folders, text_files)) | set(tree.files(root, ("scripts",), ("",)))
    for path in sorted(paths):
        for number, line in enumerate(tree.read(root, path).splitlines(), 1):
            if LEFTOVER.search(line):
                faults.append(f"{path}:{number}: {line.strip()}")
    return faults, f"{len(paths)} files"


def check_format(root):
    if not shutil.which("clang-format"):
        print("format: skipped, clang-format is not installed")
        sys.exit(SKIP_CODE)
    paths = tree.files(root, ("include", "src", "partition", "tests"), (".cpp", ".hpp"))
    if not paths:
        return [], "no files"
    run = subprocess.run(["clang-format", "--dry-run", "-Werror", *paths], cwd=root, capture_output=True, text=True)
    wrong = sorted({line.split(":")[0] for line in run.stderr.splitlines() if "-Wclang-format-violations" in line})
    if run.returncode and not wrong:
        wrong = [run.stderr.strip()]
    return [f"{p}: run clang-format -i on it" for p in wrong], f"{len(paths)} files"


if __name__ == "__main__":
    checks = {"licence": check_licence, "leftovers": check_leftovers, "format": check_format}
    sys.exit(tree.report(sys.argv[2], *checks[sys.argv[2]](sys.argv[1])))
