#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A torque-free asymmetric top: spin and orientation against Jacobi's elliptic functions, order, conservation, same bits."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402


def jacobi(u, k):
    """sn, cn, dn by the arithmetic-geometric mean (Abramowitz, Stegun 16.4)."""
    a, c, b = [1.0], [k], numpy.sqrt(1 - k * k)
    while abs(c[-1]) > 1e-17 and len(a) < 20:
        a_next, c_next, b = 0.5 * (a[-1] + b), 0.5 * (a[-1] - b), numpy.sqrt(a[-1] * b)
        a.append(a_next)
        c.append(c_next)
    phase = 2 ** (len(a) - 1) * a[-1] * u
    for i in range(len(a) - 1, 0, -1):
        phase = 0.5 * (phase + numpy.arcsin(c[i] * numpy.sin(phase) / a[i]))
    sn = numpy.sin(phase)
    return sn, numpy.cos(phase), numpy.sqrt(1 - k * k * sn * sn)


class Top:
    """Landau and Lifshitz, Mechanics, section 37: I1 < I2 < I3, l^2 > 2 E I2, no spin about axis 2 at t = 0."""

    def __init__(self, moments, spin):
        self.moments = numpy.array(moments)
        momentum = self.moments * spin
        self.momentum, energy2 = numpy.linalg.norm(momentum), float(momentum @ spin)
        i1, i2, i3 = moments
        l2 = self.momentum**2
        above, below = energy2 * i3 - l2, l2 - energy2 * i1
        assert l2 > energy2 * i2 and spin[1] == 0
        self.amplitude = numpy.sqrt([above / (i1 * (i3 - i1)), above / (i2 * (i3 - i2)), below / (i3 * (i3 - i1))])
        self.rate = numpy.sqrt((i3 - i2) * below / (i1 * i2 * i3))
        self.modulus = numpy.sqrt((i2 - i1) * above / ((i3 - i2) * below))

    def spin(self, time):
        """In body axes, a row a time."""
        sn, cn, dn = jacobi(self.rate * numpy.asarray(time), self.modulus)
        return numpy.column_stack([cn, sn, dn]) * self.amplitude

    def precession(self, times):
        """The angle about the angular momentum at these ascending times, by Gauss quadrature in 200 pieces between two."""
        points, weights = numpy.polynomial.legendre.leggauss(5)
        angles = [0.0]
        for start, end in zip(times[:-1], times[1:]):
            edges = numpy.linspace(start, end, 21)
            half = 0.5 * (edges[1:] - edges[:-1])
            at = (0.5 * (edges[1:] + edges[:-1]))[:, None] + half[:, None] * points
            w, i = self.spin(at.ravel()), self.moments
            rate = self.momentum * (i[0] * w[:, 0] ** 2 + i[1] * w[:, 1] ** 2) / (
                (i[0] * w[:, 0]) ** 2 + (i[1] * w[:, 1]) ** 2)
            angles.append(angles[-1] + float(numpy.sum(rate.reshape(at.shape) * weights * half[:, None])))
        return numpy.array(angles)

    def orientations(self, times):
        """Body to space axes, the identity at times[0]."""
        frames = []
        for w, angle in zip(self.spin(times), self.precession(times)):
            down = self.moments * w / self.momentum  # the angular momentum in body axes
            psi, theta = numpy.arctan2(down[0], down[1]), numpy.arccos(down[2])
            frames.append(about(2, angle) @ about(0, theta) @ about(2, psi))
        return [frames[0].T @ frame for frame in frames]


def about(axis, angle):
    c, s = numpy.cos(angle), numpy.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix = numpy.eye(3)
    matrix[i, i], matrix[j, j], matrix[i, j], matrix[j, i] = c, c, -s, s
    return matrix


def rotation(vector):
    angle = numpy.linalg.norm(vector)
    if angle == 0:
        return numpy.eye(3)
    x, y, z = vector / angle
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + numpy.sin(angle) * cross + (1 - numpy.cos(angle)) * cross @ cross


def vectors(result, name):
    return numpy.column_stack([result.history[f"{name}.{c}"] for c in "xyz"])


def errors_of(result, top):
    """Largest errors of the spin in body axes [rad/s] and of the orientation [rad]."""
    time, turn, spin = result.history["time"], vectors(result, "turn"), vectors(result, "spin")
    ours = [rotation(vector) for vector in turn]
    in_body = numpy.array([R.T @ w for R, w in zip(ours, spin)])
    wrong = [R.T @ exact for R, exact in zip(ours, top.orientations(time))]
    sine = [0.5 * numpy.linalg.norm([D[2, 1] - D[1, 2], D[0, 2] - D[2, 0], D[1, 0] - D[0, 1]]) for D in wrong]
    return numpy.linalg.norm(in_body - top.spin(time), axis=1).max(), max(numpy.arcsin(numpy.minimum(sine, 1)))


def main():
    case = Case(__file__)
    scene = case.scene()
    size = numpy.array(scene["mesh"]["box"]["size"])
    mass = scene["materials"]["steel"]["density"] * size.prod()
    moments = mass / 12 * (size @ size - size**2)
    axis = numpy.array(scene["initial"][0]["rotation"]["axis"])
    top = Top(moments, scene["initial"][0]["rotation"]["rate"] * axis / numpy.linalg.norm(axis))
    errors = []
    steps = (4.0e-3, 2.0e-3, 1.0e-3, 5.0e-4)
    for step in steps:
        result = case.run(overrides={"run.step": step}, name=f"step_{step:g}")
        errors.append(errors_of(result, top))
        case.assert_below(f"step {step:g}: energy error", result.summary["energy"]["error_ratio"], 1e-12)
        l = vectors(result, "momentum")
        case.assert_below(f"step {step:g}: angular momentum", abs(l - l[0]).max() / numpy.linalg.norm(l[0]), 1e-13)
        place = vectors(result, "place")
        straight = result.history["time"][:, None] * numpy.array(scene["initial"][0]["velocity"])
        case.assert_below(f"step {step:g}: centre from its straight line [m]", abs(place - straight).max(), 1e-11)
    for what, column, gate in (("spin [rad/s]", 0, 0.02), ("orientation [rad]", 1, 0.02)):
        case.assert_below(f"error of {what}, step {steps[-1]:g}", errors[-1][column], gate)
        order = numpy.log2(errors[-2][column] / errors[-1][column])
        case.assert_close(f"order of {what}", 2.0, order, 0.02, "midpoint rule")
    case.table("errors", ["step [s]", "spin in body axes [rad/s]", "orientation [rad]"],
               [[f"{step:g}", *(f"{value:.2e}" for value in error)] for step, error in zip(steps, errors)]
               + [["order", *(f"{numpy.log2(errors[-2][column] / errors[-1][column]):.3f}" for column in (0, 1))]])
    small = {"run.end": 0.2}
    case.assert_same_on_ranks((1, 2, 3, 4), restarted=True, overrides=small)
    whole = case.run(overrides=small, name="whole")
    case.assert_same_after_restart(whole, 0.1, overrides=small)
    case.finish()


main()
