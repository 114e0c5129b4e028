# SPDX-License-Identifier: Apache-2.0
"""A small reader of Abaqus input files, written from the rules of the Abaqus Analysis and Keywords Guides and not from
the program's reader. It raises Invalid where the rules give no single meaning."""
import math
import os
import re

REAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eEdD][+-]?\d+)?\Z")
INTEGER = re.compile(r"\+?\d+\Z")
BESIDE = ("T2D", "T3D", "CPS", "CPE", "CAX", "SFM3D")  # lines and surfaces beside solids are no part of the mesh
FACES = {4: ["123", "142", "243", "341"], 5: ["1234", "152", "253", "354", "451"], 6: ["123", "465", "1452", "2563", "3641"],
         8: ["1234", "5876", "1562", "2673", "3784", "4851"]}
HEXAHEDRON = {8: range(8), 6: (0, 1, 2, 2, 3, 4, 5, 5), 5: (0, 1, 2, 3, 4, 4, 4, 4)}
# Keywords that define the mesh: parameters that do, and parameters that cannot change it.
KEYWORDS = {
    "NODE": ("INPUT NSET SYSTEM", ""), "ELEMENT": ("TYPE ELSET INPUT", "OFFSET SOLIDELEMENTNUMBERING"),
    "NSET": ("NSET ELSET GENERATE INSTANCE INPUT", "INTERNAL UNSORTED"), "ELSET": ("ELSET GENERATE INSTANCE INPUT", "INTERNAL UNSORTED"),
    "SURFACE": ("NAME TYPE", "DEFINITION FILLETRADIUS INTERNAL MAXRATIO NOOFFSET NOTHICK PROPERTY REGIONTYPE SCALETHICK"),
    "SOLIDSECTION": ("ELSET", "COMPOSITE CONTROLS LAYUP MATERIAL NODALTHICKNESS OFFSET ORDER ORIENTATION REFNODE STACKDIRECTION SYMMETRIC"),
    "SYSTEM": ("", ""), "PART": ("NAME", ""), "ENDPART": ("", "NAME"), "ASSEMBLY": ("", "NAME"), "ENDASSEMBLY": ("", "NAME"),
    "INSTANCE": ("NAME PART", ""), "ENDINSTANCE": ("", "NAME"), "INCLUDE": ("INPUT", ""), "STEP": ("", None), "ENDSTEP": ("", "")}
GENERATORS = ("NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYMMETRICMODELGENERATION", "PARAMETER", "IMPERFECTION", "ADJUST", "IMPORT")


class Invalid(Exception):
    """The file has no single meaning, or one that is not a mesh of solid elements of first order."""


def need(condition, what):
    if not condition:
        raise Invalid(what)


def split(line):
    """Fields between commas outside of quotation marks; an empty last one does not count."""
    need(line.count('"') % 2 == 0, "quotation mark")
    fields = [f.strip(" \t") for f in re.split(r',(?=(?:[^"]*"[^"]*")*[^"]*\Z)', line)]
    return fields[:-1] if fields[-1] == "" else fields


def squeeze(text):
    return re.sub(r"[ \t]", "", text).upper()


def label(text):
    """(as written, as compared)"""
    if len(text) >= 2 and text[0] == text[-1] == '"':
        return text[1:-1], text[1:-1]
    return text, squeeze(text)


def real(text):
    need(text == "" or REAL.match(text), f"number {text}")
    value = float(re.sub("[dD]", "e", text)) if text else 0.0
    need(math.isfinite(value), f"number {text}")
    return value


def integer(text):
    need(INTEGER.match(text), f"number {text}")
    need(1 <= int(text) <= 999999999, f"number {text}")
    return int(text)


def lines_of(path):
    with open(path, "rb") as stream:
        text = stream.read()
    text = text.removeprefix(b"\xef\xbb\xbf").decode("latin-1")
    lines = re.split(r"\r\n|\r|\n", text)
    return [line.strip(" \t") for line in lines], bool(lines[-1].strip(" \t"))


class Card:
    def __init__(self, fields):
        self.word = squeeze(fields[0]) if fields else ""
        need(self.word, "keyword")
        self.parameters, self.data, self.unended, self.fault = {}, [], False, ""
        self.add(fields[1:])

    def add(self, fields):
        for field in fields:
            name, _, value = field.partition("=")
            if not squeeze(name) or squeeze(name) in self.parameters:
                self.fault = "parameter"
            self.parameters[squeeze(name)] = value.strip(" \t")

    def label(self, name):
        written = label(self.parameters.get(name, ""))
        need(written[1], f"{name} of {self.word}")
        return written


def cards_of(path, cards=None, open_files=()):
    cards = [] if cards is None else cards
    need(os.path.isfile(path) and path not in open_files and len(open_files) < 30, f"file {path}")
    lines, unended = lines_of(path)
    goes_on = False
    for number, line in enumerate(lines):
        if line == "" or line.startswith("**"):
            continue
        if line.startswith("*"):
            if goes_on:
                cards[-1].fault = "continuation"
            cards.append(Card(split(line[1:])))
        elif goes_on:
            cards[-1].add(split(line))
        else:
            need(cards, "data before a keyword")
            cards[-1].data.append(split(line))
            cards[-1].unended |= unended and number == len(lines) - 1
            cards[-1].data[-1].append(line.endswith(","))  # the last entry of a row: whether it ends in a comma
            continue
        goes_on = line.endswith(",")
        card = cards[-1]
        if not goes_on and (card.word == "INCLUDE" or "INPUT" in card.parameters and card.word in ("NODE", "ELEMENT", "NSET", "ELSET")):
            if card.word == "INCLUDE":
                check_parameters(cards.pop())
            inner = os.path.normpath(os.path.join(os.path.dirname(path), card.label("INPUT")[0]))
            cards_of(inner, cards, open_files + (path,))
    need(not goes_on, "continuation")
    return cards


def check_parameters(card):
    read, idle = KEYWORDS[card.word]
    need(idle is None or not card.fault, card.fault)
    need(idle is None or set(card.parameters) <= set((read + " " + idle).split()), f"parameters of {card.word}")


class Scope:
    def __init__(self):
        self.nodes, self.elements, self.foreign = {}, {}, {}  # by number
        self.node_sets, self.element_sets, self.surfaces, self.sections = {}, {}, {}, []
        self.names, self.used = {}, False


def node_place(values, system, frame):
    a, b, c = (values + [0.0] * 3)[:3]
    t, p = math.radians(b), math.radians(c)
    if system == "C":
        a, b = a * math.cos(t), a * math.sin(t)
    elif system == "S":
        a, b, c = a * math.cos(p) * math.cos(t), a * math.cos(p) * math.sin(t), a * math.sin(p)
    else:
        need(system == "R", f"system {system}")
    origin, axes = frame
    return tuple(origin[k] + a * axes[0][k] + b * axes[1][k] + c * axes[2][k] for k in range(3))


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    need(length > 0, "direction")
    return tuple(x / length for x in v)


GLOBAL = ((0.0, 0.0, 0.0), ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))


def frame_of(card):
    rows = [[real(f) for f in row[:-1]] for row in card.data]
    if not rows:
        return GLOBAL
    need(len(rows) <= 2 and len(rows[0]) in (3, 6) and all(f for row in card.data for f in row[:-1]), "SYSTEM")
    if rows == [rows[0][:3]]:
        return tuple(rows[0]), GLOBAL[1]
    need(len(rows[0]) == 6 and len(rows[-1]) in (3, 6), "SYSTEM")
    a, x = rows[0][:3], [rows[0][3 + k] - rows[0][k] for k in range(3)]
    if len(rows) == 1:
        x, z = unit((x[0], x[1], 0.0)), GLOBAL[1][2]
    else:
        need(len(rows[1]) == 3, "SYSTEM")
        x = unit(x)
        z = unit(cross(x, [rows[1][k] - a[k] for k in range(3)]))
    return tuple(a), (x, cross(z, x), z)


def turned(place, shift, turn):
    """Translation, then the rotation of Rodrigues about the axis through two points."""
    place = tuple(place[k] + shift[k] for k in range(3))
    if turn is None:
        return place
    axis, angle = unit([turn[3 + k] - turn[k] for k in range(3)]), math.radians(turn[6])
    arm = [place[k] - turn[k] for k in range(3)]
    along = sum(axis[k] * arm[k] for k in range(3)) * (1 - math.cos(angle))
    side = cross(axis, arm)
    return tuple(turn[k] + arm[k] * math.cos(angle) + side[k] * math.sin(angle) + axis[k] * along for k in range(3))


def volume(corners):
    """Of a tetrahedron, or of a trilinear hexahedron by 2 x 2 x 2 points."""
    if len(corners) == 4:
        u, v, w = ([corners[k][i] - corners[0][i] for i in range(3)] for k in (1, 2, 3))
        return sum(a * b for a, b in zip(u, cross(v, w))) / 6
    signs = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)]
    g, total = 1 / math.sqrt(3), 0.0
    for at in signs:
        rows = []
        for d in range(3):
            weights = [s[d] / 8 * math.prod(1 + s[k] * at[k] * g for k in range(3) if k != d) for s in signs]
            rows.append([sum(w * c[i] for w, c in zip(weights, corners)) for i in range(3)])
        total += sum(a * b for a, b in zip(rows[0], cross(rows[1], rows[2])))
    return total
