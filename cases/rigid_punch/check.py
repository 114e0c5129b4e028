#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A rigid sphere pressed into an elastic layer on a rigid base: force against depth by Hertz with the layer's correction."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

SOURCE = "Hertz; Dimitriadis et al. 2002"
QUARTERS = 4  # of the problem the scene holds one


def exact_force(scene, depth):
    """Of the whole sphere on a layer that is bonded to its base (E. K. Dimitriadis et al., Biophys. J. 82 (2002) 2798)."""
    law, radius = scene["materials"]["soft"], scene["mesh"][0]["sphere"]["radius"]
    thickness, nu = scene["mesh"][1]["box"]["size"][2], law["poisson"]
    hertz = 4 / 3 * law["young"] / (1 - nu**2) * numpy.sqrt(radius) * depth**1.5
    a = -(1.2876 - 1.4678 * nu + 1.3442 * nu**2) / (1 - nu)
    b = (0.6387 - 1.0277 * nu + 1.5164 * nu**2) / (1 - nu)
    x, pi = numpy.sqrt(radius * depth) / thickness, numpy.pi
    factor = (1 - 2 * a / pi * x + 4 * a**2 / pi**2 * x**2 - 8 / pi**3 * (a**3 + 4 * pi**2 / 15 * b) * x**3
              + 16 * a / pi**4 * (a**3 + 3 * pi**2 / 5 * b) * x**4)
    return hertz, hertz * factor


def held(scene, result):
    """Depth, force and reaction (means over the last quarter of the hold) of the whole sphere."""
    history = result.history
    start = scene["curves"]["press"][-1][0]
    since = numpy.searchsorted(history["time"], start + 0.75 * (scene["run"]["end"] - start))
    span = history["time"][-1] - history["time"][since]

    def mean(name):
        return QUARTERS * (history[f"impulse_{name}.z"][-1] - history[f"impulse_{name}.z"][since]) / span
    return -history["depth.z"][-1], mean("push"), mean("held"), mean("touch")


def check(case, label, scene, result, gate):
    depth, push, reaction, touch = held(scene, result)
    hertz, force = exact_force(scene, depth)
    case.row("forces", ["mesh", "depth [mm]", "force on a half-space [N]", "force on the layer [N]", "computed [N]", "error"],
             [label, f"{1e3 * depth:.3f}", f"{hertz:.5g}", f"{force:.5g}", f"{push:.5g}", f"{100 * (push / force - 1):+.2f} %"])
    case.assert_close(f"{label}: depth [m]", scene["curves"]["press"][-1][1], depth, 1e-12, "prescribed")
    case.assert_close(f"{label}: force [N]", force, push, gate, SOURCE)
    case.assert_close(f"{label}: reaction of the supports [N]", -push, reaction, 1e-3, "equilibrium")
    case.assert_close(f"{label}: force by the contact probe [N]", push, touch, 1e-9, "the same impulses")
    case.assert_energy(result, energy_gate=1e-9, momentum_gate=1e-9)


def main():
    case = Case(__file__)
    coarse = {"mesh.1.box.elements": [24, 24, 12], "mesh.0.sphere.elements": 12}
    check(case, "3 elements over the contact radius", case.scene(overrides=coarse),
          case.run(overrides=coarse, name="coarse", ranks=2), 0.03)
    if case.long:
        check(case, "6 elements over the contact radius", case.scene(), case.run(name="fine", ranks=2), 0.03)
    short = {**coarse, "run.steps": 150}
    case.assert_same_on_ranks((1, 2, 3, 4), restarted=True, overrides=short)
    whole = case.run(overrides={**coarse, "run.end": 0.003}, name="whole")
    case.assert_same_after_restart(whole, 0.002, overrides={**coarse, "run.end": 0.003})
    case.finish()


if __name__ == "__main__":
    main()
