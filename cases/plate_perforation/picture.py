#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The symmetry plane of a result at some times, with damage: picture.py RESULT [-o picture.png]."""
import argparse
import os

import h5py
import matplotlib
import numpy

matplotlib.use("Agg")
import matplotlib.pyplot as plot  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("result")
parser.add_argument("-o", "--output", default=os.path.join(os.path.dirname(os.path.abspath(__file__)), "picture.png"))
parser.add_argument("--times", default="10e-6,20e-6,60e-6")
given = parser.parse_args()

FACES = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (0, 3, 2, 1), (4, 5, 6, 7)]
with h5py.File(os.path.join(given.result, "state.h5"), "r") as state:
    records = sorted((key for key in state if key.startswith("record")))
    time = {key: float(numpy.ravel(state[key].attrs.get("time", state[key]["time"] if "time" in state[key] else 0))[0])
            for key in records}
    start, corners = state["mesh/coordinates"][:], state["mesh/connectivity"][:]
    wanted = [float(t) for t in given.times.split(",")]
    figure, axes = plot.subplots(1, len(wanted), figsize=(4.2 * len(wanted), 5), sharey=True)
    for axis, at in zip(axes, wanted):
        key = min(records, key=lambda k: abs(time[k] - at))
        record = state[key]
        moved = start + record["node/displacement"][:]
        damage = record["element/damage"][:].ravel()
        alive = record["element/alive"][:].ravel() > 0
        polygons, values = [], []
        for element in numpy.flatnonzero(alive):
            for face in FACES:
                nodes = corners[element][list(face)]
                if abs(start[nodes][:, 1]).max() < 1e-9:
                    polygons.append(1e3 * moved[nodes][:, [0, 2]])
                    values.append(damage[element])
        drawn = PolyCollection(polygons, array=numpy.array(values), cmap="viridis", edgecolors="white", linewidths=0.15)
        drawn.set_clim(0, 0.3)
        axis.add_collection(drawn)
        axis.set_xlim(0, 22)
        axis.set_ylim(-30, 22)
        axis.set_aspect("equal")
        axis.set_title(f"{1e6 * time[key]:.0f} us")
        axis.set_xlabel("radius [mm]")
    figure.colorbar(drawn, ax=list(axes), label="damage")
    figure.savefig(given.output, dpi=110, bbox_inches="tight")
