# SPDX-License-Identifier: Apache-2.0
"""Where the maps of a scene stand: how a test puts a map there, and which other keys it needs so that the reader reads all of its keys."""

MODELS = ("elastic", "j2", "neo_hookean", "johnson_cook", "piecewise_linear", "hydrodynamic", "crushable_foam", "rigid")
BODIES = ("box", "cylinder", "sphere", "tube", "torus", "plate")
GAS = {"model": "mie_gruneisen", "c": 5000, "s": 1.3, "gamma": 2}
STEEL = {"model": "elastic", "density": 7800, "young": 2.0e11, "poisson": 0.3}
METAL = {"model": "johnson_cook", "density": 7800, "young": 2.0e11, "poisson": 0.3, "A": 1.0e8, "B": 1.0e8, "n": 1, "C": 0}

# Sections that are one map.
SINGLE = ("gravity", "damping", "relaxation", "enforcement", "run", "output", "history", "checkpoint", "guards", "search", "solver", "scaling")
# Sections that are lists of maps.
LISTS = ("initial", "fixed", "symmetry", "prescribed", "pressure", "forces", "traction", "remove", "rigid_walls", "joints", "contact", "probes")

# By map: what decides which keys it has (the column `of` of the page), with the keys that say so; there may be several for one `of`.
CONTEXTS = {
    "mesh": [("all", {"file": "none.msh"}), ("all", {})],
    "mesh.BODY": [(body, {}) for body in BODIES],
    "mesh.BODY.nose": [(shape, {"shape": shape}) for shape in ("blunt", "hemisphere", "cone", "ogive")]
                      + [("cone", {"shape": "cone", "tip_radius": 0.5, "length": 1}), ("ogive", {"shape": "ogive", "tip_radius": 0.5})],
    "materials": [(model, {"model": model}) for model in MODELS]
                 + [(model, {"model": model, "eos": GAS}) for model in ("johnson_cook", "piecewise_linear", "hydrodynamic")]
                 + [("neo_hookean", {"model": "neo_hookean", "bulk": 1})],
    "materials.eos": [("mie_gruneisen", {"model": "mie_gruneisen"}), ("linear_polynomial", {"model": "linear_polynomial"})],
    "contact": [("all", {}), ("all", {"between": ["a", "b"]}), ("all", {"between": ["a", "b"], "method": "mortar"})],
    "joints": [("all", {}), ("all", {"type": "revolute"})],
    "prescribed": [("all", {}), ("all", {"displacement": "none"}), ("all", {"acceleration": "none"})],
    "probes": [("all", {}), ("all", {"node": 1}), ("all", {"part": "a"}), ("all", {"part": "a", "field": "angular_momentum"}),
               ("all", {"near": [0, 0, 0]}), ("all", {"joint": "none"})],
    "probes.section": [("all", {}), ("all", {"set": "none"})],
    "solver": [("all", {"scheme": "hht"})],
}


class Scenes:
    """Gathers maps in few scenes: those in lists, or named, in the first one; a section that is one map in the first that lacks it."""

    def __init__(self):
        self.scenes, self.whole = [], set()
        self.scene(0)

    def scene(self, number):
        while len(self.scenes) <= number:
            self.scenes.append({"units": "SI", "mesh": [], "materials": {"steel": STEEL}, "parts": {"a": {"material": "steel"}}})
        return self.scenes[number]

    def _listed(self, section, entry):
        entries = self.scene(0).setdefault(section, [])
        entries.append(entry)
        return 0, f"{section}.{len(entries) - 1}"

    def _named(self, section, entry):
        entries = self.scene(0).setdefault(section, {})
        name = f"k{len(entries)}"
        entries[name] = entry
        return 0, f"{section}.{name}"

    def _single(self, section, content):
        free = [n for n, scene in enumerate(self.scenes) if n not in self.whole and section not in scene]
        number = free[0] if free else len(self.scenes)
        self.scene(number)[section] = content
        return number, section

    def put(self, name, of, content):
        """Number of the scene and path of the key under which the map stands."""
        if name == "scene":
            self.whole.add(len(self.scenes))
            self.scenes.append(content)
            return len(self.scenes) - 1, ""
        if name in SINGLE:
            return self._single(name, content)
        if name in LISTS or name == "mesh":
            return self._listed(name, content)
        if name in ("materials", "parts", "sets"):
            return self._named(name, content)
        if name == "mesh.BODY":
            number, path = self._listed("mesh", {of: content})
            return number, f"{path}.{of}"
        return self._inner(name, content)

    def _inner(self, name, content):
        wraps = {
            "mesh.rotate": ("mesh", {"file": "none.msh", "rotate": content}, "rotate"),
            "mesh.BODY.nose": ("mesh", {"cylinder": {"part": "a", "radius": 1, "length": 2, "elements": [4, 4], "nose": content}},
                               "cylinder.nose"),
            "initial.rotation": ("initial", {"part": "a", "rotation": content}, "rotation"),
            "symmetry.rotate": ("symmetry", {"point": [0, 0, 0], "normal": [0, 0, 1], "rotate": content}, "rotate"),
            "contact.friction": ("contact", {"between": "all", "friction": content}, "friction"),
            "probes.section": ("probes", {"name": "cut", "section": content}, "section"),
        }
        if name in wraps:
            section, entry, inner = wraps[name]
            number, path = self._listed(section, entry)
            return number, f"{path}.{inner}"
        if name == "scaling.weak":
            number, path = self._single("scaling", {"weak": [content]})
            return number, f"{path}.weak.0"
        section, inner = name.split(".")
        base = {"parts": {"material": "steel"}, "materials": METAL}[section]
        if inner == "cowper_symonds":
            base = {"model": "piecewise_linear", "density": 1, "young": 1, "poisson": 0, "yield": 0.01}
        number, path = self._named(section, {**base, inner: content})
        return number, f"{path}.{inner}"
