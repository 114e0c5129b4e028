#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Mesh, surface and text files as other programs write them: line ends, marks, blank lines, empty blocks, nodes without elements, triangles
without area, several files in one scene. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import os
import re
import struct
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "input"))
import tiny_meshes
from plain_files import BLANKS, FORMS, POINTS, SCENE, bar, binary_ply, msh2, msh4, obj, ply, stl
from run_test import BRUNT, PATIENCE, Program


class Files(Program):
    def put(self, name, content):
        with open(os.path.join(self.folder, name), "wb") as stream:
            stream.write(content)

    def check(self, scene, *more):
        self.write("scene.yaml", scene)
        return self.brunt("check", "scene.yaml", *more)

    def found(self, done):
        """Elements, nodes and mass of the whole mesh as brunt check lists them."""
        self.assertEqual(done.returncode, 0, done.stderr)
        parts = re.findall(r"^\S+ +hex8 +\S+ +(\d+) +(\S+)$", done.stdout, re.M)
        nodes = re.search(r"^nodes +(\d+)$", done.stdout, re.M)
        self.assertTrue(parts and nodes, done.stdout)
        return sum(int(count) for count, _ in parts), int(nodes.group(1)), sum(float(mass) for _, mass in parts)

    def assert_one_line(self, done, *words):
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        lines = [line for line in done.stderr.splitlines() if line.strip()]
        self.assertEqual(len(lines), 1, done.stderr)
        for word in words:
            self.assertIn(word, lines[0])


class Output(Files):
    def test_a_full_device_is_no_success(self):
        self.put("u.obj", obj())
        for arguments in (("depth", "u.obj", "u.obj", "--at", "0.5,0,0", "--json"), ("info",)):
            with open("/dev/full", "wb") as full:
                done = subprocess.run([BRUNT, *arguments], cwd=self.folder, stdout=full, stderr=subprocess.PIPE, text=True, timeout=PATIENCE)
            self.assertEqual(done.returncode, 4, done.stderr)
            self.assertIn("standard output: cannot write the results", done.stderr)


class Forms(Files):
    def test_meshes_and_scenes(self):
        for name, content in (("msh2", msh2(*bar())), ("msh4", msh4(*bar()))):
            wanted = (3, 16, 24.0)
            for form, change in {**FORMS, **BLANKS}.items():
                self.put("bar.msh", change(content))
                with self.subTest(format=name, form=form):
                    self.assertEqual(self.found(self.check(SCENE.replace("FILE", "bar.msh").replace("BLOCK", "1"))), wanted)
        self.put("bar.msh", msh2(*bar()))
        scene = SCENE.replace("FILE", "bar.msh").replace("BLOCK", "bar")
        for form, change in {**FORMS, **BLANKS}.items():
            self.put("scene.yaml", change(scene.encode()))
            with self.subTest(format="scene", form=form):
                self.assertEqual(self.found(self.brunt("check", "scene.yaml")), wanted)
        wrong = scene.replace("density: 8", "density: -8").encode()
        for form in ("feeds", "returns", "returns and feeds", "mark"):  # the number of the line stays
            self.put("scene.yaml", FORMS[form](wrong))
            self.assert_one_line(self.brunt("check", "scene.yaml"), "scene.yaml:3: materials.m.density")

    def test_a_scene_keeps_its_identity_over_line_ends(self):
        self.put("bar.msh", msh2(*bar()))
        scene = SCENE.replace("FILE", "bar.msh").replace("BLOCK", "bar")
        self.write("scene.yaml", scene)
        self.run_scene(1, "scene.yaml", "--out", "out")
        self.put("scene.yaml", FORMS["mark and returns"](scene.replace("steps: 2", "steps: 4").encode()))
        self.put("bar.msh", FORMS["returns and feeds"](msh2(*bar())))
        self.run_scene(1, "scene.yaml", "--out", "out", "--restart", "out")
        self.assertEqual(self.summary("out")["steps"], 4)

    def test_surfaces_and_poses(self):
        self.put("b.obj", obj([(x + 0.1, y + 0.1, z + 0.1) for x, y, z in POINTS]))
        answers = {}
        for format, content in (("stl", stl()), ("obj", obj()), ("ply", ply())):
            for form, change in {**FORMS, **BLANKS}.items():
                self.put(f"a.{format}", change(content))
                done = self.brunt("depth", f"a.{format}", "b.obj", "--metric", "translation", "--json")
                with self.subTest(format=format, form=form):
                    self.assertEqual(done.returncode, 0, done.stderr)
                    answers[(format, form)] = re.search(r'"value": ?([-+.e0-9]+)', done.stdout) or re.search(r'"depth": ?([-+.e0-9]+)', done.stdout)
                    self.assertIsNotNone(answers[(format, form)], done.stdout)
        self.assertEqual(len({found.group(1) for found in answers.values()}), 1, answers)
        for end in (b"\n", b"\r\n", b"\r"):
            self.put("a.ply", binary_ply(end))
            done = self.brunt("depth", "a.ply", "b.obj", "--metric", "translation", "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(next(iter(answers.values())).group(1), done.stdout)
        poses = b"x,y,z\n0,0,0\n0.1,0,0\n"
        for form, change in {**FORMS, **BLANKS}.items():
            self.put("poses.csv", change(poses))
            done = self.brunt("depth", "a.ply", "b.obj", "--metric", "translation", "--poses", "poses.csv", "--json")
            with self.subTest(format="csv", form=form):
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_utf16_is_refused_with_its_cure(self):
        scene = SCENE.replace("FILE", "bar.msh").replace("BLOCK", "bar")
        self.put("b.obj", obj())
        for order, mark in (("utf-16-le", b"\xff\xfe"), ("utf-16-be", b"\xfe\xff")):
            self.put("bar.msh", mark + msh2(*bar()).decode().encode(order))
            self.assert_one_line(self.check(scene), "bar.msh:1", "UTF-16", "expected", "UTF-8")
            self.put("bar.msh", msh2(*bar()))
            self.put("scene.yaml", mark + scene.encode(order))
            self.assert_one_line(self.brunt("check", "scene.yaml"), "scene.yaml:1", "UTF-16", "UTF-8")
            for format, content in (("stl", stl()), ("obj", obj()), ("ply", ply())):
                self.put(f"a.{format}", mark + content.decode().encode(order))
                self.assert_one_line(self.brunt("depth", f"a.{format}", "b.obj"), f"a.{format}:1", "UTF-16", "UTF-8")

    def test_parametric_nodes_and_binary_files_of_gmsh(self):
        scene = SCENE.replace("FILE", "bar.msh").replace("BLOCK", "bar")
        nodes, cubes = bar()
        self.put("bar.msh", msh2(nodes, cubes, "ParametricNodes", " 2 1 0.5 0.5"))
        self.assertEqual(self.found(self.check(scene)), (3, 16, 24.0))
        for version in ("2.2", "4.1"):
            head = f"$MeshFormat\n{version} 1 8\n".encode() + struct.pack("<i", 1) + b"\n$EndMeshFormat\n"
            self.put("bar.msh", head + b"$Nodes\n16\n" + os.urandom(500) + b"\n$EndNodes\n")
            self.assert_one_line(self.check(scene), "bar.msh:2", "binary", "expected", "gmsh -save -format msh41")


class Slivers(Files):
    def test_triangles_without_area(self):
        """A cube of 12 triangles, one edge of which has one to four points of a neighbour in it."""
        corner = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
        square = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        for count in (1, 2, 4):
            points, triangles = list(corner), []
            along = [0]
            for k in range(count):  # points between 0 and 1
                along.append(len(points))
                points.append(((k + 1) / (count + 1), 0, 0))
            along.append(1)
            for a, b, c, d in square:
                if (a, b, c, d) == (0, 1, 5, 4):  # with the points in its edge
                    triangles += [(along[k], along[k + 1], 4) for k in range(count + 1)] + [(1, 5, 4)]
                else:
                    triangles += [(a, b, c), (a, c, d)]
            triangles += [(0, along[k + 1], along[k]) for k in range(1, count + 1)]  # and the other side closed by slivers
            self.put("a.stl", stl(points, triangles))
            self.put("b.stl", stl([(x + 0.75, y + 0.125, z + 0.125) for x, y, z in corner],
                                  [t for a, b, c, d in square for t in ((a, b, c), (a, c, d))]))
            done = self.brunt("depth", "a.stl", "b.stl", "--metric", "translation")
            with self.subTest(count=count):
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("without area", done.stdout + done.stderr)
                self.assertRegex(done.stdout, r"0\.25\b")
        open_one = [t for t in triangles if t != (1, 5, 4)]
        self.put("a.stl", stl(points, open_one))
        self.assertEqual(self.brunt("depth", "a.stl", "b.stl").returncode, 2)


class SeveralFiles(Files):
    def setUp(self):
        super().setUp()
        self.put("one.msh", msh2(*bar(2)))
        self.put("two.msh", msh2(*bar(3)).replace(b'"bar"', b'"rod"'))
        self.put("three.e", tiny_meshes.exodus(empty=1, block_id=7))

    def scene(self, node, first="", second=""):
        return ("units: none\n" f"mesh: [{{file: one.msh{first}}}, {{file: two.msh{second}, at: [0, 5, 0]}}]\n"
                "materials: {m: {model: elastic, density: 8, young: 1, poisson: 0}}\n"
                f"parts: {{a: {{block: {'a_' if first else ''}bar, material: m}}, b: {{block: {'b_' if second else ''}rod, material: m}}}}\n"
                f"probes: [{{name: p, node: {node}, field: position}}]\nrun: {{steps: 1}}\n")

    def position(self, text):
        self.write("scene.yaml", text)
        self.run_scene(1, "scene.yaml", "--out", "out", "--force")
        header, row = self.text("out", "history.csv").splitlines()[:2]
        names = [name.split("[")[0].strip() for name in header.split(",")]
        return [float(row.split(",")[names.index(f"p.{c}")]) for c in "xyz"]

    def test_a_number_in_two_files_is_refused_and_a_prefix_tells_them_apart(self):
        self.assert_one_line(self.check(self.scene(5)), "probes.0.node", "5", "one.msh", "two.msh", "prefix")
        self.assert_one_line(self.check(self.scene(5, ", prefix: a_", ", prefix: b_")), "probes.0.node", "a_5", "b_5")
        prefixed = ", prefix: a_", ", prefix: b_"
        nodes_one, nodes_two = bar(2)[0], bar(3)[0]
        for k in (1, 5, 12):
            self.assertEqual(self.position(self.scene(f"a_{k}", *prefixed)), list(nodes_one[k - 1]))
        for k in (1, 5, 12, 16):
            x, y, z = nodes_two[k - 1]
            self.assertEqual(self.position(self.scene(f"b_{k}", *prefixed)), [x, y + 5, z])
        self.assertEqual(self.position(self.scene(28)), [3, 6, 1])  # of the whole mesh alone: the last node
        self.assert_one_line(self.check(self.scene(99)), "probes.0.node", "unknown node 99")
        self.assert_one_line(self.check(self.scene("a_13", *prefixed)), "unknown node a_13")
        self.assert_one_line(self.check(self.scene("c_1", *prefixed)), "unknown node c_1")
        self.assertEqual(self.check(self.scene(16)).returncode, 2)  # of two.msh, and the fourth of it in the whole mesh

    def test_block_numbers_of_two_files(self):
        text = self.scene(28).replace("block: bar", "block: 1")
        self.assert_one_line(self.check(text), "parts.a.block", "several blocks", "bar", "rod", "name")
        self.assertEqual(self.check(self.scene(28).replace("block: rod", "block: 2")).returncode, 0)  # its number in the whole mesh

    def test_a_name_that_is_the_number_of_another_block(self):
        """Parts in any order whose names are numbers of other blocks, as decks number their parts."""
        for order in ((1, 2), (2, 1), (1, 3, 2), (3, 1, 2), (2, 3, 1)):
            boxes = "".join(f"  - {{box: {{part: '{name}', size: [1, 1, 1], elements: [1, 1, 1], at: [{3 * k}, 0, 0]}}}}\n" for k, name in enumerate(order))
            scene = ("units: SI\nmesh:\n" + boxes + "materials: {" +
                     ", ".join(f"m{name}: {{model: elastic, density: {1000 * name}, young: 1.0e6, poisson: 0}}" for name in order) + "}\nparts: {" +
                     ", ".join(f"'{name}': {{material: m{name}}}" for name in order) + "}\nrun: {steps: 2}\n")
            done = self.check(scene)
            self.assertEqual(done.returncode, 0, done.stderr)
            masses = {int(name): float(mass) for name, mass in re.findall(r"^(\d) +hex8 +\S+ +1 +(\S+)$", done.stdout, re.M)}
            self.assertEqual(masses, {name: 1000.0 * name for name in order})
            self.assertEqual(self.brunt("run", "scene.yaml", "--out", "out", "--force").returncode, 0)

    def test_sets_of_two_files_have_two_names(self):
        for name, n in (("one.msh", 2), ("two.msh", 3)):
            with open(os.path.join(self.folder, name), "rb") as stream:
                content = stream.read()
            row = n + 1
            face = f"{n + 1} 3 2 9 1 1 {1 + 2 * row} {1 + 3 * row} {1 + row}\n$EndElements"
            self.put(name, content.replace(f"$Elements\n{n}\n".encode(), f"$Elements\n{n + 1}\n".encode()).replace(b"$EndElements", face.encode()))
        done = self.check(self.scene(28) + "pressure: [{set: 9, value: 1}]\n")
        self.assertEqual(done.returncode, 2)
        self.assertIn("side set 9: two meshes have it; expected different names, by prefix", done.stderr)
        done = self.check(self.scene(28, ", prefix: a_", ", prefix: b_") + "pressure: [{set: b_9, value: 1}]\n")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_node_set_and_a_side_set_of_one_name(self):
        """As Exodus numbers them, and as Abaqus files name sets and surfaces: a set that is used is one of the two."""
        nodes, cubes = bar(2)
        deck = ["*NODE", *(f"{k}, {x}, {y}, {z}" for k, (x, y, z) in enumerate(nodes, 1)), "*ELEMENT, TYPE=C3D8R, ELSET=bar",
                *(f"{k}, " + ", ".join(map(str, c)) for k, c in enumerate(cubes, 1)), "*NSET, NSET=END", "1, 4, 7, 10",
                "*SURFACE, NAME=END", "2, S4", "*SOLID SECTION, ELSET=bar, MATERIAL=m", ""]
        self.put("bar.inp", "\n".join(deck).encode())
        scene = SCENE.replace("FILE", "bar.inp").replace("BLOCK", "bar")
        listing = self.check(scene).stdout
        self.assertRegex(listing, "(?m)^set of the mesh +node set END: 4 nodes$")
        self.assertRegex(listing, "(?m)^set of the mesh +side set END: 1 face$")
        for key, use in (("fixed.0.set", "fixed: [{set: END, dofs: [x, y, z]}]\n"), ("initial.0.set", "initial: [{set: END, velocity: [1, 0, 0]}]\n"),
                         ("forces.0.set", "forces: [{set: END, total: [1, 0, 0]}]\n"), ("probes.0.set", "probes: [{name: p, set: END, field: position}]\n")):
            self.assert_one_line(self.check(scene + use), key, "invalid set 'END'", "node set and a side set", "{node_set: 'END'}", "{side_set: 'END'}")
        sets = "sets: {left: {node_set: END}, right: {side_set: END}}\n"
        for which, low, high in (("left", 0, 0), ("right", 2, 2)):
            done = self.check(scene + sets + f"fixed: [{{set: {which}, dofs: [x]}}]\nforces: [{{set: {which}, total: [1, 0, 0]}}]\n")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.write("scene.yaml", scene + sets + f"probes: [{{name: p, set: {which}, field: position}}]\n")
            self.run_scene(1, "scene.yaml", "--out", "out", "--force")
            header, row = self.text("out", "history.csv").splitlines()[:2]
            x = float(row.split(",")[[name.split("[")[0].strip() for name in header.split(",")].index("p.x")])
            self.assertTrue(low <= x <= high, x)
        self.assertEqual(self.check(scene + "pressure: [{set: END, value: 1}]\n").returncode, 0)  # of sides, which the side set has

    def test_a_block_whose_number_is_the_name_of_another_one(self):
        def named(*names):
            nodes, cubes = bar(2)
            text = msh2(nodes, cubes).decode().replace('1\n3 1 "bar"', f"{len(names)}\n" + "\n".join(f'3 {k} "{name}"' for k, name in names))
            self.put("bar.msh", text.replace("2 5 2 1 1 ", "2 5 2 2 2 ").encode())

        def parts(first, second, ignore=""):
            materials = ", ".join(f"m{k}: {{model: elastic, density: {k}, young: 1, poisson: 0}}" for k in (1, 2))
            of = ", ".join(f"p{k}: {{block: {block}, material: m{k}}}" for k, block in ((1, first), (2, second)) if block)
            return self.check(f"units: none\nmesh: {{file: bar.msh{ignore}}}\nmaterials: {{{materials}}}\nparts: {{{of}}}\nrun: {{steps: 2}}\n")
        named((1, "2"))  # and block 2 has no name
        done = parts("1", None)
        self.assert_one_line(done, "missing part for block number_2", "block: number_2", "ignore: [number_2]")
        done = parts("2", "number_2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(re.findall(r"(?m)^p\d +hex8 +m(\d) +1 +(\S+)$", done.stdout), [("1", "1"), ("2", "2")])
        done = parts("2", None, ", ignore: [number_2]")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("excluded: block 2, 1 element", done.stdout)
        done = parts("2", None, ", ignore: [number_1]")
        self.assertIn("excluded: block 2, 1 element", done.stdout, done.stderr)  # the name of number 1
        named((1, "bar"), (2, "bar"))
        self.assertEqual(parts("1", "2").returncode, 0)
        self.assertIn("several blocks of the mesh have this name: 1 (bar), 2 (bar); expected the number of one", parts("bar", "2").stderr)

    def test_an_empty_block_of_exodus(self):
        text = SCENE.replace("FILE", "three.e").replace("BLOCK", "8")
        done = self.check(text)
        self.assertEqual(self.found(done), (1, 8, 8.0))
        self.assertIn("block 7", done.stdout + done.stderr)
        self.assert_one_line(self.check(text.replace("parts: {", "parts: {none: {block: 7, material: m}, ")), "parts.none.block", "'7'", "no elements", "expected one of 8")
        self.put("three.e", tiny_meshes.exodus(elements=(), empty=1))
        self.assertEqual(self.check(text).returncode, 2)
        self.assertNotIn("ignore", self.check(text).stderr)

    def test_nodes_without_elements_are_warned_of_and_have_no_mass(self):
        nodes, cubes = bar(2)
        for write, name in ((msh2, "a.msh"), (msh4, "b.msh")):
            self.put(name, write(nodes + [(9.0, 9.0, 9.0), (8.0, 0.0, 0.0)], cubes))
            text = SCENE.replace("FILE", name).replace("BLOCK", "1")
            done = self.check(text)
            self.assertEqual(self.found(done), (2, 12, 16.0))
            self.assertRegex(done.stdout + done.stderr, r"warning.*2 nodes belong to no element.*node 13")
            self.assert_one_line(self.check(text + "probes: [{name: p, node: 13, field: position}]\n"), "unknown node 13", "12 nodes of elements")
        self.put("c.e", tiny_meshes.exodus(nodes=tiny_meshes.CUBE + [(5, 5, 5)]))
        done = self.check(SCENE.replace("FILE", "c.e").replace("BLOCK", "1"))
        self.assertEqual(self.found(done), (1, 8, 8.0))
        self.assertRegex(done.stdout + done.stderr, r"warning.*1 node belongs to no element.*node 9")


if __name__ == "__main__":
    unittest.main()
