# SPDX-License-Identifier: Apache-2.0
"""From the cards of an Abaqus input file to nodes, blocks, sets and faces: the second half of abaqus_parser.py."""
import copy
import re

from abaqus_parser import (BESIDE, FACES, GENERATORS, GLOBAL, HEXAHEDRON, KEYWORDS, Scope, cards_of, check_parameters, frame_of, integer,
                           label, need, node_place, real, squeeze, turned, volume)


class Reader:
    def __init__(self):
        self.flat, self.assembly, self.parts, self.instances = Scope(), Scope(), {}, []
        self.inside, self.scope, self.frame, self.step, self.seen_assembly = "", self.flat, GLOBAL, False, False

    def read(self, cards):
        for card in cards:
            need(card.word not in GENERATORS, card.word)
            if card.word in KEYWORDS:
                check_parameters(card)
                need(not card.unended, "line end")
                self.take(card)
        need(self.inside == "" and not self.step, "end of a block")
        if self.flat.elements or self.flat.foreign:
            self.instances.append((("", ""), self.flat, (0.0, 0.0, 0.0), None))

    def take(self, card):
        word = card.word
        if word.startswith("END") or word in ("PART", "ASSEMBLY", "INSTANCE", "STEP"):
            need(word in ("INSTANCE", "STEP") or not card.data, "data")
            return self.block(card)
        if word in ("NODE", "ELEMENT", "SOLIDSECTION", "SYSTEM"):
            need(not self.step and (self.inside or not (self.parts or self.seen_assembly)), "place")
        {"NODE": self.nodes, "ELEMENT": self.elements, "NSET": self.set, "ELSET": self.set, "SURFACE": self.surface,
         "SOLIDSECTION": self.section, "SYSTEM": self.system}[word](card)

    def system(self, card):
        need(self.inside != "ASSEMBLY", "place")
        self.frame = frame_of(card)

    def section(self, card):
        need(self.inside != "ASSEMBLY", "place")
        self.scope.sections.append(card.label("ELSET")[1])

    def block(self, card):
        word, self.frame = card.word, GLOBAL
        if word in ("STEP", "ENDSTEP"):
            need(self.inside == "" and self.step == (word == "ENDSTEP"), word)
            self.step = word == "STEP"
            return
        need(not self.step, word)
        if word.startswith("END"):
            need(self.inside == word[3:], word)
            self.inside = "ASSEMBLY" if word == "ENDINSTANCE" else ""
            self.scope = self.assembly if self.inside or self.seen_assembly else self.flat
            return
        need(self.inside == ("ASSEMBLY" if word == "INSTANCE" else "") and not self.flat.nodes, word)
        self.inside = word
        if word == "PART":
            name = card.label("NAME")
            need(name[1] not in self.parts, "part twice")
            self.scope = self.parts[name[1]] = Scope()
        elif word == "ASSEMBLY":
            need(not self.seen_assembly, "assembly twice")
            self.seen_assembly, self.scope = True, self.assembly
        else:
            name, part = card.label("NAME"), card.label("PART")[1]
            need(part in self.parts and all(name[1] != i[0][1] and name[0] != i[0][0] for i in self.instances), "instance")
            rows = [[real(f) for f in row[:-1]] for row in card.data]
            need(len(rows) <= 2 and (not rows or len(rows[0]) <= 3) and (len(rows) < 2 or len(rows[1]) == 7), "placement")
            shift = tuple((rows[0] + [0.0] * 3)[:3]) if rows else (0.0, 0.0, 0.0)
            self.scope = copy.deepcopy(self.parts[part])
            self.scope.used = bool(self.scope.nodes)
            self.instances.append((name, self.scope, shift, rows[1] if len(rows) == 2 else None))

    def named(self, card, sets, parameter):
        written, key = card.label(parameter)
        if key not in sets:
            need(all(s["name"] != written for s in sets.values()), "name twice")
            sets[key] = {"name": written, "members": [], "taken": False}
        need(not sets[key]["taken"], "a set that grows after its use")
        return sets[key]["members"]

    def nodes(self, card):
        need(card.data and not self.scope.used, "nodes")
        system = squeeze(label(card.parameters.get("SYSTEM", "R"))[0])
        members = self.named(card, self.scope.node_sets, "NSET") if "NSET" in card.parameters else []
        for row in card.data:
            number = integer(row[0])
            members.append((number, number, 1, None))
            if self.inside == "ASSEMBLY":
                self.scope.nodes[number] = None
                continue
            need(number not in self.scope.nodes and len(row) <= 8, "node")
            self.scope.nodes[number] = node_place([real(f) for f in row[1:-1][:3]], system, self.frame)

    def elements(self, card):
        need(card.data and not self.scope.used, "elements")
        kind = squeeze(label(card.parameters.get("TYPE", ""))[0])
        solid = re.fullmatch(r"C3D([4568])([RIHTPES]*)", kind)
        members = self.named(card, self.scope.element_sets, "ELSET") if "ELSET" in card.parameters else []
        dealt = card.label("ELSET")[1] if "ELSET" in card.parameters else ""
        rest, count = [], int(solid.group(1)) if solid else 0
        if not solid:
            need(kind.startswith(BESIDE) or self.inside == "ASSEMBLY", f"type {kind}")
        need(not (solid and self.inside == "ASSEMBLY"), "solids of the assembly")
        for row in card.data:
            rest += row[:-1]
            if len(rest) <= count if solid else row[-1]:
                continue
            number = integer(rest[0])
            need(number not in self.scope.elements and number not in self.scope.foreign or self.inside == "ASSEMBLY", "element twice")
            members.append((number, number, 1, None))
            if solid:
                need(len(rest) == count + 1, "nodes of an element")
                corners = [integer(f) for f in rest[1:]]
                need(all(n in self.scope.nodes for n in corners), "node of an element")
                self.scope.elements[number] = (corners, dealt)
            else:
                self.scope.foreign[number] = kind
            rest = []
        need(not (solid and rest), "incomplete element")

    def instance(self, key):
        found = [k for k, i in enumerate(self.instances) if i[0][1] == key]
        need(found, f"instance {key}")
        return found[0]

    def chosen(self, field, sets, instance):
        """Members that a field names: a number, a set, INSTANCE.NUMBER or INSTANCE.SET."""
        if re.fullmatch(r"[+0-9]+", field):
            number = integer(field)
            return [(number, number, 1, instance)]
        need(field, "empty field")
        known = getattr(self.scope if instance is None else self.instances[instance][1], sets)
        found = known.get(label(field)[1])
        if found:
            found["taken"] = True
            return [m if instance is None else m[:3] + (instance,) + m[4:] for m in found["members"]]
        dotted = re.fullmatch(r'((?:"[^"]*"|[^".])*)\.(.*)', field)
        need(instance is None and dotted, f"set {field}")
        return self.chosen(dotted.group(2).strip(" \t"), sets, self.instance(label(dotted.group(1).strip(" \t"))[1]))

    def set(self, card):
        sets = "node_sets" if card.word == "NSET" else "element_sets"
        members = self.named(card, getattr(self.scope, sets), card.word)
        instance = self.instance(card.label("INSTANCE")[1]) if "INSTANCE" in card.parameters else None
        if card.word == "NSET" and "ELSET" in card.parameters:
            need(not card.data and "GENERATE" not in card.parameters, "data beside ELSET")
            card.label("ELSET")
            members += [m[:4] + ("nodes of",) for m in self.chosen(card.parameters["ELSET"], "element_sets", instance)]
            return
        need(card.data, "empty set")
        for row in card.data:
            if "GENERATE" in card.parameters:
                need(len(row) in (3, 4), "GENERATE")
                first, last, step = ([integer(f) for f in row[:-1]] + [1])[:3]
                need(first <= last and (last - first) % step == 0, "GENERATE")
                members.append((first, last, step, instance, "generated"))
                continue
            for field in row[:-1]:
                members += self.chosen(field, sets, instance)

    def surface(self, card):
        name, kind = card.label("NAME"), squeeze(label(card.parameters.get("TYPE", "ELEMENT"))[0])
        need(card.data and all(name[1] != k and name[0] != s[0] for k, s in self.scope.surfaces.items() if kind in ("NODE", "ELEMENT")), "surface")
        if kind in ("CYLINDER", "REVOLUTION", "SEGMENTS", "CUTTINGSURFACE", "USER", "EULERIANMATERIAL", "XFEM"):
            return
        need(kind in ("NODE", "ELEMENT"), "TYPE of a surface")
        pieces = []
        for row in card.data:
            need(len(row) <= 3, "surface")
            face = 0
            if kind == "ELEMENT" and len(row) == 3:
                need(re.fullmatch("S[1-6]", row[1].upper()), "face")
                face = int(row[1][1])
            pieces.append((self.chosen(row[0], "node_sets" if kind == "NODE" else "element_sets", None), face))
        self.scope.surfaces[name[1]] = (name[0], kind, pieces)


class Whole:
    """The mesh of all instances."""

    def __init__(self, reader):
        self.reader = reader
        self.nodes, self.blocks, self.node_sets, self.side_sets, self.foreign = [], {}, {}, {}, {}
        self.placed, self.faces, self.volumes = [], {}, {}
        need(any(i[1].elements for i in reader.instances), "no solid elements")
        for name, scope, shift, turn in reader.instances:
            self.place(name[0], scope, shift, turn)
        for name, scope, _, _ in reader.instances:
            self.sets(scope, scope, name[0] + "." if name[0] else "")
        self.sets(reader.assembly, None, "")

    def place(self, name, scope, shift, turn):
        index = {}
        for number, place in scope.nodes.items():
            index[number] = len(self.nodes)
            self.nodes.append(turned(place, shift, turn))
        self.placed.append((scope, index))
        of = {n: dealt for n, (_, dealt) in scope.elements.items()}
        if scope.sections:
            of = {}
            for key in scope.sections:
                need(key in scope.element_sets, "set of a section")
                for _, number in self.numbers(scope.element_sets[key]["members"], scope, "elements"):
                    if number in scope.elements:
                        need(of.setdefault(number, key) == key, "element in two sections")
            need(len(of) == len(scope.elements), "element without a section")
        prefix, shapes = name + "." if name else "", {}
        for number, (corners, _) in scope.elements.items():
            shapes.setdefault(of[number], set()).add(len(corners) == 4)
        for number, (corners, _) in scope.elements.items():
            nodes = [index[n] for n in corners]
            key = of[number]
            shown = prefix + scope.element_sets[key]["name"] if key in scope.element_sets else name
            if len(corners) == 4 and len(shapes[key]) == 2:
                shown += "_tet4"
            size = volume([self.nodes[nodes[k]] for k in (HEXAHEDRON[len(nodes)] if len(nodes) > 4 else range(4))])
            need(size > 0, "volume")
            self.blocks.setdefault(shown, []).append(nodes)
            self.volumes[shown] = self.volumes.get(shown, 0.0) + size
            for face in FACES[len(nodes)]:
                one = frozenset(nodes[int(c) - 1] for c in face)
                self.faces[one] = self.faces.get(one, 0) + 1
        for kind in scope.foreign.values():
            self.foreign[kind] = self.foreign.get(kind, 0) + 1

    def numbers(self, members, own, kind):
        """(position of the instance, number) of each member; the position is None for points of the assembly."""
        for first, last, step, instance, *how in members:
            scope = own if own is not None else self.reader.assembly if instance is None else self.placed[instance][0]
            position = next((k for k, p in enumerate(self.placed) if p[0] is scope), None)
            known = scope.nodes if kind == "nodes" and how[:1] != ["nodes of"] else {**scope.elements, **scope.foreign}
            if first == last and "generated" not in how:
                need(first in known, f"number {first}")
                yield position, first
            else:
                found = [n for n in known if first <= n <= last and (n - first) % step == 0]
                need(found, "empty range")
                yield from ((position, n) for n in found)

    def nodes_of(self, members, own):
        found = set()
        for member in members:
            if "nodes of" in member:
                for position, number in self.numbers([member[:4] + ("generated",)] if member[0] != member[1] else [member], own, "elements"):
                    need(position is not None and number in self.placed[position][0].elements, "nodes of a foreign element")
                    found |= {self.placed[position][1][n] for n in self.placed[position][0].elements[number][0]}
            else:
                found |= {self.placed[p][1][n] for p, n in self.numbers([member], own, "nodes") if p is not None}
        return found

    def sets(self, scope, own, prefix):
        for one in scope.node_sets.values():
            if found := self.nodes_of(one["members"], own):
                need(prefix + one["name"] not in self.node_sets, "set twice")
                self.node_sets[prefix + one["name"]] = sorted(found)
        for one in scope.element_sets.values():
            list(self.numbers(one["members"], own, "elements"))
        for shown, kind, pieces in scope.surfaces.values():
            name, faces, nodes, foreign = prefix + shown, set(), set(), False
            for members, face in pieces:
                if kind == "NODE":
                    nodes |= self.nodes_of(members, own)
                    continue
                for position, number in self.numbers(members, own, "elements"):
                    if position is None or number not in self.placed[position][0].elements:
                        foreign = True  # its face is no part of the mesh
                        continue
                    part, index = self.placed[position]
                    corners = [index[n] for n in part.elements[number][0]]
                    need(face <= len(FACES[len(corners)]), "face")
                    all_faces = [frozenset(corners[int(c) - 1] for c in f) for f in FACES[len(corners)]]
                    faces |= {(position, number, f) for f in ([all_faces[face - 1]] if face else all_faces) if face or self.faces[f] == 1}
            if faces or foreign:
                need(name not in self.side_sets, "surface twice")
                self.side_sets[name] = sorted(sorted(f) for _, _, f in faces)
                nodes = set().union(*(f for _, _, f in faces)) if faces else nodes
            if nodes and (kind == "NODE" or name not in self.node_sets):
                need(name not in self.node_sets, "set twice")
                self.node_sets[name] = sorted(nodes)


def read(path):
    reader = Reader()
    reader.read(cards_of(path))
    return Whole(reader)

