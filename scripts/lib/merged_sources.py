#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Sources of tests as one: each in a namespace of its own below the headers of all, so that no names clash and headers are parsed once.

usage: merged_sources.py --groups LINES FILE...    a line a group: names of files with ';' between, LINES lines together at most
       merged_sources.py --write OUT FILE...       write the merged source
A source that includes something below its first lines, or opens a namespace that has a name, stays alone (CMakeLists.txt).
"""
import os
import re
import sys

NAMED = re.compile(r"^(inline )?namespace \w+( \{|::)", re.M)


def text_of(path):
    with open(path, encoding="utf-8") as stream:
        return stream.read()


def parted(text):
    """The first lines of comments and includes, and the rest; None where there are includes further down or named namespaces."""
    lines = text.splitlines()
    first = 0
    while first < len(lines) and (not lines[first].strip() or lines[first].startswith(("//", "#include"))):
        first += 1
    rest = "\n".join(lines[first:])
    if re.search(r"^\s*#", rest, re.M) or NAMED.search(rest):
        return None
    return lines[:first], rest


def include_of(line, folder):
    """The same from another folder."""
    match = re.match(r'#include "([^"]+)"', line)
    path = os.path.join(folder, match.group(1)) if match else ""
    return f'#include "{path}"' if match and os.path.isfile(path) else line


def merged(paths):
    includes, bodies = [], []
    for path in paths:
        head, rest = parted(text_of(path))
        includes += [include_of(line, os.path.dirname(path)) for line in head if line.startswith("#include")]
        name = re.sub(r"\W", "_", os.path.splitext(os.path.basename(path))[0])
        bodies.append(f'namespace of_{name} {{\n#line {len(head) + 1} "{path}"\n{rest}\n}}  // namespace of_{name}\n')
    return "\n".join([*dict.fromkeys(includes), "", *bodies])


def groups(most, paths):
    alone = [[path] for path in paths if parted(text_of(path)) is None]
    found, size = [], most
    for path in paths:
        text = text_of(path)
        if parted(text) is None:
            continue
        lines = text.count("\n")
        if size + lines > most:
            found.append([])
            size = 0
        found[-1].append(path)
        size += lines
    return found + alone


def main():
    if sys.argv[1] == "--groups":
        for group in groups(int(sys.argv[2]), sys.argv[3:]):
            print(";".join(group))
        return
    paths = sys.argv[3:]
    with open(sys.argv[2], "w", encoding="utf-8") as stream:
        stream.write(merged(paths) if len(paths) > 1 else f'#include "{paths[0]}"\n')


if __name__ == "__main__":
    main()
