#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes lever.inp (Abaqus) and lever.msh (Gmsh 2.2): a lever of 120 x 10 x 20 mm, in millimetres, as a mesher would.

usage: lever.py [FOLDER]

Both hold the solid BEAM, the end ROOT (x = 0) and the end LOAD (x = 120). lever.inp also has the shells SKIN on top, which
are no part of the solid.
"""
import os
import sys

SIZE, COUNT = (120, 10, 20), (24, 3, 6)


def number(i, j, k):
    """Nodes from 1, x fastest."""
    return 1 + i + (COUNT[0] + 1) * (j + (COUNT[1] + 1) * k)


def nodes():
    for k in range(COUNT[2] + 1):
        for j in range(COUNT[1] + 1):
            for i in range(COUNT[0] + 1):
                yield tuple(f"{SIZE[d] * n / COUNT[d]:.10g}" for d, n in enumerate((i, j, k)))


def hexahedra():
    for k in range(COUNT[2]):
        for j in range(COUNT[1]):
            for i in range(COUNT[0]):
                yield [number(i + a, j + b, k + c) for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]


def end_faces(i):
    return [[number(i, j + a, k + b) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))] for k in range(COUNT[2]) for j in range(COUNT[1])]


def skin():
    top = COUNT[2]
    return [[number(i + a, j + b, top) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))] for j in range(COUNT[1]) for i in range(COUNT[0])]


def write_abaqus(path):
    elements = list(hexahedra())
    with open(path, "w", encoding="utf-8") as out:
        out.write("** lever of 120 x 10 x 20 mm\n*NODE\n")
        out.writelines(f"{n}, {', '.join(place)}\n" for n, place in enumerate(nodes(), 1))
        out.write("*ELEMENT, TYPE=C3D8R, ELSET=BEAM\n")
        out.writelines(f"{n}, {', '.join(map(str, element))}\n" for n, element in enumerate(elements, 1))
        out.write("*ELEMENT, TYPE=S4R, ELSET=SKIN\n")
        out.writelines(f"{n}, {', '.join(map(str, face))}\n" for n, face in enumerate(skin(), len(elements) + 1))
        out.write("*SOLID SECTION, ELSET=BEAM, MATERIAL=STEEL\n*SHELL SECTION, ELSET=SKIN, MATERIAL=PAINT\n0.1\n")
        out.write("*NSET, NSET=ROOT\n")
        out.writelines(f"{number(0, j, k)},\n" for k in range(COUNT[2] + 1) for j in range(COUNT[1] + 1))
        out.write("*SURFACE, NAME=LOAD, TYPE=ELEMENT\n")  # the face x = 120 of a hexahedron is its side S4
        out.writelines(f"{n}, S4\n" for n in range(COUNT[0], len(elements) + 1, COUNT[0]))


def write_gmsh(path):
    places, elements = list(nodes()), list(hexahedra())
    faces = [(2, face) for face in end_faces(0)] + [(3, face) for face in end_faces(COUNT[0])]
    with open(path, "w", encoding="utf-8") as out:
        out.write('$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n3 1 "BEAM"\n2 2 "ROOT"\n2 3 "LOAD"\n$EndPhysicalNames\n')
        out.write(f"$Nodes\n{len(places)}\n")
        out.writelines(f"{n} {' '.join(place)}\n" for n, place in enumerate(places, 1))
        out.write(f"$EndNodes\n$Elements\n{len(elements) + len(faces)}\n")
        out.writelines(f"{n} 5 2 1 1 {' '.join(map(str, element))}\n" for n, element in enumerate(elements, 1))
        out.writelines(f"{n} 3 2 {tag} {tag} {' '.join(map(str, face))}\n" for n, (tag, face) in enumerate(faces, len(elements) + 1))
        out.write("$EndElements\n")


if __name__ == "__main__":
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    write_abaqus(os.path.join(folder, "lever.inp"))
    write_gmsh(os.path.join(folder, "lever.msh"))
