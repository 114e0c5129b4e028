#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Two blocks whose meshes do not match: mortar contact passes on uniform states exactly."""
import math
import os
import sys

import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../support"), HERE]
import mesh  # noqa: E402
from case_check import Case  # noqa: E402
from exact import (free_side, lame, nominal, normal_stress, pressed_stretches, sheared, stress, stretch_under)  # noqa: E402
from state import Last  # noqa: E402

PAIRS = ((3, 4), (2, 3), (4, 7))  # columns of the lower and of the upper block
HEIGHT = 0.5
EXACT, ASKEW = 1e-10, 2e-6  # shares of the stress (M2): affine facets are integrated exactly, general ones by 7 points
HATS = 9  # M2's gate is of stresses; pressures of hats follow by the inverse of their mass matrix, whose condition is 3 a direction
STICKING = 10  # friction's stiffness over E/edge, a constant of the program (src/implicit)
SOURCE = "closed form, exact.py"


def laws_of(scene):
    return [scene["materials"][scene["parts"][name]["material"]] for name in ("low", "top")]


def newton(case, label, result):
    """Residuals of the last step: log r_{k+1} / log r_k over the last two iterations above 1e-11 of the first residual (M6)."""
    found = numpy.array(result.summary["implicit"]["residuals_last"])
    shares = [r for r in found / found[0] if 1e-11 < r < 1]
    if len(shares) > 1:
        case.assert_within(f"{label}: log r(k+1) / log r(k)", 1.7, 99, math.log(shares[-1]) / math.log(shares[-2]), "quadratic: 2")


def check_uniform(case, label, result, last, gradients, laws, gate, open_gap=0.0, slip=0.0, pressure=True, slave=None,
                  spread=1.0):
    """Stresses of all elements, displacements of all nodes and multipliers of all slave nodes of the contact face.

    spread: by how much more than stresses multipliers may err.
    """
    exact = [stress(law, gradient) for law, gradient in zip(laws, gradients)]
    offset = (gradients[0] - numpy.eye(3))[:, 2] * HEIGHT  # of the lower face's nodes at x = y = 0
    off, moved, most = 0.0, 0.0, 0.0
    for block, gradient in enumerate(gradients):
        off = max(off, abs(last.stress[last.block == block] - exact[block]).max())
        nodes = last.nodes[block]
        moves = (last.start[nodes] - [0, 0, HEIGHT]) @ (gradient - numpy.eye(3)).T + offset + block * numpy.array([slip, 0, open_gap])
        moved, most = max(moved, abs(last.move[nodes] - moves).max()), max(most, abs(moves).max())
    case.assert_below(f"{label}: stresses, greatest error / stress", off / max(abs(s).max() for s in exact), gate, SOURCE)
    case.assert_below(f"{label}: displacements, greatest error / displacement", moved / most, gate, SOURCE)
    if pressure:
        ours = last.pressure[last.face(slave, HEIGHT)]
        case.assert_below(f"{label}: multipliers, greatest error / pressure",
                          abs(ours / -exact[0][2] - 1).max(), spread * gate, SOURCE)
    newton(case, label, result)


def ways(case, columns):
    """(slave, multiplier): all in the thorough form; in the quick one standard functions for one pair alone."""
    for slave in ("first", "second"):
        for multiplier in ("dual", "standard"):
            if case.long or multiplier == "dual" or columns == PAIRS[0]:
                yield slave, multiplier


def columns_of(columns, layers=2, deep=None):
    return {f"mesh.{body}.box.elements": [columns[body], deep or columns[body], layers] for body in (0, 1)}


def check_confined(case):
    for columns in PAIRS:
        for slave, multiplier in ways(case, columns):
            overrides = {**columns_of(columns), "contact.0.slave": slave, "contact.0.multiplier": multiplier}
            laws = laws_of(case.scene())
            stretches = pressed_stretches(laws, HEIGHT, 0.1)
            label = f"{columns[0]}:{columns[1]}, {slave} slave, {multiplier}"
            result = case.run(overrides=overrides, name=label.replace(":", "_").replace(", ", "_").replace(" ", "_"))
            check_uniform(case, label, result, Last(result), [sheared(s, 0) for s in stretches], laws, EXACT,
                          slave=0 if slave == "first" else 1)
            case.assert_below(f"{label}: energy error", result.summary["energy"]["error_ratio"], EXACT, "work of the driven face")
    case.assert_close("stress of the closed form, held sides", -0.22073420655712835, normal_stress(laws[0], stretches[0]), 1e-14,
                      "reference M2")


def check_free(case):
    scene = case.scene("free.yaml")
    law, stretch = scene["materials"]["soft"], 0.9
    side = free_side(law, stretch)
    gradient = numpy.diag([side, 1, stretch])
    case.assert_close("stress of the closed form, free sides", -0.11533147959892898, stress(law, gradient)[2], 1e-14, "reference M2")
    for columns in (PAIRS if case.long else PAIRS[:1]):
        for slave, multiplier in ways(case, columns):
            overrides = {**columns_of(columns, 3, 1), "contact.0.slave": slave, "contact.0.multiplier": multiplier}
            label = f"free side, {columns[0]}:{columns[1]}, {slave} slave, {multiplier}"
            result = case.run("free.yaml", overrides, name=label.replace(":", "_").replace(", ", "_").replace(" ", "_"))
            check_uniform(case, label, result, Last(result), [gradient, gradient], [law, law], EXACT,
                          slave=0 if slave == "first" else 1)


def turned(scene, degrees, shift):
    """Overrides that turn the scene about the axis (1, 2, 3) and move it; the rotation and the shift."""
    axis, angle = numpy.array([1.0, 2, 3]) / math.sqrt(14), math.radians(degrees)
    cross = numpy.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    turn = numpy.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross
    rotate = [{"axis": [1, 2, 3], "degrees": degrees}]
    overrides = {}
    for body, entry in enumerate(scene["mesh"]):
        at = turn @ entry["box"].get("at", [0, 0, 0]) + shift
        overrides.update({f"mesh.{body}.box.rotate": rotate, f"mesh.{body}.box.at": at.tolist()})
    for plane, entry in enumerate(scene["symmetry"]):
        overrides[f"symmetry.{plane}.point"] = (turn @ entry["point"] + shift).tolist()
        overrides[f"symmetry.{plane}.normal"] = (turn @ entry["normal"]).tolist()
    return overrides, turn


def check_turned(case):
    scene = case.scene("pressed.yaml")
    laws, pressure = laws_of(scene), scene["pressure"][0]["value"]
    gradients = [sheared(stretch_under(law, -pressure), 0) for law in laws]
    for away, gate in ((100, EXACT), (1e4, 1e-8)) if case.long else ((100, EXACT),):
        overrides, turn = turned(scene, 33, numpy.array([away, -away, 0.5 * away]))
        shift = numpy.array([away, -away, 0.5 * away])
        # The residual cannot fall below the rounding of coordinates, 1e-16 of their size, times the stiffness.
        overrides["solver.tolerance"] = 1e-12 if away < 1e3 else 1e-10
        label = f"turned by 33 degrees, moved by {away:g}"
        result = case.run("pressed.yaml", overrides, name=f"turned_{away:g}")
        check_uniform(case, label, result, Last(result).turned_back(turn, shift), gradients, laws, gate, slave=0)


def check_meshes(case):
    """Hexahedra with general quadrilaterals, and tetrahedra on hexahedra."""
    scene = case.scene("askew.yaml")
    laws, pressure = laws_of(scene), scene["pressure"][0]["value"]
    gradients = [sheared(stretch_under(law, -pressure), 0) for law in laws]
    for columns in (PAIRS if case.long else PAIRS[:1]):
        path = os.path.join(case.work, f"askew_{columns[0]}_{columns[1]}.inp")
        os.makedirs(case.work, exist_ok=True)
        mesh.askew(path, columns)
        for multiplier in ("dual", "standard"):
            overrides = {"mesh.0.file": path, "contact.0.multiplier": multiplier}
            label = f"askew {columns[0]}:{columns[1]}, {multiplier}"
            result = case.run("askew.yaml", overrides, name=label.replace(":", "_").replace(", ", "_").replace(" ", "_"))
            check_uniform(case, label, result, Last(result), gradients, laws, ASKEW, slave=0, spread=HATS if multiplier == "standard" else 1)
    for slave in ("first", "second"):
        overrides = {"mesh.0.file": os.path.join(HERE, "tetrahedra.inp"), "parts.top.element": "tet4", "contact.0.slave": slave}
        result = case.run("askew.yaml", overrides, name=f"tetrahedra_{slave}")
        check_uniform(case, f"tetrahedra on hexahedra, {slave} slave", result, Last(result), gradients, laws, EXACT,
                      slave=0 if slave == "first" else 1)


def check_ties(case):
    scene = case.scene("shear.yaml")
    laws, shear_stress = laws_of(scene), scene["traction"][-1]["value"][0]
    stretches = pressed_stretches(laws, HEIGHT, -0.1)
    for slave in ("first", "second"):
        overrides = {"contact.0.slave": slave, "contact.0.tied": True, "curves.down": [[0, 0], [1, 0.1]]}
        result = case.run(overrides=overrides, name=f"tension_{slave}")
        check_uniform(case, f"tie in tension, {slave} slave", result, Last(result), [sheared(s, 0) for s in stretches], laws, EXACT,
                      pressure=False)
        result = case.run("shear.yaml", {"contact.0.slave": slave}, name=f"shear_{slave}")
        check_uniform(case, f"tie in shear, {slave} slave", result, Last(result),
                      [sheared(1, shear_stress / lame(law)[0]) for law in laws], laws, EXACT, pressure=False)


def edge_mean(scene, body, driven):
    """Mean edge of the faces of a block that are not in symmetry planes: of all six sides but `driven` pairs."""
    box = scene["mesh"][body]["box"]
    n, h = box["elements"], [size / count for size, count in zip(box["size"], box["elements"])]
    edges = count = 0
    for across in range(3):
        if across in driven:
            continue
        a, b = (c for c in range(3) if c != across)
        edges, count = edges + 2 * n[a] * n[b] * 2 * (h[a] + h[b]), count + 2 * n[a] * n[b] * 4
    return edges / count


def check_stick(case):
    """Pressed and sheared at once, below the limit of friction: uniform, with the slip that its stiffness leaves."""
    scene = case.scene("shear.yaml")
    laws, pressure, shear_stress = laws_of(scene), 0.05, 0.02
    gradients = [sheared(stretch_under(law, -pressure), shear_stress / lame(law)[0]) for law in laws]
    slip = shear_stress / (STICKING * laws[0]["young"] / edge_mean(scene, 0, (1,)))
    top = sum((gradient - numpy.eye(3))[:, 2] * HEIGHT for gradient in gradients) + [slip, 0, 0]
    overrides = {"contact.0.tied": None, "contact.0.friction": 1.0, "solver.step": 1, "traction.4.value": [0, 0, 0],
                 "prescribed": [{"set": "top_zmax", "dof": dof, "displacement": "ramp", "scale": top[c]} for c, dof in ((0, "x"), (2, "z"))]}
    for block, (law, gradient) in enumerate(zip(laws, gradients)):
        side = nominal(law, gradient)[:, 0]
        overrides[f"traction.{2 * block}.value"], overrides[f"traction.{2 * block + 1}.value"] = (-side).tolist(), side.tolist()
    result = case.run("shear.yaml", overrides, name="stick")
    # The faces no longer coincide after the slip: a strip of its width at one rim of the slave carries nothing. The state errs by the
    # strip's share of a facet, whose nodes lose so much of their force.
    uncovered = slip * scene["mesh"][0]["box"]["elements"][0]
    check_uniform(case, "friction, sticking", result, Last(result), gradients, laws, 1.5 * uncovered, slip=slip, slave=0)


def check_penalty(case):
    scene = case.scene()
    laws, pressure = laws_of(scene), 0.2
    gradients = [sheared(stretch_under(law, -pressure), 0) for law in laws]
    gap = -pressure / (min(law["young"] for law in laws) / edge_mean(scene, 0, (0, 1)))
    top = sum((gradient[2, 2] - 1) * HEIGHT for gradient in gradients) + gap
    result = case.run(overrides={"contact.0.enforce": "penalty", "curves.down": [[0, 0], [1, top]]}, name="penalty")
    last = Last(result)
    check_uniform(case, "penalty", result, last, gradients, laws, EXACT, open_gap=gap, slave=0)
    case.assert_below("penalty: gap of the slave nodes, greatest error / (pressure / stiffness)",
                      abs(last.gap[last.face(0, HEIGHT)] / gap - 1).max(), EXACT, "-p / (E / edge)")


def main():
    case = Case(__file__)
    check_confined(case)
    check_turned(case)
    check_meshes(case)
    check_ties(case)
    check_free(case)
    check_stick(case)
    check_penalty(case)
    case.assert_same_on_ranks((1, 2, 3, 4) if case.long else (1, 4), scene="askew.yaml")
    if case.long:
        whole = case.run("askew.yaml", name="whole")
        case.assert_same_after_restart(whole, 0.5, scene="askew.yaml")
    case.finish()


if __name__ == "__main__":
    main()
