#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A struck bar of two tied halves against d'Alembert: the tie passes pressure and tension on."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

SOURCE = "d'Alembert, see README"


def mean(result, name, start, stop):
    """Mean force over a time, from the impulse: the force of single steps is noisy."""
    time, impulse = result.history["time"], result.history[f"impulse_{name}.x"]
    return (numpy.interp(stop, time, impulse) - numpy.interp(start, time, impulse)) / (stop - start)


def check(case, label, result, scene):
    """Three bars of one length, section and material; times in transits of a bar."""
    material = scene["materials"]["steel_like"]
    size = scene["mesh"][0]["box"]["size"]
    wave_speed = numpy.sqrt(material["young"] / material["density"])
    speed, transit = scene["initial"][0]["velocity"][0], size[0] / wave_speed
    force = 0.5 * speed * material["density"] * wave_speed * size[1] * size[2]

    def over(name, start, stop):
        margin = 0.15  # of the plateau, off its ends
        return mean(result, name, (start + margin) * transit, (stop - margin) * transit)

    case.assert_close(f"{label}: force of the impact [N]", force, over("blow", 0, 2), 0.01, SOURCE)
    # the pulse is as long as the bar: at its middle it is pressure, then, come back from the free end, tension
    for start, stop, sign, what in ((1, 3, 1, "pressure"), (3, 5, -1, "tension"), (5, 7, 1, "pressure again")):
        case.assert_close(f"{label}: {what} in the tie [N]", sign * force, over("tie", start, stop), 0.01, SOURCE)
    case.assert_close(f"{label}: velocity of the striker [m/s]", 0, result.last("striker.x"), 0.01 * speed, SOURCE,
                      absolute=True)
    case.assert_close(f"{label}: velocity of the bar [m/s]", speed / 2,
                      0.5 * (result.last("near.x") + result.last("far.x")), 0.01, SOURCE)
    taken = result.history["contact"] + result.history["friction"]
    time = result.history["time"]
    after = numpy.interp(2.5 * transit, time, taken)  # the striker's blow, as in bar_impact, is over
    case.assert_below(f"{label}: energy that the tie removes or adds / energy of the striker",
                      abs(taken[-1] - after) / (0.5 * material["density"] * numpy.prod(size) * speed**2), 1e-3, "none")
    case.assert_energy(result, energy_gate=1e-10, momentum_gate=1e-12)


def main():
    case = Case(__file__)
    scene = case.scene()
    result = case.run()
    check(case, "1x1 on 3x3", result, scene)
    same = case.run(overrides={"mesh.2.box.elements": scene["mesh"][1]["box"]["elements"]}, name="same")
    check(case, "equal meshes", same, scene)
    other = case.run(overrides={"mesh.1.box.elements": [100, 2, 2]}, name="other")
    check(case, "2x2 on 3x3", other, scene)
    apart = case.run(overrides={"mesh.2.box.at": [0.1002, -0.005, -0.005]}, name="apart")
    check(case, "a fifth of an element apart", apart, scene)
    case.assert_same_on_ranks((1, 2, 3, 4), restarted=True)
    case.assert_same_after_restart(result, 5.0e-5)
    case.finish()


if __name__ == "__main__":
    main()
