#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Groups of sources that a compiler may read as one: they share no name that a source keeps to itself.

usage: source_groups.py MOST FILE...
    MOST: sources of a group at most
Prints a line a group, names of files with ';' between. Headers are parsed once a group, so a whole build takes a third of the
time (CMakeLists.txt). Two sources are kept apart where a name that one keeps to itself (in a namespace without a name,
by `using` or `static`) occurs in the other, or is declared by a header of the other, in whatever namespace.
"""
import functools
import os
import re
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)

WORD = re.compile(r"[A-Za-z_]\w*")
NOT_CODE = re.compile(r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/|\'(?:\\.|[^\'\\\n])\'|^\s*#[^\n]*', re.S | re.M)
NAMESPACE = re.compile(r"\bnamespace(\s+[\w:]+)?\s*$")
DECLARED = [  # what the head of a declaration declares, the first that fits
    re.compile(r"\busing\s+namespace\b()"),
    re.compile(r"\busing\s+(\w+)\s*="),
    re.compile(r"\busing\s+[\w:]*::(\w+)\s*$"),
    re.compile(r"\b(?:struct|class|enum|union|concept)\s+(?:class\s+|struct\s+|alignas\([^)]*\)\s+)?(\w+)"),
    re.compile(r"([\w:~]+)\s*\("),
    re.compile(r"(\w+)\s*(?:\[[^\]]*\]\s*)*(?:=.*)?$", re.S),
]


def code_of(text):
    """The text without comments, strings, characters and lines of the preprocessor."""
    return NOT_CODE.sub(" ", text)


def name_in(head):
    """The name that a declaration declares, from what stands before its body or its end; '' for none or one of a header."""
    head = re.sub(r"\[\[.*?\]\]", "", head).strip()
    while (shorter := re.sub(r"<[^<>]*>", " ", head)) != head:
        head = shorter
    for pattern in DECLARED:
        if found := pattern.search(head):
            name = found.group(1)
            return "" if "::" in name or name.isupper() else name  # capitals: TEST_CASE and other macros
    return ""


def declared_in(code, private=True):
    """Names that are declared outside of all functions and classes; private: those that no other source may use."""
    names, outer, head = set(), [], ""  # outer: of each open brace whether it is a namespace's, and whether it has no name

    def note():
        if all(of_namespace for of_namespace, _ in outer):
            own = any(nameless for _, nameless in outer) or re.match(r"\s*(using|static)\b", head)
            if own or not private:
                names.add(name_in(head))

    for part in re.split(r"([{};])", code):
        if part == "{":
            namespace = NAMESPACE.search(head)
            if not namespace:
                note()
            outer.append((bool(namespace), bool(namespace and not namespace.group(1))))
        elif part == "}":
            if outer:
                outer.pop()
        elif part == ";":
            note()
        else:
            head = part
            continue
        head = ""
    return names - {""}


def text_of(path):
    with open(path, encoding="utf-8") as stream:
        return stream.read()


def headers_of(text, folder):
    """Paths of the project's headers that a text in this folder includes."""
    for name in INCLUDE.findall(text):
        for place in (folder, os.path.join(ROOT, "src"), ROOT, os.path.join(ROOT, "tests")):
            if os.path.isfile(path := os.path.join(place, name)):
                yield os.path.realpath(path)
                break


@functools.cache
def reached_from(header):
    """This header and those that it includes."""
    text = text_of(header)
    return frozenset({header}).union(*(reached_from(other) for other in headers_of(text, os.path.dirname(header))))


@functools.cache
def declared_by(header):
    return frozenset(declared_in(code_of(text_of(header)), private=False))


def declared_in_headers(text, folder):
    """Names that the project's headers declare for a source in this folder."""
    reached = set().union(*(reached_from(header) for header in headers_of(text, folder)))
    return set().union(*(declared_by(header) for header in reached))


def groups_of(sources, most):
    """Lists of names of files; sources: (name, text) in the order in which they are dealt out, each to the first group it fits."""
    groups = []
    for name, text in sources:
        code = code_of(text)
        declared = declared_in(code)
        used = set(WORD.findall(code)) | declared_in_headers(text, os.path.dirname(name))
        for group in groups:
            if len(group["files"]) < most and not declared & group["used"] and not used & group["declared"]:
                break
        else:
            group = {"files": [], "declared": set(), "used": set()}
            groups.append(group)
        group["files"].append(name)
        group["declared"] |= declared
        group["used"] |= used
    return [group["files"] for group in groups]


def main():
    for group in groups_of([(name, text_of(name)) for name in sys.argv[2:]], int(sys.argv[1])):
        print(";".join(group))


if __name__ == "__main__":
    main()
