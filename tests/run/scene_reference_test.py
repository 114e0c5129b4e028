#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The tables of src/scene/README.md say what the reader does: the keys that it knows and no others, with the types and ranges that it
accepts and the keys that it requires. Scenes with an unknown key, a wrong value and no key at all in each map make the reader list what
it knows, accepts and misses. Needs BRUNT and BRUNT_CASES (the folder cases/) in the environment."""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "lib"))
import scene_page  # noqa: E402
from scene_places import BODIES, CONTEXTS, LISTS, SINGLE, Scenes

ROOT = os.path.dirname(os.environ["BRUNT_CASES"])
UNKNOWN = "no_such_key"
WRONG = {"list": [], "map": {UNKNOWN: 1}}  # what no number, word or text is; a value that accepts one of them says so of the other
NO_TABLE = {"curves", "rigid_walls.friction", "mesh.BODY.rotate"} | {f"mesh.{body}" for body in BODIES}  # curves: lists; others: shared

OF_TYPE = re.compile(r"a list of \d+ is given|a map is given|invalid list|invalid map|.*in this version|this version does not have")


def page():
    with open(os.path.join(ROOT, "src", "scene", "README.md"), encoding="utf-8") as stream:
        return stream.read()


def faults_of_text(text):
    """(path, what is wrong, what is accepted) of every fault of a scene."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "scene.yaml"), "w", encoding="utf-8") as stream:
            stream.write(text)
        done = subprocess.run([os.environ["BRUNT"], "check", "scene.yaml"], cwd=folder, capture_output=True, text=True, timeout=60)
    assert done.returncode in (0, 2), done.stdout + done.stderr
    found = []
    for line in done.stderr.splitlines():
        if fault := re.match(r"(?:brunt: )?scene\.yaml(?::\d+)?: (\S+): (.*)$", line):
            what, accepted = re.match(r"(.*?)(?:; (?:accepted:|expected) ((?:(?!; (?:accepted:|expected) ).)*))?$", fault[2]).groups()
            found.append((fault[1], what, accepted or ""))
    return found


def words_of(accepted):
    return set(re.sub("^one of ", "", accepted).split(", "))


def together(kinds):
    """Words that are listed in several places count as one list."""
    words = frozenset().union(*(kind for kind in kinds if isinstance(kind, frozenset)))
    return {kind for kind in kinds if not isinstance(kind, frozenset)} | ({words} if words else set())


class Reference(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        """All maps go into a dozen scenes, before the first of them is read."""
        cls.tables, cls.scenes, cls.faults = scene_page.tables(page()), Scenes(), {}
        cls.unknown, cls.wrong, cls.empty, cls.in_lists = [], [], [], []
        for name, rows in cls.tables.items():
            for of, context in CONTEXTS.get(name, [("all", {})]):
                cls.unknown.append((name, of, cls.scenes.put(name, of, {**context, UNKNOWN: 1})))
                cls.empty.append((name, of, context, cls.scenes.put(name, of, dict(context))))
                own = [row for row in rows if of in row.of or "all" in (of, *row.of)]
                if name in SINGLE or name == "scene":
                    cls.put_wrong_together(name, own)
                    continue
                for row in own:
                    if row.key not in context:
                        cls.put_wrong(name, of, context, row)
        cls.in_lists.append(("output", "fields", cls.words_of_table("field"), cls.scenes.put("output", "all", {"fields": [UNKNOWN]})))

    @staticmethod
    def words_of_table(head):
        """Words in the first column of the table with this heading."""
        rows = re.search(rf"\n\| {head} \|.*\n((?:\|.*\n)+)", page())[1]
        return frozenset(word for line in rows.splitlines()[1:] for word in re.findall(r"`(\w+)`", line.split("|")[1]))

    @classmethod
    def put_wrong_together(cls, name, rows):
        for kind, bad in WRONG.items():
            place = cls.scenes.put(name, "all", {row.key: bad for row in rows})
            cls.wrong += [(name, row, kind, place) for row in rows]

    @classmethod
    def put_wrong(cls, name, of, context, row):
        cls.wrong += [(name, row, kind, cls.scenes.put(name, of, {**context, row.key: bad})) for kind, bad in WRONG.items()]
        if words := scene_page.listed_words(row.accepted):
            cls.in_lists.append((name, row.key, words, cls.scenes.put(name, of, {**context, row.key: [UNKNOWN]})))

    def at(self, place, *keys):
        """What is wrong and what is accepted at a key of a map."""
        number, path = place
        if number not in self.faults:
            self.faults[number] = faults_of_text(json.dumps(self.scenes.scenes[number]))
        path = ".".join([path] * bool(path) + list(keys))
        return [(what, accepted) for found, what, accepted in self.faults[number] if found == path]

    def test_keys(self):
        known = {}
        for name, of, place in self.unknown:
            words = [accepted for what, accepted in self.at(place, UNKNOWN) if what.startswith("unknown key")]
            self.assertEqual(len(words), 1, (name, of))
            known.setdefault((name, of), set()).update(words_of(words[0]))
        for (name, of), keys in known.items():
            with self.subTest(map=name, of=of):
                own = {row.key for row in self.tables[name] if of in row.of or "all" in (of, *row.of)}
                self.assertEqual(own & keys if "..." in keys else own, keys - {"..."})  # a message lists the first two dozen

    def test_examples(self):
        """Parts of scenes, in which nothing is wrong but what they leave out."""
        examples = re.findall(r"```yaml\n(.*?)```", page(), re.S)
        self.assertGreater(len(examples), 10)
        for example in examples:
            for path, what, _ in faults_of_text(example):
                with self.subTest(path=path, fault=what):
                    self.assertTrue(path.startswith("scaling.") or re.match("missing|unknown (curve|part|material)", what))

    def test_every_map_has_a_table(self):
        inner = {f"{name}.{row.key}".replace("scene.", "") for name, rows in self.tables.items() for row in rows
                 if "map" in scene_page.kinds(row.accepted)}
        self.assertEqual(inner - NO_TABLE, set(self.tables) - {*LISTS, "scaling.weak", "mesh.BODY", "scene"})

    def test_types_and_ranges(self):
        said, silent = {}, set()
        for name, row, kind, place in self.wrong:
            kinds = said.setdefault((name, row.key, row.accepted), set())
            for what, accepted in self.at(place, row.key):
                if OF_TYPE.match(what):
                    kinds |= scene_page.kinds(accepted)
            if self.at(place, row.key, UNKNOWN):
                kinds.add("map")
            if kind == "list" and not self.at(place, row.key):
                silent.add((name, row.key))
        said["contact", "method", next(row.accepted for row in self.tables["contact"] if row.key == "method")].add(frozenset({"mortar"}))
        for (name, key, accepted), kinds in said.items():
            if kinds == {"map"} and (name, key) in silent:  # a list of maps, or none
                kinds.add("list")
            wanted = scene_page.kinds(accepted)
            if accepted == "word":
                wanted = {self.words_of_table(r"`field` \| of")}
            with self.subTest(map=name, key=key, page=accepted):
                self.assertEqual(together(wanted), together(kinds))

    def test_words_in_lists(self):
        said, wanted = {}, {}
        for name, key, words, place in self.in_lists:
            wanted[name, key] = words
            said.setdefault((name, key), set()).update(*(words_of(accepted) for _, accepted in self.at(place, key, "0")))
        self.assertIn(("mesh.BODY", "half"), wanted)
        self.assertEqual(wanted, said)

    def test_required(self):
        missing = {}
        for name, of, context, place in self.empty:
            for row in self.tables[name]:
                if row.key not in context and (of in row.of or "all" in (of, *row.of)):
                    lacks = any(what.startswith("missing") for what, _ in self.at(place, row.key))
                    named = any(re.search(rf"\b{row.key}\b", f"{what} {accepted}") for what, accepted in self.at(place))
                    missing.setdefault((name, row.key, row.default), []).append((lacks, named))
        for (name, key, default), lacks in missing.items():
            with self.subTest(map=name, key=key, default=default):
                if any(at_key for at_key, _ in lacks):
                    self.assertTrue(default.startswith("required"))
                if default.startswith("required"):
                    self.assertTrue(any(at_key or at_map for at_key, at_map in lacks))


if __name__ == "__main__":
    unittest.main()
