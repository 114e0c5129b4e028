// SPDX-License-Identifier: Apache-2.0
// Check that the elements of a placed body are large enough relative to their coordinates.
#pragma once
#include <string>

#include "mesh/mesh.hpp"

namespace brunt::mesh {

/// A coordinate X is rounded to |X| 2^-53, so an edge of length h has a relative error of |X| 2^-52 / h. For |X| up to
/// 2^34 h this is 2^-18 = 4e-6. The finest distinction in shares of an edge is an initial overlap, 1e-4 of it, which is
/// 25 times as large. Beyond this limit elements are distorted by their position, and they vanish from 2^52 on.
constexpr double largest_to_smallest = 0x1p34;

/// Volumes are products of three edges, and Jacobian determinants are compared with them. Edges from 2^-300 to 2^300
/// keep both within the range of a double (2^-1022 to 2^1023) with a margin of 2^100.
constexpr double smallest_edge = 0x1p-300, largest_edge = 0x1p300;

/// A message about the edges of the mesh in its present position; empty if they are valid. `farthest`: the largest
/// coordinate that the nodes had during placement (0: only the present ones).
std::string resolution_fault(const Mesh& mesh, double farthest);

}  // namespace brunt::mesh
