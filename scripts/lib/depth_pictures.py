# SPDX-License-Identifier: Apache-2.0
"""Pictures of `brunt depth`: the two bodies before and after the motion, from the surfaces in its result folder."""
import csv
import math
import os

import numpy as np
from arguments import Fault
from pictures import DPI, PART_COLOURS, plt
from raster import bounds, draw, view_axes

MOST_ROWS = 6  # answers on one page
HEAD = 34  # height of the words over a panel [pixels]


class Triangles:
    """What raster.draw wants: corners, a number a corner that chooses the colour, which sides are edges."""

    def __init__(self, corners, values, edges):
        self.corners, self.values, self.edges = corners, values, edges


def read_ply(path):
    """Corners [triangles][3][3] of a binary PLY file as brunt depth writes it."""
    try:
        with open(path, "rb") as stream:
            data = stream.read()
        head, _, body = data.partition(b"end_header\n")
        words = [line.split() for line in head.decode("ascii").splitlines()]
        counts = {w[1]: int(w[2]) for w in words if w and w[0] == "element"}
        points = np.frombuffer(body, "<f8", 3 * counts["vertex"]).reshape(-1, 3)
        faces = np.frombuffer(body, np.dtype([("n", "u1"), ("corner", "<i4", 3)]), counts["face"], 24 * counts["vertex"])
        return points[faces["corner"]]
    except (OSError, ValueError, KeyError, IndexError) as error:
        raise Fault(f"{path}: cannot read the surface ({error}); expected a PLY file of brunt depth") from None


def clipped(corners, planes):
    """What lies on the side that the normals point away from, open where it is cut."""
    for point, normal in planes:
        kept = []
        height = (corners - point) @ normal
        inside = height <= 0
        kept.append(corners[inside.all(axis=1)])
        for triangle, h in zip(corners[inside.any(axis=1) & ~inside.all(axis=1)], height[inside.any(axis=1) & ~inside.all(axis=1)]):
            polygon = []
            for k in range(3):
                a, b, ha, hb = triangle[k], triangle[(k + 1) % 3], h[k], h[(k + 1) % 3]
                if ha <= 0:
                    polygon.append(a)
                if (ha <= 0) != (hb <= 0):
                    polygon.append(a + ha / (ha - hb) * (b - a))
            kept += [np.array([[polygon[0], polygon[k], polygon[k + 1]]]) for k in range(1, len(polygon) - 1)]
        corners = np.concatenate(kept) if kept else corners[:0]
    return corners


def is_depth_folder(path):
    return os.path.isdir(path) and os.path.exists(os.path.join(path, "depth.csv"))


def rows_of(folder):
    with open(os.path.join(folder, "depth.csv"), encoding="utf-8", newline="") as stream:
        rows = [row for row in csv.DictReader(stream) if row["overlap"] == "1" and row["found"] == "1"]
    rows = [row for row in rows if os.path.exists(stem(folder, row) + "_after.ply")]
    if not rows:
        raise Fault(f"{folder}: missing surfaces before and after the motion; expected a folder of brunt depth with at most ten poses")
    return rows


def stem(folder, row):
    return os.path.join(folder, f"pose{row['pose']}_{row['metric']}")


def panel(moved, other, look, eye, box, edges):
    scene = [clipped(other, look.planes), clipped(moved, look.planes)]
    corners = np.concatenate(scene)
    values = np.repeat(np.concatenate([np.full(len(part), k) for k, part in enumerate(scene)])[:, None], 3, axis=1)
    table = np.array([[0.72, 0.72, 0.72], PART_COLOURS[1]])
    triangles = Triangles(corners, values.astype(float), np.full((len(corners), 3), edges))
    return draw(triangles, eye, box, look.size, lambda value: table[np.clip(np.rint(value).astype(int), 0, 1)], look.zoom, edges)


def page(folder, look):
    """A figure: a line an answer, before and after, from each view."""
    rows = rows_of(folder)[:MOST_ROWS]
    width, height = look.size
    across = 2 * len(look.views)
    total = across * width, len(rows) * (height + HEAD)
    figure = plt.figure(figsize=(total[0] / DPI, total[1] / DPI), dpi=DPI)
    for line, row in enumerate(rows):
        surfaces = {name: read_ply(f"{stem(folder, row)}_{name}.ply") for name in ("before", "after", "other")}
        for k, (_, azimuth, elevation) in enumerate(look.views):
            eye = view_axes(azimuth, elevation)
            box = bounds(np.concatenate(list(surfaces.values())), eye)
            for side, name in enumerate(("before", "after")):
                top = line * (height + HEAD) + HEAD
                place = figure.add_axes([(2 * k + side) * width / total[0], 1 - (top + height) / total[1],
                                         width / total[0], height / total[1]])
                edges = look.edges and len(surfaces[name]) < 20000
                place.imshow(np.clip(panel(surfaces[name], surfaces["other"], look, eye, box, edges), 0, 1),
                             interpolation="nearest", aspect="auto")
                place.set_axis_off()
                words = "before" if side == 0 else words_of(row)
                figure.text(((2 * k + side) * width + 10) / total[0], 1 - (line * (height + HEAD) + 8) / total[1], words,
                            va="top", fontsize=min(10.0, width / 55))
    return figure


def drawn_points(folder):
    """Corners of all surfaces of each answer."""
    for row in rows_of(folder)[:MOST_ROWS]:
        yield np.concatenate([read_ply(f"{stem(folder, row)}_{name}.ply").reshape(-1, 3) for name in ("before", "after", "other")])


def words_of(row):
    turn = float(row["degrees"])
    text = f"after: {row['metric'].replace('_', ' ')} {float(row['depth']):.4g} (no less than {float(row['bound']):.4g})"
    return text + (f", turned {turn:.3g} degrees" if turn > 0 and math.isfinite(turn) else "")
