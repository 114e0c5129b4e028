# SPDX-License-Identifier: Apache-2.0
"""The table of keys of a scene, as `brunt info --keys --json` prints it: the scene reference and the schema of editors are written from it."""
import collections
import json
import os
import subprocess

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")

Row = collections.namedtuple("Row", "key of accepted unit default meaning")


def maps():
    """Rows of each map, by its name; `of` is ["all"] where every kind has the key. The program is BRUNT of the environment, or that of
    the build."""
    program = os.environ.get("BRUNT") or os.path.join(ROOT, "build", "release", "brunt")
    done = subprocess.run([program, "info", "--keys", "--json"], capture_output=True, text=True, check=True)
    return {found["map"]: [Row(row["key"], row["of"] or ["all"], row["type"], row["unit"], row["default"], row["meaning"])
                           for row in found["keys"]] for found in json.loads(done.stdout)}


def update(path, text, check, script):
    """Writes a file; or says whether it has this text, which is the exit code."""
    with open(path, encoding="utf-8") as stream:
        same = stream.read() == text
    name = os.path.relpath(path, os.path.realpath(ROOT))
    if check:
        print(f"{name} " + ("is what the table of keys gives" if same else f"is stale: run scripts/lib/{script}"))
        return 0 if same else 1
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)
    return 0
