#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Every room has its folder of unit tests. Usage: unit_folders.py ROOT [LAYERS]

Rooms are those of layers.txt that hold headers. Tests of a room are the *_test.cpp of tests/unit/ROOM.
"""
import os
import sys

import includes
import tree


def rooms(root, layers_text):
    known, _ = includes.read_layers(layers_text)
    headers = tree.files(root, ("src", "partition"), (".hpp",))
    found = {includes.room_of(path, known) for path in headers} - {None}
    return sorted(room for room in found if f"src/{room}.hpp" not in headers)  # a room of one file has no folder


def check(root, layers_text):
    tested = {os.path.dirname(path) for path in tree.files(root, ("tests/unit",), ("_test.cpp",))}
    all_rooms = rooms(root, layers_text)
    faults = [f"{room}: the room has no tests in tests/unit/{room}" for room in all_rooms
              if f"tests/unit/{room}" not in tested]
    return faults, f"{len(all_rooms)} rooms"


if __name__ == "__main__":
    layers = sys.argv[2] if len(sys.argv) > 2 else os.path.join(os.path.dirname(__file__), "layers.txt")
    sys.exit(tree.report("unit folders", *check(sys.argv[1], tree.read("", layers))))
