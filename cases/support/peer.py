# SPDX-License-Identifier: Apache-2.0
"""Displacements of a peer on the same mesh, and ours beside them."""
import os

import h5py
import numpy


def table(path):
    """Rows of a csv file by column, comments left out."""
    return numpy.genfromtxt(path, delimiter=",", names=True, comments="#", skip_header=1)


def node_histories(folder):
    """The peer's displacements by node: {node: (times, displacements [times][3])}."""
    rows = table(os.path.join(folder, "peer_nodes.csv"))
    histories = {}
    for node in numpy.unique(rows["node"]).astype(int):
        of_node = rows[rows["node"] == node]
        histories[int(node)] = of_node["time"], numpy.stack([of_node[axis] for axis in "xyz"], axis=1)
    return histories


def end_state(folder):
    """The peer's displacements of all nodes at its last time, [nodes][3]."""
    rows = table(os.path.join(folder, "peer_end.csv"))
    return numpy.stack([rows[axis] for axis in "xyz"], axis=1)


def our_state(result, time):
    """Reference coordinates and displacements of the record nearest to a time, carried to it with the velocity."""
    with h5py.File(os.path.join(result.folder, "state.h5"), "r") as file:
        records = [group for name, group in file.items() if name.startswith("record_") and "time" in group.attrs]
        record = min(records, key=lambda group: abs(group.attrs["time"] - time))
        past = record.attrs["time"] - time
        order = numpy.argsort(file["mesh/node_id"][...])
        displacement = record["node/displacement"][...] - past * record["node/velocity"][...]
        return file["mesh/coordinates"][...][order], displacement[order]


def our_histories(result, node, times):
    """Displacements of a probe called nNODE at some times, [times][3]."""
    columns = [result.history[f"n{node}.{axis}"] for axis in "xyz"]
    return numpy.stack([numpy.interp(times, result.history["time"], column) for column in columns], axis=1)


def rms(values):
    return float(numpy.sqrt((values**2).sum(axis=1).mean()))
