#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""picture.png (deformed shells) and error_time.png from the results of check.py --long: cases/shell_benchmarks/picture.py build/cases/shell_benchmarks"""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../support"), os.path.join(HERE, "../../scripts/lib")]
import results  # noqa: E402
from state import State  # noqa: E402

SHOWN = [("roof_shell4_16", "Scordelis-Lo roof, x 10 000", 1e4, (20, -60)),
         ("pinched_cylinder_shell4_16", "pinched cylinder, x 4e6", 4e6, (25, 40)),
         ("hemisphere_shell4_16", "hemisphere, x 20 000", 2e4, (25, 35)),
         ("twisted_beam_along_its_tip_shell4_32", "twisted beam, x 200", 200, (25, -60)),
         ("elastica_alpha_10_deflection_shell4_16", "large end load, x 1", 1, (12, -70)),
         ("roll-up_1_of_a_circle_end_along_over_L_shell4_32", "roll-up, x 1", 1, (12, -70))]
COLOURS = {"shell4": "tab:blue", "shell4_full": "tab:orange", "shell3": "tab:green", "hex8": "0.4"}


def draw(axes, folder, title, factor, view):
    state = State(folder)
    start, places = state.positions(state.records[0], 0), state.positions(state.records[-1], factor)
    for _, _, elements, *_ in state.blocks():
        for points, colour, alpha in ((start, "0.7", 0.25), (places, "tab:blue", 0.9)):
            axes.add_collection3d(Poly3DCollection(points[elements], facecolors=colour, edgecolors="white" if alpha > 0.5 else "0.6",
                                                   linewidths=0.3, alpha=alpha))
    both = numpy.concatenate([start, places])
    low, high = both.min(0), both.max(0)
    size = numpy.maximum(high - low, 0.05 * (high - low).max())
    axes.set(xlim=(low[0], low[0] + size[0]), ylim=(low[1], low[1] + size[1]), zlim=(low[2], low[2] + size[2]))
    axes.set_box_aspect(size)
    axes.view_init(*view)
    axes.set_axis_off()
    axes.set_title(title, fontsize=10)


def error_against_time(rows):
    problems = list(dict.fromkeys(row[0] for row in rows))
    chosen = [name for name in problems if "thin" not in name and "skewed" not in name and "shortening" not in name][:9]
    figure, grid = plt.subplots(3, 3, figsize=(12, 10), layout="constrained", sharex=True)
    for axes, name in zip(grid.ravel(), chosen):
        for element, colour in COLOURS.items():
            mine = [(float(row[5]), abs(float(row[3]) - 1)) for row in rows if row[0] == name and row[1] == element]
            if mine:
                axes.loglog(*zip(*mine), "o-", color=colour, label=element, markersize=4)
        axes.axhline(0.02, color="black", linewidth=0.8, linestyle=":")
        axes.set_title(name, fontsize=10)
    grid[0, 0].legend()
    for axes in grid[-1]:
        axes.set_xlabel("processor time [s]")
    for axes in grid[:, 0]:
        axes.set_ylabel("error")
    figure.savefig(os.path.join(HERE, "error_time.png"), dpi=80)


def main():
    folder = sys.argv[1]
    figure = plt.figure(figsize=(13, 8), layout="constrained")
    for k, (name, title, factor, view) in enumerate(SHOWN):
        draw(figure.add_subplot(2, 3, k + 1, projection="3d"), os.path.join(folder, name), title, factor, view)
    figure.savefig(os.path.join(HERE, "picture.png"), dpi=80)
    stored = results.load(os.path.join(folder, "results.json"))
    if "long" in stored:
        error_against_time(stored["long"]["tables"]["errors"]["rows"])


main()
