# SPDX-License-Identifier: Apache-2.0
"""Whether two closed triangle surfaces overlap, how deep, and lengths of motions: by numpy alone, none of the program.

Two tests together: edges of one surface that cross triangles of the other, and points of one inside the other (parity of
a ray). Either alone misses overlaps.
"""
import numpy as np

from fit_shapes import mass_of, prism, rectangle

CHUNK = 2_000_000  # point-triangle pairs at a time


def placed(surface, placement):
    """placement: 3 x 4 matrix of rotation and translation."""
    return surface[0] @ placement[:, :3].T + placement[:, 3], surface[1]


def edges_of(triangles):
    return np.unique(np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1), axis=0)


def deepest_crossing(one, other, tolerance):
    """Largest distance by which an edge of one passes through a triangle of the other, the least of: the depths of both
    ends beyond its plane, the distance of the crossing from its rim. 0: none deeper than the tolerance."""
    edges = one[0][edges_of(one[1])]
    corners = other[0][other[1]]
    e_low, e_high, t_low, t_high = edges.min(axis=1), edges.max(axis=1), corners.min(axis=1), corners.max(axis=1)
    low, high = np.maximum(e_low.min(axis=0), t_low.min(axis=0)), np.minimum(e_high.max(axis=0), t_high.max(axis=0))
    keep, kept = ((e_low <= high) & (e_high >= low)).all(axis=1), ((t_low <= high) & (t_high >= low)).all(axis=1)
    edges, e_low, e_high, corners, t_low, t_high = edges[keep], e_low[keep], e_high[keep], corners[kept], t_low[kept], t_high[kept]
    near = np.ones((len(edges), len(corners)), dtype=bool)
    for c in range(3):
        near &= (e_low[:, None, c] <= t_high[None, :, c]) & (t_low[None, :, c] <= e_high[:, None, c])
    e, t = np.nonzero(near)
    if len(e) == 0:
        return 0.0
    p, q = edges[e, 0], edges[e, 1]
    a, b, c = (corners[t, k] for k in range(3))
    normal = np.cross(b - a, c - a)
    size = np.linalg.norm(normal, axis=1)
    keep = size > 0
    p, q, a, b, c, normal, size = (x[keep] for x in (p, q, a, b, c, normal, size))
    normal = normal / size[:, None]
    before, after = np.einsum("ij,ij->i", p - a, normal), np.einsum("ij,ij->i", q - a, normal)
    keep = np.minimum(np.abs(before), np.abs(after)) > tolerance
    keep &= before * after < 0
    p, q, a, b, c, normal, before, after = (x[keep] for x in (p, q, a, b, c, normal, before, after))
    if len(p) == 0:
        return 0.0
    x = p + (before / (before - after))[:, None] * (q - p)
    rim = np.full(len(x), np.inf)
    for u, v in ((a, b), (b, c), (c, a)):
        inward = np.cross(normal, v - u)
        rim = np.minimum(rim, np.einsum("ij,ij->i", x - u, inward) / np.linalg.norm(inward, axis=1))
    return max(0.0, float(np.minimum(rim, np.minimum(np.abs(before), np.abs(after))).max()))


def are_inside(points, surface):
    """Of each point: whether a ray along a direction without meaning passes through the surface an odd number of times."""
    axes = np.linalg.qr(np.array([[0.31, 0.83, -0.47], [-0.72, 0.13, 0.55], [0.59, -0.41, 0.67]]))[0]
    points, corners = points @ axes, (surface[0] @ axes)[surface[1]]
    low, high = corners.min(axis=1), corners.max(axis=1)
    hits = np.zeros(len(points), dtype=int)
    step = max(1, CHUNK // max(1, len(corners)))
    for k in range(0, len(points), step):
        part = points[k:k + step]
        near = part[:, None, 2] <= high[None, :, 2]
        for c in range(2):
            near &= (part[:, None, c] >= low[None, :, c]) & (part[:, None, c] <= high[None, :, c])
        p, t = np.nonzero(near)
        x, three = part[p], corners[t]
        area = [(v[:, 0] - x[:, 0]) * (w[:, 1] - x[:, 1]) - (v[:, 1] - x[:, 1]) * (w[:, 0] - x[:, 0])
                for v, w in ((three[:, 1], three[:, 2]), (three[:, 2], three[:, 0]), (three[:, 0], three[:, 1]))]
        through = ((area[0] > 0) == (area[1] > 0)) & ((area[1] > 0) == (area[2] > 0))
        whole = np.where(through, area[0] + area[1] + area[2], 1)
        level = sum(a * three[:, i, 2] for i, a in enumerate(area)) / np.where(whole == 0, 1, whole)
        np.add.at(hits, k + p[through & (level > x[:, 2])], 1)
    return hits % 2 == 1


def distances(points, surface):
    """From each point to the surface."""
    a, b, c = (surface[0][surface[1]][:, i] for i in range(3))
    normal = np.cross(b - a, c - a)
    size = np.linalg.norm(normal, axis=1)
    a, b, c, normal = (x[size > 0] for x in (a, b, c, normal / np.maximum(1e-300, size)[:, None]))
    sides = [(u, v - u, np.einsum("ij,ij->i", v - u, v - u), np.cross(normal, v - u)) for u, v in ((a, b), (b, c), (c, a))]
    result = np.empty(len(points))
    step = max(1, CHUNK // max(1, len(surface[1])))

    def along(x, u, direction):  # (x - u) . direction, of each point with each triangle
        return x @ direction.T - np.einsum("ij,ij->i", u, direction)
    for k in range(0, len(points), step):
        x = points[k:k + step]
        height = along(x, a, normal)
        inside = np.ones(height.shape, dtype=bool)
        in_plane = np.full(height.shape, np.inf)
        for u, side, square, inward in sides:
            s = along(x, u, side) / np.maximum(1e-300, square)
            off = along(x, u, inward) / np.sqrt(np.maximum(1e-300, square))
            inside = inside & (off >= 0)
            beyond = (s - np.clip(s, 0, 1)) ** 2 * square
            in_plane = np.minimum(in_plane, beyond + off * off)
        result[k:k + step] = np.sqrt((height * height + np.where(inside, 0, in_plane)).min(axis=1))
    return result


def deepest_point(points, surface):
    low, high = surface[0].min(axis=0), surface[0].max(axis=0)
    points = points[((points > low) & (points < high)).all(axis=1)]
    if len(points) == 0:
        return 0.0
    inside = points[are_inside(points, surface)]
    return float(distances(inside, surface).max()) if len(inside) else 0.0


def overlap(a, b, tolerance):
    """How deep two surfaces overlap at least; 0: no deeper than the tolerance, by edges, and by vertices and middles of
    triangles (where faces and edges are flush, no edge crosses a triangle and no vertex is inside)."""
    depth = max(deepest_crossing(a, b, tolerance), deepest_crossing(b, a, tolerance))
    if depth <= tolerance:
        depth = max(deepest_point(np.concatenate([one[0], one[0][one[1]].mean(axis=1)]), other) for one, other in ((a, b), (b, a)))
    return depth if depth > tolerance else 0.0


def sum_of_overlaps(a, b, per_edge=3):
    """Depth of the deepest point of A inside B and of B inside A, of points along all edges."""
    def samples(surface):
        ends = surface[0][edges_of(surface[1])]
        shares = np.linspace(0, 1, per_edge + 1)[:-1]
        return np.concatenate([(1 - s) * ends[:, 0] + s * ends[:, 1] for s in shares] + [surface[0]])
    return deepest_point(samples(a), b) + deepest_point(samples(b), a)


def lengths(surface, start, end):
    """Of the motion from one placement to another: the largest displacement of a vertex, the root mean square."""
    difference = end - start
    shifts = surface[0] @ difference[:, :3].T + difference[:, 3]
    centroid, second = mass_of(surface)
    middle = difference[:, :3] @ centroid + difference[:, 3]
    turn = difference[:, :3]
    return float(np.linalg.norm(shifts, axis=1).max()), float(np.sqrt(middle @ middle + np.trace(turn @ second @ turn.T)))


def check_itself():
    """Placements of two boxes whose overlap is known: face in face, bar through bar without vertices inside, one in the
    other, touching, apart."""
    def box(x, y, z):
        return prism(rectangle(x, y), -0.5 * z, 0.5 * z)

    def at(surface, shift):
        return surface[0] + np.asarray(shift, dtype=float), surface[1]
    cube, bar, small = box(2, 2, 2), box(0.6, 0.8, 9), box(0.5, 0.5, 0.5)
    cases = [(cube, at(cube, [1.9, 0.13, 0.07]), 0.1), (cube, at(cube, [1.9, 0, 0]), 0.1), (cube, at(bar, [0.3, 0.2, 0]), None),
             (cube, at(small, [0.1, 0.2, 0.3]), None), (cube, at(cube, [2, 0.13, 0.07]), 0), (cube, at(cube, [2, 0, 0]), 0),
             (cube, at(cube, [2.001, 0, 0]), 0), (bar, at(bar, [0.3, 0.4, 2]), None)]
    for a, b, depth in cases:
        for one, other in ((a, b), (b, a)):
            found = overlap(one, other, 1e-9)
            assert found > 1e-3 if depth is None else abs(found - depth) < 1e-9 or (depth > 0 and 0 < found <= depth + 1e-9), (depth, found)
    centroid, second = mass_of(at(bar, [1, 2, 3]))
    assert np.allclose(centroid, [1, 2, 3]) and np.allclose(second, np.diag([0.6**2, 0.8**2, 9**2]) / 12)
    turn = np.column_stack([np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]]), [0, 0, 0.1]])  # a quarter about z, and a slide
    most, mean = lengths(bar, np.eye(3, 4), turn)
    assert np.isclose(most**2, 2 * (0.3**2 + 0.4**2) + 0.01) and np.isclose(mean**2, 2 * (0.6**2 + 0.8**2) / 12 + 0.01)
