#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The JSON Schema of scenes, from the tables of keys of src/scene/README.md (tests/run/scene_reference_test.py holds these against
the reader). Editors complete and check scenes with it: `# yaml-language-server: $schema=PATH` in the first line of a scene.

usage: scene_schema.py [--check]       write src/scene/scene.schema.json, or say whether it is what the tables give
"""
import json
import os
import re
import sys

import scene_page

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")

PAGE, SCHEMA = os.path.join(ROOT, "src", "scene", "README.md"), os.path.join(ROOT, "src", "scene", "scene.schema.json")
BODIES = ("box", "cylinder", "sphere", "tube", "torus", "plate")
NAMED = ("materials", "parts", "sets")  # maps from names to the maps of their tables
NAME = {"type": ["string", "integer"]}  # blocks and sets may be named by numbers
VECTOR = {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}
ROTATION = "mesh.rotate"


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
    def __init__(self, page):
        self.tables = scene_page.tables(page)
        self.meanings = {(name, cells[0].strip("`")): cells for name, table in re.findall(r"<!-- keys of: (\S+) -->\n((?:\|.*\n)+)", page)
                         for cells in ([cell.strip() for cell in line.strip("|\n").split(" | ")] for line in table.splitlines()[2:])}

    def of_map(self, table, of="all"):
        """The object of one table, with the rows of `of` where they differ."""
        rows = [row for row in self.tables[table] if "all" in row.of or of in row.of]
        found = {"type": "object", "additionalProperties": False, "properties": {row.key: self.of_key(table, row) for row in rows}}
        if table == "mesh.BODY" and of == "tube":  # with `sector` it may be 0
            found["properties"]["inner_radius"] = {**found["properties"]["inner_radius"], **number("number", 0, True, float("inf"), False)}
            found["properties"]["inner_radius"].pop("exclusiveMinimum")
        always = [row for row in rows if not self.meanings[table, row.key][-1].startswith("Of ")]  # of one shape alone
        if required := [row.key for row in always if row.default == "required"]:
            found["required"] = required
        if groups := one_of_each(always):
            found["allOf"] = [{"anyOf": [{"required": [key]} for key in group]} for group in groups]
        return found

    def of_key(self, table, row):
        path = row.key if table == "scene" else f"{table}.{row.key}"
        alternatives = [single(kind, row.accepted, self.inner(path, row)) for kind in sorted(scene_page.kinds(row.accepted), key=str)]
        meaning = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", self.meanings[table, row.key][-1]).replace("`", "")
        unit = self.meanings[table, row.key][-3]
        described = {"description": meaning + (f" [{unit}]" if unit not in ("-", "") else "")}
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
        if path == "materials.eos":
            return {"anyOf": [self.of_model(path, model) for model in ("mie_gruneisen", "linear_polynomial")]}
        if path == "curves":
            points = {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}
            return {"type": "object", "additionalProperties": {"type": "array", "items": points, "minItems": 1}}
        if path in NAMED:
            return {"type": "object", "additionalProperties": self.of_map(path)}
        return self.of_map(path) if path in self.tables and row.key not in BODIES else None

    def of_model(self, table, model):
        found = self.of_map(table, model)
        found["properties"]["model"] = {"const": model}
        return found

    def materials(self):
        rows = {row.key: row for row in self.tables["materials"]}
        models = sorted(next(iter(scene_page.kinds(rows["model"].accepted))))
        chosen = [{"if": {"properties": {"model": {"const": model}}}, "then": self.of_model("materials", model)} for model in models]
        return {"type": "object", "additionalProperties": {"type": "object", "required": ["model"], "allOf": chosen,
                                                           "properties": {"model": self.of_key("materials", rows["model"])}}}

    def whole(self):
        return {"$schema": "http://json-schema.org/draft-07/schema#", "title": "A scene of Brunt", **self.of_map("scene")}


def text_of_schema():
    with open(PAGE, encoding="utf-8") as stream:
        return json.dumps(Schema(stream.read()).whole(), indent=1) + "\n"


def main():
    text = text_of_schema()
    if "--check" in sys.argv[1:]:
        with open(SCHEMA, encoding="utf-8") as stream:
            same = stream.read() == text
        print("scene.schema.json " + ("is what the tables give" if same else "is stale: run scripts/lib/scene_schema.py"))
        sys.exit(0 if same else 1)
    with open(SCHEMA, "w", encoding="utf-8") as stream:
        stream.write(text)


if __name__ == "__main__":
    main()
