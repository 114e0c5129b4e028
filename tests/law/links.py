#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Every relative link and picture of every page (*.md) leads to a file of the tree, and every #anchor to a heading. Usage: links.py ROOT"""
import os
import re
import subprocess
import sys

import tree

LINK = re.compile(r"\]\(<?([^)\s>]+)>?(?: \"[^\"]*\")?\)")
OUTSIDE = re.compile(r"^[a-z][a-z0-9+.-]*:")  # https:, mailto:


def without_blocks(text):
    """Blocks of code empty, with their lines."""
    return re.sub(r"^(`{3,}|~{3,}).*?^\1\s*$", lambda block: "\n" * block[0].count("\n"), text, flags=re.M | re.S)


def anchors(text):
    """Of the headings, as GitHub makes them: lower case, no punctuation, hyphens for spaces, a number where one repeats."""
    found, seen = set(), {}
    for heading in re.findall(r"^#{1,6} +(.*?)[ #]*$", without_blocks(text), re.M):
        heading = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        name = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        found.add(f"{name}-{seen[name]}" if name in seen else name)
        seen[name] = seen.get(name, 0) + 1
    return found


def pages(root):
    """Those that git knows or would take; without git all."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "*.md"], cwd=root, capture_output=True, text=True, check=False)
    found = listed.stdout.splitlines() if listed.returncode == 0 else tree.files(root, ("",), (".md",))
    return sorted(page for page in found if os.path.isfile(os.path.join(root, page)))


def faults_of(root, page):
    found = []
    for line, content in enumerate(without_blocks(tree.read(root, page)).splitlines(), 1):
        for target in LINK.findall(re.sub(r"(`+)[^`]+\1(?!\()", "", content)):
            if OUTSIDE.match(target):
                continue
            path, _, anchor = target.partition("#")
            file = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
            if not os.path.exists(os.path.join(root, file)):
                found.append(f"{page}:{line}: {target}: no such file")
            elif anchor and file.endswith(".md") and anchor not in anchors(tree.read(root, file)):
                found.append(f"{page}:{line}: {target}: no such heading")
    return found


def faults(root):
    every = pages(root)
    return [fault for page in every for fault in faults_of(root, page)], f"{len(every)} pages"


if __name__ == "__main__":
    sys.exit(tree.report("links", *faults(sys.argv[1])))
