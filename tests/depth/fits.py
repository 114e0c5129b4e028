#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Random pairs of parts that fit into each other and overlap a little: what is known of each by construction.

    fits.py FOLDER [--count N] [--seed S] [--kind KIND]   writes NAME_a.stl (or .obj), NAME_b.*, NAME.csv (the pose of A)
                                                          and pairs.json (kind, sizes, bounds) into FOLDER

Every pair comes from a free placement, which is checked here by numpy alone (fit_check.py), and from a motion of A that
makes it overlap. The way back is an upper bound for all metrics: it is shortened by bisection to where A is just free.
Where the free space is convex (a pin or key between planes), the shortest translation among these planes is exact and
found by a quadratic program in three unknowns.
"""
import argparse
import itertools
import json
import os
import random
from dataclasses import dataclass, field

import numpy as np

import fit_check
import fit_shapes as shapes

KINDS = ("pin", "key", "lid", "gear", "thread", "peg", "cross")
FREE = 1e-9  # of the size: overlaps below this are rounding of coordinates
HALVINGS = 9  # of the way back: its end is known to 1/500
MOST_TRIES = 40


@dataclass
class Pair:
    """A and B in common axes; `free`, `start`: placements of A, 3 x 4."""
    kind: str
    a: tuple
    b: tuple
    free: np.ndarray
    start: np.ndarray
    sizes: dict
    planes: list = field(default_factory=list)  # (normal, offset, z-range of A's points) that bound the free space
    seed: int = 0
    bounds: dict = field(default_factory=dict)  # of each metric: a free motion of A of that length exists
    bounds_of_b: dict = field(default_factory=dict)  # the same where B moves
    overlaps: float = 0.0
    extension: str = "stl"

    @property
    def size(self):
        return float(np.ptp(self.b[0], axis=0).max())


def rotation(axis, angle):
    axis = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def placement(turn=None, shift=(0, 0, 0)):
    return np.column_stack([np.eye(3) if turn is None else turn, np.asarray(shift, dtype=float)])


def moved(one, two):
    """one after two."""
    return placement(one[:, :3] @ two[:, :3], one[:, :3] @ two[:, 3] + one[:, 3])


def inverse(one):
    return placement(one[:, :3].T, -one[:, :3].T @ one[:, 3])


def random_rotation(dice):
    q = np.array([dice.gauss(0, 1) for _ in range(4)])
    w, x, y, z = q / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def overlap_of(dice):
    """Mostly .1 to .5 mm, one in ten deep."""
    return dice.uniform(1, 3) if dice.random() < 0.1 else dice.uniform(0.1, 0.5)


def tilt_of(dice, most_degrees):
    """None for half of the pairs; about a random axis across z."""
    if dice.random() < 0.5:
        return np.eye(3)
    angle = dice.uniform(0, 2 * np.pi)
    return rotation([np.cos(angle), np.sin(angle), 0], np.radians(dice.uniform(0.05, 1) * most_degrees))


def quarter_turn(dice, quarters=(0, 1, 2, 3)):
    """About z; exact, or by any angle."""
    k = dice.choice([*quarters, None])
    if k is None:
        return rotation([0, 0, 1], dice.uniform(0, 2 * np.pi))
    return np.round(rotation([0, 0, 1], 0.5 * np.pi * k))


def pin(dice):
    bore, length = dice.uniform(3, 15), dice.uniform(8, 40)
    inner, around, layers = dice.choice([16, 24, 32, 48]), dice.choice([12, 20, 32, 48]), dice.choice([1, 2, 4])
    clearance, over = dice.uniform(0.02, 0.5), overlap_of(dice)
    inscribed = bore * np.cos(np.pi / inner)
    radius, long = inscribed - clearance, length * dice.uniform(0.6, 2.2)
    a = shapes.prism(shapes.circle(around, radius), -0.5 * long, 0.5 * long, dice.choice([1, 3, 6]))
    b = shapes.tube(shapes.circle(inner, bore * dice.uniform(1.3, 2.5)), shapes.circle(inner, bore), -0.5 * length, 0.5 * length, layers)
    angle, low = dice.uniform(0, 2 * np.pi), dice.uniform(-0.3, 0.3) * length
    shift = np.array([np.cos(angle), np.sin(angle), 0]) * (clearance + over) + [0, 0, low]
    turn = quarter_turn(dice)
    normals = [[np.cos(t), np.sin(t), 0] for t in 2 * np.pi * (np.arange(inner) + 0.5) / inner]
    return Pair("pin", a, b, placement(turn, [0, 0, low]), placement(tilt_of(dice, 2) @ turn, shift),
                {"bore": bore, "clearance": clearance, "over": over, "length": length, "pin_length": long},
                [(n, inscribed, (-0.5 * length, 0.5 * length)) for n in normals])


def key(dice):
    width, depth, length = dice.uniform(3, 12), dice.uniform(2, 8), dice.uniform(10, 50)
    clearance, over = dice.uniform(0.02, 0.2), overlap_of(dice)
    height, long = depth * dice.uniform(0.8, 1.6), length * dice.uniform(0.4, 1.3)
    ring = shapes.rectangle(width - 2 * clearance, height) + [0, 0.5 * height]
    a = shapes.prism(ring, -0.5 * long, 0.5 * long, dice.choice([1, 4]))
    b = shapes.block_with_slot(width * dice.uniform(2, 4), depth * dice.uniform(1.6, 3), length, width, depth)
    free = placement(None, [0, clearance, 0])
    side, down = dice.choice([(1, 0), (0, 1), (1, 1), (-1, 0)])
    start = placement(tilt_of(dice, 0.5) if side else None, [side * (clearance + over), clearance - down * (over + clearance), 0])
    planes = [([s, 0, 0], 0.5 * width, (-0.5 * length, 0.5 * length)) for s in (1, -1)] + [([0, -1, 0], 0, (-0.5 * length, 0.5 * length))]
    return Pair("key", a, b, free, start, {"width": width, "clearance": clearance, "over": over, "length": length}, planes)


def lid(dice):
    width, height, tall = dice.uniform(20, 60), dice.uniform(15, 50), dice.uniform(10, 40)
    wall, clearance, over = dice.uniform(1.5, 4), dice.uniform(0.05, 0.3), overlap_of(dice)
    outer, inner = shapes.rectangle(width, height), shapes.rectangle(width - 2 * wall, height - 2 * wall)
    plug = shapes.rectangle(width - 2 * wall - 2 * clearance, height - 2 * wall - 2 * clearance)
    deep, plate = dice.uniform(2, 0.4 * tall), dice.uniform(1.5, 4)
    a = shapes.stack([plug, plug, outer, outer], [-deep, 0, 0, plate])
    b = shapes.stack([outer, outer, inner, inner], [-tall, 0, 0, wall - tall])
    side, down = dice.choice([(1, 0), (0, 1), (1, 1)])
    shift = [side * (clearance + over), side * dice.uniform(-1, 1) * (clearance + over), -down * over]
    turn = np.round(rotation([0, 0, 1], np.pi * dice.choice([0, 1])))
    return Pair("lid", a, b, placement(turn), placement(tilt_of(dice, 0.3) @ turn if side else turn, shift),
                {"width": width, "height": height, "wall": wall, "clearance": clearance, "over": over})


def gear(dice):
    module, one, two = dice.uniform(1, 4), dice.randint(12, 28), dice.randint(12, 28)
    face, backlash, over = module * dice.uniform(3, 8), module * dice.uniform(0.04, 0.15), min(overlap_of(dice), 0.25 * 4)
    distance = 0.5 * module * (one + two) + 0.05 * module

    def wheel(teeth):
        ring = shapes.gear_ring(teeth, module, backlash)
        return shapes.tube(ring, ring / np.linalg.norm(ring, axis=1)[:, None] * 0.2 * teeth * module, -0.5 * face, 0.5 * face)
    free = placement(rotation([0, 0, 1], np.pi + np.pi / one), [distance, 0, dice.uniform(-0.2, 0.2) * face])
    if dice.random() < 0.5:  # turned on its axis: flank in flank
        turn = rotation([0, 0, 1], dice.choice([1, -1]) * (over + backlash) / (0.5 * one * module))
        start = placement(turn @ free[:, :3], free[:, 3])
    else:
        start = placement(free[:, :3], free[:, 3] - [over + 0.3 * module, 0, 0])
    return Pair("gear", wheel(one), wheel(two), free, start, {"module": module, "teeth": [one, two], "backlash": backlash, "over": over})


def thread(dice):
    pitch, around = dice.uniform(1.5, 4), dice.choice([12, 16, 24])
    core, height, clearance = pitch * dice.uniform(2, 4), 0.6 * pitch, pitch * dice.uniform(0.06, 0.12)
    over, turns = min(overlap_of(dice), 0.25 * pitch), dice.randint(2, 3)
    a = shapes.thread(core, height, pitch, turns + dice.randint(1, 2), around, 6)
    nut_core = core + clearance
    b = shapes.thread(nut_core, height, pitch, turns, around, 6, shapes.circle(around, 1.8 * (nut_core + height)))
    free = placement(None, [0, 0, -pitch * dice.randint(0, 1)])
    axial = 0.5 * pitch * clearance / height + over
    shift = [0, 0, dice.choice([1, -1]) * axial] if dice.random() < 0.5 else [clearance + over, 0, 0]
    return Pair("thread", a, b, free, placement(tilt_of(dice, 1), free[:, 3] + shift), {"pitch": pitch, "core": core, "clearance": clearance, "over": over})


def through_hole(dice, kind, half_ring, hole_ring, outer, thick, long, tilt):
    """A straight peg in a straight hole, shifted, tilted, or turned about its axis."""
    clearance, over = dice.uniform(0.05, 0.3), overlap_of(dice)
    reach = float(np.linalg.norm(half_ring(0), axis=1).max())
    a = shapes.prism(half_ring(clearance), -0.5 * long, 0.5 * long, dice.choice([1, 4]))
    b = shapes.tube(outer, hole_ring, -0.5 * thick, 0.5 * thick)
    free = placement(np.round(rotation([0, 0, 1], 0.5 * np.pi * dice.choice([0, 1]))) if kind == "cross" else None, [0, 0, 0.1 * thick])
    how = dice.choice(["shift", "tilt", "turn"])
    turn, shift = np.eye(3), np.zeros(3)
    if how == "shift":
        angle = dice.choice([0, 0.5 * np.pi, dice.uniform(0, 2 * np.pi)])
        shift = np.array([np.cos(angle), np.sin(angle), 0]) * 1.2 * (clearance + over)
    elif how == "tilt":
        turn = rotation([0, 1, 0], tilt * dice.uniform(0.3, 1) + 4 * clearance / thick)
    else:
        turn = rotation([0, 0, 1], 1.5 * (clearance + over) / reach)
    return Pair(kind, a, b, free, placement(turn @ free[:, :3], free[:, 3] + shift), {"clearance": clearance, "over": over, "how": how})


def peg(dice):
    width, height = dice.uniform(4, 12), dice.uniform(4, 12)
    return through_hole(dice, "peg", lambda gap: shapes.rectangle(width - 2 * gap, height - 2 * gap), shapes.rectangle(width, height),
                        shapes.rectangle(4 * width, 4 * height), dice.uniform(3, 15), dice.uniform(10, 40), np.radians(4))


def cross(dice):
    long, wide = dice.uniform(6, 15), dice.uniform(1.2, 3)
    return through_hole(dice, "cross", lambda gap: shapes.cross(long - gap, wide - gap), shapes.cross(long, wide),
                        shapes.cross(2 * long, 1.9 * long), dice.uniform(5, 15), dice.uniform(10, 40), np.radians(3))


def nearest_translation(pair):
    """The shortest translation across the axis z after which A's points, cut to the walls' heights, lie before all
    planes: an exact value for translations across z, an upper bound of all."""
    points = fit_check.placed(pair.a, pair.start)[0]
    edges = points[fit_check.edges_of(pair.a[1])]
    rows, limits = [], []
    for normal, offset, (low, high) in pair.planes:
        normal = np.asarray(normal, dtype=float)
        reach = -np.inf
        inside = (points[:, 2] >= low) & (points[:, 2] <= high)
        if inside.any():
            reach = (points[inside] @ normal).max()
        for level in (low, high):
            before, after = edges[:, 0, 2] - level, edges[:, 1, 2] - level
            cut = before * after < 0
            if cut.any():
                share = before[cut] / (before[cut] - after[cut])
                reach = max(reach, ((edges[cut, 0] + share[:, None] * (edges[cut, 1] - edges[cut, 0])) @ normal).max())
        if np.isfinite(reach):
            rows.append(normal[:2])
            limits.append(offset - reach)
    return nearest_in_plane(np.array(rows), np.array(limits))


def nearest_in_plane(rows, limits):
    """min |t| subject to rows t <= limits, t in the plane: at no, one or two active rows."""
    best = None
    candidates = [np.zeros(2)] + [row * limit / (row @ row) for row, limit in zip(rows, limits)]
    for i, j in itertools.combinations(range(len(rows)), 2):
        pair = rows[[i, j]]
        if abs(np.linalg.det(pair)) > 1e-9:
            candidates.append(np.linalg.solve(pair, limits[[i, j]]))
    for t in sorted(candidates, key=np.linalg.norm):
        if (rows @ t <= limits + 1e-9).all():
            best = t
            break
    return None if best is None else np.array([best[0], best[1], 0.0])


def is_free(pair, at):
    return fit_check.overlap(fit_check.placed(pair.a, at), pair.b, FREE * pair.size) == 0


def on_the_way(pair, share):
    """From the start (0) to the free placement (1): rotation about the centroid, the centroid on a straight line."""
    centroid, _ = shapes.mass_of(pair.a)
    back = pair.free[:, :3] @ pair.start[:, :3].T
    cosine = np.clip(0.5 * (np.trace(back) - 1), -1, 1)
    axis = np.array([back[2, 1] - back[1, 2], back[0, 2] - back[2, 0], back[1, 0] - back[0, 1]])
    turn = rotation(axis, share * np.arccos(cosine)) if np.linalg.norm(axis) > 1e-14 else np.eye(3)
    turn = turn @ pair.start[:, :3]
    one, other = (p[:, :3] @ centroid + p[:, 3] for p in (pair.start, pair.free))
    return placement(turn, (1 - share) * one + share * other - turn @ centroid)


def offer(pair, at):
    """A free placement bounds each metric, whichever of the two moves there."""
    straight = np.abs(at[:, :3] - pair.start[:, :3]).max() < 1e-12
    for surface, bounds, start, end in ((pair.a, pair.bounds, pair.start, at), (pair.b, pair.bounds_of_b, inverse(pair.start), inverse(at))):
        most, mean = fit_check.lengths(surface, start, end)
        found = {"displacement": most, "object_norm": mean} | ({"translation": most} if straight else {})
        for metric, length in found.items():
            bounds[metric] = min(length, bounds.get(metric, np.inf))


def judge(pair):
    """Whether the pair is what it should be: free where it is free, overlapping at the start. Fills its bounds."""
    if not is_free(pair, pair.free) or fit_check.overlap(fit_check.placed(pair.a, pair.start), pair.b, 1e-4) == 0:
        return False
    low, high = 0.0, 1.0
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if is_free(pair, on_the_way(pair, middle)) else (middle, high)
    offer(pair, on_the_way(pair, high))
    for turns in (pair.start[:, :3], pair.free[:, :3]):  # as it stands, and turned back
        centroid, _ = shapes.mass_of(pair.a)
        start = placement(turns, pair.start[:, :3] @ centroid + pair.start[:, 3] - turns @ centroid)
        shift = nearest_translation(Pair(pair.kind, pair.a, pair.b, pair.free, start, {}, pair.planes)) if pair.planes else None
        if shift is not None and is_free(pair, at := placement(turns, start[:, 3] + shift * (1 + 1e-9))):
            offer(pair, at)
    pair.overlaps = fit_check.sum_of_overlaps(fit_check.placed(pair.a, pair.start), pair.b)
    return True


def make(kind, seed):
    """The pair of that kind and seed; draws again, from the same numbers, until one is sound."""
    dice = random.Random(f"{kind} {seed}")
    for _ in range(MOST_TRIES):
        pair = {"pin": pin, "key": key, "lid": lid, "gear": gear, "thread": thread, "peg": peg, "cross": cross}[kind](dice)
        for name in "ab":
            if dice.random() < 0.15 and len(getattr(pair, name)[1]) < 600:
                setattr(pair, name, shapes.refined(getattr(pair, name)))
        pair.seed, pair.extension = seed, dice.choice(["stl", "obj"])
        if judge(pair):
            return in_frames(pair, dice) if dice.random() < 0.5 else pair
    raise RuntimeError(f"no sound pair of kind {kind} in {MOST_TRIES} draws of seed {seed}")


def in_frames(pair, dice, reach=100):
    """The same pair with the files of A and B each in axes of their own."""
    to_a, to_b = (placement(random_rotation(dice), [dice.uniform(-reach, reach) for _ in range(3)]) for _ in "ab")
    return Pair(pair.kind, fit_check.placed(pair.a, to_a), fit_check.placed(pair.b, to_b), moved(to_b, moved(pair.free, inverse(to_a))),
                moved(to_b, moved(pair.start, inverse(to_a))), pair.sizes, [], pair.seed, pair.bounds, pair.bounds_of_b, pair.overlaps, pair.extension)


def exchanged(pair):
    """B moves and A stands still."""
    return Pair(pair.kind, pair.b, pair.a, inverse(pair.free), inverse(pair.start), pair.sizes, [], pair.seed, pair.bounds_of_b, pair.bounds,
                pair.overlaps, pair.extension)


def quaternion(turn):
    """(w, x, y, z) of a rotation, from its largest component."""
    t = np.array([np.trace(turn), *np.diag(turn)])
    k = int(t.argmax())
    if k == 0:
        q = np.array([1 + t[0], turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    else:
        i, j, m = k - 1, k % 3, (k + 1) % 3
        q = np.empty(4)
        q[[0, 1 + i, 1 + j, 1 + m]] = (turn[m, j] - turn[j, m], 1 + turn[i, i] - turn[j, j] - turn[m, m],
                                       turn[j, i] + turn[i, j], turn[m, i] + turn[i, m])
    return q / np.linalg.norm(q)


def write(pair, folder, name):
    """Returns the paths of A, of B and of the pose."""
    save = shapes.write_stl if pair.extension == "stl" else shapes.write_obj
    paths = [os.path.join(folder, f"{name}_{part}.{pair.extension}") for part in "ab"]
    for path, surface in zip(paths, (pair.a, pair.b)):
        save(path, surface)
    pose = os.path.join(folder, f"{name}.csv")
    with open(pose, "w", encoding="ascii") as file:
        numbers = [*pair.start[:, 3], *quaternion(pair.start[:, :3])]
        file.write("x,y,z,qw,qx,qy,qz\n" + ",".join(f"{x:.17g}" for x in numbers) + "\n")
    return [*paths, pose]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--count", type=int, default=14)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kind", choices=KINDS)
    options = parser.parse_args()
    os.makedirs(options.folder, exist_ok=True)
    told = []
    for k in range(options.count):
        pair = make(options.kind or KINDS[k % len(KINDS)], options.seed + k)
        name = f"{pair.kind}{pair.seed}"
        a, b, pose = write(pair, options.folder, name)
        told.append({"name": name, "a": a, "b": b, "pose": pose, "kind": pair.kind, "sizes": pair.sizes,
                     "bounds": pair.bounds, "bounds_of_b": pair.bounds_of_b, "sum_of_overlaps": pair.overlaps})
    with open(os.path.join(options.folder, "pairs.json"), "w", encoding="ascii") as file:
        json.dump(told, file, indent=1)


if __name__ == "__main__":
    main()
