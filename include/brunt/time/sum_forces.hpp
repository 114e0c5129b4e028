// SPDX-License-Identifier: Apache-2.0
// From the forces of elements and loads to the forces on nodes, over the ranks.
#pragma once
#include "brunt/model/model.hpp"
#include "brunt/time/links.hpp"

namespace brunt::time {

/// After force::trial_forces or force::internal_forces: scratch.force of border nodes summed in canonical order, and
/// scratch.load: gravity, pressure and dead loads at State::time on the positions of State::nodes, where the scene has
/// any. Every copy of a node ends with the same bits. Collective.
void sum_forces(const model::Model& model, const model::State& state, model::Scratch& scratch, Links& links);

}  // namespace brunt::time
