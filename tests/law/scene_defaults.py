#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Every default that src/scene/README.md states as a number or a word of the scene is the one of the source. Usage: scene_defaults.py ROOT
Keys, types and ranges are compared with the running program: tests/run/scene_reference_test.py."""
import os
import re
import sys

import tree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "lib"))
import scene_page  # noqa: E402

INPUT, LAW, CONTACT = "src/scene/input.hpp", "src/material/law.hpp", "src/contact/data/options.hpp"
ELEMENT, SOLVER, EROSION = "src/element/options.hpp", "src/model/implicit_solver.hpp", "src/model/erosion.hpp"
GUARDS = "src/scene/guards.hpp"
PARTS, METALS, READ_SOLVER = "src/scene/read/read_parts.cpp", "src/scene/read/read_metals.cpp", "src/scene/read/read_solver.cpp"
FIGURES = {key: [(CONTACT, "EnforcementSettings", key)] for key in ("method", "tolerance", "max_iterations", "partition", "stiffness", "damping")}
FIGURES |= {"softness": [(CONTACT, "EnforcementSettings", "softness"), (CONTACT, "EnforcementSettings", "softness_of_bodies")],
            "competing": [(INPUT, "Enforcement", "competing")], "rebuild": [(CONTACT, "Rebuild", "when")]}

# Where the default of a key stands: file, struct (none: the whole file), name. Several where the page states several.
PLACES = {
    "mesh": {"scale": [(INPUT, "Placement", "scale")], "at": [(INPUT, "Placement", "at")]},
    "mesh.BODY": {"scale": [(INPUT, "Placement", "scale")], "at": [(INPUT, "Placement", "at")], "finer": [(INPUT, "SphereMesh", "finer")],
                  "bias": [("src/mesh/division.hpp", None, "bias")]},
    "materials": {"stress_rate": [(LAW, "Elastic", "stress_rate")], "hardening": [(LAW, "J2", "hardening")],
                  "kinematic": [(LAW, "J2", "kinematic")],
                  "rate": [(LAW, "RateFactor", "reference")], "rate_form": [(METALS, None, "law.rate.form")],
                  "pressure_yield": [(LAW, "LinearStrength", "pressure_yield")], "rate_steps": [(LAW, "Metal", "rate_steps")],
                  "taylor_quinney": [(LAW, "Heat", "taylor_quinney")], "temperature": [(LAW, "Heat", "start")]},
    "materials.damage": {"D4": [(LAW, "RateFactor", "c")], "D5": [(LAW, "Fracture", "d5")], "critical": [(LAW, "Fracture", "critical")],
                         "softens": [(LAW, "Fracture", "softens")]},
    "materials.eos": {"energy": [(LAW, "EquationOfState", "start_energy")],
                      **{f"C{k}": [(LAW, "EquationOfState", "polynomial")] for k in (0, 2, 3, 4, 5, 6)}},
    "parts": {"element": [(INPUT, "Part", "element")]},
    "parts.hourglass": {"kind": [(ELEMENT, "Hourglass", "kind")],
                        "coefficient": [(PARTS, None, "default_stiffness"), (PARTS, None, "default_viscous")]},
    "parts.bulk": {"linear": [(ELEMENT, "BulkViscosity", "linear")], "quadratic": [(ELEMENT, "BulkViscosity", "quadratic")]},
    "parts.erosion": {"points": [(EROSION, "Erosion", "points")], "nodes": [(EROSION, "Erosion", "keeps_nodes")]},
    "initial": {"velocity": [(INPUT, "InitialMotion", "velocity")]},
    "initial.rotation": {"point": [(INPUT, "InitialMotion", "spin_point")]},
    "prescribed": {"scale": [(INPUT, "Prescribed", "scale")]},
    "damping": {"from": [(INPUT, "Damping", "from")]},
    "relaxation": {"tolerance": [(INPUT, "Relaxation", "tolerance")], "max_steps": [(INPUT, "Relaxation", "max_steps")]},
    "remove": {"nodes": [(INPUT, "Removal", "keeps_nodes")]},
    "rigid_walls": {"friction": [(CONTACT, "FrictionLaw", "fixed")], "bilateral": [(INPUT, "RigidWall", "bilateral")]},
    "contact": {**FIGURES, "friction": [(CONTACT, "FrictionLaw", "fixed")],
                "initial_overlap": [(INPUT, "ContactEntry", "initial_overlap"), ("src/scene/read/read_contact.cpp", None, "contact.initial_overlap")],
                "limit": [("src/app/whole/placed_far.hpp", None, "most_overlaps")],
                **{key: [(INPUT, "ContactEntry", key)] for key in ("self", "passes", "slave", "tied", "multiplier", "enforce", "consistent", "edges")}},
    "contact.friction": {"decay": [(CONTACT, "FrictionLaw", "decay")], "lag": [(CONTACT, "FrictionLaw", "lag")]},
    "enforcement": FIGURES,
    "run": {key: [(INPUT, "Run", key)] for key in ("cfl", "step_bound", "min_step_ratio")},
    "output": {"fields": [(INPUT, "Output", "fields")]},
    "search": {"method": [(INPUT, "Input", "search")]},
    "guards": {key: [(GUARDS, "Guards", key)] for key in (
        "energy_warning", "energy_stop", "kinetic", "depth_warning", "depth_stop", "depth_step", "parted", "hourglass", "angular_momentum")},
    "solver": {**{key: [(SOLVER, "ImplicitSolver", key)] for key in ("scheme", "tolerance", "linear", "alpha", "stability")},
               "step": [(READ_SOLVER, None, "default_steps")], "min_step": [(READ_SOLVER, None, "default_halvings")]},
}
# Rows whose value is a sentence of the code, not a constant: what is absent, or taken of another key.
SAID = {("scene", "title"), ("scene", "space"), ("scene", "solver"), ("mesh", "prefix"), ("mesh.BODY.nose", "elements"), ("materials", "tension"),
        ("materials.damage", "rate"), ("materials.damage", "rate_form"), ("parts", "block"), ("parts", "hourglass"), ("parts", "bulk"),
        ("parts.rigid", "mass"), ("parts.rigid", "centre"), ("parts.rigid", "inertia"), ("pressure", "curve"), ("forces", "curve"),
        ("traction", "curve"), ("gravity", "curve"), ("damping", "to"), ("rigid_walls", "name"), ("rigid_walls", "motion"),
        ("rigid_walls", "parts"), ("contact", "thickness"), ("contact.friction", "kinetic"), ("probes", "about"), ("probes.section", "about"),
        ("output", "every"), ("solver", "max_step")}
WORDS = {"automatic": "auto", "statics": "static", "motion_used_up": "auto", "Vec3::Zero()": "[0, 0, 0]"}


def initialiser(root, path, struct, member):
    """Text of the value that a member or constant begins with."""
    text = re.sub(r"//.*", "", tree.read(root, path))
    if struct:
        text = re.search(rf"\bstruct {struct} \{{.*?\n\}};", text, re.S)[0]
    found = re.search(rf"\b{re.escape(member)}(?: ?= ?([^;,{{]+)|(\{{[^;]*\}}))[;,]", text)
    return (found[1] or found[2]).strip()


def in_scene(value, key):
    """How a scene writes a value of the source."""
    value = value.split("::")[-1] if "()" not in value else value
    if key == "nodes":
        return {"true": "keep", "false": "drop"}[value]
    if key == "stability":
        return {"true": "warn", "false": "ignore"}[value]
    if key == "min_step":
        return repr(2.0 ** float(value))  # a number of halvings
    value = re.sub('"', "", WORDS.get(value, value))
    if value == "{}":
        return "0"
    return f"[{value[1:-1]}]" if value.startswith("{") else value


def stated(default):
    """Values of a cell such as "0.05; viscous 0.1", "`error`; tied `offset`", "`run.end` / 100"."""
    values = []
    for part in default.split("; "):
        found = re.search(r"`[\w.]+` / (\d+)|`([^`]+)`|(-?\d[\d.e+-]*)", part)
        values.append(next(group for group in found.groups() if group) if found else part)
    return values


def same(page, source):
    try:
        return float(page) == float(source)
    except ValueError:
        return page == source


def faults(root):
    wrong, count = [], 0
    for name, rows in scene_page.tables(tree.read(root, "src/scene/README.md")).items():
        for row in rows:
            places = PLACES.get(name, {}).get(row.key)
            if row.default.startswith(("required", "none")) or (name, row.key) in SAID or row.default == "`room`":
                continue
            if places is None:
                wrong.append(f"src/scene/README.md: {name}: {row.key}: no place in the source is known for the default '{row.default}'")
                continue
            count += 1
            values = [in_scene(initialiser(root, *place), row.key) for place in places]
            if len(values) != len(stated(row.default)) or not all(map(same, stated(row.default), values)):
                wrong.append(f"src/scene/README.md: {name}: {row.key}: default '{row.default}'; the source has {', '.join(values)}")
    return wrong, f"{count} defaults"


if __name__ == "__main__":
    sys.exit(tree.report("scene_defaults", *faults(sys.argv[1])))
