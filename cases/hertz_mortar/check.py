#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Two half cylinders pressed together: pressures of mortar contact against Hertz and against converged values."""
import math
import os
import sys

import h5py
import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../support"), HERE]
import mesh  # noqa: E402
from case_check import Case  # noqa: E402

DEPTH, SINK = 0.1, 1e-4
# P: greatest pressure and half width, converged, from a two-dimensional prototype of our own (neo-Hooke, plane strain)
CONVERGED = {10: (9.505, 0.671), 1: (2.977, 0.2132)}
FITTED = 0.9  # share of the contact zone over which the pressure is fitted


def hertz(scene, load):
    """Half width and greatest pressure of two equal cylinders under the load per length."""
    law = scene["materials"]["rubber"]
    modulus = law["young"] / (2 * (1 - law["poisson"] ** 2))
    radius = mesh.RADIUS / 2
    return math.sqrt(4 * load * radius / (math.pi * modulus)), math.sqrt(load * modulus / (math.pi * radius))


class Profile:
    """Pressures of the slave nodes (upper body, plane y = 0) over their current places x; tangential tractions with friction."""

    def __init__(self, result, record=-1):
        with h5py.File(os.path.join(result.folder, "state.h5"), "r") as file:
            records = sorted(name for name in file if name.startswith("record_"))
            nodal = file[records[record]]["node"]
            start = file["mesh/coordinates"][...]
            corners = file["mesh/connectivity"][...][file["mesh/element_block"][...].ravel() == 1]
            place = start + nodal["displacement"][...].reshape(-1, 3)
            pressure = nodal["contact_pressure"][...].ravel()
        upper = numpy.unique(corners)
        above = start[upper] + [0, 0, SINK]
        on_arc = abs(numpy.hypot(above[:, 0], above[:, 2] - mesh.RADIUS) - mesh.RADIUS) < 1e-6
        nodes = upper[on_arc & (above[:, 1] < 1e-9)]
        nodes = nodes[numpy.argsort(start[nodes, 0])]
        self.x, self.z, self.pressure = place[nodes, 0], place[nodes, 2], pressure[nodes]
        sides = numpy.hypot(numpy.diff(self.x), numpy.diff(self.z))
        self.length = numpy.concatenate([[0], sides / 2]) + numpy.concatenate([sides / 2, [0]])

    def fit(self):
        """Greatest pressure and half width of p^2 = p0^2 (1 - x^2/a^2), by lengths, over the inner part of the zone."""
        edge = abs(self.x[self.pressure > 0]).max()
        inner = abs(self.x) < FITTED * edge
        root = numpy.sqrt(self.length[inner])
        matrix = numpy.stack([numpy.ones(inner.sum()), self.x[inner] ** 2], 1) * root[:, None]
        c0, c1 = numpy.linalg.lstsq(matrix, self.pressure[inner] ** 2 * root, rcond=None)[0]
        return math.sqrt(c0), math.sqrt(-c0 / c1)

    def vertical(self):
        """Sum of pressures times lengths along z: of the half model."""
        dx, dz = numpy.diff(self.x), numpy.diff(self.z)
        nx, nz = numpy.append(-dz, 0) + numpy.insert(-dz, 0, 0), numpy.append(dx, 0) + numpy.insert(dx, 0, 0)
        nx[0] = 0  # in the symmetry plane
        return (self.pressure * self.length * nz / numpy.hypot(nx, nz)).sum()

    def distance(self, half_width, greatest):
        """L2 norm of the difference from Hertz over that of Hertz, by nodes."""
        exact = greatest * numpy.sqrt(numpy.maximum(0, 1 - (self.x / half_width) ** 2))
        return math.sqrt((self.length * (self.pressure - exact) ** 2).sum() / (self.length * exact ** 2).sum())


def run(case, load, facets, multiplier="dual", name=None, **more):
    """A run with half width / facets as the facets' length, of Hertz's half width."""
    scene = case.scene()
    half_width = hertz(scene, load)[0]
    path = os.path.join(case.work, f"cylinders_{load:g}_{facets}.inp")
    os.makedirs(case.work, exist_ok=True)
    mesh.write(path, half_width / facets, DEPTH, SINK * load / 10, zone=1.47 * half_width)
    overrides = {"mesh.0.file": path, "traction.0.value": [0, 0, -load / (2 * mesh.RADIUS)],
                 "contact.0.multiplier": multiplier, **more}
    return case.run(overrides=overrides, name=name or f"load_{load:g}_{facets}_{multiplier}")


def check_normal(case, load, facets, gates):
    result = run(case, load, facets)
    profile, scene = Profile(result), case.scene()
    p0, a = profile.fit()
    converged, half_width = CONVERGED[load]
    label = f"P = {load:g}, a/{facets}"
    print(f"{label}: p0 {p0:.4f} a {a:.4f}, L2 {profile.distance(*hertz(scene, load)):.4f}, {result.summary['wall_s']:.2f} s, "
          f"iterations {result.summary['implicit']['iterations']}")
    case.assert_close(f"{label}: greatest pressure", converged, p0, gates[0], "converged prototype; Hertz %.4f" % hertz(scene, load)[1])
    case.assert_close(f"{label}: half width", half_width, a, gates[1], "converged prototype; Hertz %.4f" % hertz(scene, load)[0])
    case.assert_close(f"{label}: sum of pressures", load / 2, profile.vertical(), 1e-6, "equilibrium")
    rises = numpy.diff(profile.pressure)
    case.assert_below(f"{label}: greatest rise of the pressure outwards / p0", max(rises.max(), 0) / p0, 1e-3, "monotone")
    return profile


def main():
    case = Case(__file__)
    check_normal(case, 10, 11, (0.01, 0.02))
    if case.long:
        check_normal(case, 10, 22, (0.005, 0.02))
        check_normal(case, 1, 11, (0.01, 0.02))
        check_normal(case, 1, 22, (0.005, 0.02))
    case.finish()


if __name__ == "__main__":
    main()
