#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What scripts/render draws, as triangles and as pixels, against figures that are known. Needs no program."""
import math
import os
import sys
import unittest

import numpy as np

SCRIPTS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "scripts")
sys.path.insert(0, os.path.join(SCRIPTS, "lib"))
import arguments  # noqa: E402
import history  # noqa: E402
import raster  # noqa: E402
import surface  # noqa: E402


def cube(n, kind="hex"):
    """The unit cube of n^3 elements, or of six tetrahedra for each: points and the block."""
    axis = np.linspace(0, 1, n + 1)
    points = np.array([(x, y, z) for z in axis for y in axis for x in axis])
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    hexes = np.array([[(i + a) + (n + 1) * ((j + b) + (n + 1) * (k + c)) for a, b, c in corners]
                      for k in range(n) for j in range(n) for i in range(n)])
    cells = hexes if kind == "hex" else np.concatenate([hexes[:, tet] for tet in surface.HEX_TETS])
    return points, [("cube", 0, cells, "hex8" if kind == "hex" else "tet4")]


def areas(triangles):
    a, b, c = (triangles.corners[:, k] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def cut_area(points, blocks, plane):
    """Area of what lies in the plane of the surface cut open."""
    shown = np.ones(sum(len(cells) for _, _, cells, _ in blocks), bool)
    triangles = surface.surface(points, blocks, shown, np.zeros(len(points)), True, [plane])
    normal = np.array(plane[1]) / np.linalg.norm(plane[1])
    in_plane = np.abs((triangles.corners - np.array(plane[0])) @ normal).max(axis=1) < 1e-6
    return areas(triangles)[in_plane].sum(), triangles


class Sections(unittest.TestCase):
    def test_the_whole_surface(self):
        for kind in ("hex", "tet"):
            points, blocks = cube(3, kind)
            shown = np.ones(len(blocks[0][2]), bool)
            whole = surface.surface(points, blocks, shown, np.zeros(len(points)), True)
            self.assertAlmostEqual(areas(whole).sum(), 6, places=12)

    def test_shells_are_seen_once_and_have_no_section(self):
        points, blocks = cube(1)  # with a square fin on one face, half of it triangles, and a triangle apart
        points = np.concatenate([points, [(2, 0, 0), (2, 1, 0), (5, 0, 0), (6, 0, 0), (5, 1, 0)]])
        blocks += [("fin", 1, np.array([[1, 8, 9, 3]]), "quad4"), ("apart", 2, np.array([[10, 11, 12]]), "tri3")]
        seen = surface.surface(points, blocks, np.ones(3, bool), np.zeros(len(points)), True)
        self.assertAlmostEqual(areas(seen).sum(), 6 + 1 + 0.5, places=12)
        hidden = surface.surface(points, blocks, np.array([True, False, True]), np.zeros(len(points)), True)
        self.assertAlmostEqual(areas(hidden).sum(), 6.5, places=12)
        cut = surface.surface(points, blocks, np.ones(3, bool), np.zeros(len(points)), True, [(np.array([1.5, 0, 0]), np.array([1.0, 0, 0]))])
        self.assertAlmostEqual(areas(cut).sum(), 6.5, places=6)  # half of the fin stays
        on = [("skin", 1, np.array([[4, 5, 7, 6]]), "quad4")]  # a shell on a solid does not take its face away
        both = surface.surface(points, blocks[:1] + on, np.ones(2, bool), np.zeros(len(points)), True)
        self.assertAlmostEqual(areas(both).sum(), 7, places=12)

    def test_sections_close_what_is_cut_open(self):
        slope = np.array([1, 1, 1]) / math.sqrt(3)
        for kind in ("hex", "tet"):
            for n in (1, 2, 3, 5):
                points, blocks = cube(n, kind)
                for point, normal, wanted in (((0, 0, 0.4), (0, 0, 1), 1), ((0, 0, 0.4), (0, 0, -1), 1), ((0.5, 0, 0), (1, 0, 0), 1),
                                              ((1 / 3, 0, 0), (1, 0, 0), 1), ((0.5, 0.5, 0.5), slope, 3 * math.sqrt(3) / 4),
                                              ((0.5, 0.5, 0.5), -slope, 3 * math.sqrt(3) / 4), ((0.5, 0.5, 0), (1, 1, 0), math.sqrt(2))):
                    area, triangles = cut_area(points, blocks, (np.array(point), np.array(normal) / np.linalg.norm(normal)))
                    self.assertAlmostEqual(area, wanted, places=6, msg=f"{kind} {n} {point} {normal}")
                    beyond = (triangles.corners - np.array(point)) @ np.array(normal)
                    self.assertLess(beyond.max(), 1e-9)

    def test_a_plane_that_misses_the_body_takes_all_or_nothing(self):
        points, blocks = cube(2)
        self.assertAlmostEqual(areas(cut_area(points, blocks, (np.array([2.0, 0, 0]), np.array([1.0, 0, 0])))[1]).sum(), 6)
        self.assertEqual(len(cut_area(points, blocks, (np.array([2.0, 0, 0]), np.array([-1.0, 0, 0])))[1].corners), 0)

    def test_two_planes_leave_a_quarter(self):
        points, blocks = cube(3)
        planes = [(np.array([0.5, 0, 0]), np.array([1.0, 0, 0])), (np.array([0, 0.25, 0]), np.array([0, -1.0, 0]))]
        triangles = surface.surface(points, blocks, np.ones(27, bool), np.zeros(64), True, planes)
        self.assertAlmostEqual(areas(triangles).sum(), 2 * (0.5 * 0.75 + 0.5 + 0.75), places=6)

    def test_fields_are_read_inside_the_section(self):
        points, blocks = cube(4)
        for field in (points[:, 2], points @ [1.0, -2.0, 3.0]):  # linear, so that every place has its value
            triangles = surface.surface(points, blocks, np.ones(64, bool), field, True, [(np.array([0.5, 0.5, 0.6]), np.array([0.6, 0, 0.8]))])
            wanted = triangles.corners @ np.linalg.lstsq(points, field, rcond=None)[0]
            np.testing.assert_allclose(triangles.values, wanted, atol=1e-12)

    def test_edges_of_a_section_are_those_of_elements(self):
        points, blocks = cube(3)
        _, triangles = cut_area(points, blocks, (np.array([0, 0, 0.5]), np.array([0, 0, 1.0])))
        inside = np.abs(triangles.corners[:, :, 2] - 0.5).max(axis=1) < 1e-6
        ends = {tuple(np.round(np.sort(triangles.corners[t][[(k + 1) % 3, (k + 2) % 3], :2], axis=0).ravel(), 6))
                for t in np.flatnonzero(inside) for k in range(3) if triangles.edges[t, k]}
        for x0, y0, x1, y1 in ends:  # along the grid of thirds, never across an element
            on_line = [abs(3 * a - round(3 * a)) < 1e-4 for a in (x0, y0)]
            self.assertTrue((abs(x0 - x1) < 1e-5 and on_line[0]) or (abs(y0 - y1) < 1e-5 and on_line[1]), (x0, y0, x1, y1))


class Pixels(unittest.TestCase):
    def test_the_nearest_triangle_is_seen_and_pixels_are_all_found(self):
        generator = np.random.default_rng(1)
        corners = generator.uniform(-20, 120, (60, 3, 3))
        seen, weights = raster.rasterise(corners, 100, 90)
        x, y = np.meshgrid(np.arange(100) + 0.5, np.arange(90) + 0.5)
        best, who = np.full((90, 100), -np.inf), np.full((90, 100), -1)
        for t, (a, b, c) in enumerate(corners):  # pixel by pixel
            area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
            at_b = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area
            at_c = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area
            z = a[2] + at_b * (b[2] - a[2]) + at_c * (c[2] - a[2])
            nearer = (at_b >= 0) & (at_c >= 0) & (at_b + at_c <= 1) & (z > best)
            best, who = np.where(nearer, z, best), np.where(nearer, t, who)
        self.assertLess(np.mean(seen != who), 1e-3)
        np.testing.assert_allclose(weights[seen >= 0].sum(axis=1), 1, atol=1e-9)

    def test_nothing_to_see(self):
        for corners in (np.empty((0, 3, 3)), np.full((1, 3, 3), 1e12), np.zeros((2, 3, 3))):
            seen, _ = raster.rasterise(corners, 20, 30)
            self.assertEqual(seen.shape, (30, 20))


class Lines(unittest.TestCase):
    def test_thinned_lines_keep_their_extremes(self):
        time = np.linspace(0, 1, 50_000)
        values = np.sin(300 * time)
        values[12_345], values[40_000], values[7] = 9, -9, np.nan
        thin_time, thin = history.thinned(time, values)
        self.assertLess(len(thin), 2100)
        self.assertEqual((np.nanmax(thin), np.nanmin(thin)), (9, -9))
        self.assertEqual((thin_time[0], thin_time[-1]), (0, 1))
        self.assertTrue((np.diff(thin_time) > 0).all())

    def test_long_names_keep_both_ends(self):
        for most in (5, 16, 18):
            for name in ("tip", "x" * most, "a_rather_long_name_of_probe_17"):
                short = arguments.shorter(name, most)
                self.assertEqual(len(short), min(len(name), most))
                self.assertEqual((short[0], short[-1]), (name[0], name[-1]))

    def test_names_in_their_natural_order(self):
        self.assertEqual(sorted(["tip10", "tip2", "a", "tip1"], key=history.natural), ["a", "tip1", "tip2", "tip10"])


if __name__ == "__main__":
    unittest.main()
