#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Bars that lose elements against d'Alembert: the new end is free, the new face is struck, and what has gone is booked."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

SOURCE = "d'Alembert, see README"


def bar_of(scene, body=0):
    material, size = scene["materials"]["steel_like"], scene["mesh"]
    size = (size if isinstance(size, dict) else size[body])["box"]["size"]
    return material["density"], numpy.sqrt(material["young"] / material["density"]), size[1] * size[2]


def check_blow(case, result, scene):
    """The outer half goes when the blow has run through three quarters of the bar."""
    density, wave_speed, area = bar_of(scene)
    speed, half, at = -scene["initial"][0]["velocity"][0], scene["sets"]["outer"]["box"][0][0], scene["remove"][0]["at"]
    force = density * wave_speed * speed * area
    run = at * wave_speed - half  # how far the blow is in the half that goes
    time, impulse = result.history["time"], result.history["impulse_wall.x"]

    def mean(start, stop):
        return (numpy.interp(stop, time, impulse) - numpy.interp(start, time, impulse)) / (stop - start)

    ends = at + half / wave_speed
    case.assert_close("force of the wall before [N]", force, mean(0.1 * at, at), 0.01, SOURCE)
    case.assert_close("force of the wall until the new end is felt [N]", force, mean(at, 0.97 * ends), 0.01, SOURCE)
    case.assert_close("impulse of the wall [N s]", force * ends, impulse[-1], 0.01, SOURCE)
    case.assert_close("velocity of what is left [m/s]", speed, result.last("kept.x"), 0.01, SOURCE)
    case.assert_close("velocity of mass points that were at rest [m/s]", 0, result.last("stopped.x"), 0.02 * speed, SOURCE,
                      absolute=True)
    case.assert_close("velocity of those that were not [m/s]", -speed, result.last("flying.x"), 1e-6, SOURCE)
    case.assert_close("energy that has gone [J]", 0.5 * density * speed**2 * area * run, result.last("eroded"), 0.02, SOURCE)
    case.assert_close("mass [kg]", density * area * 2 * half, result.last("mass"), 1e-12, "it stays on the nodes")
    case.assert_energy(result, energy_gate=1e-10, momentum_gate=1e-12)


def check_bared(case, result, scene):
    """Equal bars of unlike meshes; they meet where the cap was and swap their velocities."""
    density, wave_speed, area = bar_of(scene)
    speed, length = -scene["initial"][0]["velocity"][0], scene["mesh"][1]["box"]["size"][0]
    gap = scene["mesh"][1]["box"]["at"][0] - scene["sets"]["cap"]["box"][0][0]
    meet, transit = gap / speed, length / wave_speed
    time, impulse = result.history["time"], result.history["impulse_blow.x"]

    def mean(start, stop):
        return (numpy.interp(meet + stop * transit, time, impulse) - numpy.interp(meet + start * transit, time, impulse)) \
            / ((stop - start) * transit)

    first = time[result.history["active_contacts"] > 0][0]
    case.assert_close("time of the impact [s]", meet, first, 1e-3, "straight flight")
    case.assert_close("force of the impact [N]", 0.5 * density * wave_speed * speed * area, mean(0.15, 1.85), 0.01, SOURCE)
    case.assert_close("velocity of the striker [m/s]", 0, result.last("striker.x"), 0.01 * speed, SOURCE, absolute=True)
    case.assert_close("velocity of the rod [m/s]", -speed, result.last("rod.x"), 0.015, SOURCE)
    case.assert_below("deepest penetration / element", result.summary["max_penetration"] / 1e-3, 1e-3, "none")
    case.assert_energy(result, energy_gate=1e-10, momentum_gate=1e-12)


def main():
    case = Case(__file__)
    result = case.run()
    check_blow(case, result, case.scene())
    case.assert_same_on_ranks((1, 2, 3, 4), restarted=True)
    case.assert_same_after_restart(result, 3.5e-5)
    bared = case.run("bared.yaml", name="bared")
    check_bared(case, bared, case.scene("bared.yaml"))
    case.finish()


if __name__ == "__main__":
    main()
