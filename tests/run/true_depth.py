# SPDX-License-Identifier: Apache-2.0
"""How deep the nodes and edges of hexahedral bodies lie in other bodies, from the positions in state.h5 alone.

A point is inside where the inverse of the trilinear map of an element has it. Its depth is the distance to the nearest
exterior face of that body, in units of the element behind that face (its depth, or the width of the face if less).
Folded elements, whose map has no inverse, have no inside: what they hold is not judged."""
import collections

import h5py
import numpy

SIGNS = numpy.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], float)
FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]

CORNERS = [(0, 1, 3, 4), (1, 2, 0, 5), (2, 3, 1, 6), (3, 0, 2, 7), (4, 7, 5, 0), (5, 4, 6, 1), (6, 5, 7, 2), (7, 6, 4, 3)]

Depth = collections.namedtuple("Depth", "share depth node part other record time")


def trilinear(xi):
    return (1 + SIGNS * xi[:, None, :]).prod(axis=2) / 8


def is_folded(corners):
    """corners (n, 8, 3): whether a corner of the element is inverted."""
    return numpy.min([numpy.linalg.det(numpy.stack([corners[:, i] - corners[:, a] for i in others], axis=1))
                      for a, *others in CORNERS], axis=0) <= 0


def inside(corners, points):
    """corners (n, 8, 3), points (n, 3): of each pair, whether the element has the point. Newton's iteration may end
    nowhere, within the cube, for points outside of warped elements: what counts is where it has come to."""
    xi = numpy.zeros_like(points)
    alive = numpy.ones(len(points), bool)
    size = numpy.ptp(corners, axis=1).max(axis=1)
    with numpy.errstate(all="ignore"):
        for _ in range(25):
            factors = 1 + SIGNS * xi[:, None, :]
            shape = factors.prod(axis=2) / 8
            residual = (shape[:, :, None] * corners).sum(axis=1) - points
            slope = numpy.empty((len(points), 3, 3))
            for c in range(3):
                others = [k for k in range(3) if k != c]
                derivative = SIGNS[:, c] * factors[:, :, others].prod(axis=2) / 8
                slope[:, :, c] = (derivative[:, :, None] * corners).sum(axis=1)
            alive &= (numpy.abs(numpy.linalg.det(slope)) > 0) & (numpy.abs(xi).max(axis=1) < 10)
            slope[~alive] = numpy.eye(3)
            residual[~alive] = 0
            xi = xi - numpy.linalg.solve(slope, residual[:, :, None])[:, :, 0]
    left = numpy.linalg.norm((trilinear(xi)[:, :, None] * corners).sum(axis=1) - points, axis=1)
    return alive & (numpy.abs(xi).max(axis=1) <= 1 + 1e-9) & (left <= 1e-9 * size)


def distances_to_triangles(points, a, b, c):
    """Ericson: from each point to the nearest point of each triangle; distances (points, triangles)."""
    points = points[:, None]
    best = numpy.full((len(points), len(a)), numpy.inf)
    normal = numpy.cross(b - a, c - a)
    length = numpy.linalg.norm(normal, axis=1)
    flat = length > 0
    unit = normal / numpy.where(flat, length, 1)[:, None]
    height = ((points - a) * unit).sum(axis=2)
    foot = points - height[:, :, None] * unit
    within = numpy.broadcast_to(flat, best.shape).copy()
    for p, q in ((a, b), (b, c), (c, a)):
        within &= (numpy.cross(q - p, foot - p) * unit).sum(axis=2) >= 0
        edge = q - p
        t = ((points - p) * edge).sum(axis=2) / numpy.maximum((edge * edge).sum(axis=1), 1e-300)
        near = p + numpy.clip(t, 0, 1)[:, :, None] * edge
        best = numpy.minimum(best, numpy.linalg.norm(points - near, axis=2))
    return numpy.where(within, numpy.minimum(best, numpy.abs(height)), best)


class Body:
    """A connected piece of a part: its elements, exterior faces, surface nodes and edges."""

    def __init__(self, name, connectivity, coordinates):
        self.name, self.elements = name, connectivity
        seen = {}
        for e, nodes in enumerate(connectivity):
            for face in FACES:
                corners = tuple(int(nodes[k]) for k in face)
                seen.setdefault(tuple(sorted(corners)), []).append((corners, e))
        outer = [sides[0] for sides in seen.values() if len(sides) == 1]
        self.faces = numpy.array([corners for corners, _ in outer])
        self.nodes = numpy.unique(self.faces)
        self.edges = sorted({tuple(sorted((q[i], q[(i + 1) % 4]))) for q in self.faces.tolist() for i in range(4)})
        x = coordinates
        self.size = []  # of the element behind each face, or of the face if that is less [length]
        for corners, e in outer:
            volume = abs(numpy.linalg.det(numpy.array([x[connectivity[e][k]] - x[connectivity[e][0]] for k in (1, 3, 4)])))
            sides = [numpy.linalg.norm(x[corners[1]] - x[corners[0]]), numpy.linalg.norm(x[corners[2]] - x[corners[1]])]
            self.size.append(min(sides + [volume / (sides[0] * sides[1])]))
        self.size = numpy.array(self.size)

    def depths(self, x, points):
        """[(index of the point, depth, share of an element)] of those inside."""
        low, high = x[self.nodes].min(axis=0), x[self.nodes].max(axis=0)
        near = numpy.nonzero(((points >= low) & (points <= high)).all(axis=1))[0]
        if not len(near):
            return []
        sound = ~is_folded(x[self.elements])
        boxes_low, boxes_high = x[self.elements].min(axis=1), x[self.elements].max(axis=1)
        within = ((points[near, None] >= boxes_low) & (points[near, None] <= boxes_high)).all(axis=2) & sound
        pair_point, pair_element = numpy.nonzero(within)
        if not len(pair_point):
            return []
        holds = inside(x[self.elements[pair_element]], points[near[pair_point]])
        found = []
        a, b, c, d = (x[self.faces[:, k]] for k in range(4))
        middle = (a + b + c + d) / 4
        which = near[numpy.unique(pair_point[holds])]
        for some in numpy.array_split(which, 1 + len(which) // 100):  # of a size that fits the cache
            if len(some):
                distance = numpy.minimum.reduce([distances_to_triangles(points[some], p, q, middle) for p, q in ((a, b), (b, c), (c, d), (d, a))])
                face = distance.argmin(axis=1)
                depth = distance[numpy.arange(len(some)), face]
                found += zip(some.tolist(), depth.tolist(), (depth / self.size[face]).tolist())
        return found


def connected(connectivity):
    """The elements in pieces that share no node."""
    label = numpy.arange(connectivity.max() + 1)
    while True:
        least = label[connectivity].min(axis=1)
        before = label.copy()
        numpy.minimum.at(label, connectivity, least[:, None])
        if (label == before).all():
            break
    return [connectivity[least == piece] for piece in numpy.unique(least)]


def bodies_of(file):
    connectivity, coordinates = file["mesh/connectivity"][...], file["mesh/coordinates"][...]
    bodies = []
    for name in sorted(key for key in file["mesh"] if key.startswith("block_")):
        block = file["mesh"][name].attrs
        first, count = int(block["first"]), int(block["count"])
        part = block["part"] if "part" in block else block["name"]
        name = part.decode() if isinstance(part, bytes) else str(part)
        bodies += [Body(name, piece, coordinates) for piece in connected(connectivity[first:first + count])]
    return coordinates, bodies


def records_of(file):
    return sorted(key for key in file if key.startswith("record"))


def deepest(path, of_edges=False, pieces=8):
    """The deepest node (or point of an edge, numbered by its first node) of one body in another over all records."""
    worst = Depth(0.0, 0.0, -1, "", "", -1, 0.0)
    with h5py.File(path, "r") as file:
        coordinates, bodies = bodies_of(file)
        for number, record in enumerate(records_of(file)):
            x = coordinates + file[record]["node/displacement"][...]
            for one in bodies:
                if of_edges:
                    ends = numpy.array(one.edges)
                    t = numpy.linspace(0, 1, pieces + 1)[1:-1]
                    points = ((1 - t)[None, :, None] * x[ends[:, 0], None] + t[None, :, None] * x[ends[:, 1], None]).reshape(-1, 3)
                    names = numpy.repeat(ends[:, 0], len(t))
                else:
                    points, names = x[one.nodes], one.nodes
                for other in bodies:
                    if other is one:
                        continue
                    for k, depth, share in other.depths(x, points):
                        if share > worst.share:
                            worst = Depth(share, depth, int(names[k]), one.name, other.name, number,
                                          float(file[record].attrs["time"]) if "time" in file[record].attrs else 0.0)
    return worst


def folded(path):
    """The largest number of elements, over all records, whose map has a determinant <= 0 in a corner."""
    most = 0
    with h5py.File(path, "r") as file:
        coordinates, bodies = bodies_of(file)
        for record in records_of(file):
            x = coordinates + file[record]["node/displacement"][...]
            count = sum(int(is_folded(x[body.elements]).sum()) for body in bodies)
            most = max(most, count)
    return most
