#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A hard ball goes obliquely through a thin plate that erodes: balances, symmetry, debris, the same bits on any ranks."""
import os
import sys

import h5py
import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402


def speed_of(result):
    return numpy.hypot(result.last("ball.x"), result.last("ball.z"))


def mesh_of(scene, through):
    """Elements of a third of the thickness, or of another share of it."""
    size = scene["mesh"][1]["box"]["size"]
    edge = size[2] / through
    return [round(size[0] / edge), round(size[1] / edge), through]


def debris(result):
    """Nodes of the plate that fly off below it: the least and the mean of their velocities along the flight of the ball."""
    with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
        record = state[max(key for key in state if key.startswith("record"))]
        start = state["mesh/coordinates"][:]
        moved, velocity = record["node/displacement"][:], record["node/velocity"][:]
    z = start[:, 2] + moved[:, 2]
    thickness = 3.0e-3
    flies = (abs(start[:, 2]) <= 0.51 * thickness) & (z < -2 * thickness)
    return int(flies.sum()), velocity[flies]


def check_flight(case, result, scene):
    ball = scene["initial"][0]["velocity"]
    impact = numpy.linalg.norm(ball)
    case.assert_energy(result, energy_gate=1e-10, momentum_gate=1e-10)
    case.assert_within("speed of the ball behind the plate / impact", 0.5, 1.0, speed_of(result) / impact, "it is slowed")
    case.assert_below("velocity of the ball across its plane / impact", result.last("ball.y") / impact, 2e-3, "symmetry")
    case.assert_below("deepest penetration / element", result.summary["max_penetration"] / 1.0e-3, 0.01, "none")
    falls = numpy.maximum.accumulate(result.history["contact"]) - result.history["contact"]
    case.assert_below("energy that contact gave / all", falls.max() / result.summary["energy"]["total"], 1e-3, "none")
    count, velocity = debris(result)
    case.assert_within("nodes of the plate that fly off", 20, 5000, count, "a plug is struck out")
    fastest = numpy.linalg.norm(velocity, axis=1).max()
    case.assert_within("fastest of them / impact", 0.5, 2.0, fastest / impact, "at most twice as fast, elastically struck")
    case.assert_equal("elements that have folded", 0, result.summary["folded_elements"])


def main():
    case = Case(__file__)
    scene = case.scene()
    result = case.run()
    check_flight(case, result, scene)
    case.assert_same_on_ranks((1, 2, 3, 4), overrides={"run.end": 15.0e-6})
    middle = case.run(overrides={"run.end": 15.0e-6, "checkpoint.every": 7.0e-6}, name="middle")
    case.assert_same_after_restart(middle, 7.0e-6, overrides={"run.end": 15.0e-6})
    coarse = case.run(overrides={"mesh.1.box.elements": mesh_of(scene, 2)}, ranks=2, name="coarse")
    lost = [1 - speed_of(run) / numpy.linalg.norm(scene["initial"][0]["velocity"]) for run in (coarse, result)]
    case.assert_close("speed lost, 2 elements through the plate for 3", lost[1], lost[0], 0.35, "mesh")
    if case.long:
        fine = case.run(overrides={"mesh.1.box.elements": mesh_of(scene, 5)}, ranks=2, name="fine")
        lost.append(1 - speed_of(fine) / numpy.linalg.norm(scene["initial"][0]["velocity"]))
        case.assert_close("speed lost, 3 elements through the plate for 5", lost[2], lost[1], 0.25, "mesh")
    case.finish()


if __name__ == "__main__":
    main()
