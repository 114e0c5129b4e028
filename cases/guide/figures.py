# SPDX-License-Identifier: Apache-2.0
"""The checks by hand of the pages: rows (quantity, by hand, run, gate), the gate a share of the value by hand.

A value by hand uses the numbers of the page's own scene. A gate is the difference that the page explains.
"""
import math
import os

import h5py
import numpy
import yaml
from case_check import Result, SceneLoader

ROUNDING = 1e-10  # of an energy balance that is an identity


class Task:
    def __init__(self, folder):
        self.folder = folder
        self.claims = []  # (what the page says, does it hold)

    def claim(self, text, holds):
        self.claims.append((text, holds))

    def result(self, name):
        return Result(os.path.join(self.folder, name))

    def scene(self, name):
        with open(os.path.join(self.folder, name), encoding="utf-8") as stream:
            return yaml.load(stream, SceneLoader)


def energy_row(result):
    return ("energy error ratio", 0.0, result.summary["energy"]["error_ratio"], ROUNDING)


def drop(task):
    scene, result = task.scene("drop.yaml"), task.result("drop.out")
    tube, material = scene["mesh"][0]["tube"], scene["materials"]["polycarbonate"]
    wave = math.sqrt(material["young"] / material["density"])
    section = math.pi * (tube["outer_radius"]**2 - tube["inner_radius"]**2)
    force = material["density"] * wave * -scene["initial"][0]["velocity"][2] * section
    passage = 2 * tube["length"] / wave
    time, touches = result.history["time"], result.history["floor.z"] > 0
    first = time[numpy.argmax(touches) - 1]  # a row has the mean force since the row before
    last = time[touches][-1]
    begin, end = (first + share * passage for share in (0.1, 0.9))
    mean = (result.at("impulse_floor.z", end) - result.at("impulse_floor.z", begin)) / (end - begin)
    return [("force of the floor [N]", force, mean, 0.03),
            ("duration of contact [us]", 1e6 * passage, 1e6 * (last - first), 0.06),  # two rows of 5 us
            energy_row(result)]


def press_fit(task):
    scene, result = task.scene("fit.yaml"), task.result("fit.out")
    shaft, hub = (entry["tube"] for entry in scene["mesh"])
    a, r, b, length = shaft["inner_radius"], hub["inner_radius"], hub["outer_radius"], hub["length"]
    sum_of_k = (b**2 + r**2) / (b**2 - r**2) + (r**2 + a**2) / (r**2 - a**2)
    pressure = scene["materials"]["steel"]["young"] * (shaft["outer_radius"] - r) / (r * sum_of_k)
    normal = pressure * math.pi * r * length / 2
    return [("normal force of a quarter [kN]", 1e-3 * normal, 1e-3 * result.at("fit.normal", 1.0), 0.03),
            ("push-out force of a quarter [kN]", 1e-3 * scene["contact"][0]["friction"] * normal, 1e-3 * result.last("press.z"), 0.03)]


def sliding(task):
    scene, result = task.scene("brake.yaml"), task.result("brake.out")
    size, friction = scene["mesh"][0]["box"]["size"], scene["contact"][0]["friction"]
    normal = scene["pressure"][0]["value"] * size[0] * size[1]
    force, speed = friction["kinetic"] * normal, scene["prescribed"][0]["velocity"]
    end, ramp = result.last("time"), scene["curves"]["ramp"][1][0]

    def mean(column):
        return (result.last(f"impulse_pad.{column}") - result.at(f"impulse_pad.{column}", end - 1e-3)) / 1e-3
    def swing(history):
        return numpy.ptp(history["pad.normal"][history["time"] > 1e-3])
    task.claim("without the lag the normal force swings", swing(task.result("no_lag.out").history) > 3 * swing(result.history))
    return [("normal force [N]", normal, mean("normal"), 0.01), ("friction force [N]", force, mean("friction"), 0.02),
            ("heat [J]", force * speed * (end - ramp / 2 - friction["lag"]), result.last("friction"), 0.01),
            energy_row(result)]


def penetration(task):
    scene, slow, fast = task.scene("shot.yaml"), task.result("shot.out"), task.result("fast.out")
    shot, plate = (entry["cylinder"] for entry in scene["mesh"])
    plug = scene["materials"]["aluminium"]["density"] * math.pi * shot["radius"]**2 * plate["length"] / 4  # of a quarter, as the mass
    share = slow.last("mass.mass") / (slow.last("mass.mass") + plug)
    impact, residual = (abs(float(f(slow.history["shot.z"]))) for f in (lambda v: v[0], lambda v: v[-1]))
    limit = math.sqrt(impact**2 - (residual / share)**2)
    second = abs(float(fast.history["shot.z"][0]))
    task.claim("residual velocities are below the bound of momentum", abs(fast.last("shot.z")) < share * second and residual < share * impact)
    return [("residual velocity from 300 m/s [m/s]", share * math.sqrt(second**2 - limit**2), abs(fast.last("shot.z")), 0.03),
            energy_row(slow)]


def mesh(task):
    scene, result = task.scene("lever.yaml"), task.result("lever.out")
    length, width, height = 0.12, 0.01, 0.02
    material, load = scene["materials"]["steel"], -scene["forces"][0]["total"][2]
    inertia, shear = width * height**3 / 12, material["young"] / (2 + 2 * material["poisson"])
    deflection = load * length**3 / (3 * material["young"] * inertia) + load * length / (5 / 6 * shear * width * height)
    with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
        middles = state["mesh/coordinates"][:][state["mesh/connectivity"][:]].mean(axis=1)
        stress = state[max(key for key in state if key.startswith("record"))]["element/stress"][:, 0]
    outer = numpy.argmax(middles[:, 2] - middles[:, 0])  # an uppermost element next to the root
    x, z = middles[outer, 0], middles[outer, 2] - height / 2
    return [("deflection of the end [mm]", 1e3 * deflection, -1e3 * result.last("tip.z"), 0.04),
            ("reaction at the root [N]", load, result.last("root.z"), 1e-6),
            ("axial stress in the element [MPa]", 1e-6 * load * (length - x) * z / inertia, 1e-6 * float(stress[outer]), 0.06)]


def restart(task):
    scene, whole, part = task.scene("crash.yaml"), task.result("crash.out"), task.result("part.out")
    tube, metal = scene["mesh"][0]["tube"], scene["materials"]["aluminium"]
    wall, diameter = tube["outer_radius"] - tube["inner_radius"], tube["outer_radius"] + tube["inner_radius"]
    flow = metal["yield"] + 0.25 * metal["hardening"]
    force = 6 * flow * wall**1.5 * diameter**0.5 / 4
    (_, _), (ramp, speed) = scene["curves"]["speed"]
    travel = speed * (whole.last("time") - ramp / 2)
    task.claim("the restart has the bits of the run without a stop", whole.summary["state_hash"] == part.summary["state_hash"])
    return [("mean crushing force of a quarter [kN]", force, -whole.last("walls") / travel, 0.35),
            ("internal energy after the restart [J]", whole.last("internal"), part.last("internal"), 0.0),
            energy_row(whole)]


def meshes(task):
    reference = 21.43  # mm, converged: cases/taylor_bar
    names = ("coarse", "medium", "fine")
    lengths = [1e3 * task.result(os.path.join("meshes.out", name)).last("top.z") for name in names]
    orders = numpy.linspace(0.5, 6, 5501)  # L_0 + C h^p with h = 1/2, 1/3, 1/4: the ratio of differences gives p
    ratios = (2.0**-orders - 3.0**-orders) / (3.0**-orders - 4.0**-orders)
    p = orders[numpy.argmin(abs(ratios - (lengths[0] - lengths[1]) / (lengths[1] - lengths[2])))]
    slope = (lengths[1] - lengths[2]) / (3.0**-p - 4.0**-p)
    locking = 1e3 * task.result("meshes.out/fine_locking").last("top.z")
    task.claim("hex8_full errs by some 5 %", 0.04 < abs(locking / reference - 1) < 0.07)
    rows = [(f"length, {name} mesh [mm]", reference, length, gate) for name, length, gate in zip(names, lengths, (0.012, 0.005, 0.003))]
    return [*rows, ("length, extrapolated [mm]", reference, lengths[2] - slope * 4.0**-p, 0.002)]


def stops(task):
    flat, held, scene = task.result("flat.out"), task.result("held.out"), task.scene("pull.yaml")
    collapse = 1e6 * (0.02 / 50 + 5e-6)
    length, width, _ = scene["mesh"]["box"]["size"]
    load = scene["forces"][1]["total"][0]
    stretch = load * length / (scene["materials"]["steel"]["young"] * width**2)
    return [("time of the collapse [us]", collapse, 1e6 * flat.summary["end_time"], 0.01),
            ("the bar becomes longer by [um]", 1e6 * stretch, 1e6 * held.last("end.x"), 1e-3)]


TASKS = {"1_drop": drop, "2_press_fit": press_fit, "3_sliding": sliding, "4_penetration": penetration, "5_mesh": mesh,
         "6_restart": restart, "7_meshes": meshes, "8_stops": stops}


def of(page, folder):
    """Rows, and claims without a figure."""
    task = Task(folder)
    return TASKS[page](task), task.claims
