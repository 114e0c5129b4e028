# SPDX-License-Identifier: Apache-2.0
"""What the scripts read of state.h5: records, parts, fields. Layout: src/io/README.md."""
import os

import h5py
import numpy as np

from arguments import Fault, excerpt

COMPONENTS = {3: ["x", "y", "z"], 6: ["xx", "yy", "zz", "xy", "yz", "zx"]}
QUANTITIES = {"displacement": "length", "gap": "length", "velocity": "velocity", "stress": "stress",
              "contact_pressure": "stress", "stress_bottom": "stress", "stress_top": "stress", "thickness": "length"}


class State:
    """An open state.h5."""

    def __init__(self, result):
        self.path = os.path.join(result, "state.h5") if os.path.isdir(result) else result
        if not os.path.isfile(self.path):
            raise Fault(f"{self.path}: cannot read the file: it does not exist; expected a result folder, or its state.h5")
        try:
            self.file = h5py.File(self.path, "r")
        except OSError as error:
            raise Fault(f"{self.path}: cannot read the state file ({error}); expected a state.h5 of brunt run") from error
        self.records = self.complete_records()

    def complete_records(self):
        """In order of time."""
        found = [group for name, group in self.file.items() if name.startswith("record_") and "time" in group.attrs]
        return sorted(found, key=lambda record: record.attrs["step"])

    def demand_mesh(self):
        if "mesh/coordinates" not in self.file:
            raise Fault(f"{self.path}: missing mesh; expected a result folder, or its state.h5")

    def record_at(self, time):
        if not self.records:
            raise Fault("missing record; expected a state.h5 with at least one complete record")
        if time is None:
            return self.records[-1]
        first, last = self.records[0].attrs["time"], self.records[-1].attrs["time"]
        slack = 0.01 * (last - first)  # a record stands at the first step at or past its time
        if not first - slack <= time <= last + slack:
            raise Fault(f"out of range: --time {time:g}; expected a time from {first:g} to {last:g}")
        return min(self.records, key=lambda record: abs(record.attrs["time"] - time))

    def unit_of(self, quantity):
        """As the run has named it; empty with `units: none`, and in files of before."""
        return text_of(self.file.attrs.get(f"unit_{quantity}", ""))

    def unit_of_field(self, name):
        return self.unit_of(QUANTITIES.get(name.partition(".")[0], "none"))

    def blocks(self):
        """(part, index of the first element, connectivity, shape) of each block."""
        stored = self.file["mesh/connectivity"][...]
        blocks, offset = [], 0
        for b in range(int(self.file.attrs["blocks"])):
            attributes = self.file[f"mesh/block_{b}"].attrs
            first, count, width = (int(attributes[name]) for name in ("first", "count", "nodes_per_element"))
            part = text_of(attributes.get("part", attributes.get("name", b)))  # files of before name blocks alone
            shape = text_of(attributes.get("shape", "hex8" if width == 8 else "tet4"))  # and have solids alone
            if stored.ndim == 2:
                blocks.append((part, first, stored[first:first + count], shape))
            else:  # a stream of cells, each led by its type
                cells = stored[offset:offset + count * (width + 1)].reshape(count, width + 1)
                blocks.append((part, first, cells[:, 1:], shape))
                offset += count * (width + 1)
        return blocks

    def parts(self):
        return [part for part, _, _, _ in self.blocks()]

    def alive(self, record):
        """Of each element: not taken away by the run."""
        if "element/alive" in record:
            return record["element/alive"][...] != 0
        return np.ones(int(self.file.attrs["elements"]), dtype=bool)

    def positions(self, record, factor=1.0):
        """Of the nodes, with the displacement times a factor [length]."""
        points = self.file["mesh/coordinates"][...]
        moved = factor != 0 and "node/displacement" in record
        return points + factor * record["node/displacement"][...] if moved else points

    def fields(self, record):
        """(field, number of its components) in alphabetical order."""
        return sorted((name, table.shape[1] if table.ndim > 1 else 1) for place in ("node", "element") if place in record
                      for name, table in record[place].items())


def text_of(value):
    return value.decode(errors="replace") if isinstance(value, bytes) else str(value)


def field_values(record, name):
    """The field as one number an entity, whether it is nodal, and a title. name: field, field.component, field.magnitude."""
    base, _, component = name.partition(".")
    for place in ("node", "element"):
        if place not in record or base not in record[place]:
            continue
        values = record[place][base][...]
        if values.ndim == 1 and component:
            raise Fault(f"unknown component {excerpt(component)} of the scalar field {base}; expected {base}")
        if values.ndim == 1:
            return values, place == "node", base
        names = COMPONENTS.get(values.shape[1], [str(c) for c in range(values.shape[1])])
        if component in names:
            return values[:, names.index(component)], place == "node", name
        if values.shape[1] == 6 and component in ("", "mises"):
            return von_mises(values), place == "node", f"{base} (von Mises)"
        if component in ("", "magnitude"):
            return np.linalg.norm(values, axis=1), place == "node", f"{base} (magnitude)"
        raise Fault(f"unknown component {excerpt(component)} of {base}; expected one of {', '.join(names)}, magnitude")
    known = sorted(f"{n}" for place in ("node", "element") if place in record for n in record[place])
    raise Fault(f"unknown field {excerpt(base)}; expected one of {', '.join(known)}, part (output.fields of the scene lists the fields that are written)")


def von_mises(s):
    normal = (s[:, 0] - s[:, 1])**2 + (s[:, 1] - s[:, 2])**2 + (s[:, 2] - s[:, 0])**2
    return np.sqrt(0.5 * normal + 3 * (s[:, 3]**2 + s[:, 4]**2 + s[:, 5]**2))
