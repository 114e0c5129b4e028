# SPDX-License-Identifier: Apache-2.0
"""The surface that a picture shows, as triangles: exterior faces of the elements shown, cut open by planes and closed again."""
import dataclasses

import numpy as np

HEX_FACES = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [0, 4, 7, 3], [0, 3, 2, 1], [4, 5, 6, 7]]
TET_FACES = [[0, 1, 3, 3], [1, 2, 3, 3], [0, 3, 2, 2], [0, 2, 1, 1]]  # a triangle repeats its last node
SHELL_FACES = {"quad4": [0, 1, 2, 3], "tri3": [0, 1, 2, 2]}
HEX_TETS = [[0, a, b, 6] for a, b in ((1, 2), (2, 3), (3, 7), (7, 4), (4, 5), (5, 1))]  # six around the diagonal 0-6
HEX_TET_OUTSIDE = [True, False, False, True]  # is the face opposite a corner of such a tetrahedron on the hexahedron's?


@dataclasses.dataclass
class Triangles:
    corners: np.ndarray  # [triangles][3][3] [length]
    values: np.ndarray   # [triangles][3] what is shown as colour
    edges: np.ndarray    # [triangles][3] is the side opposite this corner an edge of an element?

    def chosen(self, which):
        return Triangles(self.corners[which], self.values[which], self.edges[which])


def joined(pieces):
    return Triangles(*(np.concatenate([getattr(piece, field.name) for piece in pieces])
                       for field in dataclasses.fields(Triangles)))


def exterior_faces(blocks, shown):
    """Faces that belong to one of the elements shown, and all shells shown: nodes [faces][4], element [faces]."""
    nodes, element = [np.empty((0, 4), int)], [np.empty(0, int)]
    shells = [np.empty((0, 4), int)], [np.empty(0, int)]
    for _, first, connectivity, shape in blocks:
        index = first + np.arange(len(connectivity))
        seen = shown[index]
        if shape in SHELL_FACES:
            shells[0].append(connectivity[seen][:, SHELL_FACES[shape]])
            shells[1].append(index[seen])
            continue
        for face in (HEX_FACES if shape == "hex8" else TET_FACES):
            nodes.append(connectivity[seen][:, face])
            element.append(index[seen])
    nodes, element = np.concatenate(nodes), np.concatenate(element)
    key = nodes.copy()
    key[key[:, 3] == key[:, 2], 3] = -1  # neighbours repeat different nodes of a triangle
    key.sort(axis=1)
    order = np.lexsort(key.T)
    same_as_next = (key[order][1:] == key[order][:-1]).all(axis=1)
    single = ~(np.append(same_as_next, False) | np.append(False, same_as_next)) if len(order) else np.empty(0, bool)
    kept = np.sort(order[single])
    return np.concatenate([nodes[kept], *shells[0]]), np.concatenate([element[kept], *shells[1]])


def faces_as_triangles(points, faces, values):
    """Two triangles a quadrilateral, one where the last node repeats. values: [faces][4]."""
    corner = np.concatenate([np.tile([0, 1, 2], (len(faces), 1)),
                             np.tile([0, 2, 3], ((faces[:, 3] != faces[:, 2]).sum(), 1))])
    quads = np.flatnonzero(faces[:, 3] != faces[:, 2])
    face = np.concatenate([np.arange(len(faces)), quads])
    edges = np.ones((len(face), 3), dtype=bool)
    edges[quads, 1] = False         # the diagonal 0-2 lies opposite corner 1 of the first triangle
    edges[len(faces):, 2] = False   # and opposite the last corner of the second
    return Triangles(points[faces[face[:, None], corner]], values[face[:, None], corner], edges)


def surface(points, blocks, shown, values, nodal, planes=()):
    """Triangles of what is to be seen. planes: (point, outward normal); what lies beyond one of them is cut away, and
    the elements that it cuts are closed by their sections, with the field inside them."""
    faces, element = exterior_faces(blocks, shown)
    on_corners = values[faces] if nodal else np.repeat(values[element][:, None], 4, axis=1)
    if not planes:
        return faces_as_triangles(points, faces, on_corners)
    size = np.ptp(points, axis=0).max() if len(points) else 1.0
    beyond = [distance_beyond(points, plane, size) for plane in planes]
    pieces = [cut(faces_as_triangles(points, faces, on_corners), planes, size)]
    for own, distance in enumerate(beyond):
        cap = section(points, blocks, shown, values, nodal, distance)
        pieces.append(cut(cap, [plane for p, plane in enumerate(planes) if p != own], size))
    return joined(pieces)


def distance_beyond(points, plane, size):
    """Distance beyond the plane. What lies in it counts as beyond by a hair, so that an element's face in the plane is
    closed by the section of the element that stays, once."""
    point, normal = plane
    return (points - np.asarray(point)) @ np.asarray(normal) + 1e-9 * size


def between(a, b, distance_a, distance_b, *pairs):
    """Where the distance is zero on the way from a to b, of each pair of values."""
    share = distance_a / (distance_a - distance_b)
    return [x + (y - x) * share.reshape((-1,) + (1,) * (x.ndim - 1)) for x, y in ((a, b), *pairs)]


def cut(triangles, planes, size):
    """What lies on the inner side of all planes; a triangle that a plane crosses becomes one or two smaller ones."""
    for plane in planes:
        distance = distance_beyond(triangles.corners, plane, size)
        beyond = distance > 0
        count = beyond.sum(axis=1)
        pieces = [triangles.chosen(count == 0)]
        for corner in range(3):
            pieces += cut_one_off(triangles.chosen(sel := (count == 1) & beyond[:, corner]), distance[sel], corner)
            pieces += keep_one(triangles.chosen(sel := (count == 2) & ~beyond[:, corner]), distance[sel], corner)
        triangles = joined(pieces)
    return triangles


def crossing(t, distance, a, b):
    """Place and value where the plane crosses the side from corner a to corner b."""
    return between(t.corners[:, a], t.corners[:, b], distance[:, a], distance[:, b], (t.values[:, a], t.values[:, b]))


def assembled(corners, edges):
    """corners: three of (place, value); edges: of the side opposite each."""
    places, values = (np.stack(column, axis=1) for column in zip(*corners))
    flags = [np.broadcast_to(edge, len(places)) for edge in edges]
    return Triangles(places, values, np.stack(flags, axis=1))


def cut_one_off(t, distance, v):
    """Corner v goes; the rest, a quadrilateral, is two triangles."""
    u, w = (v + 1) % 3, (v + 2) % 3
    at_u, at_w = (t.corners[:, u], t.values[:, u]), (t.corners[:, w], t.values[:, w])
    p, q = crossing(t, distance, u, v), crossing(t, distance, w, v)
    return [assembled([at_u, at_w, q], [t.edges[:, u], False, t.edges[:, v]]),
            assembled([at_u, q, p], [True, t.edges[:, w], False])]


def keep_one(t, distance, v):
    """Corner v stays."""
    u, w = (v + 1) % 3, (v + 2) % 3
    kept = (t.corners[:, v], t.values[:, v])
    return [assembled([kept, crossing(t, distance, v, u), crossing(t, distance, v, w)],
                      [True, t.edges[:, u], t.edges[:, w]])]


# --- sections of elements -------------------------------------------------------------------------------------------

def section(points, blocks, shown, values, nodal, distance):
    """Sections of the solid elements by the plane, tetrahedron by tetrahedron (a hexahedron is six); only lines in the
    elements' faces are edges."""
    pieces = [Triangles(np.empty((0, 3, 3)), np.empty((0, 3)), np.empty((0, 3), bool))]
    for _, first, connectivity, shape in blocks:
        if shape in SHELL_FACES:
            continue
        index = first + np.arange(len(connectivity))
        beyond = distance[connectivity] > 0
        crossed = shown[index] & beyond.any(axis=1) & ~beyond.all(axis=1)
        nodes, element = connectivity[crossed], index[crossed]
        is_hex = shape == "hex8"
        for tet in (HEX_TETS if is_hex else [[0, 1, 2, 3]]):
            corners = nodes[:, tet]
            field = values[corners] if nodal else np.repeat(values[element][:, None], 4, axis=1)
            outside = HEX_TET_OUTSIDE if is_hex else [True] * 4
            pieces += sections_of_tets(points[corners], field, distance[corners], outside)
    return joined(pieces)


def sections_of_tets(corners, values, distance, outside):
    """corners: [tets][4][3], values and distance: [tets][4]; outside: is the line in the face opposite a corner an edge?"""
    beyond = distance > 0
    pieces = []

    def at(sel, a, b):
        return between(corners[sel, a], corners[sel, b], distance[sel, a], distance[sel, b],
                       (values[sel, a], values[sel, b]))

    for v in range(4):  # one corner by itself: a triangle
        a, b, c = (k for k in range(4) if k != v)
        for side in (True, False):
            sel = (beyond[:, v] == side) & (beyond[:, [a, b, c]] != side).all(axis=1)
            pieces.append(assembled([at(sel, v, a), at(sel, v, b), at(sel, v, c)],
                                    [outside[a], outside[b], outside[c]]))
    for a, b, c, d in ((0, 1, 2, 3), (0, 2, 1, 3), (0, 3, 1, 2)):  # two and two: a quadrilateral
        sel = (beyond[:, a] == beyond[:, b]) & (beyond[:, c] == beyond[:, d]) & (beyond[:, a] != beyond[:, c])
        ac, ad, bd, bc = at(sel, a, c), at(sel, a, d), at(sel, b, d), at(sel, b, c)
        pieces.append(assembled([ac, ad, bd], [outside[c], False, outside[b]]))
        pieces.append(assembled([ac, bd, bc], [outside[a], outside[d], False]))
    return pieces
