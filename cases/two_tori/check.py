#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Two hollow rubber tori meet: mortar contact in an implicit step against the explicit solver."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402
from implicit_check import EXPLICIT, check_conserved, check_quadratic, outside_solver, report  # noqa: E402

COARSE = {"mesh.0.torus.elements": [32, 16, 1], "mesh.1.torus.elements": [32, 16, 1], "run.end": 1.2}


def velocity(result, time):
    return numpy.array([result.at(f"lower.{c}", time) for c in "xyz"]) / result.history["mass_lower.mass"][0]


def check_velocity(case, label, result, time, reference, gate, source):
    for c, expected, ours in zip("xyz", reference, velocity(result, time)):
        case.assert_close(f"{label}: velocity {c} of the lower torus at {time:g}", expected, ours, gate, source, absolute=True)


def check_coarse(case):
    explicit = case.run(name="coarse_explicit", overrides={**COARSE, **EXPLICIT})
    ours = case.run(name="coarse", overrides=COARSE)
    report(case, "32x16x1, explicit", explicit)
    report(case, "32x16x1", ours)
    check_velocity(case, "32x16x1", ours, 1.2, velocity(explicit, 1.2), 0.3, "explicit, same mesh; gate of M8 at 2.5")
    check_conserved(case, "32x16x1", ours, 0.03)
    check_quadratic(case, "32x16x1", ours)
    case.assert_within("32x16x1: contacts at 1.2", 1, 200, ours.summary["implicit"]["contact"]["active"], "they press")


def check_fine(case):
    """Missed (README, limits): to the time 12, with the velocities of the reference. The guard of penetration stops the run."""
    ours = case.run(name="np1", expected_code=3)
    report(case, "40x20x2", ours)
    case.assert_within("40x20x2: time at which lost nodes stop the run", 1.5, 12, ours.summary["end_time"], "missed: M8 goes to 12")
    check_velocity(case, "40x20x2", ours, 1.5, velocity(case.run(name="fine_explicit", overrides={**EXPLICIT, "run.end": 1.6}), 1.5),
                   0.3, "explicit, same mesh; gate of M8 at 2.5")
    case.assert_within("40x20x2: share of all but the linear solver", 0, 0.2, outside_solver(ours), "M10")


def main():
    case = Case(__file__)
    check_coarse(case)
    if case.long:
        case.assert_same_on_ranks((1, 2, 3, 4), overrides={**COARSE, "run.end": 0.8})
        check_fine(case)
    case.finish()


if __name__ == "__main__":
    main()
