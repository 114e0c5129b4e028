#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The JSON Schema of scenes, from the table of keys. Editors complete and check scenes with it:
`# yaml-language-server: $schema=PATH` in the first line of a scene.

usage: scene_schema.py [--check]       write src/scene/scene.schema.json, or say whether it is what the table gives
"""
import json
import os
import re
import sys

import scene_keys
import scene_page

SCHEMA = os.path.join(scene_keys.ROOT, "src", "scene", "scene.schema.json")
BODIES = ("box", "cylinder", "sphere", "tube", "torus", "plate")
NAMED = ("materials", "parts", "sets")  # maps from names to the maps of their tables
NAME = {"type": ["string", "integer"]}  # blocks and sets may be named by numbers
VECTOR = {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}
ROTATION = "mesh.rotate"
KINDS = {"materials.eos": "model", "mesh.BODY.nose": "shape"}  # the key that decides which others a map has


def number(kind, low, low_in, high, high_in):
    found = {"type": kind}
    for bound, infinite, is_in, word in ((low, -float("inf"), low_in, "minimum"), (high, float("inf"), high_in, "maximum")):
        if bound != infinite:
            found[word if is_in else "exclusive" + word.capitalize()] = int(bound) if bound == int(bound) else bound
    return found


def listed(phrase):
    """A list: its length and its entries, as far as a phrase says them."""
    found = {"type": "array"}
    if count := re.match(r"list of (\d+) ", phrase):
        found["minItems"] = found["maxItems"] = int(count[1])
    if words := scene_page.listed_words(phrase):
        found["items"] = {"enum": sorted(words)}
    elif entry := re.match(r"list of \d+ ((?:number|integer)s?\b.*)", phrase):
        kind, *bounds = next(iter(scene_page.kinds(re.sub("^(number|integer)s", r"\1", entry[1]))))
        entries = [number(kind, *bounds)]
        if kind == "integer":
            entries.append({"type": "array"})  # places and sizes of graded elements
        found["items"] = entries[0] if len(entries) == 1 else {"anyOf": entries}
    return found


def single(kind, phrase, inner):
    if isinstance(kind, frozenset):
        return {"type": "boolean"} if kind == {"true", "false"} else {"enum": sorted(kind)}
    if isinstance(kind, tuple):
        return number(*kind)
    if kind in ("vector", "direction"):
        return VECTOR
    if kind == "map":
        return inner or {"type": "object"}
    if kind == "list":
        return {"type": "array", "items": inner} if inner else listed(phrase)
    if phrase == "text":  # a title may be a number
        return {"type": ["string", "number", "boolean"]}
    return {"type": ["string", "number"]} if phrase == "duration" else {"type": "string"} if phrase == "word" else NAME


def one_of_each(rows):
    """Groups of keys of which one at least is given: "required, or `set`", or "required, or another motion"."""
    alternatives = {row.key: re.match("required, or (.*)", row.default) for row in rows}
    others = [key for key, found in alternatives.items() if found and "`" not in found[1]]
    groups = {tuple(sorted({key, *re.findall("`([^`]+)`", found[1])})) if "`" in found[1] else tuple(sorted(others))
              for key, found in alternatives.items() if found}
    return sorted(group for group in groups if len(group) > 1)


class Schema:
    def __init__(self, tables):
        self.tables = tables

    def of_map(self, table, of="all"):
        """The object of one table, with the rows of `of` where they differ."""
        rows = [row for row in self.tables[table] if "all" in row.of or of in row.of]
        found = {"type": "object", "additionalProperties": False, "properties": {row.key: self.of_key(table, row) for row in rows}}
        if required := [row.key for row in rows if row.default == "required"]:
            found["required"] = required
        if groups := one_of_each(rows):
            found["allOf"] = [{"anyOf": [{"required": [key]} for key in group]} for group in groups]
        return found

    def of_key(self, table, row):
        path = row.key if table == "scene" else f"{table}.{row.key}"
        alternatives = [single(kind, row.accepted, self.inner(path, row)) for kind in sorted(scene_page.kinds(row.accepted), key=str)]
        meaning = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", row.meaning).replace("`", "")
        described = {"description": meaning + (f" [{row.unit}]" if row.unit != "-" else "")}
        return {**described, **(alternatives[0] if len(alternatives) == 1 else {"anyOf": alternatives})}

    def inner(self, path, row):
        """What a map, or each entry of a list of maps, must be; None where any will do."""
        if path.endswith(".rotate") and not path.startswith("symmetry"):
            path = ROTATION
        if path in ("rigid_walls.friction", "contact.friction"):
            return self.of_map("contact.friction")
        if path == "mesh":
            bodies = {body: self.of_map("mesh.BODY", body) for body in BODIES}
            entry = self.of_map("mesh")
            entry["properties"].update({body: {**entry["properties"][body], **bodies[body]} for body in BODIES})
            return entry
        if path == "materials":
            return self.materials()
        if path in KINDS:
            return {"anyOf": [self.of_kind(path, KINDS[path], word) for word in self.words(path, KINDS[path])]}
        if path == "curves":
            points = {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}
            return {"type": "object", "additionalProperties": {"type": "array", "items": points, "minItems": 1}}
        if path in NAMED:
            return {"type": "object", "additionalProperties": self.of_map(path)}
        return self.of_map(path) if path in self.tables and row.key not in BODIES else None

    def words(self, table, key):
        """The words of a key, in the order of the table."""
        return re.findall("`([^`]+)`", next(row.accepted for row in self.tables[table] if row.key == key))

    def of_kind(self, table, key, word):
        """The object of one kind, which a word of this key names."""
        found = self.of_map(table, word)
        found["properties"][key] = {"const": word}
        return found

    def materials(self):
        chosen = [{"if": {"properties": {"model": {"const": model}}}, "then": self.of_kind("materials", "model", model)}
                  for model in sorted(self.words("materials", "model"))]
        row = next(row for row in self.tables["materials"] if row.key == "model")
        return {"type": "object", "additionalProperties": {"type": "object", "required": ["model"], "allOf": chosen,
                                                           "properties": {"model": self.of_key("materials", row)}}}

    def whole(self):
        return {"$schema": "http://json-schema.org/draft-07/schema#", "title": "A scene of Brunt", **self.of_map("scene")}


def main():
    text = json.dumps(Schema(scene_keys.maps()).whole(), indent=1) + "\n"
    sys.exit(scene_keys.update(SCHEMA, text, "--check" in sys.argv[1:], "scene_schema.py"))


if __name__ == "__main__":
    main()
