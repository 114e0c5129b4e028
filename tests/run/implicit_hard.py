# SPDX-License-Identifier: Apache-2.0
"""What all hard cases of implicit scenes have in common (tests/hard/IMPLICIT.md): criteria of positions, energy and balance, an explicit
twin, and meshes of quadrilaterals that are drawn out along y."""
import os

import true_depth
from scene_program import SceneProgram

EVERY_STEP = "output: {every: 1.0e-12, fields: [displacement]}\n"
NODES, EDGES, GIVEN, BALANCE = 1e-2, 0.05, 1e-3, 1e-6  # criteria for all cases, unless a case names its own


def extruded(blocks, depth, layers=1):
    """Gmsh 2.2: of each (name, [nx, nz], place) one block; place(s, t) -> (x, z) for s, t from 0 to 1."""
    nodes, elements = [], []
    for number, (_, (nx, nz), place) in enumerate(blocks, 1):
        first = len(nodes) + 1
        for k in range(nz + 1):
            for j in range(layers + 1):
                for i in range(nx + 1):
                    x, z = place(i / nx, k / nz)
                    nodes.append((x, depth * j / layers, z))
        row, layer = nx + 1, (nx + 1) * (layers + 1)
        for k in range(nz):
            for j in range(layers):
                for i in range(nx):
                    low = first + i + row * j + layer * k
                    bottom = [low, low + 1, low + 1 + row, low + row]
                    elements.append((number, bottom + [node + layer for node in bottom]))
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(blocks))]
    lines += [f'3 {number} "{name}"' for number, (name, _, _) in enumerate(blocks, 1)] + ["$EndPhysicalNames", "$Nodes", str(len(nodes))]
    lines += [f"{i} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(nodes, 1)] + ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{i} 5 2 {b} {b} " + " ".join(map(str, e)) for i, (b, e) in enumerate(elements, 1)]
    return "\n".join(lines + ["$EndElements", ""])


def largest_energy(rows):
    return max(max(row["kinetic"] + row["internal"], abs(row["external"])) for row in rows)


class HardCase(SceneProgram):
    def depths(self, out="out"):
        """How deep nodes, and points of edges, lie in other bodies over all states [elements], by positions alone."""
        path = os.path.join(self.folder, out, "state.h5")
        return true_depth.deepest(path).share, true_depth.deepest(path, of_edges=True).share

    def judged(self, scene, ranks=1, out="out", nodes=NODES, edges=EDGES, given=GIVEN, code=0):
        """Rows of a run that meets the common criteria; of one that may stop (code: (0, 3)), also what it told."""
        self.write("scene.yaml", scene + EVERY_STEP)
        told = self.run_scene(ranks, "scene.yaml", "--out", out, "--force", code=code)
        rows, log = self.rows(out), self.text(out, "log.txt")
        of_nodes, of_edges = self.depths(out)
        if max(of_nodes, of_edges) > 0.1:
            self.assertRegex(log, "contact leaves penetration|lies .* of an element behind", "deep without a word")
        self.assertLessEqual(of_nodes, nodes)
        self.assertLessEqual(of_edges, edges)
        largest = largest_energy(rows)
        for row in rows:
            self.assertGreaterEqual(row["contact"] + row["friction"] + row["walls"] * (row["external"] == 0), -given * largest, row["time"])
            self.assertLessEqual(abs(row["total"] - rows[0]["total"]), BALANCE * largest, row["time"])
        return rows if code == 0 else (rows, told)

    def same_bits(self, scene, out="out"):
        """The same state on three ranks as in `out`."""
        self.go(scene + EVERY_STEP, 3, "ranks")
        self.assertEqual(self.summary("ranks")["state_hash"], self.summary(out)["state_hash"])

    def shortfall(self, value, computed):
        """Of a criterion that is missed (tests/hard/IMPLICIT.md has both figures): it gets no worse."""
        self.assertLessEqual(value, 1.3 * computed)
