#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes nose.inp: a quarter of a nose cone with two nested limiters, shells of revolution of hexahedra (Abaqus format).

usage: mesh.py [FILE] [--density N]        N = 1 (default), 2: elements twice as short along and around

Each shell is a polygon (radius, height) [mm] with a thickness, two elements through it, in x >= 0, y >= 0.
"""
import argparse
import math
import os

# name: (points of the middle line, thickness, elements along, around the quarter)
SHELLS = {"nose": ([(26, 0.75), (50, 100)], 3.0, 24, 8),           # cone, its tip cut off
          "core": ([(14, 10), (14, 100)], 3.0, 22, 6),              # tube, short of the wall
          "flare": ([(23, 30), (33, 60), (24, 97)], 3.0, 18, 8)}   # two cones, large end to large end: buckles outward
THROUGH = 2


def along(points, share):
    """A point of the polygon at a share of its length, and the normal there (mean of both sides at a corner)."""
    lengths = [math.dist(a, b) for a, b in zip(points, points[1:])]
    normals = [((b[1] - a[1]) / d, (a[0] - b[0]) / d) for (a, b), d in zip(zip(points, points[1:]), lengths)]
    left = share * sum(lengths)
    for k, d in enumerate(lengths):
        if left <= d * (1 + 1e-12):
            a, b, t = points[k], points[k + 1], left / d
            normal = normals[k]
            if t > 1 - 1e-9 and k + 1 < len(normals):
                both = (normal[0] + normals[k + 1][0], normal[1] + normals[k + 1][1])
                size = (both[0] ** 2 + both[1] ** 2) / 2  # so that both sides keep their thickness
                normal = (both[0] / size, both[1] / size)
            return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])), normal
        left -= d
    raise ValueError("share beyond 1")


def shell(points, thickness, count, around, first):
    """Nodes [(x, y, z)] and hexahedra (numbers from `first`)."""
    nodes = []
    for i in range(count + 1):
        (r, z), (nr, nz) = along(points, i / count)
        for k in range(THROUGH + 1):
            off = (k / THROUGH - 0.5) * thickness
            for j in range(around + 1):
                angle = math.pi / 2 * j / around
                c, s = (1.0, 0.0) if j == 0 else (0.0, 1.0) if j == around else (math.cos(angle), math.sin(angle))
                nodes.append(((r + off * nr) * c, (r + off * nr) * s, z + off * nz))

    def at(i, k, j):
        return first + (i * (THROUGH + 1) + k) * (around + 1) + j

    hexes = [(at(i, k, j), at(i, k + 1, j), at(i, k + 1, j + 1), at(i, k, j + 1),
              at(i + 1, k, j), at(i + 1, k + 1, j), at(i + 1, k + 1, j + 1), at(i + 1, k, j + 1))
             for i in range(count) for k in range(THROUGH) for j in range(around)]
    return nodes, hexes


def write(path, density=1):
    nodes, blocks = [], []
    for name, (points, thickness, count, around) in SHELLS.items():
        new, hexes = shell(points, thickness, round(count * density), round(around * density), len(nodes) + 1)
        nodes += new
        blocks.append((name, hexes))
    with open(path, "w", encoding="utf-8") as out:
        out.write("*NODE\n" + "".join(f"{i}, {x:.9g}, {y:.9g}, {z:.9g}\n" for i, (x, y, z) in enumerate(nodes, 1)))
        number = 1
        for name, hexes in blocks:
            out.write(f"*ELEMENT, TYPE=C3D8R, ELSET={name}\n")
            for corners in hexes:
                out.write(f"{number}, " + ", ".join(map(str, corners)) + "\n")
                number += 1


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", nargs="?", default=os.path.join(os.path.dirname(os.path.abspath(__file__)), "nose.inp"))
    parser.add_argument("--density", type=float, default=1)
    given = parser.parse_args()
    write(given.file, given.density)
