#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The tables of keys of src/scene/README.md, and what a phrase about accepted values means: in a cell of the page or in a message of the
reader.

usage: scene_page.py [--check]       write the tables into the page, or say whether they are what the table of keys gives
"""
import fractions
import os
import re
import sys

import scene_keys

PAGE = os.path.join(scene_keys.ROOT, "src", "scene", "README.md")
TABLE = re.compile(r"(<!-- keys of: (\S+) -->\n)((?:\|.*\n)+)")
COUNTLESS = 10**9  # bounds of counts from here on are those of the machine's integers
NOUNS = ("map", "list", "name", "text", "number", "word", "duration")

def tables(text):
    """Rows of each table of keys of a page, by the name in the comment before it."""
    found = {}
    for _, name, table in TABLE.findall(text):
        cells = [[cell.strip() for cell in line.strip("|\n").split(" | ")] for line in table.splitlines()]
        rows = [dict(zip(cells[0], row)) for row in cells[2:]]
        found[name] = [scene_keys.Row(row["key"].strip("`"), row.get("of", "all").split(", "), row["type and range"], row["unit"],
                                      row["default"], row["meaning"]) for row in rows]
    return found


def table(rows):
    """The lines of a table; the column `of` only where kinds differ."""
    kinds_differ = any(row.of != ["all"] for row in rows)
    heads = ["key", *["of"] * kinds_differ, "type and range", "unit", "default", "meaning"]
    lines = [[f"`{row.key}`", *[", ".join(row.of)] * kinds_differ, row.accepted, row.unit, row.default, row.meaning] for row in rows]
    return "".join(["| " + " | ".join(heads) + " |\n", "|" + "---|" * len(heads) + "\n"] + ["| " + " | ".join(line) + " |\n" for line in lines])


def written(text, maps):
    """The page with the tables of these maps."""
    assert sorted(name for _, name, _ in TABLE.findall(text)) == sorted(maps), "each map has one table in the page"
    return TABLE.sub(lambda found: found[1] + table(maps[found[2]]), text)


def limits(phrase):
    """(low, low is included, high, high is included) of "number > 0 and <= 1", "integer from 1 to 5"."""
    low, low_in, high, high_in = -float("inf"), False, float("inf"), False
    for sign, bound in re.findall(r"(>=|<=|>|<) (-?[\d./e]+)", phrase):
        if ">" in sign:
            low, low_in = float(fractions.Fraction(bound)), sign == ">="
        else:
            high, high_in = float(fractions.Fraction(bound)), sign == "<="
    if span := re.search(r"from (-?[\d./e]+) to (-?[\d./e]+)", phrase):
        low, high, low_in, high_in = float(fractions.Fraction(span[1])), float(fractions.Fraction(span[2])), True, True
    if high >= COUNTLESS:
        high, high_in = float("inf"), False
    return low, low_in, high, high_in


def kind(phrase):
    """One alternative of a phrase."""
    phrase = re.sub(r"^(an?|the|one of) ", "", phrase.strip())
    if re.match(r"three numbers \[x, y, z\], not all zero|direction", phrase):
        return "direction"
    if re.match(r"three numbers|`\[x, y, z\]`", phrase):
        return "vector"
    if re.match(r"(number|integer|angle)\b", phrase):
        return (("integer" if phrase.startswith("integer") else "number"), *limits(phrase))
    if re.match(r"\{|map\b", phrase):
        return "map"
    if re.match(r"list\b|two |three |\d numbers|\[|pair ", phrase):
        return "list"
    return "text"


def kinds(phrase):
    """All alternatives of a phrase: kinds, and the set of its words if it lists some."""
    phrase = re.sub(r" such as .*", "", phrase)
    if phrase == "true or false":
        return {frozenset({"true", "false"})}
    while (plainer := re.sub(r"\{[^{}]*\}", "MAP", phrase)) != phrase:
        phrase = plainer
    phrase = phrase.replace("a map MAP", "a map").replace("MAP or MAP", "MAP").replace("MAP", "{}")
    phrase = re.sub(r"a map (with|that) .*", "a map", phrase)
    for pair in ("name or number", "names or numbers", "set or part", "body or file"):
        phrase = phrase.replace(pair, pair.split()[0])
    found, words = set(), set()
    for part in re.split(r",? or ", re.sub(r"^one of (?!\{)", "", phrase)):
        quoted = re.fullmatch(r"(`[^`\[]+`(, )?)+(name|)", part)
        plain = "`" not in part and re.fullmatch(r"[\w-]+(, [\w-]+)*", part) and part not in NOUNS
        if quoted or plain:
            words.update(re.findall(r"`([^`]+)`", part) if quoted else part.split(", "))
            if part.endswith("name"):
                found.add("text")
        else:
            found.add(kind(part))
    if {"a", "b"} <= words:  # parts of the scene
        words -= {"a", "b"}
        found.add("text")
    return found | ({frozenset(words)} if words else set())


def listed_words(accepted):
    """The words that may stand in a list: "list of `x`, `y`"."""
    return set(re.findall(r"`([\w-]+)`", accepted)) if accepted.startswith("list of `") else set()


def main():
    with open(PAGE, encoding="utf-8") as stream:
        text = written(stream.read(), scene_keys.maps())
    sys.exit(scene_keys.update(PAGE, text, "--check" in sys.argv[1:], "scene_page.py"))


if __name__ == "__main__":
    main()
