#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""picture.png from the results of check.py: cases/plate_impact/picture.py build/cases/plate_impact"""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../support"))
import yaml  # noqa: E402
from case_check import Result, SceneLoader  # noqa: E402
from check import Spall  # noqa: E402
from shock import Column, Metal, PlasticShock, match, records  # noqa: E402

EXACT = {"color": "black", "linewidth": 1, "linestyle": "--", "label": "exact"}


def scene(name):
    with open(os.path.join(HERE, name), encoding="utf-8") as stream:
        return yaml.load(stream, SceneLoader)


def last(folder, name):
    result = Result(os.path.join(folder, name))
    return Column(result, records(result) - 1)


def steps(axes, edges, values, **style):
    x = [edge for edge in edges for _ in (0, 1)]
    y = [0, *(value for value in values for _ in (0, 1)), 0]
    axes.plot(x, y, **style)


def impact(axes, folder):
    laws = scene("scene.yaml")["materials"]
    flyer, target = Metal(laws["copper"]), Metal(laws["aluminium"])
    u, p = match(flyer, target, 2000)
    for elements, style in ((50, ":"), (100, "-")):
        column = last(folder, f"copper_aluminium_2000_{elements}")
        axes.plot(1e3 * column.x, column.pressure / 1e9, style, color="tab:blue", label=f"{elements} elements a body")
    reach = [1e3 * column.time * speed for speed in (-flyer.shock_speed(2000 - u), target.shock_speed(u))]
    steps(axes, reach, [p / 1e9], **EXACT)
    axes.set(title=f"copper on aluminium, 2000 m/s, {1e6 * column.time:.2f} us", xlabel="reference place [mm]",
             ylabel="pressure [GPa]", xlim=(1.4 * reach[0], 1.15 * reach[1]))
    axes.axvline(0, color="grey", linewidth=0.5)
    axes.legend()


def plastic(axes, folder):
    column = last(folder, "strength")
    exact = PlasticShock(scene("strength.yaml")["materials"]["aluminium"], 150)
    axes.plot(1e3 * column.x, column.axial / 1e9, color="tab:blue", label="axial stress, 200 elements a body")
    far, near = (1e3 * column.time * front for front in exact.front)
    low, high = (stress / 1e9 for stress in exact.stress)
    steps(axes, [-far, -near, near, far], [low, high, low], **EXACT)
    axes.set(title=f"aluminium on aluminium with strength, 300 m/s, {1e6 * column.time:.2f} us", xlabel="reference place [mm]",
             ylabel="axial stress [GPa]", xlim=(-5, 5))
    axes.legend(loc="lower center")


def spalled(axes, folder):
    spall = Spall(scene("spall.yaml"))
    for name, label, colour in (("spall_200", "least pressure -1 GPa", "tab:blue"),
                                ("eroded_200", "eroded at -1 GPa", "tab:orange")):
        history = Result(os.path.join(folder, name)).history
        axes.plot(1e6 * history["time"], history["rear.x"], color=colour, label=label)
    axes.axhline(spall.speed - spall.pull_back, **{**EXACT, "label": "v - 2 P/(rho c)"})
    axes.axvline(1e6 * spall.arrival, color="grey", linewidth=0.5)
    axes.set(title="spall: velocity of the free surface", xlabel="time [us]", ylabel="velocity [m/s]", xlim=(0.8, 3))
    axes.legend(loc="lower left")


def main():
    figure, axes = plt.subplots(1, 3, figsize=(18, 5))
    for draw, place in zip((impact, plastic, spalled), axes):
        draw(place, sys.argv[1])
    figure.tight_layout()
    figure.savefig(os.path.join(HERE, "picture.png"), dpi=70)


if __name__ == "__main__":
    main()
