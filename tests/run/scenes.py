# SPDX-License-Identifier: Apache-2.0
"""Small scenes, with meshes written here, that use much of the program at once."""
import itertools
import math

# A cube of hexahedra, on it one of tetrahedra, beside it one of fully integrated hexahedra.
EDGE = 3  # elements along an edge of a cube


def node_grid(nx, ny, nz, at):
    return [(at[0] + i / nx, at[1] + j / ny, at[2] + k / nz) for k in range(nz + 1) for j in range(ny + 1)
            for i in range(nx + 1)]


def hexahedra(n, first):
    def node(i, j, k):
        return first + i + (n + 1) * (j + (n + 1) * k)
    return [[node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k), node(i, j, k + 1),
             node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)]
            for k in range(n) for j in range(n) for i in range(n)]


def tetrahedra(hexes):
    ring = [1, 2, 3, 7, 4, 5, 1]  # six around the diagonal 0-6
    return [[h[0], h[ring[k]], h[ring[k + 1]], h[6]] for h in hexes for k in range(6)]


def wedges(hexes):
    """Two a hexahedron, cut from edge 0-4 to edge 2-6; as hexahedra that name two nodes twice."""
    return [w for a, b, c, d, e, f, g, h in hexes for w in ([a, b, c, c, e, f, g, g], [a, c, d, d, e, g, h, h])]


def pair_mesh(of_hexahedra):
    """Gmsh 2.2: block low (hexahedra), above it block top, made of hexahedra by `of_hexahedra`."""
    grids = [node_grid(EDGE, EDGE, EDGE, at) for at in ((0, 0, 0), (0.1, 0.15, 1.001))]
    nodes = [x for grid in grids for x in grid]
    blocks = [hexahedra(EDGE, 1), of_hexahedra(hexahedra(EDGE, 1 + len(grids[0])))]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "2", '3 1 "low"', '3 2 "top"',
             "$EndPhysicalNames", "$Nodes", str(len(nodes))]
    lines += [f"{i} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(nodes, 1)] + ["$EndNodes", "$Elements"]
    elements = [(b + 1, e) for b, block in enumerate(blocks) for e in block]
    lines += [str(len(elements))]
    lines += [f"{i} {4 if len(e) == 4 else 5} 2 {b} {b} " + " ".join(map(str, e)) for i, (b, e) in enumerate(elements, 1)]
    return "\n".join(lines + ["$EndElements", ""])


def mixed_mesh():
    """Gmsh 2.2: blocks low (hexahedra), beside (hexahedra), top (tetrahedra, a small gap above low)."""
    places = [(0, 0, 0), (1.001, 0, 0), (0, 0, 1.001)]
    grids = [node_grid(EDGE, EDGE, EDGE, at) for at in places]
    nodes = [x for grid in grids for x in grid]
    blocks = [hexahedra(EDGE, 1 + b * len(grids[0])) for b in range(3)]
    blocks[2] = tetrahedra(blocks[2])
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "4", '3 1 "low"', '3 2 "beside"', '3 3 "top"',
             '2 4 "load"', "$EndPhysicalNames", "$Nodes", str(len(nodes))]
    lines += [f"{i} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(nodes, 1)] + ["$EndNodes", "$Elements"]
    elements = [(b + 1, e) for b, block in enumerate(blocks) for e in block]
    elements += [(4, h[4:8]) for h in blocks[1][-EDGE * EDGE:]]  # the upper side of `beside`
    kind = {(4, True): 3, (4, False): 4, (8, False): 5}  # by nodes and whether it is a face
    lines += [str(len(elements))]
    lines += [f"{i} {kind[len(e), b == 4]} 2 {b} {b} " + " ".join(map(str, e)) for i, (b, e) in enumerate(elements, 1)]
    return "\n".join(lines + ["$EndElements", ""])


def fork(overlap):
    """Gmsh 2.2: block fork, two arms whose inner sides are bent into each other by so much."""
    nx, ny, nz = 8, 2, 5
    nodes = []
    for k, j, i in itertools.product(range(nz + 1), range(ny + 1), range(nx + 1)):
        bent = (1 + overlap) * min(max(0.5 * (i - 2), 0), 1) if k > 2 else 0  # the upper arm, wholly from x = 4 on
        nodes.append((i, j, k - bent))
    return gmsh((nx, ny, nz), nodes, lambda i, k: k != 2 or i < 2)


def bent_ring(overlap):
    """Gmsh 2.2: block fork, a bar bent into a ring of chords whose ends lie in each other by so much."""
    nx, ny, nz = 12, 2, 2
    nodes = []
    for k, j, i in itertools.product(range(nz + 1), range(ny + 1), range(nx + 1)):
        radius, angle = 2 + 0.5 * k / nz, (2 * math.pi + overlap / 2.25) * i / nx
        nodes.append((radius * math.sin(angle), j / ny, radius * math.cos(angle)))
    return gmsh((nx, ny, nz), nodes, lambda i, k: True)


def gmsh(counts, nodes, has_element):
    """A file with the block fork, of a grid of nodes, x fastest."""
    nx, ny, nz = counts
    corners = [0, 1, nx + 2, nx + 1]
    corners += [c + (nx + 1) * (ny + 1) for c in corners]
    elements = [[1 + i + (nx + 1) * (j + (ny + 1) * k) + c for c in corners]
                for k in range(nz) for j in range(ny) for i in range(nx) if has_element(i, k)]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "1", '3 1 "fork"', "$EndPhysicalNames", "$Nodes",
             str(len(nodes))]
    lines += [f"{i} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(nodes, 1)] + ["$EndNodes", "$Elements"]
    lines += [str(len(elements))] + [f"{i} 5 2 1 1 " + " ".join(map(str, e)) for i, e in enumerate(elements, 1)]
    return "\n".join(lines + ["$EndElements", ""])


MIXED = """\
title: three kinds of element in contact
units: SI
mesh:
  - {file: mixed.msh}
  - {box: {part: floor, size: [3, 4, 0.5], elements: [3, 4, 1], at: [-1, -1, -0.501]}}
materials:
  soft: {model: j2, density: 1000, young: 1.0e6, poisson: 0.3, yield: 2.0e3, hardening: 1.0e5}
  hard: {model: elastic, density: 2000, young: 1.0e7, poisson: 0.2}
parts:
  low: {block: low, material: soft, element: hex8}
  beside: {block: beside, material: hard, element: hex8_full}
  top: {block: top, material: soft, element: tet4}
  floor: {block: floor, material: hard}
sets:
  under: {part: floor, box: [[-9, -9, -0.6], [9, 9, -0.5]]}
  lid: {part: top, box: [[-9, -9, 2], [9, 9, 9]]}
curves: {ramp: [[0, 0], [0.01, 1]]}
initial:
  - {part: low, velocity: [0.5, 0, -1]}
  - {part: top, velocity: [0, 0, -2]}
fixed: [{set: under, dofs: [x, z]}]
symmetry: [{point: [0, 0, 0], normal: [0, 1, 0]}]
prescribed: [{set: lid, dof: x, velocity: ramp, scale: 0.5}]
pressure: [{set: load, value: 1.0e3, curve: ramp}]
gravity: {vector: [0, 0, -9.81]}
rigid_walls: [{name: stop, point: [2.01, 0, 0], normal: [-1, 0, 0]}]
contact: [{between: all, exclude: [[beside, floor]]}]
probes: [{name: wall, wall: stop}, {name: held, set: under, field: reaction}, {name: lid, set: lid, field: velocity}]
run: {end: 0.04}
output: {every: 0.01, fields: [displacement, velocity, stress, plastic_strain]}
history: {every: 0.001}
"""

LONG = """\
units: SI
mesh: {box: {part: cube, size: [1, 1, 1], elements: [4, 4, 4]}}
materials: {steel: {model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}}
parts: {cube: {block: cube, material: steel}}
initial: [{part: cube, velocity: [0, 0, -1]}]
run: {steps: 100000000}
"""

ENERGY_FROM_NOWHERE = LONG.replace("velocity: [0, 0, -1]", "velocity: [0, 0, -1.0e8]").replace(
    "run:", "rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1]}]\nrun:")

# An elastic cube that hits a wall as fast as its waves: crushed after some hundred steps.
INVERTED_LATER = LONG.replace("velocity: [0, 0, -1]", "velocity: [0, 0, -5.0e3]").replace("poisson: 0.3", "poisson: 0").replace(
    "material: steel}", "material: steel, bulk: {linear: 0, quadratic: 0}}").replace(
    "run:", "rigid_walls: [{point: [0, 0, -1], normal: [0, 0, 1]}]\nrun:")

# Two cubes; the right one stands at x = AT.
PAIR = """\
units: SI
mesh:
  - {box: {part: left, size: [1, 1, 1], elements: [8, 8, 8]}}
  - {box: {part: right, size: [1, 1, 1], elements: [6, 6, 6], at: [AT, 0.1, 0.1]}}
materials: {steel: {model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}}
parts: {left: {block: left, material: steel}, right: {block: right, material: steel}}
contact: [{between: all, initial_overlap: RULE}]
run: {steps: 1}
"""

# Rubber parts a little too thick for their seats, which slide along them from the start: nodes that come to the seat later overlap.
SLIDING_FITS = {"slot": """\
units: SI
mesh:
  - {box: {part: bar, size: [0.0206, 0.02, 0.04], elements: [4, 2, 8], at: [-0.0103, 0.0, -0.005]}}
  - {box: {part: left, size: [0.02, 0.03, 0.02], elements: [2, 2, 4], at: [-0.03, -0.005, 0]}}
  - {box: {part: right, size: [0.02, 0.03, 0.02], elements: [2, 2, 4], at: [0.01, -0.005, 0]}}
materials: {rubber: {model: neo_hookean, density: 1000, young: 1.0e7, poisson: 0.45}}
parts: {bar: {material: rubber}, left: {material: rubber}, right: {material: rubber}}
sets: {outer: {part: left, box: [[-1, -1, -1], [-0.0299, 1, 1]]}, other: {part: right, box: [[0.0299, -1, -1], [1, 1, 1]]}}
fixed: [{set: outer, dofs: [x, y, z]}, {set: other, dofs: [x, y, z]}]
initial: [{part: bar, velocity: [0, 0, -1]}]
contact: [{between: all, initial_overlap: RULE}]
run: {end: 6.0e-3}
""", "hole": """\
units: SI
mesh:
  - {tube: {part: hole, inner_radius: 0.01, outer_radius: 0.02, length: 0.02, elements: [2, 24, 6]}}
  - {cylinder: {part: peg, radius: 0.0102, length: 0.02, elements: [4, 6], at: [0, 0, 0.005]}}
materials: {rubber: {model: neo_hookean, density: 1000, young: 1.0e7, poisson: 0.45}}
parts: {hole: {material: rubber}, peg: {material: rubber}}
sets: {bed: {part: hole, box: [[-1, -1, -1], [1, 1, 1.0e-5]]}}
fixed: [{set: bed, dofs: [x, y, z]}]
initial: [{part: peg, velocity: [0, 0, -1]}]
contact: [{between: all, initial_overlap: RULE}]
run: {end: 3.0e-3}
"""}

# A steel ball on a plate at 500 m/s: corners of the ball's one-point elements fold.
FAST_BALL = """\
units: SI
mesh:
  - {plate: {part: plate, size: [0.06, 0.06], thickness: 0.004, elements: [20, 20, 2]}}
  - {sphere: {part: ball, radius: 0.006, elements: 5, at: [0.0005, 0.0007, 0.0102]}}
materials: {steel: {model: j2, density: 7800, young: 2.0e11, poisson: 0.3, yield: 4.0e8, hardening: 5.0e8}}
parts: {plate: {material: steel, hourglass: {kind: stiffness}}, ball: {material: steel, hourglass: {kind: stiffness}}}
initial: [{part: ball, velocity: [0, 0, -500]}]
contact: [{between: all}]
run: {end: 1.2e-5}
output: {every: 1.0e-6}
"""

# One ring in another, both of chords: nodes of each lie behind the other's faces.
RINGS = """\
units: none
mesh:
  - {tube: {part: outer, inner_radius: 1, outer_radius: 1.2, length: 0.3, elements: [2, 24, 3]}}
  - {tube: {part: inner, inner_radius: 0.8, outer_radius: 1, length: 0.3, elements: [2, 36, 4], at: [0, 0, 0.02],
            rotate: {axis: [0, 0, 1], degrees: 3}}}
materials: {m: {model: elastic, density: 1, young: 100, poisson: 0.3}}
parts: {outer: {material: m}, inner: {material: m}}
contact: [{between: all, initial_overlap: offset}]
run: {steps: 1000}
"""

# Rubber cubes that meet aside of each other, with friction: what is touched by either side's nodes.
RUBBER = """\
units: SI
mesh:
  - {box: {part: low, size: [0.01, 0.01, 0.01], elements: [3, 3, 3]}}
  - {box: {part: top, size: [0.01, 0.01, 0.01], elements: [4, 4, 4], at: [0.001, 0.002, 0.01001]}}
materials: {rubber: {model: neo_hookean, density: 1000, young: 6.0e6, poisson: 0.45}}
parts: {low: {material: rubber, element: hex8_full}, top: {material: rubber, element: hex8_full}}
initial: [{part: top, velocity: [2, 0, -5]}]
contact: [{between: all, friction: 0.3, passes: two, method: METHOD}]
run: {steps: 60}
"""

# The rings tied, where their chords are apart and where they lie in each other; they spin and tilt.
TIED_RINGS = RINGS.replace("contact: [{between: all, initial_overlap: offset}]", """initial:
  - {part: outer, rotation: {axis: [0, 0.3, 1], rate: 2}}
  - {part: inner, rotation: {axis: [0, 0.3, 1], rate: 2}, velocity: [0, 0, 0.1]}
contact: [{between: [outer, inner], tied: true}]""").replace("steps: 1000", "steps: 80")

# A fork whose arms lie inside each other, at rest.
FORK = """\
units: none
mesh: {file: fork.msh}
materials: {m: {model: elastic, density: 1, young: 100, poisson: 0.3}}
parts: {fork: {material: m}}
contact: [{between: all}]
run: {steps: 50}
"""

# A body at rest, hit by a wall that brings the energy.
PUSHED_BY_WALL = """units: none
mesh: {box: {part: b, size: [1, 1, 1], elements: [2, 2, 2], at: [0, 0, 0.02]}}
materials: {m: {model: elastic, density: 1, young: 100, poisson: 0.3}}
parts: {b: {material: m}}
curves: {push: [[0, 1], [1, 1]]}
rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1], motion: push}]
run: {end: 0.2}
"""

# Two flat plates at rest, one just above the other: both together thinner than the capture of a face.
FLAT_PLATES_AT_REST = """units: none
mesh:
  - {plate: {part: a, size: [4, 4], thickness: 0.1, elements: [4, 4, 1]}}
  - {plate: {part: b, size: [4, 4], thickness: 0.1, elements: [4, 4, 1], at: [0.3, 0.2, 0.105]}}
materials: {m: {model: elastic, density: 1, young: 100, poisson: 0.3}}
parts: {a: {material: m}, b: {material: m}}
contact: [{between: all}]
run: {steps: 20}
"""

# E12: the vertex of a hard cube is driven into one soft element, at 500 m/s.
SPEAR = """\
units: SI
mesh:
  - {box: {part: target, size: [0.01, 0.01, 0.01], elements: [1, 1, 1]}}
  - {box: {part: spear, size: [0.02, 0.02, 0.02], elements: [1, 1, 1], rotate: {axis: [1, -1, 0], degrees: 54.7356}, at: [0.005, 0.005, 0.0101]}}
materials:
  soft: {model: LAW, density: 8000, young: 2.0e9, poisson: 0.3}
  hard: {model: elastic, density: DENSITY, young: 2.0e11, poisson: 0.3}
parts: {target: {material: soft, element: KIND}, spear: {material: hard}}
sets: {foot: {part: target, box: [[-1, -1, -0.001], [1, 1, 0.001]]}}
fixed: [{set: foot, dofs: [x, y, z]}]
initial: [{part: spear, velocity: [0, 0, -SPEED]}]
contact: [{between: [target, spear], slave: spear}]
run: {end: 1.0e-4}
"""

# E12: a bar pressed to a twentieth of its length at t = 9.5e-3, to nothing at 1e-2.
PRESSED = """\
units: SI
mesh: {box: {part: bar, size: [0.01, 0.01, 0.1], elements: [1, 1, 10]}}
materials: {soft: {model: LAW, density: 1000, young: 1.0e6, poisson: 0.0}}
parts: {bar: {material: soft, element: KIND}}
sets:
  all: {part: bar}
  foot: {part: bar, box: [[-1, -1, -0.001], [1, 1, 0.001]]}
  top: {part: bar, box: [[-1, -1, 0.099], [1, 1, 0.101]]}
fixed: [{set: foot, dofs: [z]}, {set: all, dofs: [x, y]}]
curves: {press: [[0, -10], [1, -10]]}
prescribed: [{set: top, dof: z, velocity: press}]
run: {end: END}
"""

# A rod over a table, with everything that can be held or loaded.
ROD = """\
units: SI
mesh:
  - {cylinder: {part: rod, radius: 1, length: 5, elements: [6, 5], at: [0, 0, 0.5]}}
  - {box: {part: table, size: [10, 10, 0.5], elements: [2, 2, 1], at: [-5, -5, -0.5]}}
materials: {steel: {model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}}
parts: {rod: {material: steel}, table: {material: steel}}
sets: {foot: {part: table, box: [[-9, -9, -9], [9, 9, -0.4]]}, head: {side_set: rod_top}}
curves: {ramp: [[0, 0], [1, 1]]}
initial: [{part: rod, velocity: [0, 0, -1], rotation: {axis: [0, 0, 5], rate: 2}}]
fixed: [{set: foot, dofs: [y, z]}]
symmetry: [{point: [-5, 0, 0], normal: [1, 0, 0]}]
prescribed:
  - {set: table_xmax, dof: x, velocity: ramp, scale: 3}
  - {set: rod_top, dof: z, velocity: 0.5}
pressure: [{set: head, value: 1.0e6, curve: ramp}]
gravity: {vector: [0, 0, -9.81]}
damping: {alpha: 100, to: 1.0e-3}
contact: [{between: all}]
run: {steps: 10}
"""

# by the reference method; masses and stiffnesses differ, and so do the rows of ranks
UNLIKE_BARS = """title: a heavy block on a light one
units: SI
mesh:
  - {box: {part: low, size: [4, 3, 1], elements: [4, 3, 1]}}
  - {box: {part: top, size: [2.6, 1.9, 1], elements: [5, 4, 2], at: [0.3, 0.2, 1.01]}}
materials:
  light: {model: elastic, density: 1, young: 1, poisson: 0.2}
  heavy: {model: elastic, density: 9, young: 20, poisson: 0.2}
parts:
  low: {material: light}
  top: {material: heavy}
initial: [{part: top, velocity: [0.05, 0, -0.2]}]
contact: [{between: all, method: reference}]
run: {end: 1.5}
"""
