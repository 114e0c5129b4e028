#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Every room has its folder of unit tests. Usage: unit_folders.py ROOT

A room is a folder that holds headers of ours (include/brunt/ROOM, contact's rooms among them, and partition) or is the
program's (src/app). Its tests are the *_test.cpp of tests/unit/ROOM.
"""
import os
import sys

import tree


def rooms(root):
    headers = tree.files(root, ("include/brunt",), (".hpp",))
    found = {os.path.relpath(os.path.dirname(path), "include/brunt") for path in headers}
    for folder, room in (("partition", "partition"), ("src/app", "app")):
        if tree.files(root, (folder,), (".hpp",)):
            found.add(room)
    return sorted(found)


def check(root):
    tested = {os.path.dirname(path) for path in tree.files(root, ("tests/unit",), ("_test.cpp",))}
    all_rooms = rooms(root)
    faults = [f"{room}: the room has no tests in tests/unit/{room}" for room in all_rooms
              if f"tests/unit/{room}" not in tested]
    return faults, f"{len(all_rooms)} rooms"


if __name__ == "__main__":
    sys.exit(tree.report("unit folders", *check(sys.argv[1])))
