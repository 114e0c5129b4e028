# SPDX-License-Identifier: Apache-2.0
"""Small mesh and surface files as text, in the forms that other programs give them."""
import struct

SCENE = """\
units: none
mesh: {file: FILE}
materials: {m: {model: elastic, density: 8, young: 1, poisson: 0}}
parts: {bar: {block: BLOCK, material: m}}
run: {steps: 2}
"""
MARK = b"\xef\xbb\xbf"
FORMS = {"feeds": lambda text: text, "returns and feeds": lambda text: text.replace(b"\n", b"\r\n"), "returns": lambda text: text.replace(b"\n", b"\r"),
         "mark": lambda text: MARK + text, "mark and returns": lambda text: MARK + text.replace(b"\n", b"\r"),
         "no last end": lambda text: text.rstrip(b"\n")}
BLANKS = {"blank lines": lambda text: b"\n  \n\n" + text, "mark and blank lines": lambda text: MARK + b"\n\n" + text,
          "many blank lines": lambda text: b"\n" * 500 + text, "blank returns": lambda text: (b"\n\n" + text).replace(b"\n", b"\r")}


def bar(n=3):
    """Nodes of n cubes in a row, and their corners, from 1."""
    nodes = [(float(i), float(j), float(k)) for k in range(2) for j in range(2) for i in range(n + 1)]
    at = lambda i, j, k: 1 + i + (n + 1) * (j + 2 * k)
    cubes = [[at(i, 0, 0), at(i + 1, 0, 0), at(i + 1, 1, 0), at(i, 1, 0), at(i, 0, 1), at(i + 1, 0, 1), at(i + 1, 1, 1), at(i, 1, 1)] for i in range(n)]
    return nodes, cubes


def msh2(nodes, cubes, section="Nodes", more=""):
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "1", '3 1 "bar"', "$EndPhysicalNames", f"${section}", str(len(nodes))]
    lines += [f"{i} {x} {y} {z}{more}" for i, (x, y, z) in enumerate(nodes, 1)] + [f"$End{section}", "$Elements", str(len(cubes))]
    lines += [f"{i} 5 2 1 1 " + " ".join(map(str, c)) for i, c in enumerate(cubes, 1)] + ["$EndElements", ""]
    return "\n".join(lines).encode()


def msh4(nodes, cubes):
    n = len(nodes)
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames", "1", '3 1 "bar"', "$EndPhysicalNames", "$Entities", "0 0 0 1",
             "1 0 0 0 3 1 1 1 1 0", "$EndEntities", "$Nodes", f"1 {n} 1 {n}", f"3 1 0 {n}"]
    lines += [str(i) for i in range(1, n + 1)] + [f"{x} {y} {z}" for x, y, z in nodes] + ["$EndNodes"]
    lines += ["$Elements", f"1 {len(cubes)} 1 {len(cubes)}", f"3 1 5 {len(cubes)}"]
    lines += [f"{i} " + " ".join(map(str, c)) for i, c in enumerate(cubes, 1)] + ["$EndElements", ""]
    return "\n".join(lines).encode()


TRIANGLES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
POINTS = [(0, 0, 0), (2, 0, 0), (0, 3, 0), (0, 0, 1)]


def stl(points=POINTS, triangles=TRIANGLES):
    lines = ["solid s"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop"] + ["vertex {} {} {}".format(*points[p]) for p in triangle] + ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid s", ""]).encode()


def obj(points=POINTS, triangles=TRIANGLES):
    lines = ["v {} {} {}".format(*p) for p in points] + ["f {} {} {}".format(*(k + 1 for k in t)) for t in triangles]
    return "\n".join(lines + [""]).encode()


def ply_header(kind):
    return "\n".join(["ply", f"format {kind} 1.0", "comment end_header", "element vertex 4", "property double x", "property double y", "property double z",
                      "element face 4", "property list uchar int vertex_indices", "end_header", ""]).encode()


def ply(points=POINTS, triangles=TRIANGLES):
    return ply_header("ascii") + "\n".join(["{} {} {}".format(*p) for p in points] + ["3 {} {} {}".format(*t) for t in triangles] + [""]).encode()


def binary_ply(end=b"\n"):
    body = b"".join(struct.pack("<3d", *p) for p in POINTS) + b"".join(struct.pack("<B3i", 3, *t) for t in TRIANGLES)
    return ply_header("binary_little_endian").replace(b"\n", end) + body
