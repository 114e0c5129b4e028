// SPDX-License-Identifier: Apache-2.0
// The node with the largest vector of a field, for messages.
#pragma once
#include <span>

#include "implicit/solver.hpp"

namespace brunt::implicit {

struct LargestNode {
  double size = 0;       ///< of its vector; the same on all ranks
  GlobalIndex gid = -1;  ///< canonical number of the node
};

/// Of vectors in the order of the unknowns; of equal ones the node with the lowest number. Collective.
LargestNode largest_node(const Scene& scene, const Solver& solver, std::span<const double> values);

}  // namespace brunt::implicit
