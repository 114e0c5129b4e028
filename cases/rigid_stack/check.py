#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Six rigid boxes on each other at rest: they neither creep nor turn, and carry their weight exactly."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

SOURCE = "statics"


def check(case, label, scene, result):
    history, boxes = result.history, [entry["box"] for entry in scene["mesh"]]
    side, gravity = boxes[0]["size"][2], -scene["gravity"]["vector"][2]
    mass = scene["materials"]["hard"]["density"] * side**3
    time = history["time"]
    moved = numpy.linalg.norm([history[f"top.{c}"] for c in "xyz"], axis=0)
    turned = numpy.linalg.norm([history[f"turn.{c}"] for c in "xyz"], axis=0)
    # rows between rigid bodies are springs, which the weight presses in once, by less than a body falls in a step
    fall = gravity * scene["run"]["step"]**2
    case.assert_below(f"{label}: the top sinks / (g dt^2)", moved.max() / fall, 1, "a fall of one step")
    case.assert_below(f"{label}: the top moves in the second half / side", abs(moved[len(time) // 2:] - moved[-1]).max() / side, 1e-9, SOURCE)
    case.assert_below(f"{label}: the top turns [rad]", turned.max(), 1e-7, SOURCE)
    for k in range(len(boxes)):
        carried = (len(boxes) - k) * mass * gravity
        impulse = numpy.abs(history[f"impulse_f{k}.z"])
        given = carried * (time[-1] - time[1])
        case.assert_close(f"{label}: mean force under box {k} [N]", carried, carried * (impulse[-1] - impulse[1]) / given, 1e-6,
                          SOURCE)
    case.assert_below(f"{label}: energy error ratio", result.summary["energy"]["error_ratio"], 1e-9)
    # nothing moves, so momentum has no scale of its own: of what the weight gives in a step
    momentum = numpy.linalg.norm([history[f"momentum_{c}"][1:] for c in "xyz"], axis=0).max()
    weight = len(boxes) * mass * gravity
    case.assert_below(f"{label}: momentum / (weight dt)", momentum / (weight * scene["run"]["step"]), 1e-2, "contact's tolerance")
    contact = result.summary["contact"]
    case.row("iterations", ["steps", "iterations a step, mean", "most", "steps at the limit", "deepest penetration / side", "loop [s]"],
             [result.summary["steps"], f"{contact['iterations_mean']:.1f}", contact["iterations_max"], contact["steps_at_limit"],
              f"{result.summary['max_penetration'] / side:.1e}", result.summary["loop_s"]])


def main():
    case = Case(__file__)
    steps = {} if case.long else {"run.steps": 5000, "history.every": 5e-3}
    result = case.run(overrides=steps)
    check(case, f"{result.summary['steps']} steps", case.scene(), result)
    short = {"run.steps": 200}
    case.assert_same_on_ranks((1, 2, 3, 4) if case.long else (1, 3), overrides=short)
    case.finish()


if __name__ == "__main__":
    main()
