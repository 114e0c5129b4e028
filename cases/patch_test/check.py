#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Two blocks with meshes that do not match, pressed together: contact in one pass against its exact static solution, and in two."""
import os
import sys

import h5py
import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from case_check import Case  # noqa: E402

PAIRS = ((2, 3), (3, 5), (4, 7), (3, 4))  # columns of the lower and of the upper block
WAYS = ("exact multipliers", "hex8_full", "hex8")  # columns of the table of one pass
GAUSS = 1 / numpy.sqrt(3)
FULL = [(a, b) for a in (-GAUSS, GAUSS) for b in (-GAUSS, GAUSS)]


class Block:
    """Quadrilaterals on a grid; nodes row by row, x fastest, from `first`."""

    def __init__(self, box, first):
        self.columns, self.rows = box["elements"][:2]
        x = numpy.linspace(0, box["size"][0], self.columns + 1)
        y = numpy.linspace(0, box["size"][1], self.rows + 1) + box.get("at", [0, 0, 0])[1]
        self.points = numpy.array([(a, b) for b in y for a in x])
        self.first, self.count = first, len(self.points)

    def quads(self):
        row = self.columns + 1
        return [[n, n + 1, n + 1 + row, n + row] for j in range(self.rows) for n in range(j * row, j * row + self.columns)]

    def row_of(self, j):
        return list(range(j * (self.columns + 1), (j + 1) * (self.columns + 1)))


def strain_matrix(corners, xi, eta):
    """Strains (xx, yy, 2 xy) by displacements of the four corners, and the Jacobian."""
    slopes = numpy.array([[-(1 - eta), 1 - eta, 1 + eta, -(1 + eta)], [-(1 - xi), -(1 + xi), 1 + xi, 1 - xi]]) / 4
    jacobian = slopes @ corners
    dx, dy = numpy.linalg.solve(jacobian, slopes)
    matrix = numpy.zeros((3, 8))
    matrix[0, 0::2] = matrix[2, 1::2] = dx
    matrix[1, 1::2] = matrix[2, 0::2] = dy
    return matrix, numpy.linalg.det(jacobian)


def plane_strain(law):
    young, nu = law["young"], law["poisson"]
    return young / (1 + nu) / (1 - 2 * nu) * numpy.array([[1 - nu, nu, 0], [nu, 1 - nu, 0], [0, 0, 0.5 - nu]])


def normal_stresses(block, law, displacement, points):
    """sigma_yy of all elements at some of their points."""
    return numpy.array([(plane_strain(law) @ strain_matrix(block.points[quad], *at)[0] @ displacement[quad].ravel())[1]
                        for quad in block.quads() for at in points])


def static_solution(blocks, law, pressure, slave):
    """Small displacements of both blocks with exact multipliers: no slave node leaves or enters the master's edge."""
    size = 2 * sum(block.count for block in blocks)
    stiffness, load, rows = numpy.zeros((size, size)), numpy.zeros(size), []
    for block in blocks:
        for quad in block.quads():
            dofs = [2 * (block.first + n) + c for n in quad for c in range(2)]
            for at in FULL:
                matrix, area = strain_matrix(block.points[quad], *at)
                stiffness[numpy.ix_(dofs, dofs)] += matrix.T @ plane_strain(law) @ matrix * area
    lower, upper = blocks
    top = upper.row_of(upper.rows)
    for a, b in zip(top, top[1:]):
        for n in (a, b):
            load[2 * (upper.first + n) + 1] -= pressure * (upper.points[b] - upper.points[a])[0] / 2
    held = [2 * (b.first + n) for b in blocks for n in range(b.count) if b.points[n][0] == 0]
    held += [2 * n + 1 for n in lower.row_of(0)]
    face = {lower: lower.row_of(lower.rows), upper: upper.row_of(0)}
    slave, master = (upper, lower) if slave == "upper" else (lower, upper)
    for n in face[slave]:
        row, x = numpy.zeros(size), slave.points[n][0]
        row[2 * (slave.first + n) + 1] = 1
        for m in face[master]:
            hat = numpy.zeros(len(face[master]))
            hat[face[master].index(m)] = 1
            row[2 * (master.first + m) + 1] = -numpy.interp(x, master.points[face[master]][:, 0], hat)
        rows.append(row)
    rows += list(numpy.eye(size)[held])
    rows = numpy.array(rows)
    system = numpy.block([[stiffness, rows.T], [rows, numpy.zeros((len(rows), len(rows)))]])
    solution = numpy.linalg.lstsq(system, numpy.concatenate([load, numpy.zeros(len(rows))]), rcond=None)[0]
    return solution[:size].reshape(-1, 2)


def displacements(result, blocks):
    """Of the nodes at z = 0 of all records: [records][nodes of both blocks][2]."""
    with h5py.File(os.path.join(result.folder, "state.h5"), "r") as file:
        order = numpy.argsort(file["mesh/node_id"][...])
        records = [file[name]["node/displacement"][...][order] for name in sorted(file) if name.startswith("record_")]
    # as boxes are numbered: the layer z = 0 of a block first, then the one behind it
    nodes = [2 * block.first + n for block in blocks for n in range(block.count)]
    return [record[nodes, :2] for record in records]


def deviation(blocks, law, pressure, displacement, points=tuple(FULL)):
    """Greatest |sigma_n - p|/p, the sigma_n at all points."""
    stress = numpy.concatenate([normal_stresses(block, law, displacement[block.first:block.first + block.count], points)
                                for block in blocks])
    return numpy.abs(stress + pressure).max() / pressure, stress / pressure


def errors(scene, result):
    """For scripts/pareto: greatest and mean square deviation from the even pressure; greatest one from what is exact for its
    contact, in one pass the solution with exact multipliers, in two the even pressure."""
    blocks, entry = blocks_of(scene), scene["contact"][0]
    model = blocks, scene["materials"]["m"], scene["pressure"][0]["value"]
    full = scene["parts"]["lower"]["element"] == "hex8_full"
    greatest, stress = deviation(*model, displacements(result, blocks)[-1], FULL if full else [(0, 0)])
    found = {"greatest stress error": greatest, "mean stress error": numpy.sqrt(((stress + 1)**2).mean())}
    if full:
        one = static_solution(*model, entry["slave"]) if entry.get("passes") != "two" else None
        exact = -1 if one is None else deviation(*model, one)[1]
        found["stress, from the exact one"] = numpy.abs(stress - exact).max()
    return found


def blocks_of(scene):
    lower = Block(scene["mesh"][0]["box"], 0)
    return lower, Block(scene["mesh"][1]["box"], lower.count)


class Pressed:
    """Two blocks with these columns under the pressure, by one way of contact; the force is right and nothing creeps."""

    def __init__(self, case, columns, way, contact, element):
        overrides = {f"mesh.{body}.box.elements": [columns[body], 3, 1] for body in (0, 1)}
        overrides.update({"parts.lower.element": element, "parts.upper.element": element})
        overrides.update({f"contact.0.{key}": value for key, value in contact.items()})
        scene = case.scene(overrides=overrides)
        self.law, self.pressure, self.blocks = scene["materials"]["m"], scene["pressure"][0]["value"], blocks_of(scene)
        self.label = f"{columns[0]}:{columns[1]}, {way}, {element}"
        name = self.label.replace(", ", "_").replace(":", "_").replace(" ", "_")
        self.result = case.run(overrides=overrides, name=name)
        *_, before, self.end = displacements(self.result, self.blocks)
        points = FULL if element == "hex8_full" else [(0, 0)]
        self.deviation, self.stress = deviation(self.blocks, self.law, self.pressure, self.end, points)
        earlier = deviation(self.blocks, self.law, self.pressure, before, points)[1]
        box = scene["mesh"][0]["box"]["size"]
        self.column = box[0] / max(columns)  # of the finer block
        case.assert_close(f"{self.label}: force", self.pressure * box[0] * box[2], abs(self.result.last("force.y")), 1e-3,
                          "equilibrium")
        case.assert_below(f"{self.label}: change of stress over the last third / pressure",
                          numpy.abs(self.stress - earlier).max(), 1e-4, "steady")


def check_pair(case, columns, slave, element):
    pressed = Pressed(case, columns, f"{'finer' if slave == 'upper' else 'coarser'} slave", {"slave": slave}, element)
    label, ours = pressed.label, pressed.deviation
    model = pressed.blocks, pressed.law, pressed.pressure
    exact, exact_stress = deviation(*model, static_solution(*model, slave))
    if element == "hex8_full":
        case.assert_close(f"{label}: greatest |stress - p|/p", exact, ours, 0.02, "exact multipliers, 2 x 2 Gauss")
        case.assert_below(f"{label}: stress at any point, from the exact one / pressure", numpy.abs(pressed.stress - exact_stress).max(),
                          1e-3, "exact multipliers")
    if slave == "upper":
        case.assert_below(f"{label}: greatest |stress - p|/p", ours, 0.15 if element == "hex8_full" else 0.25, "gate")
    case.assert_energy(pressed.result, energy_gate=1e-10, momentum_gate=1e-9)
    case.assert_below(f"{label}: penetration / column", pressed.result.summary["max_penetration"] / pressed.column, 1e-6)
    return exact, ours


def interface_depth(blocks, displacement):
    """Deepest node of either side below the other's edge."""
    lower, upper = blocks
    sides = [(block.points[row] + displacement[block.first:block.first + block.count][row])
             for block, row in ((lower, lower.row_of(lower.rows)), (upper, upper.row_of(0)))]
    below, above = sides
    return max((numpy.interp(above[:, 0], below[:, 0], below[:, 1]) - above[:, 1]).max(),
               (below[:, 1] - numpy.interp(below[:, 0], above[:, 0], above[:, 1])).max())


def check_soft_passes(case, columns, element):
    """Rows that are springs pass on even pressure nearly."""
    pressed = Pressed(case, columns, "soft two passes", {"slave": "auto", "passes": "two", "softness": 0.05}, element)
    label, strain = pressed.label, pressed.pressure / pressed.law["young"]
    case.assert_below(f"{label}: greatest |stress - p|/p", pressed.deviation, 0.03,
                      "gate of ours: a fifth of one pass's 0.15")
    most = pressed.result.summary["max_penetration"] / pressed.column
    case.assert_below(f"{label}: largest penetration at any time / column, in units of p/E", most / strain, 0.03)
    case.assert_energy(pressed.result, energy_gate=1e-10, momentum_gate=1e-9)
    return pressed.deviation, most


def check_two_passes(case, columns, element):
    """Both sides' nodes are held, and rows, rigid by default, pass on even pressure exactly (Taylor and Papadopoulos 1991)."""
    pressed = Pressed(case, columns, "two passes", {"slave": "auto", "passes": "two"}, element)
    label, ours, strain = pressed.label, pressed.deviation, pressed.pressure / pressed.law["young"]
    case.assert_below(f"{label}: greatest |stress - p|/p", ours, 10 * strain,
                      "exact but for the finite strains, of the order of p/E")
    # In units of what the load moves a free surface by, (p/E) times a column.
    depth = interface_depth(pressed.blocks, pressed.end) / pressed.column
    case.assert_below(f"{label}: penetration of either side / column, in units of p/E", depth / strain, 1e-4)
    most = pressed.result.summary["max_penetration"] / pressed.column
    case.assert_below(f"{label}: largest at any time, likewise", most / strain, 0.01)
    case.assert_energy(pressed.result, energy_gate=1e-10, momentum_gate=1e-9)
    return ours, depth


def check_averaged(case, columns, element):
    """The mean of two solutions: steady, and nearer to even pressure than one pass, but not exact."""
    pressed = Pressed(case, columns, "averaged", {"slave": "auto", "passes": "averaged"}, element)
    label, strain = pressed.label, pressed.pressure / pressed.law["young"]
    case.assert_below(f"{label}: greatest |stress - p|/p", pressed.deviation, 0.1, "gate of ours: that of one pass is 0.15")
    depth = interface_depth(pressed.blocks, pressed.end) / pressed.column
    case.assert_below(f"{label}: penetration of either side / column, in units of p/E", depth / strain, 1e-4)
    case.assert_energy(pressed.result, energy_gate=1e-10, momentum_gate=1e-9)
    return pressed.deviation


def main():
    case = Case(__file__)
    case.answer(errors)
    for columns in PAIRS:
        fine, coarse = (check_pair(case, columns, slave, "hex8_full") for slave in ("upper", "lower"))
        one_point = check_pair(case, columns, "upper", "hex8")[1], check_pair(case, columns, "lower", "hex8")[1]
        cells = fine[0], fine[1], one_point[0], coarse[0], coarse[1], one_point[1]
        case.row("one_pass", ["columns below : above", *(f"{side} slave: {what}" for side in ("finer", "coarser") for what in WAYS)],
                 [f"{columns[0]} : {columns[1]}", *(f"{cell:.4f}" for cell in cells)])
    for columns in PAIRS:
        averaged = check_averaged(case, columns, "hex8_full")
        full, one_point = check_two_passes(case, columns, "hex8_full"), check_two_passes(case, columns, "hex8")
        given_way = check_soft_passes(case, columns, "hex8_full"), check_soft_passes(case, columns, "hex8")
        case.row("two_passes", ["columns below : above", "rigid (default): hex8_full", "hex8", "largest penetration / column",
                                "softness 0.05: hex8_full", "hex8", "largest penetration / column", "averaged passes: hex8_full"],
                 [f"{columns[0]} : {columns[1]}", *(f"{value[0]:.1e}" for value in (full, one_point)), f"{max(full[1], one_point[1], 0):.0e}",
                  *(f"{value[0]:.4f}" for value in given_way), f"{max(given_way[0][1], given_way[1][1]):.1e}", f"{averaged:.4f}"])
    case.assert_same_on_ranks((1, 3))
    case.finish()


if __name__ == "__main__":
    main()
