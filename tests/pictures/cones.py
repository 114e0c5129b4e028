#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the features of a surface with their normal cones, and what a node may meet there.

usage: tests/pictures/cones.py -o PNG

The cones and the admissible normals are computed here from the corners of the bodies shown, by the definition: a
normal n of the master is admissible where n lies in the cone of the master's feature and -n in the cone of the slave's.
"""
import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

MASTER, SLAVE, CONE, MET = "#d9d9d9", "#c6dbef", "#fd8d3c", "#a50f15"


def unit(v):
    return np.asarray(v, float) / np.linalg.norm(v)


def arc(one, other, steps=24):
    """Unit vectors from one to the other."""
    angle = np.arccos(np.clip(one @ other, -1, 1))
    if angle < 1e-9:
        return np.array([one])
    t = np.linspace(0, 1, steps)
    return (np.sin((1 - t) * angle)[:, None] * one + np.sin(t * angle)[:, None] * other) / np.sin(angle)


# --- in space: a vertex, an edge, a face ------------------------------------------------------------------------------

def draw_cube(axes):
    low, high = -1.0, 0.0
    corners = np.array([[x, y, z] for x in (low, high) for y in (low, high) for z in (low, high)])
    faces = [(4, 6, 7, 5), (2, 3, 7, 6), (1, 5, 7, 3)]  # x, y and z = 0
    axes.add_collection3d(Poly3DCollection([corners[list(f)] for f in faces], facecolor=MASTER, edgecolor="k", alpha=0.9))
    axes.set(xlim=(-1, 0.6), ylim=(-1, 0.6), zlim=(-1, 0.6))
    axes.set_box_aspect((1, 1, 1))
    axes.view_init(24, 35)
    axes.set_axis_off()


def draw_cone(axes, foot, rim, size=0.5):
    tips = foot + size * rim
    axes.add_collection3d(Poly3DCollection([np.vstack([foot, tips])] if len(rim) > 1 else [], facecolor=CONE, alpha=0.6))
    for tip in tips[:: max(1, len(tips) // 8)]:
        axes.plot(*zip(foot, tip), color=CONE, linewidth=1.2)


def draw_features(figure):
    x, y, z = np.eye(3)
    for place, (title, feet) in enumerate([
            ("face: one direction", [((-0.5, -0.5, 0), np.array([z]))]),
            ("edge: an arc", [((-0.5, 0, 0), arc(y, z))]),
            ("vertex: a triangle of the sphere", [((0, 0, 0), np.vstack([arc(x, y), arc(y, z), arc(z, x)]))])]):
        axes = figure.add_subplot(2, 3, place + 1, projection="3d")
        draw_cube(axes)
        for foot, rim in feet:
            draw_cone(axes, np.array(foot, float), rim)
        axes.set_title("normal cone, " + title, fontsize=10)


# --- in the plane: what may meet --------------------------------------------------------------------------------------

def cone_in_plane(normals):
    """Angles [degrees] of the first and the last normal of a convex corner."""
    middle = np.sum(normals, axis=0)
    middle = np.degrees(np.arctan2(middle[1], middle[0]))
    off = [(np.degrees(np.arctan2(n[1], n[0])) - middle + 180) % 360 - 180 for n in normals]
    return middle + min(off), middle + max(off)


def admissible(master, slave):
    """Angles of normals out of the master that both admit: cone of the master, and the reversed one of the slave."""
    low, high = cone_in_plane(master)
    other_low, other_high = cone_in_plane([-np.asarray(n) for n in slave])
    low, high = max(low, other_low), min(high, other_high)
    return (low, high) if low <= high + 1e-9 else None


def wedge(axes, foot, angles, radius, colour, alpha):
    t = np.radians(np.linspace(*angles, 30))
    rim = np.column_stack([np.cos(t), np.sin(t)])
    axes.fill(*np.vstack([foot, foot + radius * rim]).T, color=colour, alpha=alpha, linewidth=0)
    for end in (rim[0], rim[-1]):
        axes.plot(*zip(foot, foot + radius * end), color=colour, linewidth=1.5)


def draw_meeting(axes, title, master, slave, foot, node, master_normals, slave_normals):
    axes.fill(*np.array(master).T, color=MASTER, ec="k")
    axes.fill(*np.array(slave).T, color=SLAVE, ec="k")
    foot, node = np.array(foot, float), np.array(node, float)
    wedge(axes, foot, cone_in_plane(master_normals), 0.42, CONE, 0.45)
    wedge(axes, node, cone_in_plane(slave_normals), 0.3, "tab:blue", 0.35)
    met = admissible(master_normals, slave_normals)
    if met is None:
        axes.text(*(foot + [0.06, -0.3]), "nothing in common:\nno contact here", fontsize=8, color=MET)
    else:
        for angle in sorted(set(np.round(met, 6))):
            way = 0.55 * np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
            axes.annotate("", foot + way, foot, arrowprops={"arrowstyle": "-|>", "color": MET, "lw": 2})
    axes.plot(*node, "ko", markersize=5)
    axes.set(xlim=(-1, 1), ylim=(-0.8, 0.9), aspect="equal", title=title)
    axes.title.set_fontsize(10)
    axes.set_axis_off()


def draw_meetings(figure):
    x, y = np.array([1.0, 0]), np.array([0, 1.0])
    tilted = unit([-0.45, -0.9])
    along = np.array([-tilted[1], tilted[0]])
    block = [(-1, -0.8), (0, -0.8), (0, 0), (-1, 0)]
    plate_at = np.array([0.02, 0.02])
    plate = [plate_at - 0.7 * along, plate_at + 0.7 * along, plate_at + 0.7 * along - 0.3 * tilted, plate_at - 0.7 * along - 0.3 * tilted]
    draw_meeting(figure.add_subplot(2, 3, 4), "an edge meets a smooth surface along its normal", block, plate, (0, 0), plate_at, [x, y], [tilted])
    over = [(-0.8, 0.03), (0.04, 0.03), (0.04, 0.6), (-0.8, 0.6)]
    draw_meeting(figure.add_subplot(2, 3, 5), "flush rims: one normal lies in both cones", block, over, (0, 0), (0.04, 0.03), [x, y], [x, -y])
    beside = [(0.03, -0.25), (0.8, -0.25), (0.8, 0.5), (0.03, 0.5)]
    draw_meeting(figure.add_subplot(2, 3, 6), "the foot of a post beside a block: its top is not met", block, beside, (0, 0), (0.03, 0.1), [y], [-x])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", default="cones.png", metavar="PNG")
    arguments = parser.parse_args()
    figure = plt.figure(figsize=(13, 8.2))
    draw_features(figure)
    draw_meetings(figure)
    figure.tight_layout()
    figure.savefig(arguments.o, dpi=90)


if __name__ == "__main__":
    main()
