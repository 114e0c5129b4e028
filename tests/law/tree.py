# SPDX-License-Identifier: Apache-2.0
"""The files of the project that the walls look at."""
import os

SKIPPED_FOLDERS = ("build", ".", "__pycache__")


def files(root, folders, suffixes):
    """Paths relative to root, sorted, of all files below `folders` whose name ends in one of `suffixes`."""
    found = []
    for folder in folders:
        if os.path.isfile(os.path.join(root, folder)):
            found.append(folder)
        for here, below, names in os.walk(os.path.join(root, folder)):
            below[:] = [b for b in below if not b.startswith(SKIPPED_FOLDERS) and not b.endswith(".out")]
            found += [os.path.relpath(os.path.join(here, n), root) for n in names if n.endswith(tuple(suffixes))]
    return sorted(found)


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8", errors="replace") as stream:
        return stream.read()


def report(name, faults, summary):
    """Prints the outcome of a wall; the exit code for it."""
    for fault in faults:
        print(fault)
    print(f"{name}: {len(faults)} fault(s); {summary}")
    return 1 if faults else 0
