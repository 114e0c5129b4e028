# SPDX-License-Identifier: Apache-2.0
"""Wrong joints between rigid parts."""


def cases(wrong):
    """wrong: the type of one case."""
    def joint(what, entries, *says, more="", law="{model: rigid, density: 1}", step=", step: 1.0e-3"):
        """Two boxes side by side with joints."""
        scene = f"""\
units: SI
mesh:
  - {{box: {{part: a, size: [1, 1, 1], elements: [1, 1, 1]}}}}
  - {{box: {{part: b, size: [1, 1, 1], elements: [1, 1, 1], at: [1.5, 0, 0]}}}}
materials: {{hard: {law}}}
parts: {{a: {{material: hard}}, b: {{material: hard}}}}
joints: [{entries}]
run: {{end: 1{step}}}
{more}"""
        return wrong(f"joint {what}", list(says), scene=scene)

    return [
        joint("of an unknown part", "{name: j, type: ball, between: [a, c], point: [0, 0, 0]}", "joints.0.between.1", "unknown part 'c'",
               "expected"),
        joint("of an unknown type", "{name: j, type: hinge, between: [a, b], point: [0, 0, 0]}", "joints.0.type", "'hinge'", "ball"),
        joint("of a later type", "{name: j, type: universal, between: [a, b], point: [0, 0, 0]}", "joints.0.type", "universal", "expected"),
        joint("without an axis", "{name: j, type: revolute, between: [a, b], point: [0, 0, 0]}", "joints.0", "axis", "expected"),
        joint("with an axis of no length", "{name: j, type: revolute, between: [a, b], point: [0, 0, 0], axis: [0, 0, 0]}", "joints.0.axis",
               "expected"),
        joint("of a ball with an axis", "{name: j, type: ball, between: [a, b], point: [0, 0, 0], axis: [0, 0, 1]}", "joints.0.axis",
               "ball joint", "expected"),
        joint("of one part", "{name: j, type: ball, between: [a], point: [0, 0, 0]}", "joints.0.between", "expected a list of two rigid parts"),
        joint("of a part with itself", "{name: j, type: ball, between: [a, a], point: [0, 0, 0]}", "joints.0.between", "one body", "expected"),
        joint("of the ground with itself", "{name: j, type: ball, between: [ground, ground], point: [0, 0, 0]}", "joints.0.between",
               "ground with itself", "expected"),
        joint("beyond the numbers of the machine", "{name: j, type: ball, between: [a, b], point: [1.0e160, 0, 0]}", "joints.0",
              "out of range", "expected"),
        joint("with an angle", "{name: j, type: ball, between: [a, b], point: [0, 0, 0], angle: 1}", "joints.0.angle", "expected"),
        joint("used twice", "{name: j, type: ball, between: [a, b], point: [0, 0, 0]}, {name: j, type: ball, between: [a, ground], "
               "point: [0, 0, 0]}", "joints.1", "'j'", "used twice"),
        joint("opened by the motion", "{name: j, type: ball, between: [a, b], point: [0, 0, 0]}", "joints.0", "open joint 'j'", "expected",
               more="initial: [{part: a, velocity: [0, 1, 0]}]\n"),
        joint("of a deformable part", "{name: j, type: ball, between: [a, b], point: [0, 0, 0]}", "joints.0.between", "'a': it is deformable",
               "expected", law="{model: elastic, density: 1, young: 1, poisson: 0}"),
        joint("in an implicit scene", "{name: j, type: ball, between: [a, b], point: [0, 0, 0]}", "joints", "implicit", "expected",
               more="solver: {scheme: contact_implicit, step: 1.0e-3}\n", step=""),
        joint("whose angle is asked for", "{name: j, type: ball, between: [a, b], point: [0, 0, 0]}", "probes.0.field", "'angle'", "expected",
               more="probes: [{name: p, joint: j, field: angle}]\n"),
        joint("asked for by a wrong name", "{name: jack, type: ball, between: [a, b], point: [0, 0, 0]}", "probes.0.joint",
               "unknown joint 'jacke'", "did you mean 'jack'", more="probes: [{name: p, joint: jacke, field: gap}]\n"),
    ]
