# SPDX-License-Identifier: Apache-2.0
"""A line of the scaling table from the summaries of the runs of one number of ranks, and the plot of all of them."""
import statistics

PHASES = ("element", "search", "enforcement", "halo", "other")
HEAD = ["ranks", "runs_at_once", "elements", "loop_s", "s_per_step", *[f"{phase}_s" for phase in PHASES], "ns_per_element_step", "speed-up",
        "efficiency", "neighbours", "messages", "bytes", "exchange_messages", "exchange_bytes", "collectives", "imbalance", "phase_imbalance",
        "memory_MB", "state_hash"]
NOT_MEASURED = "-"  # more ranks than cores: time there says nothing


def seconds_per_step(run):
    """Of the loop without output [s]."""
    return run["ns_per_element_step"] * 1e-9 * run["elements"] / run["ranks"]


def times(runs, first):
    """Columns from loop_s to efficiency; first: the median (run, seconds a step) to compare with, or none."""
    per_step = statistics.median(seconds_per_step(run) for run in runs)
    middle = min(runs, key=lambda run: abs(seconds_per_step(run) - per_step))
    base, base_seconds = first or (middle, per_step)
    work = middle["elements"] / base["elements"]  # 1 in strong scaling
    gain = work * base_seconds / per_step if per_step > 0 else 1.0
    return [f"{statistics.median(run['loop_s'] for run in runs):.4g}", f"{per_step:.4g}",
            *[f"{middle['share'][phase] * per_step:.4g}" for phase in PHASES], f"{middle['ns_per_element_step']:.4g}", f"{gain:.3f}",
            f"{gain * base['ranks'] / middle['ranks']:.3f}"], (middle, per_step)


def counts(run):
    """Columns that do not depend on the load of the machine: means over the ranks, a step."""
    parallel = run["parallel"]
    phases = max(parallel["imbalance"][phase] for phase in ("element", "search", "enforcement"))
    return [f"{parallel['neighbours']['mean']:.4g}", *[f"{parallel[kind][what]['mean']:.6g}" for kind in ("halo", "exchange") for what in ("messages", "bytes")],
            f"{parallel['collective']['messages']['mean']:.4g}", f"{parallel['imbalance']['elements']:.3f}", f"{phases:.3f}",
            f"{parallel['peak_memory']['max'] / 1e6:.4g}", run["state_hash"]]


def row_of(runs, at_once, first, measured):
    """(line of the table, what later lines compare with). at_once: how many such runs shared the machine."""
    run = runs[0]
    head = [str(run["ranks"]), str(at_once), str(run["elements"])]
    if not measured:
        return head + [NOT_MEASURED] * (HEAD.index("neighbours") - len(head)) + counts(run), first
    columns, this = times(runs, first)
    return head + columns + counts(run), first or this


def plot(rows, title, path, write):
    """Seconds a step by phase beside efficiency, and messages and bytes a rank and step; write(figure, path)."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    lines = [dict(zip(rows[0], row)) for row in rows[1:]]
    timed = [line for line in lines if line["s_per_step"] != NOT_MEASURED]
    counted = [line for line in lines if line["runs_at_once"] == "1"]
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4), layout="constrained")
    names = [line["ranks"] if line["runs_at_once"] == "1" else f"{line['runs_at_once']} x {line['ranks']}" for line in timed]
    bottom = [0.0] * len(timed)
    for phase in PHASES:
        heights = [float(line[f"{phase}_s"]) for line in timed]
        left.bar(names, heights, bottom=bottom, label=phase, width=0.6)
        bottom = [low + high for low, high in zip(bottom, heights)]
    for name, top, line in zip(names, bottom, timed):
        left.annotate(line["efficiency"], (name, top), ha="center", va="bottom")
    left.set(xlabel="ranks", ylabel="time a step [s]", title="phases; the number is the efficiency")
    left.legend()
    ranks = [int(line["ranks"]) for line in counted]
    right.plot(ranks, [float(line["messages"]) for line in counted], "o-", label="messages")
    right.plot(ranks, [float(line["bytes"]) / 1e3 for line in counted], "s-", label="kB")
    right.set(xscale="log", yscale="symlog", xlabel="ranks", title="sent to neighbours, a rank and step")
    right.set_xticks(ranks, [str(r) for r in ranks])
    right.minorticks_off()
    right.legend()
    figure.suptitle(title)
    write(figure, path)
    pyplot.close(figure)
