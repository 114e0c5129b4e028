#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""enforcement.impact: plastic against elastic, by runs of the program: the tables of src/contact/enforcement/IMPACT.md.

usage: impact_table.py [NAME ...]     (BRUNT: the program; default build/release/brunt)

Names: bars, steps, plates, unlike, stasio, lengths, flow, cradles, wall, rigid, rest, cases, boxes; all by default, about half an hour. Bars have the length, density and speed
of sound 1 and Poisson's ratio 0, so that they are exactly one-dimensional; the striker has the speed of tests/bench/impact_laws.py. Exact
values stand in brackets.
"""
import csv
import json
import os
import subprocess
import sys
import tempfile

import numpy

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tests", "run"))
import falling_boxes  # noqa: E402

BRUNT = os.environ.get("BRUNT", os.path.join(ROOT, "build", "release", "brunt"))
SPEED = 10 / numpy.sqrt(2e11 / 7800)
LAWS = ("plastic", "elastic")
PHASES = numpy.arange(0.03, 1, 0.07)
COURANT = (0.9, 0.5)


class Result:
    def __init__(self, folder):
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            self.summary = json.load(file)
        with open(os.path.join(folder, "history.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.history = {name.split(" [")[0]: numpy.array([float(row[name]) for row in rows]) for name in rows[0]}

    def __getitem__(self, name):
        return self.history[name]

    @property
    def start(self):
        return self["kinetic"][0] + self["internal"][0]

    @property
    def taken(self):
        """By contact and walls along their normals, over the energy of the start."""
        return (self["contact"] + self["walls"]) / self.start

    @property
    def given(self):
        """Largest energy that all of contact has given up to a time, over that of the start."""
        return max(0.0, -(self["contact"] + self["walls"] + self["friction"] + self["driven"]).min() / self.start)

    @property
    def contact_seconds(self):
        return self.summary["loop_s"] * (self.summary["share"]["enforcement"] + self.summary["share"]["search"])


def run(scene, law, settings=(), codes=(0,)):
    """Of a text, or of a file. codes: accepted exit codes; 3: stopped by a guard."""
    with tempfile.TemporaryDirectory() as folder:
        path = scene
        if "\n" in scene:
            path = os.path.join(folder, "scene.yaml")
            with open(path, "w", encoding="utf-8") as file:
                file.write(scene)
        command = [BRUNT, "run", path, "--out", os.path.join(folder, "out"), "--quiet", "--set", f"enforcement.impact={law}"]
        for setting in settings:
            command += ["--set", setting]
        environment = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}
        done = subprocess.run(command, capture_output=True, text=True, env=environment)
        if done.returncode not in codes:
            sys.exit(f"{' '.join(command)}: exit code {done.returncode}\n{done.stderr}{scene if len(scene) < 4000 else ''}")
        return Result(os.path.join(folder, "out"))


def table(title, rows):
    """rows: name, then values by law."""
    print(f"\n| {title} | " + " | ".join(LAWS) + " |\n|---|---|---|")
    for name, values in rows:
        print(f"| {name} | " + " | ".join(values[law] for law in LAWS) + " |", flush=True)


def numbers(values, digits=2):
    return ", ".join(f"{value + 0.0:.{digits}f}" for value in values)


def bars(pieces, gaps, courant, end, cells=1, contact="{between: all}", wall=False, lateral=False):
    """Bars in a row along x; pieces: elements, length, velocity, yield stress or None, and so on. cells: across, of each."""
    h = min(length / n for n, length, *_ in pieces)
    mesh, parts, materials, initial, probes, at = [], [], [], [], [], 0.0
    cells = [cells] * len(pieces) if isinstance(cells, int) else cells
    width = h * max(cells)
    for i, (n, length, velocity, yields) in enumerate(pieces):
        mesh.append(f"  - {{box: {{part: b{i}, size: [{length}, {width!r}, {width!r}], elements: [{n}, {cells[i]}, {cells[i]}], "
                    f"at: [{at!r}, 0, 0]}}}}")
        model = "elastic" if yields is None else f"j2, yield: {yields!r}, hardening: 0"
        materials.append(f"m{i}: {{model: {model}, density: 1, young: 1, poisson: 0}}")
        parts.append(f"b{i}: {{material: m{i}, bulk: {{linear: 0, quadratic: 0}}}}")
        if velocity:
            initial.append(f"{{part: b{i}, velocity: [{velocity!r}, 0, 0]}}")
        probes.append(f"{{name: b{i}, part: b{i}, field: velocity}}")
        at += length + (gaps[i] if i < len(gaps) else 0.0)
    if len(pieces) > 1:
        probes.append("{name: force, contact: [b1, b0]}")
    else:
        probes.append("{name: force, wall: w}")
    walls = f"rigid_walls: [{{name: w, point: [{at!r}, 0, 0], normal: [-1, 0, 0]}}]\n" if wall else ""
    sides = (f"symmetry: [{{point: [0, 0, 0], normal: [0, 1, 0]}}, {{point: [0, 0, 0], normal: [0, 0, 1]}}, {{point: [0, {width!r}, 0], "
             f"normal: [0, -1, 0]}}, {{point: [0, 0, {width!r}], normal: [0, 0, -1]}}]\n" if lateral else "")
    return ("units: none\nmesh:\n" + "\n".join(mesh) + f"\nmaterials: {{{', '.join(materials)}}}\nparts: {{{', '.join(parts)}}}\n"
            + f"initial: [{', '.join(initial)}]\n" + (f"contact: [{contact}]\n" if len(pieces) > 1 else "") + walls + sides
            + f"probes: [{', '.join(probes)}]\nrun: {{end: {end!r}, step: {courant * h!r}, cfl: 0.95}}\nhistory: {{every: {1e-3 * courant * h!r}}}\n"
            + "output: {every: 1000}\n"), width


def restitution(result, first=0, second=1):
    return (result[f"b{second}.x"][-1] - result[f"b{first}.x"][-1]) / SPEED if f"b{second}.x" in result.history else -result[f"b{first}.x"][-1] / SPEED


def contact_time(result):
    """From the first impulse to the last one, over that of two equal bars."""
    acts = numpy.nonzero(abs(result["force.x"]) > 0)[0]
    return (result["time"][acts[-1]] - result["time"][acts[0]]) / 2


def equal_bars():
    rows = []
    for n in (1, 2, 4, 8):
        found = {law: [[run(bars([(n, 1.0, SPEED, None), (n, 1.0, 0, None)], [SPEED * c / n * (1 + phase)], c, 8.0)[0], law)
                        for phase in PHASES] for c in COURANT] for law in LAWS}
        area = 1 / n**2
        rows.append((f"restitution (1), N = {n}: mean, least", {law: numbers((numpy.mean(e), min(e))) for law in LAWS
                     for e in [[restitution(r) for some in found[law] for r in some]]}))
        rows.append((f"contact time (1), N = {n}, C = 0.9, 0.5", {law: numbers(numpy.mean([contact_time(r) for r in some])
                     for some in found[law]) for law in LAWS}))
        rows.append((f"peak force (1), N = {n}, C = 0.9, 0.5", {law: numbers(max(abs(r["force.x"]).max() for r in some) / (area * SPEED / 2)
                     for some in found[law]) for law in LAWS}))
        rows.append((f"force of the last impulse, N = {n}, C = 0.9, 0.5", {law: numbers(numpy.mean(
            [abs(r["force.x"][numpy.nonzero(abs(r["force.x"]) > 0)[0][-3:]]).max() for r in some]) / (area * SPEED / 2)
            for some in found[law]) for law in LAWS}))
        rows.append((f"energy given, N = {n}", {law: f"{max(r.given for some in found[law] for r in some):.0e}" for law in LAWS}))
    table("equal bars", rows)


def small_steps():
    """Seven phases of the arrival with a small Courant number."""
    found = {law: [run(bars([(4, 1.0, SPEED, None), (4, 1.0, 0, None)], [SPEED * 0.15 / 4 * (1 + phase)], 0.15, 8.0)[0], law)
                   for phase in PHASES[::2]] for law in LAWS}
    table("equal bars, C = 0.15", [
        ("restitution (1), N = 4: mean, least", {law: numbers((numpy.mean(e), min(e))) for law in LAWS
         for e in [[restitution(r) for r in found[law]]]}),
        ("peak force (1), N = 4", {law: numbers([max(abs(r["force.x"]).max() for r in found[law]) * 16 / (SPEED / 2)]) for law in LAWS}),
        ("largest of the last three impulses, N = 4", {law: numbers([max(abs(r["force.x"][numpy.nonzero(abs(r["force.x"]) > 0)[0][-3:]]).max()
                                                       for r in found[law]) * 16 / (SPEED / 2)]) for law in LAWS})])


def plates():
    """Columns of several elements across, between planes of symmetry: meshes that match and that do not, in all passes."""
    rows = []
    for name, cells in (("4 on 4", (4, 4)), ("4 on 3", (4, 3))):
        for passes in ("one", "two", "mortar"):
            values = {}
            for law in LAWS:
                results = []
                for phase in (0.1, 0.5, 0.9):
                    scene, _ = bars([(4, 1.0, SPEED, None), (4, 1.0, 0, None)], [SPEED * 0.9 / 4 * (1 + phase)], 0.5, 8.0, cells,
                                    f"{{between: [b0, b1], passes: {passes}}}", lateral=True)
                    results.append(run(scene, law))
                values[law] = (numbers((numpy.mean([restitution(r) for r in results]), min(restitution(r) for r in results)))
                               + f"; {numpy.mean([r.summary['contact']['iterations_mean'] for r in results]):.1f}"
                               + f"; {max(r.given for r in results):.0e}")
            rows.append((f"plates {name}, N = 4, passes {passes}: restitution (1) mean, least; iterations; energy given", values))
    table("plates", rows)


PLATES = """units: none
mesh:
  - {{box: {{part: b0, size: [1, 1, {lengths[0]}], elements: [{cells[0]}, {cells[0]}, {n}], rotate: {turn}, at: {at[0]}}}}}
  - {{box: {{part: b1, size: [1, 1, {lengths[1]}], elements: [{cells[1]}, {cells[1]}, {n}], rotate: {turn}, at: {at[1]}}}}}
materials: {{m0: {{model: elastic, density: {density[0]}, young: 1, poisson: 0}}, m1: {{model: elastic, density: {density[1]}, young: 1, poisson: 0}}}}
parts: {{b0: {{material: m0, bulk: {{linear: 0, quadratic: 0}}}}, b1: {{material: m1, bulk: {{linear: 0, quadratic: 0}}}}}}
initial: [{{part: b0, velocity: {velocity}}}]
contact: [{{between: all, passes: {passes}}}]
probes: [{{name: b0, part: b0, field: velocity}}, {{name: b1, part: b1, field: velocity}}]
run: {{end: 6, cfl: 0.5}}
history: {{every: 0.01}}
output: {{every: 1000}}
"""


def unlike_plates():
    """F11: free plates of unlike materials that waves cross in the same time: all of the energy returns, as between points. Meshes that do not
    match, the pair turned about an axis askew."""
    axis, degrees = [1, 2, 3], 40.0
    rows = []
    for density in ((1, 1), (1, 4), (1, 16), (4, 1)):
        for n in (1, 2, 4):
            lengths, masses = [1 / numpy.sqrt(rho) for rho in density], [numpy.sqrt(rho) for rho in density]
            unit = numpy.array(axis) / numpy.linalg.norm(axis)
            normal = numpy.array(falling_boxes.turned(list(unit), degrees, [0, 0, 1]))
            values = {}
            for law in LAWS:
                found = []
                for cells in ((4, 4), (4, 3)):
                    for passes in ("one", "two", "mortar"):
                        at = [[0, 0, 0], list(normal * (lengths[0] + 0.3 * SPEED / n))]
                        r = run(PLATES.format(lengths=lengths, cells=cells, n=n, turn=f"{{axis: {axis}, degrees: {degrees}}}", at=at, density=density,
                                              velocity=list(SPEED * normal), passes=passes), law)
                        v = [sum(r[f"b{i}.{c}"][-1] * normal[k] for k, c in enumerate("xyz")) for i in (0, 1)]
                        found.append(((v[1] - v[0]) / SPEED, r.summary["angular_momentum_error"], r.given))
                values[law] = (numbers((numpy.mean([e[0] for e in found]), min(e[0] for e in found)))
                               + f"; {max(e[1] for e in found):.0e}; {max(e[2] for e in found):.0e}")
            rows.append((f"impedances {masses[0]:g} : {masses[1]:g}, N = {n}", values))
    table("turned plates, 4 on 4 and 4 on 3, all passes: restitution (1) mean, least; angular momentum; energy given", rows)


def stasio():
    """The bar of Di Stasio et al. (2019) on a rigid wall: exact are the force rho c A V for the time 2L/c and no loss."""
    rows = []
    for n in (10, 50):
        for courant in COURANT:
            values = {}
            for law in LAWS:
                scene, width = bars([(n, 1.0, SPEED, None)], [0.4 * SPEED * courant / n], courant, 8.0, wall=True)
                r = run(scene, law)
                force, time, exact = abs(r["force.x"]), r["time"], SPEED * width ** 2
                acts = numpy.nonzero(force > 0)[0]
                steady = (time > time[acts[0]] + 0.5) & (time < time[acts[0]] + 1.5)
                values[law] = (f"{(time[acts[-1]] - time[acts[0]]) / 2:.3f}; {force[steady].mean() / exact:.4f}; {force.max() / exact:.2f}; "
                               f"{force[steady].std() / exact:.3f}; {restitution(r):.3f}; {r.taken[-1]:.1e}")
            rows.append((f"N = {n}, C = {courant}", values))
    table("bar on a wall: duration (1); mean force (1); peak; scatter of the force; restitution (1); energy taken", rows)


def lengths():
    rows = []
    for n in (2, 8):
        rows.append((f"unequal lengths (0.5), N = {n}", {law: numbers([restitution(run(bars(
            [(n, 1.0, SPEED, None), (2 * n, 2.0, 0, None)], [1e-3], 0.9, 16.0)[0], law))]) for law in LAWS}))
    table("unequal lengths", rows)


def flow():
    rows = []
    for n in (4, 8, 16):
        rows.append((f"plastic plates (0), N = {n}", {law: numbers([restitution(run(bars(
            [(n, 1.0, SPEED, SPEED / 4), (n, 1.0, 0, SPEED / 4)], [1e-3], 0.9, 8.0)[0], law))], 3) for law in LAWS}))
        rows.append((f"plastic bar on a wall (0.2), N = {n}", {law: numbers([restitution(run(bars(
            [(n, 1.0, SPEED, 0.3 * SPEED)], [1e-3], 0.9, 20.0, wall=True)[0], law))], 3) for law in LAWS}))
    table("plastic flow", rows)


def cradles():
    rows = []
    for count in (3, 5):
        for c in COURANT:
            scene, _ = bars([(60, 1.0, SPEED if i == 0 else 0, None) for i in range(count)], [1e-3] + [0.0] * (count - 2), c, 2.0 * count + 4)
            rows.append((f"cradle of {count} bars (1), C = {c}", {law: numbers([run(scene, law)[f"b{count - 1}.x"][-1] / SPEED], 4)
                                                                 for law in LAWS}))
    table("cradles", rows)


def on_wall():
    rows = []
    for n in (1, 2, 4, 8):
        found = {law: [run(bars([(n, 1.0, SPEED, None)], [SPEED * c / n * (1 + phase)], c, 8.0, wall=True)[0], law)
                       for c in COURANT for phase in PHASES[::3]] for law in LAWS}
        rows.append((f"bar on a wall, restitution (1), N = {n}: mean, least", {law: numbers((numpy.mean(e), min(e)))
                     for law in LAWS for e in [[restitution(r) for r in found[law]]]}))
    table("bar on a wall", rows)


RIGID = """units: none
mesh:
  - {{box: {{part: b0, size: [1, 0.5, 0.5], elements: [{n}, 2, 2]}}}}
  - {{box: {{part: b1, size: [0.3, 0.5, 0.5], elements: [1, 1, 1], at: [1.0007, 0, 0]}}}}
materials: {{m: {{model: elastic, density: 1, young: 1, poisson: 0.0}}, r: {{model: rigid, density: 3.333333333}}}}
parts: {{b0: {{material: m, bulk: {{linear: 0, quadratic: 0}}}}, b1: {{material: r}}}}
initial: [{{part: b1, velocity: [{speed!r}, 0, 0]}}]
contact: [{{between: all}}]
probes: [{{name: b0, part: b0, field: velocity}}, {{name: b1, part: b1, field: velocity}}]
run: {{end: 12}}
history: {{every: 0.01}}
"""
REST = """units: SI
mesh:
  - {box: {part: c0, size: [0.1, 0.1, 0.1], elements: [2, 2, 2]}}
  - {box: {part: c1, size: [0.1, 0.1, 0.1], elements: [3, 3, 3], at: [0.004, -0.002, 0.1]}}
  - {box: {part: c2, size: [0.1, 0.1, 0.1], elements: [2, 2, 2], at: [-0.003, 0.003, 0.2]}}
materials: {soft: {model: elastic, density: 1000, young: 1.0e8, poisson: 0.3}}
parts: {c0: {material: soft}, c1: {material: soft}, c2: {material: soft}}
gravity: {vector: [0, 0, -9.81]}
damping: {alpha: 40, from: 0, to: 1.0}
rigid_walls: [{name: floor, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.5}]
contact: [{between: all, self: false, friction: 0.5}]
run: {steps: 120000}
history: {every: 0.02}
"""


def rigid():
    """A rigid block strikes a free bar of its mass."""
    table("rigid block of the mass of a bar", [
        (f"restitution (0.73), N = {n}", {law: numbers([restitution(run(RIGID.format(n=n, speed=-SPEED), law))]) for law in LAWS})
        for n in (2, 4, 8, 32)])


def rest():
    """Cubes that settle on each other, then without damping, over the largest work of their weight."""
    found = {law: run(REST, law) for law in LAWS}
    late = {law: found[law]["time"] > 1.3 for law in LAWS}
    work = {law: abs(found[law]["external"]).max() for law in LAWS}
    taken = {law: found[law]["contact"] + found[law]["walls"] + found[law]["friction"] for law in LAWS}
    table("three cubes at rest, 120,000 steps", [
        ("kinetic energy at rest", {law: f"{found[law]['kinetic'][late[law]].max() / work[law]:.0e}" for law in LAWS}),
        ("change of what contact has taken, at rest", {law: f"{numpy.ptp(taken[law][late[law]]) / work[law]:.0e}" for law in LAWS}),
        ("energy given at any time", {law: f"{max(0.0, -taken[law].min()) / work[law]:.0e}" for law in LAWS})])


# Scene and settings.
CASES = {
    "block_impact, elastic 10^3": ("block_impact/scene.yaml", ["mesh.0.box.elements=[10, 10, 10]", "mesh.1.box.elements=[10, 10, 10]",
                                   "run.end=0.1", "output.every=1"]),
    "hertz_impact, ball on a plane, n = 10": ("hertz_impact/scene.yaml", ["mesh.sphere.elements=10", "output.every=1"]),
    "hertz_impact, two balls, 8 on 10": ("hertz_impact/two_spheres.yaml", ["mesh.0.sphere.elements=8", "mesh.1.sphere.elements=10",
                                         "output.every=1"]),
    "bouncing_ball": ("bouncing_ball/scene.yaml", ["run.end=3e-3"]),
    "bouncing_bar": ("bouncing_bar/scene.yaml", []),
    "bar_on_wall, plastic steel": ("bar_on_wall/plastic_steel.yaml", ["output.every=1", "run.end=200e-6"]),
    "taylor_bar": ("taylor_bar/scene.yaml", ["output.every=1"]),
    "stack": ("stack/scene.yaml", ["output.every=10"]),
    "pile of eight": ("pile/eight.yaml", ["output.every=10"]),
    "incline": ("incline/scene.yaml", []),
    "sphere_on_plate": ("sphere_on_plate/scene.yaml", []),
}


def cases(chosen=tuple(CASES)):
    rows = []
    for name in chosen:
        scene, settings = CASES[name]
        values = {}
        for law in LAWS:
            result = run(os.path.join(ROOT, "cases", scene), law, settings)
            start = max(result.start, numpy.abs(result["external"]).max())
            taken = (result["contact"] + result["walls"])
            forces = [abs(result[column]).max() for column in result.history if column.startswith(("force.", "wall.", "plane.", "floor."))]
            values[law] = (f"{taken[-1] / start:.2e}; {min(0.0, taken.min() / start):.0e}; {result.summary['contact']['iterations_mean']:.1f}; "
                           f"{result.summary['contact']['steps_at_limit']}; {result.contact_seconds:.2f}; "
                           + (f"{max(forces):.4g}" if forces else "-"))
        rows.append((name, values))
    table("case: energy taken by contact and walls; least; iterations; steps at the limit; seconds in contact; greatest force", rows)


def boxes(seeds=range(1, 101), end=0.06):
    """Random boxes that fall on each other: what contact gives at most, over the energy of the start."""
    rows, figures = [], {law: {} for law in LAWS}
    for seed in seeds:
        scene = falling_boxes.scene(seed, end).replace("output:", "history: {every: 1.0e-6}\noutput:")
        for law in LAWS:
            result = run(scene, law, codes=(0, 3))  # coarse boxes at these speeds may fold, with either law
            figures[law][seed] = (result.given, result.summary["contact"]["steps_at_limit"], result.summary["contact"]["iterations_mean"],
                                  result["contact"][-1] / result.start, result.summary["energy"]["error_ratio"], result.contact_seconds)
    for name, index, kind in (("largest energy given", 0, max), ("steps at the limit, in all", 1, sum), ("iterations, mean", 2, numpy.mean),
                              ("energy taken by contact, mean", 3, numpy.mean), ("energy error, largest", 4, max), ("seconds in contact", 5, sum)):
        rows.append((name, {law: f"{kind([f[index] for f in figures[law].values()]):.3g}" for law in LAWS}))
    rows.append(("scenes above 1e-4", {law: str([seed for seed, f in figures[law].items() if f[0] > 1e-4]) for law in LAWS}))
    table(f"{len(seeds)} scenes of random boxes", rows)


PARTS = {"bars": equal_bars, "steps": small_steps, "plates": plates, "unlike": unlike_plates, "stasio": stasio, "lengths": lengths, "flow": flow, "cradles": cradles, "wall": on_wall, "rigid": rigid, "rest": rest, "cases": cases, "boxes": boxes}


def main():
    chosen = sys.argv[1:] or list(PARTS)
    for name in chosen:
        if name not in PARTS:
            sys.exit(f"impact_table: unknown name '{name}'; expected {', '.join(PARTS)}")
    for name in chosen:
        PARTS[name]()


if __name__ == "__main__":
    main()
