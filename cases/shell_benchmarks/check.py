#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Shells against beam, plate and shell theory: frequencies, large turns, the obstacle course, plastic bending."""
import json
import math
import os
import resource
import sys

import numpy

sys.path[:0] = [os.path.dirname(os.path.abspath(__file__)), os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support")]
import plastic  # noqa: E402
import problems  # noqa: E402
from case_check import Case  # noqa: E402

SHELLS = problems.SHELLS
SIDES = (4, 8, 16, 32)
COURSE = (problems.roof, problems.pinched_cylinder, problems.hemisphere, problems.twisted_beam,
          lambda n, element: problems.twisted_beam(n, element, along_width=False))
GATE = 0.02  # on the finest mesh
# The membrane of the triangle has constant strains, which is stiff where it bends in its plane.
WIDER = {("roof", "shell3", 16): 0.05, ("pinched cylinder", "shell3", 32): 0.06, ("twisted beam, across its tip", "shell3", 32): 0.06}
COURSE_SOURCE = "MacNeal and Harder 1985; Belytschko et al. 1985"


def run(case, problem, name, **arguments):
    """Writes scene and mesh into the work folder and runs them."""
    folder = os.path.join(case.work, "scenes", name)
    os.makedirs(folder, exist_ok=True)
    if problem.mesh is not None:
        problem.mesh.write(os.path.join(folder, "mesh.inp"), "skin")
    path = os.path.join(folder, "scene.yaml")
    with open(path, "w", encoding="utf-8") as stream:
        stream.writelines(f"{key}: {json.dumps(value, default=float)}\n" for key, value in problem.scene.items())  # flow style of YAML
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    result = case.run(path, name=name, **arguments)
    result.scene = "written by check.py"
    result.seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before  # of processors, with the start of about 0.1 s
    return result


def label(problem, element, n):
    words = problem.replace(",", "").replace(" / ", "_over_").replace("=", "").split()
    return "_".join([*words, element, str(n)])


def hourglass_share(result):
    energy = result.summary["energy"]
    return energy["hourglass"] / max(energy["internal"], 1e-300)


def balances(case, result, what, element, n):
    """The ledger closes, and hourglass control holds little on meshes of 16 and more. The error of the momentum is over the largest sum of m |v|, which a body at rest
    has not."""
    case.assert_below("energy error ratio", result.summary["energy"]["error_ratio"], 1e-10)
    if not result.summary.get("relaxation", {}).get("steps"):
        case.assert_below("momentum error", result.summary["momentum_error"], 1e-10)
    if element == "shell4" and n >= 16:
        case.assert_below(f"{element}, {n} a side: hourglass / internal energy, {what}", hourglass_share(result), 0.05, "issue: below 5 %")


def steps_of(result):
    return result.summary.get("relaxation", {}).get("steps", 0) + result.summary["steps"]


def static(case, make, element, n, checked=False, source=""):
    """One static problem on one mesh: the value of each quantity over its reference."""
    problem = make(n, element)
    name = next(iter(problem.measured))
    result = run(case, problem, label(name, element, n))
    found = {}
    for quantity, (column, factor, reference) in problem.measured.items():
        value = factor * float(result.history[column][0])
        found[quantity] = value / reference
        if checked:
            gate = WIDER.get((quantity, element, n), GATE)
            case.assert_close(f"{element}, {n} a side: {quantity}", reference, value, gate, source)
        case.row("errors", ["problem", "element", "elements a side", "over the reference", "steps", "processor time [s]"],
                 [quantity, element, n, f"{found[quantity]:.4f}", steps_of(result), result.seconds])
    balances(case, result, name, element, n)
    return found


def order(values):
    """Order of convergence from the last three meshes, each twice as fine as the one before; a text."""
    if len(values) < 3:
        return ""
    first, second = values[-2] - values[-3], values[-1] - values[-2]
    return f"{math.log2(first / second):.1f}" if first * second > 0 and abs(second) > 1e-5 else "-"


def convergence(case, table, makes, elements, sides=SIDES, checked=True, source=""):
    """A table: problems and elements by mesh, values over their references; the finest mesh is checked."""
    for make in makes:
        for element in elements:
            by_mesh = [static(case, make, element, n, checked and n == sides[-1], source) for n in sides]
            for quantity in by_mesh[0]:
                values = [found[quantity] for found in by_mesh]
                case.row(table, ["problem", "element", *(f"{n} a side" for n in sides), "order"],
                         [quantity, element, *(f"{value:.4f}" for value in values), order(values)])


def fitted_frequencies(time, signal, guesses, width=0.12):
    """Angular frequencies of a sum of sinusoids (and a constant) nearest to the signal in least squares: one after the other, several times."""
    found = list(guesses)

    def misfit(trial):
        columns = [f(omega * time) for omega in trial for f in (numpy.cos, numpy.sin)]
        basis = numpy.column_stack([*columns, numpy.ones_like(time)])
        right = basis.T @ signal
        return -float(right @ numpy.linalg.solve(basis.T @ basis, right))  # and the signal's own square

    while width > 1e-5:
        for _ in range(2):
            for i, centre in enumerate(found):
                grid = centre * (1 + width * numpy.linspace(-1, 1, 21))
                trials = [[*found[:i], omega, *found[i + 1:]] for omega in grid]
                found[i] = float(grid[numpy.argmin([misfit(trial) for trial in trials])])
        width *= 0.3
    return found


def frequencies(case, make, element, n, gate=None, note=""):
    """First two within the gate, the third in the table."""
    problem = make(n, element)
    name = next(iter(problem.measured)).replace(" mode 1", "") + note
    result = run(case, problem, label(f"{name} modes", element, n))
    column = next(iter(problem.measured.values()))[0]
    references = [reference for _, _, reference in problem.measured.values()]
    found = fitted_frequencies(result.history["time"], result.history[column], [2 * math.pi * f for f in references])
    found = [omega / (2 * math.pi) for omega in found]
    if gate:
        for mode in (0, 1):
            case.assert_close(f"{element}, {n} a side: {name} mode {mode + 1} [Hz]", references[mode], found[mode], gate, "beam and plate theory")
    case.row("frequencies", ["body", "element", "elements a side", "mode 1 [Hz]", "mode 2 [Hz]", "mode 3 [Hz]", "errors", "steps", "processor time [s]"],
             [name, element, n, *(f"{f:.3f}" for f in found), ", ".join(f"{100 * (f / r - 1):+.2f} %" for f, r in zip(found, references, strict=True)),
              result.summary["steps"], result.seconds])
    balances(case, result, name, element, n)


def check_frequencies(case):
    for element in SHELLS:
        for n in SIDES if case.long else (16,):
            gate = GATE if n == 16 else None
            frequencies(case, problems.vibrating_strip, element, n, gate)
            frequencies(case, problems.vibrating_plate, element, n, gate)
        if case.long:
            frequencies(case, lambda n, kind: problems.vibrating_plate(n, kind, 0.25), element, 16, note=", skewed")
    if case.long:  # one-point hexahedra are far too stiff where they are more than some five times as long as high
        frequencies(case, problems.vibrating_strip, "hex8", 50)


def check_statics(case):
    if not case.long:
        for element in SHELLS:
            static(case, problems.elastica, element, 16, True, "Bisshopp and Drucker 1945")
            static(case, problems.roof, element, 16, True, COURSE_SOURCE)
        for make in COURSE[1:]:
            static(case, make, "shell4", 16 if make is problems.hemisphere else 32, True, COURSE_SOURCE)
        static(case, lambda n, kind: problems.roll_up(n, kind, 0.5), "shell4", 16, True, "circle")
        return
    convergence(case, "course", COURSE, SHELLS, source=COURSE_SOURCE)
    thin = [lambda n, kind, along=along: problems.twisted_beam(n, kind, along, 0.0032) for along in (True, False)]
    convergence(case, "thin", thin, SHELLS, (4, 8), checked=False)
    plates = [problems.plate_under_pressure, lambda n, kind: problems.plate_under_pressure(n, kind, 0.25)]
    convergence(case, "plate", plates, SHELLS, source="Navier")
    turns = [lambda n, kind, alpha=alpha: problems.elastica(n, kind, alpha) for alpha in (1.0, 4.0, 10.0)]
    convergence(case, "turns", turns, SHELLS, source="Bisshopp and Drucker 1945")
    rolls = [lambda n, kind, share=share: problems.roll_up(n, kind, share) for share in (0.5, 1.0)]
    convergence(case, "turns", rolls, SHELLS, source="circle")


def check_bits(case):
    """The plate of scene.yaml flows and loses elements; an end moment rolls a strip up by relaxation."""
    short = {"run.end": 5.0e-3, "output.every": 5.0e-3, "parts.skin.erosion": {"plastic_strain": 0.004}}
    case.assert_same_on_ranks((1, 2, 3, 4), overrides=short)
    whole = case.run(overrides=short, name="whole")
    case.assert_below("energy error ratio", whole.summary["energy"]["error_ratio"], 1e-10)
    case.assert_within("plate that loses elements: energy eroded / at the start", 0.01, 0.5,
                       whole.summary["energy"]["eroded"] / whole.history["kinetic"][0])
    case.assert_same_after_restart(whole, 2.5e-3, overrides=short)
    if case.given.one_rank:
        return
    for element in SHELLS[1:]:
        one, three = (run(case, problems.roll_up(8, element, 0.5), f"roll_{element}_np{n}", ranks=n) for n in (1, 3))
        case.assert_same_state("state on 3 ranks", one, three)


def main():
    case = Case(__file__)
    check_frequencies(case)
    check_statics(case)
    plastic.check(case, run)
    check_bits(case)
    case.finish()


if __name__ == "__main__":
    main()
