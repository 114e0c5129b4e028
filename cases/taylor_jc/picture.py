#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""picture.png from the results of check.py --long: cases/taylor_jc/picture.py build/cases/taylor_jc"""
import glob
import os
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../support"))
from case_check import Result  # noqa: E402
from check import FACE_GATE, LENGTH_GATE, STUDY, last_state, measured, metal, sizes  # noqa: E402

FACES = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (0, 3, 2, 1), (4, 5, 6, 7)]
COLOURS = {"copper": "tab:orange", "steel": "tab:blue", "aluminium": "tab:grey"}


def profile(axes, folder, number, across=8):
    """The plane y = 0, or what is nearest to it, with the measured length and foot."""
    row, result = measured()[number], Result(os.path.join(folder, f"row{number}_hex8_{across}"))
    start, moved, fields = last_state(result)
    with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
        corners = state["mesh/connectivity"][:]
    polygons, strain = [], []
    for face in FACES:
        nodes = corners[:, face]
        here = numpy.flatnonzero((abs(start[nodes][:, :, 1]) < 1e-9).all(axis=1))
        polygons += list(1e3 * moved[nodes[here]][:, :, [0, 2]])
        strain += list(fields["plastic_strain"].ravel()[here])
    drawn = PolyCollection(polygons, array=numpy.array(strain), cmap="viridis", edgecolors="white", linewidths=0.2)
    drawn.set_clim(0, 1.5)
    axes.add_collection(drawn)
    low = 1e3 * moved[:, 2].min()
    axes.axhline(low + 1e3 * row["length"], color="red", linestyle="--", linewidth=1)
    axes.plot(numpy.array([-0.5, 0.5]) * 1e3 * row["face"], [low - 0.25, low - 0.25], color="red", linewidth=3)
    axes.set(title=f"{metal(row['name'])}, {row['V']:.0f} m/s", xlim=(-10, 10), ylim=(low - 1, low + 24), aspect="equal", xlabel="[mm]")
    return drawn


def scatter(axes, folder, what, gate):
    for number, row in enumerate(measured()):
        found = sorted(glob.glob(os.path.join(folder, f"row{number}_hex8_[0-9]")))
        if not found or not row[what]:
            continue
        length, face = sizes(Result(found[-1]))
        of = row["L"] if what == "length" else row["D"]
        ours = length if what == "length" else face
        hot = row["T"] > 300
        axes.plot(row[what] / of, ours / of, "s" if hot else "o", color=COLOURS[metal(row["name"])],
                  markerfacecolor="none" if hot else None)
    ends = numpy.array(axes.get_xlim())
    axes.fill_between(ends, (1 - gate) * ends, (1 + gate) * ends, color="0.9", zorder=0)
    axes.plot(ends, ends, color="black", linewidth=1)
    axes.set(xlim=ends, title=f"{what if what == 'length' else 'diameter of the foot'} over the rod's; band: {100 * gate:.0f} %",
             xlabel="measured", ylabel="ours")
    for name, colour in COLOURS.items():
        axes.plot([], [], "o", color=colour, label=name)
    axes.plot([], [], "s", color="black", markerfacecolor="none", label="hot")
    axes.legend()


def main():
    folder = sys.argv[1]
    figure, axes = plt.subplots(1, 5, figsize=(24, 6), gridspec_kw={"width_ratios": [1, 1, 1, 1.6, 1.6]}, layout="constrained")
    for place, number in zip(axes, STUDY.values()):
        drawn = profile(place, folder, number)
    figure.colorbar(drawn, ax=axes[2], label="plastic strain")
    scatter(axes[3], folder, "length", LENGTH_GATE)
    scatter(axes[4], folder, "face", FACE_GATE)
    figure.savefig(os.path.join(HERE, "picture.png"), dpi=70)


if __name__ == "__main__":
    main()
