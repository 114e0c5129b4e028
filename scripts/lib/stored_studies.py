# SPDX-License-Identifier: Apache-2.0
"""Tables of scripts/pareto and scripts/study as they are stored and shown: one row a setting, its meshes beside each other."""
import csv
import os

HEADS_OF_PARETO = ["setting", "mesh", "elements", "steps", "loop [s]", "contact [s]"]


def read(path):
    with open(path, encoding="utf-8", newline="") as stream:
        rows = list(csv.reader(stream))
    return rows[0], rows[1:]


def _percent(text):
    value = 100 * float(text)
    return f"{value:.2g}" if abs(value) < 10 else f"{value:.0f}"


def _times(cells):
    return ", ".join(f"{float(cell):.2g}" for cell in cells)


def of_pareto(header, rows):
    """setting | each error over the meshes [%] | its order | seconds of the loop and of contact."""
    quantities = header[len(HEADS_OF_PARETO):]
    meshes = list(dict.fromkeys(row[1] for row in rows if row[1] != "order"))
    heads = ["setting"]
    for quantity in quantities:
        heads += [f"{quantity}, error [%] with {', '.join(meshes)}", "order"]
    table = []
    for setting in dict.fromkeys(row[0] for row in rows):
        own = [row for row in rows if row[0] == setting and row[1] != "order"]
        good = [row for row in own if len(row) > len(HEADS_OF_PARETO)]
        order = next((row for row in rows if row[0] == setting and row[1] == "order"), None)
        line = [setting]
        for column in range(len(HEADS_OF_PARETO), len(header)):
            line += [", ".join(_percent(row[column]) if row in good else "stopped" for row in own), order[column] if order else ""]
        table.append(line + [_times(row[4] for row in good), _times(row[5] for row in good)])
    heads += ["loop [s]", "contact [s]"]
    # an order that no setting has is no column
    kept = [i for i, head in enumerate(heads) if head != "order" or any(line[i] for line in table)]
    return {"header": [heads[i] for i in kept], "rows": [[line[i] for i in kept] for line in table]}


def of_study(header, rows):
    """The table as scripts/study prints it, numbers with four digits."""
    def cell(text):
        try:
            return text if text.lstrip("-").isdigit() else f"{float(text):.4g}"
        except ValueError:
            return text
    return {"header": header, "rows": [[cell(text) for text in row] + [""] * (len(header) - len(row)) for row in rows]}


def printed(text):
    """The markdown tables of a text."""
    tables, lines = [], []
    for line in [*text.splitlines(), ""]:
        if line.strip().startswith("|"):
            lines.append([cell.strip() for cell in line.strip().strip("|").split("|")])
        else:
            if len(lines) > 2 and set("".join(lines[1])) <= set("-: "):
                tables.append({"header": lines[0], "rows": [row + [""] * (len(lines[0]) - len(row)) for row in lines[2:]]})
            lines = []
    return tables


def studies_of(folder):
    """Study files of a folder: {name of the form: (program, path)}."""
    found = {}
    for name in sorted(os.listdir(folder)):
        path = os.path.join(folder, name)
        if name.endswith(".yaml"):
            with open(path, encoding="utf-8") as stream:
                heads = {line.split(":")[0] for line in stream if line[:1].isalpha()}
            if "meshes" in heads and "case" in heads:
                found[name.removesuffix(".yaml")] = ("pareto", path)
            elif "columns" in heads and "runs" in heads:
                found[name.removesuffix(".yaml")] = ("study", path)
    return found
