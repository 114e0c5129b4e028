#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Two steel cubes at 100 m/s, elastic and plastic: what contact takes, and that it does not shorten the step."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

PLASTIC = {"materials.steel.model": "j2", "materials.steel.yield": 0.4, "materials.steel.hardening": 1.0}
FREE = {"contact": None, "probes": None}  # the cubes pass through each other
BULK = (0.06, 1.2)  # the default bulk viscosity
PEER_GROWTH = 135 / 69  # OpenRadioss on this scene: cycles with TYPE25 contact over cycles without
# Other programs on this scene, 2 x 20^3: columns as in the table of steps. OpenRadioss of August 2026, CalculiX 2.20 explicit; on
# another, faster machine. Their loss of energy is the error of their balance.
PEERS = {"OpenRadioss, TYPE25": (135, 69, "1.96", "2.1 (elastic), 0.1 (plastic)", None, "0.46 to 0.64", None),
         "OpenRadioss, TYPE7": (233, 69, "3.4", None, None, None, None),
         "CalculiX": (None, None, None, "0.13", None, "11.8", None)}


def refined(elements):
    return {f"mesh.{body}.box.elements": [elements] * 3 for body in range(2)}


def uniaxial_stress(law, strain):
    """Pressure along the axis of uniaxial compression; the limit beyond which steel yields; the elastic modulus."""
    young, nu = law["young"], law["poisson"]
    shear, bulk = young / (2 * (1 + nu)), young / (3 * (1 - 2 * nu))
    modulus = bulk + 4 / 3 * shear
    if law["model"] == "elastic":
        return modulus * strain, None, modulus
    limit = law["yield"] * (1 - nu) / (1 - 2 * nu)
    hardening = law["hardening"]
    tangent = bulk + 4 / 3 * shear * hardening / (3 * shear + hardening)
    return min(modulus * strain, limit + tangent * (strain - limit / modulus)), limit, modulus


def closing_share(scene, law, elements, dt):
    """What contact takes as the faces meet, as a multiple of energy/(4N), and a bound of what it may take later.

    A gap of n + r steps of free flight closes in two: the first impulse leaves r of the approach, the second takes it
    against the pressure that the elements at the face have by then (see README).
    """
    size, approach = scene["mesh"][0]["box"]["size"][0], scene["initial"][0]["velocity"][0]
    gap = scene["mesh"][1]["box"]["at"][0] - size
    left = gap / (approach * dt) % 1
    element, speed, density = size / elements, approach / 2, law["density"]
    rate = (1 - left) * speed / element
    stress, limit, modulus = uniaxial_stress(law, rate * dt)
    sound = (modulus / density)**0.5
    stress += density * element * rate * (BULK[0] * sound + BULK[1]**2 * element * rate)
    again = 0 if limit is None else (2 * limit / (density * sound * approach))**2
    return 1 + 2 * stress * dt * left / (density * element * speed), again


def main():
    case = Case(__file__)
    scene = case.scene()
    material, box = scene["materials"]["steel"], scene["mesh"][0]["box"]
    speed = scene["initial"][0]["velocity"][0]
    volume = box["size"][0] * box["size"][1] * box["size"][2]
    momentum = material["density"] * volume * speed
    energy = 0.5 * momentum * speed
    rows = []
    for elements in (20, 40) if case.long else (20,):
        for kind, law in (("elastic", {}), ("plastic", PLASTIC)):
            yielding = {key.split(".")[-1]: value for key, value in law.items()}
            label = f"{kind}, 2 x {elements}^3"
            overrides = {**refined(elements), **law}
            ours = case.run(overrides=overrides, name=f"{kind}_{elements}")
            free = case.run(overrides={**overrides, **FREE}, name=f"{kind}_{elements}_free")
            taken, steps = ours.history["contact"], ours.summary["steps"]
            rows.append([label, steps, free.summary["steps"], f"{steps / free.summary['steps']:.2f}", f"{100 * taken[-1] / energy:.2f}",
                         f"{ours.last('striker.x'):.1f}, {ours.last('target.x'):.1f}", f"{1e-3 * ours.summary['ns_per_element_step']:.3f}",
                         ours.summary["loop_s"]])
            # Compressed elements are thinner: the step may shrink by the strain behind the wave, not by contact. In plastic
            # cubes the layers at the face are pressed flat, and the frequency of a mesh follows the thickness of its
            # elements: the step ends 6.5 % shorter, while that of a free element of constant volume hardly changes.
            case.assert_close(f"{label}: steps with contact / without", 1, steps / free.summary["steps"], 0.07,
                              "free flight of the same cubes")
            case.assert_below(f"{label}: growth of steps by contact / OpenRadioss's", steps / free.summary["steps"]
                              / PEER_GROWTH, 1, "TYPE25, see README")
            share, again = closing_share(scene, {**material, **yielding}, elements, ours.history["dt"][0])
            layers = energy / (4 * elements)
            case.assert_close(f"{label}: energy taken as the faces meet / layers' share", share,
                              numpy.interp(5e-3, ours.history["time"], taken) / layers, 1e-2, "end layers, see README")
            case.assert_within(f"{label}: energy taken by contact / layers' share", 0.99 * share,
                               1.03 * share + again, taken[-1] / layers, "end layers, and once more as they part")
            case.assert_below(f"{label}: energy created by contact / initial", max(0, -taken.min()) / energy, 1e-12)
            case.assert_close(f"{label}: momentum [kg m/s]", momentum, ours.last("momentum_x"), 1e-12, "conservation")
            if kind == "elastic":  # released by now, with more than clinging and less than a lossless impact gives
                case.assert_within(f"{label}: velocity of the target [m/s]", speed / 2, speed, ours.last("target.x"),
                                   "clinging and lossless impact")
            case.assert_energy(ours, energy_gate=1e-10, momentum_gate=1e-12)
    peers = [[name, *("" if value is None else str(value) for value in cells)] for name, cells in PEERS.items()]
    case.table("steps", ["cubes", "steps with contact", "without contact", "growth by contact", "energy taken by contact [%]",
                         "velocities at the end [m/s]", "time per element and step [us]", "loop [s]"], rows + peers)
    short = {"run.end": 0.02, **PLASTIC}
    case.assert_same_on_ranks((1, 2, 3, 4, 7) if case.long else (1, 2, 3), restarted=True, overrides=short)
    whole = case.run(overrides=short, name="whole")
    case.assert_same_after_restart(whole, 0.01, overrides=short)
    case.finish()


if __name__ == "__main__":
    main()
