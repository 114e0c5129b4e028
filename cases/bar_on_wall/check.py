#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Bars on a rigid wall: elastic wave (force, duration, rebound, energy) and elastic-plastic waves at finite strain."""
import os
import sys

import h5py
import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402


def merged(scene, overrides):
    """The scene with overrides {key path: value} applied, as `--set` does it."""
    for path, value in overrides.items():
        place = scene
        *parents, last = [int(key) if key.isdigit() else key for key in path.split(".")]
        for key in parents:
            place = place[key]
        place[last] = value
    return scene


def along(result, scene, probe):
    """A probe's column along the wall's normal."""
    normal = numpy.array(scene["rigid_walls"][0]["normal"], float)
    normal /= numpy.linalg.norm(normal)
    return sum(n * result.history[f"{probe}.{axis}"] for n, axis in zip(normal, "xyz"))


def material(scene):
    return next(iter(scene["materials"].values()))


def plateau_force(result, scene, duration):
    """Mean over the middle half of the contact, from the impulse."""
    impulse = along(result, scene, "impulse_wall")
    early, late = numpy.interp([0.25 * duration, 0.75 * duration], result.history["time"], impulse)
    return (late - early) / (0.5 * duration)


# --- elastic: d'Alembert ---------------------------------------------------------------------------------------------

def check_elastic(case, name, overrides=None, elements=100, rebound_gate=2e-2):
    """One run against F = rho c v A, duration 2 L / c, rebound at the impact speed."""
    overrides = dict(overrides or {})
    overrides.setdefault("mesh.box.elements", [1, 1, elements])
    result = case.run(overrides=overrides, ranks=1, name=name.replace(" ", "_").replace(",", ""))
    scene = merged(case.scene(), overrides)
    law, (width, depth, length) = material(scene), scene["mesh"]["box"]["size"]
    confined = "fixed" in scene  # no lateral strain: the modulus of uniaxial strain
    nu = law["poisson"]
    modulus = law["young"] * ((1 - nu) / ((1 + nu) * (1 - 2 * nu)) if confined else 1)
    wave_speed = numpy.sqrt(modulus / law["density"])
    speed = numpy.linalg.norm(scene["initial"][0]["velocity"])
    force, duration = law["density"] * wave_speed * speed * width * depth, 2 * length / wave_speed

    case.assert_close(f"{name}: wall force [N]", force, plateau_force(result, scene, duration), 1e-2, "rho c v A")
    touching = result.history["time"][along(result, scene, "wall") > 0.01 * force]
    case.assert_close(f"{name}: contact ends [s]", duration, touching[-1], 2e-2, "2 L / c")
    velocity, impulse = along(result, scene, "bar"), along(result, scene, "impulse_wall")
    case.assert_close(f"{name}: rebound velocity [m/s]", speed, velocity[-1], rebound_gate, "d'Alembert")
    mass = law["density"] * width * depth * length
    case.assert_close(f"{name}: impulse [N s]", mass * (velocity[-1] + speed), impulse[-1], 1e-12, "m (v1 - v0)")
    case.assert_energy(result)
    layer_share = 1 / (2 * overrides["mesh.box.elements"][2])
    taken = result.summary["energy"]["walls"] / (0.5 * mass * speed**2)
    case.assert_below(f"{name}: energy to wall / (1/2N)", taken / layer_share, 1.2, "the touching layer")
    return result


def check_elastic_options(case):
    for elements in (50, 100, 200):
        check_elastic(case, f"N={elements}", elements=elements)
    part = "parts.bar"
    check_elastic(case, "hex8_full", {f"{part}.element": "hex8_full"})
    check_elastic(case, "hex8_bbar", {f"{part}.element": "hex8_bbar"})
    check_elastic(case, "neo-Hookean", {"materials.steel.model": "neo_hookean"})
    check_elastic(case, "3x3 section", {"mesh.box.elements": [3, 3, 100]})
    check_elastic(case, "bulk viscosity", {f"{part}.bulk": {"linear": 0.06, "quadratic": 1.2}}, rebound_gate=5e-2)
    check_elastic(case, "cfl 0.5", {"run.cfl": 0.5})
    check_elastic(case, "confined", {"materials.steel.poisson": 0.3, "fixed": [{"part": "bar", "dofs": ["x", "y"]}]})
    angle = numpy.radians(37.0)
    normal = [0.0, -float(numpy.sin(angle)), float(numpy.cos(angle))]
    turned = {"axis": [1, 0, 0], "degrees": 37}
    check_elastic(case, "inclined", {"mesh.box.rotate": turned, "rigid_walls.0.normal": normal,
                                     "initial.0.velocity": [-10 * n for n in normal]})


# --- elastic-plastic: jump conditions at finite strain ---------------------------------------------------------------

def plastic_wave(scene):
    """Two-wave solution: Cauchy stress over logarithmic strain e, sy + H ep; the section grows with exp(ep).

    Nominal stress P = s exp(ep) over stretch exp(-e) is convex in compression, so both waves are shocks:
    [v]^2 = [P] [stretch] / rho, speed^2 = [P] / [stretch] / rho (in the material).
    """
    law = material(scene)
    young, hardening, rho = law["young"], law["hardening"], law["density"]
    length, speed = scene["mesh"]["box"]["size"][2], -scene["initial"][0]["velocity"][2]
    yield_strain = law["yield"] / young
    nominal_y, stretch_y = law["yield"], numpy.exp(-yield_strain)

    def behind(strain):
        stress = (law["yield"] + hardening * strain) / (1 + hardening / young)
        plastic = strain - stress / young
        return stress * numpy.exp(plastic), plastic, numpy.exp(-strain)

    elastic_speed = numpy.sqrt(nominal_y / (1 - stretch_y) / rho)
    speed_between = speed - numpy.sqrt(nominal_y * (1 - stretch_y) / rho)
    low, high = yield_strain, 1.0
    for _ in range(100):
        middle = 0.5 * (low + high)
        nominal, plastic, stretch = behind(middle)
        slow = (nominal - nominal_y) * (stretch_y - stretch) / rho < speed_between**2
        low, high = (middle, high) if slow else (low, middle)
    front_speed = numpy.sqrt((nominal - nominal_y) / (stretch_y - stretch) / rho)
    return {"stress": nominal, "plastic": plastic, "between": speed_between, "front": front_speed,
            "meeting": 2 * length / (elastic_speed + front_speed), "elastic": elastic_speed}


def profile(result, time):
    """The record nearest to a time: its time, along the bar the place and plastic strain of the elements (in order),
    and place and velocity of the nodes; places are those at the start."""
    with h5py.File(os.path.join(result.folder, "state.h5"), "r") as state:
        records = [state[name] for name in state if name.startswith("record")]
        record = min(records, key=lambda candidate: abs(candidate.attrs["time"] - time))
        nodes = state["mesh/coordinates"][:, 2]
        place = nodes[state["mesh/connectivity"][:]].mean(axis=1)
        order = numpy.argsort(place)
        plastic = record["element/plastic_strain"][:][order]
        return float(record.attrs["time"]), place[order], plastic, nodes, record["node/velocity"][:, 2]


def check_plastic(case, scene_file, element):
    scene = case.scene(scene_file)
    exact = plastic_wave(scene)
    name = f"{os.path.splitext(scene_file)[0]} {element}"
    result = case.run(scene_file, {"parts.bar.element": element}, name=name.replace(" ", "_"))
    width, depth, length = scene["mesh"]["box"]["size"]
    size = length / scene["mesh"]["box"]["elements"][2]

    time, place, plastic, _, _ = profile(result, scene["run"]["end"])
    if time > exact["meeting"]:
        sys.exit(f"{name}: the run ends at {time:.4g} s, after the waves met at {exact['meeting']:.4g} s")
    stress = plateau_force(result, scene, time) / (width * depth)
    case.assert_close(f"{name}: nominal wall stress [Pa]", exact["stress"], stress, 1e-2, "jump conditions")
    front = exact["front"] * time
    inside = (place > 0.25 * front) & (place < 0.75 * front)
    case.assert_close(f"{name}: plastic strain", exact["plastic"], plastic[inside].mean(), 3e-2, "jump conditions")
    after = numpy.argmax((plastic < 0.5 * exact["plastic"]) & (place > 0.5 * front))
    share = (plastic[after - 1] - 0.5 * exact["plastic"]) / (plastic[after - 1] - plastic[after])
    arrived = place[after - 1] + share * size
    case.assert_close(f"{name}: plastic front at [m]", front, arrived, 2 * size, "jump conditions", absolute=True)

    time, _, _, nodes, velocity = profile(result, 0.9 * length / exact["elastic"])
    slow, fast = exact["front"] * time, exact["elastic"] * time
    between = (nodes > slow + 0.25 * (fast - slow)) & (nodes < fast - 0.25 * (fast - slow))
    case.assert_close(f"{name}: speed between fronts [m/s]", exact["between"], -velocity[between].mean(), 2e-2,
                      "jump conditions")
    case.assert_energy(result)


def main():
    case = Case(__file__)
    check_elastic_options(case)
    for element in ("hex8", "hex8_bbar"):
        check_plastic(case, "plastic_steel.yaml", element)
        check_plastic(case, "plastic_aluminium.yaml", element)
    small = {"mesh.box.elements": [2, 2, 20], "run.end": 6.0e-5}
    case.assert_same_on_ranks((1, 2, 3, 4, 7), restarted=True, overrides=small)
    whole = case.run(overrides=small, name="whole")
    case.assert_same_after_restart(whole, 3.0e-5, overrides=small)
    case.finish()


main()
