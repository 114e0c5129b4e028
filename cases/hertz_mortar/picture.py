#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""picture.png from the results of check.py --long: cases/hertz_mortar/picture.py build/cases/hertz_mortar_long"""
import math
import os
import sys

import matplotlib

matplotlib.use("Agg")
import h5py  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
import numpy  # noqa: E402
import yaml  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../support"), HERE]
from case_check import Result, SceneLoader  # noqa: E402
from check import Profile, Sheared, cattaneo, hertz  # noqa: E402


def scene(name):
    with open(os.path.join(HERE, name), encoding="utf-8") as stream:
        return yaml.load(stream, SceneLoader)


def body(axes, result):
    """The front of the slab in the deformed state, coloured by the stress zz, mirrored."""
    with h5py.File(os.path.join(result.folder, "state.h5"), "r") as file:
        record = file[max(name for name in file if name.startswith("record_"))]
        start = file["mesh/coordinates"][...]
        place, corners = start + record["node/displacement"][...].reshape(-1, 3), file["mesh/connectivity"][...]
        stress = record["element/stress"][...].reshape(-1, 6)[:, 2]
    front = numpy.array([element[start[element, 1] < 1e-9] for element in corners])
    quads = place[front][:, :, [0, 2]]
    for side in (1, -1):
        drawn = PolyCollection(quads * [side, 1], array=stress, cmap="viridis", edgecolors="white", linewidths=0.15)
        drawn.set_clim(-10, 0)
        axes.add_collection(drawn)
    axes.set(xlim=(-1.6, 1.6), ylim=(-1.7, 1.5), aspect="equal", title="stress zz, P = 10, a/11", xlabel="x", ylabel="z")
    return drawn


def main():
    folder = sys.argv[1]
    results = {name: Result(os.path.join(folder, name)) for name in ("load_10_11_dual", "load_10_11_standard", "friction_11")}
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(14, 4.6), layout="constrained")
    figure.colorbar(body(left, results["load_10_11_dual"]), ax=left, shrink=0.8)
    a, p0 = hertz(scene("scene.yaml"), 10)
    x = numpy.linspace(0, a, 400)
    middle.plot(x, p0 * numpy.sqrt(1 - (x / a) ** 2), "k--", linewidth=1, label="Hertz, half planes")
    for multiplier, mark in (("dual", "o-"), ("standard", "s:")):
        profile = Profile(results[f"load_10_11_{multiplier}"])
        near = profile.x < 1.15 * a
        middle.plot(profile.x[near], profile.pressure[near], mark, markersize=4, linewidth=1, label=multiplier)
    middle.set(xlabel="x", ylabel="pressure", title="pressure of the nodes, P = 10, a/11")
    middle.legend()
    sheared = Sheared(results["friction_11"], scene("friction.yaml"))
    width = hertz(scene("scene.yaml"), sheared.normal)[0]
    x = numpy.linspace(-width, width, 801)
    exact = cattaneo(sheared.friction, sheared.normal, sheared.tangential, width, x)[1]
    near = abs(sheared.x) < 1.15 * width
    right.plot(x, exact, "k--", linewidth=1, label="Cattaneo, Mindlin")
    right.plot(x, sheared.friction * 2 * sheared.normal / (math.pi * width) * numpy.sqrt(1 - (x / width) ** 2), "k:", linewidth=0.8,
               label="friction times pressure")
    right.plot(sheared.x[near], sheared.traction[near], "o-", markersize=4, linewidth=1, label="dual")
    right.set(xlabel="x from the middle", title="shear traction of the nodes, a/11")
    right.legend(loc="lower center")
    figure.savefig(os.path.join(HERE, "picture.png"), dpi=80)


if __name__ == "__main__":
    main()
