# SPDX-License-Identifier: Apache-2.0
"""What a step costs on many ranks, from the geometry of parts and of contact: messages and bytes a rank, time, efficiency.

A part of N/p elements is a cube where the body allows it, else a plate or a rod. Lengths are in elements, areas in faces or nodes.
"""
import itertools
import math
import os
from typing import NamedTuple

import yaml

CONSTANTS = {}


def reload():
    """Reads model.yaml, at import and once a measurement has changed it."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "model.yaml"), encoding="utf-8") as stream:
        CONSTANTS.update(yaml.safe_load(stream))


reload()


def of(section):
    return CONSTANTS[section]


class Work(NamedTuple):
    """What a scene asks for a step, whatever the ranks: from a run on one rank."""
    iterations: float = 0  # of contact, a step
    searches: float = 0  # a step
    rows: float = 0  # that act


class Scene(NamedTuple):
    bodies: list  # (n1, n2, n3) elements each
    sides: list  # (nodes along, nodes across) of each side of each surface in contact
    balanced: bool  # are faces in contact balanced beside the elements?
    work: Work
    thickness: int = 0  # of a thin body that closes on itself around (tube): elements through; the second extent is around

    @property
    def elements(self):
        return sum(math.prod(n) for n in self.bodies)

    @property
    def faces(self):
        """On the outside of the bodies."""
        return sum(2 * (a * b + b * c + c * a) for a, b, c in self.bodies)


def divisions(extents, volume):
    """Into how many parts of that volume each direction of a box is cut: cubes, flat ones where the box is thin."""
    thin, thick = [], sorted(extents)
    while thick and thick[0] ** len(thick) * math.prod(thin) < volume:
        thin.append(thick.pop(0))
    edge = (volume / math.prod(thin)) ** (1 / len(thick)) if thick else 1.0
    return [max(1.0, n / edge) if n in thick else 1.0 for n in extents]


def few_neighbours(extents, parts):
    """Mean neighbours of a box in 2 to 4 parts: slabs, or quarters where these cut less, or the mean of both where they cut alike.
    Quarters do not all meet along a line."""
    longest, second, _ = sorted(extents, reverse=True)
    slabs, quarters = 2 * (parts - 1) / parts, of("partition")["quarters"]
    ratio = (1 / longest + 1 / second) / (3 / longest)  # of what quarters cut to what slabs do
    if parts < 4 or ratio > 1.1:
        return slabs
    return quarters if ratio < 1 / 1.1 else 0.5 * (slabs + quarters)


def around(scene, direction):
    return scene.thickness > 0 and direction == 1


def cut_forces(scene, extents, volume):
    """Corner forces that the parts of one body send."""
    slabs = round(math.prod(extents) / volume)
    if slabs in (2, 3) and not scene.thickness:
        return 8 * of("partition")["excess_of_slabs"] * (slabs - 1) * math.prod(extents) / max(extents)
    planes = [k if around(scene, d) and k > 1 else k - 1 for d, k in enumerate(divisions(extents, volume))]
    return 8 * of("partition")["excess"] * (math.prod(n + k for n, k in zip(extents, planes)) - math.prod(extents))


def neighbours_of_part(scene, extents, volume):
    parts = round(math.prod(extents) / volume)
    if 2 <= parts <= 4 and not scene.thickness:
        return few_neighbours(extents, parts)
    cuts = divisions(extents, volume)
    shares = [1.0 if around(scene, d) and k > 1 else 1 - 1 / k for d, k in enumerate(cuts)]
    return math.prod(1 + of("partition")["neighbours"] * share for share in shares) - 1


def odd_corners(scene, volume):
    """(faces, pairs of parts in both directions) of corners cut off bodies that hold no whole number of parts; of two bodies the
    corner of one goes to a part of the other. Less than METIS may leave uneven is nothing."""
    parts = [math.prod(n) / volume for n in scene.bodies]
    rest = [abs(q - round(q)) for q in parts]
    if len(parts) == 1 or max(r / q for r, q in zip(rest, parts)) < of("partition")["uneven"]:
        return 0.0, 0.0
    return 0.5 * sum(3 * r ** (2 / 3) * volume ** (2 / 3) for r in rest), 2 * min(3.0, sum(parts) / len(parts))


def internal(scene, ranks):
    """(corner forces sent by all ranks, neighbours of a rank in the mean) of the elements."""
    volume = scene.elements / ranks
    if ranks == 1:
        return 0.0, 0.0
    if max(math.prod(n) for n in scene.bodies) < 1.5 * volume:  # bodies stay whole but for one cut where each part ends
        plane = (scene.elements / len(scene.bodies)) ** (2 / 3)
        return 8 * plane * (ranks - 1), 2 * (ranks - 1) / ranks
    faces, pairs = odd_corners(scene, volume)
    forces = 8 * faces + sum(cut_forces(scene, n, volume) for n in scene.bodies)
    neighbours = (pairs + sum(math.prod(n) / volume * neighbours_of_part(scene, n, volume) for n in scene.bodies)) / ranks
    if scene.balanced:
        forces, neighbours = forces * of("partition")["contact_excess"], neighbours * of("partition")["contact_neighbours"]
    return forces, min(ranks - 1, neighbours)


def ghosting(scene, ranks):
    """(nodes of others that a rank copies, ranks that it meets) in contact."""
    if not scene.sides or ranks == 1:
        return 0.0, 0.0
    area = sum(a * b for a, b in scene.sides) / ranks  # nodes of a rank
    face = math.sqrt(sum(a * b for a, b in scene.sides) / len(scene.sides))
    volume = scene.elements / ranks
    patch = min(face, math.sqrt(volume / scene.thickness)) if scene.thickness else min(face, math.sqrt(area), volume ** (1 / 3))
    reach = patch + 2 * of("contact")["rim"]
    held = len(scene.bodies) / ranks
    foreign = 1 - max(0.0, (held - 1) / max(len(scene.bodies) - 1, 1))  # whole bodies of one rank meet without messages
    patches = area / patch ** 2
    covered = of("contact")["ranks_met"] * patches * (reach / patch + 1) ** 2
    return foreign * patches * reach ** 2, (ranks - 1) * (1 - math.exp(-covered / (ranks - 1)))


class Counts(NamedTuple):
    messages: float
    bytes: float
    collectives: float


def counts(scene, ranks):
    """Sent by a rank in a step, mean over the ranks; exchanges of the search are in it."""
    if ranks == 1:
        return Counts(0, 0, 0)
    forces, neighbours = internal(scene, ranks)
    work, m = scene.work, of("messages")
    if not scene.sides:
        return Counts(neighbours, m["corner_force"] * forces / ranks, 1)
    copies, met = ghosting(scene, ranks)
    exchanges = m["exchanges"] + m["exchanges_per_iteration"] * work.iterations + m["search_exchanges"] * work.searches
    of_copy = m["copy"] + m["copy_per_iteration"] * work.iterations + m["search_copy"] * work.searches
    return Counts(neighbours + met * exchanges, m["corner_force"] * forces / ranks + copies * of_copy,
                  m["collectives"] + m["collectives_per_iteration"] * work.iterations + m["search_collectives"] * work.searches)


def step_time(scene, ranks):
    """{part of the step: seconds} on so many ranks."""
    sent, work = counts(scene, ranks), scene.work
    return {"elements": of("time")["element"] * scene.elements / ranks,
            "contact": (of("time")["row"] * work.rows * work.iterations + of("time")["face"] * scene.faces * work.searches) / ranks,
            "messages": of("network")["latency"] * sent.messages,
            "bytes": sent.bytes / of("network")["bandwidth"],
            "reductions": of("network")["reduction"] * math.log2(ranks) * sent.collectives}


def box_scene(tree, work, with_contact=True):
    """The scene of a YAML tree whose bodies are boxes in the axes: sides in contact are where faces of two boxes lie together."""
    boxes = [entry["box"] for entry in tree["mesh"]]
    sides = []
    for a, b in itertools.permutations(boxes, 2) if with_contact else ():
        low, high = corners(a)
        other_low, other_high = corners(b)
        for d in range(3):
            if abs(high[d] - other_low[d]) > 1e-9 and abs(low[d] - other_high[d]) > 1e-9:
                continue
            overlap = [min(high[k], other_high[k]) - max(low[k], other_low[k]) for k in range(3) if k != d]
            if min(overlap) <= 1e-9:
                continue
            per_length = [a["elements"][k] / (high[k] - low[k]) for k in range(3) if k != d]
            sides.append(tuple(length * density + 1 for length, density in zip(overlap, per_length)))
    return Scene([tuple(box["elements"]) for box in boxes], sides, with_contact and len(boxes) == 2, work)


def corners(box):
    low = [float(x) for x in box.get("at", (0, 0, 0))]
    return low, [x + float(size) for x, size in zip(low, box["size"])]


def tube_scene(tree, work):
    """The tube that is pressed flat: its inside touches itself over a share of its circumference."""
    through, turn, along = tree["mesh"]["tube"]["elements"]
    side = (of("contact")["tube_share"] * turn / 2, along + 1)
    return Scene([(through, turn, along)], [side, side], False, work, through)
