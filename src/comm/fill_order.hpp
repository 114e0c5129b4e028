// SPDX-License-Identifier: Apache-2.0
// The elimination order of the unknowns that reduces fill-in: nested dissection by METIS.
#pragma once
#include <span>
#include <vector>

#include "row_range.hpp"

namespace brunt::comm {

/// Position of each unknown in the elimination order, from the pattern of a whole square matrix only (made symmetric).
/// begin: rows + 1 offsets into `column`. Throws MachineError if METIS fails.
std::vector<SolverIndex> elimination_order(std::span<const SolverIndex> begin, std::span<const SolverIndex> column);

}  // namespace brunt::comm
