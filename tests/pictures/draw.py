#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Draws what chosen_faces and ghosted_faces write.

usage: chosen_faces | tests/pictures/draw.py rows -o PNG
       tests/pictures/draw.py ghosts FOLDER -o PNG
"""
import argparse
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

COLOURS = ["tab:blue", "tab:orange", "tab:green", "tab:red"]


def numbers(words):
    return np.array([float(w) for w in words])


def frame(axes, points, margin=0.05):
    low, high = points.min(axis=0), points.max(axis=0)
    middle, half = (low + high) / 2, (0.5 + margin) * (high - low).max()
    axes.set(xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] - half, middle[1] + half),
             zlim=(middle[2] - half, middle[2] + half))
    axes.set_box_aspect((1, 1, 1))
    axes.set_axis_off()


# --- rows of a node ---------------------------------------------------------------------------------------------------

def read_places(stream):
    places = []
    for line in stream:
        kind, *words = line.split()
        if kind == "place":
            places.append({"title": line.split(maxsplit=1)[1].strip(), "face": [], "row": []})
        elif kind == "node":
            places[-1]["node"] = numbers(words)
        elif kind == "face":
            places[-1]["face"].append(numbers(words).reshape(4, 3))
        else:
            places[-1]["row"].append((int(words[0]), numbers(words[1:4]), numbers(words[4:7])))
    return places


def draw_rows(output):
    places = read_places(sys.stdin)
    figure = plt.figure(figsize=(12, 8))
    for k, place in enumerate(places):
        axes = figure.add_subplot(2, 3, k + 1, projection="3d", computed_zorder=False)
        axes.view_init(elev=22, azim=32 if "box" in place["title"] else -68)
        chosen = {face for face, _, _ in place["row"]}
        for f, corners in enumerate(place["face"]):
            colour = COLOURS[sorted(chosen).index(f)] if f in chosen else "0.8"
            axes.add_collection3d(Poly3DCollection([corners], facecolor=colour, edgecolor="0.2", alpha=0.35, zorder=1))
        for face, point, normal in place["row"]:
            colour = COLOURS[sorted(chosen).index(face)]
            axes.quiver(*point, *(0.45 * normal), color=colour, linewidth=2.5, arrow_length_ratio=0.25, zorder=3)
        axes.scatter(*place["node"], color="black", s=35, depthshade=False, zorder=4)
        frame(axes, np.concatenate(place["face"] + [[p + 0.45 * n] for _, p, n in place["row"]]), margin=-0.04)
        axes.set_title(f"{place['title']} ({len(place['row'])})", fontsize=11)
    figure.subplots_adjust(left=0.01, right=0.99, bottom=0.01, top=0.95, wspace=0.02, hspace=0.06)
    figure.savefig(output, dpi=90)


# --- faces by rank ----------------------------------------------------------------------------------------------------

def read_ranks(folder):
    """Corners of each face by key, its rank, and the keys of the ghosts of each rank."""
    corners, rank_of, ghosts = {}, {}, []
    while os.path.exists(name := os.path.join(folder, f"faces_{len(ghosts)}.txt")):
        ghosts.append([])
        with open(name, encoding="utf-8") as stream:
            for line in stream:
                kind, key, *words = line.split()
                if kind == "own":
                    corners[key], rank_of[key] = numbers(words).reshape(4, 3), len(ghosts) - 1
                else:
                    ghosts[-1].append(key)
    return corners, rank_of, ghosts


def draw_ghosts(folder, output):
    corners, rank_of, ghosts = read_ranks(folder)
    everything = np.concatenate(list(corners.values()))
    figure = plt.figure(figsize=(10, 10))
    for rank, received in enumerate(ghosts):
        axes = figure.add_subplot(2, (len(ghosts) + 1) // 2, rank + 1, projection="3d")
        axes.view_init(elev=22, azim=-40)
        own = [corners[key] for key, owner in rank_of.items() if owner == rank]
        axes.add_collection3d(Poly3DCollection(own, facecolor="0.85", edgecolor="0.6", linewidth=0.3, alpha=0.35))
        axes.add_collection3d(Poly3DCollection([corners[key] for key in received], linewidth=0.3, edgecolor="0.2",
                                               facecolor=[COLOURS[rank_of[key] % 4] for key in received], alpha=0.9))
        frame(axes, everything, margin=-0.15)
        axes.set_title(f"rank {rank}: {len(own)} faces of its own, {len(received)} of others", fontsize=11)
    handles = [plt.Rectangle((0, 0), 1, 1, color=c) for c in COLOURS[:len(ghosts)]] + [plt.Rectangle((0, 0), 1, 1, color="0.85")]
    figure.legend(handles, [f"from rank {r}" for r in range(len(ghosts))] + ["its own"], loc="lower center", ncol=5)
    figure.subplots_adjust(left=0.0, right=1, bottom=0.03, top=0.96, wspace=0, hspace=0.04)
    figure.savefig(output, dpi=80)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["rows", "ghosts"])
    parser.add_argument("folder", nargs="?", default=".", help="of ghosted_faces")
    parser.add_argument("-o", "--output", required=True)
    options = parser.parse_args()
    if options.what == "rows":
        draw_rows(options.output)
    else:
        draw_ghosts(options.folder, options.output)


if __name__ == "__main__":
    main()
