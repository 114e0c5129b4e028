#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Two half cylinders pressed together and driven sideways: tractions of mortar contact against Hertz, converged values, Cattaneo."""
import glob
import math
import os
import sys

import h5py
import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../support"), HERE]
import mesh  # noqa: E402
from case_check import Case  # noqa: E402

DEPTH, SINK = 0.1, 1e-4  # of the slab; overlap of whole cylinders, whose travel is prescribed from there
# P: greatest pressure and half width, converged, from a two-dimensional prototype of our own (neo-Hooke, plane strain)
CONVERGED = {10: (9.505, 0.671), 1: (2.977, 0.2132)}
PRESSURE = ["P", "facets", "multipliers", "p0", "error", "a", "error", "L2 error against Hertz", "largest error within 0.97 a", "unknowns",
            "iterations", "loop [s]"]
FITTED = 0.9  # share of the contact zone over which the pressure is fitted


def hertz(scene, load):
    """Half width and greatest pressure of two equal cylinders under the load per length."""
    law = scene["materials"]["rubber"]
    modulus = law["young"] / (2 * (1 - law["poisson"] ** 2))
    radius = mesh.RADIUS / 2
    return math.sqrt(4 * load * radius / (math.pi * modulus)), math.sqrt(load * modulus / (math.pi * radius))


class Profile:
    """Pressures of the slave nodes (upper body, plane y = 0) at their current places x, and the lengths that they stand for."""

    def __init__(self, result):
        with h5py.File(os.path.join(result.folder, "state.h5"), "r") as file:
            nodal = file[max(name for name in file if name.startswith("record_"))]["node"]
            start, self.move = file["mesh/coordinates"][...], nodal["displacement"][...].reshape(-1, 3)
            corners = file["mesh/connectivity"][...][file["mesh/element_block"][...].ravel() == 1]
            place, pressure = start + self.move, nodal["contact_pressure"][...].ravel()
        self.upper = numpy.unique(corners)
        above = start[self.upper] - [0, 0, start[self.upper, 2].min()]
        on_arc = abs(numpy.hypot(above[:, 0], above[:, 2] - mesh.RADIUS) - mesh.RADIUS) < 1e-6
        nodes = self.upper[on_arc & (above[:, 1] < 1e-9)]
        self.nodes = nodes = nodes[numpy.argsort(start[nodes, 0])]
        self.x, self.z, self.pressure = place[nodes, 0], place[nodes, 2], pressure[nodes]
        sides = numpy.hypot(numpy.diff(self.x), numpy.diff(self.z))
        self.length = numpy.append(sides / 2, 0) + numpy.insert(sides / 2, 0, 0)

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


def mesh_of(case, load, facets, whole=False):
    """The mesh whose facets are Hertz's half width over `facets`."""
    half_width = hertz(case.scene(), load)[0]
    path = os.path.join(case.work, f"cylinders_{load:g}_{facets}{'_whole' if whole else ''}.inp")
    os.makedirs(case.work, exist_ok=True)
    facet = half_width / facets
    sink = SINK if whole else mesh.sink_for(facet)
    mesh.write(path, facet, DEPTH, sink, zone=1.47 * half_width, whole=whole)
    return path


def press(case, load, facets, multiplier):
    path = mesh_of(case, load, facets)
    overrides = {"mesh.0.file": path, "traction.0.value": [0, 0, -load / (2 * mesh.RADIUS)], "contact.0.multiplier": multiplier}
    result = case.run(overrides=overrides, name=f"load_{load:g}_{facets}_{multiplier}")
    return result, Profile(result)


def line(case, load, facets, multiplier, result, profile):
    """Adds a row to the table of pressures."""
    p0, a = profile.fit()
    exact = hertz(case.scene(), load)
    rim = profile.pressure / (exact[1] * numpy.sqrt(numpy.maximum(1e-9, 1 - (profile.x / exact[0]) ** 2)))
    inside = profile.x < 0.97 * exact[0]
    implicit = result.summary["implicit"]
    (converged, half_width), loop = CONVERGED[load], result.summary["loop_s"]
    case.row("pressure", PRESSURE, [f"{load:g}", f"a/{facets}", multiplier, f"{p0:.4f}", f"{100 * abs(p0 / converged - 1):.2f} %", f"{a:.4f}",
                                    f"{100 * abs(a / half_width - 1):.1f} %", f"{profile.distance(*exact):.3f}",
                                    f"{100 * abs(rim[inside] - 1).max():.1f} %", implicit["unknowns"], implicit["iterations"], loop])
    case.row("residuals", ["P", "facets", "multipliers", "residuals of the last step over the first one"],
             [f"{load:g}", f"a/{facets}", multiplier, ", ".join(f"{r / implicit['residuals_last'][0]:.1e}" for r in implicit["residuals_last"])])


def check_normal(case, load, facets, gates):
    """Dual multipliers; the row of the table, the rise of the pressure at the rim."""
    result, profile = press(case, load, facets, "dual")
    p0, a = profile.fit()
    (converged, half_width), theory = CONVERGED[load], hertz(case.scene(), load)
    label = f"P = {load:g}, a/{facets}"
    case.assert_close(f"{label}: greatest pressure (Hertz {theory[1]:.4f})", converged, p0, gates[0], "converged prototype")
    case.assert_close(f"{label}: half width (Hertz {theory[0]:.4f})", half_width, a, gates[1], "converged prototype")
    case.assert_close(f"{label}: sum of pressures", load / 2, profile.vertical(), 1e-6, "equilibrium")
    rises = numpy.diff(profile.pressure)
    case.assert_below(f"{label}: greatest rise of the pressure outwards / p0", max(rises.max(), 0) / p0, 1e-3, "monotone")
    case.assert_energy(result, energy_gate=1e-8)
    line(case, load, facets, "dual", result, profile)


def forces_of_nodes(result, profile):
    """Forces of contact on the nodes of state.h5: normal and tangential together, from the last checkpoint.

    A checkpoint has its own order of nodes; displacements tell which is which (both nodes of a pair across the slab move alike).
    """
    path = max(glob.glob(os.path.join(result.folder, "checkpoint_*.h5")))
    with h5py.File(path, "r") as file:
        moves = file["nodes/displacement"][...].reshape(-1, 3)
        force, friction = (file[f"nodes/{name}_force"][...].reshape(-1, 3) for name in ("contact", "friction"))
    place = {move[[0, 2]].tobytes(): i for i, move in enumerate(moves)}
    order = [place[move[[0, 2]].tobytes()] for move in profile.move]
    return force[order], friction[order]


class Sheared:
    """Tangential tractions of the slave nodes, the resultants, and the stick zone."""

    def __init__(self, result, scene):
        self.friction = scene["contact"][0]["friction"]
        self.profile = profile = Profile(result)
        force, friction = forces_of_nodes(result, profile)
        self.normal, self.tangential = force[profile.upper, 2].sum() / DEPTH, -force[profile.upper, 0].sum() / DEPTH
        self.pressed = profile.pressure > 0
        self.traction = -2 * friction[profile.nodes, 0] / DEPTH / profile.length
        weight = profile.pressure * profile.length
        self.x = profile.x - (profile.x * weight).sum() / weight.sum()  # from the middle of the zone
        self.ratio = numpy.where(self.pressed, self.traction / (self.friction * numpy.where(self.pressed, profile.pressure, 1)), 0)

    def stick_half_width(self, half_width):
        """Root mean square of the half widths that the sticking nodes give: (1 - q/(mu p))^2 (a^2 - x^2) = c^2 - x^2."""
        sticks = self.pressed & (self.ratio < 0.99)
        x, ratio = self.x[sticks], self.ratio[sticks]
        return math.sqrt((x ** 2 + (1 - ratio) ** 2 * (half_width ** 2 - x ** 2)).mean())

    def between_nodes(self):
        """Half width at which q/(mu p) reaches 1, mean of both sides, linear between the last sticking node and the next."""
        found = []
        for side in (1, -1):
            x, ratio = side * self.x[::side], self.ratio[::side]
            last = numpy.flatnonzero((ratio < 0.99) & (x > 0) & self.pressed[::side])[-1]
            found.append((x[last] + x[last + 1]) / 2)
        return sum(found) / 2


def cattaneo(friction, load, shear, half_width, x):
    """Stick half width and shear traction at x: half planes, Q after P (Johnson, Contact Mechanics, 7.2)."""
    greatest = 2 * load / (math.pi * half_width)
    stick = half_width * math.sqrt(1 - shear / (friction * load))
    outer, inner = (numpy.sqrt(numpy.maximum(0, 1 - (x / b) ** 2)) for b in (half_width, stick))
    return stick, friction * greatest * (outer - stick / half_width * inner)


def check_friction(case, facets):
    scene = case.scene("friction.yaml")
    path = mesh_of(case, 10, facets, whole=True)
    result = case.run("friction.yaml", {"mesh.0.file": path}, name=f"friction_{facets}")
    sheared = Sheared(result, scene)
    half_width = hertz(case.scene(), sheared.normal)[0]
    stick, exact = cattaneo(sheared.friction, sheared.normal, sheared.tangential, half_width, sheared.x)
    label = f"friction, a/{facets}"
    off = math.sqrt((sheared.profile.length * (sheared.traction - exact) ** 2).sum() / (sheared.profile.length * exact ** 2).sum())
    case.table("friction", ["facets", "P", "Q", "half width of contact", "of sticking, reference", "computed",
                            "L2 error of the shear traction", "unknowns", "loop [s]"],
               [[f"a/{facets}", f"{sheared.normal:.4f}", f"{sheared.tangential:.4f}", f"{half_width:.4f}", f"{stick:.4f}",
                 f"{sheared.stick_half_width(half_width):.4f}", f"{off:.3f}", result.summary["implicit"]["unknowns"],
                 result.summary["loop_s"]]])
    case.assert_close(f"{label}: normal force", 10, sheared.normal, 0.01, "travel of the scene, chosen for it")
    case.assert_close(f"{label}: tangential force", 0.936, sheared.tangential, 0.01, "likewise")
    case.assert_close(f"{label}: half width of the stick zone", stick, sheared.stick_half_width(half_width), 0.05, "Cattaneo, Mindlin")
    cusp = sheared.friction * 2 * sheared.normal / (math.pi * half_width) * math.sqrt(1 - (stick / half_width) ** 2)
    case.assert_close(f"{label}: greatest shear traction", cusp, sheared.traction.max(), 0.05, "Cattaneo, Mindlin, at x = c")
    case.assert_close(f"{label}: Coulomb's bound, q/(mu p)", 1, sheared.ratio.max(), 2e-3, "friction law; lengths are of chords")
    return sheared


def main():
    case = Case(__file__)
    check_normal(case, 10, 11, (0.01, 0.02))
    if case.long:
        for load, facets, gates in ((10, 22, (0.005, 0.02)), (1, 11, (0.01, 0.02)), (1, 22, (0.005, 0.02))):
            check_normal(case, load, facets, gates)
        line(case, 10, 11, "standard", *press(case, 10, 11, "standard"))
        check_friction(case, 11)
        case.assert_same_on_ranks((1, 3))
    case.finish()


if __name__ == "__main__":
    main()
