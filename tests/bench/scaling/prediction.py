# SPDX-License-Identifier: Apache-2.0
"""Time a step and efficiency to 10^4 ranks, by the model: tables, pictures, and the constants that a measurement gives."""
import math
import os
import re

import model
import yaml

RANKS = [1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 10000]
SHOWN = [1, 8, 64, 512, 4096, 10000]
STRONG, WEAK_A_RANK = 1e8, 1e5  # elements
PARTS = ("elements", "contact", "messages", "bytes", "reductions")
HERE = os.path.dirname(os.path.abspath(__file__))


def blocks(elements, with_contact):
    """Two blocks, each a cube, with the contact of two_blocks.yaml: rows on one whole face, iterations and searches of `ahead` in model.yaml."""
    edge = (elements / 2) ** (1 / 3)
    if not with_contact:
        return model.Scene([(edge, edge, edge)] * 2, [], False, model.Work())
    ahead = model.of("ahead")
    work = model.Work(ahead["iterations"], ahead["searches"], ahead["rows_a_node"] * edge ** 2)
    return model.Scene([(edge, edge, edge)] * 2, [(edge, edge)] * 2, True, work)


def columns(ranks, with_contact):
    """{name of the scene: the scene there}; in weak scaling the contact of a rank stays what it is, as blocks grow along their faces."""
    scenes = {f"strong, {STRONG:.0e}": blocks(STRONG, with_contact), f"strong, {STRONG / 100:.0e}": blocks(STRONG / 100, with_contact)}
    return {**scenes, f"weak, {WEAK_A_RANK:.0e} a rank": wide_blocks(WEAK_A_RANK, ranks, with_contact)}


def wide_blocks(a_rank, ranks, with_contact):
    one = blocks(a_rank, with_contact)
    edge, wide = one.bodies[0][0], math.sqrt(ranks)
    return one._replace(bodies=[(edge * wide, edge * wide, edge)] * 2, sides=[(edge * wide, edge * wide)] * len(one.sides),
                        work=one.work._replace(rows=one.work.rows * ranks))


def efficiency(scene, one, ranks):
    """Against one rank, element for element."""
    alone = sum(model.step_time(one, 1).values()) / one.elements
    return alone / (ranks * sum(model.step_time(scene, ranks).values()) / scene.elements)


def series(with_contact):
    """{name: [(ranks, times by part, efficiency)]}"""
    ones = columns(1, with_contact)
    return {name: [(ranks, model.step_time(columns(ranks, with_contact)[name], ranks), efficiency(columns(ranks, with_contact)[name], one, ranks))
                   for ranks in RANKS] for name, one in ones.items()}


def limit(line):
    """(ranks, part) from which the efficiency is below a half, and the part that costs most there besides the work."""
    for ranks, times, share in line:
        if share < 0.5:
            return ranks, max(("messages", "bytes", "reductions"), key=lambda part: times[part])
    return None, None


def duration(seconds):
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size:
            break
    return f"{seconds / size:.3g} {unit}"


def tables(times):
    """(table of the prediction, constants that times.csv gives)"""
    head = ["scene", "contact", *[f"{ranks:,} rank{'s' if ranks > 1 else ''}" for ranks in SHOWN], "below 0.5 from", "for the sake of"]
    lines = [f"| {' | '.join(head)} |", "|---|---|" + "---:|" * (len(SHOWN) + 1) + "---|"]
    for with_contact in (False, True):
        for name, line in series(with_contact).items():
            cells = [f"{duration(sum(part.values()))}, {share:.2f}" for ranks, part, share in line if ranks in SHOWN]
            ranks, part = limit(line)
            where = f"{ranks:,} ranks, {columns(ranks, with_contact)[name].elements / ranks:,.0f} elements each" if ranks else "-"
            lines.append(f"| {name} | {'yes' if with_contact else 'no'} | {' | '.join(cells)} | {where} | {part or ''} |")
    return "\n".join(lines), constants(times)


def measured(times):
    """{constant of model.yaml: value} from the runs of one rank alone; empty where they are not in times.csv."""
    alone = {row["scene"]: row for row in times if row["ranks"] == "1" and row["runs_at_once"] == "1"}
    if not {"blocks", "blocks without contact"} <= set(alone):
        return {}
    free, touching = alone["blocks without contact"], alone["blocks"]
    with open(os.path.join(HERE, "two_blocks.yaml"), encoding="utf-8") as stream:
        scene = model.box_scene(yaml.safe_load(stream), model.Work())
    iterations, searches, rows = (float(touching[name]) for name in ("iterations", "searches", "rows"))
    return {"element": sum(float(free[name]) for name in ("element_s", "halo_s", "other_s")) / float(free["elements"]),
            "row": float(touching["enforcement_s"]) / (rows * iterations),
            "face": float(touching["search_s"]) / (scene.faces * searches),
            "iterations": iterations, "searches": searches, "rows_a_node": rows * len(scene.sides) / sum(a * b for a, b in scene.sides)}


def adopt(times):
    """Writes what has been measured into model.yaml, in place of what stands there; comments stay."""
    path = os.path.join(HERE, "model.yaml")
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    for name, value in measured(times).items():
        text = re.sub(rf"^  {name}: \S+ *(#|$)", lambda found: f"  {name}: {value:.3e}".ljust(29) + found[1], text, flags=re.M)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def constants(times):
    found = measured(times)
    if not found:
        return "`time` in model.yaml has not been measured on a quiet machine yet: its values are from the tables of tests/bench/README.md and estimates."
    return (f"With one rank alone: {1e9 * found['element']:.3g} ns an element and step, {1e9 * found['row']:.3g} ns a row and iteration, "
            f"{1e6 * found['face']:.3g} us a face and search; {found['iterations']:.3g} iterations a step. model.yaml has these from here.")


def pyplot():
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot as plotter
    return plotter


def plot(path):
    plotter = pyplot()
    figure, axes = plotter.subplots(1, 2, figsize=(10, 4.4), layout="constrained", sharey=True)
    for axis, with_contact in zip(axes, (False, True)):
        for name, line in series(with_contact).items():
            axis.plot([ranks for ranks, _, _ in line], [share for _, _, share in line], "o-", markersize=3, label=name + " elements" if "weak" not in name else name)
        axis.set(xscale="log", xlabel="ranks", ylim=(0, 1.1), title="two blocks in contact" if with_contact else "without contact")
        axis.axhline(0.5, color="grey", linewidth=0.5)
    axes[0].set_ylabel("efficiency (model)")
    axes[0].legend(loc="lower left")
    network = model.of("network")
    figure.supxlabel(f"assumed: {1e6 * network['latency']:.3g} us a message, {network['bandwidth'] / 1e9:.3g} GB/s a rank, {1e6 * network['reduction']:.3g} us a level of a reduction,\n"
                     "no overlap of messages and work, perfect balance, a rank has its core and memory bandwidth to itself", fontsize=8)
    figure.savefig(path, dpi=90)
    plotter.close(figure)


def plot_counts(rows, path):
    """Messages and bytes counted and predicted."""
    import tables as written
    plotter = pyplot()
    figure, axes = plotter.subplots(1, 2, figsize=(10, 4.4), layout="constrained")
    names = [name for name in dict.fromkeys(row["scene"] for row in rows) if name != "million"]
    for k, name in enumerate(names):
        lines = [row for row in rows if row["scene"] == name and int(row["ranks"]) >= 4]
        ranks = [int(row["ranks"]) for row in lines]
        predicted = [model.counts(written.scene_of(written.COUNTS[name], row), int(row["ranks"])) for row in lines]
        for axis, what, values in ((axes[0], "messages", [p.messages for p in predicted]), (axes[1], "bytes", [p.bytes / 1e3 for p in predicted])):
            scale = 1 if what == "messages" else 1e-3
            axis.plot(ranks, [scale * (float(row[what]) + float(row[f"exchange_{what}"])) for row in lines], "o", color=f"C{k}", label=name)
            axis.plot(ranks, values, "-", color=f"C{k}", linewidth=1)
    for axis, title in zip(axes, ("messages a rank and step", "kB a rank and step")):
        axis.set(xscale="log", yscale="log", xlabel="ranks", title=title)
        axis.set_xticks([4, 8, 16, 32, 64], ["4", "8", "16", "32", "64"])
        axis.minorticks_off()
    axes[1].legend(loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize=8)
    figure.supxlabel("points: counted; lines: model", fontsize=8)
    figure.savefig(path, dpi=90)
    plotter.close(figure)
