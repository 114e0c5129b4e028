#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""picture.png from a result of check.py: cases/patch_mortar/picture.py build/cases/patch_mortar/askew_3_4_dual

Left: the stress in both blocks (scripts/render). Right: the two faces on each other, at the slave's nodes the error of the pressure.
"""
import os
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import h5py  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
import numpy  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
from state import Last  # noqa: E402

PRESSURE = 0.22073420655712835
FACES = [(0, 1, 2, 3), (4, 5, 6, 7)]


class Folder:
    def __init__(self, folder):
        self.folder = folder


def faces(folder, last):
    """Quadrilaterals of both blocks in the contact face, at the start."""
    with h5py.File(os.path.join(folder, "state.h5"), "r") as file:
        corners = file["mesh/connectivity"][...]
    for block in (0, 1):
        quads = [element[list(face)] for element in corners[last.block == block] for face in FACES]
        yield [last.start[quad][:, :2] for quad in quads if (abs(last.start[quad][:, 2] - 0.5) < 1e-9).all()]


def main():
    folder = sys.argv[1]
    last = Last(Folder(folder))
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.6), gridspec_kw={"width_ratios": (1.25, 1)}, layout="constrained")
    with tempfile.TemporaryDirectory() as place:
        drawn = os.path.join(place, "stress.png")
        subprocess.run([os.path.join(HERE, "../../scripts/render"), folder, "--field", "stress.zz", "--range", "-0.25", "0", "-o", drawn],
                       check=True, stdout=subprocess.DEVNULL)
        left.imshow(plt.imread(drawn))
    left.axis("off")
    for quads, colour in zip(faces(folder, last), ("tab:blue", "tab:orange")):
        right.add_collection(PolyCollection(quads, facecolors="none", edgecolors=colour, linewidths=1.5))
    nodes = last.face(0, 0.5)
    shown = right.scatter(*last.start[nodes, :2].T, c=last.pressure[nodes] / PRESSURE - 1, cmap="coolwarm", s=60, zorder=3)
    figure.colorbar(shown, ax=right, label="pressure / exact - 1", shrink=0.85)
    right.set(aspect="equal", xlabel="x", ylabel="y", title="faces that cross, at the start: lower (blue, slave), upper (orange)")
    right.title.set_fontsize(9)
    figure.savefig(os.path.join(HERE, "picture.png"), dpi=90)


if __name__ == "__main__":
    main()
