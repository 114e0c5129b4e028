# SPDX-License-Identifier: Apache-2.0
"""What the checks of implicit scenes with mortar contact share."""
import numpy

# The same scene by the explicit solver, in half its stable step.
EXPLICIT = {"solver": None, "contact.0.method": "rate", "run.cfl": 0.45}


def energy(result):
    """Kinetic and internal energy of all bodies over that at the start, less 1; without what contact and friction took."""
    total = result.history["kinetic"] + result.history["internal"]
    return total / total[0] - 1


def momentum_error(result):
    """Largest change of the momentum over its size at the start."""
    momentum = numpy.stack([result.history[f"momentum_{c}"] for c in "xyz"])
    return float(numpy.abs(momentum - momentum[:, :1]).max() / numpy.linalg.norm(momentum[:, 0]))


def gain_in_a_step(result):
    """The most that contact and friction gave in one row of the history, over the energy at the start."""
    taken = result.history["contact"] + result.history["friction"]
    return float(max(0, -numpy.diff(taken).min()) / result.history["kinetic"][0])


def listed(ratios):
    return ", ".join(f"{r:.1e}" for r in ratios)


def outside_solver(result):
    """Share of the loop that is not the linear solver: elements, tangents, contact, files."""
    work = result.summary["implicit"]
    return 1 - (work["factorise_s"] + work["solve_s"]) / result.summary["loop_s"]


def check_balance(case, label, result):
    """Momentum and the ledger, which closes whatever contact takes or gives."""
    case.assert_below(f"{label}: momentum / at the start", momentum_error(result), 1e-12, "equal weights of both sides")
    case.assert_energy(result, energy_gate=1e-10, momentum_gate=1e-12)
    case.assert_within(f"{label}: iterations a step, mean", 1, 6, result.summary["implicit"]["iterations_mean"], "M6")


def check_conserved(case, label, result, down):
    """What holds in any free scene of scheme contact_implicit; down: the largest share of the energy that may go."""
    case.assert_within(f"{label}: energy of the bodies / at the start - 1, largest", -1, 1e-12, float(energy(result).max()),
                       "contact_implicit: never above its start")
    case.assert_within(f"{label}: share of the energy lost at the end", 0, down, -float(energy(result)[-1]), "gate")
    check_balance(case, label, result)


def check_quadratic(case, label, result):
    """Of the steps in which the set of contact stood over the last two residuals above rounding."""
    newton = result.summary["implicit"]["newton"]
    case.row("newton", ["run", "steps with quadratic convergence", "of", "residuals of the last step over the forces that act"],
             [label, newton["quadratic"], newton["judged"], listed(newton["steps"][-1]["residuals"])])
    case.assert_within(f"{label}: share of {newton['judged']} steps with log r_k+1 / log r_k >= 1.7", 0.9, 1,
                       newton["share_quadratic"], "M6: quadratic")


def report(case, label, result):
    """A row of the table of runs, for both solvers."""
    work, summary = result.summary.get("implicit", {}), result.summary
    iterations = f"{work['iterations_mean']:.2f}, {work['iterations_max']}" if work else ""
    case.row("solvers", ["run", "solver", "steps", "halved", "iterations a step, mean and most", "energy of the bodies, change at the end [%]",
                         "largest gain in a step / energy at the start", "deepest row", "loop [s]"],
             [label, "implicit" if work else "explicit", summary["steps"], work.get("halved", ""), iterations,
              f"{100 * energy(result)[-1]:.2f}", f"{gain_in_a_step(result):.0e}", f"{summary['max_penetration']:.2g}", summary["loop_s"]])
