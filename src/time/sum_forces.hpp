// SPDX-License-Identifier: Apache-2.0
// Nodal forces from the forces of elements and loads, over the ranks.
#pragma once
#include "model/model.hpp"
#include "time/links.hpp"

namespace brunt::time {

/// After force::trial_forces or force::internal_forces: sums scratch.force of border nodes in canonical order, and
/// fills scratch.load with gravity, pressure and dead loads at State::time on the positions of State::nodes, if the
/// scene has any. Every copy of a node has the same bits. Collective.
void sum_forces(const model::Model& model, const model::State& state, model::Scratch& scratch, Links& links);

}  // namespace brunt::time
