#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Mesh files with seeded damage: refused, or the counts and the mass are those that an independent reader finds. --variants N: files of
each format. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment."""
import random
import struct
import unittest

from files_test import Files, tiny_meshes
from plain_files import FORMS, SCENE, bar, msh2, msh4
from run_test import variants_asked

VARIANTS = 5


def volume(nodes, cube):
    """Of a trilinear hexahedron: each face is the mean of its two splittings into triangles."""
    faces = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
    sums = 0
    for face in faces:
        a, b, c, d = (cube[k] for k in face)
        for one, two, three in ((a, b, c), (a, c, d), (b, c, d), (b, d, a)):  # both diagonals of a face
            sums += tet_origin(nodes, one, two, three) / 2
    return sums


def tet_origin(nodes, a, b, c):
    u, v, w = nodes[a], nodes[b], nodes[c]
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6


def read_msh(content):
    """(nodes by number, cubes) of MSH 2.2 or 4.1 of hexahedra; raises ValueError, KeyError or IndexError for what it does not understand."""
    lines = [line.split() for line in content.decode("utf-8-sig").splitlines() if line.split()]
    sections, k = {}, 0
    while k < len(lines):
        name = lines[k][0]
        end = next(i for i in range(k, len(lines)) if lines[i][0] == "$End" + name[1:])
        if name in sections:
            raise ValueError(name)
        sections[name], k = lines[k + 1:end], end + 1
    version = sections["$MeshFormat"][0][0]
    body, nodes, cubes = sections["$Nodes"], {}, []

    def add(number, words):
        if number in nodes:
            raise ValueError("twice")
        nodes[number] = tuple(float(w) for w in words[:3])

    if version == "2.2":
        rows = body[1:1 + int(body[0][0])]
        if len(rows) != int(body[0][0]) or len(body) != 1 + len(rows):
            raise ValueError("nodes")
        for row in rows:
            add(int(row[0]), row[1:4] + [None] * (3 - len(row[1:4])))
        rows = sections["$Elements"][1:]
        if len(rows) != int(sections["$Elements"][0][0]):
            raise ValueError("elements")
        for row in rows:
            if int(row[1]) == 5:
                corners = [int(w) for w in row[3 + int(row[2]):]]
                if len(corners) != 8:
                    raise ValueError("corners")
                cubes.append(corners)
            elif int(row[1]) not in (1, 2, 3, 15):
                raise ValueError("type")
        return nodes, cubes
    at = 1
    for _ in range(int(body[0][0])):
        count = int(body[at][3])
        numbers = [int(body[at + 1 + i][0]) for i in range(count)]
        for i, number in enumerate(numbers):
            add(number, body[at + 1 + count + i])
        at += 1 + 2 * count
    if len(nodes) != int(body[0][1]) or at != len(body):
        raise ValueError("nodes")
    body, at = sections["$Elements"], 1
    for _ in range(int(body[0][0])):
        kind, count = int(body[at][2]), int(body[at][3])
        for row in body[at + 1:at + 1 + count]:
            if kind == 5:
                corners = [int(w) for w in row[1:]]
                if len(corners) != 8:
                    raise ValueError("corners")
                cubes.append(corners)
        at += 1 + count
    if at != len(body) or len(cubes) != int(body[0][1]):
        raise ValueError("elements")
    return nodes, cubes


class Netcdf:
    """A classic netCDF file (NetCDF classic format specification, CDF-1)."""

    def __init__(self, content):
        self.content, self.at, self.dimensions, self.variables = content, 8, [], {}
        if content[:4] != b"CDF\x01":
            raise ValueError("magic")
        for _ in range(self.count(0x0A)):
            self.dimensions.append((self.text(), self.integer()))
        self.attributes()
        for _ in range(self.count(0x0B)):
            name, shape = self.text(), []
            for _ in range(self.integer()):
                shape.append(self.dimensions[self.integer()][1])
            attributes = self.attributes()
            kind, _, begin = self.integer(), self.integer(), self.integer()
            self.variables[name] = (shape, attributes, {4: "i", 5: "f", 6: "d"}.get(kind), begin)

    def integer(self):
        self.at += 4
        return struct.unpack_from(">i", self.content, self.at - 4)[0]

    def count(self, tag):
        found, count = self.integer(), self.integer()
        if found not in (0, tag) or count < 0 or count > len(self.content) or (found == 0 and count):
            raise ValueError("list")
        return count

    def text(self):
        length = self.integer()
        self.at += length + -length % 4
        return self.content[self.at - length - -length % 4:][:length].decode("latin-1")

    def attributes(self):
        found = {}
        for _ in range(self.count(0x0C)):
            name, kind, count = self.text(), self.integer(), self.integer()
            size = count * {1: 1, 2: 1, 3: 2, 4: 4, 5: 4, 6: 8}[kind]
            found[name] = self.content[self.at:self.at + size]
            self.at += size + -size % 4
        return found

    def size(self, name):
        return dict(self.dimensions)[name]

    def values(self, name):
        shape, _, kind, begin = self.variables[name]
        count = 1
        for extent in shape:
            count *= extent
        return struct.unpack_from(f">{count}{kind}", self.content, begin)


def read_exodus(content):
    """(nodes by number, cubes) of hexahedra (SAND92-2137)."""
    file = Netcdf(content)
    nodes = dict(enumerate(zip(*(file.values("coord" + axis) for axis in "xyz")), 1))
    cubes = []
    for block in range(1, file.size("num_el_blk") + 1):
        if "eb_status" in file.variables and file.values("eb_status")[block - 1] == 0:  # without it all blocks are in use
            continue
        kind = file.variables[f"connect{block}"][1]["elem_type"]
        if not kind.upper().startswith(b"HEX") or file.size(f"num_nod_per_el{block}") != 8:
            raise ValueError(kind)
        flat = file.values(f"connect{block}")
        cubes += [flat[k:k + 8] for k in range(0, 8 * file.size(f"num_el_in_blk{block}"), 8)]
    return nodes, cubes


def damaged_bytes(content, chance):
    data = bytearray(content)
    for _ in range(chance.choice((1, 1, 2, 4))):
        at = chance.randrange(len(data))
        data[at] = chance.choice((data[at] ^ (1 << chance.randrange(8)), chance.randrange(256), 0))
    return bytes(data[:chance.randrange(len(data))] if chance.random() < 0.1 else data)


def damaged(content, chance):
    """A text with some lines cut, doubled, swapped, or words changed."""
    lines = content.decode().split("\n")
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        k = chance.randrange(len(lines))
        words = lines[k].split()
        kind = chance.randrange(8)
        if kind == 0:
            del lines[k]
        elif kind == 1:
            lines.insert(k, lines[k])
        elif kind == 2:
            other = chance.randrange(len(lines))
            lines[k], lines[other] = lines[other], lines[k]
        elif kind == 3 and words:
            words[chance.randrange(len(words))] = chance.choice(("0", "-1", "1", "2", "5", "1e300", "nan", "x", "1.5", "99999999999", "2.5e-1", "7"))
            lines[k] = " ".join(words)
        elif kind == 4 and words:
            del words[chance.randrange(len(words))]
            lines[k] = " ".join(words)
        elif kind == 5:
            lines.insert(k, "")
        elif kind == 6:
            lines = lines[:k]
        elif words:
            digit = chance.randrange(len(lines[k]))
            lines[k] = lines[k][:digit] + chance.choice("0123456789 .-$") + lines[k][digit + 1:]
        if not lines:
            lines = [""]
    text = "\n".join(lines)
    return chance.choice(list(FORMS.values()))(text.encode()) if chance.random() < 0.3 else text.encode()


class Damage(Files):
    def assert_refused_or_equal(self, done, content, what, read=read_msh):
        self.assertIn(done.returncode, (0, 2), f"{what}: {done.stderr}")
        if done.returncode == 2:
            self.assertTrue(done.stderr.startswith("brunt: scene.yaml"), done.stderr)
            return False
        try:
            nodes, cubes = read(content)
            used = {n for cube in cubes for n in cube}
            wanted = (len(cubes), len(used), 8 * sum(volume(nodes, cube) for cube in cubes))
        except (ValueError, KeyError, IndexError, StopIteration, TypeError, struct.error) as error:
            self.fail(f"{what}: accepted, but an independent reader fails: {error!r}\n{content.decode(errors='replace')}")
        elements, count, mass = self.found(done)
        self.assertEqual((elements, count), wanted[:2], what)
        self.assertAlmostEqual(mass, wanted[2], delta=2e-4 * abs(wanted[2]), msg=what)
        return True

    def sweep(self, name, content, seed, damage=damaged, read=read_msh, block="1"):
        chance = random.Random(seed)
        scene = SCENE.replace("FILE", "bar.msh").replace("BLOCK", block)
        for k in range(VARIANTS):
            broken = damage(content, chance)
            self.put("bar.msh", broken)
            self.assert_refused_or_equal(self.check(scene), broken, f"{name} {seed} {k}", read)

    def test_msh_2(self):
        self.sweep("msh2", msh2(*bar(2)), 1)

    def test_msh_4(self):
        self.sweep("msh4", msh4(*bar(2)), 2)

    def test_exodus(self):
        self.sweep("exodus", tiny_meshes.exodus(*bar(2)), 3, damaged_bytes, read_exodus)
        self.sweep("exodus with an empty block", tiny_meshes.exodus(*bar(1), empty=1), 4, damaged_bytes, read_exodus, "2")

    def test_msh_cut_at_every_line_end(self):
        scene = SCENE.replace("FILE", "bar.msh").replace("BLOCK", "1")
        for content in (msh2(*bar(1)), msh4(*bar(1))):
            lines = content.split(b"\n")
            for k in range(1, len(lines) - 1):
                self.put("bar.msh", b"\n".join(lines[:k]) + b"\n")
                done = self.check(scene)
                if b"$EndElements" not in lines[:k]:
                    self.assertEqual(done.returncode, 2, (k, done.stdout))


if __name__ == "__main__":
    VARIANTS = variants_asked(VARIANTS)
    unittest.main()
