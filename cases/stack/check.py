#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Ten cubes on each other: settled, then left alone, they neither sink nor stir (see README)."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

SOURCE = "statics"


def check(case, label, scene, result, steps):
    """All from the moment that damping ends."""
    history, boxes = result.history, [entry["box"] for entry in scene["mesh"]]
    side, gravity = boxes[0]["size"][2], -scene["gravity"]["vector"][2]
    mass = scene["materials"]["soft"]["density"] * side**3
    since = int(numpy.searchsorted(history["time"], scene["damping"]["to"]))
    time = history["time"][since:] - history["time"][since]
    case.assert_within(f"{label}: steps without damping", steps, numpy.inf,
                       history["step"][-1] - history["step"][since])
    height = history["top.z"][since:]
    case.assert_below(f"{label}: the top rises or sinks / side", numpy.abs(height - height[0]).max() / side, 1e-6, SOURCE)
    for k in range(len(boxes)):
        carried = (len(boxes) - k) * mass * gravity
        impulse = numpy.abs(history[f"impulse_f{k}.z"][since:] - history[f"impulse_f{k}.z"][since])
        case.assert_close(f"{label}: mean force under cube {k} [N]", carried, impulse[-1] / time[-1], 1e-3, SOURCE)
        force = numpy.abs(history[f"f{k}.z"][since + 1:])
        case.assert_below(f"{label}: force under cube {k}, largest deviation / force",
                          numpy.abs(force / carried - 1).max(), 1e-3, SOURCE)
    fall = len(boxes) * mass * gravity * len(boxes) * side / 2
    kinetic = numpy.abs(history["kinetic"][since:]) / fall
    case.assert_below(f"{label}: kinetic energy / (m g h)", kinetic.max(), 1e-9, SOURCE)
    early, late = kinetic[:len(kinetic) // 2].max(), kinetic[len(kinetic) // 2:].max()
    case.assert_below(f"{label}: kinetic energy / (m g h), late over early", max(0.0, late - early), 1e-15, SOURCE)
    drift = numpy.hypot(history["top.x"][-1] - history["top.x"][since], history["top.y"][-1] - history["top.y"][since])
    case.row("drift", ["run", "steps without damping", "top moves sideways / side", "largest kinetic energy / (m g h): first half", "second half", "loop [s]"],
             [label, int(history["step"][-1] - history["step"][since]), f"{drift / side:.0e}", f"{early:.0e}", f"{late:.0e}",
              result.summary["loop_s"]])
    # nodes sink by 1e-5 (seen: 1e-7), rims hang over faces by up to a thousandth of an element, of which a cube has two
    # or three
    case.assert_below(f"{label}: deepest penetration / side", result.summary["max_penetration"] / side, 5e-4)
    # of the largest sum of m |v|, which is but that of the settling. Weight and floor give impulses of 7e3 N s each in
    # 1e6 steps, and the equal terms of all steps are rounded alike: by half of a last place of each sum
    carried = 2 * len(boxes) * mass * gravity * history["time"][-1]
    rounding = history["step"][-1] * 2.0**-53 * carried / numpy.abs(history["momentum_z"]).max()
    case.assert_energy(result, energy_gate=1e-10, momentum_gate=max(1e-8, rounding))


def main():
    case = Case(__file__)
    check(case, "at rest", case.scene(), case.run(), 1e4)
    if case.long:
        million = {"run.end": 68, "history.every": 0.02, "output.every": 50}
        check(case, "1e6 steps", case.scene(overrides=million), case.run(overrides=million, name="million"), 1e6)
    short = {"run.steps": 600}
    case.assert_same_on_ranks((1, 2, 3, 4) if case.long else (1, 3), overrides=short)
    case.finish()


if __name__ == "__main__":
    main()
