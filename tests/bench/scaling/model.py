# SPDX-License-Identifier: Apache-2.0
"""What a step costs on many ranks, from the geometry of parts and of contact: messages and bytes a rank, time, efficiency.

A part of N/p elements is a cube where the body allows it, else a plate or a rod. Lengths are in elements, areas in faces or nodes.
"""
import itertools
import math
import os
from typing import NamedTuple

import yaml

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "model.yaml"), encoding="utf-8") as stream:
    CONSTANTS = yaml.safe_load(stream)
PARTITION, MESSAGES, CONTACT, TIME, NETWORK = (CONSTANTS[name] for name in ("partition", "messages", "contact", "time", "network"))


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


def few(parts, of_two):
    """1 from 4 parts on: a body in two has no cubes, and its cut and neighbours are by `of_two` more than of cubes."""
    return 1 + of_two * min(1.0, max(0.0, (4 - parts) / 2))


def around(scene, direction):
    return scene.thickness > 0 and direction == 1


def odd_slices(scene, volume):
    """Faces cut off the corners of bodies that hold no whole number of parts: each such corner lies in two bodies' balance."""
    rest = [abs(q - round(q)) for q in (math.prod(n) / volume for n in scene.bodies)]
    return 0.5 * sum(3 * g ** (2 / 3) * volume ** (2 / 3) for g in rest) if len(scene.bodies) > 1 else 0.0


def internal(scene, ranks):
    """(corner forces sent by all ranks, neighbours of a rank in the mean) of the elements."""
    volume = scene.elements / ranks
    if ranks == 1:
        return 0.0, 0.0
    if max(math.prod(n) for n in scene.bodies) < 1.5 * volume:  # bodies stay whole but for one cut where each part ends
        plane = (scene.elements / len(scene.bodies)) ** (2 / 3)
        return 8 * plane * (ranks - 1), 2 * (ranks - 1) / ranks
    forces, neighbours = 8 * odd_slices(scene, volume), 0.0
    for n in scene.bodies:
        cuts, parts = divisions(n, volume), math.prod(n) / volume
        planes = [k if around(scene, d) and k > 1 else k - 1 for d, k in enumerate(cuts)]
        forces += 8 * PARTITION["excess"] * few(parts, PARTITION["excess_of_two"]) * (math.prod(a + k for a, k in zip(n, planes)) - math.prod(n))
        beside = few(parts, PARTITION["neighbours_of_two"])
        neighbours += parts * beside * (math.prod(1 + PARTITION["neighbours"] * k / cut for k, cut in zip(planes, cuts)) - 1)
    corner = 2 * min(3.0, ranks / len(scene.bodies)) if len(scene.bodies) > 1 else 0.0  # pairs of parts at a corner cut off
    neighbours = (neighbours + corner) / ranks
    if scene.balanced:
        return forces * PARTITION["contact_excess"], min(ranks - 1, neighbours * PARTITION["contact_neighbours"])
    return forces, min(ranks - 1, neighbours)


def ghosting(scene, ranks):
    """(nodes of others that a rank copies, ranks that it meets) in contact."""
    if not scene.sides or ranks == 1:
        return 0.0, 0.0
    area = sum(a * b for a, b in scene.sides) / ranks  # nodes of a rank
    face = math.sqrt(sum(a * b for a, b in scene.sides) / len(scene.sides))
    patch = min(face, math.sqrt(scene.elements / ranks / scene.thickness if scene.thickness else area))
    reach = patch + 2 * CONTACT["rim"]
    held = len(scene.bodies) / ranks
    foreign = 1 - max(0.0, (held - 1) / max(len(scene.bodies) - 1, 1))  # whole bodies of one rank meet without messages
    patches = area / patch ** 2
    covered = CONTACT["ranks_met"] * patches * (reach / patch + 1) ** 2
    return foreign * patches * reach ** 2, (ranks - 1) * (1 - math.exp(-covered / (ranks - 1)))


class Counts(NamedTuple):
    messages: float
    bytes: float
    collectives: float


def counts(scene, ranks):
    """Sent by a rank in a step, mean over the ranks; exchanges of the search are in it."""
    forces, neighbours = internal(scene, ranks)
    work, m = scene.work, MESSAGES
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
    return {"elements": TIME["element"] * scene.elements / ranks,
            "contact": (TIME["row"] * work.rows * work.iterations + TIME["face"] * scene.faces * work.searches) / ranks,
            "messages": (NETWORK["latency"] * sent.messages + sent.bytes / NETWORK["bandwidth"]) if ranks > 1 else 0.0,
            "reductions": NETWORK["reduction"] * math.log2(ranks) * sent.collectives}


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
    side = (CONTACT["tube_share"] * turn / 2, along + 1)
    return Scene([(through, turn, along)], [side, side], False, work, through)
