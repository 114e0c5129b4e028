# SPDX-License-Identifier: Apache-2.0
"""Meshes of one hexahedron, right and wrong, written byte by byte: the writers under test are nobody's library."""
import struct

CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
RIGHT = [1, 2, 3, 4, 5, 6, 7, 8]
INVERTED = [5, 6, 7, 8, 1, 2, 3, 4]


def gmsh(nodes=CUBE, elements=(RIGHT,), name="bar"):
    """Gmsh 2.2 ASCII (Gmsh reference manual, section 'MSH file format version 2')."""
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "1", f'3 1 "{name}"', "$EndPhysicalNames"]
    lines += ["$Nodes", str(len(nodes))] + [f"{i} {x} {y} {z}" for i, (x, y, z) in enumerate(nodes, 1)] + ["$EndNodes"]
    lines += ["$Elements", str(len(elements))]
    lines += [f"{i} 5 2 1 1 " + " ".join(map(str, e)) for i, e in enumerate(elements, 1)] + ["$EndElements", ""]
    return "\n".join(lines).encode()


def _name(text):
    data = text.encode()
    return struct.pack(">i", len(data)) + data + b"\0" * (-len(data) % 4)


def _attribute(name, value):
    if isinstance(value, str):
        kind, count, data = 2, len(value), value.encode()
    elif isinstance(value, int):
        kind, count, data = 4, 1, struct.pack(">i", value)
    else:
        kind, count, data = 5, 1, struct.pack(">f", value)
    return _name(name) + struct.pack(">ii", kind, count) + data + b"\0" * (-len(data) % 4)


def _attributes(pairs):
    if not pairs:
        return struct.pack(">ii", 0, 0)
    return struct.pack(">ii", 0x0C, len(pairs)) + b"".join(_attribute(n, v) for n, v in pairs)


def exodus(nodes=CUBE, elements=(RIGHT,), block_id=1, empty=0):
    """Exodus II in classic netCDF (NetCDF classic format specification, CDF-1; SAND92-2137 for the names). empty: blocks without elements
    before that of the elements; like the libraries it writes neither sizes nor connectivity for them."""
    last = empty + 1
    dimensions = [("len_string", 33), ("len_line", 81), ("four", 4), ("time_step", 0), ("num_dim", 3),
                  ("num_nodes", len(nodes)), ("num_elem", len(elements)), ("num_el_blk", last),
                  (f"num_el_in_blk{last}", len(elements)), (f"num_nod_per_el{last}", 8)]
    number = {name: i for i, (name, _) in enumerate(dimensions)}
    flat = [i for element in elements for i in element]
    variables = [("eb_status", ["num_el_blk"], [], "i", [0] * empty + [1]),
                 ("eb_prop1", ["num_el_blk"], [("name", "ID")], "i", [block_id + k for k in range(last)])]
    variables += [("coord" + axis, ["num_nodes"], [], "d", [p[k] for p in nodes]) for k, axis in enumerate("xyz")]
    variables += [(f"connect{last}", [f"num_el_in_blk{last}", f"num_nod_per_el{last}"], [("elem_type", "HEX8")], "i", flat)]

    head = b"CDF\x01" + struct.pack(">iii", 0, 0x0A, len(dimensions))
    head += b"".join(_name(name) + struct.pack(">i", size) for name, size in dimensions)
    head += _attributes([("api_version", 6.02), ("version", 6.02), ("floating_point_word_size", 8), ("file_size", 1),
                         ("title", "one cube")])
    head += struct.pack(">ii", 0x0B, len(variables))
    entries, bodies = [], []
    for name, shape, attributes, kind, values in variables:
        body = struct.pack(f">{len(values)}{kind}", *values)
        bodies.append(body + b"\0" * (-len(body) % 4))
        entries.append(_name(name) + struct.pack(f">i{len(shape)}i", len(shape), *(number[d] for d in shape))
                       + _attributes(attributes) + struct.pack(">ii", 4 if kind == "i" else 6, len(bodies[-1])))
    offset = len(head) + sum(len(e) + 4 for e in entries)
    for entry, body in zip(entries, bodies):
        head += entry + struct.pack(">i", offset)
        offset += len(body)
    return head + b"".join(bodies)
