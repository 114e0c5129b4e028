#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A hard ball goes obliquely through a thin plate that erodes: balances, symmetry, debris, the same bits on any ranks."""
import os
import sys

import h5py
import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402


class Flight:
    """Ball, hole and debris of a result, beside the scene's own numbers [m, m/s, kg]."""

    def __init__(self, scene, result):
        ball, plate = scene["mesh"][0]["sphere"], scene["mesh"][1]["box"]
        self.result, self.radius, self.at = result, ball["radius"], numpy.array(ball["at"])
        self.thickness, self.edge = plate["size"][2], plate["size"][2] / plate["elements"][2]
        velocity = numpy.array(scene["initial"][0]["velocity"])
        self.impact = numpy.linalg.norm(velocity)
        density = {name: law["density"] for name, law in scene["materials"].items()}
        mass = 4 / 3 * numpy.pi * self.radius**3 * density["hard"]
        struck = numpy.pi * self.radius**2 * self.thickness * self.impact / abs(velocity[2]) * density["al"]
        self.carried = struck / (mass + struck)  # share of the speed that is lost if all the ball strikes moves on with it
        self.speed = numpy.hypot(result.history["ball.x"], result.history["ball.z"])
        self.lost = 1 - self.speed[-1] / self.impact
        with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
            self.start, self.corners = state["mesh/coordinates"][:], state["mesh/connectivity"][:]
            records = [state[key] for key in sorted(state) if key.startswith("record")]
            self.places = [self.start + record["node/displacement"][:] for record in records]
            self.velocity = records[-1]["node/velocity"][:]
            self.alive = records[-1]["element/alive"][:].ravel() > 0
            strain = records[-1]["element/plastic_strain"][:].ravel()
        self.ball = numpy.linalg.norm(self.start - self.at, axis=1) < self.radius * (1 + 1e-6)
        self.strain = strain[self.alive].max()

    def hole(self):
        """Length and width of the hole: of the elements that are gone from the middle layer, or the layer below it."""
        x = self.start[self.corners[~self.alive]]
        middle = x[:, :, 2].min(axis=1)
        layer = middle[numpy.argmin(abs(middle + self.edge / 2))]
        here = x[abs(middle - layer) < 1e-3 * self.edge].reshape(-1, 3)
        return numpy.ptp(here[:, 0]), numpy.ptp(here[:, 1])

    def inside(self):
        """How deep a node of the plate lies in the ball at any record, beyond what the facets' flatness allows."""
        bare = numpy.ones(len(self.start), dtype=bool)
        bare[self.ball] = False
        deep = -numpy.inf
        for place in self.places:
            centre = self.at + (place - self.start)[self.ball].mean(axis=0)
            deep = max(deep, self.radius - numpy.linalg.norm(place[bare] - centre, axis=1).min())
        return deep - self.sagitta()

    def sagitta(self):
        """Between the sphere and the middle of the largest facet."""
        inner = numpy.ones(len(self.start), dtype=bool)
        inner[numpy.abs(numpy.linalg.norm(self.start - self.at, axis=1) - self.radius) < 1e-6 * self.radius] = False
        deepest = 0
        for face in ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)):
            nodes = self.corners[:, face]
            facets = nodes[~inner[nodes].any(axis=1)]
            middles = self.start[facets].mean(axis=1) - self.at
            deepest = max([deepest, *(self.radius - numpy.linalg.norm(middles, axis=1))])
        return deepest

    def debris(self):
        """Velocities of the plate's nodes that fly more than a thickness below it, and how many whole elements do."""
        below = ~self.ball & (self.places[-1][:, 2] < -2 * self.thickness)
        return self.velocity[below], int((below[self.corners].all(axis=1) & self.alive).sum())

    def line(self, name):
        s, (length, width) = self.result.summary, self.hole()
        shares = [s["energy"][key] / s["energy"]["total"] for key in ("eroded", "internal", "contact", "friction")]
        return [*name, f"{100 * self.lost:.2f}", f"{1e3 * length:.1f} x {1e3 * width:.1f}", s["removed_elements"], f"{self.strain:.2f}",
                *(f"{100 * share:.1f}" for share in shares), s["folded_elements"], s["steps"], s["loop_s"]]


def overrides_of(scene, through):
    size = scene["mesh"][1]["box"]["size"]
    edge = size[2] / through
    return {"mesh.1.box.elements": [round(size[0] / edge), round(size[1] / edge), through]}


def fly(case, through, element="hex8_bbar"):
    overrides = {**overrides_of(case.scene(), through), "parts.plate.element": element}
    result = case.run(overrides=overrides, ranks=case.of_all(2, 1), name=f"{element}_{through}")
    flight = Flight(case.scene(overrides=overrides), result)
    case.row("flights", ["element", "through the plate", "speed lost [%]", "hole [mm]", "eroded elements", "largest plastic strain left",
                         "energy eroded [%]", "internal [%]", "contact [%]", "friction [%]", "folded elements", "steps", "loop [s]"],
             flight.line((element, through)))
    return flight


def check_flight(case, flight):
    result, history = flight.result, flight.result.history
    case.assert_energy(result, energy_gate=1e-10, momentum_gate=1e-10)
    case.assert_within("speed lost / lost if all that is struck is carried on", 0.5, 1.0, flight.lost / flight.carried,
                       "some is pushed aside")
    case.assert_below("velocity of the ball across its plane / impact", result.last("ball.y") / flight.impact, 2e-3, "symmetry")
    case.assert_below("node of the plate in the ball beyond its facets / element", max(flight.inside(), 0) / flight.edge, 0.01,
                      "none, at any record")
    case.assert_below("max_penetration / element", result.summary["max_penetration"] / flight.edge, 0.05,
                      "no more than the ball's facets are flat")
    falls = numpy.maximum.accumulate(history["contact"]) - history["contact"]
    case.assert_below("energy that contact added / all", falls.max() / result.summary["energy"]["total"], 1e-3, "none")
    length, width = flight.hole()
    case.assert_within("width of the hole / diameter of the ball", 1.0, 1.25, width / (2 * flight.radius), "it fits the ball")
    case.assert_within("length of the hole / diameter of the ball", 1.0, 1.5, length / (2 * flight.radius), "inclined path")
    velocity, whole = flight.debris()
    case.assert_within("nodes of the plate that fly off", 20, 5000, len(velocity), "the hole's contents")
    case.assert_within("elements of the plate that fly off whole", 1, 500, whole, "debris")
    case.assert_within("fastest node / impact", 0.5, 2.0, numpy.linalg.norm(velocity, axis=1).max() / flight.impact,
                       "at most twice as fast, elastically struck")
    # of hex8_bbar: next to the hole, before they are removed; their kind resists by all of its points
    case.assert_below("elements that have folded / all", result.summary["folded_elements"] / result.summary["elements"], 2e-3, "few")


def main():
    case = Case(__file__)
    flight = fly(case, 3)
    check_flight(case, flight)
    if case.long:
        coarse, fine = fly(case, 2), fly(case, 4)
        case.assert_close("speed lost, 2 elements through the plate for 3", flight.lost, coarse.lost, 0.15, "mesh")
        case.assert_close("speed lost, 3 elements through the plate for 4", fine.lost, flight.lost, 0.1, "mesh")
        for through in (2, 3):
            fly(case, through, "hex8_full")
            fly(case, through, "hex8")
    short = {"run.end": 7.0e-6}  # erosion begins at 2.4 us
    case.assert_same_on_ranks((1, 2, 3, 4) if case.long else (1, 3), restarted=True, overrides=short)
    middle = case.run(overrides={**short, "checkpoint.every": 4.0e-6}, name="middle")
    case.assert_same_after_restart(middle, 4.0e-6, overrides=short)
    case.finish()


if __name__ == "__main__":
    main()
