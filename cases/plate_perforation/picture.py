#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The plane y = 0 of results (say, one a nose) at some times, with damage: picture.py RESULT ... [-o picture.png]."""
import argparse
import os

import h5py
import matplotlib
import numpy

matplotlib.use("Agg")
import matplotlib.pyplot as plot  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("results", nargs="+")
parser.add_argument("-o", "--output", default=os.path.join(os.path.dirname(os.path.abspath(__file__)), "picture.png"))
parser.add_argument("--times", default="20e-6,60e-6,100e-6")
given = parser.parse_args()

FACES = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (0, 3, 2, 1), (4, 5, 6, 7)]


def draw(axis, state, at):
    """The record nearest to the time: living elements in the plane, mass points as dots."""
    records = [key for key in state if key.startswith("record")]
    key = min(records, key=lambda k: abs(float(state[k].attrs["time"]) - at))
    start, corners, record = state["mesh/coordinates"][:], state["mesh/connectivity"][:], state[key]
    moved = 1e3 * (start + record["node/displacement"][:])
    damage, alive = record["element/damage"][:].ravel(), record["element/alive"][:].ravel() > 0
    polygons, values = [], []
    for element in numpy.flatnonzero(alive):
        for face in FACES:
            nodes = list(dict.fromkeys(corners[element][list(face)]))
            if len(nodes) > 2 and abs(start[nodes][:, 1]).max() < 1e-9:
                polygons.append(moved[nodes][:, [0, 2]])
                values.append(damage[element])
    drawn = PolyCollection(polygons, array=numpy.array(values), cmap="viridis", edgecolors="white", linewidths=0.15)
    drawn.set_clim(0, 0.3)
    axis.add_collection(drawn)
    free = abs(start[:, 1]) < 1e-9
    free[corners[alive].ravel()] = False
    axis.plot(moved[free, 0], moved[free, 2], "r.", markersize=2)
    axis.set(xlim=(0, 22), ylim=(-24, 20), aspect="equal", title=f"{1e6 * float(state[key].attrs['time']):.0f} us", xlabel="radius [mm]")
    return drawn


wanted = [float(t) for t in given.times.split(",")]
count = len(wanted) * len(given.results)
figure, axes = plot.subplots(1, count, figsize=(2.6 * count, 4.8), sharey=True)
for k, result in enumerate(given.results):
    with h5py.File(os.path.join(result, "state.h5"), "r") as state:
        for axis, at in zip(axes[k * len(wanted):], wanted):
            drawn = draw(axis, state, at)
figure.colorbar(drawn, ax=list(axes), label="damage")
figure.savefig(given.output, dpi=110, bbox_inches="tight")
