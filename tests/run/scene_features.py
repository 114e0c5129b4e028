# SPDX-License-Identifier: Apache-2.0
"""What a scene is made of, and few scenes that have it all."""
import re

NAMED = {"parts", "materials", "curves", "sets"}  # sections whose keys are names
NAMES = {"part", "name", "set", "block", "node_set", "between", "slave", "material", "curve", "dofs"}  # keys with a name as value
OF_NO_STATE = {"title", "output", "probes", "run", "units"}  # sections that no state depends on
WORD = re.compile(r"[a-z][a-z_0-9]*")


def features(tree, path=""):
    """Paths of all keys without names and numbers of entries, with words that are choices: contact.method=mortar."""
    if path.startswith("mesh.") and path.count(".") == 1:
        return {path}  # sizes and places of a mesh are no feature
    found = {path} if path else set()
    if isinstance(tree, dict):
        for key, value in tree.items():
            if path or key not in OF_NO_STATE:
                found |= features(value, ".".join(filter(None, [path, "*" if path in NAMED else key])))
    elif isinstance(tree, list):
        found = found.union(*(features(value, path) for value in tree))
    elif isinstance(tree, str) and WORD.fullmatch(tree) and path.split(".")[-1] not in NAMES:
        found.add(f"{path}={tree}")
    return found


def covering(scenes):
    """Names of few scenes that have every feature of all of them; scenes: trees by name. Again and again the one with most."""
    of = {name: features(tree) for name, tree in scenes.items()}
    left, chosen = set().union(*of.values()), []
    while left:
        best = max(sorted(of), key=lambda name: len(of[name] & left))
        chosen.append(best)
        left -= of[best]
    return chosen
