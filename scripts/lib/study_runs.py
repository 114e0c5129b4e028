# SPDX-License-Identifier: Apache-2.0
"""The runs that a study file asks for: scripts/study does them, scripts/submit hands them to Slurm."""
import os
import shlex
from typing import NamedTuple

from study import set_options

KEYS = ("scene", "scenes", "ranks", "runs", "columns", "bisect")  # of a study file


class Run(NamedTuple):
    label: list  # names of its scene, where there are several, and of the run
    scene: str  # path
    overrides: dict  # key path: value
    ranks: int


def existing(study, key, path):
    whole = os.path.join(study.folder, path)
    if not os.path.isfile(whole):
        study.stop(f"{key}: cannot read {os.path.normpath(whole)}: it does not exist; expected a scene file, relative to the study's folder")
    return whole


def scenes_of(study):
    """Paths of the scenes by name; one scene has no name."""
    if "scenes" not in study.tree:
        return {"": existing(study, "scene", study.value("scene", str, "a file"))}
    if "scene" in study.tree:
        study.stop("scene: invalid together with scenes; expected one of the two")
    scenes = study.value("scenes", dict, "a map of name: file")
    for name, path in scenes.items():
        study.demand_folder_name(f"scenes.{name}", name)
        if not isinstance(path, str):
            study.stop(f"scenes.{name}: invalid scene; expected a file")
    return {str(name): existing(study, f"scenes.{name}", path) for name, path in scenes.items()}


def demand_ranks(study, runs, common):
    for name, overrides in runs.items():
        study.demand_folder_name(f"runs.{name}", name)
        own = overrides.get("ranks", common)
        if not isinstance(own, int) or isinstance(own, bool) or own < 1:
            study.stop(f"runs.{name}.ranks: out of range: {own}; expected an integer >= 1")


def runs_of(study, ranks=None):
    """All runs in the order of the table; `ranks`, where given, holds for each."""
    scenes, runs = scenes_of(study), study.override_maps("runs")
    common_ranks = study.count("ranks", 1)
    demand_ranks(study, runs, common_ranks)
    found = []
    for scene_name, scene in scenes.items():
        for name, given in runs.items():
            overrides = dict(given)
            own_ranks = overrides.pop("ranks", common_ranks)
            label = [scene_name, name] if "scenes" in study.tree else [name]
            found.append(Run(label, scene, overrides, ranks or own_ranks))
    return found


def folder_of(study, label):
    """Where the results of a run go."""
    return os.path.join(study.results, "_".join(label))


def refuse_bisect(study):
    if "bisect" in study.tree:
        study.stop("bisect: invalid here, since each of its runs depends on the one before; expected a study without it")


def lines_of(study, runs):
    """One line a run, quoted for a shell: scene, result folder, options of brunt run."""
    lines = [shlex.join([os.path.abspath(run.scene), folder_of(study, run.label), *set_options(run.overrides)]) for run in runs]
    for run, line in zip(runs, lines):
        if "\n" in line:
            study.stop(f"runs.{run.label[-1]}: invalid value of several lines; expected values and paths of one line each")
    return lines
