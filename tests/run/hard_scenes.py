# SPDX-License-Identifier: Apache-2.0
"""Scenes of the hard cases E1 to E20, for runs on several ranks; their criteria are held in tests/hard."""
import math


def box(part, size, elements, at):
    return f"{{box: {{part: {part}, size: {list(size)}, elements: {list(elements)}, at: {list(at)}}}}}"


def moved(origin, *offset):
    return [a + b for a, b in zip(origin, offset)]


# E1: a heavy body meets one of a millionth of its mass, which lies askew of its mesh
MASS_RATIO = """\
units: none
mesh: [{heavy_box}, {light_box}]
materials:
  h: {{model: elastic, density: {heavy_density}, young: {young}, poisson: 0.3}}
  l: {{model: elastic, density: {light_density}, young: {young}, poisson: 0.3}}
parts: {{heavy: {{material: h}}, light: {{material: l}}}}
initial: [{{part: heavy, velocity: [0, 0, {speed}]}}]
contact: [{{between: all}}]
run: {{end: {end}}}
history: {{every: {every}}}
"""
BY_DENSITY = MASS_RATIO.format(heavy_box=box("heavy", (1, 1, 1), (3, 3, 3), (0, 0, -1)), heavy_density=1e6, light_density=1,
                               light_box=box("light", (1, 1, 1), (3, 3, 3), (0.13, -0.21, 1e-4)), young=1e10, speed=1,
                               end=3e-4, every=5e-6)
BY_SIZE = MASS_RATIO.format(heavy_box=box("heavy", (1, 1, 1), (4, 4, 4), (0, 0, -1)), heavy_density=7800, light_density=7800,
                            light_box=box("light", (0.01, 0.01, 0.01), (2, 2, 2), (0.3, 0.245, 1e-5)), young=2e11,
                            speed=math.sqrt(2 * 9.81 * 0.1), end=3e-5, every=1e-6)

# E11: a block sticks while its load along the plane swings to 99 % of the limit of friction
SWING = """\
units: none
mesh: {mesh}
materials: {{m: {{model: elastic, density: 1000, young: 1.0e7, poisson: 0.3}}}}
parts: {parts}
damping: {{alpha: 1000}}
{below}
curves: {{press: [[0, 0], [0.01, 1]], swing: {swing}}}
pressure: [{{set: block_zmax, value: 1000, curve: press}}]
gravity: {{vector: [24.75, 0, 0], curve: swing}}
probes: [{{name: block, part: block, field: position}}]
run: {{end: {end}}}
history: {{every: 1.0e-3}}
"""
BLOCK = box("block", (0.1, 0.1, 0.02), (4, 4, 2), (0, 0, 0))
PLATE = box("plate", (0.14, 0.14, 0.02), (5, 5, 1), (-0.02, -0.02, -0.02))


def swing(mesh, parts, below, cycles):
    rest, period = 0.02, 0.01
    points = [[0, 0], [rest, 0]]
    points += [[rest + (k + 1) * period / 24, math.sin(2 * math.pi * (k + 1) / 24)] for k in range(24 * cycles)]
    return SWING.format(mesh=mesh, parts=parts, below=below, swing=points, end=rest + cycles * period)


ON_WALL = swing(f"[{BLOCK}]", "{block: {material: m}}",
                "rigid_walls: [{name: floor, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.5}]", 3)
ON_PLATE = swing(f"[{BLOCK}, {PLATE}]", "{block: {material: m}, plate: {material: m}}",
                 "fixed: [{set: plate_zmin, dofs: [x, y, z]}]\ncontact: [{between: [block, plate], friction: 0.5}]", 3)

# E16: an impact, and two blocks pressed together, 1e6 m from the origin with elements of 1 mm
FAR = (1e6, -1e6, 1e6)
FAR_IMPACT = f"""\
units: SI
mesh: [{box("left", (0.02, 0.001, 0.001), (20, 1, 1), FAR)}, {box("right", (0.02, 0.001, 0.001), (20, 2, 2), moved(FAR, 0.02, 0, 0))}]
materials: {{m: {{model: elastic, density: 8000, young: 2.0e11, poisson: 0}}}}
parts: {{left: {{material: m}}, right: {{material: m}}}}
initial: [{{part: left, velocity: [10, 0, 0]}}]
contact: [{{between: all}}]
run: {{end: 1.2e-5}}
history: {{every: 4.0e-7}}
"""
UNIT = 1 / 4096  # multiples are exact 1e6 m away
FAR_PRESS = f"""\
units: none
mesh:
  - {box("lower", (12 * UNIT, 6 * UNIT, 2 * UNIT), (3, 3, 1), FAR)}
  - {box("upper", (12 * UNIT, 6 * UNIT, 2 * UNIT), (4, 3, 1), moved(FAR, 0, 6 * UNIT, 0))}
materials: {{m: {{model: elastic, density: 1, young: 1, poisson: 0.3}}}}
parts: {{lower: {{material: m, element: hex8_full}}, upper: {{material: m, element: hex8_full}}}}
fixed: [{{set: lower_ymin, dofs: [y]}}]
symmetry:
  - {{point: {list(FAR)}, normal: [1, 0, 0]}}
  - {{point: {list(FAR)}, normal: [0, 0, 1]}}
  - {{point: {moved(FAR, 0, 0, 2 * UNIT)}, normal: [0, 0, -1]}}
curves: {{ramp: [[0, 0], [0.073, 1]]}}
pressure: [{{set: upper_ymax, value: 1.0e-4, curve: ramp}}]
damping: {{alpha: 680}}
contact: [{{between: [lower, upper], slave: upper, tolerance: 1.0e-6}}]
run: {{end: 0.09}}
history: {{every: 1.0e-3}}
"""

# Two bodies at 1 unit of length and a wave speed of 32 to 37
PAIR = """\
units: none
mesh:
  - {{box: {{part: low, {low}}}}}
  - {{box: {{part: top, {top}}}}}
materials: {{m: {{model: elastic, density: 1, young: 1000, poisson: 0.3}}}}
parts: {{low: {{material: m}}, top: {{material: m}}}}
initial: [{{part: top, velocity: {velocity}}}]
contact: [{{between: all{contact}}}]
run: {{end: {end}}}
history: {{every: {every}}}
"""


def pair(low, top, velocity, end, contact=""):
    return PAIR.format(low=low, top=top, velocity=velocity, end=end, every=end / 40, contact=contact)


# E2: cubes on their vertices, one straight above the other but for 1e-6
STANDING = "size: [1, 1, 1], elements: [2, 2, 2], rotate: {axis: [1, -1, 0], degrees: 54.7356}"
CORNERS = pair(f"{STANDING}, at: [0, 0, -1.7320509]", f"{STANDING}, at: [1.0e-6, 0, 1.0e-4]", [0, 0, -2], 0.08)

# E3: bars that cross on their edges, no node near a face
CROSSED = pair("size: [8, 1, 1], elements: [8, 1, 1], rotate: {axis: [1, 0, 0], degrees: 45}, at: [-4.3, 0, -1.4143]",
               "size: [1, 8, 1], elements: [1, 8, 1], rotate: {axis: [0, 1, 0], degrees: 45}, at: [-0.8, -3.8, 0.7072]",
               [0, 0, -2], 0.15)

# E5: blocks that begin a tenth of an element inside each other
OVERLAPPING = pair("size: [1, 1, 1], elements: [3, 3, 3]", "size: [1, 1, 1], elements: [4, 4, 4], at: [0.13, -0.21, 0.97]",
                   [0, 0, 0], 0.3, ", initial_overlap: warn")

# E9: a small block slides through a tube of facets ten times its size
FACETS = """\
units: none
mesh:
  - {tube: {part: valley, inner_radius: 16, outer_radius: 17, length: 1, elements: [1, 96, 1]}}
  - {box: {part: block, size: [0.1, 0.1, 0.1], elements: [1, 1, 1], at: [0.05, -15.98, 0.45]}}
materials: {m: {model: elastic, density: 1, young: 1000, poisson: 0.3}}
parts: {valley: {material: m}, block: {material: m}}
fixed: [{set: valley_side, dofs: [x, y, z]}]
initial: [{part: block, velocity: [3, 0, 0]}]
gravity: {vector: [0, -10, 0]}
damping: {alpha: 1}
contact: [{between: all}]
run: {end: 1}
history: {every: 0.02}
"""

# E14: flat on flat at a gap of rounding, meshes a third of an element apart
FLUSH = pair("size: [3, 3, 1], elements: [3, 3, 1]", "size: [2, 2, 1], elements: [2, 2, 1], at: [0.3333333333, 0.3333333333, 1.000000000001]",
             [0, 0, -1], 0.05)

# E15: elements a hundred times smaller than those they meet
HUNDREDTH = pair("size: [2, 2, 1], elements: [2, 2, 1]",
                 "size: [0.2, 0.2, 0.04], elements: [20, 20, 4], at: [0.93, 0.87, 1.001]", [0, 0, -2], 0.004)

# E20: a tied pair of unlike meshes that spins
TIED_SPIN = """\
units: none
mesh:
  - {box: {part: low, size: [1, 1, 1], elements: [3, 3, 3], at: [-0.5, -0.5, -1]}}
  - {box: {part: top, size: [1, 1, 1], elements: [2, 2, 2], at: [-0.5, -0.5, 0]}}
materials: {m: {model: elastic, density: 1, young: 1000, poisson: 0.3}}
parts: {low: {material: m}, top: {material: m}}
initial:
  - {part: low, rotation: {axis: [0.2, 0, 1], point: [0, 0, 0], rate: 2}}
  - {part: top, rotation: {axis: [0.2, 0, 1], point: [0, 0, 0], rate: 2}}
contact: [{between: [low, top], tied: true}]
run: {end: 0.5}
history: {every: 0.02}
"""
