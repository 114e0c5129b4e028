#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Two steel cubes at 100 m/s, elastic and plastic: what contact takes, and that it does not shorten the step."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

PLASTIC = {"materials.steel.model": "j2", "materials.steel.yield": 0.4, "materials.steel.hardening": 1.0}
FREE = {"contact": None, "probes": None}  # the cubes pass through each other
PEER_GROWTH = 135 / 69  # OpenRadioss on this scene: cycles with TYPE25 contact over cycles without


def refined(elements):
    return {f"mesh.{body}.box.elements": [elements] * 3 for body in range(2)}


def main():
    case = Case(__file__)
    scene = case.scene()
    material, box = scene["materials"]["steel"], scene["mesh"][0]["box"]
    speed = scene["initial"][0]["velocity"][0]
    volume = box["size"][0] * box["size"][1] * box["size"][2]
    momentum = material["density"] * volume * speed
    energy = 0.5 * momentum * speed
    print("| scene | steps | without contact | taken by contact | contact ends, striker, target [m/s] | loop [s] |")
    print("|---|---|---|---|---|---|")
    for elements in (20, 40) if case.long else (20,):
        for kind, law in (("elastic", {}), ("plastic", PLASTIC)):
            label = f"{kind}, 2 x {elements}^3"
            overrides = {**refined(elements), **law}
            ours = case.run(overrides=overrides, name=f"{kind}_{elements}")
            free = case.run(overrides={**overrides, **FREE}, name=f"{kind}_{elements}_free")
            taken, steps = ours.history["contact"], ours.summary["steps"]
            print(f"| {label} | {steps} | {free.summary['steps']} | {taken[-1] / energy:.3%} | "
                  f"{ours.last('striker.x'):.2f}, {ours.last('target.x'):.2f} | {ours.summary['loop_s']:.2f} |")
            # compressed elements are thinner: the step may shrink by the strain behind the wave, not by contact
            case.assert_close(f"{label}: steps with contact / without", 1, steps / free.summary["steps"], 0.05,
                              "free flight of the same cubes")
            case.assert_below(f"{label}: growth of steps by contact / OpenRadioss's", steps / free.summary["steps"]
                              / PEER_GROWTH, 1, "TYPE25, see README")
            case.assert_below(f"{label}: energy taken by contact / (1.2 x end layers' share)",
                              taken[-1] / (1.2 * energy / (4 * elements)), 1, "inelastic impact of the end layers")
            case.assert_below(f"{label}: energy created by contact / initial", max(0, -taken.min()) / energy, 1e-12)
            case.assert_close(f"{label}: momentum [kg m/s]", momentum, ours.last("momentum_x"), 1e-12, "conservation")
            if kind == "elastic":  # released by now, with more than clinging and less than a lossless impact gives
                case.assert_within(f"{label}: velocity of the target [m/s]", speed / 2, speed, ours.last("target.x"),
                                   "clinging and lossless impact")
            case.assert_energy(ours, energy_gate=1e-10, momentum_gate=1e-12)
    short = {"run.end": 0.02, **PLASTIC}
    case.assert_same_on_ranks((1, 2, 3, 4, 7) if case.long else (1, 2, 3), overrides=short)
    whole = case.run(overrides=short, name="whole")
    case.assert_same_after_restart(whole, 0.01, overrides=short)
    case.finish()


if __name__ == "__main__":
    main()
