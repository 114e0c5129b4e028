#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Surfaces with collinear slivers: a point in an edge of one triangle only, and the triangle without area, up to the digits of
the file, that closes the gap. A box of edge 2 stands d deep in a plate; the shortest translation is d, whatever the frame.

    slivers_test.py [--count N] [--seed S]

Needs BRUNT, the program.
"""
import json
import os
import random
import subprocess
import sys

import numpy as np

from fits import random_rotation
from variants import wrong_of

SIDES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
TRIANGLES = [t for a, b, c, d in SIDES for t in ((a, b, c), (a, c, d))]
NEAR = 1e-3  # of the depth: the accuracy of a fast answer
DIGITS = {"stl": (6, 7, 9, 17), "obj": (6, 9, 17)}


def corners(low, high):
    (a, b, c), (d, e, f) = low, high
    return [np.array(x, float) for x in
            ((a, b, c), (d, b, c), (d, e, c), (a, e, c), (a, b, f), (d, b, f), (d, e, f), (a, e, f))]


def with_slivers(points, triangles, count, draw):
    """Each in the edge of another triangle of the box."""
    points, triangles = list(points), list(triangles)
    for k in draw.sample(range(len(triangles)), count):
        a, b, c = triangles[k]
        middle = len(points)
        points.append(points[a] + (points[b] - points[a]) * draw.choice([0.5, 0.25, 0.1, draw.random()]))
        triangles[k] = (a, middle, c)
        triangles += [(middle, b, c), (a, b, middle)]
    draw.shuffle(triangles)
    return points, triangles


def write(path, points, triangles, digits):
    words = [" ".join(f"%.{digits}g" % x for x in point) for point in points]
    with open(path, "w", encoding="ascii") as out:
        if path.endswith(".obj"):
            out.writelines(f"v {word}\n" for word in words)
            out.writelines("f " + " ".join(str(i + 1) for i in t) + "\n" for t in triangles)
            return
        out.write("solid s\n")
        for t in triangles:
            out.write("facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {words[i]}\n" for i in t) + "endloop\nendfacet\n")
        out.write("endsolid s\n")


def fault_of(variant, folder):
    """What is wrong with the answers; empty if nothing is."""
    draw = random.Random(variant)
    turn, shift, depth = random_rotation(draw), [draw.uniform(-9, 9) for _ in range(3)], draw.uniform(0.05, 0.5)
    kind = draw.choice(sorted(DIGITS))
    digits, size = draw.choice(DIGITS[kind]), 10 ** draw.uniform(-3, 3)
    placed = lambda points, lift: [size * (turn @ (x + (0, 0, lift)) + shift) for x in points]
    block, plate = f"{folder}/block.{kind}", f"{folder}/plate.{kind}"
    write(block, *with_slivers(placed(corners((-1, -1, -1), (1, 1, 1)), 2 - depth), TRIANGLES, draw.randint(1, 3), draw), digits)
    write(plate, *with_slivers(placed(corners((-2, -2, -1), (2, 2, 1)), 0), TRIANGLES, draw.randint(0, 1), draw), digits)
    files = [block, plate] if draw.random() < 0.5 else [plate, block]
    mode = draw.choice([[], ["--careful"], ["--certify", "0.1", "--boxes", "2000"]])
    call = [os.environ["BRUNT"], "depth", *files, "--metric", "translation", *mode]
    shown, done = (subprocess.run([*call, *more], capture_output=True, text=True, check=False, timeout=120)
                   for more in ([], ["--json"]))
    if done.returncode != 0:
        return f"exit {done.returncode}: {done.stderr}"
    row, = json.loads(done.stdout)
    found, bound = row["depth"] / (depth * size), row["bound"] / (depth * size)
    near = NEAR + 60 * 10.0 ** -min(digits, 7) / depth  # coordinates up to 18 edges away, of so many digits
    told = f"{kind}, {digits} digits, {mode}: depth {found:.6f}, bound {bound:.6f} of the true depth"
    if abs(found - 1) > near or bound > 1 + near:
        return told
    proven, crosses = row["proven"], "intersect or touch" in done.stderr
    if proven == crosses or ("no motion shorter" in shown.stdout) == crosses:
        return told + f"; surfaces cross: {crosses}, proven: {proven}: {shown.stdout}"
    return ""


if __name__ == "__main__":
    sys.exit(wrong_of(fault_of, 10) > 0)
