# SPDX-License-Identifier: Apache-2.0
"""Rigid bodies and walls that are driven into each other, with and without a way out: a scene for each number."""
import math
import random
from dataclasses import dataclass, field

SHARE = 0.01  # of a body's shortest side: the driven penetration at which a run stops

MASSES = "masses"  # chains of bodies of very different densities, some exactly aligned and without gaps
KINDS = ("chain", "walls", "into_wall", "turned", "tilted", "soft", "way_out")


@dataclass
class Scene:
    kind: str
    text: str = ""
    stuck: bool = True      # no way out: the run must stop
    sizes: dict = field(default_factory=dict)  # of the rigid boxes
    free: list = field(default_factory=list)   # parts that nothing holds
    speed: float = 1.0      # of the drive
    slack: float = 0.0      # travel of the drive until the last gap is closed
    step: float = 0.0
    limit: float = 0.0      # largest depth that is admitted anywhere
    rows: int = 0           # number of places where bodies of the chain touch


def turned(axis, degrees, v):
    """Rodrigues."""
    size = math.sqrt(sum(c * c for c in axis))
    k = [c / size for c in axis]
    a = math.radians(degrees)
    dot = sum(p * q for p, q in zip(k, v))
    cross = [k[1] * v[2] - k[2] * v[1], k[2] * v[0] - k[0] * v[2], k[0] * v[1] - k[1] * v[0]]
    return [v[i] * math.cos(a) + cross[i] * math.sin(a) + k[i] * dot * (1 - math.cos(a)) for i in range(3)]


def numbers(values):
    return "[" + ", ".join(f"{v:.15g}" for v in values) + "]"


class Maker:
    """Bodies on top of each other along z; the frame may be turned as a whole."""

    def __init__(self, seed, kind):
        self.random = random.Random(f"{kind} {seed}")
        self.scene = Scene(kind)
        self.boxes, self.parts, self.more, self.densities = [], [], [], {"hard": 1.0}
        self.axis, self.degrees = [0, 0, 1], 0.0
        self.flush = False

    def turn_frame(self):
        self.axis = [self.random.uniform(-1, 1) for _ in range(3)]
        self.degrees = self.random.uniform(5, 175)

    def along(self, v):
        return turned(self.axis, self.degrees, v)

    def box(self, part, size, at, material="hard", elements=None, tilt=0.0):
        counts = elements or [self.random.choice((1, 1, 2, 3)) for _ in range(3)]
        turns = []
        if tilt:
            turns.append(f"{{axis: {numbers([self.random.uniform(-1, 1), self.random.uniform(-1, 1), 0.2])}, degrees: {tilt:.6g}}}")
        if self.degrees:
            turns.append(f"{{axis: {numbers(self.axis)}, degrees: {self.degrees:.15g}}}")
        rotate = f", rotate: [{', '.join(turns)}]" if turns else ""
        self.boxes.append(f"  - {{box: {{part: {part}, size: {numbers(size)}, elements: {counts}{rotate}, at: {numbers(self.along(at))}}}}}\n")
        self.parts.append(f"{part}: {{material: {material}}}")
        if material != "soft":
            self.scene.sizes[part] = size

    def masses(self, count):
        """Materials of so many bodies."""
        for k in range(count):
            self.densities[f"hard{k}"] = 10**self.random.uniform(-1.5, 1.5)
        return {k: f"hard{k}" for k in range(count)}

    def gap(self, size):
        if self.flush:
            return 0.0
        gap = self.random.uniform(0.005, 0.05) * size
        self.scene.slack += gap
        return gap

    def size(self):
        return [self.random.uniform(1, 5) for _ in range(3)]

    def stack(self, count, z, materials=None):
        """Free bodies over z; returns where the next one stands."""
        for k in range(count):
            size = self.size()
            part = f"b{k}"
            material = (materials or {}).get(k, "hard")
            elements = [3, 3, 3] if material == "soft" else None
            self.box(part, size, [-0.5 * size[0], -0.5 * size[1], z], material, elements)
            self.scene.free.append(part)
            z += size[2] + self.gap(size[2])
        return z

    def drive(self, part, velocity, free_turns):
        held = "" if free_turns else ", dofs: [rx, ry, rz]"
        for axis, v in zip("xyz", self.along(velocity)):
            self.more.append(("prescribed", f"{{part: {part}, dof: {axis}, velocity: {v:.12g}}}"))
        if held:
            self.more.append(("fixed", f"{{part: {part}{held}}}"))

    def plate(self, part, z):
        """A broad rigid plate with its lower side at z."""
        size = [7.0, 7.0, self.random.uniform(1, 4)]
        self.box(part, size, [-3.5, -3.5, z])
        return size[2]

    def end(self, run, friction, contact=True):
        scene = self.scene
        self.random.shuffle(self.boxes)
        scene.limit = SHARE * max(min(size) for size in scene.sizes.values())
        records = 4 * max(1, round(scene.slack / (scene.speed * scene.step) / 60))
        keys = {}
        for key, entry in self.more:
            keys.setdefault(key, []).append(entry)
        lists = "".join(f"{key}: [{', '.join(entries)}]\n" for key, entries in keys.items())
        scene.text = ("units: none\nmesh:\n" + "".join(self.boxes) +
                      "materials: {" + "".join(f"{name}: {{model: rigid, density: {value:.6g}}}, " for name, value in self.densities.items()) +
                      "soft: {model: neo_hookean, density: 1.0, young: 1.0e4, poisson: 0.3}}\n"
                      f"parts: {{{', '.join(self.parts)}}}\n" + lists +
                      (f"contact: [{{between: all, friction: {friction}}}]\n" if contact else "") +
                      f"run: {run}\nhistory: {{every: {2 * scene.step:.6g}}}\noutput: {{every: {records * scene.step:.6g}}}\n")
        return scene


def scene_of(seed, kind=None):
    kind = kind or KINDS[seed % len(KINDS)]
    make = Maker(seed, kind)
    rnd, scene = make.random, make.scene
    scene.speed = rnd.choice((0.1, 1.0, 10.0))
    friction = rnd.choice((0, 0, 0.3))
    count = rnd.choice((1, 1, 2, 3))
    travel = rnd.uniform(1e-3, 8e-3)  # of the drive in a step, over the size 1 of the smallest bodies: a tenth to 8 tenths of the limit
    scene.step = travel / scene.speed
    if kind == MASSES:
        friction, count = rnd.choice((0, 0.05, 0.3, 0.3)), rnd.choice((2, 3, 3, 4))
        make.flush = rnd.random() < 0.5
    if kind in ("chain", MASSES, "soft", "way_out", "tilted"):
        if kind != MASSES or rnd.random() < 0.5:
            make.turn_frame()
        z, below = 0.0, rnd.choice(("plate", "wall"))
        if kind != "way_out":
            if below == "plate":
                z = make.plate("low", 0.0)
                make.more.append(("fixed", "{part: low, dofs: [x, y, z, rx, ry, rz]}"))
            else:
                make.more.append(("rigid_walls", f"{{point: [0, 0, 0], normal: {numbers(make.along([0, 0, 1]))}, friction: {friction}}}"))
            z += make.gap(1.0)
        if kind == "tilted":
            size = make.size()
            far = math.sqrt(sum(c * c for c in size))
            make.box("b0", size, [0, 0, z + far], tilt=rnd.uniform(5, 85))
            scene.free.append("b0")
            z += 2 * far
            scene.slack += 2 * far
        else:
            materials = {rnd.randrange(count): "soft"} if kind == "soft" else make.masses(count) if kind == MASSES else None
            z = make.stack(count, z, materials)
        make.plate("ram", z)
        make.drive("ram", [0, 0, -scene.speed], kind != "tilted" and rnd.random() < 0.3)
    elif kind == "walls":
        make.turn_frame()
        up = make.along([0, 0, 1])
        z = make.stack(count, make.gap(1.0))
        make.more.append(("rigid_walls", f"{{point: [0, 0, 0], normal: {numbers(up)}, friction: {friction}}}"))
        make.more.append(("rigid_walls", f"{{point: {numbers(make.along([0, 0, z]))}, normal: {numbers([-c for c in up])}, motion: v}}"))
    elif kind == "into_wall":
        make.turn_frame()
        make.more.append(("rigid_walls", f"{{point: [0, 0, 0], normal: {numbers(make.along([0, 0, 1]))}, friction: {friction}}}"))
        size = make.size()
        make.box("ram", size, [-0.5 * size[0], -0.5 * size[1], make.gap(1.0)])
        make.drive("ram", [0, 0, -scene.speed], rnd.random() < 0.7)
        count = 0
    elif kind == "turned":  # an arm along x turns about z towards a body in front of a wall at y = 0
        size = make.size()
        radius = rnd.uniform(4, 8)
        make.box("b0", size, [radius - 0.5 * size[0], make.gap(1.0), -0.5 * size[2]])
        scene.free.append("b0")
        y = size[1] + make.gap(1.0) + scene.slack + 0.2
        make.box("ram", [2 * (radius + size[0]), 2.0, 4.0], [-(radius + size[0]), y, -2.0])
        make.more.append(("rigid_walls", f"{{point: [0, 0, 0], normal: [0, 1, 0], friction: {friction}}}"))
        make.more.append(("fixed", "{part: ram, dofs: [x, y, z, rx, ry]}"))
        make.more.append(("prescribed", f"{{part: ram, dof: rz, velocity: {-scene.speed / radius:.9g}}}"))
        scene.slack += 2.0
        count = 1
    scene.rows = count + 1
    if kind == "soft":
        scene.stuck = False
    if kind == "way_out":
        scene.stuck = False
    travel = scene.slack + 20 * scene.rows * SHARE * 5 + 1.0
    if not scene.stuck:
        travel = scene.slack + (0.03 if kind == "soft" else 1.0)
    run = f"{{end: {travel / scene.speed:.9g}, step: {scene.step:.9g}}}"
    text = make.end(run, friction)
    if kind == "walls":
        text.text = text.text.replace("run: ", f"curves: {{v: [[0, {scene.speed}], [1, {scene.speed}]]}}\nrun: ", 1)
    return text
