# SPDX-License-Identifier: Apache-2.0
"""Wrong surfaces, poses and options of `brunt depth`."""
import struct

CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
QUADS = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def obj(corners=CORNERS, faces=QUADS, more=""):
    lines = ["v {} {} {}".format(*x) for x in corners] + ["f " + " ".join(str(i + 1) for i in face) for face in faces]
    return ("\n".join(lines) + "\n" + more).encode()


def stl(count, triangles):
    """A binary file that says it holds `count` triangles."""
    body = b"".join(struct.pack("<12f", 0, 0, 0, *[float(c) for corner in t for c in corner]) + b"\0\0" for t in triangles)
    return b"solid".ljust(80) + struct.pack("<I", count) + body


PLY = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n" \
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"


def cases(wrong):
    """wrong: the type of one case."""
    def surface(name, file, content, *says):
        return wrong(name, [file, *says], command="depth", target=file, arguments=["cube.obj"],
                     files={file: content, "cube.obj": obj()})

    def option(name, says, *arguments, **files):
        return wrong(name, says, command="depth", target="cube.obj", arguments=list(arguments),
                     files={"cube.obj": obj(), **{key.replace("_", "."): text for key, text in files.items()}})

    return [
        surface("surface of no known kind", "a.step", b"x", "expected", ".stl"),
        surface("surface that is empty", "a.stl", b"", "expected"),
        surface("surface that is a web page", "a.stl", b"<!DOCTYPE html><html><body>404</body></html>", "expected"),
        surface("stl cut off", "a.stl", stl(3, [CORNERS[:3]]), "expected"),
        surface("stl with a word for a number", "a.stl", b"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n", "a.stl:4"),
        surface("stl with infinity", "a.stl", stl(1, [[(0, 0, 0), (1, 0, 0), (float("inf"), 0, 0)]]), "triangle 1"),
        surface("obj with an index of no point", "a.obj", obj(faces=[(0, 1, 11)]), "a.obj:9", "12"),
        surface("obj with the index 0", "a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "a.obj:4"),
        surface("obj with nan", "a.obj", b"v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj:1"),
        surface("obj without faces", "a.obj", obj(faces=[]), "expected"),
        surface("obj with a face of two corners", "a.obj", obj(more="f 1 2\n"), "a.obj:15"),
        surface("ply with fewer points than it says", "a.ply", (PLY + "0 0 0\n1 0 0\n3 0 1 2\n").encode(), "a.ply"),
        surface("ply of an unknown format", "a.ply", PLY.replace("ascii", "binary_middle_endian").encode(), "a.ply:2", "expected"),
        surface("ply without points", "a.ply", b"ply\nformat ascii 1.0\nelement vertex 0\nend_header\n", "a.ply", "expected"),
        surface("open surface", "a.obj", obj(faces=QUADS[:-1]), "4 open edges", "the first", "expected a closed surface"),
        surface("a face turned over", "a.obj", obj(faces=[QUADS[0][::-1]] + QUADS[1:]), "edges", "expected"),
        surface("a fin on a cube", "a.obj", obj(corners=CORNERS + [(2, 2, 2)], faces=QUADS + [(0, 1, 8)]), "edge", "expected"),
        surface("inside out", "a.obj", obj(faces=[face[::-1] for face in QUADS]), "expected"),
        surface("a needle without volume", "a.obj", obj(corners=[(x, 1e-7 * y, 1e-7 * z) for x, y, z in CORNERS]), "a.obj: ", "volume", "expected"),
        surface("surface that is not there", "cube.obj2", obj(), "cube.obj2", "expected"),
        wrong("no second surface", ["cube.obj", "missing second surface", "expected A and B"], command="depth", target="cube.obj", files={"cube.obj": obj()}),
        option("second surface that is not there", ["nope.obj"], "nope.obj"),
        option("three numbers are a place", ["--at", "'1,2'", "x,y,z"], "cube.obj", "--at", "1,2"),
        option("a place is numbers", ["--at", "'1,2,c'"], "cube.obj", "--at", "1,2,c"),
        option("a place beyond all numbers", ["pose 0", "expected"], "cube.obj", "--at", "1e300,0,0"),
        option("an axis is not zero", ["--turn", "not zero"], "cube.obj", "--turn", "0,0,0,30"),
        option("an angle is missing", ["--turn", "degrees"], "cube.obj", "--turn", "0,0,1"),
        option("an unknown metric", ["--metric", "manhattan"], "cube.obj", "--metric", "manhattan"),
        option("a negative clearance", ["--clearance", "'-1'"], "cube.obj", "--clearance", "-1"),
        option("axes that are none", ["--along", "'x,w'"], "cube.obj", "--metric", "translation", "--along", "x,w"),
        option("axes without translations", ["--along", "--metric translation"], "cube.obj", "--along", "x"),
        option("poses and a place", ["--poses", "--at"], "cube.obj", "--poses", "p.csv", "--at", "1,2,3", p_csv=b"x,y,z\n0,0,0\n"),
        option("poses without a column", ["p.csv:1", "missing"], "cube.obj", "--poses", "p.csv", p_csv=b"x,y\n0,0\n"),
        option("poses with an unknown column", ["p.csv:1", "'w'"], "cube.obj", "--poses", "p.csv", p_csv=b"x,y,z,w\n0,0,0,0\n"),
        option("poses with a row cut short", ["p.csv:3", "2 values"], "cube.obj", "--poses", "p.csv", p_csv=b"x,y,z\n0,0,0\n1,2\n"),
        option("poses with a word", ["p.csv:2", "'one'"], "cube.obj", "--poses", "p.csv", p_csv=b"x,y,z\none,0,0\n"),
        option("poses of none", ["p.csv", "missing poses"], "cube.obj", "--poses", "p.csv", p_csv=b"x,y,z\n"),
        option("a gap beyond the depth", ["--certify", "'2'", "between 0 and 1"], "cube.obj", "--certify", "2"),
        option("no gap", ["--certify", "'0'", "between 0 and 1"], "cube.obj", "--certify", "0"),
        option("a value of a scene", ["--set", "run.end=2", "a scene"], "cube.obj", "--set", "run.end=2"),
        option("no boxes", ["--boxes"], "cube.obj", "--boxes", "0"),
        option("no time", ["--limit", "'soon'"], "cube.obj", "--limit", "soon"),
        option("pieces of three points", ["p.yaml", "piece 1"], "cube.obj", "--pieces", "p.yaml", p_yaml=b"a: [[[0, 0, 0], [1, 0, 0], [0, 1, 0]]]\n"),
        option("pieces in a plane", ["p.yaml: a", "piece 1", "plane"], "cube.obj", "--pieces", "p.yaml",
               p_yaml=b"a: [[[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]]\n"),
        option("pieces outside of their body", ["p.yaml: b", "piece 1", "outside"], "cube.obj", "--pieces", "p.yaml",
               p_yaml=b"b: [[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 2]]]\n"),
        option("results where a file is", ["--out", "taken"], "cube.obj", "--out", "taken", taken=b"precious"),
        option("pieces of a third body", ["p.yaml", "'c'"], "cube.obj", "--pieces", "p.yaml", p_yaml=b"c: []\n"),
        option("results of an earlier run", ["old", "--force"], "cube.obj", "--out", "old", **{"old/depth_json": b"precious"}),
    ]
