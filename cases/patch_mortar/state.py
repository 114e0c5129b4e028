# SPDX-License-Identifier: Apache-2.0
"""The last record of a result: nodes and elements of both blocks."""
import os

import h5py
import numpy


def nodes_of(file, block):
    """Corners of a block's elements; in a mesh of several kinds each element begins with the number of its kind (XDMF)."""
    stored = file["mesh/connectivity"][...]
    if stored.ndim == 2:
        return stored[file["mesh/element_block"][...].ravel() == block]
    counts = [file[f"mesh/block_{b}"].attrs["count"] * (file[f"mesh/block_{b}"].attrs["nodes_per_element"] + 1) for b in (0, 1)]
    begin = 0 if block == 0 else counts[0]
    return stored[begin:begin + counts[block]].reshape(-1, counts[block] // file[f"mesh/block_{block}"].attrs["count"])[:, 1:]


class Last:
    def __init__(self, result):
        with h5py.File(os.path.join(result.folder, "state.h5"), "r") as file:
            record = file[max(name for name in file if name.startswith("record_"))]
            self.start = file["mesh/coordinates"][...]
            corners = [nodes_of(file, block) for block in (0, 1)]
            self.block = file["mesh/element_block"][...].ravel()
            self.stress = record["element/stress"][...].reshape(-1, 6)
            nodal = {name: record["node"][name][...] for name in record["node"]}
        self.move = nodal["displacement"].reshape(-1, 3)
        self.pressure = nodal.get("contact_pressure", numpy.zeros(len(self.start))).ravel()
        self.gap = nodal.get("gap", numpy.zeros(len(self.start))).ravel()
        self.nodes = [numpy.unique(of_block) for of_block in corners]

    def turned_back(self, turn, shift):
        """Into the axes that the mesh had before it was turned and moved: coordinates, displacements, stresses."""
        self.start = (self.start - shift) @ turn
        self.move = self.move @ turn
        x, y, z, xy, yz, zx = self.stress.T
        full = numpy.array([[x, xy, zx], [xy, y, yz], [zx, yz, z]]).transpose(2, 0, 1)
        full = turn.T @ full @ turn
        self.stress = numpy.stack([full[:, 0, 0], full[:, 1, 1], full[:, 2, 2], full[:, 0, 1], full[:, 1, 2], full[:, 2, 0]], 1)
        return self

    def face(self, block, height):
        """Nodes of a block at this height at the start."""
        return self.nodes[block][abs(self.start[self.nodes[block], 2] - height) < 1e-6]
