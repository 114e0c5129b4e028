# SPDX-License-Identifier: Apache-2.0
"""Plastic bending: a strip whose end is turned to and fro, and the limit load of a circular plate."""
import math

import numpy

import meshes
import problems
import references

STRIP = {"length": 0.5, "width": 0.1, "thickness": 0.02, "young": 200.0e9, "limit": 200.0e6, "density": 8000.0}
TURN = 4.0                                        # largest curvature over that of first yield
SPEED = [[0, 0], [0.05, 1], [0.25, 1], [0.3, 0], [0.35, -1], [0.4, -1], [0.45, 0], [1, 0]]  # of the end's turn over time [s]
DISK = {"radius": 1.0, "thickness": 0.05, "young": 200.0e9, "limit": 2.0e6, "density": 8000.0}
OVERLOAD = 1.2                                    # greatest pressure over the limit load


def perfectly_plastic(data, poisson):
    return {"model": "j2", "young": data["young"], "poisson": poisson, "density": data["density"], "yield": data["limit"]}


def turned(times):
    """Angle of the end at these times over the rate of the plateau: the integral of SPEED."""
    at, rate = numpy.array(SPEED).T
    fine = numpy.unique(numpy.concatenate([at, times]))
    values = numpy.interp(fine, at, rate)
    angle = numpy.concatenate([[0], numpy.cumsum(0.5 * (values[1:] + values[:-1]) * numpy.diff(fine))])
    return numpy.interp(times, fine, angle)


def bent_strip(n, element, points, rule="gauss"):
    """Pure bending: the foot may not turn about y, the end is turned and may move. Elastic and plastic layers contract alike (nu = 0.49) and the
    section may curve, so that stresses are uniaxial."""
    thickness, length = STRIP["thickness"], STRIP["length"]
    mesh = problems.of_kind(meshes.plate((length, STRIP["width"]), (n, 2)), element)
    yielding = 2 * STRIP["limit"] / (STRIP["young"] * thickness)
    rate = TURN * yielding * length / float(turned(numpy.array([0.3]))[0])
    scene = problems.scene_of("Plastic strip", element, thickness, perfectly_plastic(STRIP, 0.49), n, points)
    scene["parts"]["skin"]["rule"] = rule
    mesh.sets["foot"] = mesh.sets["xmin"][1:2]  # the middle of three nodes
    scene |= {"fixed": [{"set": "xmin", "dofs": ["x", "ry"]}, {"set": "foot", "dofs": ["y", "z", "rx", "rz"]}],
              "prescribed": [{"set": "xmax", "dof": "ry", "velocity": "turn", "scale": -rate}],
              "curves": {"turn": SPEED}, "damping": {"alpha": 400},
              "probes": [{"name": "end", "set": "xmax", "field": "displacement"}],
              "run": {"end": 0.46}, "history": {"every": 1.0e-3}}
    return problems.Problem(mesh, scene), rate


def mean_moment(curvatures, rule):
    """Mean over rows of equal distance in time, weighted by the change of the curvature between them."""
    moments = numpy.array([references.strip_moment(k, STRIP["young"], STRIP["limit"], STRIP["thickness"], rule) for k in curvatures])
    changes = numpy.diff(curvatures)
    return float((0.5 * (moments[1:] + moments[:-1]) * changes).sum() / changes.sum())


def check_strip(case, run, element, points, rule="gauss", n=16):
    """Mean moment on the way to the largest curvature, from the work of the end; curvature left where it vanishes after elastic unloading."""
    problem, rate = bent_strip(n, element, points, rule)
    what = f"strip, {element}, {points} {rule} points"
    result = run(case, problem, what.replace(",", "").replace(" ", "_"))
    time, stored = result.history["time"], result.history["internal"] + result.history["hourglass"]
    angle = rate * turned(time)
    curvature = angle / STRIP["length"]
    young, limit, thickness = STRIP["young"], STRIP["limit"], STRIP["thickness"]
    largest = curvature.max()
    window = (time > 0.2) & (time < 0.28)  # after the start has died out, before the turn slows down too much
    moment = numpy.ptp(stored[window]) / numpy.ptp(angle[window]) / STRIP["width"]
    places, weights = (references.gauss if rule == "gauss" else references.lobatto)(points)
    exact, own = (mean_moment(curvature[window], rule_or_none) for rule_or_none in (None, (places, weights)))
    label = f"{element}, {points} {rule} points"
    case.assert_close(f"{label}: moment of the strip / that of its points", 1, moment / own, 0.01, "points through the thickness")
    stiffness = young * thickness**3 / 12
    rest = largest - references.strip_moment(largest, young, limit, thickness, (places, weights)) / stiffness
    back = (time > 0.3) & (time < 0.45)
    lowest = curvature[back][numpy.argmin(stored[back])]
    case.assert_close(f"{label}: curvature left after unloading / largest", rest / largest, lowest / largest, 0.01, "elastic unloading", absolute=True)
    case.row("strip", ["element", "points", "moment / exact", "of these points by theory", "curvature left / largest", "exact", "processor time [s]"],
             [element, f"{points} {rule}", f"{moment / exact:.4f}", f"{own / exact:.4f}", f"{lowest / largest:.4f}",
              f"{1 - references.strip_moment(largest, young, limit, thickness) / stiffness / largest:.4f}", result.seconds])
    case.assert_below("energy error ratio", result.summary["energy"]["error_ratio"], 1e-10)


def loaded_disk(n, element, points):
    """A quarter; the pressure is the weight. It grows over 0.15 s beyond the limit load, which damping then balances."""
    radius, thickness = DISK["radius"], DISK["thickness"]
    mesh = problems.of_kind(meshes.disk(radius, n), element)
    limit = references.limit_load() * DISK["limit"] * thickness**2 / 4 / radius**2
    scene = problems.scene_of("Limit load of a circular plate", element, thickness, perfectly_plastic(DISK, 0.3), n, points)
    scene |= {"fixed": [{"set": "rim", "dofs": ["z"]}],
              "symmetry": [{"point": [0, 0, 0], "normal": [1, 0, 0]}, {"point": [0, 0, 0], "normal": [0, 1, 0]}],
              "gravity": {"vector": [0, 0, -OVERLOAD * limit / (DISK["density"] * thickness)], "curve": "load"},
              "curves": {"load": [[0, 0], [0.15, 1], [1, 1]]}, "damping": {"alpha": 750},
              "probes": [{"name": "middle", "near": [0, 0, 0], "field": "displacement"}],
              "run": {"end": 0.35}, "history": {"every": 1.0e-3}}
    return problems.Problem(mesh, scene), limit


def check_disk(case, run, element, points, n=16):
    """The mechanism dissipates the limit load times the volume that it sweeps: p_limit = p (dissipated / work of the pressure p)."""
    problem, limit = loaded_disk(n, element, points)
    what = f"circular plate, {element}, {points} points"
    result = run(case, problem, f"{what.replace(',', '').replace(' ', '_')}_{n}")
    time, history = result.history["time"], result.history
    late = time > 0.25
    inner, outer = (numpy.ptp(history[name][late]) for name in ("internal", "external"))
    found = OVERLOAD * inner / outer
    places, weights = references.gauss(points)
    own = float((abs(places) * weights).sum())  # plastic moment of these points over limit t^2 / 4
    if n >= 16:
        case.assert_close(f"{element}, {points} points, {n} a side: limit load / that of its points", 1, found / own, 0.02, "Hopkins and Wang 1954")
    case.row("disk", ["element", "points", "elements a side", "limit load / exact", "moment of these points / exact", "deflection / thickness", "processor time [s]"],
             [element, points, n, f"{found:.4f}", f"{own:.4f}", f"{-history['middle.z'][-1] / DISK['thickness']:.3f}", result.seconds])
    case.assert_below("energy error ratio", result.summary["energy"]["error_ratio"], 1e-10)
    assert limit > 0 and math.isfinite(found)


def check(case, run):
    check_strip(case, run, "shell4", 5)
    check_disk(case, run, "shell4", 5)
    if case.long:
        for element in problems.SHELLS:
            for points, rule in ((3, "gauss"), (5, "lobatto"), (10, "gauss")):
                check_strip(case, run, element, points, rule)
            for n in (8, 16):
                check_disk(case, run, element, 10, n)
