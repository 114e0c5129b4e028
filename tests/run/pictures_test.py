#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""scripts/render and scripts/plot on a result: what they draw, and one line and exit code 2 where they cannot. Needs BRUNT and
BRUNT_RUN (scripts/run) in the environment."""
import os
import subprocess
import unittest

import numpy as np
from PIL import Image

import scenes
from run_test import PATIENCE, RUN, Program, of_all

SCRIPTS = os.path.dirname(RUN)


class Pictures(Program):
    def setUp(self):
        super().setUp()
        self.write("rod.yaml", scenes.ROD)
        self.run_scene(1, "rod.yaml", "--out", "out", "--set", "output.every=1e-5", "--set",
                       "output.fields=[displacement, velocity, gap]")
        self.before = sorted(os.listdir(os.path.join(self.folder, "out")))

    def script(self, name, *arguments):
        return subprocess.run([os.path.join(SCRIPTS, name), *arguments], cwd=self.folder, capture_output=True, text=True,
                              timeout=PATIENCE, check=False)

    def assert_refused(self, phrases, name, *arguments):
        done = self.script(name, *arguments)
        self.assertEqual(done.returncode, 2, done.stderr + done.stdout)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for phrase in (f"{name}: ", "expected", *phrases):
            self.assertIn(phrase, done.stderr)
        self.assertEqual(sorted(os.listdir(os.path.join(self.folder, "out"))), self.before)

    def test_pictures_where_none_can_be(self):
        for name in ("render", "plot"):
            self.assert_refused(["nodir/x.png", "does not exist"], name, "out", "-o", "nodir/x.png")
            self.assert_refused(["it is a folder"], name, "out", "-o", "out")
            done = self.script(name, "out", "-o", "x.fooo")
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1), done.stderr)

    def test_times_and_fields_that_are_not_there(self):
        self.assert_refused(["--time 99", "from 0 to 0.0001"], "render", "out", "--time", "99")
        self.assert_refused(["--time -1"], "render", "out", "--time", "-1")
        self.assert_refused(["unknown field velocty", "velocity"], "render", "out", "--field", "velocty")
        self.assert_refused(["unknown component w"], "render", "out", "--field", "velocity.w")
        self.assert_refused(["unknown component"], "render", "out", "--field", "gap.x")

    def test_options_that_make_no_sense(self):
        of_render = ((["invalid plane 'x'", "x=0.01"], ("--clip", "x")), (["invalid plane"], ("--clip", "w=3")),
                     (["invalid plane"], ("--clip", "x=nan")), (["must not be zero"], ("--clip", "0,0,0/0,0,0")),
                     (["invalid plane"], ("--clip", "0,0/1,0,0")), (["unknown part lid", "rod, table"], ("--hide", "lid")),
                     (["unknown part lid"], ("--only", "rod,lid")), (["all parts are hidden"], ("--hide", "rod,table")),
                     (["together with"], ("--hide", "rod", "--only", "rod")), (["empty name"], ("--hide", "rod,")),
                     (["unknown view 'sky'", "iso"], ("--view", "iso,sky")), (["several views"], ("--view", "iso,top", "--azimuth", "3")),
                     (["--time together with --film"], ("--film", "--time", "0")), (["invalid name of a film", ".gif"], ("--film", "-o", "x.mp4")),
                     (["--fps 0"], ("--film", "--fps", "0")), (["--size"], ("--view", "iso,top", "--size", "9000", "100")))
        for phrases, arguments in of_all(of_render, of_render[::4]):
            self.assert_refused(phrases, "render", "out", *arguments)
        of_plot = ((["--columns", "from 1 to 6"], ("--columns", "0")), (["from 1 to 6"], ("--columns", "many")),
                   (["unknown group of panels 'x'", "probes"], ("--panels", "x")), (["missing columns"], ("--panels", "probes")))
        for phrases, arguments in of_all(of_plot, of_plot[1:3]):
            self.assert_refused(phrases, "plot", "out", *arguments)

    def picture(self, *options, script="render", name="x.png"):
        done = self.script(script, "out", "-o", name, *options)
        self.assertEqual((done.returncode, done.stdout), (0, f"{name}\n"), done.stderr)
        picture = Image.open(os.path.join(self.folder, name))
        self.addCleanup(picture.close)
        return picture

    def colours(self, *options):
        """Pixels of the blue of the first part and of the orange of the second."""
        pixels = np.asarray(self.picture("--field", "part", "--size", "300", "240", *options).convert("RGB")).astype(int)
        pixels = pixels[40:, 90:300]  # without title, axes and names
        red, green, blue = (pixels[..., k] for k in range(3))
        return int(((blue > red + 60) & (blue > 80)).sum()), int(((red > blue + 90) & (green > blue + 40)).sum())

    def test_parts_are_hidden_and_cut(self):
        rod, table = self.colours()
        self.assertGreater(min(rod, table), 500)
        self.assertEqual(self.colours("--hide", "table")[1], 0)
        self.assertEqual(self.colours("--only", "table")[0], 0)
        self.assertEqual(self.colours("--clip", "0,0,0.25/0,0,1")[0], 0)    # the table's lower half alone
        self.assertEqual(self.colours("--clip", "0,0,0.25/0,0,-1")[1], 0)   # the rod alone
        self.assertGreater(min(self.colours("--clip", "y=0", "--clip", "x=0")), 500)

    def test_a_plane_beside_the_bodies_is_told(self):
        for told, *options in (("", "--clip", "z=0.25"), ("removes nothing", "--clip", "z=25"), ("removes all that is drawn", "--clip", "0,0,-25/0,0,1"),
                               ("--clip 9,0,0/1,0,0 removes nothing", "--clip", "z=0.25", "--clip", "9,0,0/1,0,0"),
                               ("removes nothing", "--hide", "rod", "--clip", "0,0,0.6/0,0,1"),
                               ("removes", "--film", "--clip", "x=-30")):
            done = self.script("render", "out", "-o", "x.gif" if "--film" in options else "x.png", "--size", "60", "50", *options)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1 if told else 0, done.stderr)
            if told:
                self.assertRegex(done.stderr, f"^render: warning: .*{told}")

    def test_several_views_and_films(self):
        self.assertEqual(self.picture("--size", "200", "160").size, (350, 200))
        self.assertEqual(self.picture("--view", "iso,front,top", "--size", "200", "160").size, (550, 360))
        records = 11 + 1  # every 1e-5 from 0 to 1e-4 or so, and the last
        for name in ("x.gif", "x.png", "x.webp"):
            film = self.picture("--film", "--size", "120", "100", name=name)
            self.assertLessEqual(abs(film.n_frames - records), 2, name)
            shown = []
            for frame in range(film.n_frames):
                film.seek(frame)
                shown.append(np.asarray(film.convert("RGB")))
            self.assertFalse((shown[0] == shown[-1]).all(), name)

    def test_panels_on_a_grid(self):
        header, *rows = self.text("out", "history.csv").splitlines()
        for count, across in ((0, 2), (1, 3), (9, 2), (40, 3)):
            names = [f",s{k}.{c} [m]" for k in range(count) for c in "xyz"]
            lines = [row + "".join(f",{(k + 1) * i % 7}" for k in range(3 * count)) for i, row in enumerate(rows)]
            self.write("out/history.csv", "\n".join([header + "".join(names), *lines, "1,2"]))
            picture = self.picture("--columns", str(across), script="plot")
            self.assertEqual(picture.size[0], across * 780)
        self.assertLess(picture.size[1], 10 * 442)  # forty probes share panels
        self.write("out/history.csv", "\n".join([header, ",".join(["nan"] * len(header.split(",")))]))
        self.assertEqual(self.script("plot", "out", "-o", "x.svg").returncode, 0)

    def test_pictures_are_drawn(self):
        end = self.summary("out")["end_time"]
        for name, *options in (("render",), ("render", "--time", "0"), ("render", "--time", str(end)), ("plot",)):
            done = self.script(name, "out", "-o", "x.png", *options)
            self.assertEqual((done.returncode, done.stdout), (0, "x.png\n"), done.stderr)
            self.assertGreater(os.path.getsize(os.path.join(self.folder, "x.png")), 10_000)
            os.remove(os.path.join(self.folder, "x.png"))


if __name__ == "__main__":
    unittest.main()
