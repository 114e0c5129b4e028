#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""picture.png from the results of check.py --long: cases/sphere_on_plate/picture.py build/cases/sphere_on_plate"""
import os
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../support"))
import numpy  # noqa: E402
from case_check import Result  # noqa: E402

RENDER = os.path.join(HERE, "../../scripts/render")


def draw(axes, title, result, *options):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "view.png")
        subprocess.run([RENDER, result.folder, "--field", "plastic_strain", "--range", "0", "0.8", "-o", path, *options],
                       check=True, stdout=subprocess.DEVNULL)
        axes.imshow(plt.imread(path))
    axes.set_title(title)
    axes.axis("off")


def speeds(axes, folder):
    for name, label, style in (("hex8_bbar_3", "3 elements through the plate", "-"), ("hex8_bbar_2", "2 elements", ":"),
                               ("hex8_bbar_4", "4 elements", "--")):
        if os.path.exists(os.path.join(folder, name, "summary.json")):
            history = Result(os.path.join(folder, name)).history
            axes.plot(1e6 * history["time"], numpy.hypot(history["ball.x"], history["ball.z"]), style, color="tab:blue", label=label)
    axes.set(title="speed of the ball", xlabel="time [us]", ylabel="speed [m/s]")
    axes.legend()


def energies(axes, result):
    history = result.history
    for key, label in (("eroded", "eroded with elements"), ("contact", "taken by contact"), ("internal", "internal"),
                       ("friction", "friction")):
        axes.plot(1e6 * history["time"], history[key], label=label)
    axes.plot(1e6 * history["time"], history["kinetic"][0] - history["kinetic"], color="black", linewidth=1, label="kinetic lost")
    axes.set(title=f"energies ({history['total'][0]:.0f} J in all)", xlabel="time [us]", ylabel="energy [J]")
    axes.legend()


def main():
    folder = sys.argv[1]
    result = Result(os.path.join(folder, "hex8_bbar_3"))
    figure, axes = plt.subplots(2, 2, figsize=(17, 11), gridspec_kw={"height_ratios": [1.2, 1]})
    draw(axes[0, 0], "plastic strain, cut in the plane of flight, 10 us", result, "--time", "10e-6", "--clip", "y=0", "--view", "front",
         "--zoom", "1.7", "--size", "1100", "700")
    draw(axes[0, 1], "40 us, from below", result, "--time", "40e-6", "--azimuth", "-60", "--elevation", "-35", "--size", "1100", "700")
    speeds(axes[1, 0], folder)
    energies(axes[1, 1], result)
    figure.tight_layout()
    figure.savefig(os.path.join(HERE, "picture.png"), dpi=70)


if __name__ == "__main__":
    main()
