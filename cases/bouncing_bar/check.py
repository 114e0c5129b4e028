#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A bar that bounces: heights, times, force and energy against d'Alembert's solution (see README)."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

SOURCE = "d'Alembert, see README"


def exact(scene):
    """Times of the first bounces, force on the floor, heights of the centre of mass over its height at impact."""
    material, box = scene["materials"]["elastic"], scene["mesh"][0]["box"]
    length, area = box["size"][2], box["size"][0] * box["size"][1]
    speed_of_sound = numpy.sqrt(material["young"] / material["density"])
    gravity = -scene["gravity"]["vector"][2]
    drop = box["at"][2]
    impact = numpy.sqrt(2 * drop / gravity)
    speed, contact = gravity * impact, 2 * length / speed_of_sound
    impedance, weight = material["density"] * speed_of_sound * area, material["density"] * area * length * gravity
    # the foot stops; the rest falls on until the wave reaches it: F = impedance (v + g t)
    impulse = impedance * (speed * contact + gravity * contact**2 / 2)
    mass = material["density"] * area * length
    rebound = (impulse - weight * contact) / mass - speed
    # position at release: integrate twice, m z'' = F - m g
    sunk = -speed * contact - gravity * contact**2 / 2 + impedance / mass * (
        speed * contact**2 / 2 + gravity * contact**3 / 6)
    return {"impact": impact, "speed": speed, "contact": contact, "rebound": rebound, "impulse": impulse,
            "peak_1": sunk + rebound**2 / (2 * gravity), "peak_2": drop,
            "impact_2": impact + contact + 2 * rebound / gravity, "energy": mass * gravity * drop}


def impact_times(result, scene):
    """Of the first two bounces, from the impulse given until well into the contact: single steps are noisy."""
    reference = exact(scene)
    material, box = scene["materials"]["elastic"], scene["mesh"][0]["box"]
    impedance = numpy.sqrt(material["young"] * material["density"]) * box["size"][0] * box["size"][1]
    gravity = -scene["gravity"]["vector"][2]
    # a force acts over the two half steps around its instant
    instant = result.history["time"] + 0.5 * result.history["dt"]
    impulse = result.history["impulse_floor.z"]
    times = []
    for first, before, speed, growth in (
            (reference["impact"], 0, reference["speed"], gravity),
            (reference["impact_2"], reference["impulse"], reference["speed"] + gravity * reference["contact"],
             -gravity)):
        look = first + 0.6 * reference["contact"]
        given = (numpy.interp(look, instant, impulse) - (before and numpy.interp(first - 0.5, instant, impulse)))
        # impedance (speed s + growth s^2 / 2) = given, s after the impact
        passed = (numpy.sqrt(speed**2 + 2 * growth * given / impedance) - speed) / growth
        times.append(look - passed)
    return times


def peaks(result, rest):
    """Largest heights of the centre of mass, by a parabola through the rows around."""
    time, height = result.history["time"], result.history["bar.z"] - rest
    found = []
    for i in range(5, len(time) - 5):
        if height[i] == height[i - 5:i + 6].max() and (not found or time[i] - found[-1][0] > 1):
            a, b, c = numpy.polyfit(time[i - 5:i + 6] - time[i], height[i - 5:i + 6], 2)
            found.append((time[i] - b / (2 * a), c - b * b / (4 * a)))
    return [height for _, height in found]


def errors(scene, result):
    """For scripts/pareto: shares of times, heights and impulse, and what the floor takes of the energy."""
    reference, heights = exact(scene), peaks(result, scene["mesh"][0]["box"]["size"][2] / 2)
    after = result.at("impulse_floor.z", reference["impact"] + 1.2 * reference["contact"])
    taken = result.at("walls", reference["impact_2"] - 0.5) + result.at("contact", reference["impact_2"] - 0.5)
    return {"time of impact 2": impact_times(result, scene)[1] / reference["impact_2"] - 1,
            "peak 1": heights[0] / reference["peak_1"] - 1, "peak 2": heights[1] / reference["peak_2"] - 1,
            "impulse": after / reference["impulse"] - 1, "energy taken": taken / reference["energy"]}


def check(case, label, result, scene, peak_gates):
    reference = exact(scene)
    heights = peaks(result, scene["mesh"][0]["box"]["size"][2] / 2)
    for name, ours in zip(("impact", "impact_2"), impact_times(result, scene)):
        case.assert_close(f"{label}: time of {name}", reference[name], ours, 1e-3, SOURCE)
    for peak, gate in zip(("peak_1", "peak_2"), peak_gates):
        case.assert_close(f"{label}: {peak}", reference[peak], heights[int(peak[-1]) - 1], gate, SOURCE)
    after = result.at("impulse_floor.z", reference["impact"] + 1.2 * reference["contact"])
    case.assert_close(f"{label}: impulse of bounce 1", reference["impulse"], after, 0.01, SOURCE)
    taken = result.history["walls"] / reference["energy"]
    case.assert_below(f"{label}: energy taken by bounce 1", numpy.interp(reference["impact_2"] - 0.5,
                                                                       result.history["time"], taken), 0.01, "share")
    case.assert_below(f"{label}: energy created by the floor", max(0, -taken.min()), 1e-12)
    case.assert_below(f"{label}: energy identity", result.summary["energy"]["error_ratio"], 1e-10)
    case.assert_below(f"{label}: momentum", result.summary["momentum_error"], 1e-10)
    return heights


def main():
    case = Case(__file__)
    case.answer(errors)
    scene = case.scene()
    result = case.run()
    heights = {"reference": [exact(scene)[f"peak_{k}"] for k in (1, 2, 1)], 100: check(case, "N = 100", result, scene, (0.01, 0.04))}
    fine = {"mesh.0.box.elements": [1, 1, 500]}
    heights[500] = check(case, "N = 500", case.run(overrides=fine, name="N500"), scene, (0.01, 0.01))
    if case.long:
        finer = {"mesh.0.box.elements": [1, 1, 1000]}
        heights[1000] = check(case, "N = 1000", case.run(overrides=finer, name="N1000"), scene, (0.01, 0.01))
    case.table("peaks", ["elements", "peak 1 [1e-3]", "peak 2 [1e-3]", "peak 3 [1e-3]"],
               [[count, *(f"{1e3 * p:.4f}" for p in peak[:3])] for count, peak in heights.items()])
    two = {"run.end": 4}
    case.assert_same_on_ranks((1, 2, 3, 4, 7) if case.long else (1, 3), restarted=True, overrides=two)
    case.assert_same_after_restart(case.run(overrides=two, name="two"), 1.3, overrides=two)
    case.finish()


if __name__ == "__main__":
    main()
