# SPDX-License-Identifier: Apache-2.0
"""How deep bodies of hexahedra stand in each other, from the positions of a record alone: the program is not asked.

    record = Bodies(result).deepest(time)      # the deepest point [length], and the two bodies
"""
import os

import h5py
import numpy

HEX_FACES = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [0, 4, 7, 3], [0, 3, 2, 1], [4, 5, 6, 7]]
SAMPLES = numpy.linspace(0, 1, 5)  # of a face, along and across: corners and edges are looked at, not only nodes


def outer_quads(connectivity):
    """Faces of one element only, corners counter-clockwise seen from outside."""
    quads = connectivity[:, HEX_FACES].reshape(-1, 4)
    _, index, count = numpy.unique(numpy.sort(quads, axis=1), axis=0, return_index=True, return_counts=True)
    return quads[numpy.sort(index[count == 1])]


def sample(corners):
    """Points of bilinear quadrilaterals [quads][4][3]."""
    a, b = (part.ravel()[:, None] for part in numpy.meshgrid(SAMPLES, SAMPLES))
    shapes = numpy.hstack([(1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b])
    return numpy.einsum("pc,qcx->qpx", shapes, corners).reshape(-1, 3)


def triangles(corners):
    """Four a quadrilateral, around its middle."""
    middle = corners.mean(axis=1)
    return numpy.concatenate([numpy.stack([corners[:, k], corners[:, (k + 1) % 4], middle], axis=1) for k in range(4)])


def closest_on(triangle, points):
    """Closest points of triangles [t][3][3] to points [p][3]: [p][t][3]."""
    a, b, c = (triangle[None, :, k] for k in range(3))
    p = points[:, None]
    normal = numpy.cross(b - a, c - a)
    inside = numpy.ones(numpy.broadcast_shapes(p.shape, a.shape)[:2], dtype=bool)
    best = p - ((p - a) * normal).sum(-1, keepdims=True) / (normal * normal).sum(-1, keepdims=True) * normal
    for u, v in ((a, b), (b, c), (c, a)):
        inside &= (numpy.cross(v - u, p - u) * normal).sum(-1) >= 0
    distance = numpy.where(inside, numpy.linalg.norm(best - p, axis=-1), numpy.inf)
    for u, v in ((a, b), (b, c), (c, a)):
        along = ((p - u) * (v - u)).sum(-1) / ((v - u)**2).sum(-1)
        at = u + numpy.clip(along, 0, 1)[..., None] * (v - u)
        near = numpy.linalg.norm(at - p, axis=-1)
        best = numpy.where((near < distance)[..., None], at, best)
        distance = numpy.minimum(distance, near)
    return best, distance


def winding(faces, points):
    """How often a closed surface goes round points: 1 inside, 0 outside (solid angles, van Oosterom and Strackee 1983)."""
    a, b, c = (faces[None, :, k] - points[:, None] for k in range(3))
    la, lb, lc = (numpy.linalg.norm(side, axis=-1) for side in (a, b, c))
    triple = (a * numpy.cross(b, c)).sum(-1)
    below = la * lb * lc + (a * b).sum(-1) * lc + (b * c).sum(-1) * la + (c * a).sum(-1) * lb
    return numpy.arctan2(triple, below).sum(axis=1) / (2 * numpy.pi)


def depths(points, corners):
    """How far points are inside a body (> 0), from its nearest outer face."""
    faces = triangles(corners)
    return numpy.where(winding(faces, points) > 0.5, closest_on(faces, points)[1].min(axis=1), 0.0)


class Bodies:
    """Each block of the mesh is a body."""

    def __init__(self, result):
        self.path = os.path.join(result.folder, "state.h5")
        with h5py.File(self.path, "r") as file:
            self.reference = file["mesh/coordinates"][...]
            connectivity, block = file["mesh/connectivity"][...], file["mesh/element_block"][...]
        self.quads = [outer_quads(connectivity[block == b]) for b in numpy.unique(block)]

    def positions(self, time):
        """At the record nearest to a time, and its time."""
        with h5py.File(self.path, "r") as file:
            record = min((file[name] for name in file if name.startswith("record_")), key=lambda r: abs(r.attrs["time"] - time))
            return self.reference + record["node/displacement"][...], float(record.attrs["time"])

    def deepest(self, time):
        """(depth, one body, the body that it stands in); depth 0 where all are apart."""
        x, _ = self.positions(time)
        corners = [x[quads] for quads in self.quads]
        low, high = (numpy.array([pick(c.reshape(-1, 3), axis=0) for c in corners]) for pick in (numpy.min, numpy.max))
        worst = (0.0, None, None)
        for a, own in enumerate(corners):
            points = numpy.unique(sample(own), axis=0)
            for b in range(len(corners)):
                near = points[((points >= low[b]) & (points <= high[b])).all(axis=1)] if b != a else points[:0]
                if len(near):
                    worst = max(worst, (float(depths(near, corners[b]).max()), a, b), key=lambda entry: entry[0])
        return worst
