#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""An elastic ball bounces five times on a rigid floor: energy never grows, heights come back (see README)."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

BOUNCES = 5


def peaks(height, near):
    """Indices of the highest rows between bounces."""
    return [k for k in range(near, len(height) - near) if height[k] == height[k - near:k + near + 1].max()]


def main():
    case = Case(__file__)
    scene, result = case.scene(), case.run()
    ball, gravity = scene["mesh"]["sphere"], -scene["gravity"]["vector"][2]
    drop = scene["initial"][0]["velocity"][2]**2 / (2 * gravity)  # to where it starts
    history = result.history
    time, height = history["time"], history["ball.z"] - history["ball.z"][0]
    tops = peaks(height, 100)
    case.assert_equal("bounces", BOUNCES, len(tops))
    for k in range(2):
        case.assert_close(f"height after bounce {k + 1}, of the centre of mass [m]", drop, height[tops[k]], 0.01,
                          "Hertz, elastic impact")
    case.table("heights", ["bounce", "height / drop"], [[k + 1, f"{height[top] / drop:.5f}"] for k, top in enumerate(tops)])
    start = history["kinetic"][0]
    case.assert_below("energy that the floor adds, in any row", max(0.0, -numpy.diff(history["walls"]).min()) / start, 1e-12)
    case.assert_below("energy that the floor adds, in all", max(0.0, -history["walls"].min()) / start, 1e-12)
    energy = history["kinetic"] + history["internal"] + history["hourglass"] - history["external"]
    case.assert_below("energy of the ball, growth / energy of the fall", max(0.0, (energy - energy[0]).max()) / start, 1e-6)
    case.assert_energy(result, energy_gate=1e-10, momentum_gate=1e-9)
    case.assert_same_on_ranks((1, 3), overrides={"run.steps": 500})
    case.finish()


if __name__ == "__main__":
    main()
