// SPDX-License-Identifier: Apache-2.0
// In which order unknowns are eliminated, so that factors stay small: nested dissection by METIS.
#pragma once
#include <span>
#include <vector>

#include "row_range.hpp"

namespace brunt::comm {

/// Position of each unknown in the order of elimination, from the pattern of a whole square matrix alone (made
/// symmetric). begin: rows + 1 offsets into `column`. Throws MachineError where METIS fails.
std::vector<SolverIndex> elimination_order(std::span<const SolverIndex> begin, std::span<const SolverIndex> column);

}  // namespace brunt::comm
