#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Guards of a run and mass damping, end to end: what stops, what it says, and that ranks and restarts change nothing.

Needs BRUNT (the program) and BRUNT_RUN (scripts/run) in the environment."""
import csv
import json
import os
import re
import subprocess
import tempfile
import unittest

from run_test import of_all

RUN = os.environ["BRUNT_RUN"]
PATIENCE = 300  # [s] for one run

# two steel blocks, one on a support; damped as DAMPING says
DAMPED = """\
units: SI
mesh:
  - {box: {part: a, size: [0.1, 0.1, 0.1], elements: [3, 3, 3]}}
  - {box: {part: b, size: [0.1, 0.1, 0.1], elements: [4, 4, 4], at: [0, 0, 0.10001]}}
materials: {s: {model: j2, density: 7800, young: 2.0e11, poisson: 0.3, yield: 4.0e8}}
parts: {a: {material: s}, b: {material: s}}
sets: {foot: {box: [[0, 0, 0], [1, 1, 0.001]], part: a}}
initial: [{part: b, velocity: [0, 0, -10]}]
fixed: [{set: foot, dofs: [x, y, z]}]
contact: [{between: all, friction: 0.2}]
damping: {DAMPING}
run: {steps: 200}
"""

# a sharp steel cube between blocks of rubber takes the step with it
COLLAPSE = """\
units: SI
materials: {s: {model: j2, density: 7800, young: 2.0e11, poisson: 0.3, yield: 4.0e8, hardening: 1.0e9}, r: {model: neo_hookean, density: 1100, bulk: 1.0e8, shear: 1.0e7}}
mesh:
  - {box: {part: a, size: [1, 1, 0.5], elements: [4, 4, 2]}}
  - {box: {part: b, size: [0.001, 0.001, 0.001], elements: [3, 3, 3], at: [0.4601, 0.3711, 0.50001]}}
  - {box: {part: c, size: [1, 1, 0.5], elements: [3, 3, 2], at: [0, 0, 0.50102]}}
parts: {a: {material: r}, b: {material: s}, c: {material: r}}
initial: [{part: c, velocity: [0, 0, -10]}]
contact: [{between: all, friction: 0.3}]
run: {end: 1.4e-4, min_step_ratio: RATIO}
history: {every: 1.0e-5}
"""

# elastic plates of equal mass that meet flush: their velocities should be exchanged
PLATES = """\
units: SI
mesh:
  - {box: {part: a, size: [0.1, 0.1, 0.01], elements: [4, 4, N]}}
  - {box: {part: b, size: [0.1, 0.1, 0.01], elements: [4, 4, N], at: [0, 0, 0.01001]}}
materials: {e: {model: elastic, density: 7800, young: 2.0e11, poisson: 0.0}}
parts: {a: {material: e}, b: {material: e}}
initial: [{part: b, velocity: [0, 0, -10]}]
contact: [{between: all}]
run: {end: END}
"""

# a steel block falls on one of its corners
CORNER = """\
units: SI
mesh: {box: {part: b, size: [0.01, 0.01, 0.01], elements: [4, 4, 4], rotate: {axis: [1, -0.7, 1], degrees: 80}, at: [0, 0, 0.02]}}
materials: {s: {model: j2, density: 7800, young: 2.0e11, poisson: 0.3, yield: 2.0e8}}
parts: {b: {material: s, ELEMENT}}
initial: [{part: b, velocity: [0, 0, -SPEED]}]
rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1]}]
run: {end: 4.0e-4}
"""

# the top of an elastic block is driven through its foot
TURNED_OVER = """\
units: SI
mesh: {box: {part: b, size: [1, 1, 1], elements: [2, 2, 2]}}
materials: {e: {model: elastic, density: 1000, young: 1.0e7, poisson: 0.3}}
parts: {b: {material: e}}
fixed: [{set: b_zmin, dofs: [x, y, z]}]
prescribed: [{set: b_zmax, dof: z, velocity: -2}]
run: {end: 1, min_step_ratio: 0.2}
"""

# a small sphere pressed flat between two bodies meets itself through its own thickness
FLATTENED = """\
units: SI
mesh:
  - {sphere: {part: b0, radius: 0.02, elements: 2, rotate: {axis: [0.296982, 0.941191, 0.161123], degrees: 297.711}, at: [0, 0, -0.02615]}}
  - {box: {part: b1, size: [0.0224454, 0.0238714, 0.0229425], elements: [2, 1, 3], rotate: {axis: [0.328416, 0.337622, -0.882131], degrees: 36.3413}, at: [-0.0118974, -0.00700992, 0.01642]}}
  - {sphere: {part: b2, radius: 0.006, elements: 2, rotate: {axis: [0.489128, -0.84239, -0.226126], degrees: 88.1725}, at: [0.00355582, -0.00225888, 0]}}
materials: {steel: {model: j2, density: 7800, young: 2.0e11, poisson: 0.3, yield: 2e+08, hardening: 0}}
parts:
  b0: {material: steel, element: hex8, hourglass: {kind: elastic}}
  b1: {material: steel, element: hex8, hourglass: {kind: elastic}}
  b2: {material: steel, element: hex8, hourglass: {kind: elastic}}
initial:
  - {part: b0, velocity: [0, 0, 0]}
  - {part: b1, velocity: [0, 0, -150]}
  - {part: b2, velocity: [0, 0, 0]}
contact: [{between: all, friction: 0.3}]
run: {end: 0.0002445}
"""


class Guards(unittest.TestCase):
    def setUp(self):
        self.keeper = tempfile.TemporaryDirectory()
        self.addCleanup(self.keeper.cleanup)

    def path(self, *names):
        return os.path.join(self.keeper.name, *names)

    def run_scene(self, ranks, text, out, *options, code=0):
        with open(self.path("scene.yaml"), "w", encoding="utf-8") as stream:
            stream.write(text)
        done = subprocess.run([RUN, "-np", str(ranks), "scene.yaml", "--out", out, "--quiet", *options],
                              cwd=self.keeper.name, capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, code, done.stderr + done.stdout)
        with open(self.path(out, "summary.json"), encoding="utf-8") as stream:
            return json.load(stream)

    def log(self, out):
        with open(self.path(out, "log.txt"), encoding="utf-8") as stream:
            return stream.read()

    def rows(self, out):
        with open(self.path(out, "history.csv"), encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def test_damping_of_any_size_keeps_the_balance_on_any_ranks_and_over_a_restart(self):
        for damping in ("alpha: 1.0e3", "alpha: 1.0e6", "alpha: 4.5e5, from: 2.0e-5, to: 6.0e-5"):
            with self.subTest(damping=damping):
                text = DAMPED.replace("DAMPING", damping)
                name = damping.replace(" ", "").replace(":", "").replace(",", "")
                found = [self.run_scene(ranks, text, f"{name}{ranks}") for ranks in of_all((1, 2, 3), (1, 3))]
                self.assertEqual(len({one["state_hash"] for one in found}), 1)
                whole = found[0]
                self.assertLess(whole["energy"]["error_ratio"], 1e-12)
                self.assertLess(whole["momentum_error"], 1e-12)
                taken = [float(next(v for k, v in row.items() if k.startswith("damping"))) for row in self.rows(f"{name}1")]
                self.assertGreater(taken[-1], 0)
                for before, after in zip(taken, taken[1:]):
                    self.assertGreaterEqual(after, before * (1 - 1e-12))
                self.run_scene(2, text, f"{name}_part", "--set", "run.steps=77")
                last = self.run_scene(3, text, f"{name}_part", "--restart", f"{name}_part")
                self.assertEqual(last["state_hash"], whole["state_hash"])
                for one in (last, whole):
                    self.assertLess(one["energy"].pop("error_ratio"), 1e-12)
                self.assertEqual(last["energy"], whole["energy"])

    def test_a_step_that_falls_stops_the_run_and_names_the_element(self):
        text = COLLAPSE.replace("RATIO", "1.0e-2")
        for ranks in (1, 2):
            summary = self.run_scene(ranks, text, f"fell{ranks}", code=3)
            self.assertEqual(summary["stopped_by"], "guard")
            log = self.log(f"fell{ranks}")
            for phrase in ("run.min_step_ratio 0.01 of the first", "of part 'b' at (0.46", "Likely cause", "last good state"):
                self.assertIn(phrase, log)
        said = [next(line for line in self.log(f"fell{r}").splitlines() if line.startswith("stopped:")) for r in (1, 2)]
        self.assertEqual(*said)
        # with a smaller ratio the run goes on from the last good state, and measures by the first step of all
        self.run_scene(2, text, "fell2", "--restart", "fell2", "--set", "run.min_step_ratio=2.0e-3", code=3)
        first = said[0].split("of the first, ")[1].split(":")[0]
        again = [line for line in self.log("fell2").splitlines() if line.startswith("stopped:")][-1]
        self.assertIn(f"run.min_step_ratio 0.002 of the first, {first}", again)

    def test_a_guard_in_the_very_last_step_leaves_no_checkpoint_of_the_broken_state(self):
        text = TURNED_OVER
        self.run_scene(1, text, "whole", code=3)
        said = next(line for line in self.log("whole").splitlines() if line.startswith("stopped:"))
        steps = int(re.search(r", step (\d+)\b", said).group(1))
        for ranks, more in ((1, ()), (2, ("--set", "checkpoint={every: 0.1}"))):
            out = f"last{ranks}"
            summary = self.run_scene(ranks, text, out, "--set", f"run.steps={steps}", *more, code=3)
            self.assertEqual(summary["stopped_by"], "guard")
            self.assertIn(said, self.log(out))
            kept = sorted(name for name in os.listdir(self.path(out)) if name.startswith("checkpoint_"))
            self.assertNotIn(f"checkpoint_{steps:09d}.h5", kept)
            self.assertTrue(kept)
            self.assertIn(f"last good state: {out}/{kept[-1]}", self.log(out))
            # the run goes on from there and stops in the same step
            self.run_scene(ranks, text, out, "--restart", out, code=3)
            self.assertEqual([line for line in self.log(out).splitlines() if line.startswith("stopped:")][-1], said)

    def test_contact_that_took_much_of_bodies_that_parted_is_told(self):
        for elements, end, told in ((1, 3.0e-5, True), (4, 3.0e-5, True), (16, 1.5e-5, False), (2, 2.0e-6, False)):
            with self.subTest(elements=elements, end=end):
                summary = self.run_scene(1, PLATES.replace("N]", f"{elements}]").replace("END", str(end)), f"p{elements}_{end}")
                self.assertGreater(summary["energy"]["contact"], 0)
                self.assertEqual("have separated again" in self.log(f"p{elements}_{end}"), told)

    def test_a_corner_that_metal_of_mean_dilatation_does_not_hold_is_told_with_what_holds_it(self):
        for speed in (150, 250):
            for element, stops in (("hex8_bbar", True), ("hex8_full", False), ("hex8, hourglass: {kind: elastic}", False)):
                with self.subTest(speed=speed, element=element):
                    text = CORNER.replace("ELEMENT", f"element: {element}").replace("SPEED", str(speed))
                    out = f"{element[:9]}{speed}".replace(", ", "")
                    summary = self.run_scene(1, text, out, code=3 if stops else 0)
                    self.assertEqual(summary["stopped_by"], "guard" if stops else "end")
                    self.assertEqual("no volume left" in self.log(out), stops)
                    self.assertEqual("use element: hex8_full, or hex8 with hourglass: {kind: elastic}" in self.log(out), stops)

    def test_causes_among_rigid_bodies_are_of_the_scene(self):
        """A heavy block squeezes a light one on a fixed anvil: nothing there moves a support."""
        boxes = (("anvil", 2, 1, "[-1, -1, -1]"), ("pin", 0.4, 0.4, "[-0.2, -0.2, 0]"), ("ram", 1, 1, "[-0.5, -0.5, 0.4]"))
        text = ("units: SI\nmesh: [" + ", ".join(f"{{box: {{part: {name}, size: [{side}, {side}, {high}], elements: [1, 1, 1], at: {at}}}}}"
                                                                for name, side, high, at in boxes) + "]\n"
                   "materials: {light: {model: rigid, density: 15.625}, heavy: {model: rigid, density: 1000}}\n"
                   "parts: {anvil: {material: heavy}, pin: {material: light}, ram: {material: heavy}}\n"
                   "fixed: [{part: anvil, dofs: [x, y, z, rx, ry, rz]}]\ninitial: [{part: ram, velocity: [0, 0, -10]}]\n"
                   "contact: [{between: all, softness: 0}]\nenforcement: {max_iterations: 2}\nrun: {end: 0.01, step: 0.001}\n")
        self.run_scene(1, text, "ram")
        told = self.log("ram")
        self.assertIn("ended at max_iterations", told)
        for word in ("supports", "prescribed", "moving walls"):
            self.assertNotIn(word, told)

    def test_contact_that_gives_energy_stops_the_run(self):
        """Of the element pressed flat, whose two sides meet; contact without self-contact gives nothing."""
        self.run_scene(1, FLATTENED, "true", code=3)
        self.assertRegex(self.log("true"), "stopped: energy dissipated by contact is -.* must not be negative; likely cause: ")
        summary = self.run_scene(1, FLATTENED, "false", "--set", "contact.0.self=false")
        self.assertGreater(summary["energy"]["contact"], 0)
        self.assertNotIn("energy dissipated by contact", self.log("false"))


if __name__ == "__main__":
    unittest.main()
