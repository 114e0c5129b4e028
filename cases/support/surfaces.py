# SPDX-License-Identifier: Apache-2.0
"""Closed surfaces for cases of penetration depth, written as OBJ files with all digits."""
import math


def prism(polygon, low, high):
    """A convex polygon in x and y, seen counter-clockwise, from z = low to high."""
    n = len(polygon)
    points = [(x, y, z) for z in (low, high) for x, y in polygon]
    faces = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    faces += [tuple(reversed(range(n))), tuple(range(n, 2 * n))]
    return points, faces


def box(low, high):
    return prism([(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])], low[2], high[2])


def plate_with_hole(half, hole, low, high):
    """A square plate of half-width `half` with a square hole of half-width `hole`."""
    def square(a):
        return [(-a, -a), (a, -a), (a, a), (-a, a)]
    points = [(x, y, z) for z in (low, high) for a in (half, hole) for x, y in square(a)]  # outer 0-3, inner 4-7; + 8 above
    faces = []
    for i in range(4):
        j = (i + 1) % 4
        faces += [(i, j, 8 + j, 8 + i), (4 + j, 4 + i, 12 + i, 12 + j), (8 + i, 8 + j, 12 + j, 12 + i), (j, i, 4 + i, 4 + j)]
    return points, faces


def torus_grid(n, m, f):
    """Points f(2 pi i/n, 2 pi j/m), quadrilaterals cut from (i, j) to (i + 1, j + 1)."""
    points = [f(2 * math.pi * i / n, 2 * math.pi * j / m) for i in range(n) for j in range(m)]
    faces = []
    for i in range(n):
        for j in range(m):
            a, b, c, d = (i * m + j, (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m)
            faces += [(a, b, c), (a, c, d)]
    return outward(points, faces)


def sphere_grid(n, m, f):
    """Poles f(0, 0) and f(0, 1), rings f(2 pi i/n, (r + 1)/(m + 1)), quadrilaterals cut from (r, i) to (r + 1, i + 1)."""
    points = [f(2 * math.pi * i / n, (r + 1) / (m + 1)) for r in range(m) for i in range(n)] + [f(0.0, 0.0), f(0.0, 1.0)]
    first, last = n * m, n * m + 1
    faces = []
    for r in range(m - 1):
        for i in range(n):
            a, b, c, d = r * n + i, (r + 1) * n + i, (r + 1) * n + (i + 1) % n, r * n + (i + 1) % n
            faces += [(a, b, c), (a, c, d)]
    for i in range(n):
        j = (i + 1) % n
        faces += [(first, i, j), (last, (m - 1) * n + j, (m - 1) * n + i)]
    return outward(points, faces)


def volume(points, faces):
    total = 0.0
    for face in faces:
        for k in range(1, len(face) - 1):
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = points[face[0]], points[face[k]], points[face[k + 1]]
            total += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    return total / 6


def outward(points, faces):
    return (points, faces) if volume(points, faces) > 0 else (points, [tuple(reversed(face)) for face in faces])


def write_obj(path, surface):
    points, faces = surface
    with open(path, "w", encoding="utf-8") as stream:
        for point in points:
            stream.write("v " + " ".join(repr(float(x)) for x in point) + "\n")
        for face in faces:
            stream.write("f " + " ".join(str(i + 1) for i in face) + "\n")
