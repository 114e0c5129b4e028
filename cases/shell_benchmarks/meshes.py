# SPDX-License-Identifier: Apache-2.0
"""Meshes of shells on a grid of quadrilaterals or triangles, written as Abaqus input (S4R, S3R)."""
import numpy

TYPES = {3: "S3R", 4: "S4R"}


class Mesh:
    """points: [nodes, 3]; elements: [elements, 3 or 4], indices of points, normal by the right hand; sets: arrays of points by name;
    fields: black (0) or white (1) field of a chessboard, by element."""

    def __init__(self, points, elements, sets, fields=None):
        self.points, self.elements = numpy.asarray(points, float), numpy.asarray(elements, int)
        self.points[abs(self.points) < 1e-13 * abs(self.points).max()] = 0  # cos(pi/2): nodes of a symmetry plane lie in it
        self.sets = {name: numpy.asarray(nodes, int) for name, nodes in sets.items()}
        self.fields = fields

    def triangles(self):
        """Each quadrilateral in two triangles; the diagonals alternate from field to field."""
        a, b, c, d = self.elements.T
        even = (self.fields == 0)[:, None]
        first = numpy.where(even, numpy.stack([a, b, c], 1), numpy.stack([a, b, d], 1))
        second = numpy.where(even, numpy.stack([a, c, d], 1), numpy.stack([b, c, d], 1))
        return Mesh(self.points, numpy.stack([first, second], 1).reshape(-1, 3), self.sets)

    def moved(self, place):
        """The same mesh with its points at place(x, y, z), which takes and gives arrays."""
        return Mesh(numpy.stack(place(*self.points.T), 1), self.elements, self.sets, self.fields)

    def near(self, point):
        """Index of the nearest point."""
        return int(numpy.argmin(((self.points - numpy.asarray(point, float))**2).sum(1)))

    def write(self, path, part):
        """All elements in the set `part`, numbers from 1."""
        lines = ["*NODE"]
        lines += [f"{i + 1}, {x!r}, {y!r}, {z!r}" for i, (x, y, z) in enumerate(self.points.tolist())]
        lines.append(f"*ELEMENT, TYPE={TYPES[self.elements.shape[1]]}, ELSET={part}")
        lines += [", ".join(map(str, [e + 1, *(corners + 1)])) for e, corners in enumerate(self.elements)]
        for name, nodes in self.sets.items():
            lines.append(f"*NSET, NSET={name}")
            lines += [", ".join(map(str, nodes[i:i + 8] + 1)) for i in range(0, len(nodes), 8)]
        lines.append(f"*SHELL SECTION, ELSET={part}, MATERIAL=M\n1.0")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write("\n".join(lines) + "\n")


def grid(across, along):
    """The unit square in across x along elements, normal z; sets xmin, xmax, ymin, ymax."""
    x, y = numpy.meshgrid(numpy.linspace(0, 1, across + 1), numpy.linspace(0, 1, along + 1))
    points = numpy.stack([x.ravel(), y.ravel(), 0 * x.ravel()], 1)
    index = numpy.arange(len(points)).reshape(along + 1, across + 1)
    elements = numpy.stack([index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]], -1).reshape(-1, 4)
    i, j = numpy.meshgrid(numpy.arange(across), numpy.arange(along))
    return Mesh(points, elements, {"xmin": index[:, 0], "xmax": index[:, -1], "ymin": index[0], "ymax": index[-1]}, (i + j).ravel() % 2)


def plate(size, elements, skewed=0.0):
    """In the plane z = 0, one corner at the origin. skewed: inner nodes are moved by up to this share of an element, always the same way."""
    mesh = grid(*elements)
    inner = numpy.setdiff1d(numpy.arange(len(mesh.points)), numpy.concatenate(list(mesh.sets.values())))
    moves = numpy.random.default_rng(1).uniform(-1, 1, (len(mesh.points), 2)) * skewed / numpy.asarray(elements)
    mesh.points[inner, :2] += moves[inner]
    return mesh.moved(lambda x, y, z: (size[0] * x, size[1] * y, z))


def twisted(length, width, turn, elements):
    """A strip along x whose cross-section lies along y at x = 0 and turns about x by `turn` [rad] to the end."""
    def place(x, y, z):
        angle, across = turn * x, width * (y - 0.5)
        return length * x, across * numpy.cos(angle), across * numpy.sin(angle) + z
    return grid(*elements).moved(place)


def cylinder(radius, length, angle, elements):
    """Axis y from 0 to length, from the top (z = radius) by `angle` [rad] towards +x, normal outwards. xmin is the top line, ymin the end."""
    return grid(*elements).moved(lambda x, y, z: (radius * numpy.sin(angle * x), length * y, radius * numpy.cos(angle * x) + z))


def sphere(radius, top, elements):
    """A quarter of a hemisphere (x, y, z >= 0), axis z, from the equator (ymin) to the elevation `top` [rad]; normal outwards. xmin lies in
    y = 0, xmax in x = 0."""
    def place(x, y, z):
        azimuth, elevation = 0.5 * numpy.pi * x, top * y
        flat = radius * numpy.cos(elevation)
        return flat * numpy.cos(azimuth), flat * numpy.sin(azimuth), radius * numpy.sin(elevation) + z
    return grid(*elements).moved(place)


def disk(radius, elements):
    """A quarter of a disk (x, y >= 0) in three blocks of elements/2 a side; sets xzero, yzero (its straight sides) and rim."""
    half = elements // 2
    core, diagonal = 0.55 * radius, 0.42 * radius  # of the inner block: its corners on the axes, and both coordinates of that between

    def bilinear(a, b, c, d):
        return lambda x, y, z: tuple((1 - x) * (1 - y) * p + x * (1 - y) * q + x * y * r + (1 - x) * y * s + z
                                     for p, q, r, s in zip(a, b, c, d, strict=True)) + (z,)

    def ring(first, last, start):
        """From the straight line first-last (x = 0) to the arc of 45 degrees that begins at `start` [rad] (x = 1)."""
        def place(x, y, z):
            angle = start + 0.25 * numpy.pi * y
            line = [(1 - y) * p + y * q for p, q in zip(first, last, strict=True)]
            return (1 - x) * line[0] + x * radius * numpy.cos(angle), (1 - x) * line[1] + x * radius * numpy.sin(angle), z
        return place

    places = [bilinear((0, 0), (core, 0), (diagonal, diagonal), (0, core)), ring((core, 0), (diagonal, diagonal), 0.0),
              ring((diagonal, diagonal), (0, core), 0.25 * numpy.pi)]
    blocks = [grid(half, half).moved(place) for place in places]
    points = numpy.concatenate([block.points for block in blocks])
    _, first, of = numpy.unique(numpy.round(points / radius, 9), axis=0, return_index=True, return_inverse=True)
    elements = numpy.concatenate([block.elements + i * len(blocks[0].points) for i, block in enumerate(blocks)])
    merged = Mesh(points[first], of.ravel()[elements], {}, numpy.concatenate([block.fields for block in blocks]))
    x, y, _ = merged.points.T
    near = 1e-9 * radius
    merged.sets = {"xzero": numpy.flatnonzero(x < near), "yzero": numpy.flatnonzero(y < near),
                   "rim": numpy.flatnonzero(numpy.hypot(x, y) > radius - near)}
    return merged
