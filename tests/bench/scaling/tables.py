# SPDX-License-Identifier: Apache-2.0
"""Tables and pictures of README.md from counts.csv, times.csv and the model."""
import csv
import os
import re
import sys

import yaml

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(HERE))), "scripts", "lib"))
import model  # noqa: E402
import prediction  # noqa: E402
from cases import COUNTS  # noqa: E402
from weak_growth import Growth, put  # noqa: E402

COUNTED, TIMED, README = "counts.csv", "times.csv", "README.md"
WITHIN = {False: 0.10, True: 0.25}  # of a count, without and with contact


def read(path):
    if not os.path.isfile(path):
        return []
    with open(path, encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def write(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, ["scene", *[name for name in rows[0] if name != "scene"]])
        writer.writeheader()
        writer.writerows(rows)


def tree_of(case, ranks):
    """The scene's YAML with its overrides, grown to the ranks where it grows."""
    overrides = {key: yaml.safe_dump(value) for key, value in case.overrides.items()}
    growth = Growth(os.path.join(HERE, case.scene + ".yaml"), overrides)
    for path, value in growth.overrides(ranks).items() if "--weak" in case.options else ():
        put(growth.tree, path, str(value))
    return growth.tree


def scene_of(case, row):
    """The model's scene for a line of the counts."""
    ranks, with_contact = int(row["ranks"]), "contact" not in case.overrides
    work = model.Work(float(row["iterations"]), float(row["searches"]), float(row["rows"])) if with_contact else model.Work()
    tree = tree_of(case, ranks)
    if case.scene == "crush":
        return model.tube_scene(tree, work)
    return model.box_scene(tree, work, with_contact)


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" + "---:|" * (len(head) - 1)]
    return "\n".join([*lines, *["| " + " | ".join(row) + " |" for row in rows]])


def check(rows):
    """(table of predicted and counted figures, number of those beyond the limit)."""
    lines, missed = [], 0
    for row in rows:
        ranks = int(row["ranks"])
        case = COUNTS[row["scene"]]
        if ranks < 4 or row["scene"] == "million":
            continue
        scene = scene_of(case, row)
        predicted = model.counts(scene, ranks)
        messages = float(row["messages"]) + float(row["exchange_messages"])
        sent = float(row["bytes"]) + float(row["exchange_bytes"])
        errors = [predicted.messages / messages - 1, predicted.bytes / sent - 1]
        beyond = [abs(error) > WITHIN[bool(scene.sides)] for error in errors]
        missed += sum(beyond)
        marked = [f"{100 * error:+.0f} %" + (" (!)" if far else "") for error, far in zip(errors, beyond)]
        lines.append([row["scene"], str(ranks), f"{messages:.4g}", f"{predicted.messages:.4g}", marked[0], f"{sent / 1e3:.4g}",
                      f"{predicted.bytes / 1e3:.4g}", marked[1], row["collectives"], f"{predicted.collectives:.3g}"])
    head = ["scene", "ranks", "messages", "model", "error", "kB", "model", "error", "collectives", "model"]
    return table(head, lines), missed


def counted(rows):
    head = ["scene", "ranks", "elements", "neighbours", "messages", "kB", "of the search", "kB", "collectives", "imbalance", "MB a rank"]
    return table(head, [[row["scene"], row["ranks"], row["elements"], row["neighbours"], f"{float(row['messages']):.4g}", f"{float(row['bytes']) / 1e3:.4g}",
                         f"{float(row['exchange_messages']):.3g}", f"{float(row['exchange_bytes']) / 1e3:.3g}", row["collectives"], row["imbalance"], row["memory_MB"]]
                        for row in rows])


def timed(rows):
    if not rows:
        return "Not measured yet: `tests/bench/scaling/measure times` on a quiet machine."
    phases = ("element_s", "search_s", "enforcement_s", "halo_s", "other_s")
    head = ["scene", "ranks", "runs at once", "elements", "ms a step", *[name[:-2] for name in phases], "efficiency", "of the machine", "imbalance of phases", "MB a rank"]
    lines, together = [], {}
    for row in rows:
        if row["runs_at_once"] != "1":
            together[row["scene"]] = float(row["efficiency"])
    for row in rows:
        of_machine = float(row["efficiency"]) / together.get(row["scene"], 1.0) if row["ranks"] != "1" else float("nan")
        lines.append([row["scene"], row["ranks"], row["runs_at_once"], row["elements"], f"{1e3 * float(row['s_per_step']):.4g}",
                      *[f"{1e3 * float(row[name]):.3g}" for name in phases], row["efficiency"], f"{of_machine:.3f}" if of_machine == of_machine else "",
                      row["phase_imbalance"], row["memory_MB"]])
    return table(head, lines)


def fill(text, name, body):
    """The part of README.md between its two marks."""
    marks = f"<!-- {name} -->", f"<!-- end of {name} -->"
    pattern = re.escape(marks[0]) + ".*?" + re.escape(marks[1])
    return re.sub(pattern, lambda _: f"{marks[0]}\n{body}\n{marks[1]}", text, flags=re.S)


def make():
    """Writes README.md and the pictures; 1 where the model misses a count."""
    counts, times = read(os.path.join(HERE, COUNTED)), read(os.path.join(HERE, TIMED))
    checked, missed = check(counts)
    ahead, limits = prediction.tables(times)
    path = os.path.join(HERE, README)
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    for name, body in (("counts", counted(counts)), ("times", timed(times)), ("check", checked), ("prediction", ahead), ("constants", limits)):
        text = fill(text, name, body)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)
    prediction.plot(os.path.join(HERE, "prediction.png"))
    prediction.plot_counts(counts, os.path.join(HERE, "counts.png"))
    if missed:
        print(f"the model misses {missed} counts by more than 10 % without contact or 25 % with: see README.md", file=sys.stderr)
    return 1 if missed else 0
