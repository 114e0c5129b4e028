# SPDX-License-Identifier: Apache-2.0
"""Random impacts of coarse bodies: three to five boxes of any attitude fall on each other and on a rigid wall."""
import math
import random

MATERIALS = """materials:
  st: {model: j2, density: 7.85e-6, young: 210, poisson: 0.3, yield: 0.4, hardening: 1}
  el: {model: elastic, density: 2.7e-6, young: 70, poisson: 0.3}
  ru: {model: neo_hookean, density: 1.1e-6, bulk: 0.5, shear: 0.05}
  ri: {model: rigid, density: 7.85e-6}
"""
# law, elements, largest speed of a fall [mm/ms]
KINDS = [("st", ("hex8", "hex8_full"), 400), ("el", ("hex8", "hex8_full"), 250), ("ru", ("hex8", "hex8_full"), 100), ("ri", (None,), 600)]


def turned(axis, degrees, v):
    angle = math.radians(degrees)
    c, s = math.cos(angle), math.sin(angle)
    dot = sum(a * b for a, b in zip(axis, v))
    cross = [axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2], axis[0] * v[1] - axis[1] * v[0]]
    return [c * v[i] + s * cross[i] + (1 - c) * dot * axis[i] for i in range(3)]


def scene(seed, end=0.25, records=20):
    """The bodies are a function of the seed alone."""
    draw = random.Random(f"falling boxes {seed}")
    count = draw.randint(3, 5)
    # rubber meets slow bodies: all speeds of a scene have one scale
    kinds = [draw.choice(KINDS) for _ in range(count)]
    if all(law == "ri" for law, _, _ in kinds):  # nothing would bound the step
        kinds[0] = KINDS[1]
    slowest = min(kind[2] for kind in kinds)
    scale = slowest if slowest <= 100 else 400
    mesh, parts, initial = [], [], []
    level = 0.5
    for i, (law, elements, speed) in enumerate(kinds):
        size = [draw.uniform(3, 8) for _ in range(3)]
        cells = [draw.choice((1, 1, 2, 3, 4, 5, 6)) for _ in range(3)]
        axis = [draw.gauss(0, 1) for _ in range(3)]
        norm = math.sqrt(sum(a * a for a in axis))
        axis = [a / norm for a in axis]
        degrees = draw.choice((0.0, draw.uniform(0, 180), draw.uniform(0, 180), draw.uniform(0, 180)))
        corners = [turned(axis, degrees, [size[k] if b >> k & 1 else 0.0 for k in range(3)]) for b in range(8)]
        low = [min(c[k] for c in corners) for k in range(3)]
        high = [max(c[k] for c in corners) for k in range(3)]
        centre = [draw.uniform(-2, 2), draw.uniform(-2, 2)]
        at = [centre[0] - 0.5 * (low[0] + high[0]), centre[1] - 0.5 * (low[1] + high[1]), level - low[2]]
        level += high[2] - low[2] + draw.uniform(0.05, 1.5)
        mesh.append(f"  - {{box: {{part: p{i}, size: {rounded(size)}, elements: {cells}, "
                    f"rotate: {{axis: {rounded(axis)}, degrees: {degrees:.9f}}}, at: {rounded(at)}}}}}")
        element = draw.choice(elements)
        parts.append(f"p{i}: {{material: {law}{', element: ' + element if element else ''}}}")
        fall = -scale * (0.2 + 0.8 * i / count) * draw.uniform(0.7, 1.3)
        velocity = [draw.gauss(0, 0.02) * scale, draw.gauss(0, 0.02) * scale, fall]
        initial.append(f"{{part: p{i}, velocity: {rounded(velocity)}}}")
    friction = draw.choice((0, 0, 0.2))
    time = end * 400 / scale
    return ("units: mm-ms-kg\nmesh:\n" + "\n".join(mesh) + "\n" + MATERIALS + f"parts: {{{', '.join(parts)}}}\n"
            f"initial: [{', '.join(initial)}]\ncontact: [{{between: all, friction: {friction}}}]\n"
            "rigid_walls: [{name: w, point: [0, 0, 0], normal: [0, 0, 1], friction: 0.2}]\n"
            f"run: {{end: {time:.6g}}}\noutput: {{every: {time / records:.6g}, fields: [displacement]}}\n")


def rounded(values):
    return "[" + ", ".join(f"{value:.9g}" for value in values) + "]"
