#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the figures of the theory pages from data/*.csv, which record.py has stored.

usage: tests/pictures/plots.py all|NAME...       (writes NAME.png into this folder)
"""
import argparse
import csv
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))


def table(name):
    """Columns by name; of the stored numbers as floats, of texts as they are."""
    with open(os.path.join(HERE, "data", name + ".csv"), encoding="utf-8") as stream:
        lines = [line for line in stream if not line.startswith("#")]
    columns = {}
    for row in csv.DictReader(lines):
        for key, value in row.items():
            columns.setdefault(key, []).append(value)

    def numbers(values):
        try:
            return np.array([float(value) for value in values])
        except ValueError:
            return np.array(values)

    return {key: numbers(values) for key, values in columns.items()}


def where(columns, **wanted):
    chosen = np.all([columns[key] == value for key, value in wanted.items()], axis=0)
    return {key: values[chosen] for key, values in columns.items()}


def panels(count, width=5.6, height=4.0):
    figure, axes = plt.subplots(1, count, figsize=(width * count, height), squeeze=False)
    for one in axes[0]:
        one.grid(color="0.9")
    return figure, axes[0]


def label(axes, x, y, title=""):
    axes.set(xlabel=x, ylabel=y)
    axes.set_title(title, fontsize=10)
    axes.legend(fontsize=8, frameon=False)


# --- one function a figure --------------------------------------------------------------------------------------------

def stable_step():
    t = table("stable_step")
    figure, (axes,) = panels(1)
    axes.plot(t["n"], t["element"], "s-", label="run.step_bound: element")
    axes.plot(t["n"], t["assembled"], "o-", label="run.step_bound: assembled")
    axes.axhline(1, color="0.5", linestyle=":", label="plane waves in an infinite mesh of cubes, h/c")
    axes.set(xscale="log", ylim=(0.65, 1.05))
    axes.set_xticks(t["n"], [f"{n:.0f}" for n in t["n"]])
    label(axes, "elements along an edge of the cube", r"stable step $\Delta t\, c/h$")
    return figure


def enforcement():
    t = table("enforcement")
    figure, axes = panels(2)
    kinds = [("rate", 0.0, "rate", "tab:blue"), ("rate", 0.3, "rate, friction 0.3", "tab:orange"), ("row_sum", 0.0, "row_sum", "tab:green")]
    for one, passes, title in zip(axes, ("one", "two"), ("one pass", "two passes, rigid rows")):
        for method, friction, text, colour in kinds:
            c = where(t, passes=passes, method=method, friction=friction)
            if len(c["iterations"]):
                one.loglog(c["iterations"], c["residual"], "o-", markersize=4, color=colour, label=text)
        one.axhline(1e-3, color="0.5", linestyle=":", label="default tolerance")
        one.set(ylim=(1e-11, 2), xlim=(0.9, 3000))
        label(one, "iterations", "residual / largest violation", title)
    return figure


def friction_cone():
    t, lagged = table("friction"), table("friction_lag")
    figure, axes = panels(3, width=4.8)
    weight, mu = 0.2 * 9.81, 0.2
    for name, text, colour in (("coulomb", "friction: 0.2", "tab:blue"), ("decay", "static 0.3, kinetic 0.2", "tab:orange")):
        c = where(t, law=name)
        axes[0].plot(4 * c["time"], -c["tangential"] / weight, color=colour, label=text)
        axes[1].plot(c["normal"] / weight, np.abs(c["tangential"]) / weight, ".", color=colour, markersize=4, label=text)
    axes[0].plot([0, 0.4], [0, 0.4], color="0.5", linestyle=":", label="equal to the pull")
    label(axes[0], "pull / weight", "friction force / weight", "a block that is pulled along a wall")
    edge = np.array([0, 1.6])
    for limit in (mu, 0.3):
        axes[1].plot(edge, limit * edge, color="0.5", linestyle="-" if limit == mu else ":", label=rf"$\mu$ = {limit}")
    axes[1].set(xlim=edge, ylim=(0, 0.45))
    label(axes[1], "normal force / weight", "friction force / weight", "all rows of the history: inside the cone")
    for name, text in (("without", "friction: 0.5"), ("with", "the same with a lag of 2.6 ms")):
        c = where(lagged, lag=name)
        axes[2].plot(c["time"], c["normal"] / (weight * np.sqrt(0.75)), linewidth=0.9, label=text)
    axes[2].set(xlim=(0.05, 0.3), ylim=(0, 2))
    label(axes[2], "time [s]", "normal force / its static value", "an elastic block slides down 30 degrees")
    return figure


def ties():
    t = table("ties")
    figure, (axes,) = panels(1, width=8)
    transit = 0.1 / 5000
    axes.plot(t["time"] / transit, t["blow"] / 20e3, color="0.7", label="between striker and bar (contact)")
    axes.plot(t["time"] / transit, t["tie"] / 20e3, color="tab:blue", label="between the tied halves")
    exact = [(0, 0), (1, 0), (1, 1), (3, 1), (3, -1), (5, -1), (5, 1), (7, 1)]
    axes.plot(*zip(*exact), color="k", linestyle=":", label="d'Alembert, at the tie")
    label(axes, "time / transit of a half", "force / 20 kN; pressure > 0")
    return figure


def element_bending():
    t = table("bending")
    figure, axes = panels(2)
    length, height, width, young, shear = 0.2, 0.02, 0.005, 2e11, 1e11
    exact = length**3 / (3 * young * width * height**3 / 12) + length / (5 / 6 * shear * width * height)
    for one, along in zip(axes, (10, 40)):
        for name in ("hex8", "hex8 without control", "hex8_full", "hex8_bbar"):
            c = where(t, element=name, along=float(along))
            one.plot(c["layers"], c["deflection"] / exact, "o-" if name != "hex8_bbar" else "x--", label=name)
        layers = np.array([2, 4, 8])
        one.plot(layers, 1 / (1 - 1 / layers**2), color="k", linestyle=":", label=r"$1/(1 - 1/n^2)$")
        aspect = length / along / height
        one.axhline(1 / (1 + shear / young * aspect**2), color="0.5", linestyle=":", label=r"$1/(1 + (G/E)(a/H)^2)$")
        one.set(ylim=(0.4, 1.8), xscale="log")
        one.set_xticks([1, 2, 4, 8], ["1", "2", "4", "8"])
        one.minorticks_off()
        label(one, "layers of elements", "deflection / Timoshenko's beam",
              f"elements as long as {'the' if along == 10 else 'a quarter of the'} height")
    return figure


def material_paths():
    t = table("material")
    figure, axes = panels(3, width=4.8)
    for kind, text in ((0.0, "isotropic"), (1.0, "kinematic")):
        c = where(t, path="cyclic", kind=f"{kind:g}")
        axes[0].plot(100 * c["strain"], c["stress"], ".", markersize=4, label=text + " hardening")
        axes[0].plot(*cyclic_exact(kinematic=kind > 0), color="k", linewidth=0.6)
    label(axes[0], "strain [%]", "stress / yield stress", "J2, uniaxial stress, cyclic strain")
    shear = np.linspace(0, 4, 200)
    for kind in ("jaumann", "logarithmic"):
        c = where(t, path="shear", kind=kind)
        axes[1].plot(c["strain"], c["stress"], ".", markersize=4, label=kind)
    axes[1].plot(shear, np.sin(shear), color="k", linewidth=0.6)
    axes[1].plot(shear, 2 * np.arcsinh(shear / 2) / np.sqrt(1 + shear**2 / 4), color="k", linewidth=0.6)
    label(axes[1], r"shear $\gamma$", r"$\sigma_{12}/\mu$", "elastic, simple shear")
    c = where(t, path="foam")
    axes[2].plot(-c["strain"], c["stress"], ".", markersize=4, label="run")
    axes[2].plot(*foam_exact(), color="k", linewidth=0.6, label="table, locking, unloading")
    label(axes[2], r"volume lost $1 - J$", "pressure along the axis", "foam, crushed without lateral motion")
    return figure


def cyclic_exact(kinematic, young=1000.0, hardening=100.0):
    """Uniaxial stress by small increments of strain (true area left aside: strains are below 1 %)."""
    strain = np.concatenate([np.linspace(a, b, 400) for a, b in ((0, 6e-3), (6e-3, -6e-3), (-6e-3, 6e-3))])
    stress, centre, radius, path = 0.0, 0.0, 1.0, []
    for step in np.diff(strain, prepend=0):
        trial = stress + young * step
        excess = abs(trial - centre) - radius
        if excess > 0:
            plastic = excess / (young + hardening)
            sign = np.sign(trial - centre)
            trial -= young * plastic * sign
            centre, radius = (centre + hardening * plastic * sign, radius) if kinematic else (centre, radius + hardening * plastic)
        stress = trial
        path.append(stress)
    return 100 * strain, path


def foam_exact(young=10.0):
    """Elastic to the table 0.5 + 0.5 v, along it to 0.6, locked to 0.75, and back: E J d(strain) is E dJ."""
    start = 0.5 / (young - 0.5)
    lost = [0, start, 0.6, 0.75, 0.6]
    locked = 0.8 + young * 0.15
    return lost, [0, young * start, 0.8, locked, locked - young * 0.15]


def rigid_top():
    motion, order = table("rigid_motion"), table("rigid_order")
    figure, axes = panels(3, width=4.8)
    for axis in "xyz":
        axes[0].plot(motion["time"], motion["spin_" + axis], label=f"axis {axis}")
    label(axes[0], "time [s]", "spin in the axes of the body [rad/s]", "a free block tumbles")
    for name in ("energy", "momentum"):
        axes[1].plot(motion["time"], np.abs(motion[name]), ".", label={"energy": "energy", "momentum": "angular momentum"}[name])
    axes[1].set(ylim=(0, 1e-14))
    label(axes[1], "time [s]", "relative change", "conservation")
    for name, unit in (("spin", "spin [rad/s]"), ("orientation", "orientation [rad]")):
        axes[2].loglog(1e3 * order["step"], order[name], "o-", label=unit)
    axes[2].loglog(1e3 * order["step"], order["spin"][0] * (order["step"] / order["step"][0])**2 / 4, color="0.5",
                   linestyle=":", label="second order")
    axes[2].set_xticks([0.5, 1, 2, 4], ["0.5", "1", "2", "4"])
    axes[2].minorticks_off()
    label(axes[2], "step [ms]", "largest error over 4 s", "against Jacobi's elliptic functions")
    return figure


def search():
    t = table("search")
    figure, axes = panels(2)
    for one, (scene, title) in zip(axes, (("plates", "two facing plates"), ("rod", "a slender rod in its sleeve, and 24 far outliers"))):
        for method, text in (("blocks", "blocks along a curve (in use)"), ("bucket", "bucket sort"), ("binary", "binary sort")):
            c = where(t, scene=scene, method=method)
            one.loglog(c["nodes"], 1e6 * (c["build_ms"] + c["query_ms"]) / c["nodes"], "o-", label=text)
        one.set(ylim=(80, 2e5))
        label(one, "nodes (about as many boxes)", "time of one search / node [ns]", title)
    return figure


def depth_samples():
    t = table("depth_samples")
    pairs = list(dict.fromkeys(t["pair"]))
    figure, axes = panels(len(pairs), width=4.4)
    methods = (("marches", "marches (in use)", "k", "o-"), ("samples 100", "nearest of 100 samples", "tab:green", "s--"),
               ("samples 1000", "nearest of 1,000", "tab:blue", "s-"), ("samples 10000", "nearest of 10,000", "tab:orange", "s-"),
               ("both", "marches and 10,000 samples", "tab:red", "^-"))
    for one, pair in zip(axes, pairs):
        for method, text, colour, line in methods:
            c = where(t, pair=pair, metric="DISP", starts=method)
            one.plot(c["ms"], 100 * np.maximum(c["excess"], 1e-3), line, color=colour, markersize=4, label=text)
            if method == "marches":
                for k, x, y in zip(c["k"], c["ms"], c["excess"]):
                    one.annotate(f"{k:.0f}", (x, 100 * max(y, 1e-3)), xytext=(3, 3), textcoords="offset points", fontsize=7)
        one.set(xscale="log", yscale="log")
        label(one, "CPU time of a query [ms]", "mean excess above the best known depth [%]", f"{pair}, DISP; K = 1, 2, 5, 10, 20")
    return figure


ALL = {f.__name__: f for f in (stable_step, enforcement, friction_cone, ties, element_bending, material_paths, rigid_top, search, depth_samples)}

if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="+", choices=["all", *ALL], metavar="NAME", help=f"all or {', '.join(ALL)}")
    names = parser.parse_args().names
    for chosen in ALL if "all" in names else names:
        drawn = ALL[chosen]()
        drawn.tight_layout()
        drawn.savefig(os.path.join(HERE, chosen + ".png"), dpi=80)
