#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Hard implicit cases of sharp corners, edges and snapping: against explicit twins of the same mesh, and closed paths. Criteria:
tests/hard/IMPLICIT.md. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment. --long: finer meshes, more angles, three dimensions."""
import math
import re
import unittest

import numpy

from implicit_hard import WORSE, HardCase, extruded, largest_energy, of_all

SNAPS = re.compile("loses its stability|equilibrium jumps")
PUNCH = """\
units: none
mesh: {{file: punch.msh}}
materials:
  soft: {{model: neo_hookean, density: 1, young: 1, poisson: 0.3}}
  hard: {{model: neo_hookean, density: 1, young: 10, poisson: 0.3}}
parts: {{slab: {{material: soft, element: hex8_full}}, iron: {{material: hard, element: hex8_full}}}}
sets: {{head: {{part: iron, box: [[-9, -9, 2.999], [9, 9, 9]]}}, foot: {{part: slab, box: [[-9, -9, -9], [9, 9, 0.001]]}}}}
fixed: [{{set: foot, dofs: [x, y, z]}}]
symmetry: [{{point: [0, 0, 0], normal: [0, 1, 0]}}, {{point: [0, 1, 0], normal: [0, 1, 0]}}, {{point: [0, 0, 0], normal: [1, 0, 0]}}]
curves: {{down: [[0, 0], [{time}, -0.8], [{end}, -0.8]]}}
prescribed: [{{set: head, dof: z, displacement: down}}]
probes: [{{name: top, set: head, field: reaction}}, {{name: bot, set: foot, field: reaction}}]
"""


def punch_mesh(degrees, n):
    """A slab 4 x 2 and a punch with a flat face of half width 1.2, whose sides rise at so many degrees inside of the iron."""
    lean = 1 / math.tan(math.radians(degrees))
    return extruded([("slab", [8 * n, 4 * n], lambda s, t: (4 * s, 2 * t)),
                     ("iron", [3 * n, 2 * n], lambda s, t: (s * (1.2 - lean * t), 2 + t))], 1)


# of criteria that are not met, by degrees, fineness, scheme and slave: share of the run that is reached, error of the force, edges, given
MISSED = {(90, 1, "static", "iron"): (0.39, 0.029, 0.05, 2.3e-3), (90, 1, "static", "slab"): (0.27, 0.035, 0.05, 2.1e-3),
          (90, 1, "contact_implicit", "iron"): (0.9, 0.035, 1, 1e-3), (90, 1, "contact_implicit", "slab"): (0.9, 0.023, 1, 1e-3),
          (60, 1, "static", "slab"): (1, 0.033, 0.05, 0.016), (120, 1, "static", "iron"): (0.65, 0.064, 0.05, 0.015),
          (120, 1, "static", "slab"): (1, 0.096, 0.123, 0.03),
          (75, 1, "static", "iron"): (0.979, 0.035, 0.063, 1e-3), (75, 1, "static", "slab"): (1, 0.02, 0.05, 0.049),
          (90, 2, "static", "iron"): (0.162, 0.02, 0.05, 1e-3), (90, 2, "static", "slab"): (0.246, 0.02, 0.218, 1e-3),
          (60, 2, "static", "slab"): (0.961, 0.02, 0.05, 1e-3), (120, 2, "static", "iron"): (1, 0.02, 0.066, 0.013),
          (120, 2, "static", "slab"): (1, 0.02, 0.218, 0.0052), (90, 3, "static", "iron"): (1, 0.066, 0.105, 0.02),
          (90, 3, "static", "slab"): (0.129, 0.02, 0.05, 1e-3)}


class Corners(HardCase):
    def twin(self, text, time, damping=1.0, history=1.0):
        """The last rows of an explicit run that is so slow that inertia does not matter, damped."""
        self.write("scene.yaml", text + f"damping: {{alpha: {damping}}}\nrun: {{end: {time}}}\nhistory: {{every: {history}}}\noutput: {{every: {time / 20}, fields: [displacement]}}\n")
        self.run_scene(1, "scene.yaml", "--out", "twin", "--force")
        return self.rows("twin")

    def punch(self, degrees, n, runs=(("static", "iron"), ("static", "slab"))):
        self.write("punch.msh", punch_mesh(degrees, n))
        force = self.twin(PUNCH.format(time=100, end=150) + "contact: [{between: [iron, slab], passes: two}]\n", 150)[-1]["top.z"]
        for scheme, slave in runs:
            with self.subTest(degrees=degrees, n=n, scheme=scheme, slave=slave):
                static = scheme == "static"
                time, end = (1, 1) if static else (100, 150)  # the second with all inertia, too slow to matter
                text = PUNCH.format(time=time, end=end + 1) + f"contact: [{{between: [iron, slab], method: mortar, slave: {slave}}}]\n" + \
                    f"solver: {{scheme: {scheme}, step: {0.05 if static else 2.5}}}\nrun: {{end: {end}}}\n"
                self.keeps_to(text, force, MISSED.get((degrees, n, scheme, slave)))

    def keeps_to(self, text, force, missed):
        if missed is None:
            rows, reached, error, told = self.judged(text, nodes=1e-3), 1, 0.02, ""
        else:
            reached, error = missed[0] / WORSE, WORSE * missed[1]
            rows, told = self.judged(text, nodes=1e-3, code=(0, 3), missed={"edges": missed[2], "given": missed[3]})
        end = float(text[text.rindex("end: ") + 5:text.rindex("}")])
        self.assertGreaterEqual(rows[-1]["time"] / end, reached)
        if not told:
            last = rows[-1]["top.z"] if end == 1 else numpy.mean([row["top.z"] for row in rows if row["time"] > 110])
            self.assertAlmostEqual(last / force, 1, delta=error)

    def test_a_square_punch(self):
        runs = [(scheme, slave) for scheme in ("static", "contact_implicit") for slave in ("iron", "slab")]
        self.punch(90, 1, of_all(runs, runs[:3]))

    def test_punches_of_other_angles_and_finer_meshes(self):
        for degrees, n in of_all(((60, 1), (75, 1), (120, 1), (90, 2), (60, 2), (120, 2), (90, 3)), ((60, 1), (120, 1))):
            self.punch(degrees, n)

    OFF = """\
units: none
mesh:
  - {box: {part: plate, size: [1, 0.5, 0.4], elements: [5, 2, 2]}}
  - {box: {part: block, size: [0.5, 0.5, 0.3], elements: [3, 2, 2], at: [0.3, 0, 0.4]}}
materials: {m: {model: neo_hookean, density: 1, young: 1000, poisson: 0.3}}
parts: {plate: {material: m, element: hex8_full}, block: {material: m, element: hex8_full}}
fixed: [{set: plate_zmin, dofs: [x, y, z]}, {set: block_zmax, dofs: [y]}]
symmetry: [{point: [0, 0, 0], normal: [0, 1, 0]}]
curves: {down: [[0, 0], [0.2, -0.01], [1, -0.01]], along: [[0, 0], [0.2, 0], [1, 0.9]]}
prescribed: [{set: block_zmax, dof: z, displacement: down}, {set: block_zmax, dof: x, displacement: along}]
contact: [{between: [plate, block], method: mortar, friction: FRICTION, slave: SLAVE}]
probes: [{name: top, set: block_zmax, field: reaction}, {name: foot, set: plate_zmin, field: reaction}]
solver: {scheme: static, step: 0.02}
run: {end: 1}
"""

    def test_a_block_slides_off_the_edge_of_a_plate(self):
        cases = [("plate", 0), ("plate", 0.3), ("block", 0.3), ("block", 0)]
        for slave, friction in of_all(cases, cases[1::2]):
            with self.subTest(slave=slave, friction=friction):
                rows = self.judged(self.OFF.replace("FRICTION", str(friction)).replace("SLAVE", slave), missed={} if friction else {"given": 1.35e-3})
                peak = max(abs(row["top.z"]) for row in rows)
                for row in rows:
                    self.assertLess(abs(row["top.z"] + row["foot.z"]), 1e-8 * peak)
                self.assertEqual(rows[-1]["active_contacts"], 0)
                self.assertLess(abs(rows[-1]["top.z"]) + abs(rows[-1]["top.x"]), 1e-8 * peak)
                largest = largest_energy(rows)
                if not friction:
                    self.assertLess(abs(rows[-1]["contact"]), WORSE * 0.174 * largest)  # criterion 1e-2
                self.assertLess(rows[-1]["internal"], 1e-2 * largest)  # neo-Hookean bodies give all of it back

    ARCH = """\
units: none
mesh: {file: arch.msh}
materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0}}
parts: {PARTS}
sets: {apex: {part: arch, box: [[-9, -9, -9], [0.001, 9, 9]]}, clamp: {part: arch, box: [[1.999, -9, -9], [9, 9, 9]]}, HEAD}
fixed: [{set: clamp, dofs: [x, y, z]}]
symmetry: [{point: [0, 0, 0], normal: [0, 1, 0]}, {point: [0, 0.5, 0], normal: [0, 1, 0]}, {point: [0, 0, 0], normal: [1, 0, 0]}]
probes: [{name: apex, set: apex, field: reaction}, {name: moved, set: apex, field: displacement}]
"""

    def arch(self, ram=False):
        """Half of a shallow arch, clamped, with a symmetry plane at its apex; a ram above it."""
        def middle(s):
            return 0.2 * (1 + math.cos(math.pi * s))

        blocks = [("arch", [12, 2], lambda s, t: (2 * s, middle(s) + 0.15 * (t - 0.5)))]
        if ram:
            blocks.append(("ram", [2, 2], lambda s, t: (0.3 * s, 0.475 + 0.3 * t)))
        self.write("arch.msh", extruded(blocks, 0.5))
        parts = "arch: {material: m, element: hex8_full}" + (", ram: {material: m, element: hex8_full}" if ram else "")
        return self.ARCH.replace("PARTS", parts).replace("HEAD", "head: {part: ram, box: [[-9, -9, 0.774], [9, 9, 9]]}" if ram else "none: {part: arch}")

    def test_an_arch_snaps_under_a_driven_displacement(self):
        text = self.arch() + "prescribed: [{set: apex, dof: z, displacement: down}]\n"
        rows = self.judged(text + "curves: {down: [[0, 0], [1, -0.9]]}\nsolver: {scheme: static, step: 0.025}\nrun: {end: 1}\n")
        self.assertNotIn("stability", self.text("out", "log.txt"))
        twin = self.twin(text + "curves: {down: [[0, 0], [200, -0.9], [201, -0.9]]}\n", 200, 1.0, 0.1)
        peak = max(abs(row["apex.z"]) for row in rows)
        self.assertLess(min(row["apex.z"] for row in rows) * max(row["apex.z"] for row in rows), 0)  # it wants to snap
        at, force = [row["time"] / 200 for row in twin], [row["apex.z"] for row in twin]
        for row in rows[1:-1]:
            near = [f for t, f in zip(at, force) if abs(t - row["time"]) < 0.01]
            self.assertAlmostEqual(row["apex.z"] / peak, numpy.mean(near) / peak, delta=0.02)

    def test_an_arch_under_a_load_beyond_its_limit_point_stops_or_says_so(self):
        """Steps of a tenth and of the whole load; the limit point is that of the driven arch."""
        text = self.arch()
        driven = self.go(text + "prescribed: [{set: apex, dof: z, displacement: down}]\ncurves: {down: [[0, 0], [1, -0.9]]}\nsolver: {scheme: static, step: 0.025}\nrun: {end: 1}\n")
        limit = max(-row["apex.z"] for row in driven[:20])
        for share, step in ((0.9, 0.1), (1.2, 0.1), (1.2, 1)):  # 3 times the limit at once jumps without a word
            with self.subTest(share=share, step=step):
                loaded = text + f"forces: [{{set: apex, total: [0, 0, {-share * limit}], curve: f}}]\ncurves: {{f: [[0, 0], [1, 1]]}}\nsolver: {{scheme: static, step: {step}}}\nrun: {{end: 1}}\n"
                rows, told = self.judged(loaded, code=(0, 3))
                log = self.text("out", "log.txt")
                if share < 1:
                    self.assertEqual((told, rows[-1]["time"]), ("", 1))
                    self.assertNotIn("stability", log)
                else:
                    self.assertTrue(told or SNAPS.search(log), "it has snapped without a word")

    def test_a_ram_snaps_an_arch_through(self):
        cases = [("arch", "contact_implicit"), ("arch", "static"), ("ram", "static"), ("ram", "contact_implicit")]
        for slave, scheme in of_all(cases, cases[1::2]):
            with self.subTest(slave=slave, scheme=scheme):
                static = scheme == "static"
                end = 1 if static else 20
                text = self.arch(ram=True) + f"curves: {{down: [[0, 0], [{end}, -0.8]]}}\nprescribed: [{{set: head, dof: z, displacement: down}}]\n" + \
                    f"contact: [{{between: [arch, ram], method: mortar, slave: {slave}}}]\nsolver: {{scheme: {scheme}, step: {end / 80}}}\nrun: {{end: {end}}}\n"
                text = text.replace("probes: [", "probes: [{name: c, contact: [arch, ram]}, ")
                rows, told = self.judged(text, code=(0, 3), missed={} if static else {"edges": 0.254})
                if not static:
                    self.assertEqual(told, "")
                    self.assertLess(rows[-1]["moved.z"], -0.7)
                elif not told and not SNAPS.search(self.text("out", "log.txt")):  # then the ram holds the arch all the way
                    self.assertLess(max(row["c.z"] for row in rows[1:]), 0)


if __name__ == "__main__":
    unittest.main()
