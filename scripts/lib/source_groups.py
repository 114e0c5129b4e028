#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Groups of sources that a compiler may read as one: they share no name that a source keeps to itself.

usage: source_groups.py MOST FILE...
    MOST: sources of a group at most
Prints a line a group, names of files with ';' between. Headers are parsed once a group, so a whole build takes a third of the
time (CMakeLists.txt). Two sources are kept apart where one declares a name outside of all functions and classes that occurs
anywhere in the other; what a header declares is the same for both.
"""
import re
import sys

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


def declared_in(code):
    """Names that are declared outside of all functions and classes."""
    names, outer, head = set(), [], ""
    for part in re.split(r"([{};])", code):
        if part == "{":
            if all(outer) and not NAMESPACE.search(head):
                names.add(name_in(head))
            outer.append(bool(NAMESPACE.search(head)))
        elif part == "}":
            if outer:
                outer.pop()
        elif part == ";":
            if all(outer):
                names.add(name_in(head))
        else:
            head = part
            continue
        head = ""
    return names - {""}


def groups_of(sources, most):
    """Lists of names of files; sources: (name, text) in the order in which they are dealt out, each to the first group it fits."""
    groups = []
    for name, text in sources:
        code = code_of(text)
        declared, used = declared_in(code), set(WORD.findall(code))
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
    sources = []
    for name in sys.argv[2:]:
        with open(name, encoding="utf-8") as stream:
            sources.append((name, stream.read()))
    for group in groups_of(sources, int(sys.argv[1])):
        print(";".join(group))


if __name__ == "__main__":
    main()
