#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Prisms in sockets with a clearance of 2e-4 to 3e-4 of the radius, turned about their axis by .3 to 4 degrees, in random frames. The turn back
is known. The free region is narrow, and the search may miss it: then it warns. A careful answer is never longer than the fast one.

    narrow_fits_test.py [--count N] [--seed S]

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

RADIUS, OUTER, HEIGHT = 5.0, 9.0, 20.0
ORDER = 1e-6  # relative: accuracy of a fast answer's final contact
NEAR = 1.05  # of the turn back: longer answers need a warning


def lathed(profile, sides):
    """Corners and triangles of a closed profile (radius, z) around z; radius 0 is on the axis."""
    rings, points = [], []
    for radius, z in profile:
        angles = 2 * np.pi * np.arange(sides) / sides
        corners = [(radius * np.cos(t), radius * np.sin(t), z) for t in (angles if radius else [0.0])]
        rings.append([len(points) + k % len(corners) for k in range(sides)])
        points += corners
    triangles = []
    for below, above in zip(rings, rings[1:] + rings[:1]):
        for i in range(sides):
            j = (i + 1) % sides
            triangles += [t for t in ((below[i], below[j], above[j]), (below[i], above[j], above[i])) if len(set(t)) == 3]
    return np.array(points), triangles


def write(path, points, triangles):
    with open(path, "w", encoding="utf-8") as stream:
        stream.writelines("v %.17g %.17g %.17g\n" % tuple(point) for point in points)
        stream.writelines("f %d %d %d\n" % tuple(k + 1 for k in triangle) for triangle in triangles)


def fault_of(variant, folder):
    dice = random.Random(variant)
    sides, clearance, degrees = dice.randint(3, 12), dice.uniform(1e-3, 1.6e-3), dice.uniform(0.3, 4)
    frame = random_rotation(dice)
    radius = RADIUS - clearance / np.cos(np.pi / sides)
    peg, socket = os.path.join(folder, "peg.obj"), os.path.join(folder, "socket.obj")
    half = HEIGHT / 2
    points, triangles = lathed([(0, -half), (radius, -half), (radius, half), (0, half)], sides)
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    write(peg, points @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) @ frame.T, triangles)
    points, triangles = lathed([(RADIUS, -half), (OUTER, -half), (OUTER, half), (RADIUS, half)], sides)
    write(socket, points @ frame.T, triangles)
    back = 2 * radius * np.sin(np.radians(degrees) / 2)
    depths = []
    for mode in ([], ["--careful"]):
        done = subprocess.run([os.environ["BRUNT"], "depth", peg, socket, *mode, "--json"], capture_output=True, text=True, timeout=300)
        if done.returncode:
            return f"exit code {done.returncode}: {done.stderr}"
        depths.append(json.loads(done.stdout)[0]["depth"])
        if depths[-1] > NEAR * back and "a shorter motion may have been missed" not in done.stderr:
            return f"{' '.join(mode)}: {depths[-1]:.4g} for {back:.4g} without a warning"
    return f"careful {depths[1]:.6g}, fast {depths[0]:.6g}, back {back:.6g}" if depths[1] > depths[0] * (1 + ORDER) else ""


if __name__ == "__main__":
    sys.exit(wrong_of(fault_of, 9) > 0)
