// SPDX-License-Identifier: Apache-2.0
// Which rank computes which element: METIS k-way partition of the dual graph with two things balanced at once, the
// cost of the elements and the number of contact faces (G. Karypis, V. Kumar, Multilevel algorithms for
// multi-constraint graph partitioning, SC 1998). The same mesh and number of parts give the same split.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "brunt/core/ragged.hpp"
#include "brunt/core/types.hpp"
#include "brunt/mesh/mesh.hpp"

namespace brunt::partition {

/// What each element brings to its rank, over all blocks in order.
struct Weights {
  std::vector<double> cost;                 ///< of computing it, relative to the others, > 0
  std::vector<std::int32_t> contact_faces;  ///< number of its faces that bring contact its work
};

/// contact_sides: faces that bring contact its work; none: the cost alone is balanced. block_cost: cost of one element
/// of each block; where empty, a hex8 counts 1 and a tet4 one half.
Weights weigh(const mesh::Mesh& mesh, std::span<const mesh::Side> contact_sides,
              std::span<const double> block_cost = {});

/// Part of each element. No part is empty where there are at least as many elements as parts; with fewer elements the
/// last parts are. `parts` >= 1.
std::vector<Rank> split(const Ragged<LocalIndex>& graph, const Weights& weights, int parts);

/// The same with the usual weights, from the mesh alone.
std::vector<Rank> split(const mesh::Mesh& mesh, int parts);

}  // namespace brunt::partition
