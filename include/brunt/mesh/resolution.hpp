// SPDX-License-Identifier: Apache-2.0
// Are the elements of a placed body large enough for the coordinates that they have?
#pragma once
#include <string>

#include "brunt/mesh/mesh.hpp"

namespace brunt::mesh {

/// A coordinate X is rounded to |X| 2^-53, so an edge of length h has a relative error of |X| 2^-52 / h. With |X| up to
/// 2^34 h this is 2^-18 = 4e-6: the finest that is told apart in shares of an edge is an initial overlap, 1e-4 of it,
/// which is 25 times as much. Beyond, elements are deformed by their place, and vanish from 2^52 on.
constexpr double largest_to_smallest = 0x1p34;

/// Volumes are products of three edges, and determinants of Jacobians are compared with them: edges from 2^-300 to
/// 2^300 keep both, with a factor of 2^100 to spare, within a double's range (2^-1022 to 2^1023).
constexpr double smallest_edge = 0x1p-300, largest_edge = 0x1p300;

/// What is wrong with the edges of the mesh as it stands; empty if nothing is. `farthest`: the largest coordinate that
/// the nodes passed through on the way to their places (0: none but theirs).
std::string resolution_fault(const Mesh& mesh, double farthest);

}  // namespace brunt::mesh
