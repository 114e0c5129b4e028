#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""picture.png from the results of check.py --long: cases/impact_limiter/picture.py build/cases/impact_limiter"""
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
import yaml  # noqa: E402
from case_check import Result, SceneLoader  # noqa: E402
from foam import Foam  # noqa: E402

FACES = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (0, 3, 2, 1), (4, 5, 6, 7)]
EXACT = {"color": "black", "linewidth": 1, "linestyle": "--"}
MOST_STRAIN = 0.8


class States:
    def __init__(self, result):
        self.file = h5py.File(os.path.join(result.folder, "state.h5"), "r")
        self.records = sorted(key for key in self.file if key.startswith("record"))
        self.start, self.corners = self.file["mesh/coordinates"][:], self.file["mesh/connectivity"][:]

    def time(self, key):
        return float(self.file[key].attrs["time"])

    def near(self, time):
        return min(self.records, key=lambda key: abs(self.time(key) - time))

    def cut(self, key, across, along):
        """Faces in the symmetry plane across = 0: their corners (along, z) and their elements."""
        place = self.start + self.file[key]["node/displacement"][:]
        polygons, elements = [], []
        for face in FACES:
            nodes = self.corners[:, face]
            here = numpy.flatnonzero((abs(self.start[nodes][:, :, across]) < 1e-9).all(axis=1))
            polygons += list(place[nodes[here]][:, :, [along, 2]])
            elements += list(here)
        return numpy.array(polygons), numpy.array(elements)


def crushed(axes, states, time, speed):
    """Right: the symmetry plane y = 0; left: the plane x = 0, mirrored."""
    key = states.near(time)
    strain = states.file[key]["element/plastic_strain"][:].ravel()
    for across, along, side in ((1, 0, 1), (0, 1, -1)):
        polygons, elements = states.cut(key, across, along)
        polygons[:, :, 0] *= side
        drawn = PolyCollection(polygons, array=strain[elements], cmap="viridis", edgecolors="white", linewidths=0.2)
        drawn.set_clim(0, MOST_STRAIN)
        axes.add_collection(drawn)
    axes.axhline(0, color="black", linewidth=1)
    axes.set(title=f"{speed} m/s, {states.time(key):.1f} ms", xlim=(-64, 64), ylim=(-4, 116), aspect="equal", xlabel="radius [mm]")
    return drawn


def forces(axes, result):
    history = result.history
    force = numpy.diff(history["impulse_wall.z"]) / numpy.diff(history["time"]) / 1e3
    axes.plot(history["time"][1:], 4 * force, color="tab:blue")
    axes.set(title="force of the wall (all four quarters)", xlabel="time [ms]", ylabel="force [kN]")
    twin = axes.twinx()
    twin.plot(history["time"], -history["payload.z"], color="tab:orange")
    twin.set_ylabel("speed of the payload [m/s]", color="tab:orange")
    twin.axhline(0, color="grey", linewidth=0.5)


def energies(axes, result):
    history = result.history
    start = history["kinetic"][0]
    for shell in ("nose", "core", "flare"):
        axes.plot(history["time"], 100 * history[f"{shell}.internal"] / start, label=f"{shell}, internal")
    for key, label in (("friction", "friction"), ("contact", "contact"), ("kinetic", "kinetic")):
        axes.plot(history["time"], 100 * history[key] / start, ":", label=label)
    axes.set(title=f"energies ({4 * start / 1e3:.0f} J in all)", xlabel="time [ms]", ylabel="share of the kinetic energy [%]")
    axes.legend(loc="center right")


def foam(axes, folder, theory):
    history = Result(os.path.join(folder, "foam_200")).history
    time, impulse = history["time"], history["impulse_wall.z"] / theory.area
    step = max(1, len(time) // 36)  # of some elements crushed, else it is a staircase
    axes.plot(1e3 * (time[step::step] + time[:-step:step]) / 2, numpy.diff(impulse[::step]) / numpy.diff(time[::step]) / 1e6, color="tab:blue",
              label="200 elements, means of 25 us")
    time, stress = theory.curve()
    axes.plot(1e3 * time, stress / 1e6, **EXACT, label="shock theory")
    axes.set(title="foam bar: stress at the wall", xlabel="time [ms]", ylabel="stress [MPa]", ylim=(0, 2.5))
    axes.legend()


def main():
    folder = sys.argv[1]
    result = Result(os.path.join(folder, "limiter_1_40"))
    states = States(result)
    with open(os.path.join(HERE, "foam.yaml"), encoding="utf-8") as stream:
        theory = Foam(yaml.load(stream, SceneLoader))
    fast = States(Result(os.path.join(folder, "limiter_1_80")))
    figure = plt.figure(figsize=(20, 8), layout="constrained")
    above, below = figure.subfigures(2, 1)
    axes = above.subplots(1, 5)
    for place, of, time, speed in zip(axes, (states, states, states, fast, fast), (0, 0.6, 2.6, 0.8, 2.6), (40, 40, 40, 80, 80)):
        drawn = crushed(place, of, time, speed)
    above.colorbar(drawn, ax=list(axes), label="plastic strain")
    axes = below.subplots(1, 3)
    forces(axes[0], result)
    energies(axes[1], result)
    foam(axes[2], folder, theory)
    figure.savefig(os.path.join(HERE, "picture.png"), dpi=70)


if __name__ == "__main__":
    main()
