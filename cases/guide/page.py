# SPDX-License-Identifier: Apache-2.0
"""A page of the guide as a program: its code blocks are files and commands, its quotations are compared with the run.

The parts of a page, in the order of its lines:

- a code block after a line "Save ... `NAME`:" is the file NAME;
- a `sh` block is run by bash in the folder of the page. It ends at the first command that fails, unless it prints
  "exit code" itself;
- a `text` block after `<!-- output: A | B -->` quotes what the `sh` block before it printed; after `<!-- lines: A | B -->` only
  the lines that contain A or B. The page and the run must both contain A and B, all places FILE:LINE and all exit codes that
  are quoted. Wording and other numbers may differ until the page is written anew;
- the table between `<!-- figures -->` and `<!-- end of figures -->` is that of figures.py;
- a picture `![...](NAME)` is one that the commands write under the same name.
"""
import os
import re
import shutil
import subprocess

FENCE = re.compile(r"^( *)```(\w*)$")
SAVE = re.compile(r"\b[Ss]ave .*`([\w./-]+)`:$")
QUOTE = re.compile(r"^<!-- (output|lines): (.*) -->$")
IMAGE = re.compile(r"!\[[^\]]*\]\(([^)]+)\)")
PLACE = re.compile(r"\b[\w./-]+\.(?:yaml|inp|msh):\d+")
EXIT = re.compile(r"^exit code \d+$", re.M)
BEGIN_FIGURES, END_FIGURES = "<!-- figures -->", "<!-- end of figures -->"
LINKED = ("scripts", "cases")  # what the commands of the pages use of a clone


class Quotation:
    """A `text` block of the page, whose opening fence is in line `at`; the marker before it, and what was printed."""

    def __init__(self, marker, at, lines, quoted, printed):
        self.kind, anchors = marker
        self.anchors = [anchor.strip() for anchor in anchors.split("|") if anchor.strip()]
        self.indent = FENCE.match(lines[at])[1]
        self.first, self.last = at + 1, lines.index(self.indent + "```", at + 1)
        self.quoted, self.printed = quoted, printed

    def chosen(self):
        """What of the printed text the page should quote."""
        lines = [line.rstrip() for line in self.printed.strip("\n").split("\n")]
        if self.kind == "lines":
            lines = [line for line in lines if any(anchor in line for anchor in self.anchors)]
        return "\n".join(lines)

    def missing(self):
        """What must be in the page and in the run, and is not in one of them."""
        must = self.anchors + PLACE.findall(self.quoted) + EXIT.findall(self.quoted)
        must += PLACE.findall(self.chosen()) + EXIT.findall(self.chosen())
        return sorted({word for word in must if word not in self.quoted or word not in self.printed})


class Page:
    def __init__(self, path):
        self.path = path
        self.name = os.path.splitext(os.path.basename(path))[0]
        with open(path, encoding="utf-8") as stream:
            self.lines = stream.read().split("\n")
        self.printed = []  # by each `sh` block
        self.faults = []

    def blocks(self):
        """(line of the opening fence, language, text, the nearest line above that is not empty)."""
        at = 0
        while at < len(self.lines):
            fence = FENCE.match(self.lines[at])
            if not fence:
                at += 1
                continue
            indent = fence[1]
            end = self.lines.index(indent + "```", at + 1)
            above = next((line for line in reversed(self.lines[:at]) if line.strip()), "")
            text = "\n".join(line[len(indent):] for line in self.lines[at + 1:end])
            yield at, fence[2], text, above.strip()
            at = end + 1

    def run(self, folder, brunt, project):
        """Saves the files and runs the commands in a clean folder that looks like a clone with a build."""
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(os.path.join(folder, "build/release"))
        for name in LINKED:
            os.symlink(os.path.join(project, name), os.path.join(folder, name))
        os.symlink(brunt, os.path.join(folder, "build/release/brunt"))
        for _, language, text, above in self.blocks():
            save = SAVE.search(above)
            if save:
                with open(os.path.join(folder, save[1]), "w", encoding="utf-8") as stream:
                    stream.write(text + "\n")
            elif language == "sh":
                self.printed.append(self._run_commands(text, folder, brunt))

    def quotations(self):
        """Each `text` block beside what the commands before it printed."""
        found, number = [], -1
        for at, language, text, above in self.blocks():
            quote = QUOTE.match(above)
            if language == "sh":
                number += 1
            elif quote:
                found.append(Quotation(quote.groups(), at, self.lines, text, self.printed[number]))
        return found

    def _run_commands(self, text, folder, brunt):
        mode = [] if "exit code" in text else ["-e"]
        environment = {**os.environ, "BRUNT": brunt, "MPLBACKEND": "Agg"}
        run = subprocess.run(["bash", *mode, "-c", text], cwd=folder, env=environment, text=True, errors="replace",
                             stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        if run.returncode != 0:
            self.faults.append(f"exit code {run.returncode} of\n{text}\n{run.stdout}")
        return run.stdout.replace(os.path.realpath(folder) + "/", "").replace(folder + "/", "")

    def images(self):
        return [name for line in self.lines for name in IMAGE.findall(line)]

    def figures(self):
        """(quantity, by hand, run) as the page quotes them."""
        inside = self.lines[self.lines.index(BEGIN_FIGURES) + 1:self.lines.index(END_FIGURES)]
        rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in inside if line.startswith("|")]
        return [tuple(row[:3]) for row in rows[2:]]

    def write(self, figure_lines):
        """Replaces the quotations and the figures by those of this run."""
        for quotation in reversed(self.quotations()):
            self.lines[quotation.first:quotation.last] = [(quotation.indent + line).rstrip() for line in quotation.chosen().split("\n")]
        first, last = self.lines.index(BEGIN_FIGURES) + 1, self.lines.index(END_FIGURES)
        self.lines[first:last] = figure_lines
        with open(self.path, "w", encoding="utf-8") as stream:
            stream.write("\n".join(self.lines))


def keep_picture(source, target, most_bytes, width=900):
    """A copy without the white margin, at most `width` pixels wide; with fewer colours where it would be too large."""
    from PIL import Image, ImageChops  # only to write
    picture = Image.open(source).convert("RGB")
    box = ImageChops.difference(picture, Image.new("RGB", picture.size, (255, 255, 255))).getbbox()
    margin = 8
    picture = picture.crop((max(0, box[0] - margin), max(0, box[1] - margin), box[2] + margin, box[3] + margin))
    if picture.width > width:
        picture = picture.resize((width, round(picture.height * width / picture.width)), Image.LANCZOS)
    picture.save(target, optimize=True)
    if os.path.getsize(target) > most_bytes:
        picture.quantize(256).save(target, optimize=True)
