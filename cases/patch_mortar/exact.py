# SPDX-License-Identifier: Apache-2.0
"""Uniform states of compressible neo-Hookean blocks, psi = mu/2 (I1 - 3) - mu ln J + lambda/2 ln^2 J, in closed form.

Stresses are Cauchy's, as xx, yy, zz, xy, yz, zx.
"""
import math

import numpy


def lame(law):
    young, nu = law["young"], law["poisson"]
    return young / (2 * (1 + nu)), young * nu / ((1 + nu) * (1 - 2 * nu))


def root(function, low, high):
    """Bisection to the last bit; function(low) and function(high) differ in sign."""
    below = function(low) < 0
    while True:
        middle = 0.5 * (low + high)
        if middle in (low, high):
            return middle
        low, high = (middle, high) if (function(middle) < 0) == below else (low, middle)


def stress(law, gradient):
    mu, lam = lame(law)
    j = numpy.linalg.det(gradient)
    s = (mu * (gradient @ gradient.T - numpy.eye(3)) + lam * math.log(j) * numpy.eye(3)) / j
    return numpy.array([s[0, 0], s[1, 1], s[2, 2], s[0, 1], s[1, 2], s[2, 0]])


def nominal(law, gradient):
    """First Piola-Kirchhoff stress: traction per area of the start = nominal @ normal of the start."""
    mu, lam = lame(law)
    inverse = numpy.linalg.inv(gradient).T
    return mu * (gradient - inverse) + lam * math.log(numpy.linalg.det(gradient)) * inverse


def sheared(stretch, shear):
    """Deformation gradient of a stretch along z and a shear du_x/dZ."""
    return numpy.array([[1, 0, shear], [0, 1, 0], [0, 0, stretch]])


def normal_stress(law, stretch):
    """zz of a block whose sides are held."""
    return stress(law, sheared(stretch, 0))[2]


def stretch_under(law, traction):
    """Of a block whose sides are held."""
    return root(lambda l: normal_stress(law, l) - traction, 0.3, 2)


def pressed_stretches(laws, height, travel):
    """Of two blocks of this height whose outer faces come nearer by `travel`, sides held."""
    def unbalanced(lower):
        return normal_stress(laws[0], lower) - normal_stress(laws[1], 2 - travel / height - lower)
    lower = root(unbalanced, 1 - 0.9 * max(travel, -travel) / height, 1 + 0.9 * max(travel, -travel) / height)
    return lower, 2 - travel / height - lower


def free_side(law, stretch):
    """Stretch along x without stress, at a stretch along z, none along y."""
    mu, lam = lame(law)
    return root(lambda b: mu * (b * b - 1) + lam * math.log(b * stretch), 0.5, 2)
