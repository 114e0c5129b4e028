# SPDX-License-Identifier: Apache-2.0
"""history.csv: its columns, and panels that show them."""
import csv
import os
import re

import matplotlib

matplotlib.use("Agg")
import numpy as np

from arguments import Fault, shorter

ENERGIES = ["kinetic", "internal", "hourglass", "bulk", "damping", "contact", "friction", "walls", "external",
            "eroded", "driven", "total"]
MOMENTA = ["momentum_x", "momentum_y", "momentum_z"]
KNOWN = {"step", "time", "dt", "mass", *MOMENTA, "active_contacts", "max_penetration", *ENERGIES}
# Okabe and Ito's colours, which the colour-blind tell apart; lines beyond them are dashed
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7f7f7f", "#000000"]
PANELS_OF_PROBES = 9   # with more, components of many probes share a panel
LINES_OF_A_PANEL = 8   # as many as there are colours
LETTERS = 18           # of a name, at most
LINE = 76              # letters of a legend's line, with six for each name's sample and the space between
MOST_POINTS = 2000     # of a line: more than a picture has pixels


class History:
    """Columns by name, and their units."""

    def __init__(self, result):
        self.path = os.path.join(result, "history.csv") if os.path.isdir(result) else result
        rows = self.read()
        self.units = {}
        for cell in rows[0]:
            name, _, unit = cell.partition(" [")
            self.units[name] = unit.rstrip("]")
        whole = [row for row in rows[1:] if len(row) == len(rows[0])]  # a killed run may leave an unfinished row
        try:
            values = np.array(whole, dtype=float).reshape(len(whole), len(rows[0]))
        except ValueError as error:
            raise Fault(f"{self.path}: invalid row ({error}); expected numbers") from error
        self.columns = {name: values[:, i] for i, name in enumerate(self.units)}

    def read(self):
        if not os.path.isfile(self.path):
            raise Fault(f"{self.path}: cannot read the file: it does not exist; expected a result folder, or its history.csv")
        try:
            with open(self.path, newline="", encoding="utf-8") as file:
                rows = list(csv.reader(file))
        except (OSError, UnicodeDecodeError, csv.Error) as error:
            raise Fault(f"{self.path}: cannot read the file ({error}); expected a history.csv of brunt run") from error
        if len(rows) < 2 or not rows[0] or rows[0][0] != "step" or len(set(rows[0])) != len(rows[0]):
            raise Fault(f"{self.path}: missing history; expected a header that begins with step, and rows")
        return rows

    def __len__(self):
        return len(self.columns["step"])

    def moves(self, name):
        """Is there anything but zeros to see?"""
        values = self.columns.get(name, np.empty(0))
        return bool(np.any(np.isfinite(values) & (values != 0)))


def unit_text(unit):
    return f" [{unit}]" if unit not in ("", "1") else ""  # 1: units: none


def energy_error(history):
    """Change of the total since the first row, over the largest of kinetic + internal and external energy so far: error_ratio
    of summary.json as it grows."""
    c = history.columns
    if not all(name in c for name in ("kinetic", "internal", "external", "total")) or len(history) == 0:
        return None
    largest = np.maximum.accumulate(np.fmax(c["kinetic"] + c["internal"], np.abs(c["external"])))
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(largest > 0, (c["total"] - c["total"][0]) / largest, 0.0)


# --- panels: (title, unit, {label: values}) -------------------------------------------------------------------------

def energy_panels(history):
    present = [name for name in ENERGIES if name in history.columns]
    shown = [name for name in present if name in ("kinetic", "internal", "total") or history.moves(name)]
    panels = [panel(history, "energy", shown)] if shown else []
    error = energy_error(history)
    if error is not None and np.any(error != 0):
        panels.append(("change of the total over the largest energy", "", {"error": error}))
    return panels


def general_panels(history):
    """Momentum, contact, the step."""
    panels = []
    momenta = [name for name in MOMENTA if name in history.columns]
    if any(history.moves(name) for name in momenta):
        panels.append(("momentum", history.units[momenta[0]], {name[-1]: history.columns[name] for name in momenta}))
    for name, title in (("active_contacts", "active contact constraints"), ("max_penetration", "largest penetration"),
                        ("dt", "time step")):
        if history.moves(name):
            panels.append((title, history.units[name], {name: history.columns[name]}))
    return panels


def panel(history, title, names):
    return title, history.units.get(names[0], ""), {name: history.columns[name] for name in names}


def natural(text):
    """tip2 before tip10."""
    return [int(piece) if piece.isdigit() else piece for piece in re.split(r"(\d+)", text)]


def probe_columns(history):
    """{(probe, unit): columns}; impulses stay off where their forces are."""
    probes = {}
    for name in history.columns:
        forces = name.replace("impulse_", "", 1) in history.columns
        if name in KNOWN or (name.startswith("impulse_") and forces):
            continue
        probes.setdefault((name.rpartition(".")[0] or name, history.units[name]), []).append(name)
    return dict(sorted(probes.items(), key=lambda entry: natural(entry[0][0])))


def component(name):
    return name.rpartition(".")[2] if "." in name else name


def probe_panels(history):
    """One panel a probe; where these are many, one a unit and component with up to eight probes in it, and what is zero
    throughout is left off."""
    probes = probe_columns(history)
    if len(probes) <= PANELS_OF_PROBES:
        return [(probe, unit, {component(name): history.columns[name] for name in names})
                for (probe, unit), names in probes.items()]
    shared = {}
    for (probe, unit), names in probes.items():
        for name in names:
            if history.moves(name):
                shared.setdefault((unit, component(name)), []).append((probe, name))
    panels = []
    for (unit, what), members in shared.items():
        pages = -(-len(members) // LINES_OF_A_PANEL)
        size = -(-len(members) // pages)
        for k in range(pages):
            some = members[k * size:(k + 1) * size]
            first, last = (shorter(some[end][0], LETTERS) for end in (0, -1))
            span = first if len(some) == 1 else f"{first} to {last}"
            lines = {probe: history.columns[name] for probe, name in some}
            panels.append((f"{what} of {span}" if what != some[0][0] else span, unit, lines))
    return panels


def all_panels(history):
    return energy_panels(history) + general_panels(history) + probe_panels(history)


# --- drawing --------------------------------------------------------------------------------------------------------

ENERGY_STYLE = {name: {"color": colour} for name, colour in zip(ENERGIES, COLOURS)}
ENERGY_STYLE.update(external={"color": "#0072b2", "linestyle": "--"}, eroded={"color": "#d55e00", "linestyle": "--"},
                    driven={"color": "#cc79a7", "linestyle": "--"},
                    walls={"color": "#009e73", "linestyle": "--"}, total={"color": "black", "linewidth": 1.8})


def thinned(time, values):
    """Extremes of so many pieces, where a line has more points than can be seen."""
    if len(time) <= MOST_POINTS:
        return time, values
    bounds = np.linspace(0, len(time), MOST_POINTS // 2 + 1).astype(int)[:-1]
    filled = np.where(np.isfinite(values), values, 0.0)
    ends = np.append(bounds, len(time))
    kept = np.concatenate([[a + np.argmin(filled[a:b]), a + np.argmax(filled[a:b])] for a, b in zip(ends, ends[1:])])
    kept = np.unique(np.concatenate([[0], kept, [len(time) - 1]]))
    return time[kept], values[kept]


def draw_panel(axes, one, history):
    title, unit, lines = one
    for k, (name, values) in enumerate(lines.items()):
        style = ENERGY_STYLE.get(name) if title == "energy" else None
        style = {"color": COLOURS[k % len(COLOURS)], "linestyle": ("-", "--", ":")[k // len(COLOURS) % 3], **(style or {})}
        time, shown = thinned(history.columns["time"], np.where(np.isfinite(values), values, np.nan))
        marker = {"marker": "o", "markersize": 3} if len(time) < 3 else {}
        axes.plot(time, shown, label=shorter(name, LETTERS), **{"linewidth": 1.3, **marker, **style})
    words = title.replace("_", " ")
    axes.set_title(shorter(words, 52) + unit_text(unit), fontsize=9.5, loc="left")
    axes.set_xlabel(f"time{unit_text(history.units.get('time', ''))}", fontsize=9)
    axes.tick_params(labelsize=8.5)
    axes.ticklabel_format(axis="both", style="sci", scilimits=(-3, 4), useMathText=True)
    axes.yaxis.get_offset_text().set(fontsize=8.5, ha="right")
    axes.xaxis.get_offset_text().set_fontsize(8.5)
    axes.grid(alpha=0.3)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    if len(lines) > 1:
        longest = max(len(shorter(name, LETTERS)) for name in lines)
        axes.legend(fontsize=8, ncol=min(4, LINE // (longest + 6)), loc="upper center", bbox_to_anchor=(0.5, -0.2), frameon=False,
                    columnspacing=1.2, handlelength=1.6)


def grid_of(panels, history, across, width=6.0, height=3.4):
    """A figure with all panels, row by row."""
    import matplotlib.pyplot as plt
    across = min(across, len(panels))
    down = -(-len(panels) // across)
    figure, places = plt.subplots(down, across, figsize=(width * across, height * down), squeeze=False,
                                  constrained_layout=True)
    figure.get_layout_engine().set(hspace=0.06, wspace=0.04)
    for place, one in zip(places.flat, panels):
        draw_panel(place, one, history)
    for unused in places.flat[len(panels):]:
        unused.remove()
    return figure
