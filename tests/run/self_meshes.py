# SPDX-License-Identifier: Apache-2.0
"""Meshes of bodies that meet themselves, as Abaqus decks: boxes of one part or of several, folded strips."""
import math

import numpy


def box(size, elements, at=(0, 0, 0)):
    """Points [n][3] and hexahedra [m][8] of a box."""
    nx, ny, nz = elements
    number = numpy.arange((nx + 1) * (ny + 1) * (nz + 1)).reshape(nx + 1, ny + 1, nz + 1)
    axes = [numpy.linspace(0, size[c], elements[c] + 1) + at[c] for c in range(3)]
    points = numpy.stack(numpy.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    corner = [number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]]
    hexes = numpy.stack([c[:, :, :-1] for c in corner] + [c[:, :, 1:] for c in corner], axis=-1).reshape(-1, 8)
    return points, hexes


def along(path, thickness, layers, depth):
    """A strip along a path in the plane z = 0, points [n][2]; one element deep in z."""
    offsets = numpy.linspace(-0.5, 0.5, layers + 1) * thickness
    plane = path[:, None, :] + offsets[None, :, None] * _to_left(path)[:, None, :]
    n, m = plane.shape[:2]
    number = numpy.arange(n * m).reshape(n, m)
    points = numpy.concatenate([numpy.concatenate([plane.reshape(-1, 2), numpy.full((n * m, 1), z)], axis=1) for z in (0.0, depth)])
    quads = numpy.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1).reshape(-1, 4)
    return points, numpy.concatenate([quads, quads + n * m], axis=1)


def bellows(folds, length, pitch, thickness, edge, layers=2, depth=0.5):
    """A strip of straight layers `length` long, `pitch` apart from middle to middle, joined by half circles."""
    straight, around = max(1, round(length / edge)), max(4, round(math.pi * pitch / 2 / edge))
    path = []
    for fold in range(folds + 1):
        ahead, y = (1, -1)[fold % 2], fold * pitch
        start = 0 if ahead > 0 else length
        for k in range(straight + 1):
            path.append([start + ahead * length * k / straight, y])
        for k in range(1, around if fold < folds else 1):
            angle = -math.pi / 2 + math.pi * k / around
            path.append([start + ahead * (length + pitch / 2 * math.cos(angle)), y + pitch / 2 * (1 + math.sin(angle))])
    return along(numpy.array(path), thickness, layers, depth)


def _to_left(path):
    """Unit normals to the left of a polyline at its points."""
    ahead = numpy.empty_like(path)
    ahead[1:-1] = path[2:] - path[:-2]
    ahead[0], ahead[-1] = path[1] - path[0], path[-1] - path[-2]
    ahead /= numpy.linalg.norm(ahead, axis=1)[:, None]
    return numpy.stack([-ahead[:, 1], ahead[:, 0]], axis=1)


def deck(bodies):
    """Text of an Abaqus deck. bodies: name of the part, points, hexahedra; a part may have several."""
    nodes, elements, first, count = ["*NODE\n"], [], 1, 1
    for part, points, hexes in bodies:
        nodes += [f"{first + k}, " + ", ".join(f"{x:.12g}" for x in point) + "\n" for k, point in enumerate(points)]
        elements.append(f"*ELEMENT, TYPE=C3D8, ELSET={part}\n")
        for corners in hexes:
            elements.append(f"{count}, " + ", ".join(str(first + c) for c in corners) + "\n")
            count += 1
        first += len(points)
    return "".join(nodes + elements)
