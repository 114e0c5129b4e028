#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Rubber cubes fall into a box and come to rest: none stands in another, the books close (see README)."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402
from overlap import Bodies  # noqa: E402


def check(case, name):
    scene = case.scene(name)
    result = case.run(name, name=name[:-5])
    side, count = scene["mesh"][0]["box"]["size"][0], len(scene["mesh"])
    weight = count * scene["materials"]["rubber"]["density"] * side**3 * -scene["gravity"]["vector"][2]
    bodies, end = Bodies(result), scene["run"]["end"]
    label = f"{count} cubes"
    depth, one, other = bodies.deepest(end)
    case.assert_below(f"{label}: deepest point of one in another at rest / side", depth / side, 1e-3, "by positions alone")
    x, _ = bodies.positions(end)
    for wall in scene["rigid_walls"]:
        least = ((x - numpy.array(wall["point"])) @ numpy.array(wall["normal"])).min()
        case.assert_below(f"{label}: node behind the wall {wall['name']} / side", min(0.0, least) / side, 1e-3, "positions")
    history = result.history
    late = history["time"] > 0.9 * end
    case.assert_below(f"{label}: kinetic energy of the last tenth / (weight x side)",
                      numpy.abs(history["kinetic"][late]).max() / (weight * side), 1e-6, "at rest")
    rows = numpy.flatnonzero(late)
    force = (history["impulse_floor.z"][rows[-1]] - history["impulse_floor.z"][rows[0]]) / numpy.ptp(history["time"][late])
    # friction on the sides of the box may carry some
    case.assert_within(f"{label}: force on the floor / weight", 0.9, 1.001, force / weight, "statics")
    energy = result.summary["energy"]
    case.assert_within(f"{label}: energy that friction and contact remove", 0, numpy.inf, min(energy["friction"], energy["contact"]))
    case.assert_energy(result, energy_gate=1e-10, momentum_gate=1e-10)
    worst = max((bodies.deepest(time) for time in numpy.arange(0.05, end, 0.05)), key=lambda found: found[0])
    contact, summary = result.summary["contact"], result.summary
    case.row("depths", ["cubes", "deepest point at rest / side", "on the way / side", "largest penetration that contact reports / side",
                        "iterations of contact, mean and most", "steps at their limit", "steps", "loop [s]"],
             [count, f"{depth / side:.1e}", f"{worst[0] / side:.1e}", f"{summary['max_penetration'] / side:.1e}",
              f"{contact['iterations_mean']:.1f}, {contact['iterations_max']}", contact["steps_at_limit"], summary["steps"], summary["loop_s"]])


def main():
    case = Case(__file__)
    check(case, "eight.yaml")
    if case.long:
        check(case, "scene.yaml")
    case.assert_same_on_ranks((1, 3), scene="eight.yaml", overrides={"run.end": 0.1})
    case.finish()


if __name__ == "__main__":
    main()
