#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes askew.inp and tetrahedra.inp: two blocks on each other whose meshes do not match (Abaqus format).

usage: mesh.py [FOLDER]

Each block is 1 x 1 x 0.5 in layers of equal height. Nodes within a block move at random by up to a share of an element
in all directions; those within the contact face move in the face, so that quadrilaterals cross askew; those on sides stay.
"""
import os
import sys

import numpy

LAYERS = 2
HEIGHT = 0.5
# corners of the six tetrahedra of a hexahedron around the diagonal from corner 0 to corner 6: neighbours fit
TETRAHEDRA = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]


class Block:
    """Points [n][3] and hexahedra [m][8] of the block from z = foot up; x fastest, then y, then z."""

    def __init__(self, name, columns, foot):
        self.name, self.columns, self.foot = name, columns, foot
        side, levels = numpy.linspace(0, 1, columns + 1), foot + numpy.linspace(0, HEIGHT, LAYERS + 1)
        self.points = numpy.array([(x, y, z) for z in levels for y in side for x in side])
        row = columns + 1

        def at(i, j, k):
            return (k * row + j) * row + i
        self.elements = numpy.array([[at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k), at(i, j, k + 1),
                                      at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)]
                                     for k in range(LAYERS) for j in range(columns) for i in range(columns)])

    def displace(self, share, contact, random):
        """Moves nodes off the sides and off the outer face; those at the height `contact` stay in it."""
        inside = (abs(self.points[:, :2] - 0.5) < 0.5 - 1e-9).all(axis=1)
        inner = inside & (abs(self.points[:, 2] - self.foot - HEIGHT / 2) < HEIGHT / 2 - 1e-9)
        face = inside & (abs(self.points[:, 2] - contact) < 1e-9)
        moves = share / self.columns * random.uniform(-1, 1, self.points.shape)
        self.points[inner] += moves[inner]
        self.points[face, :2] += moves[face, :2]

    def cut(self):
        """Six tetrahedra for each hexahedron."""
        self.elements = numpy.array([[hexahedron[c] for c in corners] for hexahedron in self.elements for corners in TETRAHEDRA])


def write(path, blocks):
    """Also the surface `load`: the faces of the last block on top."""
    kind = {8: "C3D8", 4: "C3D4"}
    sides = {8: [(0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)],
             4: [(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)]}  # S1, S2, ... of Abaqus
    first, number, surface = 1, 1, []
    with open(path, "w", encoding="utf-8") as out:
        out.write("*NODE\n")
        for block in blocks:
            out.writelines(f"{first + i}, {x:.17g}, {y:.17g}, {z:.17g}\n" for i, (x, y, z) in enumerate(block.points))
            block.first, first = first, first + len(block.points)
        for block in blocks:
            corners = block.elements.shape[1]
            out.write(f"*ELEMENT, TYPE={kind[corners]}, ELSET={block.name}\n")
            for element in block.elements:
                out.write(f"{number}, " + ", ".join(str(block.first + n) for n in element) + "\n")
                if block is blocks[-1]:
                    surface += [(number, s + 1) for s, side in enumerate(sides[corners])
                                if (abs(block.points[element[list(side)], 2] - 2 * HEIGHT) < 1e-9).all()]
                number += 1
        out.write("*SURFACE, TYPE=ELEMENT, NAME=load\n" + "".join(f"{n}, S{s}\n" for n, s in surface))


def askew(path, columns, share=0.2, seed=1):
    """Hexahedra on hexahedra, as many columns a side below and above; the share of an element by which nodes move."""
    random = numpy.random.default_rng(seed)
    blocks = [Block(name, n, foot) for name, n, foot in zip(("low", "top"), columns, (0, HEIGHT))]
    for block in blocks:
        block.displace(share, HEIGHT, random)
    write(path, blocks)


def tetrahedra(path, columns, share=0.0, seed=1):
    """Hexahedra below, tetrahedra above."""
    random = numpy.random.default_rng(seed)
    blocks = [Block(name, n, foot) for name, n, foot in zip(("low", "top"), columns, (0, HEIGHT))]
    for block in blocks:
        block.displace(share, HEIGHT, random)
    blocks[1].cut()
    write(path, blocks)


if __name__ == "__main__":
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    askew(os.path.join(folder, "askew.inp"), (3, 4))
    tetrahedra(os.path.join(folder, "tetrahedra.inp"), (2, 3))
