# SPDX-License-Identifier: Apache-2.0
"""YAML of bounded depth and size, as the program itself reads it (src/scene/text/yaml_document.hpp has the same limits)."""
import yaml

DEEPEST = 64  # levels of lists and maps
MOST_REPEATED = 100_000  # values that aliases repeat


def survey(text):
    """Raises yaml.YAMLError for an alias within its own anchor, too many levels, too many repeated values."""
    def refuse(event, what):
        raise yaml.YAMLError(f"line {event.start_mark.line + 1}: {what}")

    def demand_depth(event, levels):
        if levels > DEEPEST:
            refuse(event, f"out of range: more than {DEEPEST} nested levels of lists and maps; expected at most {DEEPEST}")

    extents, opened, repeated = {}, [], 0  # by anchor: [values, levels]; a level: [anchor, values, levels]
    for event in yaml.parse(text, Loader=yaml.SafeLoader):
        if isinstance(event, yaml.AliasEvent):
            if any(level[0] == event.anchor for level in opened):
                refuse(event, "invalid alias within its own anchor; expected an alias after the end of its anchor")
            values, levels = extents.get(event.anchor, (0, 0))
            repeated += values
            if repeated > MOST_REPEATED:
                refuse(event, f"out of range: aliases repeat more than {MOST_REPEATED} values up to this line; expected at most {MOST_REPEATED}")
            demand_depth(event, len(opened) + levels)
        elif isinstance(event, yaml.ScalarEvent):
            values, levels = 1, 0
            if event.anchor:
                extents[event.anchor] = (values, levels)
        elif isinstance(event, yaml.CollectionStartEvent):
            opened.append([event.anchor, 1, 1])
            demand_depth(event, len(opened))
            continue
        elif isinstance(event, yaml.CollectionEndEvent):
            anchor, values, levels = opened.pop()
            if anchor:
                extents[anchor] = (values, levels)
        else:
            continue
        if opened:
            opened[-1][1] += values
            opened[-1][2] = max(opened[-1][2], levels + 1)


def load(text):
    """The document of a text; yaml.YAMLError where it is none, or one without bounds."""
    survey(text)
    return yaml.safe_load(text)
