#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Two cubes face to face: momentum, bounds of the force from plane waves, symmetries, the same bits on any ranks."""
import os
import sys

import h5py
import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402


def refined(bodies, elements):
    return {f"mesh.{body}.box.elements": [elements] * 3 for body in range(bodies)}


def plane_wave(scene):
    """Speed of dilatational waves; force while the whole face knows nothing of its sides; momentum brought along."""
    steel = scene["materials"]["steel"]
    young, poisson, density = steel["young"], steel["poisson"], steel["density"]
    modulus = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson))
    speed = numpy.sqrt(modulus / density)
    side = scene["mesh"][0]["box"]["size"][0]
    approach = scene["initial"][0]["velocity"][1]
    return speed, density * speed * approach / 2 * side**2, density * side**3 * approach


def check_force(case, label, result, scene, elements):
    """Unloading enters the face from its four edges at no more than the speed of dilatational waves."""
    speed, force, _ = plane_wave(scene)
    side = scene["mesh"][0]["box"]["size"][0]
    transit = side / speed
    time = 0.2 * transit
    instants = numpy.linspace(0, time, 1001)
    least = numpy.trapz(force * (1 - 2 * instants / transit)**2, instants)
    # half a layer of elements stops in the first step, not after a wave has passed through it
    element = 0.5 * force * transit / elements
    case.assert_within(f"{label}: impulse in the first fifth of a transit [lbf s]", least - element,
                       force * time + element, result.at("impulse_force.y", time), "plane waves, see README")


def check_symmetry(case, label, folder, elements):
    """Mirror planes x = 1/2, z = 1/2, x = z, and y = 1 as seen by an observer who moves with the common centre."""
    with h5py.File(os.path.join(folder, "state.h5")) as file:
        nodes = file["mesh/coordinates"][...]
        record = max((group for name, group in file.items() if name.startswith("record_")),
                     key=lambda group: group.attrs["step"])
        velocity = record["node/velocity"][...] - [0, 250, 0]
    # the two bodies have nodes of their own in the plane y = 1: number them apart
    half = len(nodes) // 2
    key = [(i >= half, *numpy.rint(x * elements).astype(int)) for i, x in enumerate(nodes)]
    grid = {k: i for i, k in enumerate(key)}
    mirrors = {"x": (lambda b, x, y, z: (b, elements - x, y, z), lambda v: v * [-1, 1, 1]),
               "z": (lambda b, x, y, z: (b, x, y, elements - z), lambda v: v * [1, 1, -1]),
               "x = z": (lambda b, x, y, z: (b, z, y, x), lambda v: v[:, [2, 1, 0]]),
               "y": (lambda b, x, y, z: (not b, x, 2 * elements - y, z), lambda v: v * [1, -1, 1])}
    for name, (place, turn) in mirrors.items():
        other = [grid[place(*k)] for k in key]
        error = numpy.abs(velocity[other] - turn(velocity)).max() / 250
        gate = 1e-4 if name == "y" else 1e-8  # one pass takes its normals from one side of y = 1
        case.assert_below(f"{label}: velocities seen in the mirror {name} differ by", error, gate, "symmetry")


def main():
    case = Case(__file__)
    scene = case.scene()
    approach = scene["initial"][0]["velocity"][1]
    _, _, momentum = plane_wave(scene)
    for elements in (2, 8, 24, 48) if case.long else (2, 8, 24):
        label = f"2 x {elements}^3"
        two = case.run(overrides=refined(2, elements), name=f"blocks_{elements}")
        wall = case.run("wall.yaml", overrides=refined(1, elements), name=f"wall_{elements}")
        case.assert_close(f"{label}: momentum [lbf s]", momentum, two.last("momentum_y"), 1e-12, "conservation")
        check_force(case, label, two, scene, elements)
        for name, ours, reference in (("impulse [lbf s]", two.last("impulse_force.y"), wall.last("impulse_force.y")),
                                      ("velocity of block2 [in/s]", two.last("block2.y"),
                                       wall.last("block2.y") + approach / 2),
                                      ("energy taken by contact [in lbf]", two.last("contact"),
                                       2 * wall.last("walls"))):
            case.assert_close(f"{label}: {name}, wall in the plane of symmetry", reference, ours, 1e-6, "symmetry")
        # the layer of half an element at the face stops as one lump (see bar_impact); nodes that touch again add to it
        energy = 0.5 * momentum * approach
        case.assert_below(f"{label}: energy taken by contact / (1.5 x end layers' share)",
                          two.last("contact") / (1.5 * energy / (4 * elements)), 1, "end layers, inelastic")
        created = max(0, -two.history["contact"].min()) / energy
        case.assert_below(f"{label}: energy created by contact / initial", created, 1e-12)
        case.assert_energy(two, energy_gate=1e-10, momentum_gate=1e-12)
        check_symmetry(case, label, two.folder, elements)

    case.assert_same_on_ranks((1, 2, 3, 4, 7) if case.long else (1, 2, 3), restarted=True, overrides=refined(2, 8))
    case.assert_same_after_restart(case.run(overrides=refined(2, 8), name="blocks_8"), 1.0e-5, overrides=refined(2, 8))
    case.finish()


if __name__ == "__main__":
    main()
