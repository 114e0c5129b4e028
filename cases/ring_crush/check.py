#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A rubber ring crushed flat between two walls: stiffness of the ring, and self-contact that nothing passes."""
import math
import os
import sys

import h5py
import numpy
from scipy.spatial import cKDTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

BEFORE_TOUCH = 34.0  # the inner surfaces meet at 34.2 ms
GENTLE = {"curves.press": [[0, 0], [10, 0.01], [40, 0.01]], "run.end": 30, "contact": None, "output.every": 30,
          "mesh.0.tube.elements": [4, 240, 1]}


def ring_stiffness(scene):
    """Force per shortening of the loaded diameter: curved beam with hoop and shear strain, plane strain (see README)."""
    tube, law = scene["mesh"]["tube"], scene["materials"]["rubber"]
    thickness = tube["outer_radius"] - tube["inner_radius"]
    radius = (tube["outer_radius"] + tube["inner_radius"]) / 2
    modulus = law["young"] / (1 - law["poisson"]**2)
    hoop = thickness**2 / (12 * radius**2)
    shear = 1.2 * 2 / (1 - law["poisson"]) * hoop
    shape = math.pi / 4 * (1 - hoop + shear) - 2 / math.pi * (1 - hoop)**2
    return modulus * tube["length"] * thickness**3 / 12 / radius**3 / shape


def measured_stiffness(result):
    """From the wall's impulse while it moves evenly: a parabola in the shortening, whose second derivative counts."""
    time, impulse = result.history["time"], numpy.abs(result.history["impulse_below.y"])
    rate, shortening = 0.02, 0.1 + 0.02 * (time - 10)
    early = (shortening > 0.1) & (shortening < 0.5)
    return 2 * rate * numpy.polyfit(shortening[early], impulse[early], 2)[0]


class Ring:
    """The section z = 0 of all records: times, points [nodes][2], quadrilaterals, nodes of the inner surface."""

    def __init__(self, result, inner_radius):
        with h5py.File(os.path.join(result.folder, "state.h5"), "r") as file:
            reference = file["mesh/coordinates"][...]
            stored = file["mesh/connectivity"][...]
            hexes = stored.reshape(-1, 9)[:, 1:] if stored.ndim == 1 else stored
            records = [group for name, group in sorted(file.items()) if name.startswith("record_")]
            self.times = [float(group.attrs["time"]) for group in records]
            self.moves = [group["node/displacement"][...] for group in records]
        self.reference = reference
        flat = reference[:, 2] < 1e-9
        self.quads = numpy.array([_around(reference, [n for n in element if flat[n]]) for element in hexes])
        self.inner = numpy.flatnonzero(flat & (numpy.hypot(reference[:, 0], reference[:, 1]) < inner_radius * 1.001))

    def deepest(self, record):
        """How far each inner node is inside elements that are not its own; 0 outside."""
        points = (self.reference + self.moves[record])[:, :2]
        corners = points[self.quads]
        edges = numpy.roll(corners, -1, axis=1) - corners
        depth = []
        for node in self.inner:
            to = points[node] - corners
            distance = (edges[..., 0] * to[..., 1] - edges[..., 1] * to[..., 0]) / numpy.hypot(edges[..., 0], edges[..., 1])
            inside = distance.min(axis=1)
            inside[(self.quads == node).any(axis=1)] = 0
            depth.append(max(0.0, float(inside.max())))
        return numpy.array(depth)

    def asymmetry(self, record, axis):
        mirror = numpy.ones(3)
        mirror[axis] = -1
        partner = cKDTree(self.reference).query(self.reference * mirror)[1]
        return float(numpy.abs(self.moves[record] - self.moves[record][partner] * mirror).max())

    def crossings(self, record):
        """Pairs of edges of the inner surface that cross."""
        angle = numpy.arctan2(self.reference[self.inner, 1], self.reference[self.inner, 0])
        loop = (self.reference + self.moves[record])[self.inner[numpy.argsort(angle)], :2]
        a, b = loop, numpy.roll(loop, -1, axis=0)
        side = numpy.sign(_turn(a[:, None], b[:, None], a[None])) * numpy.sign(_turn(a[:, None], b[:, None], b[None]))
        return int(numpy.count_nonzero((side < 0) & (side.T < 0)) // 2)


def _turn(a, b, c):
    return (b - a)[..., 0] * (c - a)[..., 1] - (b - a)[..., 1] * (c - a)[..., 0]


def _around(points, nodes):
    """The nodes in mathematical order around their centre."""
    offset = points[nodes][:, :2] - points[nodes][:, :2].mean(axis=0)
    return [nodes[k] for k in numpy.argsort(numpy.arctan2(offset[:, 1], offset[:, 0]))]


def text_of(result):
    with open(os.path.join(result.folder, "history.csv"), encoding="utf-8") as stream:
        return stream.read()


def check_crush(case, scene, elements, ours):
    tube = scene["mesh"]["tube"]
    layer = (tube["outer_radius"] - tube["inner_radius"]) / elements[0]
    ring = Ring(ours, tube["inner_radius"])
    depths = [ring.deepest(record) for record in range(len(ring.times))]
    case.assert_equal("inner nodes behind the opposite surface, all records", 0,
                      sum(int((depth > layer / 2).sum()) for depth in depths), "E6: none passes")
    case.assert_below("greatest depth of an inner node / element", max(depth.max() for depth in depths) / layer, 0.05, "none")
    # walls count among the active contacts: some forty nodes before the touch
    case.assert_within("contacts active at the end / before touch", 3, math.inf,
                       ours.last("active_contacts") / ours.at("active_contacts", BEFORE_TOUCH), "the ring is flat")
    case.assert_below("crossings of the inner surface with itself before touch",
                      sum(ring.crossings(k) for k in range(len(ring.times)) if ring.times[k] < BEFORE_TOUCH), 0.5, "none")
    before = max(k for k, time in enumerate(ring.times) if time < BEFORE_TOUCH)
    case.assert_below("left-right asymmetry before touch / thickness", ring.asymmetry(before, 0), 1e-6, "symmetry")
    case.assert_below("up-down asymmetry before touch / thickness", ring.asymmetry(before, 1), 1e-2, "symmetry")
    work = -ours.last("walls")
    case.assert_within("energy taken by contact / work of the walls", -1e-3, 1e-2, ours.last("contact") / work, "no energy made")
    case.assert_energy(ours, energy_gate=1e-10, momentum_gate=1e-10)
    case.row("rings", ["elements", "greatest depth of an inner node / element", "energy taken by contact / work of the walls",
                       "left-right asymmetry at the end [mm]", "up-down [mm]", "steps", "loop [s]"],
             [f"{elements[0]} x {elements[1]}", f"{max(depth.max() for depth in depths) / layer:.0e}", f"{ours.last('contact') / work:.1e}",
              f"{ring.asymmetry(-1, 0):.0e}", f"{ring.asymmetry(-1, 1):.0e}", ours.summary["steps"], ours.summary["loop_s"]])


def elastica_force(tube, law, half):
    """Of a thin inextensible ring between plates, flat where it touches them, at half the distance of its middle lines (see README)."""
    thickness = tube["outer_radius"] - tube["inner_radius"]
    bending = law["young"] / (1 - law["poisson"]**2) * tube["length"] * thickness**3 / 12
    root_of_sine = math.sqrt(math.pi) * math.gamma(0.75) / (2 * math.gamma(1.25))  # integral over a quarter circle
    return bending * (root_of_sine / half)**2


def check_static(case):
    """Mortar contact of the ring with itself."""
    ours, scene = case.run("static.yaml", name="static"), case.scene("static.yaml")
    tube, law = scene["mesh"]["tube"], scene["materials"]["rubber"]
    for time in (0.42, 0.54, 0.66, 0.78):
        half = (tube["inner_radius"] + tube["outer_radius"]) / 2 - scene["curves"]["press"][0][1] * time
        case.assert_close(f"static: force at h = {half:.2f} mm [N]", elastica_force(tube, law, half), ours.at("below.y", time), 0.04, "elastica")
    other = case.run("static.yaml", ranks=4, name="static_np4")
    case.assert_same_state("static: state on 4 ranks", ours, other)
    case.assert_close("static: force of the upper wall at the end", ours.last("below.y"), -ours.last("above.y"), 1e-8, "equilibrium")
    case.assert_below("static: energy given by contact / of the ring", abs(ours.last("contact") / ours.last("internal")), 1e-3, "none without friction")
    case.assert_below("static: deepest point / element", ours.summary["deepest_penetration"]["elements"], 0.01, "positions")
    for time, distance in ((1, 3.0), (2, 1.76)):
        case.row("static", ["time", "distance of the walls [mm]", "force [N]", "of the halves on each other [N]"],
                 [time, distance, f"{ours.at('below.y', time):.3f}", f"{ours.at('self.normal', time):.3f}"])


def main():
    case = Case(__file__)
    scene = case.scene()
    gentle = case.run(overrides=GENTLE, name="gentle")
    case.assert_close("stiffness of the ring [N/mm]", ring_stiffness(scene), measured_stiffness(gentle), 0.02,
                      "curved beam, Roark")
    ours = case.run(name="np1")
    check_crush(case, scene, scene["mesh"]["tube"]["elements"], ours)
    ranks = 4 if case.long else 2
    other = case.run(ranks=ranks, name=f"np{ranks}")
    case.assert_equal(f"history.csv (force curve) on {ranks} ranks, byte for byte", True, text_of(ours) == text_of(other), "1 rank")
    case.assert_same_state(f"state on {ranks} ranks", ours, other)
    if case.long:
        check_static(case)
        fine = [4, 480, 1]
        check_crush(case, scene, fine, case.run(overrides={"mesh.0.tube.elements": fine}, name="fine"))
    case.finish()


if __name__ == "__main__":
    main()
