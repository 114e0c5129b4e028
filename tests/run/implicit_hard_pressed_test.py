#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Hard implicit cases with a closed form: stiffness ratios, coincident meshes, thin plates, unequal facets, incompressible rubber, stacks,
wedges, press fits. Criteria: tests/hard/IMPLICIT.md. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import math
import random
import unittest

from scipy.optimize import brentq

from implicit_hard import HardCase, extruded, of_all
from mortar_seats_test import PressFit

STATIC = "solver: {scheme: static, step: 0.25}\nrun: {end: 1}\n"
QUARTER = "symmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}, {point: [0, 0, 0], normal: [0, 1, 0]}]\n"


def box(part, size, elements, at=(0, 0, 0)):
    return f"  - {{box: {{part: {part}, size: {list(size)}, elements: {list(elements)}, at: {list(at)}}}}}\n"


def in_series(bars, shortening):
    """Nominal stress of neo-Hookean bars without lateral strain (Poisson's ratio 0), of which each is (modulus, length)."""
    def stretch(young, stress):  # P = E/2 (s - 1/s)
        return (stress + math.sqrt(stress * stress + young * young)) / young

    def missing(stress):
        return sum(length * (stretch(young, stress) - 1) for young, length in bars) + shortening

    least = min(young for young, _ in bars)
    return brentq(missing, -10 * least, 0, xtol=1e-15 * least, rtol=1e-14)


class Pressed(HardCase):
    def pile(self, layers, shortening, slaves, more=""):
        """Boxes (name, modulus, height, elements) on each other, ends held along z alone, which is shortened."""
        at, mesh, laws, parts = 0.0, "", "", ""
        for name, young, height, elements in layers:
            mesh += box(name, (1, 1, height), elements, (0, 0, at))
            laws += f"  {name}: {{model: neo_hookean, density: 1, young: {young}, poisson: 0}}\n"
            parts += f"  {name}: {{material: {name}, element: hex8_full}}\n"
            at += height
        low, top = layers[0][0], layers[-1][0]
        pairs = [(a[0], b[0]) for a, b in zip(layers, layers[1:])]
        contact = ", ".join(f"{{between: [{a}, {b}], method: mortar{slave and ', slave: ' + (a if slave == 'low' else b)}}}" for (a, b), slave in zip(pairs, slaves))
        probes = ", ".join(f"{{name: on_{b}, contact: [{b}, {a}]}}" for a, b in pairs)
        return f"units: none\nmesh:\n{mesh}materials:\n{laws}parts:\n{parts}{QUARTER}fixed: [{{set: {low}_zmin, dofs: [z]}}]\n" + \
            f"curves: {{down: [[0, 0], [1, {-shortening}]]}}\nprescribed: [{{set: {top}_zmax, dof: z, displacement: down}}]\n" + \
            f"contact: [{contact}]\nprobes: [{{name: top, set: {top}_zmax, field: reaction}}, {{name: foot, set: {low}_zmin, field: reaction}}, {probes}]\n{more}{STATIC}"

    def is_in_series(self, layers, shortening, slaves):
        row = self.judged(self.pile(layers, shortening, slaves))[-1]
        stress = in_series([(young, height) for _, young, height, _ in layers], shortening)
        self.assertAlmostEqual(row["top.z"] / stress, 1, delta=1e-6)
        for name, *_ in layers[1:]:
            self.assertAlmostEqual(row[f"on_{name}.z"] / -stress, 1, delta=1e-6)
        return row

    def test_moduli_a_million_apart(self):
        for soft_below in (True, False):
            for slave in ("low", "top"):
                with self.subTest(soft_below=soft_below, slave=slave):
                    moduli = (1.0, 1.0e6) if soft_below else (1.0e6, 1.0)
                    self.is_in_series([("a", moduli[0], 1, [3, 3, 2]), ("b", moduli[1], 1, [4, 4, 2])], 0.1, [slave])

    def test_a_thin_plate_between_bodies(self):
        for slaves in of_all((("low", "low"), ("low", "top"), ("top", "low"), ("top", "top"), ("", "")), (("low", "top"), ("", ""))):
            for plate in of_all((1.0, 1000.0), (1000.0,)):
                with self.subTest(slaves=slaves, plate=plate):
                    self.is_in_series([("a", 1.0, 1, [3, 3, 2]), ("p", plate, 0.01, [5, 5, 1]), ("b", 3.0, 1, [4, 4, 2])], 0.1, slaves)

    def test_facets_one_to_twenty(self):
        for slave in ("low", "top"):
            for coarse_below in (True, False):
                with self.subTest(slave=slave, coarse_below=coarse_below):
                    layers = [("a", 1.0, 1, [1, 1, 1]), ("b", 2.0, 0.2, [20, 1, 2])]
                    self.is_in_series(layers if coarse_below else layers[::-1], 0.1, [slave])

    SMALL = """\
units: none
mesh:
  - {box: {part: plate, size: [3, 1, 1], elements: [3, 1, 1]}}
  - {box: {part: small, size: [0.3, 1, 0.3], elements: [6, 1, 6], at: [1.13, 0, 1]}}
materials: {m: {model: neo_hookean, density: 1, young: 1, poisson: 0.3}}
parts: {plate: {material: m, element: hex8_full}, small: {material: m, element: hex8_full}}
fixed: [{set: plate_zmin, dofs: [x, y, z]}, {set: small_zmax, dofs: [x]}]
symmetry: [{point: [0, 0, 0], normal: [0, 1, 0]}, {point: [0, 1, 0], normal: [0, 1, 0]}]
curves: {down: [[0, 0], [1, -0.1]]}
prescribed: [{set: small_zmax, dof: z, displacement: down}]
contact: [{between: [plate, small], method: mortar, slave: SLAVE}]
probes: [{name: top, set: small_zmax, field: reaction}, {name: foot, set: plate_zmin, field: reaction}]
solver: {scheme: static, step: 0.1}
run: {end: 1}
"""

    def test_a_small_body_in_the_middle_of_a_facet_of_twenty_times_its_size(self):
        rows = self.judged(self.SMALL.replace("SLAVE", "small"))
        self.assertAlmostEqual(rows[-1]["top.z"], -rows[-1]["foot.z"], delta=1e-8 * abs(rows[-1]["top.z"]))
        rows = self.judged(self.SMALL.replace("SLAVE", "plate"))

    def test_coincident_nodes_are_one_body(self):
        """Two cubes with the same nodes on both sides, ends clamped: by symmetry nothing slides, so one body of both is the same."""
        text = """\
units: none
mesh:
MESH
materials: {m: {model: neo_hookean, density: 1, young: 1, poisson: 0.3}}
parts: {PARTS}
fixed: [{set: LOW_zmin, dofs: [x, y, z]}, {set: TOP_zmax, dofs: [x, y]}]
curves: {down: [[0, 0], [1, -0.5]]}
prescribed: [{set: TOP_zmax, dof: z, displacement: down}]
probes: [{name: top, set: TOP_zmax, field: reaction}, {name: foot, set: LOW_zmin, field: reaction}, {name: rim, near: [1, 1, 1], part: LOW, field: displacement}]
""" + STATIC
        one = self.judged(text.replace("MESH\n", box("a", (1, 1, 2), (3, 3, 6))).replace("PARTS", "a: {material: m, element: hex8_full}").replace("LOW", "a").replace("TOP", "a"))[-1]
        two = text.replace("MESH\n", box("a", (1, 1, 1), (3, 3, 3)) + box("b", (1, 1, 1), (3, 3, 3), (0, 0, 1))).replace(
            "PARTS", "a: {material: m, element: hex8_full}, b: {material: m, element: hex8_full}").replace("LOW", "a").replace("TOP", "b")
        for contact in ("", ", slave: a", ", slave: b", ", friction: 0.3"):
            with self.subTest(contact=contact):
                row = self.judged(two + f"contact: [{{between: [a, b], method: mortar{contact}}}]\n")[-1]
                self.assertAlmostEqual(row["top.z"] / one["top.z"], 1, delta=1e-8)
                for axis in "xyz":
                    self.assertAlmostEqual(row[f"rim.{axis}"], one[f"rim.{axis}"], delta=1e-8)

    def test_four_blocks_with_coincident_nodes_at_one_edge(self):
        """Pressed from above and from one side, they are one block in a uniform state."""
        names, mesh = {"sw": (0, 0), "se": (1, 0), "nw": (0, 1), "ne": (1, 1)}, ""
        for name, (x, z) in names.items():
            mesh += box(name, (1, 1, 1), (2, 2, 2), (x, 0, z))
        pairs = [("sw", "se"), ("nw", "ne"), ("sw", "nw"), ("se", "ne")]
        whole = "units: none\nmesh:\nMESH\nmaterials: {m: {model: neo_hookean, density: 1, young: 1, poisson: 0.3}}\nparts: {PARTS}\n" + \
            "symmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}, {point: [0, 0, 0], normal: [0, 1, 0]}, {point: [0, 0, 0], normal: [0, 0, 1]}]\n" + \
            "sets: {lid: {box: [[-9, -9, 1.99], [9, 9, 9]]}, side: {box: [[1.99, -9, -9], [9, 9, 9]]}}\ncurves: {down: [[0, 0], [1, -0.2]]}\n" + \
            "prescribed: [{set: lid, dof: z, displacement: down}, {set: side, dof: x, displacement: down, scale: 0.5}]\n" + \
            "probes: [{name: lid, set: lid, field: reaction}, {name: side, set: side, field: reaction}]\n" + STATIC
        one = self.judged(whole.replace("MESH\n", box("a", (2, 1, 2), (4, 2, 4))).replace("PARTS", "a: {material: m, element: hex8_full}"))[-1]
        contact = ", ".join(f"{{between: [{a}, {b}], method: mortar}}" for a, b in pairs)
        four = whole.replace("MESH\n", mesh).replace("PARTS", ", ".join(f"{name}: {{material: m, element: hex8_full}}" for name in names))
        row = self.judged(four + f"contact: [{contact}]\n")[-1]
        for name in ("lid.z", "side.x", "internal"):
            self.assertAlmostEqual(row[name] / one[name], 1, delta=1e-6)

    def test_rubber_that_hardly_changes_its_volume(self):
        """Pressed to .7 between stiffer plates without friction: the closed form with a free side."""
        bulk, shear, stretch = 1000.0, 1.0, 0.7
        lame = bulk - 2 / 3 * shear
        side = brentq(lambda s: shear * (s * s - 1) + lame * math.log(stretch * s * s), 0.5, 2, xtol=1e-14)
        force = (shear * (stretch * stretch - 1) + lame * math.log(stretch * side * side)) / stretch * 0.25
        for slave in of_all(("rubber", "plate"), ("plate",)):
            with self.subTest(slave=slave):
                pairs = ", ".join(f"{{between: [rubber, {p}], method: mortar, slave: {p if slave == 'plate' else 'rubber'}}}" for p in ("low", "top"))
                rows = self.judged("units: none\nmesh:\n" + box("low", (0.8, 0.8, 0.2), (5, 5, 1)) + box("rubber", (0.5, 0.5, 1), (3, 3, 4), (0, 0, 0.2)) +
                                   box("top", (0.8, 0.8, 0.2), (4, 4, 1), (0, 0, 1.2)) +
                                   f"materials: {{r: {{model: neo_hookean, density: 1, bulk: {bulk}, shear: {shear}}}, s: {{model: neo_hookean, density: 1, young: 1.0e5, poisson: 0.3}}}}\n"
                                   "parts: {low: {material: s, element: hex8_full}, rubber: {material: r, element: hex8_bbar}, top: {material: s, element: hex8_full}}\n" + QUARTER +
                                   "fixed: [{part: low, dofs: [x, y, z]}, {part: top, dofs: [x, y]}]\ncurves: {down: [[0, 0], [1, -0.3]]}\n"
                                   f"prescribed: [{{part: top, dof: z, displacement: down}}]\ncontact: [{pairs}]\n"
                                   "probes: [{name: c, contact: [top, rubber]}]\nsolver: {scheme: static, step: 0.1}\nrun: {end: 1}\n")
                self.assertAlmostEqual(rows[-1]["c.z"] / -force, 1, delta=1e-3)

    def test_a_stack_carries_what_lies_above(self):
        random_ = random.Random(1)
        mesh, above, at = "", [], 0.0
        for k in range(6):
            a, b, c = random_.uniform(0.8, 1.2), random_.uniform(0.8, 1.2), random_.uniform(0.3, 0.6)
            mesh += box(f"b{k}", (a, b, c), [random_.randint(1, 3) for _ in range(3)], (random_.uniform(-0.1, 0.1), random_.uniform(-0.1, 0.1), at))
            above.append(a * b * c)
            at += c
        weight = 2.0
        contact = ", ".join(f"{{between: [b{k}, b{k + 1}], method: mortar, friction: 0.5}}" for k in range(5))
        probes = ", ".join(f"{{name: p{k + 1}, contact: [b{k + 1}, b{k}]}}" for k in range(5))
        text = f"units: none\nmesh:\n{mesh}materials: {{m: {{model: neo_hookean, density: 1, young: 1000, poisson: 0.3}}}}\n" + \
            "parts: {" + ", ".join(f"b{k}: {{material: m, element: hex8_full}}" for k in range(6)) + "}\nfixed: [{set: b0_zmin, dofs: [x, y, z]}]\n" + \
            f"curves: {{g: [[0, 0.1], [1, 1]]}}\ngravity: {{vector: [0, 0, {-weight}], curve: g}}\ncontact: [{contact}]\nprobes: [{probes}]\n" + STATIC
        rows = self.judged(text)
        for k in range(1, 6):
            load = weight * sum(above[k:])
            self.assertAlmostEqual(rows[-1][f"p{k}.z"] / load, 1, delta=1e-8)
        self.same_bits(text)

    def wedge(self, angle, friction, slave):
        """Half of a wedge of so many degrees to its axis, in plane strain, driven between cheeks whose outer sides are held."""
        slope = math.tan(math.radians(angle))
        tip, height = 0.2, 1.0

        def face(z):
            return tip + slope * z

        blocks = [("wedge", [3, 5], lambda s, t: (s * face(t * height), t * height)),
                  ("cheek", [3, 4], lambda s, t: (face(1.3 * t - 0.1) * (1 - s) + 2 * s, 1.3 * t - 0.1))]
        self.write("wedge.msh", extruded(blocks, 0.5))
        return f"""\
units: none
mesh: {{file: wedge.msh}}
materials: {{m: {{model: neo_hookean, density: 1, young: 1.0e4, poisson: 0.3}}}}
parts: {{wedge: {{material: m, element: hex8_full}}, cheek: {{material: m, element: hex8_full}}}}
sets: {{lid: {{part: wedge, box: [[-9, -9, 0.999], [9, 9, 9]]}}, outer: {{part: cheek, box: [[1.999, -9, -9], [9, 9, 9]]}}}}
fixed: [{{set: outer, dofs: [x, y, z]}}]
symmetry: [{{point: [0, 0, 0], normal: [1, 0, 0]}}, {{point: [0, 0, 0], normal: [0, 1, 0]}}, {{point: [0, 0.5, 0], normal: [0, 1, 0]}}]
curves: {{down: [[0, 0], [1, -0.002]]}}
prescribed: [{{set: lid, dof: z, displacement: down}}]
contact: [{{between: [wedge, cheek], method: mortar, friction: {friction}, slave: {slave}}}]
probes: [{{name: lid, set: lid, field: reaction}}, {{name: c, contact: [wedge, cheek]}}, {{name: outer, set: outer, field: reaction}}]
solver: {{scheme: static, step: 0.1}}
run: {{end: 1}}
"""

    def test_a_wedge(self):
        """The force along the axis of a wedge is that of its cheeks times sin + mu cos of the half angle."""
        cases = [(angle, friction, slave) for angle in (5, 15, 30, 45) for friction in (0, 0.2) for slave in ("wedge", "cheek")]
        for angle, friction, slave in of_all(cases, ((5, 0.2, "cheek"), (45, 0.2, "wedge"), (45, 0, "cheek"))):
            with self.subTest(angle=angle, friction=friction, slave=slave):
                missed, corners = 0.01, ""
                if angle >= 15 and slave == "cheek":  # missed: contact gives most of the energy, and the guard stops the run
                    self.assertIn("energy dissipated by contact", self.go(self.wedge(angle, friction, slave), code=3))
                    missed, corners = 0.06 if angle == 45 else 0.01, ", edges: true"
                row = self.judged(self.wedge(angle, friction, slave + corners))[-1]
                self.assertAlmostEqual(row["lid.z"], -row["c.z"], delta=1e-8 * abs(row["lid.z"]))
                part = math.sin(math.radians(angle)) + friction * math.cos(math.radians(angle))
                self.assertAlmostEqual(row["c.z"] / row["c.normal"] / part, 1, delta=missed)

    def test_press_fits(self):
        for shaft, hub, slave, tight, error in ((48, 48, "", 0.03, 0.01), (96, 120, "shaft", 0.06, 0.02), (96, 120, "hub", 0.06, 0.02)):
            with self.subTest(shaft=shaft, hub=hub, slave=slave):
                fit = PressFit(random.Random(3))
                fit.shaft, fit.hub, fit.tight, fit.slave = shaft, hub, tight, slave and f", slave: {slave}"
                rows = self.go(fit.scene())  # its bodies overlap at the start, so no criterion of depth
                force = fit.force()
                for axis in "xy":
                    self.assertAlmostEqual(rows[-1][f"c.{axis}"] / force, 1, delta=error)


if __name__ == "__main__":
    unittest.main()
