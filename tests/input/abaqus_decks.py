# SPDX-License-Identifier: Apache-2.0
"""Right Abaqus input files, each in many ways of writing, and random damage to them. A deck is {file name: text}; the
first file is the one to read."""
import math

MAIN = "deck.inp"


def grid(counts, first=1, step=1):
    """Node numbers with positions in units of an element, and hexahedra by corner numbers."""
    nx, ny, nz = counts
    at = {(i, j, k): first + step * (i + (nx + 1) * (j + (ny + 1) * k)) for k in range(nz + 1) for j in range(ny + 1) for i in range(nx + 1)}
    corner = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = [[at[i + a, j + b, k + c] for a, b, c in corner] for k in range(nz) for j in range(ny) for i in range(nx)]
    return at, cells


def vector(rng, size):
    return [round(rng.uniform(-size, size), 3) for _ in range(3)]


def number(rng, value):
    """One of the ways in which Abaqus takes a real number."""
    plain = repr(round(value, 9))
    form = rng.randrange(7)
    if form == 0 and value == int(value):
        return str(int(value)) + "."
    if form == 1:
        return f"{value:.12e}".replace("e", rng.choice("dDeE"))
    if form == 2 and value >= 0:
        return "+" + plain
    if form == 3 and value == int(value):
        return str(int(value))
    if form == 4 and plain.startswith("0."):
        return plain[1:]
    return plain


def mesh_lines(rng, counts, sizes, first, step, system="R", nset="", elset=""):
    """*NODE and *ELEMENT of a box, or of a sector in cylindrical or spherical coordinates; its exact volume."""
    at, cells = grid(counts, first, step)
    lines = ["*NODE" + (f", SYSTEM={system}" if system != "R" or rng.random() < .2 else "") + (f", NSET={nset}" if nset else "")]
    for (i, j, k), n in at.items():
        x, y, z = i * sizes[0], j * sizes[1], k * sizes[2]
        if system == "C":
            x, y = 1 + x, 90.0 * j / counts[1]
        elif system == "S":
            x, y, z = 1 + x, 90.0 * j / counts[1], 60.0 * k / counts[2]
        lines.append(f"{n}, {number(rng, x)}, {number(rng, y)}, {number(rng, z)}")
    lines.append("*ELEMENT, TYPE=" + rng.choice(["C3D8", "C3D8R", "C3D8I"]) + (f", ELSET={elset}" if elset else ""))
    spread = rng.choice([1, 5])
    ids = [1 + spread * e for e in range(len(cells))]
    lines += [f"{e}, " + ", ".join(map(str, cell)) for e, cell in zip(ids, cells)]
    width, height, depth = (c * s for c, s in zip(counts, sizes))
    size = width * height * depth
    if system == "C":  # chords: each sector is a difference of triangles
        step_angle = math.pi / 2 / counts[1]
        size = counts[1] * math.sin(step_angle) / 2 * ((1 + width) ** 2 - 1) * depth
    return lines, at, ids, None if system == "S" else size


def ends(rng, at, counts, name):
    """Sets of the nodes with k = 0: by number, by range, by elements or by name."""
    foot = [n for (_, _, k), n in at.items() if k == 0]
    form = rng.randrange(4)
    if form == 0:
        return [f"*NSET, NSET={name}"] + [", ".join(map(str, foot[a:a + 8])) + rng.choice(["", ","]) for a in range(0, len(foot), 8)]
    if form == 1:
        step = foot[1] - foot[0]
        return [f"*NSET, NSET={name}, GENERATE", f"{foot[0]}, {foot[-1]}" + (f", {step}" if rng.random() < .6 else "")]
    if form == 2:
        return ['*NSET, NSET="first part"', f"{foot[0]}, {foot[1]}", f"*NSET, NSET={name}", '"first part",'] + [f"{n}," for n in foot[2:]]
    below = range(1, counts[0] * counts[1] + 1)
    return [f"*ELSET, ELSET={name}_E", ", ".join(f"{e}" for e in below), f"*NSET, NSET={name}, ELSET={name}_E"] if counts[0] * counts[1] < 9 else [
        f"*NSET, NSET={name}", f"{foot[0]}, {foot[-1]}"]


def flat(rng):
    counts, sizes = [rng.randint(1, 3) for _ in range(3)], [rng.choice([.5, 1.0, 1.25]) for _ in range(3)]
    system = rng.choice(["R", "R", "R", "C", "S"])
    lines, at, ids, size = mesh_lines(rng, counts, sizes, rng.choice([1, 101]), rng.choice([1, 10]), system, rng.choice(["", "ALLN"]), "BAR")
    head = ["*HEADING", "a bar"]
    if rng.random() < .4:
        head += ["*SYSTEM", ", ".join(number(rng, v) for v in vector(rng, 5) + (vector(rng, 5) if rng.random() < .7 else []))]
        if head[-1].count(",") == 5 and rng.random() < .6:
            head.append(", ".join(number(rng, v) for v in vector(rng, 5)))
    foot = ends(rng, at, counts, "FOOT") if ids[-1] == len(ids) else [f"*NSET, NSET=FOOT, GENERATE", f"{min(at.values())}, {max(at.values())}"]
    tail = ["*ELSET, ELSET=\"last one\"", f"{ids[-1]}", "*SURFACE, NAME=PUSH, TYPE=ELEMENT", f'"last one", S{rng.randint(1, 6)}']
    tail += rng.choice([[], ["*ELSET, ELSET=EVERY, GENERATE", f"1, {ids[-1]}, 1", "*SURFACE, NAME=SKIN", "EVERY,"], ["*SURFACE, NAME=POINTS, TYPE=NODE", "FOOT"]])
    section = ["*SOLID SECTION, ELSET=BAR, MATERIAL=M", ","]
    material = rng.choice([[], ["*MATERIAL, NAME=M", "*DENSITY", "1000.,", "*ELASTIC", "1e6, .3"]])
    step = rng.choice([[], ["*STEP, NLGEOM=YES", "*DYNAMIC, EXPLICIT", ", 1.", "*BOUNDARY", "FOOT, 1, 3", "*END STEP"]])
    files = {MAIN: head + lines + foot + section + tail + material + step}
    if rng.random() < .2:
        files = {MAIN: head + ["*INCLUDE, INPUT=mesh.inc"] + foot + section + tail + material + step, "mesh.inc": lines}
    return files, size


def mixed(rng):
    """A hexahedron, a wedge beside it, a pyramid on it and a tetrahedron apart, with skins that are no part of the mesh."""
    nodes = ["0,0,0", "1,0,0", "1,1,0", "0,1", "0,0,1", "1,0,1", "1,1,1", "0,1,1", "2,0,0", "2,0,1", ".5,.5,2"]
    apart = ["5,0,0", "6,0,0", "5,1,0", "5,0,1"]
    lines = ["*NODE, NSET=ALL"] + [f"{k + 1},{n}" for k, n in enumerate(nodes)] + [f"{k + 21},{n}" for k, n in enumerate(apart)]
    lines += ["*ELEMENT, TYPE=C3D8R, ELSET=BODY", "1, 1, 2, 3, 4,", "5, 6, 7, 8", "*ELEMENT, TYPE=C3D6, ELSET=BODY", "2, 2, 9, 3, 6, 10, 7"]
    lines += ["*ELEMENT, TYPE=C3D5, ELSET=CAP", "3, 5, 6, 7, 8, 11", "*ELEMENT, TYPE=C3D4, ELSET=BODY", "4, 21, 22, 23, 24"]
    lines += ["*ELEMENT, TYPE=CPS4, ELSET=SKIN", "5, 1, 2, 3, 4", "*NSET, NSET=ENDS, GENERATE", "1, 9, 4", "*NSET, NSET=MORE", "ENDS, 24"]
    lines += ["*SURFACE, NAME=SIDES"] + [f"{e}, S{rng.randint(1, 4)}" for e in range(1, 5)] + ["*SURFACE, NAME=SKIN", "BODY,"]
    if rng.random() < .6:
        lines += ["*SOLID SECTION, ELSET=BODY, MATERIAL=M", "*SOLID SECTION, ELSET=CAP, MATERIAL=M"]
    return {MAIN: lines}, 1 + .5 + 1 / 3 + 1 / 6


def parts(rng):
    """Instances of two parts: with the mesh in the part or in the instance, moved and turned."""
    lines, size, total = ["*HEADING"], {}, 0.0
    meshes = {}
    for name in ("Rod", "Pin"):
        counts = [rng.randint(1, 2) for _ in range(3)]
        mesh, at, ids, volume = mesh_lines(rng, counts, [1.0, .5, .75], 1, 1, rng.choice("RRC"), "", "whole" if rng.random() < .5 else "")
        mesh += ["*Nset, nset=Root", ", ".join(str(n) for (_, _, k), n in at.items() if k == 0)[:200].rstrip(", ")]
        mesh += ["*Elset, elset=Body, generate", f"1, {ids[-1]}", "*Solid Section, elset=BODY, material=m", ","]
        meshes[name], size[name] = mesh, volume
    own = rng.random() < .5  # Pin's mesh is in its instance
    for name, mesh in meshes.items():
        lines += [f"*Part, name={name}"] + ([] if own and name == "Pin" else mesh) + ["*End Part"]
    lines.append("*Assembly, name=Assembly")
    instances = [("Rod-1", "Rod"), ("Pin-1", "Pin")] + ([('"second rod"', "rod")] if rng.random() < .5 else [])
    for instance, part in instances:
        lines.append(f"*Instance, name={instance}, part={part}")
        if rng.random() < .7:
            lines.append(", ".join(number(rng, v) for v in vector(rng, 9)))
            if rng.random() < .6:
                lines.append(", ".join(number(rng, v) for v in vector(rng, 4) + vector(rng, 4) + [round(rng.uniform(-180, 180), 2)]))
        lines += meshes["Pin"] if own and part == "Pin" else []
        lines.append("*End Instance")
        total += size[part.capitalize()]
    lines += ["*Node, nset=Reference", "1, 0, 0, 9"]
    for instance, _ in instances:
        lines += [f"*Nset, nset=Foot, instance={instance}", rng.choice(["1, 2", "Root", "Root, 3"])]
    lines += ["*Elset, elset=_top, instance=Rod-1", "1,", "*Surface, type=ELEMENT, name=Top", "_top, S2", "*Surface, name=Skin", "Pin-1.Body,"]
    lines += ["*Nset, nset=Both", "Rod-1.1, Pin-1.Root", "*Nset, nset=Cells, elset=_top", "*End Assembly"]
    return {MAIN: lines + rng.choice([[], ["*Material, name=m", "*Density", "1.,"], ["*Step", "*Static", "*End Step"]])}, total


def right_deck(rng):
    """A deck and its volume by hand (None: no closed form)."""
    return rng.choice([flat, flat, mixed, parts])(rng)


def disguise(rng, files):
    """The same decks, written in another way that the rules allow; as bytes."""
    written = {}
    end = rng.choice(["\n", "\n", "\r\n", "\r"])
    case = rng.choice([str, str, str.upper, str.lower, str.title])
    for name, lines in files.items():
        new = []
        for line in lines:
            is_keyword = line.startswith("*")
            if is_keyword and '"' not in line and "INPUT" not in line:
                line = case(line)
            if is_keyword and "," in line and rng.random() < .1:
                at = line.rindex(",")
                line = line[:at + 1] + end + line[at + 1:].strip()
            if not is_keyword and rng.random() < .05:
                line = rng.choice([" ", "\t", "  "]) + line + rng.choice([" ", "\t"])
            if rng.random() < .03:
                new.append(rng.choice(["", "** a comment", "**, 1, 2", "   "]))
            new.append(line)
        start = rng.choice([b"", b"", b"", b"\xef\xbb\xbf", (end * rng.randint(1, 30)).encode()])
        written[name] = start + (end.join(new) + end).encode("latin-1")
    return written
