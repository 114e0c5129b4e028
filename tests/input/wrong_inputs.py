# SPDX-License-Identifier: Apache-2.0
"""What a hurried user gets wrong. Each entry is one change of the good scene and what the message must say of it."""
from dataclasses import dataclass, field

import tiny_meshes as mesh
import wrong_depths
import wrong_joints
import wrong_scripts
import wrong_shells

GOOD = """\
title: one cube against a wall
units: SI
mesh: {file: bar.msh}
materials:
  steel: {model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}
parts:
  bar: {block: bar, material: steel, element: hex8}
sets:
  foot: {part: bar, box: [[0, 0, 0], [1, 1, 0.01]]}
initial:
  - {part: bar, velocity: [0, 0, -1]}
fixed:
  - {set: foot, dofs: [x]}
run: {end: 1.0e-5}
output: {every: 5.0e-6, fields: [displacement, velocity]}
history: {every: 1.0e-6}
"""


@dataclass
class Wrong:
    name: str
    says: list                    # phrases that one line of the message must hold together, in any case of letters
    change: tuple = ()            # (text of the good scene, what stands there instead)
    scene: object = None          # the whole scene instead: text or bytes
    files: dict = field(default_factory=dict)  # more files beside the scene: name -> bytes; None: not there
    arguments: list = field(default_factory=list)
    command: str = "check"
    target: str = "scene.yaml"    # what is given as the scene
    keeps: list = field(default_factory=list)  # files that must be left as they were
    lines: int = 0                # so many lines are told; 0: some


def changed(name, old, new, *says, **more):
    return Wrong(name, list(says), (old, new), **more)


def with_mesh(name, content, *says, file="bar.msh"):
    return Wrong(name, list(says), ("bar.msh", file), files={file: content})


exo, msh = mesh.exodus(), mesh.gmsh()
flat = [(x, y, 0) for x, y, _ in mesh.CUBE]
not_finite = [(float("nan"), 0, 0)] + mesh.CUBE[1:]

COPPER = ("{model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}",
          "{model: johnson_cook, density: 8960, young: 1.24e11, poisson: 0.34, A: 9.0e7, B: 2.92e8, n: 0.31, C: 0.025, m: 1.09, "
          "melt: 1356, room: 294, heat_capacity: 383, damage: {D1: 0.54, D2: 4.89, D3: -3.03, D4: 0.014, D5: 1.12}, "
          "eos: {model: mie_gruneisen, c: 3940, s: 1.489, gamma: 1.99}}")


def copper(name, old, new, *says):
    """A fault in the constants of a metal."""
    return Wrong(name, list(says), (COPPER[0], COPPER[1].replace(old, new)))


def eroding(name, erosion, *says, metal=True, **more):
    part = "material: steel, element: hex8"
    scene = GOOD.replace(part, f"{part}, erosion: {erosion}")
    return Wrong(name, list(says), scene=scene.replace(*COPPER) if metal else scene, **more)


METALS = [
    copper("a constant of Johnson-Cook is missing", "n: 0.31, ", "", "materials.steel.n", "expected a number > 0"),
    copper("melts below room temperature", "melt: 1356", "melt: 290", "materials.steel.melt", "not above room, 294"),
    copper("temperature without melting point", "melt: 1356, ", "", "materials.steel.melt"),
    copper("negative D2", "D2: 4.89", "D2: -4.89", "materials.steel.damage.D2", "a number >= 0"),
    copper("strain at fracture below zero", "D1: 0.54", "D1: -5", "materials.steel.damage", "D1 + D2 = -0.11"),
    copper("D5 that makes hot metal fail at once", "D5: 1.12", "D5: -5", "materials.steel.damage.D5", "> -1"),
    copper("hardening in other units", "B: 2.92e8", "B: 2.92e14", "materials.steel.B", "of Young's modulus"),
    copper("D3 above zero", "D3: -3.03", "D3: 3.03", "materials.steel.damage.D3", "<= 0"),
    copper("yield stress in MPa beside Pa", "A: 9.0e7", "A: 90", "materials.steel.A", "7.2e-10 of Young's modulus",
           "same units"),
    copper("critical damage of 2", "D1: 0.54", "critical: 2, D1: 0.54", "damage.critical", "<= 1"),
    copper("an unknown equation of state", "model: mie_gruneisen", "model: jwl", "eos.model", "mie_gruneisen"),
    copper("equation of state without c", "c: 3940, ", "", "materials.steel.eos.c"),
    copper("a positive minimum pressure", "gamma: 1.99", "gamma: 1.99, minimum_pressure: 1.0e9", "eos.minimum_pressure",
           "<= 0"),
    copper("shear beside young", "A: 9.0e7", "shear: 4.6e10, A: 9.0e7", "materials.steel.young", "together with shear"),
    copper("a wrong key of damage", "D5: 1.12", "D6: 1.12", "damage.D6", "unknown key"),
    eroding("erosion without criterion", "{nodes: keep}", "parts.bar.erosion", "missing criterion"),
    eroding("erosion of a criterion nobody knows", "{strain: 0.3}", "parts.bar.erosion.strain", "unknown key"),
    eroding("erosion by damage of what has none", "{damage: 1.0}", "parts.bar.erosion.damage", "has no damage",
            metal=False),
    eroding("erosion by plastic strain of what is elastic", "{plastic_strain: 0.3}", "parts.bar.erosion.plastic_strain",
            metal=False),
    eroding("erosion beyond the critical damage", "{damage: 1.5}", "parts.bar.erosion.damage", "never reached"),
    eroding("erosion that takes all elements at the start", "{step: 1.0}", "parts.bar.erosion", "at the start"),
    eroding("a run of which erosion takes all elements at the start", "{step: 1.0}", "parts.bar.erosion", "at the start", command="run"),
    eroding("erosion at no pressure", "{pressure: 0}", "parts.bar.erosion.pressure", "expected a number > 0"),
    eroding("erosion at more than all volume", "{volume: 1.5}", "parts.bar.erosion.volume", "< 1", lines=1),
    Wrong("foam without table", ["materials.steel", "yield_table"], (COPPER[0],
          "{model: crushable_foam, density: 200, young: 5.0e7}")),
    Wrong("foam that loses all volume", ["materials.steel.yield_table", "below 1"], (COPPER[0],
          "{model: crushable_foam, density: 200, young: 5.0e7, yield_table: [[0, 1.0e6], [1.2, 2.0e6]]}")),
    Wrong("a yield table of foam in other units", ["materials.steel.yield_table", "of Young's modulus"], (COPPER[0],
          "{model: crushable_foam, density: 200, young: 50, yield_table: [[0, 1.0e6], [0.6, 1.2e6]]}")),
    Wrong("a hardening table in other units", ["materials.steel.hardening_table", "of Young's modulus"], (COPPER[0],
          "{model: piecewise_linear, density: 7830, young: 2.0e5, poisson: 0.3, hardening_table: [[0, 4.0e8], [1, 5.0e8]]}")),
    Wrong("hydrodynamic without equation of state", ["materials.steel", "eos"], (COPPER[0],
          "{model: hydrodynamic, density: 8930, shear: 4.8e10, yield: 1.2e8}")),
]

FILES = [
    Wrong("scene is not there", ["nowhere.yaml"], target="nowhere.yaml"),
    Wrong("scene in a folder that is not there", ["no/such/folder"], target="no/such/folder/scene.yaml"),
    Wrong("scene is a folder", ["folder"], target="folder", files={"folder/x": b""}),
    Wrong("scene is empty", ["scene.yaml"], scene=""),
    Wrong("scene is a comment", ["scene.yaml"], scene="# later\n"),
    Wrong("scene is a list", ["scene.yaml"], scene="- a\n- b\n"),
    Wrong("scene is binary", ["scene.yaml"], scene=bytes(range(256)) * 8),
    Wrong("scene is the mesh", ["bar.msh"], target="bar.msh"),
    changed("tab in YAML", "  steel:", "\tsteel:", "scene.yaml", "5"),
    changed("bracket not closed", "[0, 0, -1]}", "[0, 0, -1}", "scene.yaml"),
    changed("key twice", "units: SI", "units: SI\nunits: SI", "units"),
    changed("mesh file is not there", "bar.msh", "missing.exo", "missing.exo"),
    changed("mesh file of no known kind", "bar.msh", "bar.step", "bar.step", files={"bar.step": b"ISO-10303-21;"}),
    with_mesh("mesh file is empty", b"", "bar.msh"),
    with_mesh("mesh file is text", b"hello\n", "bar.msh"),
    with_mesh("Gmsh file cut in its elements", msh[:-30], "bar.msh"),
    with_mesh("Gmsh file without elements", mesh.gmsh(elements=()), "bar.msh", "element"),
    with_mesh("Gmsh element inverted", mesh.gmsh(elements=[mesh.INVERTED]), "element 1"),
    with_mesh("Gmsh element flat", mesh.gmsh(nodes=flat), "element 1"),
    with_mesh("Gmsh node out of range", mesh.gmsh(elements=[[1, 2, 3, 4, 5, 6, 7, 99]]), "99"),
    with_mesh("Gmsh node not finite", mesh.gmsh(nodes=not_finite), "bar.msh", "1"),
    with_mesh("Exodus file cut in its header", exo[:200], "bar.exo", file="bar.exo"),
    with_mesh("Exodus file cut in its data", exo[:-20], "bar.exo", file="bar.exo"),
    with_mesh("Exodus file is text", b"hello\n", "bar.exo", file="bar.exo"),
    with_mesh("Exodus node out of range", mesh.exodus(elements=[[1, 2, 3, 4, 5, 6, 7, 99]]), "bar.exo", "99", file="bar.exo"),
    with_mesh("Exodus element inverted", mesh.exodus(elements=[mesh.INVERTED]), "element 1", file="bar.exo"),
]

SCENES = [
    changed("unit missing", "units: SI\n", "", "units"),
    changed("unit unknown", "units: SI", "units: furlong-fortnight-stone", "units", "furlong-fortnight-stone"),
    changed("misspelt section", "materials:", "matrials:", "scene.yaml:4", "matrials", "did you mean 'materials'?", lines=1),
    changed("misspelt key", "density:", "densty:", "scene.yaml:5", "densty", "did you mean 'density'?", lines=1),
    changed("unknown model", "model: elastic", "model: elasic", "elasic", "elastic"),
    changed("unknown material", "material: steel", "material: stel", "stel", "steel"),
    changed("no material", ", material: steel", "", "material", "bar"),
    changed("unknown element", "element: hex8", "element: hex9", "hex9", "hex8"),
    changed("element of another shape", "element: hex8", "element: tet4", "scene.yaml:7: parts.bar.element", "tet4", "expected", lines=1),
    changed("negative density", "7800", "-7800", "density", "-7800"),
    changed("zero density", "7800", "0", "density"),
    changed("density not a number", "7800", ".nan", "density"),
    changed("density infinite", "7800", ".inf", "density"),
    changed("number with a unit", "7800", "7800 kg", "density", "7800 kg"),
    changed("decimal comma", "7800", "'7,8'", "density", "7,8", "no comma", lines=1),
    changed("comma of thousands in a map", "7800", "7,800", "scene.yaml:5", "density", "7,800", "no comma", "7800", lines=1),
    changed("commas of thousands in a map", "2.0e11", "200,000,000", "scene.yaml:5", "young", "200,000,000", "no comma", "write 200000000", lines=1),
    changed("decimal comma in a map", "{end: 1.0e-5}", "{end: 1.0e-5, cfl: 0,9}", "run.cfl", "0,9", "no comma", "write 0.9;", lines=1),
    changed("decimal comma in a duration", "{end: 1.0e-5}", "{end: 1.0e-5, wall_limit: 1,5h}", "wall_limit", "1,5h", "write 1.5h", lines=1),
    changed("decimal comma in a count", "{end: 1.0e-5}", "{steps: 1,000,000}", "steps", "no comma", "write 1000000", lines=1),
    changed("decimal comma in a list", "[0, 0, -1]", "[0, 0, -1,5]", "scene.yaml:11", "velocity", "no comma", lines=1),
    changed("number too large", "2.0e11", "2.0e999", "young"),
    changed("Poisson's ratio one half", "poisson: 0.3", "poisson: 0.5", "poisson", "0.5"),
    changed("unknown stress rate", "poisson: 0.3", "poisson: 0.3, stress_rate: truesdell", "stress_rate", "unknown value 'truesdell'",
            "jaumann, logarithmic", lines=1),
    changed("stress rate of a hyperelastic law", "model: elastic", "model: neo_hookean, stress_rate: logarithmic", "stress_rate", lines=1),
    changed("list instead of a number", "7800", "[7800]", "density"),
    changed("vector of two", "[0, 0, -1]", "[0, -1]", "velocity"),
    changed("text in a vector", "[0, 0, -1]", "[0, 0, down]", "velocity", "down"),
    changed("part without block", "block: bar", "block: rod", "scene.yaml:7: parts.bar.block", "rod", "expected", "(bar)"),
    changed("block without part", "  bar: {block: bar, material: steel, element: hex8}\n", "", "parts"),
    changed("two parts of one block", "sets:", "  twin: {block: bar, material: steel}\nsets:", "scene.yaml:8: parts.twin.block", "bar", "expected", lines=1),
    changed("end time zero", "end: 1.0e-5", "end: 0", "end", "0"),
    changed("end time negative", "end: 1.0e-5", "end: -1", "end", "-1"),
    changed("no end", "{end: 1.0e-5}", "{cfl: 0.9}", "run", "end"),
    changed("step ratio of nothing", "{end: 1.0e-5}", "{end: 1.0e-5, min_step_ratio: 0}", "min_step_ratio", "out of range: 0", lines=1),
    changed("step ratio of one", "{end: 1.0e-5}", "{end: 1.0e-5, min_step_ratio: 1}", "min_step_ratio", "> 0 and < 1", lines=1),
    changed("guard of nothing", "run:", "guards: {energy_stop: 0}\nrun:", "guards.energy_stop", "out of range: 0", "a number > 0", lines=1),
    changed("guard that stops before it warns", "run:", "guards: {energy_warning: 0.2}\nrun:", "guards.energy_warning",
            "would stop before it warns", "at least energy_warning", lines=1),
    changed("guard of depth that stops before it warns", "run:", "guards: {depth_stop: 0.05}\nrun:", "guards.depth_stop",
            "would stop before it warns", "at least depth_warning", lines=1),
    changed("unknown guard", "run:", "guards: {energy_stp: 0.2}\nrun:", "guards.energy_stp", "did you mean 'energy_stop'", lines=1),
    changed("unknown search", "run:", "search: {method: tree}\nrun:", "search.method", "tree", "auto, blocks, binary", lines=1),
    changed("step factor above one", "{end: 1.0e-5}", "{end: 1.0e-5, cfl: 1.5}", "cfl", "1.5"),
    changed("unknown output field", "[displacement, velocity]", "[displacment]", "displacment", "displacement"),
    changed("output interval zero", "every: 5.0e-6", "every: 0", "output", "every"),
    changed("set selects nothing", "[1, 1, 0.01]", "[1, 1, -0.01]", "foot"),
    changed("side set that the mesh does not have", "{part: bar, box: [[0, 0, 0], [1, 1, 0.01]]}", "{side_set: foot}",
            "scene.yaml:9: sets.foot.side_set", "expected", lines=1),
    changed("box beside the part", "[[0, 0, 0], [1, 1, 0.01]]", "[[5, 5, 5], [6, 6, 6]]", "scene.yaml:13: fixed.0.set", "foot", "expected", lines=1),
    changed("removal of an unknown part", "fixed:", "remove: [{part: bra, at: 0}]\nfixed:", "scene.yaml:12: remove.0.part",
            "unknown part 'bra'", "did you mean 'bar'", "expected", lines=1),
    changed("removal before the start", "fixed:", "remove: [{part: bar, at: -1}]\nfixed:", "scene.yaml:12: remove.0.at",
            "out of range: -1", "a number >= 0", lines=1),
    changed("removal without a time", "fixed:", "remove: [{part: bar}]\nfixed:", "scene.yaml:12: remove.0", "missing",
            "at", lines=1),
    changed("removal of no whole element", "fixed:", "remove: [{set: foot, at: 0}]\nfixed:", "scene.yaml:12: remove.0.set",
            "'foot' contains no complete deformable element", "expected", lines=1),
    changed("unknown set", "set: foot", "set: food", "scene.yaml:13: fixed.0.set", "food", "did you mean 'foot'", "expected", lines=1),
    changed("unknown direction", "dofs: [x]", "dofs: [w]", "dofs", "w"),
    changed("initial motion of an unknown part", "part: bar, velocity", "part: baz, velocity", "baz", "bar"),
    changed("contact of unknown parts", "run:", "contact:\n  - {between: [bar, plate]}\nrun:", "plate"),
    changed("unknown curve", "run:", "gravity: {vector: [0, 0, -9.81], curve: rmp}\nrun:", "rmp"),
    changed("curve going back", "run:", "curves: {r: [[0, 0], [2, 1], [1, 0]]}\nrun:", "curves"),
    changed("rigid wall through the body", "run:", "rigid_walls:\n  - {point: [0, 0, 0.5], normal: [0, 0, 1]}\nrun:",
            "scene.yaml:15: rigid_walls.0", "passes through a body", "expected", lines=1),
    changed("rigid wall with the body behind it", "run:", "rigid_walls:\n  - {point: [0, 0, -1], normal: [0, 0, -1]}\nrun:",
            "rigid_walls.0.normal", "behind the wall", "expected", lines=1),
    changed("rigid wall without direction", "run:", "rigid_walls:\n  - {point: [0, 0, 0], normal: [0, 0, 0]}\nrun:", "normal"),
    changed("box of no elements", "{file: bar.msh}", "{box: {part: bar, size: [1, 1, 1], elements: [0, 1, 1]}}", "elements"),
    changed("box of half an element", "{file: bar.msh}", "{box: {part: bar, size: [1, 1, 1], elements: [1.5, 1, 1]}}", "elements", "1.5"),
    changed("sphere made coarser at its foot", "{file: bar.msh}", "{sphere: {part: bar, radius: 1, elements: 4, finer: 0.5}}", "finer", "a number >= 1"),
    changed("half of a sphere along w", "{file: bar.msh}", "{sphere: {part: bar, radius: 1, elements: 4, half: [x, w]}}", "half.1", "'w'"),
    changed("half of a sphere twice", "{file: bar.msh}", "{sphere: {part: bar, radius: 1, elements: 4, half: [x, x]}}", "half.1", "twice"),
    changed("the half of a sphere without its fine pole", "{file: bar.msh}", "{sphere: {part: bar, radius: 1, elements: 4, finer: 2, half: [z]}}", "mesh.sphere.half", "expected -z", lines=1),
    changed("sizes beyond the box", "{file: bar.msh}", "{box: {part: bar, size: [1, 1, 1], elements: [[[0, 0.1], [2, 0.1]], 1, 1]}}", "elements.0.1.0", "from 0 to 1", lines=1),
    changed("bias of one number", "{file: bar.msh}", "{box: {part: bar, size: [1, 1, 1], elements: [1, 1, 1], bias: 2}}", "bias", "3 numbers", lines=1),
    changed("sector of a cylinder", "{file: bar.msh}", "{cylinder: {part: bar, radius: 1, length: 1, elements: [4, 1], sector: [0, 5]}}", "sector", "inner_radius: 0", lines=1),
    changed("sector that closes", "{file: bar.msh}", "{tube: {part: bar, inner_radius: 0, outer_radius: 1, length: 1, elements: [4, 40, 1], sector: [0, 360]}}", "sector", "less than 360", lines=1),
    changed("nose without a length", "{file: bar.msh}", "{cylinder: {part: bar, radius: 1, length: 1, elements: [4, 1], nose: {shape: cone}}}", "nose", "half_angle", lines=1),
    changed("box without size", "{file: bar.msh}", "{box: {part: bar, size: [1, 0, 1], elements: [1, 1, 1]}}", "size"),
    changed("unknown body", "{file: bar.msh}", "{bx: {part: bar, size: [1, 1, 1], elements: [1, 1, 1]}}", "bx"),
    changed("probe of a node that is not there", "run:", "probes:\n  - {name: tip, node: 4711, field: velocity}\nrun:",
            "scene.yaml:15: probes.0.node", "4711", "expected", "from 1 to 8", lines=1),
    changed("node held in two ways", "fixed:", "prescribed: [{part: bar, dof: x, velocity: 1}]\nfixed:",
            "scene.yaml:12: prescribed.0", "fixed.0", "expected", lines=1),
    changed("probe of a part without a field", "run:", "probes:\n  - {name: p, part: bar}\nrun:", "scene.yaml:15: probes.0", "field", lines=1),
    changed("probe of the energy of a set", "run:", "probes:\n  - {name: p, set: foot, field: energy}\nrun:", "scene.yaml:15: probes.0.field", "energy", "reaction", lines=1),
    changed("probe near a place that is none", "run:", "probes:\n  - {name: p, near: [0, 0], field: velocity}\nrun:", "probes.0.near", lines=1),
    changed("probe near a place and of a node", "run:", "probes:\n  - {name: p, near: [0, 0, 0], node: 1, field: velocity}\nrun:", "probes.0", "2 places", "expected", lines=1),
    changed("section beside the body", "run:", "probes:\n  - {name: p, section: {part: bar, point: [9, 0, 0], normal: [1, 0, 0]}}\nrun:",
            "scene.yaml:15: probes.0.section", "intersects no element", "expected", lines=1),
    changed("section without a part", "run:", "probes:\n  - {name: p, section: {point: [0, 0, 0], normal: [1, 0, 0]}}\nrun:", "probes.0.section", "missing part", "expected", lines=1),
    changed("section without a normal", "run:", "probes:\n  - {name: p, section: {part: bar, point: [0, 0, 0]}}\nrun:", "probes.0.section", "normal", lines=1),
    changed("section of an unknown set", "run:", "probes:\n  - {name: p, section: {part: bar, set: food}}\nrun:", "probes.0.section.set", "food", "did you mean 'foot'", lines=1),
    changed("section by a set and a plane", "run:", "probes:\n  - {name: p, section: {part: bar, set: foot, point: [0, 0, 0]}}\nrun:", "probes.0.section", "both", "expected", lines=1),
    changed("force and total", "run:", "forces:\n  - {set: foot, force: [0, 0, 1], total: [0, 0, 1]}\nrun:", "scene.yaml:15: forces.0", "both given", "expected", lines=1),
    changed("no force", "run:", "forces:\n  - {set: foot}\nrun:", "scene.yaml:15: forces.0", "missing force", "expected", lines=1),
    changed("force of two components", "run:", "forces:\n  - {set: foot, force: [0, 1]}\nrun:", "forces.0.force", lines=1),
    changed("force on an unknown set", "run:", "forces:\n  - {set: food, force: [0, 0, 1]}\nrun:", "scene.yaml:15: forces.0.set", "food", "did you mean 'foot'", lines=1),
    changed("total over nodes without a face", "  foot: {part: bar, box: [[0, 0, 0], [1, 1, 0.01]]}", "  foot: {part: bar, box: [[0, 0, 0], [1, 1, 0.01]]}\n  edge: {part: bar, box: [[0, 0, 0], [0, 1, 0]]}\nforces: [{set: edge, total: [0, 0, 1]}]",
            "forces.0.set", "no exterior face", "expected", lines=1),
    changed("traction on nodes", "run:", "traction:\n  - {set: foot, value: [0, 0, 1]}\nrun:", "scene.yaml:15: traction.0.set", "unknown side set 'foot'", "expected", lines=1),
    changed("displacement that jumps", "run:", "curves: {c: [[0, 1], [1, 2]]}\nprescribed: [{set: foot, dof: y, displacement: c}]\nrun:",
            "scene.yaml:15: prescribed.0", "at t = 0 is 1", "expected", lines=1),
    changed("displacement that is a number", "run:", "prescribed: [{set: foot, dof: y, displacement: 0.1}]\nrun:", "prescribed.0.displacement", "curve", lines=1),
    changed("two motions of one node", "run:", "prescribed: [{set: foot, dof: y, velocity: 1, acceleration: 2}]\nrun:", "prescribed.0", "more than one kind of motion", "expected", lines=1),
    changed("no prescribed motion", "run:", "prescribed: [{set: foot, dof: y}]\nrun:", "prescribed.0", "expected", lines=1),
    changed("relaxation without a load", "run:", "relaxation: {}\nrun:", "scene.yaml:14: relaxation", "without loads", "expected", lines=1),
    changed("relaxation to nothing", "run:", "gravity: {vector: [0, 0, -9]}\nrelaxation: {tolerance: 0}\nrun:", "relaxation.tolerance", "0", lines=1),
    changed("relaxation in no steps", "run:", "gravity: {vector: [0, 0, -9]}\nrelaxation: {max_steps: 0}\nrun:", "relaxation.max_steps", "0", lines=1),
    changed("misspelt key of a relaxation", "run:", "gravity: {vector: [0, 0, -9]}\nrelaxation: {tolerence: 0.1}\nrun:", "tolerence", "tolerance", lines=1),
    changed("probe of an unknown field", "run:", "probes:\n  - {name: tip, node: 1, field: speed}\nrun:", "speed"),
]

TWO_BOXES = """\
units: SI
mesh:
  - {box: {part: left, size: [1, 1, 1], elements: [4, 4, 4]}}
  - {box: {part: right, size: [1, 1, 1], elements: [3, 3, 3], at: [0.4, 0.1, 0.1]}}
materials: {steel: {model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}}
parts: {left: {block: left, material: steel}, right: {block: right, material: steel}}
contact: [{between: all}]
run: {end: 1.0e-5}
"""

OPTIONS = [
    Wrong("no command", ["run"], command="", target=""),
    Wrong("misspelt command", ["chek"], command="chek"),
    Wrong("misspelt option", ["--ot"], command="run", arguments=["--ot", "x"]),
    Wrong("no scene given", ["scene is required", "--help"], command="run", target=""),
    Wrong("override of an unknown key", ["run.ent"], arguments=["--set", "run.ent=1"]),
    Wrong("override without a value", ["run.end"], arguments=["--set", "run.end"]),
    Wrong("override of the wrong type", ["run.end", "soon"], arguments=["--set", "run.end=soon"]),
    Wrong("override beyond a list", ["initial.7"], arguments=["--set", "initial.7.part=bar"]),
    Wrong("bodies overlap at the start", ["scene.yaml:7: contact.0", "node", "left", "inside", "right"], scene=TWO_BOXES, command="run"),
    Wrong("limit without place", ["scene.yaml:7: contact.0.limit", "initial_overlap: place"], lines=1,
          scene=TWO_BOXES.replace("between: all", "between: all, initial_overlap: move, limit: 0.1")),
    Wrong("negative limit", ["scene.yaml:7: contact.0.limit", "-1", "> 0"], lines=1,
          scene=TWO_BOXES.replace("between: all", "between: all, initial_overlap: place, limit: -1")),
    Wrong("tied parts to be placed", ["scene.yaml:7: contact.0.initial_overlap", "tied"], lines=1,
          scene=TWO_BOXES.replace("between: all", "between: [left, right], tied: true, initial_overlap: place")),
    Wrong("parts beyond the limit of place", ["scene.yaml:7: contact.0.limit", "would move part", "at most 0.01 m"], lines=1, command="run",
          scene=TWO_BOXES.replace("between: all", "between: all, initial_overlap: place, limit: 0.01")),
    Wrong("restart file is not there", ["missing.h5"], command="run", arguments=["--restart", "missing.h5"]),
    Wrong("restart from an empty folder", ["old"], command="run", arguments=["--restart", "old"], files={"old/x": b""}),
    Wrong("result folder where none can be", ["/proc/nope/x", "--out"], command="run", arguments=["--out", "/proc/nope/x"]),
    Wrong("restart from a file of another kind", ["bar.msh", "signature"], command="run", arguments=["--restart", "bar.msh"]),
    Wrong("result folder is there already", ["here.out", "--force"], command="run", arguments=["--out", "here.out"],
          files={"here.out/summary.json": b"precious"}, keeps=["here.out/summary.json"]),
    Wrong("result folder is a file", ["here.out"], command="run", arguments=["--out", "here.out"],
          files={"here.out": b"precious"}, keeps=["here.out"]),
    Wrong("result folder is the scene", ["scene.yaml"], command="run", arguments=["--out", "scene.yaml"],
          keeps=["scene.yaml"]),
    Wrong("partition into no ranks", ["-n", "'0'", "an integer"], command="partition", arguments=["-n", "0"]),
    Wrong("partition asked as mpirun is", ["-n", "'p'", "an integer"], command="partition", arguments=["-np", "2"]),
    Wrong("compare with nothing", ["missing"], command="compare", target="missing", arguments=["missing2"]),
]

SCRIPTS = wrong_scripts.cases(Wrong)

STUDY_RUNS, STUDY_SCENES = "scene: scene.yaml\nruns: {{{}: {{}}}}", "scenes: {{{}: scene.yaml}}\nruns: {{a: {{}}}}"

SCRIPTS += [  # before anything is built, run or drawn
    Wrong(f"{script} with a misspelt option", [script, option], command=script, target="", arguments=[option], lines=1)
    for script, option in (("test", "--halp"), ("demo", "--halp"), ("setup", "--halp"), ("tidy", "--halp"), ("run", "--halp"),
                           ("render", "--halp"), ("plot", "--halp"), ("report", "--halp"), ("study", "--halp"), ("pareto", "--halp"), ("submit", "--halp"))
] + [
    Wrong("test with a word too many", ["test", "'law'", "expected"], command="test", target="", arguments=["law"], lines=1),
    Wrong("test with an option cut short", ["test", "-R"], command="test", target="", arguments=["-R"], lines=1),
    Wrong("test on no number of cores", ["test", "-j", "expected"], command="test", target="", arguments=["-j"], lines=1),
    Wrong("tidy on no number of cores", ["tidy", "-j", "expected"], command="tidy", target="", arguments=["-j"], lines=1),
    Wrong("run with an option cut short", ["run", "--set", "expected"], command="run", arguments=["--set"], lines=1),
    Wrong("study with an option cut short", ["study", "-np"], command="study", arguments=["-np"], lines=1),
    Wrong("setup with a word too many", ["setup", "'x'"], command="setup", target="", arguments=["--list", "x"], lines=1),
    Wrong("demo with two scenes", ["demo", "'x'"], command="demo", arguments=["x"], lines=1),
    Wrong("run with a misspelt option of brunt", ["run", "--forse", "--force"], command="run", arguments=["--forse"], lines=1),
    Wrong("study on no ranks", ["study", "'0'", "an integer"], command="study", arguments=["-np", "0"], lines=1),
    Wrong("study that is not there", ["study", "nope.yaml"], command="study", target="nope.yaml", lines=1),
    Wrong("pareto that is not there", ["pareto", "nope.yaml"], command="pareto", target="nope.yaml", lines=1),
    Wrong("pareto on half a rank", ["pareto", "'0.5'", "an integer"], command="pareto", arguments=["-np", "0.5"], lines=1),
    Wrong("render in no colours", ["render", "--colours", "expected"], command="render", arguments=["--colours", "trubo"], lines=1),
    *(Wrong(f"render with {option} {value}", ["render", option, value, "expected"], command="render", arguments=[option, value], lines=1)
      for option, value in (("--azimuth", "nan"), ("--elevation", "inf"), ("--deform", "nan"), ("--zoom", "inf"), ("--time", "nan"))),
    Wrong("render in a range of nan", ["render", "--range", "nan", "expected"], command="render", arguments=["--range", "nan", "1"], lines=1),
    *(Wrong(f"study with {key} named {name}", ["study", f"{key}.{name}", "of a folder", "expected"], command="study", target="s.yaml",
            files={"s.yaml": f"{text.format(name)}\ncolumns: [elements]\n".encode()}, lines=1)
      for key, name, text in (("runs", "../x", STUDY_RUNS), ("runs", "/tmp/x", STUDY_RUNS), ("runs", "..", STUDY_RUNS), ("scenes", "../x", STUDY_SCENES))),
    Wrong("render of no size", ["render", "--size", "expected"], command="render", arguments=["--size", "0", "0"], lines=1),
]

def inp(*elements, more=""):
    """An Abaqus file of the cube's nodes and of (type, element set, lines)."""
    lines = ["*NODE"] + [f"{i}, {x}, {y}, {z}" for i, (x, y, z) in enumerate(mesh.CUBE, 1)]
    for kind, name, rows in elements:
        lines += [f"*ELEMENT, TYPE={kind}, ELSET={name}"] + rows
    return ("\n".join(lines) + "\n" + more).encode()


CUBE_8, BOMB = "1, 2, 3, 4, 5, 6, 7, 8", "".join(f"x{i}: &x{i} [{', '.join(['*x%d' % (i - 1) if i else 'x'] * 9)}]\n" for i in range(9))
RING = "{file: bar.msh}", "{tube: {part: bar, inner_radius: 1, outer_radius: 2, length: 1, elements: [1, %d, 1], %s}}"

YAML_LIMITS = [
    Wrong("an alias within its own anchor", ["scene.yaml:1", "within its own anchor", "expected"], scene="a: &a {b: *a}\n", lines=1),
    changed("sets within themselves", "sets:\n  foot:", "sets: &c\n  all: *c\n  foot:", "scene.yaml:9", "within its own anchor", lines=1),
    Wrong("aliases of aliases", ["scene.yaml:6", "repeat", "100000", "expected"], scene=BOMB, lines=1),
    Wrong("a hundred thousand brackets", ["scene.yaml:1", "64 nested levels"], scene="a: " + "[" * 100000, lines=1),
    *(Wrong(f"an override that {what}", ["run.end", *says], arguments=["--set", f"run.end={value}"], lines=1)
      for what, value, says in (("names itself", "&a [*a]", ["within its own anchor"]), ("is deep", "[" * 280, ["64 nested levels"]), ("is open", "[1", ["YAML"]))),
    changed("a title with a colon", "title: one cube", "title: one: a cube", "scene.yaml:1", "expected quotes", 'title: "one: a cube', lines=1),
    changed("no blank behind a colon", "density: 7800", "density:7800", "scene.yaml:5", "density: 7800", lines=1),
    changed("a quote left open", "title: one cube", "title: 'one cube", "scene.yaml:1", "missing closing quote", lines=1),
    changed("a bracket left open", "[x]}", "[x}", "scene.yaml:13", "'['", lines=1),
    changed("a comma left out in a map", "material: steel, ", "material: steel ", "scene.yaml:7", "expected", lines=1),
]

MESHES = [
    *(changed(f"a torus with {what}", "{file: bar.msh}", f"{{torus: {{part: bar, radius: {radius}, tube: {tube}, elements: [{around}, 20, 2]}}}}", key, "expected", lines=1)
      for what, radius, tube, around, key in (("a wall of no thickness", 76, "[24, 24]", 40, "torus.tube"), ("no hole", 24, "[19, 24]", 40, "torus.radius"), ("two elements around", 76, "[19, 24]", 2, "torus.elements"))),
    changed("half of a tube along its axis", RING[0], RING[1] % (8, "half: [z]"), "half.0", "'z'", "x, -x, y, -y", lines=1),
    changed("half of a tube of odd elements", RING[0], RING[1] % (7, "half: [x]"), "elements", "7", "multiple of 2", lines=1),
    changed("quarter of a tube that has none", RING[0], RING[1] % (6, "half: [x, -y]"), "elements", "6", "multiple of 4", lines=1),
    changed("quarter of one side", RING[0], RING[1] % (8, "quarter: [x]"), "quarter", "two of", lines=1),
    changed("half of both sides", RING[0], RING[1] % (8, "half: [x, -x]"), "half.1", "twice", lines=1),
    changed("half and quarter", RING[0], RING[1] % (8, "half: [x], quarter: [x, y]"), "quarter", "together with half", lines=1),
    *(changed(f"a body at {at}", "{file: bar.msh}", f"{{box: {{part: bar, size: [1, 1, 1], elements: [4, 4, 4], at: [0, {at}, 0]}}}}", "scene.yaml:3", "rounding", "expected", lines=1)
      for at in ("1.0e10", "-1.0e12", "1.0e15", "1.0e17", "1.0e60")),
    *(changed(f"a file at {at} scaled by {scale}", "{file: bar.msh}", f"{{file: bar.msh, scale: {scale}, at: [{at}, 0, 0]}}", "scene.yaml:3", "expected", lines=1)
      for at, scale in (("2.0e10", 1), ("1.0e300", 1), ("0", "1.0e-120"), ("0", "1.0e120"), ("1.0", "1.0e-11"))),
    with_mesh("twins on the same nodes", mesh.gmsh(elements=[mesh.RIGHT, mesh.RIGHT]), "element 2", "nodes of element 1", "bar", "expected"),
    with_mesh("twins, one of them turned", mesh.gmsh(elements=[mesh.RIGHT, [2, 3, 4, 1, 6, 7, 8, 5]]), "element 2", "nodes of element 1"),
    with_mesh("twins in Exodus", mesh.exodus(elements=[mesh.RIGHT, mesh.RIGHT]), "element 2", "nodes of element 1", file="bar.exo"),
    with_mesh("twins of two blocks", inp(("C3D8", "bar", ["1, " + CUBE_8]), ("C3D8R", "two", ["2, " + CUBE_8])), "element 2 (block two)", "element 1 (block bar)", file="bar.inp"),
    Wrong("twins of two files", ["scene.yaml:3: mesh", "block bar and block b_bar", "coincide"], ("{file: bar.msh}", "[{file: bar.msh}, {file: bar.msh, prefix: b_}]"), lines=1),
    with_mesh("a shell in the mesh", inp(("C3D8", "bar", ["1, " + CUBE_8]), ("S4R", "skin", ["2, 1, 2, 3, 4"])), "missing part for block 2 (skin)", "ignore: [skin]", file="bar.inp"),
    with_mesh("a surface that is no face", msh.replace(b"$Elements\n1\n", b"$Elements\n2\n7 3 2 9 1 1 2 7 8\n"), "missing part for block 9", "ignore: [9]"),
    Wrong("a block to ignore that is not there", ["scene.yaml:3", "unknown block 'skin'", "expected 1 (bar)"], change=("{file: bar.msh}", "{file: bar.msh, ignore: [skin]}"), lines=1),
    Wrong("a part of an ignored block", ["parts.bar.block", "ignore of the mesh excludes it"], change=("{file: bar.msh}", "{file: bar.inp, ignore: [bar]}"),
          files={"bar.inp": inp(("C3D8", "bar", ["1, " + CUBE_8]), ("C3D4", "tip", ["2, 1, 2, 4, 5"]))}),
    Wrong("every block ignored", ["bar.msh", "excludes every block"], change=("{file: bar.msh}", "{file: bar.msh, ignore: [1]}"), lines=1),
    Wrong("a block ignored twice", ["mesh.ignore.1", "twice"], change=("{file: bar.msh}", "{file: bar.msh, ignore: [x, x]}"), lines=1),
    with_mesh("an included file is not there", inp(more="*INCLUDE, INPUT=no/elements.inp\n"), "bar.inp:10", "no/elements.inp", "does not exist", file="bar.inp"),
    with_mesh("a file that includes itself", inp(more="*INCLUDE, INPUT=bar.inp\n"), "bar.inp:10", "includes itself", file="bar.inp"),
    Wrong("a fault of an included file", ["scene.yaml:3", "sub/e.inp:2", "unknown node 99"], change=("bar.msh", "bar.inp"), lines=1,
          files={"bar.inp": inp(more="*INCLUDE, INPUT=sub/e.inp\n"), "sub/e.inp": b"*ELEMENT, TYPE=C3D8, ELSET=bar\n1, 1, 2, 3, 4, 5, 6, 7, 99\n"}),
]

STUDIES = [
    Wrong(f"{script} of {what}", [script, *says, "expected"], command=script, target="s.yaml", files={"s.yaml": text.encode()}, lines=1)
    for script in ("study", "pareto")
    for what, text, says in (("an alias within its anchor", "runs: &a {b: *a}\n", ["line 1", "within its own anchor"]),
                             ("aliases of aliases", BOMB, ["line 6", "repeat"]), ("many brackets", "runs: " + "[" * 5000, ["line 1", "64 nested levels"]))
]
SCRIPTS += STUDIES
ALL = FILES + METALS + SCENES + OPTIONS + YAML_LIMITS + MESHES + wrong_depths.cases(Wrong) + wrong_joints.cases(Wrong) + wrong_shells.cases(Wrong)
