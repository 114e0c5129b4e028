# SPDX-License-Identifier: Apache-2.0
"""The benchmarks: mesh, scene and what is measured, for a number of elements a side and a kind of element.

Loads of linear problems are scaled down (LINEAR) where the published ones bend the shell by more than a hundredth of its thickness;
displacements are scaled up again. Densities decide only how long the relaxation takes.
"""
import math
from dataclasses import dataclass, field

import numpy

import meshes
import references

SHELLS = ("shell4", "shell4_full", "shell3")
LINEAR = 1e-3
RELAXATION = {"tolerance": 1e-3, "max_steps": 20_000_000}  # in the energy norm; displacements under the load are nearer


@dataclass
class Problem:
    mesh: meshes.Mesh | None                      # None: the scene generates it
    scene: dict
    measured: dict = field(default_factory=dict)  # column of history.csv by quantity: (column, factor on it, reference)


def scene_of(title, element, thickness, material, n, points=5):
    """What all scenes have in common. n: for the title."""
    part = {"block": "skin", "material": "m", "element": element}
    if element in SHELLS:
        part |= {"thickness": thickness, "points": points}
    return {"title": f"{title}, {element}, {n} elements a side", "units": "none", "mesh": {"file": "mesh.inp"},
            "materials": {"m": material}, "parts": {"skin": part}, "run": {"steps": 20}}


def elastic(young, poisson, density):
    return {"model": "elastic", "young": young, "poisson": poisson, "density": density}


def of_kind(mesh, element):
    return mesh.triangles() if element == "shell3" else mesh


def probe(mesh, name, point):
    return {"name": name, "node": mesh.near(point) + 1, "field": "displacement"}


def at_node(mesh, name, point, force):
    """A force on the node nearest to a point, as an entry of `forces`."""
    mesh.sets[name] = numpy.array([mesh.near(point)])
    return {"set": name, "force": force}


def along_edge(mesh, name, total, key="force"):
    """An even force or moment on an edge: its end nodes get half as much as those between."""
    nodes = mesh.sets[name]
    share = [component / (len(nodes) - 1) for component in total]
    mesh.sets[f"{name}_ends"] = nodes[[0, -1]]
    entries = [{"set": f"{name}_ends", key: [0.5 * component for component in share]}]
    if len(nodes) > 2:
        mesh.sets[f"{name}_inner"] = nodes[1:-1]
        entries.append({"set": f"{name}_inner", key: share})
    return entries


def roof(n, element):
    radius, half, angle = 25.0, 25.0, math.radians(40)
    mesh = of_kind(meshes.cylinder(radius, half, angle, (n, n)), element)
    scene = scene_of("Scordelis-Lo roof, a quarter", element, 0.25, elastic(4.32e8, 0.0, 36.0), n)
    scene |= {"fixed": [{"set": "ymin", "dofs": ["x", "z", "ry"]}],
              "symmetry": [{"point": [0, half, 0], "normal": [0, 1, 0]}, {"point": [0, 0, 0], "normal": [1, 0, 0]}],
              "gravity": {"vector": [0, 0, -10 * LINEAR]},  # 36 * 0.25 * 10 = 90 on the unit of area
              "relaxation": RELAXATION,
              "probes": [probe(mesh, "edge", [radius * math.sin(angle), half, radius * math.cos(angle)])]}
    return Problem(mesh, scene, {"roof": ("edge.z", -1 / LINEAR, 0.3024)})


def pinched_cylinder(n, element):
    radius, half = 300.0, 300.0
    mesh = of_kind(meshes.cylinder(radius, half, math.pi / 2, (n, n)), element)
    scene = scene_of("Pinched cylinder with end diaphragms, an eighth", element, 3.0, elastic(3.0e6, 0.3, 1.0), n)
    scene |= {"fixed": [{"set": "ymin", "dofs": ["x", "z", "ry"]}],
              "symmetry": [{"point": [0, half, 0], "normal": [0, 1, 0]}, {"point": [0, 0, 0], "normal": [1, 0, 0]},
                           {"point": [0, 0, 0], "normal": [0, 0, 1]}],
              "forces": [at_node(mesh, "load", [0, half, radius], [0, 0, -0.25])],
              "relaxation": RELAXATION, "probes": [probe(mesh, "load", [0, half, radius])]}
    return Problem(mesh, scene, {"pinched cylinder": ("load.z", -1, 1.8248e-5)})


def hemisphere(n, element):
    radius = 10.0
    mesh = of_kind(meshes.sphere(radius, math.radians(72), (n, n)), element)
    out, into = [radius, 0, 0], [0, radius, 0]
    scene = scene_of("Hemisphere with a hole of 18 degrees, a quarter", element, 0.04, elastic(6.825e7, 0.3, 1.0), n)
    scene |= {"symmetry": [{"point": [0, 0, 0], "normal": [1, 0, 0]}, {"point": [0, 0, 0], "normal": [0, 1, 0]}],
              "forces": [at_node(mesh, "out", out, [LINEAR, 0, 0]), at_node(mesh, "into", into, [0, -LINEAR, 0])],
              "fixed": [{"set": "out", "dofs": ["z"]}],
              "relaxation": RELAXATION, "probes": [probe(mesh, "out", out), probe(mesh, "into", into)]}
    return Problem(mesh, scene, {"hemisphere": ("out.x", 1 / LINEAR, 0.0940)})


def twisted_beam(n, element, along_width=True, thickness=0.32):
    """n elements along, n/8 but at least 2 across. At its end the section lies along z."""
    length, width = 12.0, 1.1
    mesh = of_kind(meshes.twisted(length, width, math.pi / 2, (n, max(2, n // 8))), element)
    thin = thickness < 0.1
    load, axis = (1.0e-6 if thin else 1.0), 2 if along_width else 1
    force = [0.0, 0.0, 0.0]
    force[axis] = load
    reference = {(False, True): 5.424e-3, (False, False): 1.754e-3, (True, True): 5.256e-3, (True, False): 1.294e-3}[thin, along_width]
    scene = scene_of("Twisted beam", element, thickness, elastic(29.0e6, 0.22, 1.0), n)
    scene |= {"fixed": [{"set": "xmin", "dofs": ["x", "y", "z", "rx", "ry", "rz"]}], "forces": along_edge(mesh, "xmax", force),
              "relaxation": RELAXATION, "probes": [probe(mesh, "tip", [length, 0, 0])]}
    name = f"twisted beam{', thin' if thin else ''}, {'along' if along_width else 'across'} its tip"
    return Problem(mesh, scene, {name: (f"tip.{'xyz'[axis]}", 1, reference)})


def elastica(n, element, alpha=4.0):
    """A cantilever under a large dead end load; sizes of Sze, Liu and Lo (2004), whose greatest load is alpha = 4."""
    length, width, thickness, young = 10.0, 1.0, 0.1, 1.2e6
    load = alpha * young * width * thickness**3 / 12 / length**2
    scene = scene_of(f"Cantilever with a large end load, alpha = {alpha:g}", element, thickness, elastic(young, 0.0, 1.0), n)
    across = max(1, n // 8)
    if element in SHELLS:
        mesh = of_kind(meshes.plate((length, width), (n, across)), element)
        scene |= {"fixed": [{"set": "xmin", "dofs": ["x", "y", "z", "rx", "ry", "rz"]}],
                  "forces": along_edge(mesh, "xmax", [0, 0, load])}
        end = "xmax"
    else:
        mesh, end = None, "skin_xmax"
        scene["mesh"] = {"box": {"part": "skin", "size": [length, width, thickness], "elements": [n, across, 4]}}
        scene |= {"fixed": [{"set": "skin_xmin", "dofs": ["x", "y", "z"]}], "forces": [{"set": end, "total": [0, 0, load]}]}
    deflection, shortening = references.elastica(alpha)
    scene |= {"relaxation": RELAXATION, "probes": [{"name": "end", "set": end, "field": "displacement"}]}
    return Problem(mesh, scene, {f"elastica, alpha = {alpha:g}, deflection": ("end.z", 1 / length, deflection),
                                 f"elastica, alpha = {alpha:g}, shortening": ("end.x", -1 / length, shortening)})


def roll_up(n, element, share=1.0):
    """A cantilever with an end moment that bends it to a share of a full circle (Simo, Fox and Rifai 1990; sizes of Sze, Liu and Lo)."""
    length, width, thickness, young = 12.0, 1.0, 0.1, 1.2e6
    turn = 2 * math.pi * share
    moment = young * width * thickness**3 / 12 * turn / length
    mesh = of_kind(meshes.plate((length, width), (n, max(1, n // 8))), element)
    scene = scene_of(f"Roll-up by an end moment, {share:g} of a circle", element, thickness, elastic(young, 0.0, 1.0), n)
    scene |= {"fixed": [{"set": "xmin", "dofs": ["x", "y", "z", "rx", "ry", "rz"]}],
              "forces": along_edge(mesh, "xmax", [0, -moment, 0], key="moment"),
              "relaxation": RELAXATION, "probes": [{"name": "end", "set": "xmax", "field": "displacement"}]}
    measured = {f"roll-up, {share:g} of a circle, end along / L": ("end.x", 1 / length, math.sin(turn) / turn - 1)}
    if abs(math.cos(turn) - 1) > 1e-9:
        measured[f"roll-up, {share:g} of a circle, end across / L"] = ("end.z", 1 / length, (1 - math.cos(turn)) / turn)
    return Problem(mesh, scene, measured)


PLATE = {"side": 1.0, "thickness": 0.01, "young": 200.0e9, "poisson": 0.3, "density": 8000.0}  # A10
STRIP = {"length": 1.0, "width": 0.05, "thickness": 0.02, "young": 200.0e9, "density": 8000.0}


def supported_plate(title, n, element, skewed):
    """A square plate with its four sides simply supported (deflection and the turn along the side are zero)."""
    side, thickness = PLATE["side"], PLATE["thickness"]
    scene = scene_of(title, element, thickness, elastic(PLATE["young"], PLATE["poisson"], PLATE["density"]), n)
    if element in SHELLS:
        mesh = of_kind(meshes.plate((side, side), (n, n), skewed), element)
        scene["fixed"] = [{"set": "xmin", "dofs": ["z", "rx"]}, {"set": "xmax", "dofs": ["z", "rx"]},
                          {"set": "ymin", "dofs": ["z", "ry"]}, {"set": "ymax", "dofs": ["z", "ry"]}]
        return mesh, scene
    near, half = 1e-6, 0.5 * thickness
    scene["mesh"] = {"box": {"part": "skin", "size": [side, side, thickness], "elements": [n, n, 4]}}
    scene["sets"], scene["fixed"] = {}, []
    for axis, along in (("x", "y"), ("y", "x")):
        for end in (0, side):
            low, high = [-1, -1, -1], [2, 2, 1]
            i = "xy".index(axis)
            low[i], high[i] = end - near, end + near
            name = f"{axis}_{end:g}"
            scene["sets"][name] = {"part": "skin", "box": [low, high]}
            scene["fixed"] += [{"set": name, "dofs": ["z", along]}]  # hard support: the section does not shear along the side
    assert half > near
    return None, scene


def plate_under_pressure(n, element, skewed=0.0):
    """Static deflection in the middle; the pressure is the weight."""
    mesh, scene = supported_plate("Plate under even pressure", n, element, skewed)
    scene |= {"gravity": {"vector": [0, 0, -LINEAR * 1.0e4 / (PLATE["density"] * PLATE["thickness"])]}, "relaxation": RELAXATION}
    half = 0.5 * PLATE["side"]
    scene["probes"] = [{"name": "middle", "near": [half, half, 0], "field": "displacement"}]
    reference = references.plate_deflection(PLATE["young"], PLATE["poisson"], PLATE["side"], PLATE["thickness"], 1.0e4)
    return Problem(mesh, scene, {f"plate under pressure{', skewed' if skewed else ''}": ("middle.z", -1 / LINEAR, reference)})


def moving(scene, mesh, points, speeds):
    """Initial velocities along z at nodes of a mesh, or of layers and columns of a generated body; equal ones share an entry."""
    scene["initial"] = []
    for i, value in enumerate(numpy.unique(numpy.round(speeds, 12))):
        nodes = numpy.flatnonzero(abs(speeds - value) < 1e-11)
        if mesh is not None:
            mesh.sets[f"speed_{i}"] = nodes
            scene["initial"].append({"set": f"speed_{i}", "velocity": [0, 0, float(value)]})
            continue
        for node in nodes:
            name, (x, y) = f"speed_{node}", points[node]
            scene.setdefault("sets", {})[name] = {"part": "skin", "box": [[x - 1e-6, y - 1e-6, -1], [x + 1e-6, y + 1e-6, 1]]}
            scene["initial"].append({"set": name, "velocity": [0, 0, float(value)]})


def vibrating(scene, frequencies, periods=3.0):
    """Runs over so many periods of the lowest of the frequencies, with ten rows in one of the highest."""
    scene["run"] = {"end": periods / min(frequencies)}
    scene["history"] = {"every": 0.1 / max(frequencies)}


def vibrating_plate(n, element, skewed=0.0, modes=((1, 1), (1, 2), (2, 2))):
    """All three modes at once; the probe stands where none of them vanishes."""
    mesh, scene = supported_plate("Vibrating plate", n, element, skewed)
    frequencies = references.plate_frequencies(PLATE["young"], PLATE["poisson"], PLATE["density"], PLATE["side"], PLATE["thickness"], modes)
    line = numpy.linspace(0, 1, n + 1)
    points = mesh.points[:, :2] if mesh else numpy.stack(numpy.meshgrid(line, line), -1).reshape(-1, 2)
    speeds = 1e-3 * sum(numpy.sin(math.pi * m * points[:, 0]) * numpy.sin(math.pi * k * points[:, 1]) for m, k in modes)
    moving(scene, mesh, points, speeds)
    vibrating(scene, frequencies)
    scene["probes"] = [{"name": "point", "near": [0.25, 0.25, 0], "field": "displacement"}]
    return Problem(mesh, scene, {f"plate mode {i + 1}": ("point.z", 1, f) for i, f in enumerate(frequencies)})


def vibrating_strip(n, element):
    """A cantilever, three modes at once."""
    length, width, thickness = STRIP["length"], STRIP["width"], STRIP["thickness"]
    scene = scene_of("Vibrating cantilever", element, thickness, elastic(STRIP["young"], 0.0, STRIP["density"]), n)
    line = numpy.linspace(0, length, n + 1)
    if element in SHELLS:
        mesh = of_kind(meshes.plate((length, width), (n, 1)), element)
        points, held = mesh.points[:, :2], {"set": "xmin", "dofs": ["x", "y", "z", "rx", "ry", "rz"]}
    else:
        mesh, held = None, {"set": "skin_xmin", "dofs": ["x", "y", "z"]}
        scene["mesh"] = {"box": {"part": "skin", "size": [length, width, thickness], "elements": [n, 1, 4]}}
        points = numpy.stack(numpy.meshgrid(line, [0, width]), -1).reshape(-1, 2)
    scene["fixed"] = [held]
    frequencies = references.cantilever_frequencies(STRIP["young"], STRIP["density"], length, thickness)
    shapes = [references.cantilever_mode(root)(points[:, 0] / length) for root in references.CANTILEVER_ROOTS]
    moving(scene, mesh, points, 1e-3 * sum(shapes))
    vibrating(scene, frequencies)
    scene["probes"] = [{"name": "tip", "near": [length, 0, 0], "field": "displacement"}]
    return Problem(mesh, scene, {f"cantilever mode {i + 1}": ("tip.z", 1, f) for i, f in enumerate(frequencies)})
