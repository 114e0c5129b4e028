# SPDX-License-Identifier: Apache-2.0
"""Exact plane shocks in materials on the Hugoniot U = c + s u, and profiles of a column read from a result."""
import os

import h5py
import numpy


class Metal:
    """Of the scene's own constants. Energy is counted by reference volume, h = 1 - J is the compression."""

    def __init__(self, law):
        eos = law["eos"]
        self.density, self.c, self.s, self.gamma = law["density"], eos["c"], eos["s"], eos["gamma"]

    def shock_speed(self, u):
        return self.c + self.s * u

    def pressure(self, u):
        return self.density * self.shock_speed(u) * u

    def energy(self, u):
        return self.density * u**2 / 2

    def volume(self, u):
        return 1 - u / self.shock_speed(u)

    def cold(self, J):
        """p = cold(J) + gamma e."""
        h = 1 - J
        squeeze = numpy.maximum(h, 0)
        return self.density * self.c**2 * h / (1 - self.s * squeeze)**2 * (1 - self.gamma * squeeze / 2)

    def release_speed(self, u):
        """Of the head of a release behind a shock, by reference length: rho w^2 = -dp/dJ = -cold' + gamma p."""
        J, step = self.volume(u), 1e-6
        slope = (self.cold(J + step) - self.cold(J - step)) / (2 * step)
        return numpy.sqrt((self.gamma * self.pressure(u) - slope) / self.density)

    def isentrope(self, J):
        """Pressure and energy at constant entropy from J = 1: de/dJ + gamma e = -cold, by Gauss quadrature."""
        points, weights = numpy.polynomial.legendre.leggauss(60)
        at = 1 + (J - 1) * (points + 1) / 2
        energy = -(J - 1) / 2 * numpy.sum(weights * self.cold(at) * numpy.exp(self.gamma * (at - J)))
        return self.cold(J) + self.gamma * energy, energy


def match(flyer, target, speed):
    """Particle velocity and pressure at the interface: rho1 (c1 + s1 (v - u)) (v - u) = rho2 (c2 + s2 u) u."""
    square = flyer.density * flyer.s - target.density * target.s
    linear = -flyer.density * (flyer.c + 2 * flyer.s * speed) - target.density * target.c
    constant = flyer.density * (flyer.c + flyer.s * speed) * speed
    u = 2 * constant / (-linear + numpy.sqrt(linear**2 - 4 * square * constant))
    return u, target.pressure(u)


class PlasticShock:
    """Two fronts in an ideally plastic metal, [elastic, plastic]: axial stress, particle velocity, front speed."""

    def __init__(self, law, u):
        metal, shear, limit = Metal(law), law["shear"], law["A"]
        third = 2 * limit / 3
        first = numpy.exp(-limit / (2 * shear))  # the deviator follows the logarithmic strain
        # e = (p + third) h / 2 and p = cold + gamma e
        energy = (metal.cold(first) + third) * (1 - first) / 2 / (1 - metal.gamma * (1 - first) / 2)
        precursor = metal.cold(first) + metal.gamma * energy + third
        slow = numpy.sqrt(precursor * (1 - first) / metal.density)
        jump = u - slow

        def behind(volume):
            front = jump / (first - volume)
            stress = precursor + metal.density * front * jump
            end = energy + (precursor + stress) * (first - volume) / 2
            return front, stress, end, metal.cold(volume) + metal.gamma * end + third - stress

        # bisection: the residual is negative near `first`, where the front would be infinitely fast
        low, high = first * (1 - 4 * u / metal.c), first * (1 - 1e-6)
        for _ in range(200):
            middle = (low + high) / 2
            low, high = (middle, high) if behind(middle)[3] > 0 else (low, middle)
        front, stress, self.energy, _ = behind(low)
        self.volume, self.pressure = low, stress - third
        self.stress, self.u, self.front = (precursor, stress), (slow, u), (slow / (1 - first), front)
        self.strain = -2 / 3 * numpy.log(low) - limit / (3 * shear)
        work = third * (first - low)
        self.start = law["temperature"]
        self.heating = law["taylor_quinney"] * work / (metal.density * law["heat_capacity"])


class Column:
    """A record of a column along x: element fields by the reference place of the middle, nodal ones by layers."""

    def __init__(self, result, record):
        with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
            names = sorted(key for key in state if key.startswith("record"))
            group = state[names[record]]
            self.time = float(group.attrs["time"])
            start, corners = state["mesh/coordinates"][:, 0], state["mesh/connectivity"][:]
            ends = start[corners]
            order = numpy.argsort(ends.mean(axis=1), kind="stable")
            self.low, self.high = ends.min(axis=1)[order], ends.max(axis=1)[order]
            self.x = (self.low + self.high) / 2
            self.alive = numpy.ones(len(order), bool)
            for name, values in group["element"].items():
                setattr(self, name, values[:][order])
            self.alive = numpy.asarray(self.alive, bool)
            displacement = group["node/displacement"][:, 0]
            self.now = (start + displacement)[corners].mean(axis=1)[order]
            self.nodal = {name: values[:] for name, values in group["node"].items()}
            self.start = start
            if "velocity" in self.nodal:
                self.velocity = self.nodal["velocity"][:, 0][corners].mean(axis=1)[order]
        self.pressure = -self.stress[:, :3].mean(axis=1)
        self.axial = -self.stress[:, 0]

    def between(self, low, high):
        return (self.x > low) & (self.x < high)

    def share(self, low, high):
        """Of each element that lies between two reference places."""
        return numpy.clip((numpy.minimum(self.high, high) - numpy.maximum(self.low, low)) / (self.high - self.low), 0, 1)

    def crossing(self, values, level, from_right):
        """The outermost reference place where values pass the level, linear between the middles of elements."""
        above = numpy.flatnonzero(values >= level)
        i = above[-1] if from_right else above[0]
        j = i + 1 if from_right else i - 1
        share = (values[i] - level) / (values[i] - values[j])
        return self.x[i] + share * (self.x[j] - self.x[i])


def records(result):
    with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
        return sum(key.startswith("record") for key in state)
