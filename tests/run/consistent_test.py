#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""consistent: true in mortar contact: frictionless statics takes no energy from curved surfaces. Seeded half cylinders that slide over each
other and back (radii, offsets, turned planes, meshes, either slave, a rigid one), ranks. Judged by what the program does not compute: the
path integral of the reaction at the driven nodes, and the net work of a closed path. Needs BRUNT and BRUNT_RUN (scripts/run) in the
environment. --variants N: scenes."""
import math
import random
import re
import unittest

from run_test import of_all, variants_asked
from scene_program import SceneProgram

VARIANTS = 2
WIDE = "guards: {energy_warning: 10, energy_stop: 10}\n"  # false energies are judged by the tests
SCENE = """\
units: none
mesh:
  - {{tube: {{part: nose, inner_radius: {i1:.6g}, outer_radius: {r1:.6g}, length: 0.25, elements: [2, {n1}, 1], half: [-y], rotate: {{axis: [1, 0, 0], degrees: 90}}, at: [{x1:.6g}, 0.25, {z1:.6g}]}}}}
  - {{tube: {{part: bump, inner_radius: {i2:.6g}, outer_radius: {r2:.6g}, length: 0.4, elements: [2, {n2}, 1], half: [y], rotate: {{axis: [1, 0, 0], degrees: 90}}, at: [{x2:.6g}, 0.325, {z2:.6g}]}}}}
materials:
  p: {{model: neo_hookean, density: 1, young: 1000, poisson: 0}}
  r: {{model: rigid, density: 1}}
parts: {{nose: {{material: p, element: hex8_full}}, bump: {{material: {bump}}}}}
fixed: [{{{held}}}, {{set: nose_ymax, dofs: [z]}}]
symmetry: [{{point: [0, 0, 0], normal: [0, 1, 0]}}, {{point: [0, 0.25, 0], normal: [0, 1, 0]}}]
curves: {{push: {push}}}
prescribed: [{{set: nose_ymax, dof: x, displacement: push}}]
contact: [{{between: [nose, bump], method: mortar{more}}}]
probes: [{{name: top, set: nose_ymax, field: reaction}}]
solver: {{scheme: static, step: {step:.9g}}}
run: {{end: 1}}
"""


def sliding(seed):
    """Numbers of a scene: a nose that slides past the top of a bump, from where they first touch."""
    rng = random.Random(seed)
    r1, r2 = rng.uniform(0.4, 0.6), rng.uniform(0.4, 0.6)
    pressed = rng.uniform(0.06, 0.12) * (r1 + r2)
    height = r1 + r2 - pressed
    start = math.sqrt((r1 + r2) ** 2 - height ** 2) + 0.06
    rigid = rng.random() < 0.5
    return {"r1": r1, "r2": r2, "i1": 0.6 * r1, "i2": 0.6 * r2, "n1": rng.choice([20, 24, 28]), "n2": rng.choice([24, 28, 36]), "x1": 10 - start, "x2": 10 + rng.uniform(-0.02, 0.02),
            "z1": 0.5 * height, "z2": -0.5 * height, "bump": "r" if rigid else "p, element: hex8_full",
            "held": "part: bump, dofs: [x, y, z, rx, ry, rz]" if rigid else "set: bump_ymin, dofs: [x, y, z]",
            "path": rng.uniform(0.8, 1.2) * start, "slave": "nose" if rigid else rng.choice(["nose", "bump"])}


def scene_of(of, steps, more="", back=False):
    """back: there and back again in the same steps."""
    push = [[0, 0], [0.5, of["path"]], [1, 0]] if back else [[0, 0], [1, of["path"]]]
    return SCENE.format(**of, push=push, step=(0.5 if back else 1) / steps, more=f", slave: {of['slave']}{more}")


def contact_share(rows):
    return max(abs(row["contact"]) for row in rows) / max(row["internal"] for row in rows)


def work_of_reactions(rows, path):
    """At the driven nodes, by the trapezoidal rule: [(of a row, until then)]."""
    done, at = [0.0], [path * 2 * min(row["time"], 1 - row["time"]) for row in rows]
    for k in range(1, len(rows)):
        done.append(done[-1] + 0.5 * (rows[k]["top.x"] + rows[k - 1]["top.x"]) * (at[k] - at[k - 1]))
    return done


class Consistent(SceneProgram):
    def attempt(self, text, ranks):
        """Rows of the history; None where the run stops with its cause."""
        told = self.go(text, ranks=ranks, code=(0, 3))
        return None if "brunt: stopped: " in told else self.rows("out")

    def test_contact_takes_no_energy_that_steps_do_not_make(self):
        """Of second order in the step, whatever the mesh; without the key most scenes take or give more than a percent."""
        orders, plain, missed = [], [], []
        for seed in range(1, VARIANTS + 1):
            of = sliding(seed)
            with self.subTest(seed=seed, **of):
                coarse, fine = [self.attempt(scene_of(of, steps, ", consistent: true"), 1 + seed % 2) for steps in (20, 40)]
                if coarse is None or fine is None or contact_share(fine) >= 4e-3:
                    if fine and min(row["contact"] for row in fine) < -0.01 * max(row["internal"] for row in fine):
                        self.assertIn("warning: energy dissipated by contact is -", self.text("out", "log.txt"))
                    missed.append((seed, "stopped" if coarse is None or fine is None else contact_share(fine)))
                    continue
                orders.append(math.log2(contact_share(coarse) / contact_share(fine)))
                plain.append(contact_share(self.go(scene_of(of, 20, ", consistent: false") + WIDE)))
        # Missed (cases/LIMITS.md): 8 of 300. In five of them contact takes or gives .75 to 3.5 % in one step, whatever its length:
        # the nose leaves the last facet in a jump. Three stop with their cause.
        self.assertLessEqual(len(missed), 0.03 * VARIANTS, missed)
        self.assertGreater(sorted(orders)[len(orders) // 2], 1.6, orders)
        self.assertGreater(sorted(plain)[len(plain) // 2], 0.01, plain)

    def test_energy_is_the_path_integral_of_the_reactions(self):
        rows = self.go(scene_of(sliding(2), 30, ", consistent: true", back=True))
        largest = max(row["internal"] for row in rows)
        for row, work in zip(rows, work_of_reactions(rows, sliding(2)["path"])):
            self.assertAlmostEqual(row["internal"] / largest, work / largest, delta=0.01)
        self.assertLess(abs(rows[-1]["external"]), 1e-6 * largest)

    def test_a_closed_path_does_no_work(self):
        """On to the bump, up from it and back through the air: what is left of the external work is what contact made."""
        left = {}
        for more in (", consistent: true", ""):
            text = scene_of(sliding(2), 50, more).replace(", {set: nose_ymax, dofs: [z]}]", "]")
            push = f"[[0, 0], [0.4, {sliding(2)['path']}], [0.9, {sliding(2)['path']}], [1, 0]]"
            text = re.sub(r"push: .*}", f"push: {push}, lift: [[0, 0], [0.4, 0], [0.8, 0.3], [0.9, 0.3], [1, 0.3]]}}", text).replace(
                "prescribed: [", "prescribed: [{set: nose_ymax, dof: z, displacement: lift}, ")
            rows = self.go(text + WIDE)
            self.assertEqual(rows[-1]["active_contacts"], 0)
            left[more] = abs(rows[-1]["external"]) / max(row["internal"] for row in rows)
        self.assertLess(left[", consistent: true"], 0.01, left)
        self.assertGreater(left[""], 0.02, left)

    def test_restart_and_ranks_have_the_same_bits(self):
        of, hashes = sliding(5), set()
        text = scene_of(of, 12, ", consistent: true")
        for ranks in of_all((1, 2, 3, 4), (1, 3)):
            self.go(text, ranks=ranks)
            hashes.add(self.summary("out")["state_hash"])
        self.write("half.yaml", text + "checkpoint: {every: 0.5}\n")
        self.run_scene(2, "half.yaml", "--out", "half", "--force", "--set", "run.end=0.5")
        self.run_scene(3, "half.yaml", "--out", "half", "--restart", "half")
        hashes.add(self.summary("half")["state_hash"])
        self.assertEqual(len(hashes), 1, hashes)

    def test_the_whole_run_is_the_scale_of_the_guard(self):
        """At first touch there is next to no energy, and a false one is a large share of it; at the end it is what it is."""
        of = {**sliding(1), "r1": 0.5, "r2": 0.5, "i1": 0.3, "i2": 0.3, "n1": 20, "n2": 24, "x1": 9.5, "x2": 10, "z1": 0.45, "z2": -0.45, "path": 0.3,
              "bump": "r", "held": "part: bump, dofs: [x, y, z, rx, ry, rz]", "slave": "nose"}
        share = contact_share(self.go(scene_of(of, 20) + WIDE))
        self.assertNotIn("must not be negative", self.text("out", "log.txt"))
        self.assertGreater(share, 0.02)
        least = min(row["contact"] for row in self.rows("out"))
        self.assertLess(least, 0)
        part = -least / max(row["internal"] for row in self.rows("out"))
        self.go(scene_of(of, 20) + f"guards: {{energy_warning: {0.9 * part:.6g}, energy_stop: 1}}\n")
        log = self.text("out", "log.txt")
        self.assertEqual(log.count("must not be negative"), 1)
        self.assertRegex(log, "% of the largest energy of the run, .*shorter steps do not help: use consistent: true")
        told = self.go(scene_of(of, 20) + f"guards: {{energy_warning: {0.5 * part:.6g}, energy_stop: {0.9 * part:.6g}}}\n", code=3)
        self.assertRegex(told, "% of the largest energy of the run")
        self.assertEqual(self.rows("out")[-1]["time"], 1)


if __name__ == "__main__":
    VARIANTS = variants_asked(VARIANTS)
    unittest.main()
