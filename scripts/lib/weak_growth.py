# SPDX-License-Identifier: Apache-2.0
"""How a scene grows with the number of ranks, as its section `scaling` says (src/scene/README.md)."""
import yaml

import bounded_yaml
from arguments import Fault, excerpt


def prime_factors(number):
    """Ascending."""
    found, divisor = [], 2
    while number > 1:
        while number % divisor == 0:
            found.append(divisor)
            number //= divisor
        divisor += 1
    return found


def factors_of(ranks, directions):
    """The growth of each direction: prime factors, the largest first, go to the one that has grown least."""
    growth = [1] * directions
    for factor in reversed(prime_factors(ranks)):
        growth[growth.index(min(growth))] *= factor
    return growth


def below(place, tree, step):
    """[(path, value)] that a step leads to; `*`: every entry. A mesh of one body may be written without its list."""
    if place == "mesh" and isinstance(tree, dict) and step in ("0", "*"):
        return [(place, tree)]
    entries = tree.items() if isinstance(tree, dict) else enumerate(tree) if isinstance(tree, list) else ()
    return [(f"{place}.{key}" if place else str(key), value) for key, value in entries if step in ("*", str(key))]


def values_at(tree, path):
    """[(path without `*`, value)]"""
    found = [("", tree)]
    for step in path.split("."):
        found = [entry for place, value in found for entry in below(place, value, step)]
    return found


def put(tree, path, text):
    """What `--set path=text` does to the tree; nothing where the path leads nowhere, which brunt itself reports."""
    parent, _, last = path.rpartition(".")
    for _, owner in values_at(tree, parent) if parent else [("", tree)]:
        if isinstance(owner, dict):
            owner[last] = yaml.safe_load(text)
        elif isinstance(owner, list) and last.isdigit() and int(last) < len(owner):
            owner[int(last)] = yaml.safe_load(text)


class Growth:
    """The growth that a scene file asks for; Fault where it asks for none, or for what is not there."""

    def __init__(self, path, given):
        """given: {key path: text} of --set, applied before anything grows."""
        try:
            with open(path, encoding="utf-8") as stream:
                self.tree = bounded_yaml.load(stream.read())
            for place, text in given.items():
                put(self.tree, place, text)
        except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
            what = " ".join(str(error).split())
            raise Fault(f"{path}: {what}" if "; expected" in what else f"{path}: cannot read the file ({what}); expected a scene file") from error
        self.path = path
        scaling = self.tree.get("scaling") if isinstance(self.tree, dict) else None
        if isinstance(scaling, dict) and set(scaling) - {"weak"}:
            raise Fault(f"{path}: scaling.{sorted(set(scaling) - {'weak'}, key=str)[0]}: unknown key; expected weak")
        self.directions = scaling.get("weak") if isinstance(scaling, dict) else None
        if not isinstance(self.directions, list) or not self.directions:
            raise Fault(f"{path}: scaling.weak: missing; expected a list of growing quantities for --weak, such as "
                        "[{counts: [mesh.0.box.elements.0], lengths: [mesh.0.box.size.0]}]")

    def fault(self, key, what, expected):
        raise Fault(f"{self.path}: {key}: {what}; expected {expected}")

    def overrides(self, ranks):
        """{key path: value} of the scene on so many ranks."""
        grown = {}
        for d, factor in enumerate(factors_of(ranks, len(self.directions))):
            direction = self.directions[d]
            if not isinstance(direction, dict) or "counts" not in direction or set(direction) - {"counts", "lengths"}:
                self.fault(f"scaling.weak.{d}", "invalid direction of growth", "a map {counts: [...], lengths: [...]}")
            if not direction["counts"]:
                self.fault(f"scaling.weak.{d}.counts", "missing entries", "a list of paths such as mesh.0.box.elements.0")
            for name, kind in (("counts", int), ("lengths", float)):
                for k, path in enumerate(direction.get(name) or []):
                    self.multiply(grown, f"scaling.weak.{d}.{name}.{k}", str(path), kind, factor)
        return grown

    def multiply(self, grown, key, path, kind, factor):
        values = values_at(self.tree, path)
        if kind is int and "elements" not in path.split("."):
            self.fault(key, f"invalid path '{excerpt(path)}': not a number of elements", "paths such as mesh.0.box.elements.0")
        if not values:
            self.fault(key, f"unknown path '{excerpt(path)}' in this scene", "a key path, as for --set")
        for place, value in values:
            try:
                number = kind(value) if not isinstance(value, (bool, list, dict)) else None
            except (TypeError, ValueError):
                number = None
            if number is None or (kind is int and (number < 1 or str(value).strip() != str(number))):
                self.fault(key, f"invalid path '{excerpt(path)}': it leads to {value!r}", "integers >= 1" if kind is int else "numbers")
            grown[place] = number * factor
