# SPDX-License-Identifier: Apache-2.0
"""Closed triangle surfaces of parts that fit into each other: stacks of rings of equally many points. Lengths in mm."""
import numpy as np


def circle(count, radius, phase=0.0):
    """Ring of a regular polygon, counter-clockwise."""
    angle = phase + 2 * np.pi * np.arange(count) / count
    return radius * np.column_stack([np.cos(angle), np.sin(angle)])


def rectangle(width, height):
    return 0.5 * np.array([[width, -height], [width, height], [-width, height], [-width, -height]])


def cross(half_length, half_width):
    """Ring of a cross of two bars, counter-clockwise."""
    long, wide = half_length, half_width
    quarter = np.array([[long, -wide], [long, wide], [wide, wide]])
    turn = np.array([[0, -1], [1, 0]])
    return np.concatenate([quarter @ np.linalg.matrix_power(turn, k).T for k in range(4)])


def gear_ring(teeth, module, backlash):
    """Involute spur gear of pressure angle 20 degrees: five points a flank, teeth thinner by half of the backlash."""
    pressure = np.radians(20)
    pitch, base = 0.5 * teeth * module, 0.5 * teeth * module * np.cos(pressure)
    root, tip = pitch - 1.25 * module, pitch + module

    def involute(radius):
        angle = np.arccos(np.minimum(1, base / radius))
        return np.tan(angle) - angle

    radii = np.linspace(max(base, root + 0.05 * module), tip, 5)
    half = np.pi / (2 * teeth) - backlash / (4 * pitch) + involute(pitch) - involute(radii)
    foot = half[0] + 0.1 * (np.pi / teeth - half[0])
    points = []
    for tooth in range(teeth):
        middle = 2 * np.pi * tooth / teeth
        for radius, angle in [(root, -foot)] + list(zip(radii, -half)) + list(zip(radii, half))[::-1] + [(root, foot)]:
            points.append([radius * np.cos(middle + angle), radius * np.sin(middle + angle)])
    return np.array(points)


def stack(rings, levels, closed=False):
    """Surface through rings at their levels z; caps about the means of the end rings unless closed to a tube. Outward if the rings run
    counter-clockwise and upwards (a tube: up outside, down inside)."""
    count = len(rings[0])
    points = [np.column_stack([ring, np.full(count, z)]) for ring, z in zip(rings, levels)]
    triangles = []
    following = (np.arange(count) + 1) % count
    here = np.arange(count)
    for k in range(len(rings) if closed else len(rings) - 1):
        low, high = k * count, (k + 1) % len(rings) * count
        triangles += [np.column_stack([low + here, low + following, high + following]),
                      np.column_stack([low + here, high + following, high + here])]
    if not closed:
        centre = len(rings) * count
        points.append(np.array([[*rings[k].mean(axis=0), levels[k]] for k in (0, -1)]))
        top = (len(rings) - 1) * count
        triangles += [np.column_stack([following, here, np.full(count, centre)]),
                      np.column_stack([top + here, top + following, np.full(count, centre + 1)])]
    return np.concatenate(points), np.concatenate(triangles)


def prism(ring, low, high, layers=1):
    levels = np.linspace(low, high, layers + 1)
    return stack([ring] * len(levels), levels)


def tube(outer, inner, low, high, layers=1):
    """Between two rings of equally many points."""
    levels = np.linspace(low, high, layers + 1)
    return stack([outer] * len(levels) + [inner] * len(levels), [*levels, *levels[::-1]], closed=True)


def block_with_slot(width, height, length, slot_width, slot_depth):
    """Prism along z of a block with a slot open towards +y; the floor of the slot is y = 0."""
    w, s = 0.5 * width, 0.5 * slot_width
    ring = np.array([[-w, slot_depth - height], [w, slot_depth - height], [w, slot_depth], [s, slot_depth], [s, 0],
                     [-s, 0], [-s, slot_depth], [-w, slot_depth]])
    points = np.concatenate([np.column_stack([ring, np.full(8, z)]) for z in (-0.5 * length, 0.5 * length)])
    cap = [[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4], [0, 5, 6], [0, 6, 7]]
    triangles = [[c, b, a] for a, b, c in cap] + [[a + 8, b + 8, c + 8] for a, b, c in cap]
    for i in range(8):
        j = (i + 1) % 8
        triangles += [[i, j, j + 8], [i, j + 8, i + 8]]
    return points, np.array(triangles)


def thread(core, height, pitch, turns, per_turn, per_pitch, other=None):
    """A bolt whose radius varies along a helix, with lead-ins of one ring; with a ring `other` a nut about it, whose
    thread is the same surface with `core` larger."""
    levels = pitch * np.arange(turns * per_pitch + 1) / per_pitch
    angle = 2 * np.pi * np.arange(per_turn) / per_turn
    rings = []
    for z in levels:
        phase = (z / pitch - angle / (2 * np.pi)) % 1
        radius = core + height * (1 - np.abs(2 * phase - 1))
        rings.append(np.column_stack([radius * np.cos(angle), radius * np.sin(angle)]))
    if other is None:
        return stack(rings, levels)
    return stack([other] * len(levels) + rings[::-1], [*levels, *levels[::-1]], closed=True)


def refined(surface):
    """Each triangle cut in four."""
    points, triangles = surface
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    unique, inverse = np.unique(edges, axis=0, return_inverse=True)
    inverse = inverse.reshape(-1)
    middle = len(points) + inverse.reshape(3, -1).T
    a, b, c = triangles.T
    ab, bc, ca = middle.T
    cut = [np.column_stack(t) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]
    return np.concatenate([points, points[unique].mean(axis=1)]), np.concatenate(cut)


def volume(surface):
    a, b, c = (surface[0][surface[1][:, k]] for k in range(3))
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def mass_of(surface):
    """Centroid, and the matrix of second moments about it over the volume [length^2]."""
    corners = surface[0][surface[1]]
    weights = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    total = corners.sum(axis=1)
    centroid = (weights[:, None] * total / 4).sum(axis=0) / weights.sum()
    second = np.einsum("t,ti,tj->ij", weights, total, total) + np.einsum("t,tki,tkj->ij", weights, corners, corners)
    return centroid, second / (20 * weights.sum()) - np.outer(centroid, centroid)


def write_stl(path, surface):
    corners = surface[0][surface[1]]
    with open(path, "w", encoding="ascii") as file:
        file.write("solid part\n")
        for triangle in corners:
            file.write("facet normal 0 0 0\nouter loop\n")
            file.writelines(f"vertex {x:.17g} {y:.17g} {z:.17g}\n" for x, y, z in triangle)
            file.write("endloop\nendfacet\n")
        file.write("endsolid part\n")


def write_obj(path, surface):
    with open(path, "w", encoding="ascii") as file:
        file.writelines(f"v {x:.17g} {y:.17g} {z:.17g}\n" for x, y, z in surface[0])
        file.writelines(f"f {a} {b} {c}\n" for a, b, c in surface[1] + 1)
