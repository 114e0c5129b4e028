#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Elastic balls on a rigid plane and on each other against Hertz's impact, with the correction for finite balls."""
import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

SOURCE = "Hertz 1881 and finite-size factor, see README"
QUARTERS = 4  # the scenes hold a quarter of each ball
MASSES = []  # rows of the table of masses
WINDOW = 0.015  # of the contact: forces are means over it, 5 us of H4
# Hertz takes each ball for a half-space. Converged linear finite elements (axisymmetric, three meshes, extrapolated) of
# a/R = 0.0425, 0.068, 0.081 give F / Hertz = 1.018, 1.030, 1.037 and t / Hertz = 0.9855, 0.979, 0.974.
FORCE_FACTOR, TIME_FACTOR = 0.44, -0.32  # per a/R


class Ball:
    def __init__(self, scene, mesh, mass):
        self.radius, part = mesh["radius"], mesh["part"]
        self.law = scene["materials"][scene["parts"][part]["material"]]
        self.velocity = next(entry["velocity"][2] for entry in scene["initial"] if entry["part"] == part)
        self.modulus = self.law["young"] / (1 - self.law["poisson"]**2)
        self.volume = 4 / 3 * numpy.pi * self.radius**3
        self.mass = mass or self.law["density"] * self.volume


def meshes(scene):
    listed = scene["mesh"] if isinstance(scene["mesh"], list) else [scene["mesh"]]
    return [entry["sphere"] for entry in listed]


def exact(scene, masses=None):
    """Greatest force, duration, approach; masses: of the whole balls as meshed (faceted balls are lighter)."""
    balls = [Ball(scene, mesh, mass) for mesh, mass in zip(meshes(scene), masses or [None, None])]
    compliance = sum(1 / ball.modulus for ball in balls)
    curvature = sum(1 / ball.radius for ball in balls)
    mass = 1 / sum(1 / ball.mass for ball in balls)
    closing = abs(balls[0].velocity - (balls[1].velocity if len(balls) > 1 else 0))
    stiffness = 4 / 3 / compliance / numpy.sqrt(curvature)
    approach = (5 * mass * closing**2 / (4 * stiffness))**0.4
    slender = numpy.sqrt(approach / curvature) / max(ball.radius for ball in balls)
    return {"force": stiffness * approach**1.5 * (1 + FORCE_FACTOR * slender),
            "duration": 2.943275 * approach / closing * (1 + TIME_FACTOR * slender),
            "contact radius": numpy.sqrt(approach / curvature), "closing": closing}


def meshed_masses(scene, history):
    """Of the whole balls as meshed, from total mass and (for two) momentum."""
    total = QUARTERS * history["mass"][0]
    if len(meshes(scene)) == 1:
        return [total]
    first, second = (entry["velocity"][2] for entry in scene["initial"])
    share = (QUARTERS * history["momentum_z"][0] / total - second) / (first - second)
    return [share * total, (1 - share) * total]


class Impact:
    """What a run gives, for whole balls; `reference`: Hertz for their masses as meshed."""

    def __init__(self, scene, result):
        history, parts = result.history, [mesh["part"] for mesh in meshes(scene)]
        self.masses = meshed_masses(scene, history)
        self.reference = exact(scene, self.masses)
        closing = history[f"{parts[0]}.z"] - (history[f"{parts[1]}.z"] if len(parts) > 1 else 0)
        self.restitution = -closing[-1] / closing[0]
        time, impulse = history["time"], QUARTERS * abs(history["impulse_force.z"])
        half = WINDOW * self.reference["duration"] / 2
        middle = time[(time > half) & (time < time[-1] - half)]
        given = numpy.interp(middle + half, time, impulse) - numpy.interp(middle - half, time, impulse)
        self.force = given.max() / (2 * half)
        touching = numpy.flatnonzero(impulse < (1 - 1e-9) * impulse[-1])
        self.duration = time[touching[-1] + 1] - time[max(0, numpy.flatnonzero(impulse > 0)[0] - 1)]

    def errors(self):
        return {"force": self.force / self.reference["force"] - 1, "duration": self.duration / self.reference["duration"] - 1,
                "restitution": self.restitution - 1}


def errors(scene, result):
    """For scripts/pareto."""
    return Impact(scene, result).errors()


def check(case, label, scene, result):
    ours = Impact(scene, result)
    whole = [Ball(scene, mesh, None).mass for mesh in meshes(scene)]
    full = exact(scene)
    MASSES.append([label, ", ".join(f"{100 * (mass / sphere - 1):+.2f}" for mass, sphere in zip(ours.masses, whole)),
                   f"{full['force']:.5g}", f"{1e6 * full['duration']:.5g}"])
    for mesh in meshes(scene):
        edge = numpy.pi / 4 * mesh["radius"] / round(0.6 * mesh["elements"]) / mesh.get("finer", 1)
        case.assert_within(f"{label}: elements over the contact radius, {mesh['part']}", 6, numpy.inf,
                           ours.reference["contact radius"] / edge, "resolution")
    case.assert_close(f"{label}: greatest force [N]", ours.reference["force"], ours.force, 0.015, SOURCE)
    case.assert_close(f"{label}: duration [s]", ours.reference["duration"], ours.duration, 0.01, SOURCE)
    case.assert_within(f"{label}: restitution", 0.995, 1, ours.restitution, "elastic, waves have time to settle")
    case.assert_below(f"{label}: hourglass energy / total", result.summary["energy"]["hourglass"]
                      / result.summary["energy"]["total"], 1e-3)
    case.assert_energy(result, energy_gate=1e-10, momentum_gate=1e-10)
    return ours


def check_mirror(case, scene, plane):
    """The same ball on its mirror image: one must not know a deformable plane from a rigid one (H5)."""
    two = case.scene("two_spheres.yaml")
    mirror, lower = dict(scene["mesh"]["sphere"]), dict(two["mesh"][1]["sphere"])
    lower = {**mirror, "part": "lower", "rotate": lower["rotate"], "at": [-x for x in mirror["at"]]}
    image = {"mesh.0.sphere": {**mirror, "part": "upper"}, "mesh.1.sphere": lower, "materials.steel": scene["materials"]["soft"],
             "initial.0.velocity": [0, 0, -2], "initial.1.velocity": [0, 0, 2], "run.end": scene["run"]["end"],
             "history.every": scene["history"]["every"], "output.every": scene["run"]["end"]}
    mirrored = case.run("two_spheres.yaml", overrides=image, name="mirror", ranks=2)
    ours = check(case, "ball on its mirror image", case.scene("two_spheres.yaml", image), mirrored)
    case.assert_close("force on the mirror image [N]", plane.force, ours.force, 5e-3, "symmetry")


def main():
    case = Case(__file__)
    case.answer(errors)
    scene = case.scene()
    plane = check(case, "ball on plane", scene, case.run(name="plane", ranks=case.of_all(2, 1)))
    if case.long:
        check_mirror(case, scene, plane)
        two = case.scene("two_spheres.yaml")
        check(case, "two steel balls", two, case.run("two_spheres.yaml", name="two", ranks=2))
        rows = []
        for factor in (0.5, 0.75):
            coarse = {"mesh.sphere.elements": round(factor * scene["mesh"]["sphere"]["elements"])}
            run = Impact(case.scene(overrides=coarse), case.run(overrides=coarse, name=f"coarse_{factor}", ranks=2))
            rows.append([coarse["mesh.sphere.elements"], *(f"{100 * error:+.2f} %" for error in run.errors().values())])
        case.table("coarser", ["elements across the radius", "force, error", "duration, error", "restitution, error"], rows)
    case.table("masses", ["scene", "mass of each ball as meshed, error [%]", "force for the full mass [N]", "duration for the full mass [us]"], MASSES)
    short = {"run.steps": 300}
    case.assert_same_on_ranks((1, 2, 3), overrides=short)
    case.finish()


if __name__ == "__main__":
    main()
