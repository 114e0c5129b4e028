# SPDX-License-Identifier: Apache-2.0
"""What scripts/study and scripts/pareto share: study files, runs with overrides, tables."""
import csv
import difflib
import json
import os
import subprocess
import sys

import yaml

import bounded_yaml

SCRIPTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
WRONG_INPUT = 2


class Study:
    """A study file: a map of known keys. Each fault is one line on the error stream and exit code 2."""

    def __init__(self, program, path, keys):
        self.program, self.path, self.folder = program, path, os.path.dirname(os.path.abspath(path))
        self.results = os.path.splitext(os.path.abspath(path))[0] + ".out"
        try:
            with open(path, encoding="utf-8") as stream:
                self.tree = bounded_yaml.load(stream.read())
        except OSError as error:
            self.stop(f"cannot read the file ({error.strerror}); expected a study file")
        except UnicodeDecodeError as error:
            self.stop(f"cannot read the file ({error}); expected a study file")
        except yaml.YAMLError as error:
            what = " ".join(str(error).split())
            self.stop(what if "; expected" in what else f"invalid YAML: {what}; expected a study file")
        if not isinstance(self.tree, dict):
            self.stop(f"invalid study; expected a map of {', '.join(keys)}")
        for key in self.tree:
            if key not in keys:
                self.stop(f"{key}: unknown key; expected one of {', '.join(keys)}")

    def stop(self, what):
        print(f"{self.program}: {self.path}: {what}", file=sys.stderr)
        sys.exit(WRONG_INPUT)

    def make_folder(self):
        try:
            os.makedirs(self.results, exist_ok=True)
        except OSError as error:
            self.stop(f"cannot create the folder {self.results} ({error.strerror}); expected a study in a writable folder")

    def value(self, key, kind, expected, default=None):
        """The value of a key, of one kind and not empty; without a default the key must be there."""
        found = self.tree.get(key, default)
        if not isinstance(found, kind) or isinstance(found, bool) or not found:
            self.stop(f"{key}: missing or of the wrong kind; expected {expected}")
        return found

    def count(self, key, default):
        found = self.value(key, int, "an integer >= 1", default)
        if found < 1:
            self.stop(f"{key}: out of range: {found}; expected an integer >= 1")
        return found

    def demand_folder_name(self, key, name):
        """Results go to a folder of this name: it must be one within that of the study."""
        name = str(name)
        if name in ("", ".", "..") or any(c == "/" or not c.isprintable() for c in name):
            self.stop(f"{key}: invalid name {name!r} of a folder; expected a name without '/', such as coarse")

    def override_maps(self, key, default=None):
        """A map of names to overrides {key path: value}, which may be empty."""
        maps = self.value(key, dict, "a map of name: overrides", default)
        for name, overrides in maps.items():
            if not isinstance(overrides or {}, dict):
                self.stop(f"{key}.{name}: invalid overrides; expected a map of key path: value")
        return {str(name): dict(overrides or {}) for name, overrides in maps.items()}


def nearest_of(word, known):
    """", nearest is 'x'" where some known word is near."""
    near = difflib.get_close_matches(word, known, 1)
    return f", nearest is '{near[0]}'" if near else ""


def set_options(overrides):
    pairs = (f"{key}={value if isinstance(value, str) else json.dumps(value)}" for key, value in overrides.items())
    return [word for pair in pairs for word in ("--set", pair)]


def run_scene(scene, overrides, ranks, out):
    """Runs the scene into `out` and returns the exit code."""
    command = [os.path.join(SCRIPTS, "run"), "-np", str(ranks), scene, "--out", out, "--force", "--quiet"]
    return subprocess.run(command + set_options(overrides), check=False).returncode


def read_summary(folder):
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as stream:
        return json.load(stream)


def cell(value):
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def write_table(path, rows):
    """To a csv file, and to the terminal as a table; the first row is the head."""
    with open(path, "w", newline="", encoding="utf-8") as stream:
        csv.writer(stream).writerows(rows)
    for i, row in enumerate(rows):
        print("| " + " | ".join(row) + " |" + ("\n" + "|---" * len(row) + "|" if i == 0 else ""))
