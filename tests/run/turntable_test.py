#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A rigid box on a turning table, held by friction alone, close to its limit: the load is shared unequally among the nodes, and
some of them reach their limits. The box stays at its place. A step moves it off its circle by (w dt)^2 r / 2, of which a
twentieth is recovered in each step: 10 (w dt)^2 r remain. Beyond the limit it slides outwards. Needs BRUNT and BRUNT_RUN
(scripts/run) in the environment. --variants N: boxes."""
import math
import random
import unittest

from run_test import Program, variants_asked

VARIANTS = 3
SCENE = """units: none
mesh:
{boxes}
materials: {{m: {{model: rigid, density: 1}}}}
parts: {{table: {{material: m}}, box: {{material: m}}}}
fixed: [{{part: table, dofs: [x, y, z, rx, ry]}}]
prescribed: [{{part: table, dof: rz, velocity: {rate:.17g}}}]
initial: [{{part: box, rotation: {{axis: [0, 0, 1], point: [0, 0, 0], rate: {rate:.17g}}}}}]
gravity: {{vector: [0, 0, -{gravity:.17g}]}}
contact: [{{between: all, friction: {friction:.17g}}}]
probes: [{{name: box, part: box, field: center}}]
run: {{end: {end:.17g}, step: {step:.17g}}}
history: {{every: {end:.17g}}}
"""
BOX = "- {{box: {{part: {}, size: {}, elements: {}, at: {}}}}}"


def turntable(seed, share):
    """The scene of one turn, the radius, and what remains of a step's way off the circle. share: of the limit."""
    rng = random.Random(seed)
    radius, friction, gravity = rng.uniform(0.5, 1.6), rng.uniform(0.2, 0.9), 10 ** rng.uniform(0, 2)
    rate = math.sqrt(share * friction * gravity / radius)
    step = 10 ** rng.uniform(-2.5, -1.7) / rate
    size = [rng.uniform(0.1, 0.4), rng.uniform(0.1, 0.4), rng.uniform(0.02, 0.1)]
    boxes = [BOX.format("table", [4, 4, 0.4], [rng.randint(1, 3), rng.randint(1, 3), 1], [-2, -2, -0.4]),
             BOX.format("box", size, [rng.randint(1, 3), rng.randint(1, 3), 1], [radius - size[0] / 2, -size[1] / 2, 0])]
    rng.shuffle(boxes)
    text = SCENE.format(boxes="\n".join(boxes), rate=rate, gravity=gravity, friction=friction, step=step, end=2 * math.pi / rate)
    return text, radius, 10 * (rate * step) ** 2 * radius


class Turntable(Program):
    def off(self, text, radius):
        self.write("scene.yaml", text)
        self.run_scene(1, "scene.yaml", "--out", "out", "--force")
        last = self.history("out")[-1]
        return math.hypot(last["box.x"], last["box.y"]) - radius

    def test_a_box_below_its_limit_stays(self):
        for seed in range(1, VARIANTS + 1):
            for share in (0.5, 0.8, 0.95):
                with self.subTest(seed=seed, share=share):
                    text, radius, remains = turntable(seed, share)
                    self.assertLess(abs(self.off(text, radius)), 1.2 * remains)

    def test_a_box_beyond_its_limit_slides_outwards(self):
        for seed in range(1, VARIANTS + 1):
            with self.subTest(seed=seed):
                text, radius, _ = turntable(seed, 1.1)
                self.assertGreater(self.off(text, radius), 0.1 * radius)


if __name__ == "__main__":
    VARIANTS = variants_asked(VARIANTS)
    unittest.main()
