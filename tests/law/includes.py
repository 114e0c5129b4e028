#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Holds every #include of the project against layers.txt. Usage: includes.py ROOT [LAYERS]"""
import os
import re
import sys

import tree

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)
CODE = (".cpp", ".hpp", ".h", ".c")


def read_layers(text):
    rooms, vendors = {}, {}
    for line in text.splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        name, allowed = line.split(":", 1)
        if name.startswith("vendor "):
            vendors[name[len("vendor "):].strip()] = tuple(allowed.split())
        else:
            rooms[name] = set(allowed.split())
    return rooms, vendors


def room_of(path, rooms):
    """The longest room that the path lies in, None outside the rooms."""
    path = re.sub(r"^include/brunt/", "api/", re.sub(r"^src/", "", path))
    inside = [r for r in rooms if re.match(re.escape(r) + r"([./]|$)", path)]
    return max(inside, key=len, default=None)


def find_circle(graph):
    """One circle of a graph {node: nodes} as a list that ends where it begins; empty if there is none."""
    done, path = set(), []

    def visit(node):
        if node in path:
            return path[path.index(node):] + [node]
        if node in done:
            return []
        path.append(node)
        for following in sorted(graph.get(node, ())):
            circle = visit(following)
            if circle:
                return circle
        path.pop()
        done.add(node)
        return []

    return next((c for c in map(visit, sorted(graph)) if c), [])


def folder_of(path):
    """The folder of a file, by its room's name."""
    return os.path.dirname(re.sub(r"^include/brunt/", "api/", re.sub(r"^src/", "", path)))


def folders_of(graph):
    """Which folders include which others, of a graph {file: files}; tests stand outside."""
    folders = {}
    for path, included in graph.items():
        if not path.startswith("tests"):
            own = folders.setdefault(folder_of(path), set())
            own |= {folder_of(i) for i in included} - {folder_of(path)}
    return folders


def resolve(root, includer, included):
    """The project's own file that an include names, or None."""
    for place in (os.path.dirname(includer), "src", "include", ""):
        path = os.path.normpath(os.path.join(place, included))
        if os.path.isfile(os.path.join(root, path)):
            return path
    return None


def check_file(path, own_includes, all_includes, rooms, vendors):
    faults = []
    room = room_of(path, rooms)
    if room is None:
        faults.append(f"{path}: lies in no room of layers.txt")
        return faults
    for included in own_includes:
        other = room_of(included, rooms)
        if other not in (room, "core", None) and other not in rooms[room] and "*" not in rooms[room]:
            faults.append(f"{path}: {room} may not include {other} ({included})")
    for included in all_includes:
        for vendor, places in vendors.items():
            if included.startswith(vendor) and not path.startswith(places):
                faults.append(f"{path}: {included} is allowed in {', '.join(places)} only")
    return faults


def check(root, layers_text):
    rooms, vendors = read_layers(layers_text)
    faults = []
    circle = find_circle({r: (allowed - {"*"}) | ({"core"} - {r}) for r, allowed in rooms.items()})
    if circle:
        faults.append("layers.txt: circle of rooms " + " -> ".join(circle))
    for room, allowed in rooms.items():
        faults += [f"layers.txt: {room} may include {a}, which is no room" for a in allowed - set(rooms) - {"*"}]

    graph = {}
    for path in tree.files(root, ("include", "src", "partition", "tests"), CODE):
        included = INCLUDE.findall(tree.read(root, path))
        own = [p for p in (resolve(root, path, i) for i in included) if p]
        graph[path] = set(own)
        faults += [f"{path}: includes a source file, {i}" for i in included if i.endswith((".cpp", ".c"))]
        if not path.startswith("tests"):
            faults += check_file(path, own, included, rooms, vendors)
    circle = find_circle(graph)
    if circle:
        faults.append("circle of files " + " -> ".join(circle))
    circle = find_circle(folders_of(graph))
    if circle:
        faults.append("circle of folders " + " -> ".join(circle))
    return faults, f"{len(graph)} files, {sum(map(len, graph.values()))} includes of our own"


if __name__ == "__main__":
    layers = sys.argv[2] if len(sys.argv) > 2 else os.path.join(os.path.dirname(__file__), "layers.txt")
    with open(layers, encoding="utf-8") as stream:
        sys.exit(tree.report("include law", *check(sys.argv[1], stream.read())))
