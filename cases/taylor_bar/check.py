#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Taylor bar: face radius and length after the impact against converged published values; order in the mesh size."""
import os
import sys

import h5py
import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

SOURCE = "Foulk et al. 2021; Sierra/SM, Carina"
# For a bar of radius 3.2 mm: the face 7.22 mm, the length 21.43 mm. Similar bars scale with the radius; what makes two
# bars similar is below (length over radius, rho v^2 / yield, E / yield, H / yield, poisson, v t / radius).
RADIUS, FACE, LENGTH = 3.2e-3, 7.22e-3, 21.43e-3
SIMILAR = {"slenderness": 32.4 / 3.2, "damage number": 8930 * 227**2 / 400e6, "E / yield": 117e9 / 400e6,
           "H / yield": 100e6 / 400e6, "poisson": 0.35, "time": 227 * 80e-6 / 3.2e-3}


def similarity(scene):
    """The scene's own numbers in place of those of the reference."""
    bar, law = scene["mesh"]["cylinder"], scene["materials"]["copper"]
    speed = numpy.linalg.norm(scene["initial"][0]["velocity"])
    return {"slenderness": bar["length"] / bar["radius"], "damage number": law["density"] * speed**2 / law["yield"],
            "E / yield": law["young"] / law["yield"], "H / yield": law["hardening"] / law["yield"],
            "poisson": law["poisson"], "time": speed * scene["run"]["end"] / bar["radius"]}


def rim_radius(result):
    """Of the nodes on the rim of the foot, at the end."""
    with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
        start = state["mesh/coordinates"][:]
        record = state[max(key for key in state if key.startswith("record"))]
        moved = start + record["node/displacement"][:]
    radius = numpy.hypot(start[:, 0], start[:, 1])
    rim = (start[:, 2] < 1e-9 * start[:, 2].max()) & (radius > (1 - 1e-9) * radius.max())
    return numpy.hypot(moved[rim, 0], moved[rim, 1])


def errors(scene, result):
    """For scripts/pareto: shares of face radius and length."""
    scale = scene["mesh"]["cylinder"]["radius"] / RADIUS
    return {"face radius": rim_radius(result).mean() / (scale * FACE) - 1,
            "length": result.last("top.z") / (scale * LENGTH) - 1}


class Bar:
    """One run: lengths in the scene's unit, energies as shares of the initial kinetic energy."""

    def __init__(self, case, name, across, overrides=None, ranks=2):
        along = 10 * across
        overrides = {"mesh.cylinder.elements": [across, along], "output.every": 80e-6, **(overrides or {})}
        self.name, self.across = name, across
        self.result = case.run(overrides=overrides, ranks=ranks, name=name.replace(" ", "_"))
        rim = rim_radius(self.result)
        self.face, self.spread = rim.mean(), numpy.ptp(rim) / rim.mean()
        self.length = self.result.last("top.z")
        energy = self.result.summary["energy"]
        self.hourglass = energy["hourglass"] / energy["total"]
        self.seconds = self.result.summary["wall_s"]

    def line(self):
        s = self.result.summary
        return [self.name, s["elements"], s["steps"], f"{1e3 * self.face:.4f}", f"{100 * (self.face / FACE - 1):+.2f} %", f"{100 * self.spread:.1f}",
                f"{1e3 * self.length:.4f}", f"{100 * (self.length / LENGTH - 1):+.2f} %", f"{100 * self.hourglass:.2f}", s["loop_s"],
                f"{s['ns_per_element_step']:.0f}"]


def assert_bar(case, bar, scale, face_gate, length_gate):
    case.assert_close(f"{bar.name}: face radius [m]", scale * FACE, bar.face, face_gate, SOURCE)
    case.assert_close(f"{bar.name}: length [m]", scale * LENGTH, bar.length, length_gate, SOURCE)
    case.assert_below(f"{bar.name}: hourglass energy, share", bar.hourglass, 0.03)
    case.assert_energy(bar.result)


def assert_order(case, bars, scale):
    """Error of the face falls with the mesh size at first order or better (least squares over the meshes)."""
    size = numpy.log([1 / bar.across for bar in bars])
    error = numpy.log([abs(bar.face - scale * FACE) for bar in bars])
    order = numpy.polyfit(size, error, 1)[0]
    case.assert_close("order of the face radius", 1.5, order, 0.75, "first order or better", absolute=True)


def assert_symmetry(case, bar):
    """No momentum across the axis, and the wall's impulse is what the bar's momentum changed by."""
    history, mass = bar.result.history, bar.result.history["mass"][-1]
    speed = numpy.linalg.norm(case.scene()["initial"][0]["velocity"])
    case.assert_close(f"{bar.name}: wall impulse [N s]", mass * speed + history["momentum_z"][-1],
                      history["impulse_wall.z"][-1], 1e-12, "change of momentum")
    sideways = max(abs(history["momentum_x"]).max(), abs(history["momentum_y"]).max())
    case.assert_below(f"{bar.name}: sideways momentum, share", sideways / (mass * speed), 1e-10, "symmetry")


def main():
    case = Case(__file__)
    case.answer(errors)
    scene = case.scene()
    for name, value in similarity(scene).items():
        if abs(value / SIMILAR[name] - 1) > 1e-6:
            case.skip(f"the published bar has {name} {SIMILAR[name]:.6g}, this scene {value:.6g}")
    scale = scene["mesh"]["cylinder"]["radius"] / RADIUS
    one_sided = {"rigid_walls.0.bilateral": False}
    bars = [Bar(case, f"hex8 {n}", n) for n in ((4, 8, 16) if case.long else (3, 4, 6))]
    gates = [(3e-2, 5e-3), (2e-2, 5e-3), (1e-2, 5e-3)] if case.long else [(4e-2, 1e-2), (3e-2, 5e-3), (1.5e-2, 5e-3)]
    for bar, gate in zip(bars, gates):
        assert_bar(case, bar, scale, *gate)
        assert_symmetry(case, bar)
    assert_order(case, bars, scale)

    n = 4
    others = [Bar(case, f"hex8_bbar {n}", n, {"parts.bar.element": "hex8_bbar"})]
    assert_bar(case, others[0], scale, 3e-2, 5e-3)
    others.append(Bar(case, f"hex8 {n} one-sided wall", n, one_sided))
    case.assert_energy(others[-1].result)
    depth = others[-1].result.summary["max_penetration"] / scene["mesh"]["cylinder"]["radius"]
    case.assert_below("one-sided wall: penetration, share of the radius", depth, 1e-12, "no node passes the wall")
    others.append(Bar(case, f"hex8_full {n}", n, {"parts.bar.element": "hex8_full"}))  # locks: reported, not gated
    case.assert_energy(others[-1].result)
    if case.long:
        soft = {"kind": "stiffness", "coefficient": 0.005}
        viscous = {"kind": "viscous", "coefficient": 0.03}
        bulk = {"linear": 0.06, "quadratic": 1.2}
        for name, change in {"hourglass 0.005": {"parts.bar.hourglass": soft},
                             "viscous hourglass 0.03": {"parts.bar.hourglass": viscous},
                             "bulk viscosity": {"parts.bar.bulk": bulk}}.items():
            others.append(Bar(case, f"hex8 8 {name}", 8, change))
        others.append(Bar(case, "hex8_bbar 4 one-sided wall", 4, {"parts.bar.element": "hex8_bbar", **one_sided}))
        others.append(Bar(case, "hex8_bbar 8", 8, {"parts.bar.element": "hex8_bbar"}))
        others.append(Bar(case, "hex8 8 one-sided wall", 8, one_sided))
    case.table("bars", ["run", "elements", "steps", "face radius [mm]", "error", "spread of the rim [%]", "length [mm]", "error", "hourglass energy [%]",
                        "loop [s]", "time per element and step [ns]"], [bar.line() for bar in bars + others])

    small = {"mesh.cylinder.elements": [2, 10], "run.end": 2.0e-5}
    case.assert_same_on_ranks((1, 2, 3, 4, 7), restarted=True, overrides=small)
    whole = case.run(overrides=small, name="whole")
    case.assert_same_after_restart(whole, 1.0e-5, overrides=small)
    case.finish()


main()
