// SPDX-License-Identifier: Apache-2.0
// The XDMF description of a mesh's cells.
#pragma once
#include <string>

#include "io/results/state_file.hpp"

namespace brunt::io {

/// Collective: shapes and counts of all blocks.
std::string state_topology(const comm::Communicator& ranks, const StateMesh& mesh);

}  // namespace brunt::io
