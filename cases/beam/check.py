#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Frequencies: axial modes of a discrete bar (exact), bending modes of a cantilever and of a free beam."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

# roots b of cos b cosh b = -1 (clamped-free) and = 1 (free-free): omega = b^2 sqrt(E I / (rho A)) / L^2
ROOTS = {"cantilever": [1.875104068711961, 4.694091132974175, 7.854757438237613],
         "free": [4.730040744862704, 7.853204624095838]}


def parts_of(scene):
    """The generated box and the name of its part."""
    box = scene["mesh"]["box"]
    return box, box["part"]


def mode_overrides(scene, shape, speed, axis):
    """Overrides that give each layer of nodes along x the velocity speed * shape(x) along an axis."""
    box, part = parts_of(scene)
    length, layers = box["size"][0], box["elements"][0]
    sets, initial = {}, []
    for i in range(layers + 1):
        x, near = length * i / layers, 0.25 * length / layers
        sets[f"layer_{i}"] = {"part": part, "box": [[x - near, -1, -1], [x + near, 1, 1]]}
        velocity = [0.0, 0.0, 0.0]
        velocity[axis] = float(speed * shape(x / length))
        initial.append({"set": f"layer_{i}", "velocity": velocity})
    return {"sets": sets, "initial": initial}


def fitted_frequency(time, signal, guess, width=0.2):
    """Angular frequency of the sinusoid (and constant) nearest to the signal in least squares."""
    def misfit(omega):
        basis = numpy.column_stack([numpy.cos(omega * time), numpy.sin(omega * time), numpy.ones_like(time)])
        coefficients = numpy.linalg.lstsq(basis, signal, rcond=None)[0]
        return float(numpy.sum((signal - basis @ coefficients) ** 2))

    centre, width = guess, width * guess
    while width > 1e-13 * guess:
        grid = numpy.linspace(centre - width, centre + width, 41)
        centre = grid[numpy.argmin([misfit(omega) for omega in grid])]
        width *= 0.1
    return centre


def check_discrete_bar(case):
    """Linear elements with lumped mass, omega = 2 c/h sin((2k-1) pi / 4N), moved by the central difference to
    Omega = 2/dt asin(omega dt/2)."""
    scene = case.scene("bar.yaml")
    box, _ = parts_of(scene)
    law = next(iter(scene["materials"].values()))
    length, count = box["size"][0], box["elements"][0]
    wave_speed = numpy.sqrt(law["young"] / law["density"])
    for mode in (1, 2, 3):
        wave = (2 * mode - 1) * numpy.pi / 2
        # strains of 1e-7: the large-strain terms stay below the gate
        overrides = mode_overrides(scene, lambda x, wave=wave: numpy.sin(wave * x), 1e-7 * wave_speed, axis=0)
        result = case.run("bar.yaml", overrides, name=f"bar_{mode}")
        dt = result.history["dt"][1:].mean()
        omega = 2 * wave_speed * count / length * numpy.sin(wave / (2 * count))
        discrete = 2 / dt * numpy.arcsin(0.5 * omega * dt)
        ours = fitted_frequency(result.history["time"], result.history["tip.x"], discrete, width=1e-3)
        periods = discrete * result.summary["end_time"] / (2 * numpy.pi)
        case.assert_close(f"bar mode {mode} over {periods:.0f} periods [rad/s]", discrete, ours, 1e-8, "discrete wave")
        case.assert_energy(result)


def beam_mode(kind, root):
    """Mode shape over x / L of an Euler-Bernoulli beam, clamped or free at 0 and free at 1, unit amplitude at 1."""
    c, s = numpy.cosh(root) + numpy.cos(root), numpy.sinh(root) + numpy.sin(root)
    if kind == "cantilever":
        def shape(x):
            return numpy.cosh(root * x) - numpy.cos(root * x) - c / s * (numpy.sinh(root * x) - numpy.sin(root * x))
    else:
        ratio = (numpy.cosh(root) - numpy.cos(root)) / (numpy.sinh(root) - numpy.sin(root))

        def shape(x):
            return numpy.cosh(root * x) + numpy.cos(root * x) - ratio * (numpy.sinh(root * x) + numpy.sin(root * x))
    return lambda x: shape(x) / shape(1.0)


def check_bending(case, kind, mode, mesh, gate, element="hex8", hourglass=None, stiffness=1.0, periods=2.5):
    """One mode on one mesh; stiffness: what the element's own theory makes of E I."""
    scene = case.scene()
    box, part = parts_of(scene)
    law = next(iter(scene["materials"].values()))
    length, width, height = box["size"]
    root = ROOTS[kind][mode - 1]
    inertia = stiffness * width * height**3 / 12
    omega = root**2 / length**2 * numpy.sqrt(law["young"] * inertia / (law["density"] * width * height))
    period = 2 * numpy.pi / omega
    overrides = mode_overrides({"mesh": {"box": {**box, "elements": mesh}}}, beam_mode(kind, root), 1e-3, axis=2)
    overrides |= {"mesh.box.elements": mesh, f"parts.{part}.element": element, "run.end": periods * period,
                  "history.every": period / 50, "output.every": periods * period}
    if hourglass:
        overrides[f"parts.{part}.hourglass"] = hourglass
    if kind == "free":
        overrides["fixed"] = []
    kinds = element + (" no hourglass control" if hourglass else "")
    name = f"{kind} mode {mode}, {'x'.join(map(str, mesh))} {kinds}"
    result = case.run(overrides=overrides, name=name.replace(" ", "_").replace(",", ""))
    ours = fitted_frequency(result.history["time"], result.history["tip.z"], omega, 0.3)
    source = "Euler-Bernoulli" if stiffness == 1 else f"Euler-Bernoulli, E I x {stiffness:.4f}"
    case.assert_close(f"{name} [Hz]", omega / (2 * numpy.pi), ours / (2 * numpy.pi), gate, source)
    case.row("bending", ["beam, mode", "element", "mesh", "factor on E I by theory", "reference [Hz]", "computed [Hz]", "error", "loop [s]"],
             [f"{kind} {mode}", kinds, " x ".join(map(str, mesh)), f"{stiffness:.4g}", f"{omega / (2 * numpy.pi):.3f}", f"{ours / (2 * numpy.pi):.3f}",
              f"{100 * (ours / omega - 1):+.2f} %", result.summary["loop_s"]])
    case.assert_energy(result)


def check_elements(case):
    """What coarse elements make of bending, by their own theory."""
    scene = case.scene()
    (length, _, height), poisson = parts_of(scene)[0]["size"], next(iter(scene["materials"].values()))["poisson"]
    shear_share = 1 / (2 * (1 + poisson))  # G / E
    for layers in (2, 4):  # one point in each of n layers sees the mean strain of the layer alone
        check_bending(case, "cantilever", 2, [100, 1, layers], 2e-2, hourglass={"kind": "none"},
                      stiffness=1 - 1 / layers**2)
    for cells in (50, 100):  # a straight-edged element of length a shears by +-curvature a/2 at its ends
        check_bending(case, "cantilever", 2, [cells, 1, 2], 1e-2, element="hex8_full",
                      stiffness=1 + shear_share * (length / cells / height) ** 2)


def main():
    case = Case(__file__)
    check_discrete_bar(case)
    check_elements(case)
    for kind, mode in case.of_all((("cantilever", 1), ("cantilever", 2), ("cantilever", 3), ("free", 1), ("free", 2)), (("cantilever", 2), ("free", 2))):
        check_bending(case, kind, mode, [50, 1, 4], 2e-2)
    for kind, mode in case.of_all((("cantilever", 2), ("free", 1)), ()):
        check_bending(case, kind, mode, [100, 1, 8], 1e-2)
    if case.long:
        check_bending(case, "cantilever", 1, [100, 1, 8], 1e-2)
    small = {"mesh.box.elements": [10, 1, 2], "run.end": 2.0e-3, "output.every": 1.0e-3}
    case.assert_same_on_ranks((1, 2, 3, 4, 7), restarted=True, overrides=small)
    whole = case.run(overrides=small, name="whole")
    case.assert_same_after_restart(whole, 1.0e-3, overrides=small)
    case.finish()


main()
