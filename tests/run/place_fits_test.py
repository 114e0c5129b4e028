#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""initial_overlap: place with pins in bores: after the run's set-up the pin is free and still in its bore, or the scene is
refused with one line that names the parts, the motion, the overlap and what to do.

    place_fits_test.py [--count N] [--seed S] [--table]     --table prints motions in units of the overlap

Judged by the nodes of state.h5 alone: those of the mesh as it is given, and those after the placement.
"""
import argparse
import os
import random
import re
import subprocess
import sys
import tempfile

import h5py
import numpy

MOST_OVERLAPS = 5  # what the program grants (src/app/whole/placed_far.hpp)
TOUCHING = 1e-6  # of the bore: the gap that is left, and rounding
PATIENCE = 120  # [s] of one run

REFUSAL = re.compile(r"^brunt: scene\.yaml:\d+: contact\.0\S*: out of range: initial_overlap: place would move part '(pin|hub)' by (\S+) mm "
                     r"relative to part '(pin|hub)', which it overlaps by (\S+) mm; expected at most 5 times the overlap: \S.*$")


class Fit:
    """A tube and a cylinder along z; the pin is displaced across and perhaps tilted."""

    def __init__(self, seed):
        dice = random.Random(f"place {seed}")
        self.name = f"fit {seed}"
        self.bore = dice.uniform(4, 15)
        self.around = 4 * dice.choice([4, 6, 8, 10])
        inscribed = self.bore * numpy.cos(numpy.pi / self.around)
        self.press = dice.random() < 0.15  # too thick: it fits nowhere
        self.clearance = -dice.uniform(0.1, 0.4) if self.press else dice.uniform(0.02, 0.5)
        self.over = dice.uniform(1, 2) if dice.random() < 0.1 else dice.uniform(0.1, 0.5)
        self.radius = inscribed - self.clearance
        self.length, self.pin_length = dice.uniform(8, 40), 0.0
        self.pin_length = self.length * dice.uniform(0.6, 2.2)
        angle = dice.uniform(0, 2 * numpy.pi)
        self.offset = max(0.0, self.clearance) + self.over
        self.shift = self.offset * numpy.array([numpy.cos(angle), numpy.sin(angle)])
        self.low = 0.5 * (self.length - self.pin_length) + dice.uniform(-0.2, 0.2) * self.length
        self.tilt = dice.uniform(0.05, 0.6) if dice.random() < 0.3 else 0.0
        self.about = dice.uniform(0, 2 * numpy.pi)
        self.pin_first = dice.random() < 0.5
        self.held = dice.random() < 0.4
        self.heavy = dice.choice(["hub", "pin", "none"])
        self.layers, self.across = dice.choice([2, 4]), dice.choice([4, 6, 8])

    def scene(self):
        tilt = ""
        if self.tilt:
            axis = f"[{numpy.cos(self.about):.6f}, {numpy.sin(self.about):.6f}, 0]"
            tilt = f", rotate: {{axis: {axis}, degrees: {self.tilt:.4f}}}"
        parts = [f"  - {{tube: {{part: hub, inner_radius: {self.bore:.6f}, outer_radius: {2 * self.bore:.6f}, length: {self.length:.6f}, "
                 f"elements: [2, {self.around}, {self.layers}]}}}}",
                 f"  - {{cylinder: {{part: pin, radius: {self.radius:.6f}, length: {self.pin_length:.6f}, elements: [{self.across}, 8], "
                 f"at: [{self.shift[0]:.6f}, {self.shift[1]:.6f}, {self.low:.6f}]{tilt}}}}}"]
        mesh = "\n".join(parts[::-1] if self.pin_first else parts)
        density = {part: "7.85e-5" if part == self.heavy else "7.85e-6" for part in ("hub", "pin")}
        held = "fixed: [{part: hub, dofs: [x, y, z]}]\n" if self.held else ""
        return (f"title: {self.name}\nunits: mm-ms-kg\nmesh:\n{mesh}\nmaterials:\n"
                + "".join(f"  of_{part}: {{model: elastic, density: {density[part]}, young: 210, poisson: 0.3}}\n" for part in density)
                + f"parts: {{hub: {{material: of_hub}}, pin: {{material: of_pin}}}}\n{held}"
                "contact: [{between: all, initial_overlap: place}]\nrun: {steps: 1}\n")


def nodes_of(path):
    """Of each part the coordinates of its nodes at the start of the run."""
    with h5py.File(path) as file:
        mesh = file["mesh"]
        coordinates, cells, block = mesh["coordinates"][...], mesh["connectivity"][...].reshape(-1, 8), mesh["element_block"][...]
        names = {b: mesh[f"block_{b}"].attrs["part"] for b in numpy.unique(block)}
    text = {b: (n.decode() if isinstance(n, bytes) else str(n)) for b, n in names.items()}
    return {text[b]: coordinates[numpy.unique(cells[block == b])] for b in text}


def rigid_motion(before, after):
    """The rotation and the translation that bring one set of points to the other (Kabsch), and the error."""
    one, other = before.mean(axis=0), after.mean(axis=0)
    u, _, v = numpy.linalg.svd((before - one).T @ (after - other))
    turn = v.T @ numpy.diag([1, 1, numpy.sign(numpy.linalg.det(v.T @ u.T))]) @ u.T
    shift = other - turn @ one
    return turn, shift, numpy.abs(before @ turn.T + shift - after).max()


def run(folder, *changes, out):
    return subprocess.run([os.environ["BRUNT"], "run", "scene.yaml", "--quiet", "--out", out, *changes], cwd=folder, capture_output=True,
                          text=True, timeout=PATIENCE, env=os.environ | {"OMPI_MCA_orte_tmpdir_base": folder})


class Outcome:
    """What became of a fit: `fault` tells what is wrong, `ratio` the pin's motion beside the hub in units of its overlap."""

    def __init__(self, fit):
        self.fit, self.fault, self.ratio, self.refused, self.guarded = fit, "", 0.0, False, False
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "scene.yaml"), "w", encoding="ascii") as file:
                file.write(fit.scene())
            placed = run(folder, out="placed")
            if placed.returncode not in (0, 3):
                return self.judge_refusal(placed)
            self.guarded = placed.returncode == 3  # a guard stopped the step after the placement, which is judged all the same
            given = run(folder, "--set", "contact=[]", out="given")
            if given.returncode != 0:
                self.fault = f"without contact: exit {given.returncode}: {given.stderr}"
                return None
            self.judge_positions(nodes_of(os.path.join(folder, "given/state.h5")), nodes_of(os.path.join(folder, "placed/state.h5")))
        return None

    def judge_refusal(self, done):
        self.refused = True
        lines = done.stderr.splitlines()
        told = REFUSAL.match(lines[0]) if len(lines) == 1 else None
        if done.returncode != 2 or not told:
            self.fault = f"exit {done.returncode}, not one clear line: {done.stderr}"
            return
        self.ratio = float(told.group(2)) / float(told.group(4))
        if {told.group(1), told.group(3)} != {"pin", "hub"} or not self.ratio > MOST_OVERLAPS:
            self.fault = f"names {told.groups()}"
        if not self.fit.press and not 0.5 * self.fit.over < float(told.group(4)) < 1.5 * self.fit.over + self.fit.pin_length * numpy.radians(self.fit.tilt):
            self.fault = f"overlap {told.group(4)} told, {self.fit.over:.3f} made"

    def judge_positions(self, given, placed):
        motions = {part: rigid_motion(given[part], placed[part]) for part in given}
        if max(error for *_, error in motions.values()) > 1e-9 * self.fit.length:
            self.fault = "a part is distorted"
            return
        turn, shift, _ = motions["hub"]
        before, after = given["pin"], (placed["pin"] - shift) @ turn  # as seen from the hub
        overlap = self.fit.over + 0.5 * self.fit.length * numpy.radians(self.fit.tilt)
        self.ratio = numpy.linalg.norm(after - before, axis=1).max() / overlap
        axial = abs((after - before).mean(axis=0)[2])
        sideways = numpy.linalg.norm(after.mean(axis=0)[:2])
        inside = after[(after[:, 2] > 0) & (after[:, 2] < self.fit.length)]
        ends = after[[after[:, 2].argmin(), after[:, 2].argmax()], 2]
        if sideways > self.fit.bore:
            self.fault = f"the pin has left its bore: {sideways:.3f} mm beside its axis, for an overlap of {overlap:.3f} mm"
        elif self.fit.press or ends[0] > 0.9 * self.fit.length or ends[1] < 0.1 * self.fit.length or axial > MOST_OVERLAPS * overlap:
            self.fault = f"the pin has left its bore: {axial:.3f} mm along it, for an overlap of {overlap:.3f} mm"
        elif numpy.linalg.norm(inside[:, :2], axis=1).max(initial=0) > self.fit.bore * (1 + TOUCHING):
            self.fault = "the pin is still inside the hub"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-v", "--table", action="store_true")
    options = parser.parse_args()
    outcomes = [Outcome(Fit(options.seed + k)) for k in range(options.count)]
    for one in outcomes:
        if options.table or one.fault:
            print(f"{one.fit.name}: {'refused' if one.refused else 'placed'}, {one.ratio:.2f} overlaps{', press fit' if one.fit.press else ''}"
                  f"{', tilted' if one.fit.tilt else ''}{', ' + one.fault if one.fault else ''}")
    faults = [one for one in outcomes if one.fault]
    kept = sorted(one.ratio for one in outcomes if not one.refused)
    away = sorted(one.ratio for one in outcomes if one.refused)
    print(f"{len(outcomes)} fits: {len(kept)} placed, by {kept[-1] if kept else 0:.2f} overlaps at most; {len(away)} refused, which would have moved by "
          f"{away[0] if away else 0:.2f} at least, {sum(one.fit.press for one in outcomes if one.refused)} of them press fits; {len(faults)} faults; "
          f"{sum(one.guarded for one in outcomes)} runs stopped by a guard in the step after the placement")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
