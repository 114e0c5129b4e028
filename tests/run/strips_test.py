#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Edges whose two ends lie on two bodies and cross the rims of others, where no node is near. A plate lies on two strips, and
a third one lifts it at its middle: it rises with that strip. A block slides without friction over the seams of plates that
are flush: it keeps its speed. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment. --all: three hundred scenes."""
import math
import random
import sys
import unittest

from run_test import Program, of_all

SCENE = """units: none
mesh:
{boxes}
materials: {{m: {{model: rigid, density: 1}}}}
parts: {{plate: {{material: m}}, left: {{material: m}}, right: {{material: m}}, middle: {{material: m}}}}
fixed: [{{part: left, dofs: [x, y, z, rx, ry, rz]}}, {{part: right, dofs: [x, y, z, rx, ry, rz]}}]
gravity: {{vector: [0, 0, -10]}}
prescribed: [{{part: middle, dof: z, velocity: {speed}}}]
contact: [{{between: all, friction: 0.3}}]
probes: [{{name: plate, part: plate, field: displacement}}]
run: {{end: 0.2, step: 1.0e-3}}
history: {{every: 0.01}}
"""
BOX = "  - {{box: {{part: {part}, size: [{size[0]:.6g}, {size[1]:.6g}, {size[2]:.6g}], elements: {elements}, at: [{at[0]:.6g}, {at[1]:.6g}, {at[2]:.6g}]{turn}}}}}"
SPEED, END = 0.5, 0.2


def box(part, size, middle, elements, degrees=0):
    """A box around `middle`, turned about z there."""
    angle = math.radians(degrees)
    half = [0.5 * s for s in size]
    at = [middle[0] - math.cos(angle) * half[0] + math.sin(angle) * half[1],
          middle[1] - math.sin(angle) * half[0] - math.cos(angle) * half[1], middle[2] - half[2]]
    turn = f", rotate: {{axis: [0, 0, 1], degrees: {degrees:.6g}}}" if degrees else ""
    return BOX.format(part=part, size=size, at=at, elements=elements, turn=turn)


def scene(seed):
    """The text, and how high the plate rises."""
    rng = random.Random(seed)
    length, width, thick = rng.uniform(2, 4), rng.uniform(0.3, 0.8), rng.uniform(0.02, 0.1)
    clearance = rng.uniform(0, 0.3) * thick
    boxes = [box("plate", (length, width, thick), (0, 0, 0.5 * thick), [rng.randint(1, 2), 1, 1]),
             box("left", (0.4, 2 * width, thick), (-0.5 * length, 0, -0.5 * thick), [rng.randint(1, 2), 1, 1]),
             box("right", (0.4, 2 * width, thick), (0.5 * length, 0, -0.5 * thick), [rng.randint(1, 2), 1, 1]),
             box("middle", (0.2 * length, rng.uniform(1, 12), thick), (0, 0, -0.5 * thick - clearance),
                 [1, 1, 1], rng.uniform(-35, 35))]
    rng.shuffle(boxes)
    return SCENE.format(boxes="\n".join(boxes), speed=SPEED), SPEED * END - clearance, thick


class Strips(Program):
    seeds = range(1, of_all(11, 6))

    def test_the_plate_rises_with_the_strip_under_its_middle(self):
        for seed in self.seeds:
            with self.subTest(seed=seed):
                text, height, thick = scene(seed)
                self.write("scene.yaml", text)
                self.run_scene(1, "scene.yaml", "--out", "out", "--force")
                rises = self.history("out")[-1]["plate.z"]
                self.assertLess(abs(rises - height), 0.01 * thick, f"{rises} for {height}")

    def test_the_number_of_ranks_changes_no_bit(self):
        self.write("scene.yaml", scene(1)[0])
        found = set()
        for ranks in of_all((1, 2, 3, 4), (1, 3)):
            self.run_scene(ranks, "scene.yaml", "--out", "out", "--force")
            found.add(self.summary("out")["state_hash"])
        self.assertEqual(len(found), 1)


def floor(seed):
    """A block on a floor of tiles, some of them free to be pushed away were there no friction to the ground."""
    rng = random.Random(seed)
    size, gravity = rng.uniform(0.25, 1.2), 10 ** rng.uniform(0, 2)
    yaw = rng.choice([-1, 1]) * rng.uniform(12, 20) if rng.random() < 0.7 else rng.uniform(-45, 45)
    tiles = [(i, j) for i in range(math.ceil(2.4 / size)) for j in range(math.ceil(2 / size))]
    boxes = [box(f"t{i}_{j}", (size, size, 0.3), (size * (i + 0.5) - 0.6, size * (j + 0.5) - 1, -0.15), [1, 1, 1])
             for i, j in tiles]
    boxes.append(box("block", (0.4, rng.uniform(0.3, 0.6), 0.12), (0, 0, 0.06), [rng.randint(1, 3), 1, 1], yaw))
    rng.shuffle(boxes)
    parts = [f"t{i}_{j}" for i, j in tiles]
    return f"""units: none
mesh:
{chr(10).join(boxes)}
materials: {{r: {{model: rigid, density: 1}}}}
parts: {{{", ".join(f"{part}: {{material: r}}" for part in [*parts, "block"])}}}
fixed: [{", ".join(f"{{part: {part}, dofs: [x, y, z, rx, ry, rz]}}" for part in parts)}]
initial: [{{part: block, velocity: [1, 0, 0]}}]
gravity: {{vector: [0, 0, -{gravity:.6g}]}}
contact: [{{between: all}}]
probes: [{{name: block, part: block, field: velocity}}]
run: {{end: 0.9, step: 1.0e-3}}
"""


class Floors(Program):
    seeds = of_all([*range(1, 11), 12, 17, 18], [1, 2, 3, 12, 17, 18])

    def test_the_block_keeps_its_speed(self):
        for seed in self.seeds:
            with self.subTest(seed=seed):
                self.write("scene.yaml", floor(seed))
                self.run_scene(1, "scene.yaml", "--out", "out", "--force")
                last = self.history("out")[-1]
                self.assertLess(abs(last["block.x"] - 1) + abs(last["block.y"]) + abs(last["block.z"]), 1e-3)


class AllStrips(Strips):
    seeds = range(1, 301)


class AllFloors(Floors):
    seeds = range(1, 301)


if __name__ == "__main__":
    if "--all" in sys.argv:
        sys.argv.remove("--all")
    else:
        del AllStrips, AllFloors
    unittest.main()
