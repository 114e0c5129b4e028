// SPDX-License-Identifier: Apache-2.0
// Assignment of elements to ranks: METIS k-way partition of the dual graph with two balance constraints, the cost of
// the elements and the number of contact faces (G. Karypis, V. Kumar, Multilevel algorithms for multi-constraint graph
// partitioning, SC 1998). The same mesh and number of parts give the same partition.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/ragged.hpp"
#include "core/types.hpp"
#include "mesh/mesh.hpp"

namespace brunt::partition {

/// Work of each element, over all blocks in order.
struct Weights {
  std::vector<double> cost;                 ///< of computing it, relative to the others, > 0
  std::vector<std::int32_t> contact_faces;  ///< number of its faces with work for contact
};

/// contact_sides: faces with work for contact; if empty, only the cost is balanced. block_cost: cost of one element of
/// each block; if empty, a hex8 counts 1 and a tet4 one half.
Weights weigh(const mesh::Mesh& mesh, std::span<const mesh::Side> contact_sides,
              std::span<const double> block_cost = {});

/// Part of each element. No part is empty if there are at least as many elements as parts; with fewer elements the last
/// parts are empty. `parts` >= 1.
std::vector<Rank> split(const Ragged<LocalIndex>& graph, const Weights& weights, int parts);

/// The same with the standard weights, from the mesh only.
std::vector<Rank> split(const mesh::Mesh& mesh, int parts);

}  // namespace brunt::partition
