#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Nothing passes in implicit scenes, however long the steps: seeded boxes that are thrown at each other, plates among them, with steps of
a tenth of an element's motion to ten elements, and boxes that supports push into each other in statics. A run ends with a message (exit
code 3), or the bodies are still on the sides on which they began: by the positions of their middles. Needs BRUNT and BRUNT_RUN
(scripts/run) in the environment. --variants N: scenes of each kind."""
import random
import unittest

import numpy

from run_test import variants_asked
from scene_program import SceneProgram

VARIANTS = 3
SCENE = """units: none
mesh:
{boxes}
materials: {{m: {{model: neo_hookean, density: 1000, young: 1.0e7, poisson: 0.3}}}}
parts: {{a: {{material: m, element: hex8_full}}, b: {{material: m, element: hex8_full}}}}
{motion}
contact: [{{between: [{pair}], method: mortar}}]
probes: [{{name: a, part: a, field: center}}, {{name: b, part: b, field: center}}]
solver: {{scheme: {scheme}, step: {step:.9g}}}
run: {{end: {end:.9g}}}
history: {{every: {step:.9g}}}
"""
BOX = "- {{box: {{part: {}, size: {}, elements: {}, at: {}}}}}"


def thrown(seed, scheme):
    """The scene, and the axis along which a meets b, which lies at larger coordinates."""
    rng = random.Random(seed)
    axis = rng.randrange(3)
    sizes = [[rng.uniform(0.3, 1) for _ in range(3)] for _ in range(2)]
    for size in sizes:
        if rng.random() < 0.4:
            size[axis] *= 0.1  # a plate
    counts = [[rng.randint(1, 3) for _ in range(3)] for _ in range(2)]
    gap = rng.uniform(0, 2) * sizes[0][axis]
    at = [-0.5 * x for x in sizes[0]], [-0.5 * x for x in sizes[1]]
    for c in range(3):
        if c != axis:
            at[1][c] += rng.uniform(-0.3, 0.3) * sizes[1][c]
    at[1][axis] = at[0][axis] + sizes[0][axis] + gap
    boxes = [BOX.format(part, sizes[k], counts[k], at[k]) for k, part in enumerate("ab")]
    rng.shuffle(boxes)
    element = min(sizes[k][axis] / counts[k][axis] for k in (0, 1))
    path = gap + 1.5 * sizes[1][axis] + sizes[0][axis]  # beyond b, were it not there
    step = 10 ** rng.uniform(-1, 1) * element  # of the path
    speed = 10 ** rng.uniform(0, 1.7)
    unit = [float(c == axis) for c in range(3)]
    if scheme == "static":
        motion = (f"fixed: [{{set: b_{'xyz'[axis]}max, dofs: [x, y, z]}}, {{set: a_{'xyz'[axis]}min, dofs: [{', '.join(c for c in 'xyz' if c != 'xyz'[axis])}]}}]\n"
                  f"curves: {{push: [[0, 0], [1, {path:.9g}]]}}\nprescribed: [{{set: a_{'xyz'[axis]}min, dof: {'xyz'[axis]}, displacement: push}}]")
        time = 1 / path
    else:
        motion = f"initial: [{{part: a, velocity: {[speed * u for u in unit]}}}]"
        time = 1 / speed
    pair = ", ".join(rng.sample("ab", 2))
    return SCENE.format(boxes="\n".join(boxes), motion=motion, pair=pair, scheme=scheme, step=step * time, end=max(path, 2 * step) * time), axis


SINKS = """\
units: SI
mesh:
  - {sphere: {part: ball, radius: 0.05, elements: 4, at: [0.02, 0.01, 0.06]}}
  - {box: {part: plate, size: [0.3, 0.3, THICK], elements: [1, 4, 1], at: [-0.15, -0.15, -THICK]}}
materials: {rub: {model: neo_hookean, density: 1100, young: 5.0e6, poisson: 0.3}, rig: {model: rigid, density: 2000}}
parts: {ball: {material: rig}, plate: {material: rub, element: hex8_full}}
fixed: [{part: plate, dofs: [x, y, z]}]
initial: [{part: ball, velocity: [0, 0, -1]}]
contact: [{between: [ball, plate], method: mortar}]
probes: [{name: tip, near: [0.02, 0.01, 0.01], field: position}]
history: {every: 1.0e-6}
run: {end: 0.05}
solver: {scheme: contact_implicit, step: STEP}
"""


class ImplicitPasses(SceneProgram):
    def stays_or_stops(self, scheme):
        stopped = 0
        for seed in range(1, VARIANTS + 1):
            with self.subTest(seed=seed, scheme=scheme):
                text, axis = thrown(seed, scheme)
                self.write("scene.yaml", text)
                told = self.run_scene(1, "scene.yaml", "--out", "out", "--force", code=(0, 3))
                if "stopped" in told:
                    stopped += 1
                    continue
                for row in self.rows("out"):
                    name = "xyz"[axis]
                    self.assertGreater(row[f"b.{name}"] - row[f"a.{name}"], 0, row["time"])
        return stopped

    def test_thrown_bodies_do_not_pass(self):
        stopped = self.stays_or_stops("contact_implicit")
        self.assertLessEqual(stopped, 0.2 * VARIANTS)

    def test_a_wall_does_not_blind_the_watch(self):
        text, axis = thrown(13, "contact_implicit")  # flew through without the watch
        self.write("scene.yaml", text + "rigid_walls: [{name: far, point: [0, 0, -50], normal: [0, 0, 1]}]\n")
        self.run_scene(1, "scene.yaml", "--out", "out", "--force", code=(0, 3))
        for row in self.rows("out"):
            self.assertGreater(row[f"b.{'xyz'[axis]}"] - row[f"a.{'xyz'[axis]}"], 0, row["time"])

    def test_what_a_coarse_slave_lets_in_is_told_by_positions(self):
        """Mean gaps over the facets of a coarse held plate stay open while a ball sinks into it."""
        for ranks in (1, 2):
            rows = self.go(SINKS.replace("THICK", "0.04").replace("STEP", "1.0e-3"), ranks=ranks)
            depth = max(-row["tip.z"] for row in rows)
            told = self.summary("out")["deepest_penetration"]
            self.assertGreater(depth, 0.1 * 0.04)
            self.assertAlmostEqual(told["depth"], depth, delta=0.02 * depth)
            self.assertAlmostEqual(told["elements"], told["depth"] / 0.04, delta=1e-6)
            self.assertRegex(self.text("out", "log.txt"), "contact leaves penetration: node .* of part 'ball' .* in part 'plate'.*a coarse slave lets")
            self.write("scene.yaml", SINKS.replace("THICK", "0.012").replace("STEP", "2.0e-4"))  # right through, node by node
            self.run_scene(ranks, "scene.yaml", "--out", "out", "--force", code=(0, 3))
            self.assertGreater(self.summary("out")["deepest_penetration"]["elements"], 0.4)
            self.assertIn("contact leaves penetration: ", self.text("out", "log.txt"))

    def test_pushed_bodies_do_not_pass(self):
        self.stays_or_stops("static")


if __name__ == "__main__":
    VARIANTS = variants_asked(VARIANTS)
    unittest.main()
