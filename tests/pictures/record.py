#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the scenes behind the figures of the theory pages and stores what is plotted in data/NAME.csv.

usage: tests/pictures/record.py all|NAME...      (BRUNT: the program; without it scripts/run finds or builds it)

Each file begins with a comment that names the scene, the commit and the date. plots.py draws from these files alone.
"""
import argparse
import datetime
import importlib.util
import itertools
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "../..")
SCENES, DATA = os.path.join(HERE, "scenes"), os.path.join(HERE, "data")


class Result:
    def __init__(self, folder):
        with open(os.path.join(folder, "history.csv"), encoding="utf-8") as stream:
            names = [column.split(" [")[0] for column in stream.readline().rstrip("\n").split(",")]
            table = np.atleast_2d(np.genfromtxt(stream, delimiter=","))
        self.history = dict(zip(names, table.T))
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as stream:
            self.summary = json.load(stream)


def run(scene, **changes):
    """Runs a scene of this folder or of cases; changes: values by key path, with __ for points."""
    path = os.path.join(SCENES, scene) if os.path.exists(os.path.join(SCENES, scene)) else os.path.join(ROOT, "cases", scene)
    command = [os.path.join(ROOT, "scripts/run"), "-np", "1", path, "--force", "--quiet"]
    for key, value in changes.items():
        command += ["--set", f"{key.replace('__', '.')}={json.dumps(value)}"]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(command + ["--out", folder], check=True, stdout=subprocess.DEVNULL)
        return Result(folder)


def store(name, scene, columns, rows):
    commit = subprocess.run(["git", "-C", ROOT, "rev-parse", "--short", "HEAD"], check=False, capture_output=True,
                            text=True).stdout.strip()
    os.makedirs(DATA, exist_ok=True)
    with open(os.path.join(DATA, name + ".csv"), "w", encoding="utf-8") as stream:
        stream.write(f"# {scene}; commit {commit}; {datetime.date.today()}\n{','.join(columns)}\n")
        for row in rows:
            stream.write(",".join(cell if isinstance(cell, str) else f"{cell:.6g}" for cell in row) + "\n")


# --- one function a file ----------------------------------------------------------------------------------------------

def stable_step():
    rows = []
    for n in (1, 2, 3, 4, 6, 8, 12, 16, 24):
        steps = [run("stable_step.yaml", mesh__box__elements=[n] * 3, mesh__box__size=[n] * 3,
                     run__step_bound=bound).history["dt"][0] for bound in ("element", "assembled")]
        rows.append([n, *steps])
    store("stable_step", "stable_step.yaml, n^3 elements of edge 1, c = 1", ["n", "element", "assembled"], rows)


def enforcement():
    """Iterations that the first contact step of an impact takes to a tolerance, and the residual that it ends with."""
    rows = []
    for passes, method, softness, friction in [("one", "rate", 0, 0), ("one", "row_sum", 0, 0), ("one", "rate", 0, 0.3),
                                               ("two", "rate", 0, 0), ("two", "row_sum", 0, 0)]:
        for tolerance in (0.3, 0.1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10):
            result = run("impact.yaml", enforcement__tolerance=tolerance, enforcement__method=method,
                         enforcement__softness=softness, contact__0__passes=passes, contact__0__friction=friction)
            contact = result.summary["contact"]
            if contact["steps_at_limit"] > 0:
                break
            rows.append([passes, method, friction, contact["iterations_max"], contact["residual_max"]])
    store("enforcement", "impact.yaml, first step", ["passes", "method", "friction", "iterations", "residual"], rows)


def friction():
    laws = {"coulomb": 0.2, "decay": {"static": 0.3, "kinetic": 0.2, "decay": 300}}
    rows = []
    for name, law in laws.items():
        h = run("friction.yaml", rigid_walls__0__friction=law).history
        time, tangent, normal = h["time"], h["impulse_floor.x"], h["impulse_floor.z"]
        mean = (np.diff(tangent) / np.diff(time), np.diff(normal) / np.diff(time))
        rows += [[name, *row] for row in zip(0.5 * (time[1:] + time[:-1]), *mean, h["block.x"][1:])]
    store("friction", "friction.yaml", ["law", "time", "tangential", "normal", "velocity"], rows)


def lag():
    """A block on an incline of 30 degrees with friction 0.5, with and without a lag."""
    rows = []
    leaning = [9.81 * 0.5, 0, -9.81 * np.sqrt(0.75)]
    for name, law in {"without": 0.5, "with": {"static": 0.5, "lag": 2.6e-3}}.items():
        h = run("incline/scene.yaml", gravity__vector=leaning, rigid_walls__0__friction=law).history
        rows += [[name, *row] for row in zip(h["time"], h["incline.x"], h["incline.z"], h["block.x"])]
    store("friction_lag", "cases/incline, 30 degrees, 0.5", ["lag", "time", "tangential", "normal", "velocity"], rows)


def ties():
    h = run("tied_bars/scene.yaml").history
    every = 5
    time, tie, blow = (h[key][::every] for key in ("time", "impulse_tie.x", "impulse_blow.x"))
    store("ties", "cases/tied_bars", ["time", "tie", "blow"],
          zip(0.5 * (time[1:] + time[:-1]), np.diff(tie) / np.diff(time), np.diff(blow) / np.diff(time)))


def bending():
    """Deflection of the tip by element, layers of elements and elements along the beam."""
    rows = []
    for along, layers in itertools.product((10, 40), (1, 2, 4, 8)):
        for label, element, kind in [("hex8 without control", "hex8", "none"), ("hex8", "hex8", "stiffness"),
                                     ("hex8_full", "hex8_full", None), ("hex8_bbar", "hex8_bbar", None)]:
            if kind == "none" and layers == 1:
                continue  # a mechanism
            part = {"material": "steel", "element": element} | ({"hourglass": {"kind": kind}} if kind else {})
            result = run("bending.yaml", mesh__box__elements=[along, 1, layers], parts__beam=part)
            rows.append([label, along, layers, -result.history["tip.z"][0]])
    store("bending", "bending.yaml", ["element", "along", "layers", "deflection"], rows)


def mean_force(h, force, displacement):
    """Mean of each interval between two rows, with the displacement in its middle."""
    return zip(0.5 * (h[displacement][1:] + h[displacement][:-1]), np.diff(h[force]) / np.diff(h["time"]))


def material():
    rows = []
    for kinematic in (0, 1):
        h = run("cyclic.yaml", materials__m__kinematic=kinematic).history
        rows += [["cyclic", kinematic, *row] for row in mean_force(h, "impulse_pull.x", "end.x")]
    for rate in ("jaumann", "logarithmic"):
        h = run("shear.yaml", materials__m__stress_rate=rate).history
        rows += [["shear", rate, *row] for row in mean_force(h, "impulse_pull.x", "top.x")]
    h = run("foam.yaml").history
    rows += [["foam", 0, *row] for row in mean_force(h, "impulse_push.z", "top.z")]
    store("material", "cyclic.yaml, shear.yaml, foam.yaml", ["path", "kind", "strain", "stress"], rows)


def case_module(case):
    """The closed forms in the check of a case, without its main()."""
    path = os.path.join(ROOT, "cases", case, "check.py")
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    spec = importlib.util.spec_from_loader(case, loader=None)
    module = importlib.util.module_from_spec(spec)
    module.__file__ = path
    exec(compile(text.rsplit("\nmain()", 1)[0], path, "exec"), module.__dict__)  # pylint: disable=exec-used
    return module


def rigid():
    check = case_module("rigid_top")
    size, mass = np.array([0.6, 0.4, 0.2]), 7800 * 0.6 * 0.4 * 0.2
    axis = np.array([1, 0, 0.81])
    top = check.Top(mass / 12 * (size @ size - size**2), 10 * axis / np.linalg.norm(axis))
    errors, rows = [], []
    for step in (4.0e-3, 2.0e-3, 1.0e-3, 5.0e-4):
        result = run("rigid_top/scene.yaml", run__step=step)
        errors.append([step, *check.errors_of(result, top)])
        if step != 2.0e-3:
            continue
        h = result.history
        in_body = [check.rotation(t).T @ w for t, w in zip(check.vectors(result, "turn"), check.vectors(result, "spin"))]
        l = check.vectors(result, "momentum")
        rows = [[t, *w, (e - h["kinetic"][0]) / h["kinetic"][0], d] for t, w, e, d in
                zip(h["time"], in_body, h["kinetic"], np.linalg.norm(l - l[0], axis=1) / np.linalg.norm(l[0]))]
    store("rigid_motion", "cases/rigid_top", ["time", "spin_x", "spin_y", "spin_z", "energy", "momentum"], rows)
    store("rigid_order", "cases/rigid_top", ["step", "spin", "orientation"], errors)


TURN = np.linalg.qr(np.array([[1, 0.4, 0.7], [-0.3, 1, 0.5], [-0.6, -0.5, 1]]))[0]


def plates(points):
    """Two facing plates, edges 1 : 0.93: nodes of the one, corners of the faces of the other, edge of the nodes' mesh."""
    k = round(points**0.5)
    faces, h = round(0.93 * k), 1 / (k - 1)
    nodes = np.array([(i * h, j * h, 0) for j in range(k) for i in range(k)])
    e = 1 / faces
    corner = np.array([(0, 0, 0), (e, 0, 0), (e, e, 0), (0, e, 0)])
    place = np.array([(i * e, j * e, 0.05 * h) for j in range(faces) for i in range(faces)])
    return nodes, place[:, None, :] + corner, h


def rod(points):
    """The four sides of a square rod, 1000 times as long as wide, in a sleeve; 24 nodes and faces far away."""
    width = 1e-3
    across = max(2, round((points * width / 4) ** 0.5))
    along, h = round(points / (4 * across)), width / across
    x = np.linspace(0, 1, along)
    side = np.array([(u, v * h, 0) for u in x for v in range(across)])
    e = np.array([(0, 0, 0), (x[1], 0, 0), (x[1], h, 0), (0, h, 0)])
    sides, faces = [], []
    for y, z in ((1, 2), (2, 1)):
        for level in (0, width):
            order = [0, y, z]
            sides.append(side[:, order] + level * np.eye(3)[3 - order.index(1)])
            faces.append((side[:, None, :] + e + [0.5 * x[1], 0.5 * h, 0.05 * h])[:, :, order] + level * np.eye(3)[3 - order.index(1)])
    nodes, corners = np.concatenate(sides), np.concatenate(faces)
    far = np.random.default_rng(1).uniform(-1000, 1000, (24, 3))
    return np.concatenate([nodes, far]), np.concatenate([corners, far[:, None, :] + corners[0] - corners[0, 0]]), h


def write_search(scene, points, path):
    """All turned askew; capture boxes reach a tenth of an edge beyond the faces."""
    nodes, corners, edge = scene(points)
    nodes, corners = nodes @ TURN.T, corners @ TURN.T
    boxes = np.hstack([corners.min(1) - 0.1 * edge, corners.max(1) + 0.1 * edge])
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(f"scene1 {scene.__name__} {len(nodes)} {len(boxes)}\n")
        np.savetxt(stream, nodes, fmt="%.9g")
        np.savetxt(stream, boxes, fmt="%.9g " * 6 + "-1 -1 -1 -1")


def search():
    rows = []
    program = os.environ.get("BRUNT", os.path.join(ROOT, "build/brunt"))
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.txt")
        for scene, points in itertools.product((plates, rod), (1000, 3000, 10000, 30000, 100000)):
            write_search(scene, points, path)
            for method in ("blocks", "bucket", "binary"):
                slow = (scene, method) == (rod, "bucket")
                if slow and points > 30000:
                    continue  # minutes: its buckets hold too many points
                repeat = 1 if slow and points > 3000 else max(10, 500000 // points)
                command = [program, "search", path, "--method", method, "--repeat", str(repeat)]
                a = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
                rows.append([scene.__name__, method, a["nodes"], a["pairs"], 1e3 * a["build_s"], 1e3 * a["query_s"]])
    store("search", "plates and a rod, least of 10 runs or more (one of the rod by buckets)",
          ["scene", "method", "nodes", "pairs", "build_ms", "query_ms"], rows)


def depth_samples():
    program = os.environ.get("BENCH_DEPTH_SAMPLES", os.path.join(ROOT, "build/release/tests/bench/bench_depth_samples"))
    queries = 40
    done = subprocess.run([program, str(queries)], check=True, capture_output=True, text=True).stdout.splitlines()
    rows = [[cell if k < 3 else float(cell) for k, cell in enumerate(line.split(","))] for line in done[1:]]
    store("depth_samples", f"tests/bench/bench_depth_samples, {queries} random queries a pair; CPU times of one machine", done[0].split(","), rows)


ALL = {f.__name__: f for f in (stable_step, enforcement, friction, lag, ties, bending, material, rigid, search, depth_samples)}

if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="+", choices=["all", *ALL], metavar="NAME", help=f"all or {', '.join(ALL)}")
    names = parser.parse_args().names
    for chosen in ALL if "all" in names else names:
        print(chosen, flush=True)
        ALL[chosen]()
    sys.exit(0)
