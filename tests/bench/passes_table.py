#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""One pass, two passes and mortar rows by runs of the program: tables of src/contact/mortar_rows/README.md and FRICTION.md.

usage: passes_table.py [NAME ...]     (BRUNT: the program; default build/release/brunt)

Names: slide (cost of two large faces that slide), spin (angular momentum with friction), hertz (pressure of cylinders), facets (noise of a
block that slides over facets), stack (a million steps at rest), falls (three hundred random impacts, by true depth); all by default, about
two hours.
"""
import csv
import importlib.util
import json
import math
import os
import random
import subprocess
import sys
import tempfile

import numpy

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [os.path.join(ROOT, "tests", "run"), os.path.join(ROOT, "cases", "hertz_mortar"), os.path.join(ROOT, "cases", "support")]
import falling_boxes  # noqa: E402
import mesh  # noqa: E402  of cases/hertz_mortar
import true_depth  # noqa: E402

BRUNT = os.environ.get("BRUNT", os.path.join(ROOT, "build", "release", "brunt"))
PASSES = ("one", "two", "mortar")


class Run:
    """Of a scene's text, in a folder of its own that lives as long as the object."""

    def __init__(self, scene, codes=(0,), files=()):
        self.folder = tempfile.TemporaryDirectory()
        path, self.out = (os.path.join(self.folder.name, name) for name in ("scene.yaml", "out"))
        with open(path, "w", encoding="utf-8") as file:
            file.write(scene)
        for name, write in files:
            write(os.path.join(self.folder.name, name))
        environment = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}
        done = subprocess.run([BRUNT, "run", path, "--out", self.out, "--quiet"], capture_output=True, text=True, env=environment)
        if done.returncode not in codes:
            sys.exit(f"{BRUNT}: exit code {done.returncode}\n{done.stderr}{scene}")
        self.code = done.returncode
        with open(os.path.join(self.out, "summary.json"), encoding="utf-8") as file:
            self.summary = json.load(file)
        with open(os.path.join(self.out, "history.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.history = {name.split(" [")[0]: numpy.array([float(row[name]) for row in rows]) for name in rows[0]}
        self.contact, self.energy = self.summary["contact"], self.summary["energy"]

    def __getitem__(self, name):
        return self.history[name]

    def over_elements(self, *parts):
        return sum(self.summary["share"][part] for part in parts) / self.summary["share"]["element"]


def table(title, columns, rows):
    print(f"\n| {title} | " + " | ".join(columns) + " |\n|" + "---|" * (len(columns) + 1))
    for name, values in rows:
        print(f"| {name} | " + " | ".join(values) + " |", flush=True)


SLIDE = """units: SI
mesh:
  - {{box: {{part: a, size: [1, 1, 0.5], elements: [56, 56, 28]}}}}
  - {{box: {{part: b, size: [1, 1, 0.5], elements: [53, 53, 27], at: [0, 0, 0.5001]}}}}
materials: {{m: {{model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}}}}
parts: {{a: {{material: m}}, b: {{material: m}}}}
initial: [{{part: b, velocity: [{speed}, 0, -40]}}]
contact: [{{between: all, friction: {friction}, passes: {passes}}}]
run: {{steps: 60, step_bound: element}}
"""


def slide():
    """Two steel blocks that meet with a whole face at 40 m/s: one core, search, the rest of contact over elements."""
    rows = []
    for speed in (3, 100):
        for friction in (0.2, 0):
            values = []
            for passes in PASSES:
                run = Run(SLIDE.format(speed=speed, friction=friction, passes=passes))
                values.append(f"{run.contact['iterations_mean']:.1f}; {run.over_elements('search'):.2f}; "
                              f"{run.over_elements('enforcement'):.2f}; {run.energy['friction']:.4g}; {run.summary['max_penetration']:.1e}")
            rows.append((f"{speed} m/s, friction {friction}", values))
    table("iterations; search; contact, over elements; work of friction [J]; penetration [m]", PASSES, rows)


SPIN = """units: SI
mesh:
  - {{box: {{part: a, size: [1, 1, 0.3], elements: [8, 8, 2]}}}}
  - {{box: {{part: b, size: [0.5, 0.4, 0.3], elements: {elements}, at: {at}, rotate: {{axis: [0, 0, 1], degrees: {degrees}}}}}}}
materials: {{m: {{model: elastic, density: 7800, young: 2.0e9, poisson: 0.3}}}}
parts: {{a: {{material: m}}, b: {{material: m}}}}
initial: [{{part: b, velocity: {velocity}, rotation: {{axis: [0, 0, 1], point: [0.5, 0.5, 0.4], rate: {rate}}}}}]
contact: [{{between: all, friction: {friction}, passes: {passes}}}]
run: {{end: 0.015}}
history: {{every: 1}}
"""


def spin(seeds=range(1, 21)):
    """A block that slides and spins on another one, and does not come to its rim: changes of the angular momentum, over its size."""
    rows = []
    for friction in (0, 0.3):
        values = []
        for passes in PASSES:
            errors, balance = [], []
            for seed in seeds:
                rng = random.Random(seed)
                cells, degrees = [rng.randint(3, 9), rng.randint(3, 9), 2], rng.uniform(0, 90)
                angle = math.radians(degrees)
                at = [0.5 - 0.25 * math.cos(angle) + 0.2 * math.sin(angle), 0.5 - 0.25 * math.sin(angle) - 0.2 * math.cos(angle), 0.30001]
                velocity = [rng.uniform(-8, 8), rng.uniform(-8, 8), rng.uniform(-15, -2)]
                run = Run(SPIN.format(elements=cells, at=at, degrees=degrees, velocity=velocity, rate=rng.uniform(-20, 20), friction=friction,
                                      passes=passes))
                errors.append(run.summary["angular_momentum_error"])
                balance.append(run.energy["error_ratio"])
            values.append(f"{numpy.median(errors):.0e}; {max(errors):.0e}; {max(balance):.0e}")
        rows.append((f"friction {friction}", values))
    table("angular momentum: median, largest error; energy: largest error", PASSES, rows)


HERTZ = """units: none
mesh:
  - {{file: cylinders.inp}}
materials: {{rubber: {{model: neo_hookean, density: 1, young: 200, poisson: 0.3}}}}
parts: {{low: {{material: rubber, element: hex8_full}}, top: {{material: rubber, element: hex8_full}}}}
symmetry:
  - {{point: [0, 0, 0], normal: [1, 0, 0]}}
  - {{point: [0, 0, 0], normal: [0, 1, 0]}}
  - {{point: [0, 0.1, 0], normal: [0, 1, 0]}}
fixed: [{{set: low_flat, dofs: [z]}}]
traction: [{{set: top_flat, value: [0, 0, -0.625], curve: ramp}}]
curves: {{ramp: [[0, 0], [20, 1]]}}
damping: {{alpha: 1.5}}
contact: [{{between: [top, low], slave: first, passes: {passes}}}]
run: {{end: 60}}
history: {{every: 1}}
output: {{every: 60, fields: [displacement, contact_pressure]}}
"""


def hertz(facets=8):
    """Cylinders as in cases/hertz_mortar at P = 10, but explicit and damped, with `facets` elements over Hertz's half width."""
    spec = importlib.util.spec_from_file_location("hertz_check", os.path.join(ROOT, "cases", "hertz_mortar", "check.py"))
    check = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(check)
    half_width = 0.6807783738
    facet = half_width / facets
    rows = []
    for passes in PASSES:
        run = Run(HERTZ.format(passes=passes), files=[("cylinders.inp", lambda path: mesh.write(path, facet, check.DEPTH, 0.0,
                                                                                                zone=1.47 * half_width))])
        profile = check.Profile(type("Result", (), {"folder": run.out}))
        p0, a = profile.fit()
        fitted = p0 * numpy.sqrt(numpy.maximum(0, 1 - (profile.x / a) ** 2))
        (converged, width), away = check.CONVERGED[10], profile.x < 0.97 * a
        rises = max(numpy.diff(profile.pressure).max(), 0)
        rows.append((passes, [f"{p0:.4f} ({100 * (p0 / converged - 1):+.2f} %)", f"{a:.4f} ({100 * (a / width - 1):+.2f} %)",
                              f"{100 * rises / p0:.2f} %", f"{100 * abs(profile.pressure - fitted)[away].max() / p0:.2f} %",
                              f"{profile.vertical() / 5 - 1:.1e}", f"{run['kinetic'][-1]:.0e}"]))
    table(f"Hertz, a/{facets}", ["p0 (9.505)", "a (0.671)", "largest rise outwards / p0", "off the fit within 0.97 a / p0", "sum of pressures",
                                "kinetic energy"], rows)


FACETS = """units: none
mesh:
  - {{tube: {{part: valley, inner_radius: 16, outer_radius: 17, length: 1, elements: [1, 96, 1]}}}}
  - {{box: {{part: block, size: [0.1, 0.1, 0.1], elements: [{cells}, {cells}, {cells}], at: [0.05, -15.98, 0.45]}}}}
materials: {{m: {{model: elastic, density: 1, young: 1000, poisson: 0.3}}}}
parts: {{valley: {{material: m}}, block: {{material: m}}}}
fixed: [{{set: valley_side, dofs: [x, y, z]}}]
initial: [{{part: block, velocity: [3, 0, 0]}}]
contact: [{{between: all, passes: {passes}}}]
probes: [{{name: force, contact: [block, valley]}}, {{name: block, part: block, field: position}}]
run: {{end: 10}}
history: {{every: 0.01}}
"""


def facets():
    """E9: a block slides through a tube of facets ten times its size: the impulse on it, smoothed over the time of one and of two
    facets, beside that of a smooth tube at the same speeds."""
    rows = []
    for cells in (1, 3):
        values = []
        for passes in PASSES:
            run = Run(FACETS.format(cells=cells, passes=passes))
            time, x, y = run["time"], run["block.x"], run["block.y"]
            radius, turned = numpy.hypot(x, y), numpy.unwrap(numpy.arctan2(x, -y))
            inwards = -(run["force.x"] * x + run["force.y"] * y) / radius
            due = 1e-3 * numpy.gradient(turned, time) ** 2 * radius
            smooth = []
            for count in (1, 2):
                window = round(count * 2 * math.pi * 16 / 96 / 3 / 0.01)
                mean = numpy.convolve(inwards / due, numpy.ones(window) / window, "valid")[round(1 / 0.01):]
                smooth.append(f"{mean.mean():.3f}, {100 * mean.std():.1f} %")
            values.append("; ".join(smooth) + f"; {run.summary['momentum_error']:.0e}")
        rows.append((f"block of {cells} elements an edge", values))
    table("force over that of a smooth tube: mean, noise over one facet; over two; error of momentum", PASSES, rows)


STACK = """units: SI
mesh:
  - {{box: {{part: c0, size: [0.1, 0.1, 0.1], elements: [2, 2, 2]}}}}
  - {{box: {{part: c1, size: [0.1, 0.1, 0.1], elements: [3, 3, 3], at: [0.004, -0.002, 0.1]}}}}
  - {{box: {{part: c2, size: [0.1, 0.1, 0.1], elements: [2, 2, 2], at: [-0.003, 0.003, 0.2]}}}}
materials: {{soft: {{model: elastic, density: 1000, young: 1.0e8, poisson: 0.3}}}}
parts: {{c0: {{material: soft}}, c1: {{material: soft}}, c2: {{material: soft}}}}
gravity: {{vector: [0, 0, -9.81]}}
damping: {{alpha: 40, from: 0, to: 1.0}}
rigid_walls: [{{name: floor, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.5}}]
contact: [{{between: all, self: false, friction: 0.5, passes: {passes}}}]
probes: [{{name: top, part: c2, field: position}}]
run: {{steps: {steps}}}
history: {{every: 0.02}}
"""


def stack(steps=1010000):
    """Three cubes: from the end of damping on."""
    rows = []
    for passes in PASSES:
        run = Run(STACK.format(passes=passes, steps=steps))
        rest = run["time"] > 1.05
        fall = 3 * 9.81 * 0.15
        taken = run["contact"] + run["friction"] + run["walls"]
        kinetic = run["kinetic"][rest]
        rows.append((passes, [f"{run['step'][-1] - run['step'][rest][0]:.0f}"]
                     + [f"{numpy.ptp(run[f'top.{c}'][rest]) / 0.1:.0e}" for c in "xyz"]
                     + [f"{kinetic[:len(kinetic) // 2].max() / fall:.0e}", f"{kinetic[len(kinetic) // 2:].max() / fall:.0e}",
                        f"{-numpy.minimum(0, numpy.diff(taken[rest])).sum() / fall:.0e}", f"{run.energy['error_ratio']:.0e}",
                        f"{run.contact['iterations_mean']:.1f}", f"{run.summary['loop_s']:.0f}"]))
    table("three cubes at rest", ["steps at rest", "top moves / side: x", "y", "z", "kinetic energy / (m g h): first half", "second half",
                                  "given by contact / (m g h)", "error of energy", "iterations", "loop [s]"], rows)


WARNED, DIFFERENCE, WARP = 0.1, 0.05, 0.01  # as in tests/run/falling_boxes_test.py


def falls(seeds=range(1, 301), end=0.06):
    """Random boxes that fall on each other and on a wall: depth of nodes by positions, and whether the program reported it."""
    found = {passes: [] for passes in ("auto", "mortar")}
    for seed in seeds:
        scene = falling_boxes.scene(seed, end, records=8).replace("output:", "history: {every: 1.0e-4}\noutput:")
        for passes, list_of in found.items():
            run = Run(scene.replace("between: all,", f"between: all, passes: {passes},"), codes=(0, 3))
            depth = true_depth.deepest(os.path.join(run.out, "state.h5")).share
            with open(os.path.join(run.out, "log.txt"), encoding="utf-8") as file:
                log = file.read()
            total = run["kinetic"] + run["internal"]
            list_of.append({"seed": seed, "depth": depth, "code": run.code, "folds": run.summary["folded_elements"],
                            "missed": (depth > WARNED + DIFFERENCE and not any(word in log for word in ("leaves penetration", "lost nodes", "folded")))
                            or (run.summary["folded_elements"] == 0
                                and run.summary["deepest_penetration"]["elements"] < depth * (1 - DIFFERENCE) - WARP),
                            "gain": (total.max() - total[0]) / total[0], "given": max(0.0, -(run["contact"] + run["walls"] + run["friction"]
                                                                                            + run["driven"]).min() / total[0]),
                            "error": run.energy["error_ratio"], "iterations": run.contact["iterations_mean"], "loop": run.summary["loop_s"]})
    whole = {passes: [one for one in of if one["folds"] == 0] for passes, of in found.items()}
    lines = [("scenes; stopped", lambda p: f"{len(found[p])}; {sum(one['code'] == 3 for one in found[p])}"),
             ("seeds missed", lambda p: str([one["seed"] for one in found[p] if one["missed"]])),
             ("deeper than .1 of an element, none folded", lambda p: str([one["seed"] for one in whole[p] if one["depth"] > WARNED])),
             ("depth without folds: mean, largest", lambda p: f"{numpy.mean([one['depth'] for one in whole[p]]):.4f}, "
                                                             f"{max(one['depth'] for one in whole[p]):.3f}"),
             ("most energy above the start / start", lambda p: f"{max(one['gain'] for one in found[p]):.1e}"),
             ("most given by contact / start", lambda p: f"{max(one['given'] for one in found[p]):.1e}"),
             ("error of energy, largest", lambda p: f"{max(one['error'] for one in found[p]):.0e}"),
             ("iterations, mean; loop, sum [s]", lambda p: f"{numpy.mean([one['iterations'] for one in found[p]]):.1f}; "
                                                           f"{sum(one['loop'] for one in found[p]):.0f}")]
    table(f"{len(seeds)} falls", list(found), [(name, [value(passes) for passes in found]) for name, value in lines])


PARTS = {"slide": slide, "spin": spin, "hertz": hertz, "facets": facets, "stack": stack, "falls": falls}


def main():
    chosen = sys.argv[1:] or list(PARTS)
    for name in chosen:
        if name not in PARTS:
            sys.exit(f"passes_table: unknown name '{name}'; expected {', '.join(PARTS)}")
    for name in chosen:
        PARTS[name]()


if __name__ == "__main__":
    main()
