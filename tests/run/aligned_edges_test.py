#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A cube falls with an edge on the face of another one, node on node, the ends of the edge on the rim: all is symmetric,
and nothing depends on which part comes first. Needs BRUNT and BRUNT_RUN (scripts/run) in the environment. --all: finer cubes."""
import itertools
import sys
import unittest

from run_test import Program

SCENE = """units: SI
mesh:
{boxes}
materials: {{m: {{model: elastic, density: 1000, young: 1.0e8, poisson: {poisson}}}}}
parts: {{low: {{material: m, element: {element}}}, up: {{material: m, element: {element}}}}}
initial: [{{part: up, velocity: [0, 0, -2]}}]
contact: [{{between: all}}]
probes: [{{name: low, part: low, field: velocity}}]
run: {{end: 0.02}}
history: {{every: 1.0e-3}}
"""
LOW = "  - {{box: {{part: low, size: [1, 1, 1], elements: [{n}, {n}, {n}], at: [-0.5, -0.5, -0.5]}}}}"
UP = ("  - {{box: {{part: up, size: [1, 1, 1], elements: [{n}, {n}, {n}], rotate: {{axis: [1, 0, 0], degrees: 45}}, "
      "at: [-0.5, 0, {height}]}}}}")
SPEED, ENERGY = 2.0, 2000.0


class AlignedEdges(Program):
    counts, poissons = (2,), (0,)

    def fall(self, n, order, poisson, element, height):
        boxes = [LOW.format(n=n), UP.format(n=n, height=height)]
        self.write("scene.yaml", SCENE.format(boxes="\n".join(boxes[::order]), poisson=poisson, element=element))
        self.run_scene(1, "scene.yaml", "--out", "out", "--force")
        summary, last = self.summary("out"), self.history("out")[-1]
        return summary["max_penetration"], summary["energy"]["contact"] / ENERGY, last["low.x"], last["low.y"]

    def test_symmetric_whichever_part_comes_first(self):
        for n, poisson, element, height in itertools.product(self.counts, self.poissons, ("hex8", "hex8_full"), (0.505, 0.5001)):
            losses = []
            for order in (1, -1):
                with self.subTest(n=n, order=order, poisson=poisson, element=element, height=height):
                    depth, loss, along, across = self.fall(n, order, poisson, element, height)
                    self.assertLess(depth, 2e-5)
                    self.assertLess(abs(along), 1e-9 * SPEED)
                    self.assertLess(abs(across), 5e-9 * SPEED)  # what the iteration leaves grows: an edge on a face may tip
                    losses.append(loss)
            self.assertLess(max(losses) - min(losses), 1e-3, losses)


class FinerCubes(AlignedEdges):
    counts, poissons = (2, 3, 4, 6), (0, 0.3)


if __name__ == "__main__":
    if "--all" in sys.argv:
        sys.argv.remove("--all")
    else:
        del FinerCubes
    unittest.main()
