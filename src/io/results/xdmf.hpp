// SPDX-License-Identifier: Apache-2.0
// The XDMF 3 text that lets ParaView read state.h5 (https://www.xdmf.org/index.php/XDMF_Model_and_Format).
#pragma once
#include <span>
#include <string>

#include "io/results/state_file.hpp"

namespace brunt::io {

struct XdmfCells {
  bool mixed = false;                     ///< a stream of XDMF Mixed cells, else one shape
  mesh::Shape shape = mesh::Shape::hex8;  ///< where not mixed
  GlobalIndex stream_length = 0;          ///< integers in the stream, where mixed
};

/// <Topology>: connectivity as in io/results/state_file.hpp.
[[nodiscard]] std::string xdmf_topology(const XdmfCells& cells, GlobalIndex elements);

/// The whole file: a temporal collection, each time with the one mesh of state.h5 and its fields.
[[nodiscard]] std::string xdmf_text(const std::string& topology, GlobalIndex nodes, GlobalIndex elements,
                                    std::span<const StateRecord> records);

}  // namespace brunt::io
