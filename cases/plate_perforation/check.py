#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Hard projectiles with three noses go through a steel plate: balances, plug, residual velocities beside the measured ones."""
import os
import sys

import h5py
import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

# Measured (impact, residual) [m/s], blunt; limit 184.5 (T. Borvik et al. 2002, from memory: README.md).
MEASURED = ((303.5, 199.7), (285.4, 181.1), (244.2, 132.6), (224.7, 113.7), (200.4, 71.4))
# Ours [m/s], 0.5 mm, by impact. No gate comes from the measured ones: see README.md.
OURS = {300.0: 195.6, 303.5: 200.5, 285.4: 177.9, 244.2: 89.5, 224.7: 52.1}
WHOLE = 360 / 6  # sectors in the plate
HALF = numpy.radians(3)  # of a sector
EDGE = 0.5e-3  # of elements in the shear band [m]


def velocity_of(result):
    """Mean over the last tenth of the run: the projectile rings."""
    time, velocity = result.history["time"], -result.history["shot.z"]
    return velocity[time > 0.9 * time[-1]].mean()


def plug_of(result, density):
    """Mass of the plate [kg] that flies off, and its mean velocity: of living elements below the plate."""
    with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
        record = state[max(key for key in state if key.startswith("record"))]
        start, moved = state["mesh/coordinates"][:], record["node/displacement"][:]
        velocity = record["node/velocity"][:]
        corners, alive = state["mesh/connectivity"][:], record["element/alive"][:].ravel() > 0
    at = start[:, 2] + moved[:, 2]
    plate = (start[corners][:, :, 2].max(axis=1) <= 6.0e-3 + 1e-9) & alive
    gone = plate & (at[corners].mean(axis=1) < -8.0e-3) & (start[corners][:, :, 0].mean(axis=1) < 12e-3)
    x = start[corners[gone]]
    ring = [1, 2, 3, 7, 4, 5, 1]
    diagonal = x[:, 6] - x[:, 0]
    volume = sum(numpy.einsum("ei,ei->e", diagonal, numpy.cross(x[:, i] - x[:, 0], x[:, j] - x[:, 0]))
                 for i, j in zip(ring, ring[1:])) / 6
    mass = abs(volume) * density
    speed = -velocity[corners[gone]].mean(axis=1)[:, 2]
    return WHOLE * mass.sum(), (mass * speed).sum() / mass.sum() if mass.sum() > 0 else 0.0


def profile(start, moved):
    """The outline of the projectile in the plane y = 0: radius over height, at the nodes of its nose and side."""
    shot = (start[:, 2] > 6.02e-3) & (abs(start[:, 1]) < 1e-9)
    height, radius = moved[shot][:, 2].round(9), moved[shot][:, 0]
    levels = numpy.unique(height)
    return levels, numpy.array([radius[height == level].max() for level in levels])


def deepest_inside(result):
    """How deep a node of the plate lies in the rigid projectile at the end [m]; between its planes faces are flat."""
    with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
        start = state["mesh/coordinates"][:]
        moved = start + state[max(key for key in state if key.startswith("record"))]["node/displacement"][:]
    heights, radii = profile(start, moved)
    at = moved[start[:, 2] < 6.02e-3]
    at = at[(at[:, 2] > heights[0]) & (at[:, 2] < heights[-1])]
    turned = numpy.arctan2(at[:, 1], at[:, 0]) - HALF
    across = numpy.hypot(at[:, 0], at[:, 1]) * numpy.cos(turned) / numpy.cos(HALF)
    depth = numpy.minimum(numpy.interp(at[:, 2], heights, radii) - across, at[:, 2] - heights[0])
    return depth.max(initial=0.0)


def check_nose(case, nose):
    """A pointed nose at 300 m/s, as far as the time of a test allows: the plate is on its way to be perforated."""
    result = case.run(f"{nose}.yaml", overrides={"run.end": 25.0e-6}, name=nose, ranks=2)
    case.assert_energy(result, energy_gate=1e-10, momentum_gate=1e-10)
    case.assert_below(f"{nose}: node of the plate in the projectile / element", deepest_inside(result) / EDGE, 0.05, "none")
    # corners of hex8_bbar turn inside out under the tip before they erode (README, limits)
    case.assert_below(f"{nose}: elements that have folded / all", result.summary["folded_elements"] /
                      result.summary["elements"], 5e-3, "few")
    case.assert_within(f"{nose}: energy eroded / total", 1e-4, 0.1, result.summary["energy"]["eroded"] /
                       result.summary["energy"]["total"], "the surface of the hole")


def main():
    case = Case(__file__)
    result = case.run(ranks=case.of_all(2, 1))
    scene = case.scene()
    impact = -scene["initial"][0]["velocity"][2]
    residual, (mass, speed) = velocity_of(result), plug_of(result, scene["materials"]["weldox"]["density"])
    shot = WHOLE * result.history["momentum_z"][0] / -impact
    case.assert_energy(result, energy_gate=1e-10, momentum_gate=1e-10)
    case.assert_within("residual velocity [m/s]", 0, impact * shot / (shot + mass), residual,
                       "momentum: the plug is as fast or faster (R. F. Recht, T. W. Ipson 1963)")
    if impact in OURS:
        case.assert_close("residual velocity, regression [m/s]", OURS[impact], residual, 0.03, "ours; measured 199.7 at 303.5")
    case.assert_within("mass of the plug [kg]", 15.1e-3, 36.0e-3, mass, "measured plugs")
    case.assert_within("velocity of the plug / projectile's", 0.95, 1.5, speed / residual, "it flies ahead")
    case.assert_below("deepest penetration / element", result.summary["max_penetration"] / EDGE, 0.01, "none")
    short = {"run.end": 13.5e-6}  # the cone erodes the plate from 8 us on
    case.assert_same_on_ranks((1, 2, 3, 4) if case.long else (1, 3), restarted=True, scene="conical.yaml", overrides=short)
    middle = case.run("conical.yaml", overrides={**short, "checkpoint.every": 11.0e-6}, name="middle")
    case.assert_within("conical: elements gone when bits are compared", 3, 100, middle.summary["removed_elements"], "some")
    case.assert_same_after_restart(middle, 11.0e-6, scene="conical.yaml", overrides=short)
    case.assert_energy(middle, energy_gate=1e-10, momentum_gate=1e-10)
    if case.long:
        for nose in ("hemispherical", "conical"):
            check_nose(case, nose)
        for speed, measured in MEASURED[:4]:
            run = case.run(overrides={"initial.0.velocity": [0, 0, -speed], "run.end": 150e-6}, name=f"v{speed:.0f}")
            case.assert_close(f"residual velocity at {speed} m/s [m/s]", OURS[speed], velocity_of(run), 0.05,
                              f"regression; measured {measured}")
    case.finish()


if __name__ == "__main__":
    main()
