# SPDX-License-Identifier: Apache-2.0
"""Words, tables and curves of a report."""
import os
import urllib.parse

import numpy as np

from history import energy_panels, general_panels, probe_panels
from report_page import Html, el, joined, number, section, table
from report_pictures import panel_figure

ENDS = {"end": "it reached run.end", "steps": "it took run.steps", "wall_limit": "run.wall_limit was over",
        "signal": "a signal asked for it", "control": "a file stop asked for it", "guard": "a physics guard",
        "fault": "a fault"}
ENERGY_WORDS = {"kinetic": "of all nodes", "internal": "work of the stresses", "hourglass": "work of hourglass forces",
                "bulk": "taken by bulk viscosity", "damping": "taken by damping", "contact": "taken by contact along its normals",
                "friction": "taken by friction, and by ties in shear", "walls": "taken by rigid walls",
                "external": "given by gravity, loads and prescribed motion", "eroded": "of elements taken away",
                "driven": "of drives on constraints that no motion satisfies",
                "total": "sum of all but external, less external"}
STRESSES = ("young", "yield", "hardening", "bulk", "shear")
OF_THE_MODEL = ("title", "units", "mesh", "materials", "parts", "sets", "curves", "run", "output", "history", "checkpoint", "space")
SHARE_COLOURS = {"element": "#0072b2", "search": "#e69f00", "enforcement": "#d55e00", "halo": "#009e73", "other": "#9aa3ad"}


def verdict(result):
    code = result.get("exit_code")
    why = ENDS.get(result.get("stopped_by"), result.get("stopped_by") or "")
    if not result.summary:
        kind, words = "wait", "no summary"
    elif code == 0:
        kind, words = "good", "complete"
    elif code == 5:
        kind, words = "wait", "stopped on request"
    else:
        kind, words = "bad", "stopped by a guard" if code == 3 else "ended with a fault"
    return el("span", words, class_=f"verdict {kind}"), f"The run ended because {why}." if code == 5 else ""


def header(result):
    badge, words = verdict(result)
    units = result.get("units") or result.scene.get("units") or "unknown"
    pieces = [el("h1", result.title()), el("p", badge)]
    pieces += [el("p", text) for text in [words, *(f"Stopped: {line}." for line in result.lines("stopped: "))] if text]
    pieces += [el("p", f"Restarted from {line}.") for line in result.lines("restart from ")]
    version = result.get("version")
    known = [f"{quantity} {unit}" for quantity in ("length", "time", "mass", "energy", "stress") if (unit := result.unit(quantity))]
    words = f"Units: {units}{' (' + ', '.join(known) + ')' if known else ''}."
    pieces.append(el("p", words + (f" Program: {version}." if version else ""), class_="soft"))
    return el("header", *pieces)


def facts(result):
    time, length = result.unit("time"), result.unit("length")
    entries = [("time reached", number(result.get("end_time"), time)), ("steps", number(result.get("steps"))),
               ("elements", number(result.get("elements"))), ("nodes", number(result.get("nodes"))),
               ("ranks", number(result.get("ranks"))), ("wall clock", number(result.get("wall_s"), "s", 3)),
               ("energy error", number(result.get("energy", "error_ratio"), digits=2)),
               ("momentum error", number(result.get("momentum_error"), digits=2)),
               ("largest penetration", number(result.get("max_penetration"), length, 3)),
               ("folded elements", number(result.get("folded_elements"))),
               ("warnings", number(result.get("warnings"))), ("state hash", el("code", result.get("state_hash") or "unknown"))]
    if not result.summary:
        return Html("")
    return el("dl", *(el("div", el("dt", name), el("dd", value)) for name, value in entries), class_="facts")


def warnings(result):
    lines = list(dict.fromkeys(result.lines("warning: ")))  # a restart repeats those of the scene
    pieces = []
    if lines:
        pieces.append(el("div", el("ul", *(el("li", line) for line in lines), class_="notes"), class_="warnings"))
    elif result.log:
        pieces.append(el("p", "The run gave no warning."))
    if result.missing:
        pieces += [el("h3", "Not in this report"), el("ul", *(el("li", line) for line in result.missing), class_="notes")]
    return section("warnings", "Warnings", *pieces)


LONG_TABLE = 20  # rows; a longer one is folded


def folded(words, rows, listing):
    return el("details", el("summary", f"{len(rows)} {words}"), listing) if len(rows) > LONG_TABLE else listing


# --- the model ------------------------------------------------------------------------------------------------------

def in_line(tree):
    """A piece of the scene as one line of text."""
    if isinstance(tree, dict):
        return ", ".join(f"{key}: {in_brackets(value)}" for key, value in tree.items())
    if isinstance(tree, list):
        return "[" + ", ".join(in_brackets(value) for value in tree) + "]"
    return str(tree)


def in_brackets(tree):
    return "{" + in_line(tree) + "}" if isinstance(tree, dict) else in_line(tree)


def entries_of(tree):
    return tree if isinstance(tree, list) else [tree]


def map_of(tree, key):
    found = tree.get(key) if isinstance(tree, dict) else None
    return found if isinstance(found, dict) else {}


def parts_table(result):
    """Parts of the scene, with what state.h5 knows of them."""
    counts, ends = {}, {}
    if result.state:
        points = result.state.positions(result.state.records[0], 0.0)
        for part, _, connectivity, _ in result.state.blocks():
            counts[part] = counts.get(part, 0) + len(connectivity)
            corners = points[connectivity.ravel()]
            ends[part] = (corners.min(axis=0), corners.max(axis=0)) if len(corners) else None
    given = map_of(result.scene, "parts")
    rows = []
    for name in given or counts:
        part = given.get(name) if isinstance(given.get(name), dict) else {}
        extent = ends.get(name)
        spans = [f"{low:.5g} \u2026 {high:.5g}".replace("-", "\u2212") for low, high in zip(*extent)] if extent else ["unknown"] * 3
        rows.append([name, part.get("material", "unknown"), part.get("element", "hex8") if part else "unknown",
                     number(counts.get(name)), *spans])
    unit = f" [{result.unit('length')}]" if result.unit("length") else ""
    head = ["part", "material", "element", "elements", *(f"{axis} at the start{unit}" for axis in "xyz")]
    return folded("parts", rows, table(head, rows, class_="narrow"))


def material_text(result, material):
    stress = result.unit("stress")
    units = {key: stress for key in STRESSES}
    if result.unit("mass") and result.unit("length"):
        units["density"] = f"{result.unit('mass')}/{result.unit('length')}\u00b3"
    words = [f"{key.replace('_', ' ')} {in_line(value)} {units.get(key, '') if isinstance(value, str) else ''}".rstrip()
             for key, value in material.items() if key != "model"]
    return ", ".join(words)


def model(result):
    pieces = [parts_table(result)] if result.scene or result.state else []
    materials = map_of(result.scene, "materials")
    rows = [[name, material.get("model", "unknown"), material_text(result, material)]
            for name, material in materials.items() if isinstance(material, dict)]
    if rows:
        pieces += [el("h3", "Materials"), table(["material", "law", "parameters"], rows)]
    rows = [[key.replace("_", " ") if k == 0 else "", in_line(entry)]
            for key, tree in result.scene.items() if key not in OF_THE_MODEL for k, entry in enumerate(entries_of(tree))]
    if rows:
        pieces += [el("h3", "Motions, supports, loads, contact, probes"), folded("entries", rows, table([], rows))]
    if result.scene_text:
        pieces.append(el("details", el("summary", "The whole scene"), el("pre", result.scene_text)))
    return section("model", "Model", *pieces) if pieces else Html("")


# --- curves and tables ----------------------------------------------------------------------------------------------

def curves(panels, history):
    return el("div", *(panel_figure(one, history) for one in panels), class_="plots")


def largest_energy(result):
    """The scale of error_ratio, as the history knows it."""
    columns = result.history.columns if result.history else {}
    if not all(name in columns for name in ("kinetic", "internal", "external")):
        return None
    with np.errstate(invalid="ignore"):
        sizes = np.fmax(columns["kinetic"] + columns["internal"], np.abs(columns["external"]))
    sizes = sizes[np.isfinite(sizes)]
    return float(sizes.max()) if len(sizes) and sizes.max() > 0 else None


def share(value, whole):
    if whole is None or not isinstance(value, (int, float)) or not np.isfinite(value):
        return Html("")
    return number(float(100 * value / whole), "%", 3)


def energies(result):
    energy = result.get("energy")
    pieces = [curves(energy_panels(result.history), result.history)] if result.history else []
    if isinstance(energy, dict):
        unit, whole = result.unit("energy"), largest_energy(result)
        rows = [[name, number(value, unit, 5), share(value, whole), ENERGY_WORDS.get(name, "")]
                for name, value in energy.items() if name != "error_ratio"]
        pieces += [el("h3", "At the end"), table(["energy", "value", "of the largest", "what it is"], rows, class_="numbers")]
        scale = f" The largest kinetic and internal (or external) energy was {number(whole, unit)}." if whole else ""
        pieces.append(el("p", Html(f"The total changed by {number(energy.get('error_ratio'), digits=2)} of the largest energy at "
                                   f"most (error ratio).{scale}")))
    return section("energies", "Energies", *pieces) if pieces else Html("")


def motion(result):
    pieces = [curves(general_panels(result.history), result.history)] if result.history else []
    contact = result.get("contact")
    if isinstance(contact, dict) and contact.get("steps"):
        pieces.append(el("p", Html(f"Contact acted in {number(contact.get('steps'))} steps, with "
                                   f"{number(contact.get('iterations_mean'), digits=3)} iterations on average and "
                                   f"{number(contact.get('iterations_max'))} at most; {number(contact.get('steps_at_limit'))} steps "
                                   f"ended at the limit. Candidate lists were built {number(contact.get('searches'))} times.")))
    return section("motion", "Momentum, contact and step", *pieces) if pieces else Html("")


def probes(result):
    panels = probe_panels(result.history) if result.history else []
    return section("probes", "Probes", curves(panels, result.history)) if panels else Html("")


def cost(result):
    shares = {name: value for name, value in map_of(result.summary, "share").items()
              if isinstance(value, (int, float)) and np.isfinite(value)}
    if not shares:
        return Html("")
    bar = el("div", *(el("span", style=f"flex:{max(value, 0):.4f} 1 0;background:{SHARE_COLOURS.get(name, '#555')}")
                      for name, value in shares.items()), class_="bar")
    rows = [[joined([el("span", class_="key", style=f"background:{SHARE_COLOURS.get(name, '#555')}"), name]),
             number(100 * float(value), "%", 3)] for name, value in shares.items()]
    words = Html(f"The time loop took {number(result.get('loop_s'), 's', 3)}, output included, or "
                 f"{number(result.get('ns_per_element_step'), 'ns', 3)} an element, step and rank without output.")
    return section("cost", "Cost", el("p", words), bar, table(["share of the loop", ""], rows, class_="numbers"))


def size_text(count):
    for unit in ("bytes", "kB", "MB", "GB"):
        if count < 1000 or unit == "GB":
            return f"{count:.3g} {unit}"
        count /= 1000


def files(result, page_folder):
    rows = []
    for name, what, count in result.files():
        link = os.path.relpath(result.path(name), page_folder)
        rows.append([el("a", name, href=urllib.parse.quote(link)), what, size_text(count)])
    return section("files", "Files", table(["file", "what it is", "size"], rows, class_="narrow"))
