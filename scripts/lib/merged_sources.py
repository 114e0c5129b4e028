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

from source_groups import code_of, declared_in, declared_in_headers, headers_of, reached_from, text_of

NAMED = re.compile(r"^(inline )?namespace \w+( \{|::)", re.M)


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


def functions(names, code):
    """Those that the code calls or declares as functions; types begin with a capital."""
    called = set(re.findall(r"\b([a-z_]\w*)\s*\(", code))
    return names & called


def code_of_headers(text, folder):
    reached = set().union(*(reached_from(header) for header in headers_of(text, folder)))
    return " ".join(code_of(text_of(header)) for header in sorted(reached))


def groups(most, paths):
    """Each source goes to the first group with room for it, where none of its functions has the name of one in a header that it does
    not include: a call would mean both, the other by the namespace of an argument. All other names are hidden by its own."""
    alone, found = [], []
    for path in paths:
        text = text_of(path)
        if parted(text) is None:
            alone.append([path])
            continue
        code = code_of(text)
        own = functions(declared_in(code), code)
        of_headers = functions(declared_in_headers(text, os.path.dirname(path)), code_of_headers(text, os.path.dirname(path)))
        lines = text.count("\n")
        for group in found:
            if group["lines"] + lines <= most and not own & group["of_headers"] and not of_headers & group["own"]:
                break
        else:
            group = {"files": [], "lines": 0, "own": set(), "of_headers": set()}
            found.append(group)
        group["files"].append(path)
        group["lines"] += lines
        group["own"] |= own
        group["of_headers"] |= of_headers
    return [group["files"] for group in found] + alone


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
