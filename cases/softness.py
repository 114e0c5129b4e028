#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Softness of contact rows over all cases: error, energy, iterations and time, as the table of cases/README.md.

    scripts/tables cases    fills the table there, once the results of a complete run are stored in cases/results.json

    cases/softness.py [--softness 0,0.002,0.01,0.05] [--only NAME,...] [--repeat 3] [--work DIR] [--brunt PROGRAM]

Runs every scene on one rank with each softness in turn, as many times as asked for (once where a run takes long),
and prints the table. Times are processor seconds less those of a run of one step, the least of all runs: other work on the
machine matters less to them.
Scenes whose state is the same with any softness are named in one line. Each finished scene is kept in DIR/results.json, and
a later call runs only what is missing there.
"""
import argparse
import glob
import importlib.util
import json
import os
import random
import resource
import shutil
import statistics
import subprocess
import sys

import numpy
import yaml

sys.dont_write_bytecode = True
CASES = os.path.dirname(os.path.abspath(__file__))
PROJECT = os.path.dirname(CASES)
sys.path.insert(0, os.path.join(CASES, "support"))
import results  # noqa: E402
from case_check import Result, SceneLoader, _override  # noqa: E402
from overlap import Bodies  # noqa: E402

STEEL = {"model": "elastic", "density": 7800, "young": 2.0e11, "poisson": 0.3}
ALUMINIUM = {"model": "elastic", "density": 2700, "young": 6.9e10, "poisson": 0.3}
HEADER = ["scene", "softness", "error (of what)", "penetration", "contact takes", "gives back at most", "iterations, mean and most",
          "steps at the limit", "time over that with 0"]
SHORTEST = 0.25  # runs of less processor time [s] are not compared
RUBBER = {"model": "neo_hookean", "density": 1000, "young": 1.0e6, "poisson": 0.45}


def check_of(case):
    """The check.py of a case as a module: its references are used, it runs nothing."""
    spec = importlib.util.spec_from_file_location(f"check_{case}", os.path.join(CASES, case, "check.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def box(part, size, elements, at=(0, 0, 0), rotate=None):
    entry = {"part": part, "size": list(size), "elements": list(elements), "at": list(at)}
    return {"box": {**entry, **({"rotate": rotate} if rotate else {})}}


# ---- errors: error(scene, result, rigid) with the result of softness 0 on the same mesh ----

def by_check(case, quantity):
    return lambda scene, result, rigid: abs(check_of(case).errors(scene, result)[quantity])


def cubes_force(scene, result, rigid):
    check = check_of("cubes")
    sound = ((check.BULK + 4 / 3 * check.SHEAR) / check.DENSITY)**0.5
    time, impulse = result.history["time"], numpy.abs(result.history["impulse_force.z"])
    mean = (impulse[-2] - impulse[0]) / (time[-2] - time[0])
    return abs(mean / (check.DENSITY * sound * check.SPEED / 2 * 4 * check.FACE) - 1)


def stack_force(scene, result, rigid):
    """Largest deviation of the mean forces under the cubes from the weight above, over the last quarter."""
    boxes = [entry["box"] for entry in scene["mesh"]]
    material = scene["materials"][scene["parts"][boxes[0]["part"]]["material"]]
    weight = material["density"] * numpy.prod(boxes[0]["size"]) * -scene["gravity"]["vector"][2]
    time = result.history["time"]
    since, worst = int(0.75 * len(time)), 0.0
    for k in range(len(boxes)):
        impulse = numpy.abs(result.history[f"impulse_f{k}.z"])
        force = (impulse[-1] - impulse[since]) / (time[-1] - time[since])
        worst = max(worst, abs(force / ((len(boxes) - k) * weight) - 1))
    return worst


def pile_depth(scene, result, rigid):
    side = scene["mesh"][0]["box"]["size"][0]
    return Bodies(result).deepest(scene["run"]["end"])[0] / side


def ring_depth(scene, result, rigid):
    tube = scene["mesh"]["tube"]
    ring = check_of("ring_crush").Ring(result, tube["inner_radius"])
    layer = (tube["outer_radius"] - tube["inner_radius"]) / tube["elements"][0]
    return max(ring.deepest(record).max() for record in range(len(ring.times))) / layer


def impulse_from_rigid(scene, result, rigid):
    ours, reference = result.last("impulse_force.z"), rigid.last("impulse_force.z")
    return abs(ours / reference - 1)


def top_stirs(scene, result, rigid):
    """Kinetic energy of the last tenth over m g h."""
    boxes = [entry["box"] for entry in scene["mesh"]]
    density = scene["materials"]["m"]["density"]
    fall = sum(density * numpy.prod(b["size"]) for b in boxes) * -scene["gravity"]["vector"][2] * boxes[0]["size"][2]
    kinetic = result.history["kinetic"]
    return numpy.abs(kinetic[int(0.9 * len(kinetic)):]).max() / fall


def velocity_from_rigid(part):
    """Difference of a body's last velocity, as a share of the speed it had at first."""
    def error(scene, result, rigid):
        last = [numpy.array([run.last(f"{part}.{c}") for c in "xyz"]) for run in (result, rigid)]
        first = numpy.array([rigid.history[f"{part}.{c}"][0] for c in "xyz"])
        return numpy.linalg.norm(last[0] - last[1]) / numpy.linalg.norm(first)
    return error


# ---- scenes of this table alone ----

def askew(lower, upper):
    """An impact of blocks whose meshes meet at 7 degrees, as in tests/hard/two_pass_test.cpp."""
    return {"units": "SI", "materials": {"m": ALUMINIUM}, "parts": {"lower": {"material": "m"}, "upper": {"material": "m"}},
            "mesh": [box("lower", [0.02, 0.02, 0.008], [lower, lower, 2 * lower // 5]),
                     box("upper", [0.016, 0.016, 0.008], [upper, upper, upper // 2], [0.002, 0.001, 0.00801],
                         {"axis": [0, 0, 1], "degrees": 7})],
            "initial": [{"part": "upper", "velocity": [10, 0, -40]}],
            "contact": [{"between": ["lower", "upper"], "passes": "two"}],
            "probes": [{"name": "force", "contact": ["lower", "upper"]}], "run": {"end": 6e-6}, "history": {"every": 1e-7}}


def pressed(lower, upper):
    """The same blocks, the lower one's foot held, pressed six times."""
    scene = askew(lower, upper)
    scene["mesh"][1]["box"]["at"][2] = 0.008
    pulses = [[5.0e-5 * k, (0 if k == 0 else 1 if k % 2 else 0.02)] for k in range(11)]
    del scene["initial"]
    scene.update({"fixed": [{"set": "lower_zmin", "dofs": ["x", "y", "z"]}], "curves": {"c": pulses},
                  "pressure": [{"set": "upper_zmax", "value": 2.0e8, "curve": "c"}], "run": {"end": 5e-4},
                  "history": {"every": 1e-7}})
    return scene


def turned_cubes():
    """Three rubber cubes at rest on each other, turned, with friction."""
    mesh = [box(f"c{k}", [0.1, 0.1, 0.1], [3 + k % 2] * 3, at, {"axis": [0, 0, 1], "degrees": degrees})
            for k, (degrees, at) in enumerate([(0, [0, 0, 0]), (20, [0.02, -0.02, 0.1]), (65, [0.075, -0.025, 0.2])])]
    return {"units": "SI", "materials": {"m": {**RUBBER, "young": 1.0e7, "poisson": 0.3}}, "mesh": mesh,
            "parts": {f"c{k}": {"material": "m"} for k in range(3)}, "gravity": {"vector": [0, 0, -9.81]},
            "damping": {"alpha": 60, "from": 0, "to": 0.5}, "run": {"end": 0.8}, "history": {"every": 2e-3},
            "rigid_walls": [{"name": "floor", "point": [0, 0, 0], "normal": [0, 0, 1], "friction": 0.5}],
            "contact": [{"between": "all", "self": False, "passes": "two", "friction": 0.5}],
            "probes": [{"name": "f0", "wall": "floor"}, {"name": "f1", "contact": ["c0", "c1"]}, {"name": "f2", "contact": ["c1", "c2"]}]}


def random_impact(seed):
    """Cubes of random meshes and attitudes run into each other, after tests/hard/random_impacts_test.cpp."""
    dice, side = random.Random(seed), 0.1
    steel, speed = seed % 2 == 0, 50 if seed % 2 == 0 else 10
    toward = numpy.array([1, dice.choice([0, 0.3, 1]), dice.choice([0, 0, 1])])
    toward = toward / numpy.linalg.norm(toward)

    def turned(name, count, degrees):
        axis = numpy.array([dice.choice([0.0, 1, -1]), dice.choice([0.0, 1]), 1])
        unit, angle = axis / numpy.linalg.norm(axis), numpy.radians(degrees)
        corners = side * numpy.array([[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
        corners = (corners * numpy.cos(angle) + numpy.cross(unit, corners) * numpy.sin(angle)
                   + numpy.outer(corners @ unit, unit) * (1 - numpy.cos(angle)))
        return box(name, [side] * 3, [count] * 3, [0, 0, 0], {"axis": axis.tolist(), "degrees": degrees}), corners
    (one, first), (two, second) = (turned("one", dice.choice([2, 3, 4]), dice.choice([0, 1, 10, 45])),
                                   turned("two", dice.choice([2, 3, 4]), dice.choice([0.5, 5, 20, 45])))
    aside = numpy.array([dice.choice([0, 0.003, 0.03]), dice.choice([0, 0.02, 0.045]), dice.choice([0, 0.003, -0.05])])
    aside = aside + first.mean(axis=0) - second.mean(axis=0)
    aside = aside - aside @ toward * toward
    two["box"]["at"] = (aside + ((first @ toward).max() - (second @ toward).min() + 1e-3) * toward).tolist()
    return {"units": "SI", "materials": {"m": STEEL if steel else RUBBER}, "mesh": [one, two],
            "parts": {"one": {"material": "m"}, "two": {"material": "m"}},
            "initial": [{"part": "two", "velocity": (-speed * toward).tolist()}],
            "contact": [{"between": "all", "self": False, "passes": "two"}],
            "probes": [{"name": "two", "part": "two", "field": "velocity"}],
            "run": {"end": 2e-4 if steel else 3e-2}, "history": {"every": 1e-6 if steel else 1e-4}}


def seam():
    """A block slides over the seam of two others of unlike meshes."""
    rubber = {"model": "neo_hookean", "density": 1100, "bulk": 1.0e8, "shear": 1.0e7}
    return {"units": "SI", "materials": {"r": rubber}, "parts": {p: {"material": "r"} for p in "abc"},
            "mesh": [box("a", [0.1, 0.1, 0.05], [5, 5, 3]), box("c", [0.1, 0.1, 0.05], [7, 7, 3], [0.1, 0, 0]),
                     box("b", [0.05, 0.05, 0.05], [3, 3, 3], [0.01, 0.02, 0.05])],
            "fixed": [{"set": f"{p}_zmin", "dofs": ["x", "y", "z"]} for p in "ac"], "gravity": {"vector": [0, 0, -200]},
            "initial": [{"part": "b", "velocity": [8, 0.5, 0]}],
            "contact": [{"between": "all", "passes": "two", "friction": 0.02}],
            "probes": [{"name": "b", "part": "b", "field": "velocity"}], "run": {"end": 1.5e-2}, "history": {"every": 1e-4}}


class Scene:
    """What is run: a scene of a case or one made here, with overrides; what its error is."""

    def __init__(self, source, error, what, overrides=None, slow=False, energy=True):
        self.source, self.error, self.what, self.overrides, self.slow = source, error, what, overrides or {}, slow
        self.energy = energy  # is there any in the bodies to compare with
        self.several = source if isinstance(source, list) else [source]


def patch(lower, upper, rows=3, **more):
    meshes = {f"mesh.{k}.box.elements": [n, rows, 1] for k, n in enumerate((lower, upper))}
    return Scene("patch_test/scene.yaml", by_check("patch_test", "greatest stress error"), "stress, even pressure",
                 {**meshes, "contact.0.passes": "two", "contact.0.slave": "auto", **more})


SCENES = {
    "patch_test 2:3": patch(2, 3), "patch_test 3:5": patch(3, 5), "patch_test 4:7": patch(4, 7), "patch_test 3:4": patch(3, 4),
    "patch_test 16:24": patch(16, 24, 24),
    "cubes": Scene("cubes/scene.yaml", cubes_force, "mean force, d'Alembert"),
    "two balls 16:19": Scene("hertz_impact/two_spheres.yaml", by_check("hertz_impact", "force"), "force, Hertz",
                             {"mesh.0.sphere.elements": 16, "mesh.1.sphere.elements": 19}, slow=True),
    "incline plate": Scene("incline/plate.yaml", by_check("incline", "acceleration"), "acceleration, Coulomb"),
    "stack": Scene("stack/scene.yaml", stack_force, "forces, weight", slow=True),
    "pile eight": Scene("pile/eight.yaml", pile_depth, "depth at rest / side", slow=True),
    "ring_crush": Scene("ring_crush/scene.yaml", ring_depth, "depth / element", slow=True),
    "rigid_stack 2000 steps": Scene("rigid_stack/scene.yaml", stack_force, "forces, weight",
                                     {"run.steps": 2000, "history.every": 5e-3}, slow=True, energy=False),
    "askew 10:8": Scene(askew(10, 8), impulse_from_rigid, "impulse, from softness 0"),
    "askew 20:16": Scene(askew(20, 16), impulse_from_rigid, "impulse, from softness 0"),
    "askew 40:32": Scene(askew(40, 32), impulse_from_rigid, "impulse, from softness 0"),
    "pressed six times 5:4": Scene(pressed(5, 4), None, ""),
    "turned cubes at rest": Scene(turned_cubes(), top_stirs, "kinetic energy / m g h"),
    "seam": Scene(seam(), velocity_from_rigid("b"), "velocity, from softness 0"),
    "random impacts (8)": Scene([random_impact(seed) for seed in range(1, 9)], velocity_from_rigid("two"),
                                 "velocity, from softness 0, mean"),
}
# shortened where the whole would say the same
OTHERS = {"bar_impact/scene.yaml": {}, "block_impact/scene.yaml": {"run.end": 0.01}, "sphere_plate/scene.yaml": {"run.cfl": 0.5},
          "two_blocks/scene.yaml": {}, "tied_bars/scene.yaml": {}, "removal/bared.yaml": {},
          "rolling_ball/plate.yaml": {"run.end": 0.05},
          "rigid_punch/scene.yaml": {"mesh.1.box.elements": [24, 24, 12], "mesh.0.sphere.elements": 12, "run.end": 0.006}}


class Runner:
    def __init__(self, brunt, work):
        self.brunt, self.work = brunt, work
        os.makedirs(work, exist_ok=True)

    def load(self, source, overrides):
        if isinstance(source, dict):
            tree = json.loads(json.dumps(source))
        else:
            with open(os.path.join(CASES, source), encoding="utf-8") as stream:
                tree = yaml.load(stream, SceneLoader)
        for path, value in overrides.items():
            _override(tree, path.split("."), value)
        return tree

    def run(self, source, overrides, name):
        out = os.path.join(self.work, "".join(c if c.isalnum() or c in "._" else "_" for c in name))
        shutil.rmtree(out, ignore_errors=True)
        file = source
        if isinstance(source, dict):
            file = out + ".yaml"
            with open(file, "w", encoding="utf-8") as stream:
                json.dump(source, stream)
        else:
            file = os.path.join(CASES, source)
        command = [os.path.join(PROJECT, "scripts/run"), "-np", "1", file, "--out", out, "--quiet"]
        for key, value in overrides.items():
            command += ["--set", f"{key}={json.dumps(value)}"]
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "BRUNT": self.brunt}, check=False)
        if done.returncode not in (0, 3):
            sys.exit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
        if done.returncode != 0:
            return None
        result = Result(out)
        result.seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        return result


def energy_of(result):
    """What contact has taken at the end, and the most that it has given back of what it had taken, over what is in the bodies."""
    history = result.history
    scale, contact = (history["kinetic"] + history["internal"]).max(), history["contact"]
    return contact[-1] / scale, (numpy.maximum.accumulate(numpy.maximum(contact, 0)) - contact).max() / scale


def figures(runner, scene, softness, name, times):
    """Of one scene and softness values: a dict a value; runs interleaved."""
    found = {s: [] for s in softness}
    for k, source in enumerate(scene.several):
        results, seconds = {}, {s: [] for s in softness}
        start = runner.run(source, {**scene.overrides, "run.steps": 1}, f"{name}_{k}_start").seconds
        for turn in range(times if len(scene.several) == 1 else 1):
            for s in softness if turn % 2 == 0 else reversed(softness):
                result = runner.run(source, {**scene.overrides, "contact.0.softness": s}, f"{name}_{k}_{s}")
                if result:
                    results[s] = result
                    seconds[s].append(result.seconds - start)
        for s, result in results.items():
            tree, contact = runner.load(source, scene.overrides), result.summary["contact"]
            taken, given = energy_of(result)
            found[s].append({"error": float(scene.error(tree, result, results[0])) if scene.error else None, "taken": taken,
                             "given": given, "mean": contact["iterations_mean"], "max": contact["iterations_max"],
                             "limit": contact["steps_at_limit"], "time": min(seconds[s]),
                             "depth": result.summary["max_penetration"], "books": result.summary["energy"]["error_ratio"],
                             "hash": result.summary["state_hash"], "steps": result.summary["steps"]})
    joined = {}
    for s, runs in found.items():
        if not runs:
            continue
        mean = lambda key: statistics.fmean(run[key] for run in runs)  # noqa: E731
        joined[str(s)] = {"error": mean("error") if scene.error else None, "worst": max((run["error"] or 0) for run in runs),
                          "taken": mean("taken"), "given": max(run["given"] for run in runs), "mean": mean("mean"),
                          "max": max(run["max"] for run in runs), "limit": sum(run["limit"] for run in runs),
                          "time": sum(run["time"] for run in runs), "depth": max(run["depth"] for run in runs),
                          "books": max(run["books"] for run in runs), "hash": "".join(run["hash"] for run in runs),
                          "steps": sum(run["steps"] for run in runs), "runs": len(runs)}
    return joined


def cells(name, scene, softness, of):
    for s in softness:
        run, rigid = of.get(str(s)), of.get(str(softness[0]))
        if run is None:
            yield [name, f"{s:g}", "stopped by a guard", "", "", "", "", "", ""]
            continue
        error = "" if run["error"] is None else f"{run['error']:.2g} ({scene.what})"
        ratio = f"{run['time'] / rigid['time']:.2f}" if rigid and rigid["time"] >= SHORTEST else ""
        energy = [f"{run['taken']:.1e}", f"{run['given']:.1e}"] if scene.energy else ["", ""]
        yield [name, f"{s:g}", error, f"{run['depth']:.1e}", *energy,
               f"{run['mean']:.1f}, {run['max']}", str(run["limit"]), ratio]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--softness", default="0,0.002,0.01,0.05", help="the first is what times are compared with")
    parser.add_argument("--only", default="", help="names of scenes")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--work", default=os.path.join(PROJECT, "build/softness"))
    parser.add_argument("--brunt", default=os.path.join(PROJECT, "build/release/brunt"))
    given = parser.parse_args()
    softness = [float(word) for word in given.softness.split(",")]
    softness = [int(s) if s == int(s) else s for s in softness]
    runner, kept = Runner(os.path.abspath(given.brunt), os.path.abspath(given.work)), {}
    book = os.path.join(runner.work, "results.json")
    if os.path.exists(book):
        with open(book, encoding="utf-8") as stream:
            kept = json.load(stream)
    only = [name for name in given.only.split(",") if name]
    others = {name: Scene(name, None, "", overrides, slow=True) for name, overrides in OTHERS.items()}
    table, alike = [], []
    for name, scene in {**SCENES, **others}.items():
        if only and name not in only:
            continue
        values = softness if name in SCENES else [0, 0.05]
        if any(str(s) not in kept.get(name, {}) for s in values):
            kept[name] = figures(runner, scene, values, name, 1 if scene.slow else given.repeat)
            with open(book, "w", encoding="utf-8") as stream:
                json.dump(kept, stream, indent=1)
            print(name, {s: (run["error"], run["max"], round(run["time"], 2)) for s, run in kept[name].items()}, file=sys.stderr, flush=True)
        if len({run["hash"] for run in kept[name].values()}) == 1:
            alike.append(name)
        else:
            table += cells(name, scene, values, kept[name])
    print("| " + " | ".join(HEADER) + " |\n" + "|---" * len(HEADER) + "|")
    for row in table:
        print("| " + " | ".join(row) + " |")
    if not only:
        path = os.path.join(CASES, "results.json")
        stored = results.record(PROJECT, "cases/softness.py", tables={"softness": {"header": HEADER, "rows": table}})
        results.save(path, {**results.load(path), "softness": stored})
    print(f"\nThe same bits with any softness: {', '.join(alike)}.")


if __name__ == "__main__":
    main()
