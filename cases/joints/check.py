#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Joints between rigid parts: a double pendulum and a parallelogram against published motion, links under a blow of 10,000 g."""
import math
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

GRAVITY = 9.81


def rates(y):
    """Of a double pendulum of uniform rods, m = L = 1: angles from the downward vertical, then their rates."""
    a, b, u, v = y
    c, s = math.cos(a - b), math.sin(a - b)
    # mass matrix [[4/3, c/2], [c/2, 1/3]]
    p = -0.5 * s * v * v - 1.5 * GRAVITY * math.sin(a)
    q = 0.5 * s * u * u - 0.5 * GRAVITY * math.sin(b)
    det = 4 / 9 - 0.25 * c * c
    return numpy.array([u, v, (p / 3 - 0.5 * c * q) / det, (4 / 3 * q - 0.5 * c * p) / det])


def pendulum(times):
    """Tip of the double pendulum released horizontally at rest, by the fourth-order method of Runge and Kutta."""
    y, t, tips = numpy.array([math.pi / 2, math.pi / 2, 0.0, 0.0]), 0.0, []
    for time in times:
        steps = max(1, math.ceil((time - t) / 2.0e-4))
        h = (time - t) / steps
        for _ in range(steps):
            k1 = rates(y)
            k2 = rates(y + 0.5 * h * k1)
            k3 = rates(y + 0.5 * h * k2)
            k4 = rates(y + h * k3)
            y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        t = time
        tips.append([math.sin(y[0]) + math.sin(y[1]), -math.cos(y[0]) - math.cos(y[1])])
    return numpy.array(tips)


def period(start, square):
    """Of a pendulum with omega_0^2 = square, released at this angle: 4 K(sin(start/2))/omega_0, K by the arithmetic-geometric mean."""
    a, b = 1.0, math.cos(start / 2)
    for _ in range(20):
        a, b = 0.5 * (a + b), math.sqrt(a * b)
    return 2 * math.pi / a / math.sqrt(square)


def check_double(case):
    exact_times = (0.5, 1.0, 2.0)
    # DOP853, Radau and a Taylor method of 20 digits agree to these digits
    published = [(1.2966885362, -1.4057799232), (-1.6621151358, -1.0414666372), (0.3135247765, -1.9147466176)]
    own = pendulum(exact_times)
    case.assert_below("our reference against published tips [m]", abs(own - published).max(), 1e-8)
    steps, errors = case.of_all((2.0e-3, 1.0e-3, 5.0e-4, 2.5e-4), (5.0e-4, 2.5e-4)), []
    for step in steps:
        result = case.run("double.yaml", {"run.step": step, "run.end": 2.0}, name=f"double_{step:g}")
        rows = [int(numpy.argmin(abs(result.history["time"] - t))) for t in exact_times]
        tips = numpy.column_stack([result.history["tip.x"], result.history["tip.z"]])[rows]
        errors.append(numpy.linalg.norm(tips - pendulum(result.history["time"][rows]), axis=1))
        case.assert_below(f"step {step:g}: gap of the hinge [m]", result.history["hinge_gap.gap"].max(), 1e-13)
    order = numpy.log2(errors[-2] / errors[-1])
    for t, value in zip(exact_times, order):
        case.assert_close(f"order of the tip at {t:g} s", 2.0, value, 0.05, "half-explicit rule, symmetric in time")
    case.table("tip", ["step [s]", *(f"error at {t:g} s [m]" for t in exact_times)],
               [[f"{step:g}", *(f"{e:.2e}" for e in error)] for step, error in zip(steps, errors)]
               + [["order", *(f"{o:.3f}" for o in order)]])
    end = case.of_all(20.0, 4.0)
    long_run = case.run("double.yaml", {"run.step": 5.0e-5, "run.end": end}, name="double_energy")
    case.assert_below(f"double pendulum, {end:g} s, step 5e-5: energy error / energy that moves", energy_error(long_run), 1e-6)
    short = {"run.end": 0.5}
    case.assert_same_on_ranks((1, 2, 3, 4), restarted=True, scene="double.yaml", overrides=short)
    whole = case.run("double.yaml", short, name="double_whole")
    case.assert_same_after_restart(whole, 0.25, scene="double.yaml", overrides=short)


def energy_error(result):
    """Largest change of the balance over the largest kinetic energy."""
    history = result.history
    total = history["total"]
    return abs(total - total[0]).max() / history["kinetic"].max()


def check_four_bar(case):
    rows = []
    for step in case.of_all((4.0e-3, 2.0e-3, 1.0e-3), (2.0e-3,)):
        result = case.run("four_bar.yaml", {"run.step": step}, name=f"four_bar_{step:g}")
        turn, time = result.history["turn.angle"], result.history["time"]
        middle = math.radians(30)  # the rods hang downwards there
        down = [t + (middle - a) / (b - a) * (s - t) for t, s, a, b in zip(time, time[1:], turn, turn[1:]) if (a - middle) * (b - middle) < 0]
        found = 2 * (down[-1] - down[0]) / (len(down) - 1)
        exact = period(math.radians(30), 1.2 * GRAVITY)
        gaps = max(result.history["left_gap.gap"].max(), result.history["right_gap.gap"].max())
        rows.append([f"{step:g}", f"{found:.7f}", f"{found / exact - 1:.2e}", f"{gaps:.1e}", f"{energy_error(result):.1e}"])
        case.assert_close(f"parallelogram, step {step:g}: period [s]", exact, found, 40 * step**2, "elliptic integral")
        case.assert_below(f"parallelogram, step {step:g}: gap over ten periods [m]", gaps, 1e-10)
        case.assert_below(f"parallelogram, step {step:g}: turn of one rod against the other [rad]",
                          abs(turn - result.history["other_turn.angle"]).max(), 1e-10)
    case.table("four_bar", ["step [s]", "period [s]", "error", "largest gap [m]", "energy error"], rows)


def felt_share(width):
    """What the top of three straight hanging bars feels of the mass of one, their width over their length given: with spins w (per unit
    speed of the top) the kinetic energy is least."""
    inertia = (1 + width**2) / 12
    above = numpy.array([[0.5, 0, 0], [1, 0.5, 0], [1, 1, 0.5]])  # velocity of the centres by the spins
    spins = numpy.linalg.solve(above.T @ above + inertia * numpy.eye(3), -above.T @ numpy.ones(3))
    centres = 1 + above @ spins
    return centres @ centres + inertia * (spins @ spins)


def check_blow(case):
    rows = []
    for step in case.of_all((2.0e-5, 1.0e-5, 5.0e-6), (1.0e-5,)):
        result = case.run("blow.yaml", {"run.step": step}, name=f"blow_{step:g}")
        history = result.history
        gaps = max(history[f"{joint}_gap.gap"].max() for joint in ("foot", "knee", "hip"))
        speed = 1.0e5 * 1.0e-4
        case.assert_close(f"blow, step {step:g}: speed of the base [m/s]", speed, result.last("base.x"), 1e-3, "impulse of the blow")
        case.assert_below(f"blow, step {step:g}: gap of a joint over a link", gaps / 0.2, 1e-6)
        mass = 7800 * 0.02 * 0.02 * 0.2
        first = numpy.argmax(history["time"] >= 1.0e-4)
        shove = history["impulse_foot.x"][first]
        rows.append([f"{step:g}", f"{gaps / 0.2:.1e}", f"{-shove:.5f}", f"{energy_error(result):.1e}"])
        case.assert_close(f"blow, step {step:g}: impulse on the links [N s]", felt_share(0.1) * mass * speed, -shove, 0.01,
                          "equations of Lagrange of the straight chain")
    case.table("blow", ["step [s]", "largest gap / link", "impulse of the base on the links at 0.1 ms [N s]", "energy error"], rows)
    short = {"run.end": 0.005}
    case.assert_same_on_ranks((1, 2, 3, 4), scene="blow.yaml", overrides=short)


def main():
    case = Case(__file__)
    check_double(case)
    check_four_bar(case)
    check_blow(case)
    case.finish()


main()
