# SPDX-License-Identifier: Apache-2.0
"""Closed forms and integrals that the shells are compared with. Sources stand in README.md."""
import math

import numpy

CANTILEVER_ROOTS = (1.875104068711961, 4.694091132974175, 7.854757438237613)  # of cos b cosh b = -1


def cantilever_frequencies(young, density, length, thickness):
    """First three of bending [1/s], Euler and Bernoulli."""
    speed = thickness / math.sqrt(12) * math.sqrt(young / density)
    return [root**2 * speed / length**2 / (2 * math.pi) for root in CANTILEVER_ROOTS]


def plate_frequencies(young, poisson, density, side, thickness, modes):
    """Of a square plate simply supported on all sides [1/s], Kirchhoff; modes: half waves (m, n)."""
    speed = thickness * math.sqrt(young / (12 * density * (1 - poisson**2)))
    return [math.pi / 2 * (m * m + n * n) * speed / side**2 for m, n in modes]


def plate_deflection(young, poisson, side, thickness, pressure):
    """In the middle of a square plate simply supported on all sides under even pressure, by Navier's double sine series."""
    stiffness = young * thickness**3 / (12 * (1 - poisson**2))
    odd = numpy.arange(1, 400, 2)
    m, n = numpy.meshgrid(odd, odd)
    signs = (-1.0)**((m + n) / 2 - 1)
    return 16 * pressure * side**4 / (math.pi**6 * stiffness) * float((signs / (m * n * (m * m + n * n)**2)).sum())


def elastica(alpha):
    """Tip of a cantilever under a dead end load across it, alpha = P L^2 / (E I), without shear and stretch (Bisshopp and Drucker 1945):
    deflection / L and shortening / L. The slope t over the arc length s obeys t'^2 = 2 alpha (sin t_end - sin t); with
    sin t = sin t_end sin^2 q the integrals over q have no singular end."""
    nodes, weights = numpy.polynomial.legendre.leggauss(400)
    q, weights = math.pi / 4 * (nodes + 1), math.pi / 4 * weights  # amplitude from 0 (foot) to pi/2 (end)

    def integrals(end):
        top = math.sin(end)
        sine = top * numpy.sin(q)**2
        # ds = dt / sqrt(2 alpha (top - sine)), cos t dt = 2 top sin q cos q dq, top - sine = top cos^2 q
        step = 2 * top * numpy.sin(q) / numpy.sqrt(1 - sine**2) / math.sqrt(2 * alpha * top) * weights
        return step.sum(), (sine * step).sum(), (numpy.sqrt(1 - sine**2) * step).sum()

    low, high = 1e-6, math.pi / 2 - 1e-9
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if integrals(middle)[0] < 1 else (low, middle)
    _, deflection, reach = integrals(low)
    return deflection, 1 - reach


def twisted_deflection(young, length, width, thickness, load, along_width):
    """Tip of a strip that is twisted by 90 degrees, in the direction of the load: by beam theory, from the bending moments about the two
    axes of each cross-section. along_width: the load acts along the width of the tip."""
    s, weights = numpy.polynomial.legendre.leggauss(40)
    s, weights = 0.5 * length * (s + 1), 0.5 * length * weights  # distance from the tip
    angle = 0.5 * math.pi * s / length
    edge, flat = (numpy.cos(angle), numpy.sin(angle)) if along_width else (numpy.sin(angle), numpy.cos(angle))
    stiff, soft = thickness * width**3 / 12, width * thickness**3 / 12
    return load / young * float((s**2 * (edge**2 / stiff + flat**2 / soft) * weights).sum())


def limit_load(steps=20000):
    """p R^2 / M_p of a circular plate simply supported at its rim under even pressure, yield condition of Mises (Hopkins and Wang 1954):
    (r M_r)' = M_t - p r^2 / 2 with M_r^2 - M_r M_t + M_t^2 = M_p^2, M_r = M_p in the middle and 0 at the rim."""
    def slope(r, m):  # of m = M_r, with R = M_p = 1 and r scaled so that p = 2
        around = 0.5 * m + math.sqrt(max(0.0, 1 - 0.75 * m * m))
        return (around - m) / r - r if r > 0 else 0.0

    r, m, h = 0.0, 1.0, 4.0 / steps
    while True:  # Heun's method of the second order; near r = 0 M_r = 1 - O(r^2)
        first = slope(r, m)
        second = slope(r + h, m + h * first)
        new = m + 0.5 * h * (first + second)
        if new <= 0:
            rim = r + h * m / (m - new)
            return 2 * rim * rim
        r, m = r + h, new


def gauss(points):
    """Places and weights on -1..1."""
    return numpy.polynomial.legendre.leggauss(points)


def lobatto(points):
    """Likewise with points at both ends: zeros of the derivative of Legendre's polynomial P between them, weights 2 / (n (n-1) P^2)."""
    legendre = numpy.polynomial.legendre.Legendre.basis(points - 1)
    places = numpy.concatenate([[-1], numpy.sort(legendre.deriv().roots().real), [1]])
    return places, 2 / (points * (points - 1) * legendre(places)**2)


def strip_moment(curvature, young, limit, thickness, rule=None):
    """Moment on the unit of width of a strip of elastic, perfectly plastic material in pure bending under uniaxial stress; with a rule
    (places and weights on -1..1) what these points through the thickness make of it."""
    yielding = 2 * limit / (young * thickness)
    if rule is None:
        full = limit * thickness**2 / 4
        return young * thickness**3 / 12 * curvature if curvature < yielding else full * (1 - (yielding / curvature)**2 / 3)
    z, weights = 0.5 * thickness * rule[0], 0.5 * thickness * rule[1]
    return float((numpy.clip(young * curvature * z, -limit, limit) * z * weights).sum())


def cantilever_mode(root):
    """Shape over x / L of a clamped and free Euler-Bernoulli beam, 1 at the end."""
    ratio = (math.cosh(root) + math.cos(root)) / (math.sinh(root) + math.sin(root))

    def shape(x):
        return numpy.cosh(root * x) - numpy.cos(root * x) - ratio * (numpy.sinh(root * x) - numpy.sin(root * x))
    return lambda x: shape(x) / shape(1.0)
