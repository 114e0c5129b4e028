# SPDX-License-Identifier: Apache-2.0
"""What a report says: the files of a result folder, each of which may be missing or damaged; a sentence says so then."""
import json
import os

import yaml

from arguments import Fault
from history import History
from state import State

FILES = {"summary.json": "how the run went", "history.csv": "figures over time", "state.h5": "fields over time",
         "state.xdmf": "opens state.h5 in ParaView", "log.txt": "what the terminal showed", "scene_as_run.yaml": "the scene"}


class Result:
    """summary, scene, history, state: None where there is none, with a sentence in `missing`."""

    def __init__(self, folder):
        self.folder = folder
        self.missing = []
        if not os.path.isdir(folder):
            raise Fault(f"{folder}: cannot read the folder: it does not exist; expected a result folder of brunt run")
        if not any(os.path.isfile(self.path(name)) for name in ("summary.json", "history.csv", "state.h5", "log.txt")):
            raise Fault(f"{folder}: missing results; expected a result folder of brunt run (with summary.json, state.h5, ...)")
        self.summary = self.read_summary()
        self.log = self.read_log()
        self.scene_text, self.scene = self.read_scene()
        self.history = self.read_history()
        self.state = self.read_state()
        if not (self.summary or self.history or self.state):
            raise Fault(f"{folder}: missing results: no file of them can be read ({' '.join(self.missing)}); expected a result folder of brunt run")

    def path(self, name):
        return os.path.join(self.folder, name)

    def text(self, name):
        with open(self.path(name), encoding="utf-8", errors="replace") as stream:
            return stream.read()

    def read_summary(self):
        try:
            summary = json.loads(self.text("summary.json"))
            if isinstance(summary, dict):
                return summary
            self.missing.append("summary.json is damaged (it holds no object).")
        except FileNotFoundError:
            self.missing.append("There is no summary.json: the run goes on still, or it ended without writing one.")
        except (OSError, ValueError) as error:
            self.missing.append(f"summary.json cannot be read ({error}).")
        return {}

    def read_log(self):
        try:
            return self.text("log.txt").splitlines()
        except OSError:
            self.missing.append("There is no log.txt, so that warnings of the run are not known.")
            return []

    def read_scene(self):
        """As text, and as maps and lists of text."""
        try:
            text = self.text("scene_as_run.yaml")
        except OSError:
            self.missing.append("There is no scene_as_run.yaml, so that materials and loads are not known.")
            return "", {}
        try:
            tree = yaml.load(text, Loader=yaml.BaseLoader)  # keeps numbers as they were written
        except (yaml.YAMLError, RecursionError) as error:
            self.missing.append(f"scene_as_run.yaml cannot be read ({' '.join(str(error).split())}).")
            tree = None
        return text, tree if isinstance(tree, dict) else {}

    def read_history(self):
        try:
            history = History(self.folder)
        except Fault as fault:
            self.missing.append(f"There are no curves over time: {fault}.")
            return None
        if "time" not in history.columns or len(history) == 0:
            self.missing.append("history.csv has no complete row, so that there are no curves over time.")
            return None
        return history

    def read_state(self):
        try:
            state = State(self.folder)
            state.demand_mesh()
        except Fault as fault:
            self.missing.append(f"There are no pictures: {fault}.")
            return None
        if not state.records:
            self.missing.append("state.h5 has no complete state, so that there are no pictures.")
            return None
        return state

    # --- what follows from them ---------------------------------------------------------------------------------

    def get(self, *keys):
        """A value of the summary; None where it is not there."""
        value = self.summary
        for key in keys:
            value = value.get(key) if isinstance(value, dict) else None
        return value

    def title(self):
        title = self.get("title") or self.scene.get("title")
        return title if isinstance(title, str) and title else os.path.basename(os.path.abspath(self.folder))

    def lines(self, start):
        return [line[len(start):] for line in self.log if line.startswith(start)]

    def unit(self, quantity):
        """Of time, length, velocity, stress, mass, energy, momentum; empty where it is not known."""
        columns = {"time": "time", "length": "max_penetration", "mass": "mass", "energy": "total", "momentum": "momentum_x"}
        if self.history and columns.get(quantity) in self.history.units:
            unit = self.history.units[columns[quantity]]
        else:
            unit = self.state.unit_of(quantity) if self.state else ""
        return "" if unit == "1" else unit

    def files(self):
        """(name, what it is, bytes) of all that a run writes."""
        found = [(name, what) for name, what in FILES.items() if os.path.isfile(self.path(name))]
        found += [(name, "for --restart") for name in sorted(os.listdir(self.folder))
                  if name.startswith("checkpoint_") and name.endswith(".h5")]
        return [(name, what, os.path.getsize(self.path(name))) for name, what in found]
