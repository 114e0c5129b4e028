#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Taylor rods of Johnson-Cook metals: final length and mushroom diameter against measured ones (measured.csv)."""
import csv
import os
import sys

import h5py
import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

LENGTH_GATE, FACE_GATE = 0.04, 0.10  # T3: what Johnson and Cook's own fits scatter by
# Rows of measured.csv (from 0) that the constants do not meet, see README.md; the gates that they are held to instead
# say that our result has not moved: length, diameter.
MISSES = {0: (.07, .14), 1: (.07, .14), 19: (.04, .18), 20: (.06, 0), 21: (.06, 0), 24: (.10, 0), 25: (.05, 0),
          29: (.08, 0), 38: (.06, 0), 54: (.04, .14), **{row: (.14, .10) for row in range(39, 51)}}
SOFT = (30, 31, 32)  # copper at 1230 K and more: elements fold, and a run takes minutes; not run
STUDY = {"copper": 8, "steel": 2, "aluminium": 53}  # rods with length and diameter measured, over three meshes
# The rod of scene.yaml (row 8) with 12 elements across the radius [m], what scripts/pareto measures errors from.
FINEST_FACE, FINEST_LENGTH = 15.845e-3, 15.042e-3


def measured():
    """Rows of measured.csv as {name, source, rho, T, D, L, V, length, face}: SI units, face None where not measured."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "measured.csv"), encoding="utf-8") as stream:
        rows = list(csv.reader(stream))[1:]
    milli = 1e-3
    return [{"name": r[0], "source": r[1].split(" (")[0], "rho": float(r[2]), "T": float(r[3]), "D": float(r[4]) * milli,
             "L": float(r[5]) * milli, "V": float(r[6]), "length": float(r[7]) * milli,
             "face": float(r[9]) * milli if r[9] else None} for r in rows]


def metal(name):
    return "copper" if "Cu" in name else "steel" if "4340" in name else "aluminium"


def overrides_of(row, across):
    """The scene for a row of the table; 0.75 L/V is when every rod has come off the wall."""
    material, end = metal(row["name"]), 0.75 * row["L"] / row["V"]
    return {"mesh.cylinder.radius": row["D"] / 2, "mesh.cylinder.length": row["L"],
            "mesh.cylinder.elements": [across, round(across * row["L"] / (row["D"] / 2))],
            "parts.rod.material": material, f"materials.{material}.density": row["rho"],
            f"materials.{material}.temperature": row["T"], "initial.0.velocity": [0, 0, -row["V"]],
            "run.end": end, "output.every": end, "history.every": end / 200}


def last_state(result):
    with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
        start = state["mesh/coordinates"][:]
        record = state[max(key for key in state if key.startswith("record"))]
        fields = {name: record[f"element/{name}"][:] for name in record["element"]}
        return start, start + record["node/displacement"][:], fields


def sizes(result):
    """Length of the rod and mean diameter of the rim of its foot, at the end."""
    start, moved, _ = last_state(result)
    radius = numpy.hypot(start[:, 0], start[:, 1])
    rim = (start[:, 2] < 1e-9 * start[:, 2].max()) & (radius > (1 - 1e-9) * radius.max())
    return numpy.ptp(moved[:, 2]), 2 * numpy.hypot(moved[rim, 0], moved[rim, 1]).mean()


def errors(scene, result):
    """For scripts/pareto: of the rod of scene.yaml, from the finest mesh."""
    length, face = sizes(result)
    return {"diameter": face / FINEST_FACE - 1, "length": length / FINEST_LENGTH - 1}


class Rod:
    def __init__(self, case, number, across=4, label="hex8", **overrides):
        self.number, self.row, self.across, self.label = number, measured()[number], across, label
        name = f"row{number}_{label}_{across}".replace(" ", "_")
        self.result = case.run(overrides={**overrides_of(self.row, across), **overrides}, ranks=1, name=name)
        self.length, self.face = sizes(self.result)
        self.fields = last_state(self.result)[2]
        energy = self.result.summary["energy"]
        self.hourglass = energy["hourglass"] / energy["total"]
        self.name = f"row {number}, {self.row['name']}, {self.row['V']:.0f} m/s, {label} {across}"

    def line(self):
        r, s = self.row, self.result.summary
        length, face = 100 * (self.length / r["length"] - 1), r["face"] and 100 * (self.face / r["face"] - 1)
        out = abs(length) > 100 * LENGTH_GATE or (face and abs(face) > 100 * FACE_GATE)
        foot = [f"{1e3 * r['face']:.2f}", f"{1e3 * self.face:.2f}", f"{face:+.1f} %"] if face else ["", f"{1e3 * self.face:.2f}", ""]
        return [self.number, r["name"], r["source"], f"{r['T']:.0f}", f"{1e3 * r['L']:.2f}", f"{r['V']:.0f}", f"{self.label}, {self.across}",
                f"{1e3 * r['length']:.2f}", f"{1e3 * self.length:.2f}", f"{length:+.1f} %", *foot, "**no**" if out else "yes",
                f"{100 * self.hourglass:.1f}", s["folded_elements"], s["steps"], s["loop_s"]]


def assert_ledger(case, rod):
    """Balance of energy; the wall's impulse is what the rod's momentum changed by; nothing moves sideways."""
    history, name = rod.result.history, rod.name
    momentum = history["mass"][-1] * rod.row["V"]
    case.assert_below(f"{name}: energy error", rod.result.summary["energy"]["error_ratio"], 1e-10, "ledger")
    case.assert_close(f"{name}: wall impulse [N s]", momentum + history["momentum_z"][-1], history["impulse_wall.z"][-1],
                      1e-12, "change of momentum")
    sideways = max(abs(history["momentum_x"]).max(), abs(history["momentum_y"]).max())
    case.assert_below(f"{name}: sideways momentum, share", sideways / momentum, 1e-10, "symmetry")
    case.assert_below(f"{name}: node behind the wall, share of the radius",
                      rod.result.summary["max_penetration"] / rod.row["D"], 1e-12, "no node passes the wall")


def assert_measured(case, rod):
    length_gate, face_gate = MISSES.get(rod.number, (LENGTH_GATE, FACE_GATE))
    source = rod.row["source"] + ("; misses T3" if rod.number in MISSES else "")
    case.assert_close(f"{rod.name}: length [m]", rod.row["length"], rod.length, length_gate, source)
    if rod.row["face"]:
        case.assert_close(f"{rod.name}: mushroom [m]", rod.row["face"], rod.face, face_gate, source)


def assert_convergence(case, rods):
    """The mesh changes less than the experiment scatters. (There are 16, 16, 32 elements around for n = 3, 4, 6: no order.)"""
    name = rods[0].row["name"]
    for what, gate in (("length", 0.005), ("face", 0.03)):
        values = numpy.array([getattr(rod, what) for rod in rods])
        case.assert_below(f"{name}: {what}, last two meshes", values[-1] / values[-2] - 1, gate, "a fifth of T3")


def assert_adiabatic(case, rod):
    """Heat is taylor_quinney times plastic work, which is all of the internal energy but the elastic one at rest."""
    law = case.scene()["materials"][metal(rod.row["name"])]
    mass = rod.result.history["mass"][-1]
    start, _, fields = last_state(rod.result)
    with h5py.File(os.path.join(rod.result.folder, "state.h5"), "r") as state:
        corners = start[state["mesh/connectivity"][:]]
    volume = numpy.abs(hex_volume(corners))
    heat = (volume * (fields["temperature"].ravel() - rod.row["T"])).sum() / volume.sum() * mass * law["heat_capacity"]
    internal = rod.result.summary["energy"]["internal"]
    case.assert_close(f"{rod.name}: heat / (0.9 internal energy)", 1, heat / (law["taylor_quinney"] * internal), 0.02,
                      "adiabatic, nearly all work is plastic")


def hex_volume(x):
    """By six tetrahedra around the diagonal 0-6."""
    ring = [1, 2, 3, 7, 4, 5, 1]
    a = x[:, 6] - x[:, 0]
    return sum(numpy.einsum("ei,ei->e", a, numpy.cross(x[:, i] - x[:, 0], x[:, j] - x[:, 0]))
               for i, j in zip(ring, ring[1:])) / 6


def main():
    case = Case(__file__)
    case.answer(errors)
    rods = []
    for number in STUDY.values():
        meshes = [Rod(case, number, across) for across in ((4, 6, 8) if case.long else (3, 4, 6))]
        assert_measured(case, meshes[-1])
        assert_convergence(case, meshes)
        rods += meshes
    rows = range(len(measured())) if case.long else case.of_all((0, 27, 58), (0,))
    for number in rows:
        if number in SOFT or number in STUDY.values():
            continue
        rods.append(Rod(case, number))
        assert_measured(case, rods[-1])
    for rod in rods:
        assert_ledger(case, rod)
        if not rod.result.summary["folded_elements"]:
            assert_adiabatic(case, rod)
    others = {"hex8_bbar": {"parts.rod.element": "hex8_bbar"}, "hex8_full": {"parts.rod.element": "hex8_full"},
              "elastic": {"parts.rod.hourglass": {"kind": "elastic", "coefficient": 0.05}},
              "viscous": {"parts.rod.hourglass": {"kind": "viscous", "coefficient": 0.1}},
              "friction 0.1": {"rigid_walls.0.friction": 0.1}}
    if not case.long:
        others = {label: others[label] for label in ("hex8_bbar", "hex8_full", "elastic")}
    for number in STUDY.values() if case.long else (STUDY["steel"],):
        plain = next(rod for rod in rods if rod.number == number and rod.across == 4)
        for label, change in others.items():
            rods.append(Rod(case, number, 4, label, **change))
            case.assert_below(f"{rods[-1].name}: energy error", rods[-1].result.summary["energy"]["error_ratio"], 1e-10)
            if label == "hex8_bbar":
                case.assert_close(f"{rods[-1].name}: mushroom as hex8's [m]", plain.face, rods[-1].face, 0.02)
    case.table("rods", ["row", "metal", "source", "temperature [K]", "length before [mm]", "speed [m/s]", "element, n", "length measured [mm]",
                        "computed", "error", "diameter measured [mm]", "computed", "error", "meets T3", "hourglass energy [%]", "folded elements",
                        "steps", "loop [s]"], [rod.line() for rod in rods])

    small = {**overrides_of(measured()[STUDY["steel"]], 2), "run.end": 2.0e-5, "output.every": 2.0e-5}
    case.assert_same_on_ranks((1, 2, 3, 4), restarted=True, overrides=small)
    whole = case.run(overrides=small, name="whole")
    case.assert_same_after_restart(whole, 1.0e-5, overrides=small)
    case.finish()


if __name__ == "__main__":
    main()
