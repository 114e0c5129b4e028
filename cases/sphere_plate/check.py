#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A ball at 800 m/s on a plate: displacements beside those of a code with penalty contact."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402
import peer  # noqa: E402

END = 1.0e-4
SOURCE = "NimbleSM, penalty 0.333e12"
IMPACT = (452, 1077, 1353)  # front and back of the plate, front of the ball: where a penalty lets the ball in


def approach(displacement):
    """How far the ball's front node has passed the plate's nearest front node [mm]."""
    return 1e3 * (displacement[1353 - 1, 0] - displacement[452 - 1, 0] - 0.01)


def main():
    case = Case(__file__)
    end, histories = peer.end_state(case.folder), peer.node_histories(case.folder)
    for element, gates in (("hex8_full", (0.04, 0.02)), ("hex8", (0.12, 0.05))):
        overrides = {f"parts.{part}.element": element for part in ("plate", "ball")}
        ours = case.run(overrides=overrides, name=element)
        _, displacement = peer.our_state(ours, END)
        case.assert_below(f"{element}: rms difference of all nodes at the end / rms",
                          peer.rms(displacement - end) / peer.rms(end), gates[0], SOURCE)
        case.assert_close(f"{element}: greatest displacement at the end [m]", abs(end).max(), abs(displacement).max(), 0.01,
                          SOURCE)
        for node, (times, values) in histories.items():
            difference = peer.our_histories(ours, node, times) - values
            case.assert_below(f"{element}: node {node}, greatest difference in {len(times)} frames / greatest displacement",
                              numpy.abs(difference).max() / abs(end).max(), 0.2 if node in IMPACT else gates[1], SOURCE)
        head = ["program, element", "ball's front node past the plate's front nodes at the end [mm]", "steps", "loop [s]"]
        if element == "hex8_full":
            case.row("approach", head, ["NimbleSM", f"{approach(end):.2f}", "", ""])
        case.row("approach", head, [f"Brunt, {element}", f"{approach(displacement):.2f}", ours.summary["steps"], ours.summary["loop_s"]])
        case.assert_below(f"{element}: the ball's front node between the plate's nodes / edge", approach(displacement) / 20, 0.01,
                          "none")
        case.assert_below(f"{element}: greatest penetration / edge of the plate's elements",
                          ours.summary["max_penetration"] / 0.02, 0.01, "none")
        case.assert_within(f"{element}: energy taken by contact / initial", 0, 0.03,
                           ours.last("contact") / ours.history["total"][0], "no energy made")
        case.assert_energy(ours, energy_gate=1e-10, momentum_gate=1e-12)
    case.assert_same_on_ranks((1, 2, 3))
    case.finish()


if __name__ == "__main__":
    main()
