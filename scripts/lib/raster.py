# SPDX-License-Identifier: Apache-2.0
"""Triangles to pixels: parallel projection, depth, light from above left, edges of elements. numpy alone."""
import numpy as np

VIEWS = {"iso": (-60, 25), "front": (-90, 0), "back": (90, 0), "left": (180, 0), "right": (0, 0),
         "top": (-90, 90), "bottom": (-90, -90)}  # azimuth, elevation of the eye [degrees]
EDGE_WIDTH = 0.7  # half the width of an edge's line, in pixels of the picture at twice its size
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])  # of red, green, blue (ITU-R BT.709)
NO_VALUE = np.array([0.8, 0.8, 0.8])  # the colour of what is not a number


def view_axes(azimuth, elevation):
    """Rows: right, up, towards the eye."""
    a, e = np.radians([azimuth, elevation])
    towards = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0])
    return np.array([right, np.cross(towards, right), towards])


def bounds(points, axes):
    """Least and greatest place to the right and up [length]; of nothing a square around the origin."""
    if len(points) == 0:
        return np.array([[-1.0, -1.0], [1.0, 1.0]])
    seen = points.reshape(-1, 3) @ axes[:2].T
    return np.array([seen.min(axis=0), seen.max(axis=0)])


def to_pixels(points, axes, box, width, height, zoom):
    """Parallel projection that fits the box into the picture: x to the right, y down [pixels], depth as it is."""
    extent = np.maximum(box[1] - box[0], 1e-300)
    scale = zoom * 0.92 * min(width / extent[0], height / extent[1])
    seen = points @ axes.T
    centred = (seen[..., :2] - box.mean(axis=0)) * scale
    return np.stack([width / 2 + centred[..., 0], height / 2 - centred[..., 1], seen[..., 2] * scale], axis=-1)


def rasterise(corners, width, height):
    """Which triangle is seen in each pixel (-1: none) and its barycentric weights there. corners: [triangles][3][3].

    A triangle is a list of rows, a row a list of pixels between two sides: no loop over triangles, and no pixel is looked
    at that a triangle does not cover.
    """
    depth = np.full(width * height, -np.inf)
    seen = np.full(width * height, -1)
    triangle, y, first, count = rows_of(corners, width, height)
    slope = depth_slopes(corners)
    pixels = np.concatenate([[0], np.cumsum(count)])
    start = 0
    while start < len(triangle):
        end = max(start + 1, int(np.searchsorted(pixels, pixels[start] + 2_000_000, side="right")) - 1)
        rows = slice(start, end)
        row = np.repeat(np.arange(start, end), count[rows])
        x = first[row] + (np.arange(len(row)) - (pixels[row] - pixels[start]))
        splat(triangle[row], x, y[row], slope, width, depth, seen)
        start = end
    weights = np.zeros((width * height, 3))
    hit = np.flatnonzero(seen >= 0)
    weights[hit] = barycentric(corners[seen[hit]], hit % width + 0.5, hit // width + 0.5)
    return seen.reshape(height, width), weights.reshape(height, width, 3)


def rows_of(corners, width, height):
    """(triangle, y, first x, number of pixels) of all rows of pixels whose centres lie in a triangle."""
    x, y = corners[:, :, 0], corners[:, :, 1]
    low = np.clip(np.ceil(y.min(axis=1) - 0.5), 0, height).astype(int)
    high = np.clip(np.floor(y.max(axis=1) - 0.5), -1, height - 1).astype(int)
    rows = np.maximum(high - low + 1, 0)
    triangle = np.repeat(np.arange(len(corners)), rows)
    row = low[triangle] + np.arange(len(triangle)) - np.repeat(np.cumsum(rows) - rows, rows)
    left, right = np.full(len(triangle), np.inf), np.full(len(triangle), -np.inf)
    for p, q in ((0, 1), (1, 2), (2, 0)):
        y_p, y_q, x_p, x_q = y[triangle, p], y[triangle, q], x[triangle, p], x[triangle, q]
        crosses = (np.minimum(y_p, y_q) <= row + 0.5) & (row + 0.5 <= np.maximum(y_p, y_q)) & (y_p != y_q)
        share = (row + 0.5 - y_p) / np.where(crosses, y_q - y_p, 1)
        at = x_p + share * (x_q - x_p)
        left, right = np.where(crosses, np.minimum(left, at), left), np.where(crosses, np.maximum(right, at), right)
    slack = 1e-9  # [pixels] a centre on a side belongs to the triangles of both sides
    first = np.clip(np.ceil(left - 0.5 - slack), 0, width)
    last = np.clip(np.floor(right - 0.5 + slack), -1, width - 1)
    count = np.maximum(last - first + 1, 0).astype(int)
    return triangle, row, first.astype(int), count


def twice_areas(corners):
    a, b, c = (corners[:, k, :2] for k in range(3))
    area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (c[:, 0] - a[:, 0]) * (b[:, 1] - a[:, 1])
    return np.where(np.abs(area) < 1e-12, np.inf, area)  # seen from its edge: any corner's depth will do


def depth_slopes(corners):
    """Depth of each triangle's plane: its first corner, and the slopes to the right and down."""
    a, b, c = (corners[:, k] for k in range(3))
    u, v, area = b - a, c - a, twice_areas(corners)
    right = (u[:, 2] * v[:, 1] - v[:, 2] * u[:, 1]) / area
    down = (u[:, 0] * v[:, 2] - v[:, 0] * u[:, 2]) / area
    return a, right, down


def splat(triangle, x, y, slope, width, depth, seen):
    """Pixels of triangles into the picture: the nearest to the eye stays."""
    corner, right, down = slope
    z = corner[triangle, 2] + right[triangle] * (x + 0.5 - corner[triangle, 0]) + down[triangle] * (y + 0.5 - corner[triangle, 1])
    place = y * width + x
    nearer = np.flatnonzero(z > depth[place])
    order = nearer[np.argsort(z[nearer], kind="stable")]  # of several for a pixel the last one written is the nearest
    depth[place[order]] = z[order]
    seen[place[order]] = triangle[order]


def barycentric(corners, x, y):
    a, b, c = (corners[:, k, :2] for k in range(3))
    area = twice_areas(corners)
    at_a = ((c[:, 0] - b[:, 0]) * (y - b[:, 1]) - (x - b[:, 0]) * (c[:, 1] - b[:, 1])) / area
    at_b = ((a[:, 0] - c[:, 0]) * (y - c[:, 1]) - (x - c[:, 0]) * (a[:, 1] - c[:, 1])) / area
    return np.clip(np.stack([at_a, at_b, 1 - at_a - at_b], axis=-1), 0, 1)


def edge_strength(corners, edges, seen, weights):
    """1 on the edges of the elements' faces, 0 off them [seen pixels]."""
    points = corners[seen]
    twice_area = np.abs(np.cross(points[:, 1, :2] - points[:, 0, :2], points[:, 2, :2] - points[:, 0, :2]))
    strength = np.zeros(len(seen))
    for k in range(3):  # the side opposite corner k
        p, q = (k + 1) % 3, (k + 2) % 3
        length = np.linalg.norm(points[:, q, :2] - points[:, p, :2], axis=1)
        distance = weights[:, k] * twice_area / np.maximum(length, 1e-300)
        strength = np.maximum(strength, np.where(edges[seen, k], np.clip(EDGE_WIDTH + 0.5 - distance, 0, 1), 0))
    return strength


def light_on(corners):
    """Of each triangle, from above left; every one is lit from its visible side."""
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    normal *= np.where(normal[:, 2] < 0, -1, 1)[:, None]
    return 0.68 + 0.32 * np.clip(normal @ np.array([-0.35, -0.45, 0.82]), 0, 1)  # y of the picture points down


def draw(triangles, axes, box, size, colour_of, zoom=1.0, edges=True):
    """RGB picture [height][width][3], made at twice the size and averaged down. colour_of: values to RGB."""
    width, height = 2 * size[0], 2 * size[1]
    corners = to_pixels(triangles.corners, axes, box, width, height, zoom)
    seen, weights = rasterise(corners, width, height)
    picture = np.ones((height, width, 3))
    hit = seen >= 0
    triangle, w = seen[hit], weights[hit]
    value = (triangles.values[triangle] * w).sum(axis=1)
    colour = np.where(np.isfinite(value)[:, None], colour_of(np.where(np.isfinite(value), value, 0.0)), NO_VALUE)
    colour = colour * light_on(corners)[triangle][:, None]
    if edges:
        share = 0.75 * edge_strength(corners, triangles.edges, triangle, w)[:, None]
        middle = triangles.values.mean(axis=1)
        dark = colour_of(np.where(np.isfinite(middle), middle, 0.0)) @ LUMINANCE < 0.2  # a black line would be lost there
        dark = dark[triangle][:, None]
        colour = np.where(dark, (1 - 0.6 * share) * colour + 0.6 * share, (1 - share) * colour)
    picture[hit] = colour
    return picture.reshape(height // 2, 2, width // 2, 2, 3).mean(axis=(1, 3))
