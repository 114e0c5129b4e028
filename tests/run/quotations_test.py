#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What messages quote of a scene, a command line or a file: at most 60 characters, on one line. Needs BRUNT and BRUNT_RUN (scripts/run) in
the environment; the first argument `--all` tries every key and value instead of each 24th."""
import copy
import json
import os
import re
import subprocess
import sys
import unittest

from run_test import PATIENCE, RUN, Program

LONG = "x" * 5000
TWO_LINES = "xy\n" + "x" * 70 + "\nz"

# one of each kind of key whose text a message may quote
SCENE = {
    "title": "t", "units": "none", "space": "3d",
    "mesh": [{"box": {"part": "a", "size": [1, 1, 1], "elements": [2, 2, 2], "bias": [1, 1, 1]}},
             {"cylinder": {"part": "b", "radius": 1, "length": 2, "elements": [2, 2], "half": ["x"], "at": [0, 0, 3],
                           "nose": {"shape": "cone", "half_angle": 30, "tip_radius": 0.2}}},
             {"box": {"part": "r", "size": [1, 1, 1], "elements": [1, 1, 1], "at": [0, 0, 9], "rotate": {"axis": [0, 0, 1], "degrees": 10}}}],
    "materials": {"m": {"model": "j2", "density": 1, "young": 1, "poisson": 0.3, "yield": 0.1},
                  "jc": {"model": "johnson_cook", "density": 1, "young": 1, "poisson": 0.3, "A": 0.01, "B": 0.01, "n": 0.4, "C": 0.1,
                         "damage": {"D1": 0.1, "D2": 0, "D3": 0}},
                  "hard": {"model": "rigid", "density": 1}},
    "parts": {"a": {"material": "m", "element": "hex8", "hourglass": {"kind": "viscous", "coefficient": 0.1}},
              "b": {"block": "b", "material": "jc", "erosion": {"damage": 1, "nodes": "keep", "points": "any"}},
              "r": {"material": "hard", "rigid": {"mass": 2}}},
    "sets": {"foot": {"node_set": "a_zmin"}, "top": {"side_set": "a_zmax"}, "some": {"box": [[0, 0, 0], [1, 1, 1]], "part": "a"}},
    "curves": {"ramp": [[0, 0], [1, 1]]},
    "initial": [{"part": "b", "velocity": [0, 0, -1]}],
    "fixed": [{"set": "foot", "dofs": ["x", "z"]}, {"part": "r", "dofs": ["rx"]}],
    "prescribed": [{"set": "some", "dof": "y", "displacement": "ramp"}],
    "pressure": [{"set": "top", "value": 1, "curve": "ramp"}],
    "forces": [{"part": "a", "total": [1, 0, 0]}],
    "remove": [{"part": "b", "at": 0.5, "nodes": "keep"}],
    "rigid_walls": [{"name": "w", "point": [0, 0, -5], "normal": [0, 0, 1], "friction": {"static": 0.1}, "parts": ["a"], "motion": "ramp"}],
    "contact": [{"between": "all", "exclude": [["a", "r"]], "friction": 0.2, "slave": "auto", "passes": "one", "initial_overlap": "warn"},
                {"between": ["a", "b"], "slave": "a"}],
    "enforcement": {"method": "rate", "rebuild": 5, "competing": "auto"},
    "probes": [{"name": "n", "node": 3, "field": "velocity"}, {"name": "c", "contact": ["a", "b"]}, {"name": "w", "wall": "w"},
               {"name": "s", "section": {"part": "a", "point": [0.5, 0, 0], "normal": [1, 0, 0]}}, {"name": "m", "part": "r", "field": "moment"}],
    "run": {"end": 1, "step_bound": "element", "wall_limit": "3h"},
    "output": {"every": 0.1, "fields": ["displacement", "stress"]},
    "scaling": {"weak": [{"counts": ["mesh.0.box.elements.0"], "lengths": ["mesh.0.box.size.0"]}]},
}
ALL = "--all" in sys.argv


def places(tree, path=()):
    """Paths of values and of keys."""
    items = tree.items() if isinstance(tree, dict) else enumerate(tree) if isinstance(tree, list) else ()
    for key, value in items:
        if isinstance(tree, dict):
            yield "key", path + (key,)
        if isinstance(value, (dict, list)):
            yield from places(value, path + (key,))
        elif path + (key,) != ("title",):
            yield "value", path + (key,)


def changed(kind, path, text):
    tree = copy.deepcopy(SCENE)
    at = tree
    for step in path[:-1]:
        at = at[step]
    if kind == "value":
        at[path[-1]] = text
    else:
        at[text] = at.pop(path[-1])
    return json.dumps(tree, indent=1)


class Quotations(Program):
    def assert_short(self, done, what, *starts):
        for line in (done.stderr + done.stdout).splitlines():
            self.assertNotIn("x" * 61, line, what)
            self.assertLess(len(line), 1500, what)
        for line in done.stderr.splitlines():
            if starts and line.strip():
                self.assertTrue(line.startswith(tuple(f"brunt: {start}" for start in starts) + ("warning",)), f"{what}: {line}")

    def test_the_scene_is_sound(self):
        self.write("scene.yaml", json.dumps(SCENE))
        done = self.brunt("check", "scene.yaml")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_every_key_and_value_of_a_scene(self):
        refused = tried = 0
        every = 1 if ALL else 24  # each place is a run of the program
        for k, (kind, path) in list(enumerate(places(SCENE)))[::every]:
            for text in (LONG, TWO_LINES) if k % 4 == 0 else (LONG,):
                self.write("scene.yaml", changed(kind, path, text))
                done = self.brunt("check", "scene.yaml")
                self.assertIn(done.returncode, (0, 2), f"{path}: {done.stderr}")
                refused += done.returncode == 2
                tried += 1
                self.assert_short(done, f"{kind} {path}", "scene.yaml:")
        self.assertGreater(refused, 0.7 * tried)

    def test_a_scene_that_is_no_map(self):
        deck = "".join(f"*KEYWORD {k}\n$ xxxxx\n {k}, 1.0, 2.0, 3.0\n" for k in range(500))
        texts = {"deck.k": deck, "list.yaml": "- " + LONG, "text.yaml": LONG, "lines.yaml": "a text\n" * 400, "quoted.yaml": '"' + "x x" * 900 + '"',
                 "joined.yaml": f"units:{LONG}\n", "colon.yaml": f"title: a: {LONG}\n", "bracket.yaml": f"mesh: [{LONG}\n",
                 "anchor.yaml": f"mesh: *{LONG}\n", "tag.yaml": f"mesh: !{LONG} 3\n", "escape.yaml": f'title: "\\q{LONG}"\n'}
        for name, text in texts.items():
            self.write(name, text)
            done = self.brunt("check", name)
            self.assertEqual(done.returncode, 2, name)
            self.assert_short(done, name, name)
            if name != "tag.yaml":  # a map, in which other keys are missing
                self.assertEqual(len(done.stderr.splitlines()), 1, name + done.stderr[:2000])

    def test_options(self):
        self.write("scene.yaml", json.dumps(SCENE))
        for more in (["--set", "run.end=" + LONG], ["--set", LONG + "=1"], ["--set", "run." + LONG + "=1"], ["--set", LONG], ["--set", "run.end=[" + LONG]):
            done = self.brunt("check", "scene.yaml", *more)
            self.assertEqual(done.returncode, 2)
            self.assert_short(done, str(more)[:60])
        for command in ([LONG], ["partition", "scene.yaml", "-n", LONG], ["compare", "a", "b", "--tol", LONG],
                        ["depth", "a.stl", "b.stl", "--at", LONG], ["depth", "a.stl", "b.stl", "--clearance", LONG],
                        ["check", "scene.yaml", LONG], ["check", "scene.yaml", "--" + LONG], ["run", "scene.yaml", "-" + LONG, "y" * 90],
                        *(["depth", "a.stl", "b.stl", *word] for name in ("--metric", "--boxes", "--samples", "--limit", "--merge", "--certify")
                          for word in ([name, LONG], [f"{name}={LONG}"])),
                        ["search", "a", "--method", LONG], ["search", "a", "--repeat", TWO_LINES]):
            done = self.brunt(*command)
            self.assertEqual(done.returncode, 2, done.stderr[:500])
            self.assert_short(done, str(command)[:60])
            self.assertNotIn("y" * 61, done.stderr)

    def test_options_of_scripts(self):
        self.write("scene.yaml", json.dumps(SCENE))
        number = "9" * 5000
        cases = (("run", "-np", LONG), ("run", "-np", number), ("run", "-np", "9999999999999999999", "scene.yaml"), ("run", "--" + LONG, "scene.yaml"),
                             ("render", "out", "--view", LONG), ("render", "out", "--clip", LONG), ("render", "out", "--zoom", LONG), ("render", "out", "--size", LONG, "3"),
                             ("render", "out", "--" + LONG), ("render", "out", LONG), ("render", "out", f"--fps={LONG}"), ("render", "out", "--colours", LONG),
                             ("report", "out", "--states", LONG), ("report", "out", "--view", LONG),
                             ("plot", "out", "--panels", LONG), ("plot", "out", "--columns", LONG), ("study", "-np", LONG, "x.yaml"),
                             ("scaling", "scene.yaml", "--ranks", LONG), ("pareto", "-np", LONG, "x.yaml"), ("tables", LONG))
        for name, *words in cases if ALL else (*cases[:4], cases[5], cases[-7]):  # most take a second to start
            done = subprocess.run([os.path.join(os.path.dirname(RUN), name), *words], cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE, check=False)
            what = f"{name} {words[0]} {words[-1][:20]}"
            self.assertEqual(done.returncode, 2, what + done.stderr[:500])
            self.assert_short(done, what)
            self.assertNotIn("9" * 61, done.stderr, what)
            self.assertEqual(len(done.stderr.splitlines()), 1, what + done.stderr[:500])

    def test_files(self):
        msh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 15 2 0 1 1\n$EndElements\n"
        lines = msh.splitlines()
        for k in range(len(lines)):
            self.write("mesh.msh", "\n".join(lines[:k] + [LONG] + lines[k + 1:]) + "\n")
            self.write("scene.yaml", "units: none\nmesh: {file: mesh.msh}\nmaterials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
                       "parts: {p: {block: 1, material: m}}\nrun: {steps: 1}\n")
            self.assert_short(self.brunt("check", "scene.yaml"), f"msh line {k}", "scene.yaml:")
        tetrahedron = {"obj": ["v 0 0 0", "v 1 0 0", "v 0 1 0", "v 0 0 1", "f 1 3 2", "f 1 2 4", "f 1 4 3", "f 2 3 4"],
                       "ply": ["ply", "format ascii 1.0", "element vertex 4", "property double x", "property double y", "property double z",
                               "element face 4", "property list uchar int vertex_indices", "end_header", "0 0 0", "1 0 0", "0 1 0", "0 0 1",
                               "3 0 2 1", "3 0 1 3", "3 0 3 2", "3 1 2 3"],
                       "stl": ["solid s", "facet normal 0 0 1", "outer loop", "vertex 0 0 0", "vertex 1 0 0", "vertex 0 1 0", "endloop", "endfacet", "endsolid s"]}
        for format, lines in tetrahedron.items():
            for k in range(len(lines)):
                texts = (LONG, lines[k] + " " + LONG, LONG + " " + lines[k])
                for text in texts if ALL else (texts[k % 3],):
                    self.write(f"body.{format}", "\n".join(lines[:k] + [text] + lines[k + 1:]) + "\n")
                    self.assert_short(self.brunt("depth", f"body.{format}", f"body.{format}"), f"{format} line {k}")
        self.write("sound.obj", "\n".join(tetrahedron["obj"]) + "\n")
        for poses in (f"x,y,z,{LONG}\n0,0,0,0\n", f"x,y,z\n0,0,{LONG}\n"):
            self.write("poses.csv", poses)
            done = self.brunt("depth", "sound.obj", "sound.obj", "--poses", "poses.csv")
            self.assertEqual(done.returncode, 2)
            self.assert_short(done, poses[:20])

    def test_control_characters_and_other_alphabets(self):
        self.write("scene.yaml", json.dumps(SCENE).replace('"none"', '"\\u001b[31m\\u0007' + "\\u00e4" * 100 + '"'))
        done = self.brunt("check", "scene.yaml")
        self.assertEqual(done.returncode, 2)
        self.assertIsNone(re.search("[\x00-\x08\x0b-\x1f]", done.stderr))
        self.assertIn("\u00e4" * 50, done.stderr)
        self.assertNotIn("\u00e4" * 61, done.stderr)


if __name__ == "__main__":
    unittest.main(argv=[word for word in sys.argv if word != "--all"])
