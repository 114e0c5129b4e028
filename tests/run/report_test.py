#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""scripts/report: what its page says of a result, of one with files missing or damaged, and of none. Needs BRUNT, BRUNT_RUN
(scripts/run) in the environment."""
import base64
import html.parser
import io
import json
import os
import subprocess
import unittest
import urllib.parse

import h5py
import numpy as np
from PIL import Image

import scenes
from run_test import PATIENCE, RUN, Program

SCRIPTS = os.path.dirname(RUN)
TITLE = "a rod & <script>alert('x')</script> </title>"
PROBES = """\
title: "a rod & <script>alert('x')</script> </title>"
rigid_walls: [{point: [0, 0, -3], normal: [0, 0, 1]}]
probes: [{name: "tip", node: 1, field: velocity}, {name: press, contact: [rod, table]}]
output: {every: 5.0e-6, fields: [displacement, velocity, stress]}
"""
VOID = {"img", "input", "meta"}


class Page(html.parser.HTMLParser):
    """Elements in order, with the text in them; elements that are not closed rightly are faults."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.open, self.elements, self.faults = [], [], []
        self.feed(text)
        self.close()
        self.faults += [f"{element[0]} is not closed" for element in self.open]

    def handle_starttag(self, tag, attributes):
        element = [tag, dict(attributes), ""]
        self.elements.append(element)
        if tag not in VOID:
            self.open.append(element)

    def handle_endtag(self, tag):
        if not self.open or self.open[-1][0] != tag:
            self.faults.append(f"{tag} closes {self.open[-1][0] if self.open else 'nothing'}")
        elif self.open:
            self.open.pop()

    def handle_data(self, data):
        for element in self.open:
            element[2] += data

    def all(self, tag, **attributes):
        wanted = {key.rstrip("_"): value for key, value in attributes.items()}
        return [e for e in self.elements if e[0] == tag and all(e[1].get(k) == v for k, v in wanted.items())]

    def text(self, tag="main"):
        return " ".join(self.all(tag)[0][2].split())

    def rows(self, section):
        """Cells of the tables of a section, row by row."""
        start = self.elements.index(self.all("section", id=section)[0])
        rows = []
        for tag, _, text in self.elements[start + 1:]:
            if tag == "section":
                break
            if tag == "tr":
                rows.append([])
            elif tag in ("td", "th"):
                rows[-1].append(text)
        return rows


def picture_of(uri):
    kind, _, data = uri.partition(";base64,")
    data = base64.b64decode(data)
    if kind == "data:image/svg+xml":
        return data.decode()
    picture = Image.open(io.BytesIO(data))
    picture.load()
    return picture


class Report(Program):
    def setUp(self):
        super().setUp()
        self.write("rod.yaml", scenes.ROD + PROBES)

    def run_rod(self, *arguments, code=0):
        self.run_scene(1, "rod.yaml", "--out", "out", "--set", "run.steps=20", *arguments, code=code)

    def report(self, *arguments):
        return subprocess.run([os.path.join(SCRIPTS, "report"), *arguments], cwd=self.folder, capture_output=True, text=True,
                              timeout=2 * PATIENCE, check=False)

    def page(self, *arguments):
        done = self.report("out", "-o", "page.html", *arguments)
        self.assertEqual((done.returncode, done.stdout), (0, "page.html\n"), done.stderr)
        text = self.text("page.html")
        page = Page(text)
        told = [line.removeprefix("report: warning: ") for line in done.stderr.splitlines()]
        missing = [h for h in page.all("h3") if h[2] == "Not in this report"]
        self.assertEqual(len(told) > 0, len(missing) > 0, done.stderr)
        for line in told:
            self.assertIn(" ".join(line.split()), page.text())
        self.assertEqual(page.faults, [])
        for word in ("nan", "inf", "None", "NaN"):
            self.assertFalse(f">{word}" in text, word)
        return page

    def test_the_page_of_a_whole_result(self):
        self.run_rod()
        page = self.page("--states", "5")
        self.assertEqual(page.text("title"), TITLE)
        self.assertEqual(page.text("h1"), TITLE)
        self.assertEqual(len(page.all("script")), 2)  # the film's pictures and its controls
        self.assertEqual([e[1]["id"] for e in page.all("section")],
                         ["warnings", "model", "pictures", "film", "energies", "motion", "probes", "cost", "files"])
        words, summary = page.text(), self.summary("out")
        for word in ("complete", "SI", summary["version"], summary["state_hash"], "elastic", "young 2.0e11 Pa",
                     "density 7800 kg/m\u00b3", "part: rod, velocity: [0, 0, -1]", "between: all", "gravity", "table", "hex8"):
            self.assertIn(word, words)
        energies = {row[0]: row[1] for row in page.rows("energies")}
        for name, value in summary["energy"].items():
            if name != "error_ratio":
                told = energies[name].replace("\u2212", "-").replace("\u00a0\u00d7\u00a010", "e").replace("\u00a0J", "")
                self.assertAlmostEqual(float(told), value, delta=1e-4 * abs(value))
                self.assertTrue(energies[name].endswith("\u00a0J"))

    def test_the_page_needs_nothing_but_itself(self):
        self.run_rod()
        page = self.page("--states", "7")
        for tag, attributes, _ in page.elements:
            for name in ("src", "href"):
                if tag == "a" and name in attributes:
                    target = urllib.parse.unquote(attributes[name])
                    self.assertTrue(os.path.isfile(os.path.join(self.folder, target)), target)
                elif name in attributes:
                    self.assertTrue(attributes[name].startswith("data:image/"), attributes[name][:60])
            self.assertNotIn(tag, ("link", "iframe", "object"))
        for image in page.all("img"):
            self.assertTrue(image[1]["alt"])
            picture = picture_of(image[1]["src"])
            if isinstance(picture, str):
                self.assertIn("<svg", picture)
            else:
                self.assertGreater(len(set(picture.convert("RGB").getdata())), 20)
        film = json.loads(page.all("script", type="application/json")[0][2])
        self.assertEqual((len(film["frames"]), len(film["times"])), (7, 7))
        self.assertEqual(len(set(film["frames"])), 7)
        self.assertTrue(all(time.startswith("t = ") and time.endswith(" s") for time in film["times"]), film["times"])

    def test_files_that_are_missing_or_damaged_are_a_sentence_each(self):
        self.run_rod()
        out = os.path.join(self.folder, "out")
        kept = {}
        for name in os.listdir(out):
            with open(os.path.join(out, name), "rb") as stream:
                kept[name] = stream.read()
        head = kept["history.csv"].splitlines(keepends=True)[0]
        last = kept["history.csv"].splitlines()[-1].split(b",")
        not_numbers = head + kept["history.csv"].splitlines(keepends=True)[1] + b",".join(last[:3] + [b"nan"] * (len(last) - 3)) + b"\n"
        damaged = (("state.h5", b"no file of HDF5", "cannot read the state file", "energies"), ("history.csv", None, "no curves over time", "model"),
                   ("history.csv", head, "missing history", "energies"), ("history.csv", not_numbers, "Probes", "probes"),
                   ("history.csv", head + b"1,2,3", "no complete row", "files"),
                   ("summary.json", None, "no summary.json", "model"), ("summary.json", b"{", "summary.json cannot be read", "model"),
                   ("summary.json", b"[1]", "summary.json is damaged", "model"),
                   ("summary.json", b'{"energy": {"kinetic": null, "total": NaN}, "share": [], "steps": "x", "contact": 3}', "unknown", "energies"),
                   ("log.txt", None, "no log.txt", "model"), ("scene_as_run.yaml", None, "no scene_as_run.yaml", "energies"),
                   ("scene_as_run.yaml", b"a: [", "scene_as_run.yaml cannot be read", "model"),
                   ("scene_as_run.yaml", b"materials: [1]\nparts: x\ncontact: {a: [b, {c: d}]}\n", "a: [b, {c: d}]", "model"))
        os.remove(os.path.join(out, "state.h5"))  # pictures take long, and have had their turn
        for name, content, sentence, section in damaged:
            with self.subTest(name=name, content=content and content[:20]):
                path = os.path.join(out, name)
                if content is None:
                    os.remove(path)
                else:
                    with open(path, "wb") as stream:
                        stream.write(content)
                page = self.page("--states", "0")
                self.assertIn(sentence, page.text())
                self.assertIn(section, [e[1]["id"] for e in page.all("section")])
                if name == "state.h5":
                    os.remove(path)
                    continue
                with open(path, "wb") as stream:
                    stream.write(kept[name])

    def test_results_of_which_nothing_can_be_read(self):
        self.run_rod()
        out = os.path.join(self.folder, "out")
        sizes = {name: os.path.getsize(os.path.join(out, name)) for name in ("summary.json", "history.csv", "state.h5")}
        for share in (0, 0.3):
            for name, size in sizes.items():
                with open(os.path.join(out, name), "r+b") as stream:
                    stream.truncate(min(int(share * size), 40))
            done = self.report("out")
            self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            for word in ("report: out: missing results", "summary.json", "history", "state", "expected"):
                self.assertIn(word, done.stderr)
            self.assertNotIn("report.html", os.listdir(out))
            for name in sizes:
                os.remove(os.path.join(out, name))
            self.run_rod("--force")

    def test_one_state_and_no_displacement(self):
        self.run_rod("--set", "output=null", "--set", "run.steps=1", "--force", "--set", "output.fields=[velocity]")
        page = self.page()
        self.assertIn("displacement was not written", page.text())
        self.assertNotIn("film", [e[1]["id"] for e in page.all("section")])
        with h5py.File(os.path.join(self.folder, "out", "state.h5"), "a") as state:
            del state["record_000001"]
        self.assertIn("one state only", self.page().text())
        with h5py.File(os.path.join(self.folder, "out", "state.h5"), "a") as state:
            state["record_000000/node/displacement"] = np.full(state["mesh/coordinates"].shape, np.nan)
        self.assertIn("are left out: step 0", self.page().text())
        with h5py.File(os.path.join(self.folder, "out", "state.h5"), "a") as state:
            del state["record_000000"]
        self.assertIn("no complete state", self.page().text())

    def test_bodies_that_go_far_stay_in_the_picture(self):
        self.write("rod.yaml", scenes.LONG.replace("100000000", "3000"))
        self.run_scene(1, "rod.yaml", "--out", "out", "--set", "output.every=1e-2", "--set", "initial.0.velocity=[0,0,-100]")
        page = self.page()
        self.assertIn("the pictures go with them", page.text())
        for image in page.all("img")[:6]:
            colours = picture_of(image[1]["src"]).convert("RGB").crop((0, 40, 520, 430)).getdata()
            self.assertGreater(sum(min(colour) < 200 for colour in colours), 0.1 * 520 * 390)

    def test_guard_and_restart_are_told(self):
        self.run_rod("--set", "run.steps=10")
        self.run_rod("--restart", "out")
        self.assertIn("Restarted from out/checkpoint_000000010.h5 at step 10.", self.page("--states", "0").text())
        self.write("rod.yaml", scenes.INVERTED_LATER)
        self.run_scene(1, "rod.yaml", "--out", "out", "--force", code=3)
        page = self.page("--states", "0")
        self.assertIn("stopped by a guard", page.text())
        self.assertIn("Stopped: ", page.text())
        self.assertTrue(page.all("span", class_="verdict bad"))

    def test_what_is_refused(self):
        self.run_rod()
        os.mkdir(os.path.join(self.folder, "empty"))
        for words, arguments in ((["does not exist"], ["nowhere"]), (["missing results"], ["empty"]), (["rod.yaml", "does not exist"], ["rod.yaml"]),
                                 (["does not exist"], ["out", "-o", "nowhere/x.html"]), (["it is a folder"], ["out", "-o", "out"]),
                                 (["unknown field nothing", "stress"], ["out", "--field", "nothing"]), (["unknown component w"], ["out", "--field", "velocity.w"]),
                                 (["--states", "expected"], ["out", "--states", "-1"]), (["--states", "expected"], ["out", "--states", "1e9"]),
                                 (["unknown option '--feild'", "--field"], ["out", "--feild", "x"]), (["result"], [])):
            done = self.report(*arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""), arguments)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            for word in ("report: ", *words):
                self.assertIn(word, done.stderr)
        self.assertNotIn("report.html", os.listdir(os.path.join(self.folder, "out")))


if __name__ == "__main__":
    unittest.main()
