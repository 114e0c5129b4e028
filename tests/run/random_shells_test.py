#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Random free shells that are struck: momentum, angular momentum and energy are kept to rounding, on one rank and on three with the same bits;
a run that cannot go on says so. --count N --seed S. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import math
import random
import sys
import unittest

from scene_program import SceneProgram

COUNT, SEED = 4, 1
LAWS = ("{model: elastic, density: 1, young: 1000, poisson: %(nu).3f}",
        "{model: j2, density: 1, young: 1000, poisson: %(nu).3f, yield: %(y).3f, hardening: %(h).3f}",
        "{model: j2, density: 1, young: 1000, poisson: %(nu).3f, hardening_table: [[0, %(y).3f], [0.1, %(z).3f]], kinematic: 0.5}",
        "{model: johnson_cook, density: 1, young: 1000, poisson: %(nu).3f, A: %(y).3f, B: %(h).3f, n: 0.4, C: 0.01, rate: 1.0, m: 1,"
        " melt: 1000, room: 300, heat_capacity: 100}")


def body(draw):
    """A generated body of shells, and node sets of it."""
    place = "rotate: {axis: [%.2f, %.2f, %.2f], degrees: %.1f}" % (*[draw.uniform(-1, 1) for _ in range(3)], draw.uniform(0, 180))
    n, m = draw.randint(1, 9), draw.randint(1, 9)
    kind = draw.choice(("plate", "tube", "box", "sphere"))
    if kind == "plate":
        return f"plate: {{part: p, size: [{draw.uniform(.3, 2):.2f}, 1], elements: [{n}, {m}], shell: true, {place}}}", ("p_xmin", "p_ymax")
    if kind == "tube":
        return (f"tube: {{part: p, inner_radius: .4, outer_radius: .5, length: {draw.uniform(.3, 2):.2f}, elements: [1, {n + 3}, {m}], "
                f"shell: true, {place}}}", ("p_top", "p_bottom"))
    if kind == "box":
        opened = draw.choice(("", ", open: [zmax]", ", open: [xmin, zmax]"))
        return (f"box: {{part: p, size: [1, {draw.uniform(.5, 1.5):.2f}, 1], elements: [{draw.randint(1, 5)}, {draw.randint(1, 5)}, "
                f"{draw.randint(1, 5)}], shell: true{opened}, {place}}}", ("p_ymin", "p_zmin"))
    return f"sphere: {{part: p, radius: .6, elements: {draw.randint(2, 4)}, shell: true, {place}}}", ("p", "p")


def scene(draw):
    mesh, sets = body(draw)
    values = {"nu": draw.choice((0, 0.3, 0.45)), "y": draw.uniform(2, 30), "h": draw.uniform(0, 100), "z": draw.uniform(31, 60)}
    points = draw.randint(2, 7)
    speed = [draw.uniform(-3, 3) for _ in range(3)]
    hourglass = draw.choice(("stiffness", "elastic", "viscous"))
    element = draw.choice(("shell4", "shell4_full", "shell3"))
    warping = draw.choice(("true", "true", "false"))
    extra = f", hourglass: {{kind: {hourglass}}}, warping: {warping}" if element == "shell4" else ""
    return f"""units: none
mesh: [{{{mesh}}}]
materials: {{m: {draw.choice(LAWS) % values}}}
parts: {{p: {{material: m, element: {element}, thickness: {10**draw.uniform(-2.5, -0.8):.4f}, points: {points}, rule: {draw.choice(("gauss", "lobatto"))},
  offset: {draw.choice((0, 0, 0.5, -0.3))}, thinning: {draw.choice(("true", "false"))}{extra}}}}}
initial: [{{part: p, rotation: {{axis: [{speed[1]:.2f}, 1, {speed[0]:.2f}], rate: {draw.uniform(0, 4):.2f}}}}},
          {{set: {sets[0]}, velocity: [{speed[0]:.2f}, {speed[1]:.2f}, {speed[2]:.2f}]}}, {{set: {sets[1]}, velocity: [0, {speed[2]:.2f}, 0]}}]
probes: [{{name: l, part: p, field: angular_momentum}}]
run: {{steps: 300}}
history: {{every: 0.01}}
"""


class RandomShells(SceneProgram):
    def judge(self, rows):
        size = lambda row: math.sqrt(sum(row[f"l.{c}"]**2 for c in "xyz"))  # noqa: E731
        drift = max(math.sqrt(sum((row[f"l.{c}"] - rows[0][f"l.{c}"])**2 for c in "xyz")) for row in rows)
        scale = max(size(rows[0]), 0.1 * math.sqrt(2 * rows[0]["kinetic"] * rows[0]["mass"]))
        self.assertLess(drift, 1e-10 * scale)
        summary = self.summary("out")
        self.assertLess(summary["momentum_error"], 1e-12)
        self.assertLess(summary["energy"]["error_ratio"], 1e-10)
        self.assertLess(max(row["kinetic"] for row in rows), rows[0]["kinetic"] * (1 + 1e-9))
        return summary["state_hash"]

    def test_random_shells(self):
        for seed in range(SEED, SEED + COUNT):
            text = scene(random.Random(seed))
            with self.subTest(seed=seed, scene=text):
                self.write("scene.yaml", text)
                told = self.run_scene(1, "scene.yaml", "--out", "out", "--force", code=(0, 3))
                if "300 steps" not in told and self.summary("out")["exit_code"] != 0:
                    print(f"seed {seed} stops: {told.strip().splitlines()[-1][:160]}")
                    continue
                found = self.judge(self.rows("out"))
                self.run_scene(3, "scene.yaml", "--out", "three", "--force")
                self.assertEqual(self.summary("three")["state_hash"], found)


if __name__ == "__main__":
    for flag in ("--count", "--seed"):
        if flag in sys.argv:
            at = sys.argv.index(flag)
            COUNT, SEED = (int(sys.argv[at + 1]), SEED) if flag == "--count" else (COUNT, int(sys.argv[at + 1]))
            del sys.argv[at:at + 2]
    unittest.main()
