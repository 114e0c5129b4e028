#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes cylinders.inp: two half cylinders on each other, a slab of one hexahedron between y = 0 and y = depth.

usage: mesh.py [FILE] [--facet F] [--whole]        F: length of a facet of the upper body in the contact zone (default a/5)

Of both only x >= 0 is written, unless they are asked for as a whole.

The contact zone is a square of equal elements at the lowest point; around it lie half rings in polar coordinates about
that point, whose elements grow with the radius, out to the flat side. Facets of the lower body are 1.3 times as long.
"""
import argparse
import math
import os

import numpy

RADIUS = 8.0
ZONE = 1.0       # side of the square of equal elements, unless another is asked for: 1.47 half widths at P = 10
LONGER = 1.3     # facets of the lower body
RINGS = 2.0      # elements outside the square are so many times as long along the radius as across it


def sink_for(facet):
    """Overlap at which the gap weighted over the facets beside the lowest point is negative: the gap at their ends."""
    return facet ** 2 / RADIUS


def angle_of_arc(r):
    """Angle above the x axis at which a circle of radius r about the lowest point meets the cylinder."""
    return math.asin(r / (2 * RADIUS))


def place(share, r):
    """Point at the distance r from the lowest point; share 0: on the cylinder, 1: in the plane x = 0."""
    arc = angle_of_arc(r)
    angle = arc + share * (math.pi / 2 - arc)
    return numpy.array([r * math.cos(angle) if share < 1 else 0.0, r * math.sin(angle)])


def to_flat_side(share):
    """Distance at which the ray of this share meets z = RADIUS."""
    low, high = 0.9 * RADIUS, 1.5 * RADIUS
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if place(share, middle)[1] < RADIUS else (low, middle)
    return 0.5 * (low + high)


def quarter(facet, side):
    """Points [n][2] (x, z) and quadrilaterals [m][4] of the upper body, lowest point at the origin."""
    n = max(2, round(side / facet))
    zone = n * facet
    around = 2 * n
    inner = [zone / max(math.cos(math.pi / 2 * j / around), math.sin(math.pi / 2 * j / around)) for j in range(around + 1)]
    outer = [to_flat_side(j / around) for j in range(around + 1)]
    rings = max(2, round(math.log(RADIUS / zone) / (RINGS * math.pi / 2 / around)))
    points, number = [], {}

    def add(key, point):
        number[key] = len(points)
        points.append(point)
    rim = [place(j / around, inner[j]) for j in range(around + 1)]
    foot, axis = [place(0, i * facet) for i in range(n + 1)], [numpy.array([0, i * facet]) for i in range(n + 1)]
    right, top = rim[:n + 1], rim[:n - 1:-1]
    for j in range(n + 1):
        for i in range(n + 1):
            u, v = i / n, j / n
            point = (1 - v) * foot[i] + v * top[i] + (1 - u) * axis[j] + u * right[j] - (
                (1 - u) * (1 - v) * foot[0] + u * (1 - v) * foot[n] + u * v * top[n] + (1 - u) * v * top[0])
            add(("square", i, j), foot[i] if j == 0 else axis[j] if i == 0 else point)
    for k in range(rings + 1):
        for j in range(around + 1):
            if k == 0:
                number["ring", j, 0] = number["square", n, j] if j <= n else number["square", around - j, n]
            else:
                add(("ring", j, k), place(j / around, inner[j] ** (1 - k / rings) * outer[j] ** (k / rings)))
    for j in range(around + 1):
        points[number["ring", j, rings]][1] = RADIUS
    points[number["ring", 0, rings]] = numpy.array([RADIUS, RADIUS])
    quads = [[number["square", i, j], number["square", i + 1, j], number["square", i + 1, j + 1], number["square", i, j + 1]]
             for j in range(n) for i in range(n)]
    quads += [[number["ring", j, k], number["ring", j, k + 1], number["ring", j + 1, k + 1], number["ring", j + 1, k]]
              for k in range(rings) for j in range(around)]
    return numpy.array(points), numpy.array(quads)


def mirrored(points, quads):
    """Both halves of a body; nodes in x = 0 are common."""
    apart = abs(points[:, 0]) > 1e-12
    other = numpy.where(apart, len(points) + numpy.cumsum(apart) - 1, numpy.arange(len(points)))
    return numpy.concatenate([points, points[apart] * [-1, 1]]), numpy.concatenate([quads, other[quads][:, ::-1]])


def write(path, facet, depth, sink, zone=ZONE, whole=False):
    """sink: by how much the upper body lies in the lower one at the start, so that something holds it."""
    first, lines, elements, surfaces, count = 1, [], [], [], 1
    for name, length, up in (("low", LONGER * facet, -1), ("top", facet, 1)):
        points, quads = quarter(length, zone)
        if whole:
            points, quads = mirrored(points, quads)
        n = len(points)
        for y in (0, depth):
            lines += [f"{first + i + (n if y else 0)}, {x:.12g}, {y:.12g}, {up * z - (sink if up > 0 else 0):.12g}\n"
                      for i, (x, z) in enumerate(points)]
        elements.append(f"*ELEMENT, TYPE=C3D8, ELSET={name}\n")
        surface = f"*SURFACE, TYPE=ELEMENT, NAME={name}_flat\n"
        for quad in quads:
            front = [first + c for c in (quad if up < 0 else quad[::-1])]  # faces y = 0 as seen from within
            corners = front + [c + n for c in front]
            elements.append(f"{count}, " + ", ".join(map(str, corners)) + "\n")
            for side in range(4):
                a, b = front[side] - first, front[(side + 1) % 4] - first
                if abs(points[a][1] - RADIUS) < 1e-9 and abs(points[b][1] - RADIUS) < 1e-9:
                    surface += f"{count}, S{3 + side}\n"
            count += 1
        surfaces.append(surface)
        first += 2 * n
    with open(path, "w", encoding="utf-8") as out:
        out.writelines(["*NODE\n", *lines, *elements, *surfaces])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", nargs="?", default=os.path.join(os.path.dirname(os.path.abspath(__file__)), "cylinders.inp"))
    parser.add_argument("--facet", type=float, default=0.6807783738 / 5)
    parser.add_argument("--whole", action="store_true")
    given = parser.parse_args()
    write(given.file, given.facet, depth=0.1, sink=1e-4 if given.whole else sink_for(given.facet), whole=given.whole)
