#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Runs brunt on wrong inputs: exit code 2, one clear line, nothing left behind, nothing overwritten.

Usage: run_wrong_inputs.py --brunt PROGRAM --run SCRIPT --work FOLDER [--only TEXT] [--show]
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import tiny_meshes
import wrong_inputs

TIMEOUT = 60  # [s] a wrong input is found in far less; a hang is a fault
CRASH = re.compile(r"terminate called|what\(\)|Traceback|MPI_ABORT|mpirun|\[\d+\] ?PETSC|Segmentation|Signal|std::|errno", re.I)
LONGEST_LINE = 400
MOST_LINES = 12  # a fault may well bring a few of its followers along, never a page


def prepare(wrong, folder):
    """Writes scene and files of one case; the text of every file in the folder."""
    shutil.rmtree(folder, ignore_errors=True)
    scene = wrong.scene
    if scene is None:
        old, new = wrong.change or ("", "")
        assert old in wrong_inputs.GOOD, f"{wrong.name}: '{old}' is not in the good scene"
        scene = wrong_inputs.GOOD.replace(old, new, 1)
    contents = {"bar.msh": tiny_meshes.gmsh(), "scene.yaml": scene if isinstance(scene, bytes) else scene.encode()}
    contents.update(wrong.files)
    for name, content in contents.items():
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as stream:
            stream.write(content)
    return contents


def paths_in(folder):
    return sorted(os.path.relpath(os.path.join(here, n), folder) for here, _, names in os.walk(folder) for n in names)


def faults_of(wrong, code, output, folder, before):
    faults = []
    if code != 2:
        faults.append(f"exit code {code}, not 2")
    lines = [line for line in output.splitlines() if line.strip()]
    if not any(all(phrase.lower() in line.lower() for phrase in wrong.says) for line in lines):
        faults.append(f"no line says {' and '.join(wrong.says)}")
    if wrong.lines and len(lines) != wrong.lines:
        faults.append(f"{len(lines)} lines, not {wrong.lines}")
    if len(lines) > MOST_LINES:
        faults.append(f"{len(lines)} lines, more than {MOST_LINES}")
    faults += [f"a line of {len(line)} characters" for line in lines if len(line) > LONGEST_LINE]
    if CRASH.search(output):
        faults.append(f"reads like a crash: '{CRASH.search(output).group()}'")
    extra = set(paths_in(folder)) - set(before)
    if extra:
        faults.append(f"left behind: {', '.join(sorted(extra))}")
    for name, content in before.items():
        path = os.path.join(folder, name)
        if not os.path.isfile(path) or open(path, "rb").read() != content:
            faults.append(f"overwrote or removed {name}")
    return faults


def execute(command, folder, environment=None):
    """(exit code, standard error and output together) of a command in the folder."""
    try:
        run = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", timeout=TIMEOUT,
                             env={**os.environ, **(environment or {})})
    except subprocess.TimeoutExpired:
        return "none: no end in time", ""
    return run.returncode, run.stderr + run.stdout


def check(wrong, prefix, work, environment=None):
    folder = os.path.join(work, re.sub(r"\W+", "_", wrong.name))
    before = prepare(wrong, folder)
    command = prefix + [a for a in (wrong.target,) if a] + wrong.arguments
    code, output = execute(command, folder, environment)
    return wrong.name, faults_of(wrong, code, output, folder, before), output


def check_good_scene(brunt, work):
    """The scene that the wrong ones are made from must pass, else their faults prove nothing."""
    faults = []
    for mesh_file, content in (("bar.msh", tiny_meshes.gmsh()), ("bar.exo", tiny_meshes.exodus())):
        block = "bar" if mesh_file.endswith("msh") else "1"
        scene = wrong_inputs.GOOD.replace("bar.msh", mesh_file).replace("block: bar", f"block: {block}")
        folder = os.path.join(work, "good_" + mesh_file)
        prepare(wrong_inputs.Wrong("good", [], scene=scene, files={mesh_file: content}), folder)
        code, output = execute([brunt, "check", "scene.yaml"], folder)
        if code != 0:
            faults.append(f"the good scene with {mesh_file}: exit code {code}\n{output}")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--brunt", required=True)
    parser.add_argument("--run", required=True, help="scripts/run, for the cases on two ranks; render and plot lie beside it")
    parser.add_argument("--work", required=True)
    parser.add_argument("--only", default="", help="cases whose name holds this text")
    parser.add_argument("--show", action="store_true", help="print every message")
    given = parser.parse_args()

    cases = [w for w in wrong_inputs.ALL if given.only in w.name]
    alone = os.path.join(given.work, "alone")
    ranks = os.path.join(given.work, "two_ranks")
    failed = check_good_scene(given.brunt, given.work)
    print("\n".join(failed) or "the good scene passes")
    with ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(check, w, [given.brunt] + ([w.command] if w.command else []), alone) for w in cases]
        on_ranks = [w for w in cases if w in wrong_inputs.FILES[-3:] or (w.command == "run" and w.target)]
        jobs += [pool.submit(check, w, [given.run, "-np", "2"], ranks, {"BRUNT": given.brunt}) for w in on_ranks]
        scripts = os.path.dirname(given.run)
        jobs += [pool.submit(check, w, [os.path.join(scripts, w.command)], alone) for w in wrong_inputs.SCRIPTS
                 if given.only in w.name]
        results = [job.result() for job in jobs]
    for name, faults, output in results:
        if given.show or faults:
            print(f"{'FAILED' if faults else 'ok    '} {name}")
            print("".join(f"    - {fault}\n" for fault in faults) + "".join(f"    | {l}\n" for l in output.splitlines()), end="")
        failed += faults
    print(f"wrong inputs: {len(results)} cases, {sum(bool(r[1]) for r in results)} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
