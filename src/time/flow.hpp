// SPDX-License-Identifier: Apache-2.0
// Plastic flow around the nodes of the surface, for contact with Impact::elastic.
#pragma once
#include <span>
#include <vector>

#include "comm/ordered_sum.hpp"
#include "model/model.hpp"

namespace brunt::time {

/// Elements with plastic flow around the surface.
struct SurfaceFlow {
  struct Element {
    LocalIndex block = 0, element = 0;
  };
  std::vector<Element> elements;     ///< of this rank, in canonical order
  std::vector<LocalIndex> targets;   ///< their corners: a local node, or -1 - slot of a border corner
  std::vector<double> slots;         ///< of border corners, zero of other elements
  std::vector<double> of_node{0.0};  ///< sums of the plastic strains of the elements around each node, and one more
  bool planned = false;
};

/// Whether the model has a material that flows: the same on all ranks.
bool has_flow(const model::Model& model);

/// Sums at t_n, complete at the nodes `surface` (local nodes of the mesh). The same bits on any number of ranks. After
/// a removal of elements `flow.planned` must be reset. Collective.
void sum_flow(const model::Model& model, const model::State& state, std::span<const LocalIndex> surface,
              comm::OrderedSum& corner_sum, SurfaceFlow& flow);

}  // namespace brunt::time
