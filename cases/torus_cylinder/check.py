#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A hollow rubber torus passes through a rubber tube: mortar contact in an implicit step against the explicit solver."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402
from implicit_check import check_conserved, check_quadratic, report  # noqa: E402
from overlap import Bodies  # noqa: E402

COARSE = {"mesh.0.torus.elements": [20, 10, 1], "mesh.1.tube.elements": [1, 24, 6], "run.end": 2}
# mean velocities along the axis of torus and tube, explicit solver on this mesh in two passes (one pass): M8
PUBLISHED = {1.0: (28.80, 28.27), 4.0: (27.99, 27.52)}
AFTER, GATE_AFTER = 27.0, 0.5
GATE = 0.6  # the two passes and the one pass of the explicit solver are .5 apart
THICKNESS = 4.5  # of the wall of the torus, the thinner one


def speed(result, part, time):
    return result.at(f"{part}.z", time) / result.history[f"mass_{part}.mass"][0]


def check_depth(case, label, result, time):
    depth = Bodies(result).deepest(time)[0]
    case.assert_below(f"{label}: deepest point in the other body at {time:g} / wall", depth / THICKNESS, 0.15,
                      "gaps are zero in the mean over facets, not at points")


def check_coarse(case):
    ours = case.run(name="coarse", overrides=COARSE)
    report(case, "coarse", ours)
    check_conserved(case, "coarse", ours, 0.03)
    check_quadratic(case, "coarse, step at 2", ours)
    case.assert_within("coarse: velocity of the torus at 2", 20, 30, speed(ours, "torus", 2), "it is braked, and goes on")


def check_fine(case):
    """In three parts: each says what Newton's iteration did in its last step."""
    parts, options = [], ()
    for end in (1, 4, 6):
        parts.append(case.run(name=f"to_{end}", overrides={"run.end": end}, options=options))
        report(case, f"to {end}", parts[-1])
        options = ("--restart", parts[-1].folder)
    for part, (time, (two, one)) in zip(parts, PUBLISHED.items()):
        case.assert_close(f"velocity of the torus at {time:g}", (two + one) / 2, speed(part, "torus", time), GATE,
                          "M8, explicit, mean of two passes and one", absolute=True)
        check_quadratic(case, f"step at {time:g}", part)
    case.assert_close("velocity of the torus at 6", AFTER, speed(parts[-1], "torus", 6), GATE_AFTER, "M8", absolute=True)
    check_depth(case, "after passing", parts[-1], 6)
    check_conserved(case, "to 1", parts[0], 0.03)


def main():
    case = Case(__file__)
    check_coarse(case)
    case.assert_same_on_ranks((1, 2, 3, 4) if case.long else (1, 2), overrides={**COARSE, "run.end": 0.8})
    if case.long:
        check_fine(case)
    case.finish()


if __name__ == "__main__":
    main()
