#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""initial_overlap: place - whole parts move apart before the run; and the smallest motions that brunt check names."""
import random
import re
import subprocess
import unittest

import h5py
import numpy

from run_test import BRUNT, PATIENCE, Program, of_all

# Two cubes that overlap by 0.1 along x.
CUBES = """\
units: SI
mesh:
  - {box: {part: left, size: [1, 1, 1], elements: [2, 2, 2]}}
  - {box: {part: right, size: [1, 1, 1], elements: [3, 3, 3], at: [0.9, 0, 0]}}
materials:
  light: {model: elastic, density: 1000, young: 1.0e9, poisson: 0.3}
  heavy: {model: elastic, density: 3000, young: 1.0e9, poisson: 0.3}
  stiff: {model: rigid, density: 1000}
parts: {left: {material: light}, right: {material: light}}
contact: [{between: all, initial_overlap: place}]
run: {steps: 20}
"""

# Three cubes and a ball in a heap, on a floor that is fixed.
HEAP = """\
units: SI
mesh:
  - {box: {part: floor, size: [4, 4, 0.5], elements: [4, 4, 1], at: [-1, -1, -0.5]}}
  - {box: {part: low, size: [1, 1, 1], elements: [3, 3, 3], at: [0, 0, -0.05]}}
  - {box: {part: beside, size: [1, 1, 1], elements: [2, 2, 2], at: [0.93, 0.2, -0.02]}}
  - {box: {part: top, size: [1, 1, 1], elements: [3, 3, 3], at: [0.5, 0.1, 0.9], rotate: {axis: [0, 0, 1], degrees: 20}}}
  - {sphere: {part: ball, radius: 0.4, elements: 3, at: [0.5, 1.33, 0.35]}}
materials: {rubber: {model: elastic, density: 1000, young: 1.0e7, poisson: 0.3}}
parts: {floor: {material: rubber}, low: {material: rubber}, beside: {material: rubber}, top: {material: rubber}, ball: {material: rubber}}
fixed: [{part: floor, dofs: [x, y, z]}]
contact: [{between: all, initial_overlap: place}]
run: {steps: 60}
"""


def turned(point, axis, degrees):
    """About an axis through the origin (Rodrigues)."""
    unit, angle = axis / numpy.linalg.norm(axis), numpy.radians(degrees)
    x = numpy.array(point, float)
    return (numpy.cos(angle) * x + numpy.sin(angle) * numpy.cross(unit, x) + (1 - numpy.cos(angle)) * (unit @ x) * unit).tolist()


class Place(Program):
    def check(self, scene, *options):
        self.write("scene.yaml", scene)
        done = self.brunt("check", "scene.yaml", *options)
        return done.returncode, done.stdout, done.stderr

    def placed(self, scene, *options):
        """Translation of each part that moved; the rest of what is told."""
        code, output, errors = self.check(scene, *options)
        self.assertEqual(code, 0, errors + output)
        told = re.findall(r"^placed +part '(\w+)'.*translation \((\S+), (\S+), (\S+)\), (.*)$", output, re.M)
        return {part: tuple(map(float, x)) for part, *x, _ in told}, {part: rest for part, *_, rest in told}

    def assert_moved(self, found, **wanted):
        self.assertEqual(set(found), set(wanted))
        for part, translation in wanted.items():
            for ours, reference in zip(found[part], translation):
                self.assertAlmostEqual(ours, reference, delta=2e-7, msg=part)

    def test_equal_cubes_move_by_half_of_the_overlap(self):
        moved, rest = self.placed(CUBES)
        self.assert_moved(moved, left=(-0.05, 0, 0), right=(0.05, 0, 0))
        self.assertEqual(rest["left"], "no turn")
        _, output, _ = self.check(CUBES)
        self.assertIn("initial overlaps: 2 parts placed, moved by 0.05 m at most", output)
        self.assertRegex(output, r"extent +left: x -0\.05 \.\. 0\.95, ")
        self.assertRegex(output, r"smallest gap +\S+ m between")

    def test_the_heavier_part_moves_less(self):
        moved, _ = self.placed(CUBES, "--set", "parts.right.material=heavy")
        self.assert_moved(moved, left=(-0.075, 0, 0), right=(0.025, 0, 0))

    def test_what_is_held_stays(self):
        moved, _ = self.placed(CUBES + "sets: {end: {part: left, box: [[0, 0, 0], [0, 1, 1]]}}\nfixed: [{set: end, dofs: [x, y, z]}]\n")
        self.assert_moved(moved, right=(0.1, 0, 0))
        moved, _ = self.placed(CUBES + "prescribed: [{part: right, dof: x, velocity: 1}]\n")
        self.assert_moved(moved, left=(-0.1, 0, 0))
        both = CUBES + "fixed: [{part: left, dofs: [x, y, z]}, {part: right, dofs: [x, y, z]}]\n"
        code, _, errors = self.check(both)
        self.assertEqual(code, 2)
        self.assertRegex(errors, r"scene\.yaml:\d+: contact\.0.*: invalid initial_overlap: place cannot separate parts 'left' and 'right', which are both fixed")

    def test_symmetry_holds_across_its_plane(self):
        """The plane x = 0 holds the left cube; planes that both lie on take away the other directions."""
        moved, rest = self.placed(CUBES + "symmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}]\n")
        self.assert_moved(moved, right=(0.1, 0, 0))
        moved, _ = self.placed(CUBES.replace("at: [0.9, 0, 0]", "at: [0.8, 0, 0.9]") + "symmetry: [{point: [0, 0, 0], normal: [0, 0, 1]}, {point: [0, 0, 1.9], normal: [0, 0, 1]}]\n")
        self.assert_moved(moved, left=(-0.1, 0, 0), right=(0.1, 0, 0))  # 0.1 along z would do

    def test_two_planes_at_any_angle_leave_their_line_of_intersection(self):
        """The planes hold the left cube along x and y, in any order, and so does an oblique plane with a support along x."""
        for degrees in of_all((20, 60, 135), (60,)):
            normal = [-round(numpy.sin(numpy.radians(degrees)), 6), round(numpy.cos(numpy.radians(degrees)), 6), 0]
            oblique, plane = f"{{point: [0, 0, 0], normal: {normal}}}", "{point: [0, 0, 0], normal: [0, 1, 0]}"
            for held in (f"symmetry: [{plane}, {oblique}]\n", f"symmetry: [{oblique}, {plane}]\n",
                         f"symmetry: [{oblique}]\nfixed: [{{part: left, dofs: [x]}}]\n"):
                with self.subTest(degrees=degrees, held=held):
                    moved, _ = self.placed(CUBES + held)
                    self.assert_moved(moved, right=(0.1, 0, 0))

    def test_rigid_parts_move_too(self):
        moved, _ = self.placed(CUBES, "--set", "parts.right.material=stiff")
        self.assert_moved(moved, left=(-0.05, 0, 0), right=(0.05, 0, 0))

    def test_tied_parts_move_as_one(self):
        third = CUBES.replace("materials:", "  - {box: {part: third, size: [1, 1, 1], elements: [2, 2, 2], at: [1.9, 0, 0]}}\nmaterials:").replace(
            "right: {material: light}}", "right: {material: light}, third: {material: light}}").replace(
                "place}]", "place}, {between: [right, third], tied: true}]")
        code, output, errors = self.check(third)
        self.assertEqual(code, 0, errors)
        self.assertRegex(output, r"placed +part 'right' with 'third': moved by 0\.03333 m at most")
        self.assertRegex(output, r"placed +part 'left': moved by 0\.06667 m at most")

    def test_joined_rigid_parts_move_as_one(self):
        """The part that names the body need not have a key `rigid`."""
        third = CUBES.replace("materials:", "  - {box: {part: third, size: [1, 1, 1], elements: [2, 2, 2], at: [1.9, 0, 0]}}\nmaterials:")
        for lead, other in (("right", "third"), ("third", "right")):
            with self.subTest(lead=lead):
                code, output, errors = self.check(third.replace(
                    "right: {material: light}}", f"{lead}: {{material: stiff}}, {other}: {{material: stiff, rigid: {{joins: {lead}}}}}}}"))
                self.assertEqual(code, 0, errors)
                self.assertRegex(output, r"placed +part 'right' with 'third': moved by 0\.03333 m at most")
                self.assertRegex(output, r"placed +part 'left': moved by 0\.06667 m at most")

    def test_large_motions_are_refused(self):
        limited = CUBES.replace("initial_overlap: place", "initial_overlap: place, limit: LIMIT")
        self.assertEqual(len(self.placed(limited.replace("LIMIT", "0.06"))[0]), 2)
        code, _, errors = self.check(limited.replace("LIMIT", "0.04"))
        self.assertEqual(code, 2)
        self.assertEqual(len(errors.splitlines()), 1)
        self.assertRegex(errors, r"^brunt: scene\.yaml:\d+: contact\.0\.limit: out of range: initial_overlap: place would move part '\w+' by 0\.05 m; expected at most 0\.04 m$")

    def test_parts_that_would_leave_what_they_overlap_are_refused(self):
        """A pin too thick for its bore can only be pulled out of it."""
        press = (CUBES[:CUBES.index("mesh:")].replace("SI", "mm-ms-kg") + """\
mesh:
  - {tube: {part: left, inner_radius: 10, outer_radius: 25, length: 30, elements: [2, 24, 2]}}
  - {cylinder: {part: right, radius: 10.3, length: 60, elements: [4, 6], at: [0, 0, -15]}}
""" + CUBES[CUBES.index("materials:"):]).replace("young: 1.0e9", "young: 1")
        code, _, errors = self.check(press)
        self.assertEqual(code, 2)
        self.assertEqual(len(errors.splitlines()), 1, errors)
        told = re.match(r"brunt: scene\.yaml:\d+: contact\.0: out of range: initial_overlap: place would move part '(?:left|right)' by (\S+) mm relative to part "
                        r"'(?:left|right)', which it overlaps by (\S+) mm; expected at most 5 times the overlap: .*set limit", errors)
        self.assertIsNotNone(told, errors)
        self.assertGreater(float(told.group(1)), 20)  # half of the hub's length and more
        self.assertAlmostEqual(float(told.group(2)), 0.3, delta=0.1)  # facets
        limited = press.replace("place}", "place, limit: 100}")
        self.assertEqual(len(self.placed(limited)[0]), 2)
        self.assertRegex(self.check(limited)[1], r"place moves part '(?:left|right)' by \S+ mm relative to part '(?:left|right)', which it overlaps by \S+ mm")

    def test_a_neighbour_pushed_aside_by_another_part_slides(self):
        """A block stands in a fixed wall, and a lid overlaps the block a little, across that direction: nothing is pulled out."""
        for variant in range(of_all(10, 4)):
            dice = random.Random(f"lid {variant}")
            wide, high, thick = dice.uniform(8, 30), dice.uniform(8, 30), dice.uniform(2, 8)
            deep = dice.uniform(0.5, 2)
            little = deep / dice.uniform(6, 40)
            axis, degrees = numpy.array([dice.gauss(0, 1) for _ in range(3)]), dice.uniform(0, 180)
            bodies = [("wall", (10, 2 * wide, 2 * high), (-10, -wide, -high)), ("block", (wide, wide, high), (-deep, -wide / 2, -high / 2)),
                      ("lid", (0.7 * wide, 0.8 * wide, thick), (0.2 * wide, -0.4 * wide, high / 2 - little))]
            dice.shuffle(bodies)
            mesh = "".join(f"  - {{box: {{part: {name}, size: {list(size)}, elements: [3, 3, 2], rotate: {{axis: {axis.tolist()}, degrees: {degrees}}}, "
                           f"at: {turned(at, axis, degrees)}}}}}\n" for name, size, at in bodies)
            scene = (CUBES[:CUBES.index("mesh:")] + "mesh:\n" + mesh + CUBES[CUBES.index("materials:"):CUBES.index("parts:")]
                     + "parts: {wall: {material: light}, block: {material: light}, lid: {material: light}}\nfixed: [{part: wall, dofs: [x, y, z]}]\n"
                     + CUBES[CUBES.index("contact:"):])
            with self.subTest(variant=variant):
                moved, _ = self.placed(scene)
                self.assertAlmostEqual(numpy.linalg.norm(moved["block"]), deep, delta=0.02 * deep)
                self.assertLess(numpy.linalg.norm(moved["lid"]), 1.01 * little)

    def test_a_row_of_parts_moves_far_as_a_whole(self):
        """Each cube overlaps the next by 0.1, and the first is held: the last moves by seven overlaps, by one beside its neighbour."""
        cubes = "".join(f"  - {{box: {{part: c{k}, size: [1, 1, 1], elements: [1, 1, 1], at: [{0.9 * k:.1f}, 0, 0]}}}}\n" for k in range(8))
        row = (CUBES[:CUBES.index("mesh:")] + "mesh:\n" + cubes + CUBES[CUBES.index("materials:"):CUBES.index("parts:")]
               + "parts: {" + ", ".join(f"c{k}: {{material: light}}" for k in range(8)) + "}\nfixed: [{part: c0, dofs: [x, y, z]}]\n"
               + CUBES[CUBES.index("contact:"):])
        moved, _ = self.placed(row)
        self.assertAlmostEqual(moved["c7"][0], 0.7, delta=1e-5)

    def test_no_element_is_distorted_and_nothing_moves_in_the_run(self):
        self.write("scene.yaml", HEAP)
        self.run_scene(1, "scene.yaml", "--out", "one")
        done = self.summary("one")
        self.assertEqual(done["stopped_by"], "steps")
        self.assertEqual(done["energy"]["kinetic"], 0)
        self.assertEqual(done["energy"]["contact"], 0)
        self.assertEqual(done["max_penetration"], 0)
        log = self.text("one", "log.txt")
        self.assertRegex(log, r"initial overlaps: 4 parts placed, moved by \S+ m at most")
        self.assertNotRegex(log, "placed +part 'floor'")

    def test_any_number_of_ranks_and_a_restart(self):
        self.write("scene.yaml", HEAP)
        push = ("--set", "initial=[{part: top, velocity: [0, 0, -5]}]")
        for ranks in (1, 3):
            self.run_scene(ranks, "scene.yaml", "--out", f"out{ranks}", *push)
        self.assertEqual(self.summary("out1")["state_hash"], self.summary("out3")["state_hash"])
        self.run_scene(2, "scene.yaml", "--out", "part", *push, "--set", "run.steps=25")
        self.run_scene(1, "scene.yaml", "--out", "part", "--restart", "part", *push)
        self.assertEqual(self.summary("part")["state_hash"], self.summary("out1")["state_hash"])

    def test_distances_between_nodes_stay(self):
        self.write("scene.yaml", HEAP)
        for out, rule in (("placed", "place"), ("drawn", "offset")):
            self.run_scene(1, "scene.yaml", "--out", out, "--set", f"contact.0.initial_overlap={rule}", "--set", "run.steps=1")
        nodes = []
        for out in ("placed", "drawn"):
            with h5py.File(f"{self.folder}/{out}/state.h5") as file:
                nodes.append(file["mesh/coordinates"][...])
        moved = numpy.linalg.norm(nodes[0] - nodes[1], axis=1)
        self.assertGreater(moved.max(), 1e-3)
        floor = (nodes[1][:, 2] <= 0) & (nodes[1][:, 2] == numpy.round(nodes[1][:, 2], 1)) & (moved == 0)
        self.assertGreaterEqual(floor.sum(), 2 * 25)

    def test_check_names_the_smallest_motion(self):
        for rule in ("error", "place", "offset"):
            _, output, _ = self.check(CUBES, "--set", f"contact.0.initial_overlap={rule}")
            self.assertRegex(output, r"smallest motion +parts 'left' and 'right' overlap: moving 'left' by 0\.1 m along \(-1, 0, 0\) separates them "
                                     r"\(translation\); no motion below 0\.1 m separates them", rule)
        _, output, _ = self.check(CUBES.replace("at: [0.9, 0, 0]", "at: [1.1, 0, 0]"))
        self.assertNotIn("smallest motion", output)

    def test_check_moves_only_what_may_move(self):
        """The left cube is the one that is named where none is held (above): of equal masses the first."""
        for held, line in (("{part: left, dofs: [x, y, z]}", r"moving 'right' by 0\.1 m along \(1, 0, 0\) separates them \(translation\); no motion below 0\.1 m separates them"),
                           ("{part: left, dofs: [x]}", r"moving 'right' by 0\.1 m along \(1, 0, 0\)"),
                           ("{part: left, dofs: [x]}, {part: right, dofs: [x, y, z]}", r"moving 'left' by 1 m along \(0, -?[01], -?[01]\) separates them"),
                           ("{part: left, dofs: [x, y, z]}, {part: right, dofs: [x, y, z]}", "both are fixed, so neither can move")):
            _, output, errors = self.check(CUBES.replace("initial_overlap: place", "initial_overlap: offset") + f"fixed: [{held}]\n")
            self.assertRegex(output, "smallest motion +parts 'left' and 'right' overlap: " + line, errors)

    def test_parts_placed_through_walls_and_planes_are_named(self):
        wall = CUBES + "rigid_walls: [{name: side, point: [WALL, 0, 0], normal: [1, 0, 0]}]\n"
        warning = r"^warning: scene\.yaml:\d+: rigid_walls\.0.*: initial_overlap: place moves part 'left' 0\.03 m behind rigid wall 'side'$"
        for place, told in (("-0.02", True), ("-0.06", False)):
            code, output, errors = self.check(wall.replace("WALL", place))
            self.assertEqual(code, 0, errors)
            self.assertEqual(bool(re.search(warning, output, re.M)), told, output)
            self.assertNotIn("'right' 0", output)
        base = CUBES.replace("materials:", "  - {box: {part: base, size: [1, 1, 1], elements: [1, 1, 1], at: [-0.02, 3, 0]}}\nmaterials:", 1).replace(
            "right: {material: light}}", "right: {material: light}, base: {material: light}}")
        code, output, errors = self.check(base + "symmetry: [{point: [-0.02, 0, 0], normal: [-1, 0, 0]}]\n")
        self.assertEqual(code, 0, errors)
        self.assertRegex(output, r"(?m)^warning: scene\.yaml:\d+: symmetry\.0.*: initial_overlap: place moves part 'left' 0\.03 m across the plane of symmetry$")
        self.assertNotRegex(output, "moves part '(right|base)'")

    def test_check_on_three_ranks(self):
        self.write("scene.yaml", HEAP)
        told = []
        for ranks in (1, 3):
            done = subprocess.run(["mpirun", "-np", str(ranks), BRUNT, "check", "scene.yaml"], cwd=self.folder, capture_output=True, text=True,
                                  timeout=4 * PATIENCE, check=True)
            told.append(re.findall(r"^(?:placed|smallest motion) .*$", done.stdout, re.M))
        self.assertGreater(len(told[0]), 6)
        self.assertEqual(told[0], told[1])


if __name__ == "__main__":
    unittest.main()
