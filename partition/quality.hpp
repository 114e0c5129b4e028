// SPDX-License-Identifier: Apache-2.0
// Quality of a partition: balance of the work, and communication between the ranks.
#pragma once
#include <span>

#include "core/ragged.hpp"
#include "mesh/mesh.hpp"
#include "partition/split.hpp"

namespace brunt::partition {

struct Quality {
  int parts = 1;
  int empty_parts = 0;
  GlobalIndex elements = 0;
  GlobalIndex contact_faces = 0;
  double element_imbalance = 1.0;  ///< largest cost of a part over the mean; 1 is perfect
  double contact_imbalance = 1.0;  ///< the same of contact faces; 1 where there are none
  GlobalIndex edge_cut = 0;        ///< element faces between two parts
  GlobalIndex shared_nodes = 0;    ///< nodes in two parts or more
  GlobalIndex corner_forces = 0;   ///< sent in each step: of an element at a shared node, to each other holder
  int neighbours_max = 0;          ///< parts that share a node with one part
  double neighbours_mean = 0.0;
};

Quality quality(const mesh::Mesh& mesh, const Ragged<LocalIndex>& graph, const Weights& weights,
                std::span<const Rank> part, int parts);

}  // namespace brunt::partition
