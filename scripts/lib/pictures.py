# SPDX-License-Identifier: Apache-2.0
"""Pictures of a result: what is shown, from where, in which colours; several views on a grid; films."""
import dataclasses
import io
import math
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib import patheffects

from arguments import Fault, excerpt, shorter
from raster import VIEWS, bounds, draw, view_axes
from state import field_values
from surface import surface

DPI = 100
BAR = 150   # [pixels] beside the views, for the scale of colours
HEAD = 40   # [pixels] above them, for the title
# Okabe and Ito's colours, which the colour-blind tell apart; then the same lighter
PART_COLOURS = np.array([[0, 114, 178], [230, 159, 0], [0, 158, 115], [204, 121, 167], [86, 180, 233], [213, 94, 0],
                         [240, 228, 66], [150, 150, 150]]) / 255


@dataclasses.dataclass
class Look:
    """What the pictures of one command share."""
    field: str = "displacement"
    views: list = dataclasses.field(default_factory=lambda: [("iso", *VIEWS["iso"])])  # name, azimuth, elevation
    size: tuple = (1000, 800)  # of one view [pixels]
    zoom: float = 1.0
    deform: float = 1.0        # factor on the displacement
    limits: tuple = None       # of the colours; None: of the values shown
    colours: str = "viridis"
    edges: bool = True
    hide: list = dataclasses.field(default_factory=list)
    only: list = dataclasses.field(default_factory=list)
    planes: list = dataclasses.field(default_factory=list)  # (point, outward normal): what lies beyond is cut away


@dataclasses.dataclass
class Shot:
    """One record as triangles."""
    triangles: object
    title: str
    time: str
    step: int
    heights: list = dataclasses.field(default_factory=list)  # (lowest, highest) over each plane, before it cuts


def parts_shown(state, look):
    """True for each block that is to be seen."""
    parts = state.parts()
    for name in look.hide + look.only:
        if name not in parts:
            raise Fault(f"unknown part {excerpt(name)}; expected one of {', '.join(sorted(set(parts)))}")
    shown = [(not look.only or part in look.only) and part not in look.hide for part in parts]
    if not any(shown):
        raise Fault("invalid selection: all parts are hidden; expected at least one visible part")
    return shown


def take(state, record, look):
    """Triangles and words for one record."""
    state.demand_mesh()
    points = state.positions(record, look.deform)
    if not np.isfinite(points).all():
        if look.deform not in (0.0, 1.0):
            raise Fault(f"out of range: --deform {look.deform:g} gives positions that are not finite; expected a smaller factor")
        raise Fault(f"invalid displacement of step {record.attrs['step']}: it is not finite; expected an earlier --time")
    blocks, shown = state.blocks(), state.alive(record)
    for (_, first, connectivity, _), seen in zip(blocks, parts_shown(state, look)):
        shown[first:first + len(connectivity)] &= seen
    if look.field == "part":
        values, nodal, title = np.zeros(len(shown)), False, "parts"
        order = list(dict.fromkeys(state.parts()))
        for part, first, connectivity, _ in blocks:
            values[first:first + len(connectivity)] = order.index(part)
    else:
        values, nodal, title = field_values(record, look.field)
    triangles = surface(points, blocks, shown, values, nodal, look.planes)
    drawn = np.unique(np.concatenate([c[shown[first:first + len(c)]].ravel() for _, first, c, _ in blocks])) if look.planes else []
    time = f"{record.attrs['time']:.6g} {state.unit_of('time')}".rstrip()
    return Shot(triangles, title, time, int(record.attrs["step"]), heights_over(look.planes, points[drawn]))


def heights_over(planes, points):
    """(lowest, highest) of the points over each plane; no point: (inf, -inf)."""
    over = [(points - point) @ normal for point, normal in planes]
    return [(h.min(initial=np.inf), h.max(initial=-np.inf)) for h in over]


def idle_planes(planes, heights):
    """A sentence for each plane that removes nothing, or all that is drawn. planes: as they were written; heights: those of each picture."""
    for k, plane in enumerate(planes):
        low, high = min(over[k][0] for over in heights), max(over[k][1] for over in heights)
        if high <= 0 or low > high:
            yield f"--clip {excerpt(plane)} removes nothing: all that is drawn lies on one side of the plane"
        elif low >= 0:
            yield f"--clip {excerpt(plane)} removes all that is drawn"


def limits_of(shots, look):
    """Range of the colours that all pictures share."""
    if look.limits:
        return tuple(look.limits)
    found = [values for shot in shots if len(values := shot.triangles.values[np.isfinite(shot.triangles.values)])]
    if not found:
        return 0.0, 1.0
    return min(v.min() for v in found), max(v.max() for v in found)


FARTHEST = 3  # a frame that holds all states may be so many times as large as the largest of them; then it goes with them


def boxes_of(shots, look):
    """For each picture what each of its views has to hold: the same place for all, or the same size around bodies that go
    far; and whether it goes with them."""
    by_view = []
    for _, azimuth, elevation in look.views:
        axes = view_axes(azimuth, elevation)
        by_view.append(np.array([bounds(shot.triangles.corners, axes) for shot in shots]))
    together = [np.array([ends[:, 0].min(axis=0), ends[:, 1].max(axis=0)]) for ends in by_view]
    largest = [(ends[:, 1] - ends[:, 0]).max(axis=0) for ends in by_view]
    follows = any((box[1] - box[0]).max() > FARTHEST * size.max() for box, size in zip(together, largest))
    if not follows:
        return [together] * len(shots), False
    return [[ends[k].mean(axis=0) + np.outer([-0.5, 0.5], size) for ends, size in zip(by_view, largest)]
            for k in range(len(shots))], True


def colour_function(look, limits, parts):
    if look.field == "part":
        table = part_colours(parts)
        return lambda value: table[np.clip(np.rint(value).astype(int), 0, len(table) - 1)]
    span = limits[1] - limits[0]
    colours = plt.get_cmap(look.colours)
    return lambda value: colours((value - limits[0]) / span if span > 0 else np.zeros_like(value))[:, :3]


def part_colours(parts):
    lighter = [PART_COLOURS * (1 - share) + share for share in (0, 0.45)]
    table = np.concatenate(lighter)
    return table[np.arange(max(len(parts), 1)) % len(table)]


# --- one page -------------------------------------------------------------------------------------------------------

def page(state, shot, look, limits, boxes):
    """A figure: the views on a grid, the scale beside them, the title above."""
    width, height = look.size
    across = math.ceil(math.sqrt(len(look.views)))
    down = math.ceil(len(look.views) / across)
    total = across * width + BAR, down * height + HEAD
    figure = plt.figure(figsize=(total[0] / DPI, total[1] / DPI), dpi=DPI)
    parts = list(dict.fromkeys(state.parts()))
    colour_of = colour_function(look, limits, parts)
    for k, (name, azimuth, elevation) in enumerate(look.views):
        left, top = (k % across) * width, HEAD + (k // across) * height
        place = figure.add_axes([left / total[0], 1 - (top + height) / total[1], width / total[0], height / total[1]])
        axes = view_axes(azimuth, elevation)
        picture = draw(shot.triangles, axes, boxes[k], look.size, colour_of, look.zoom, look.edges)
        place.imshow(np.clip(picture, 0, 1), interpolation="nearest", aspect="auto")
        place.set_axis_off()
        draw_triad(place, width, height, axes)
        if len(look.views) > 1:
            place.text(12, 10, name, va="top", fontsize=11, color="0.25")
    if look.field == "part":
        part_names(figure, total, [part for part, seen in zip(state.parts(), parts_shown(state, look)) if seen], parts)
    else:
        scale_of_colours(figure, total, look, limits, state.unit_of_field(look.field))
    unit = "" if look.field == "part" else state.unit_of_field(look.field)
    title = f"{shot.title}{f' [{unit}]' if unit else ''}    t = {shot.time}    step {shot.step}"
    size = min(11.0, 1.35 * total[0] / max(len(title), 1))  # [points] a letter is some 0.85 pixels wide a point
    figure.text(10 / total[0], 1 - 12 / total[1], title, va="top", fontsize=size)
    return figure


def scale_of_colours(figure, total, look, limits, unit):
    bar = figure.add_axes([(total[0] - BAR + 15) / total[0], 0.12, 18 / total[0], 0.72])
    if not limits[1] > limits[0]:
        limits = limits[0], limits[0] + (abs(limits[0]) or 1.0)  # one value everywhere: the lower end of the scale
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(*limits), look.colours)
    figure.colorbar(scale, cax=bar).ax.ticklabel_format(style="sci", scilimits=(-3, 4), useMathText=True)
    bar.set_xlabel(unit)


def part_names(figure, total, shown, parts):
    """A line of its colour for each part, as many as there is room for."""
    line, room = 20, int((total[1] - 2 * HEAD) / 20)
    colours = part_colours(parts)
    names = list(dict.fromkeys(shown))
    for k, name in enumerate(names[:room]):
        y = 1 - (HEAD + 20 + line * k) / total[1]
        rest = k == room - 1 and len(names) > room
        text = f"and {len(names) - k} more" if rest else shorter(name, 16)
        x = (total[0] - BAR + 8) / total[0]
        if not rest:
            figure.text(x, y, "\u25a0", color=colours[parts.index(name)], va="center", fontsize=13)
        figure.text(x + 20 / total[0], y, text, va="center", fontsize=8.5)


def draw_triad(place, width, height, axes):
    """The directions of x, y, z in the lower left corner."""
    arm = min(28.0, 0.12 * min(width, height))
    origin = np.array([1.45 * arm, height - 1.45 * arm])
    halo = [patheffects.withStroke(linewidth=3, foreground="white")]  # it may lie on a body
    for k, (name, colour) in enumerate(zip("xyz", ("#d55e00", "#009e73", "#0072b2"))):
        step = np.array([axes[0][k], -axes[1][k]])
        if np.hypot(*step) < 0.05:
            continue
        place.annotate("", origin + arm * step, origin, arrowprops={"arrowstyle": "->", "color": colour, "path_effects": halo})
        place.text(*(origin + 1.36 * arm * step), name, color=colour, ha="center", va="center", path_effects=halo)


# --- files ----------------------------------------------------------------------------------------------------------

FILM_KINDS = {".gif": "GIF", ".png": "PNG", ".webp": "WEBP"}


def image_of(figure):
    """As Pillow's picture."""
    from PIL import Image  # a film alone needs it
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=DPI)
    plt.close(figure)
    buffer.seek(0)
    return Image.open(buffer).convert("RGB")


def frames(state, shots, look):
    """A picture of each shot; views and colours stay the same."""
    limits, (boxes, _) = limits_of(shots, look), boxes_of(shots, look)
    for shot, box in zip(shots, boxes):
        yield image_of(page(state, shot, look, limits, box))


def write_film(path, images, frames_per_second, fail):
    """One file of all pictures, played for ever: GIF, animated PNG or WebP, as its name ends."""
    kind = FILM_KINDS[os.path.splitext(path)[1].lower()]
    images = list(images)
    if kind == "GIF":
        images = [image.quantize(256, dither=0) for image in images]
    pause = [round(1000 / frames_per_second)] * len(images)
    pause[-1] = max(pause[-1], 1000)  # [ms] the end stands still for a while
    try:
        images[0].save(path, format=kind, save_all=True, append_images=images[1:], duration=pause, loop=0,
                       **({"quality": 85} if kind == "WEBP" else {}))
    except (OSError, ValueError) as error:
        fail(f"{path}: cannot write the file ({getattr(error, 'strerror', None) or error})")
