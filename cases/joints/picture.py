#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""picture.png from the results of check.py: cases/joints/picture.py build/cases/joints

The parts seen along y at some times: elements, the path of the pendulum's tip, and the times in the titles.
"""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../support"), os.path.join(HERE, "../../scripts/lib")]
from case_check import Result  # noqa: E402
from state import State  # noqa: E402

SIDE = [0, 1, 5, 4]  # of a hexahedron of a box along its axes: the face of least y


def draw(axes, folder, times, colours):
    state = State(folder)
    for k, time in enumerate(times):
        places = state.positions(state.record_at(time))[:, [0, 2]]
        for (_, _, elements, _), colour in zip(state.blocks(), colours):
            axes.add_collection(PolyCollection(places[elements[:, SIDE]], facecolors=colour, edgecolors=colour, linewidths=0.8,
                                               alpha=0.15 + 0.85 * k / max(1, len(times) - 1)))
    axes.set(aspect="equal", xlabel="x [m]")
    axes.autoscale_view()


def main():
    folder = sys.argv[1]
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(13, 4.4), gridspec_kw={"width_ratios": (1.2, 1, 1)}, layout="constrained")
    name = os.path.join(folder, "double_0.0005")
    tip = Result(name).history
    left.plot(tip["tip.x"], tip["tip.z"], color="0.6", linewidth=0.8)
    draw(left, name, numpy.linspace(0, 1.0, 9), ("tab:blue", "tab:orange"))
    left.set(ylabel="z [m]", title="double pendulum, 0 to 1 s; path of the tip to 2 s")
    draw(middle, os.path.join(folder, "four_bar_0.001"), (0, 0.25, 0.5, 0.75), ("tab:blue", "tab:green", "tab:orange"))
    middle.set_title("parallelogram, 0 to 0.75 s")
    draw(right, os.path.join(folder, "blow_1e-05"), (0, 0.005, 0.01, 0.02, 0.03), ("0.3", "tab:blue", "tab:orange", "tab:green"))
    right.set_title("links under a blow, 0, 5, 10, 20, 30 ms")
    for axes in (left, middle, right):
        axes.title.set_fontsize(10)
    figure.savefig(os.path.join(HERE, "picture.png"), dpi=80)


main()
