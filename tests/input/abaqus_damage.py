# SPDX-License-Identifier: Apache-2.0
"""Random damage to Abaqus input files: to lines, fields, parameters, numbers, ends."""
import re

PARAMETERS = ["NSET=A", "ELSET=BAR", "ELSET=whole", "GENERATE", "INSTANCE=Rod-1", "INTERNAL", "UNSORTED", "SYSTEM=C", "SYSTEM=S", "SYSTEM=R", "SYSTEM=X",
              "INPUT=none.inc", "TYPE=C3D8", "TYPE=C3D4", "TYPE=C3D20", "TYPE=CPS4", "TYPE=NODE", "TYPE=ELEMENT", "TYPE=CYLINDER", "OFFSET=1000",
              "SOLID ELEMENT NUMBERING=1", "FILE=x", "NAME=B", "COMBINE=UNION", "CROP", "TRIM=YES", "NO THICK", "MAX RATIO=.1", "PROPERTY=p",
              "REGION TYPE=SLIDING", "FILLET RADIUS=1", "DEFINITION=NODES", "SCALE THICK=2", "LIBRARY=old", "INSTANCE=old", "PART=Rod", "COMPOSITE",
              "CONTROLS=c", "LAYUP=l", "MATERIAL=M", "ORDER=1", "ORIENTATION=o", "REF NODE=1", "STACK DIRECTION=3", "SYMMETRIC", "PASSWORD=x", "NSE=FOOT"]
KEYWORDS = ["*NGEN", "*NFILL", "*NCOPY", "*NMAP, NSET=FOOT, TYPE=CYLINDRICAL", "*ELGEN, ELSET=BAR", "*ELCOPY", "*PARAMETER", "*SYSTEM", "*NOD", "*ELEMENTS",
            "*END PART", "*PART, NAME=P", "*ASSEMBLY", "*INSTANCE, NAME=I, PART=Rod", "*END INSTANCE", "*STEP", "*END STEP", "*HEADING", "*NSET, NSET=FOOT",
            "*ELSET, ELSET=BAR", "*NODE", "*ELEMENT, TYPE=C3D8", "*SURFACE, NAME=PUSH", "*IMPERFECTION, FILE=f, STEP=1", "*UNHEARD OF"]
NUMBERS = ["0", "-1", "1", "2", "7", "1.", "1.D0", "1e5", "+1", "+-1", "1e400", "nan", "1 2", "", "1000000000", "99999999999999999999", "0x1", "1,", "1e", "S1",
           '"', '"A"', "*", "Rod-1.1", "FOOT"]


def keyword_lines(lines):
    return [k for k, line in enumerate(lines) if line.startswith("*") and not line.startswith("**")]


def change_parameter(rng, lines):
    k = rng.choice(keyword_lines(lines))
    fields = lines[k].split(",")
    form = rng.randrange(4)
    if form == 0 and len(fields) > 1:
        del fields[rng.randrange(1, len(fields))]
    elif form == 1 and len(fields) > 1:
        fields[rng.randrange(1, len(fields))] = " " + rng.choice(PARAMETERS)
    elif form == 2 and len(fields) > 1:
        at = rng.randrange(1, len(fields))
        fields[at] = re.sub(r"=(.*)", lambda m: "=" + rng.choice([m.group(1)[:-1], m.group(1) + "x", '"' + m.group(1).strip('"') + '"', "", "A"]), fields[at])
    else:
        fields.append(" " + rng.choice(PARAMETERS))
    lines[k] = ",".join(fields)


def change_keyword(rng, lines):
    k = rng.choice(keyword_lines(lines))
    word, *rest = lines[k].split(",")
    lines[k] = rng.choice([",".join([word[:-1]] + rest), word, lines[k][1:], "*" + lines[k], ",".join([word.replace(" ", "")] + rest), lines[k] + ",",
                           rng.choice(KEYWORDS), ",".join([word + "X"] + rest)])


def change_field(rng, lines):
    k = rng.randrange(len(lines))
    fields = lines[k].split(",")
    at = rng.randrange(len(fields))
    form = rng.randrange(5)
    if form == 0:
        del fields[at]
    elif form == 1:
        fields.insert(at, fields[at])
    elif form == 2:
        fields.insert(at, "")
    elif form == 3:
        fields[at] = rng.choice(NUMBERS)
    else:
        other = rng.randrange(len(fields))
        fields[at], fields[other] = fields[other], fields[at]
    lines[k] = ",".join(fields)


def change_lines(rng, lines):
    k, other = rng.randrange(len(lines)), rng.randrange(len(lines))
    form = rng.randrange(6)
    if form == 0:
        del lines[k]
    elif form == 1:
        lines.insert(k, lines[k])
    elif form == 2:
        lines[k], lines[other] = lines[other], lines[k]
    elif form == 3:
        lines.insert(k, rng.choice(KEYWORDS))
    elif form == 4:
        lines.insert(other, lines[k])
    else:
        low, high = min(k, other), max(k, other)
        del lines[low:min(high, low + 4)]


def damage(rng, files):
    """(kind, {name: bytes}) of a deck with one or two faults."""
    files = {name: list(lines) for name, lines in files.items()}
    name = rng.choice(list(files))
    form = rng.randrange(7)
    text = None
    if form == 0:
        kind, files[name] = "cut at a line", files[name][:rng.randrange(len(files[name]))]
    elif form == 1:
        kind = "cut at a byte"
        whole = "\n".join(files[name]) + "\n"
        text = whole[:rng.randrange(max(0, len(whole) - 400), len(whole))]
    elif form == 2:
        kind = "a byte"
        whole = "\n".join(files[name]) + "\n"
        at = rng.randrange(len(whole))
        text = whole[:at] + rng.choice(list('0123456789,."*=\n\r aE') + ["", "\0", "\xff"]) + whole[at + rng.randrange(2):]
    else:
        change = [change_parameter, change_keyword, change_field, change_lines][form - 3]
        kind = change.__name__
        for _ in range(rng.choice([1, 1, 1, 2])):
            if files[name] and keyword_lines(files[name]):
                change(rng, files[name])
    texts = {n: ("\n".join(lines) + "\n" if lines else "") for n, lines in files.items()}
    if text is not None:
        texts[name] = text
    return kind, {n: t.encode("latin-1", "replace") for n, t in texts.items()}
