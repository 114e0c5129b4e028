#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Impact limiters: a nose cone with nested shells that folds up on a wall, and a foam bar against the shock theory."""
import os
import sys

import h5py
import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402
from overlap import Bodies, depths, outer_quads  # noqa: E402

SHELLS = ("nose", "core", "flare")


class Foam:
    """Rigid, perfectly plastic, locking foam: a shock behind which all is crushed to the locking strain and at rest.

    Ahead of it the rest, of length L - x, is slowed by the plateau stress: rho (L - x) dv/dt = -plateau, dx/dt = v/locking.
    """

    def __init__(self, scene):
        bar, law = scene["mesh"]["box"], scene["materials"]["foam"]
        self.area, self.length = bar["size"][0] * bar["size"][1], bar["size"][2]
        (_, self.plateau), (self.locking, _) = law["yield_table"]
        self.rho, self.young = law["density"], law["young"]
        self.speed = numpy.linalg.norm(scene["initial"][0]["velocity"])
        jump = self.rho * self.speed**2 / self.locking
        self.wall = self.plateau + jump
        self.crushed = 1 - numpy.exp(-jump / (2 * self.plateau))
        self.left = self.length * (1 - self.locking * self.crushed)
        x = numpy.linspace(0, self.length * self.crushed, 20001)
        squared = self.speed**2 + 2 * self.plateau * self.locking / self.rho * numpy.log1p(-x / self.length)
        # dt = locking dx / v; with v as the variable the end, v = 0, is regular: dx = -(L - x) rho v dv / (plateau locking)
        v = numpy.sqrt(numpy.maximum(squared, 0))
        rest = self.rho * (self.length - x) / self.plateau
        self.stop = numpy.trapz(rest[::-1], v[::-1])
        self.wave = numpy.sqrt(self.young / self.rho)
        self.kick = self.plateau / (self.rho * self.wave)  # what an elastic wave of the plateau stress takes [m/s]

    def measure(self, result):
        """Wall stress at t = 0, crushed share, stop, length at the stop."""
        h = result.history
        time, impulse, momentum = h["time"], h["impulse_wall.z"] / self.area, h["momentum_z"]
        early = time < 0.65 * self.stop
        stress = numpy.polyfit(time[early], impulse[early], 4)[-2]  # slope at 0: elements crush one by one, the sum is smooth
        k = int(numpy.argmax(momentum > 0))
        stop = numpy.interp(0, momentum[k - 1:k + 1], time[k - 1:k + 1])
        with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
            record = state[max(key for key in state if key.startswith("record"))]
            crushed = ((1 - record["element/relative_volume"][:]) / self.locking).mean()
        return {"wall": stress, "crushed": crushed, "stop": stop, "left": result.at("top.z", stop)}


def foam_bar(case):
    theory = Foam(case.scene("foam.yaml"))
    meshes = (50, 100, 200, 400) if case.long else (50, 100, 200)
    found = []
    print("| foam bar, elements | wall stress [MPa] | crushed share | stop [ms] | length [mm] | steps | time [s] |\n|---|---|---|---|---|---|---|")
    print(f"| theory | {theory.wall / 1e6:.5f} | {theory.crushed:.6f} | {1e3 * theory.stop:.6f} | {1e3 * theory.left:.4f} | | |")
    for count in meshes:
        result = case.run("foam.yaml", overrides={"mesh.box.elements": [1, 1, count]}, ranks=1, name=f"foam_{count}")
        values = theory.measure(result)
        found.append(values)
        s = result.summary
        print(f"| {count} | {values['wall'] / 1e6:.4f} | {values['crushed']:.4f} | {1e3 * values['stop']:.4f} | {1e3 * values['left']:.3f} | {s['steps']} | {s['wall_s']:.1f} |")
        energy = result.summary["energy"]
        case.assert_below(f"foam {count}: energy error", energy["error_ratio"], 1e-10, "ledger")
        case.assert_close(f"foam {count}: taken by foam, viscosity, wall / kinetic energy", 1,
                          1 - energy["kinetic"] / energy["total"], 1e-2, "the bar stands")
    # Finite young: the wall stress is a staircase of waves around the theory's, of steps 2 kick out of the speed that
    # the shock has; the bar stops within one run of a wave through what is not crushed; strains are off by stress / E.
    jump = theory.wall - theory.plateau
    gates = {"wall": 2 * jump / theory.wall * theory.kick / theory.speed,
             "crushed": theory.wall / (theory.young * theory.locking) / theory.crushed * 2,
             "stop": theory.length * (1 - theory.crushed) / theory.wave / theory.stop,
             "left": theory.wall / theory.young * 2}
    front = 1.0 / meshes[-1]  # half an element at each side of the front
    for name, gate in gates.items():
        share = {"crushed": front / theory.crushed, "left": theory.locking * front, "wall": 0, "stop": 0}[name]
        case.assert_close(f"foam {meshes[-1]}: {name}", getattr(theory, name), found[-1][name], gate + share, "shock theory, P5")
    for name in ("crushed", "left"):
        error = [abs(values[name] / getattr(theory, name) - 1) for values in found]
        order = numpy.polyfit(numpy.log([1 / count for count in meshes]), numpy.log(error), 1)[0]
        print(f"observed order of {name} over {meshes}: {order:.2f}")
        case.assert_close(f"foam: order of {name}", 1, order, 0.4, "a front of a fixed number of elements", absolute=True)


def self_depth(result, time):
    """Share of the samples just outside of each shell's faces that are inside of the same shell."""
    bodies = Bodies(result)
    x, _ = bodies.positions(time)
    worst = 0
    for quads in bodies.quads[:len(SHELLS)]:
        corners = x[quads]
        normal = numpy.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
        normal /= numpy.linalg.norm(normal, axis=1)[:, None]
        outside = corners.mean(axis=1) + 0.15 * normal  # [mm]: a tenth of an element's thickness
        worst += int((depths(outside, corners) > 0).sum())
    return worst


def mirrored(result):
    """How far displacements are from those mirrored in x = y, over the largest."""
    with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
        start = state["mesh/coordinates"][:]
        record = state[max(key for key in state if key.startswith("record"))]
        moved = record["node/displacement"][:]
        block, hexes = state["mesh/element_block"][:], state["mesh/connectivity"][:]
    payload = numpy.unique(hexes[block == block.max()])
    mine = numpy.setdiff1d(numpy.arange(len(start)), payload)
    place = {tuple(numpy.round(1e4 * start[i]).astype(int)): i for i in mine}
    swap = [1, 0, 2]
    # shells may begin at the same place nowhere: each key is one node
    other = numpy.array([place[tuple(numpy.round(1e4 * start[i][swap]).astype(int))] for i in mine])
    return abs(moved[mine] - moved[other][:, swap]).max() / abs(moved).max()


def limiter(case, density=1):
    overrides = {}
    if density != 1:
        import mesh
        path = os.path.join(case.work, f"nose_{density}.inp")
        os.makedirs(case.work, exist_ok=True)
        mesh.write(path, density)
        overrides["mesh.0.file"] = path
    result = case.run(overrides=overrides, ranks=2, name=f"limiter_{density}")
    s, h, name = result.summary, result.history, f"limiter {density}"
    energy = s["energy"]
    start = h["kinetic"][0]
    absorbed = {shell: h[f"{shell}.internal"][-1] / start for shell in SHELLS}
    stop = int(numpy.argmax(h["payload.z"] >= 0)) or len(h["time"]) - 1
    print(f"| {name} | " + " | ".join(f"{key} {100 * share:.1f} %" for key, share in absorbed.items())
          + f" | friction {100 * energy['friction'] / start:.1f} % | contact {100 * energy['contact'] / start:.2f} % | walls {100 * energy['walls'] / start:.2f} % | kinetic {100 * energy['kinetic'] / start:.2f} % | "
          f"payload stops at {h['time'][stop]:.3f} ms after {-h['place.z'][stop]:.2f} mm | elements {s['elements']} | steps {s['steps']} | time {s['wall_s']:.0f} s | folded {s['folded_elements']} | "
          f"iterations {s['contact']['iterations_mean']:.1f}, {s['contact']['iterations_max']} | depth {s['max_penetration']:.1e} |")
    case.assert_below(f"{name}: energy error", energy["error_ratio"], 1e-10, "ledger")
    case.assert_below(f"{name}: momentum error", s["momentum_error"], 1e-10, "ledger")
    case.assert_within(f"{name}: energy taken by contact, share", 0, 0.01, energy["contact"] / start, "gives nothing")
    case.assert_within(f"{name}: absorbed by plastic flow and friction, share", 0.95, 1,
                       sum(absorbed.values()) + energy["friction"] / start, "nothing else takes energy")
    case.assert_below(f"{name}: kinetic energy left, share", energy["kinetic"] / start, 0.02, "the payload stands")
    case.assert_equal(f"{name}: folded elements", 0, s["folded_elements"])
    case.assert_equal(f"{name}: payload has stopped", True, bool((h["payload.z"] >= 0).any()))
    depth = max(Bodies(result).deepest(t)[0] for t in numpy.arange(0.2, 2.7, 0.4))
    case.assert_below(f"{name}: depth of a body in another [mm]", depth, 0.15, "a tenth of an element: faces are bilinear")
    case.assert_equal(f"{name}: faces in their own shell", 0, sum(self_depth(result, t) for t in (1.0, 1.8, 2.6)))
    case.assert_below(f"{name}: not its own mirror image in x = y, share", mirrored(result), 1e-3, "symmetry")
    return result


def main():
    case = Case(__file__)
    foam_bar(case)
    limiter(case)
    if case.long:
        limiter(case, 1.5)
    short = {"run.end": 0.3, "output.every": 0.3}  # the nose has folded on the wall, the core has met it
    case.assert_same_on_ranks((1, 2, 3, 4), overrides=short)
    whole = Case.run(case, overrides=short, name="whole")
    case.assert_same_after_restart(whole, 0.15, overrides=short)
    case.finish()


main()
