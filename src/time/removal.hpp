// SPDX-License-Identifier: Apache-2.0
// Removal of elements between `evaluate` and `advance`: their forces at t_n act a last time, afterwards they are
// ignored. The mass remains on the nodes.
#pragma once
#include <vector>

#include "comm/communicator.hpp"
#include "model/model.hpp"

namespace brunt::time {

/// Whether a removal of the scene is due in the step from t_n. The same on every rank.
bool removal_is_due(const model::Model& model, const model::State& state);

/// Updates the data that depend on the flags, after they have changed. Collective.
void follow_alive(const comm::Communicator& ranks, const model::Model& model, model::State& state);

/// Sets the flags of the elements that are removed at t_n and updates dependent data; returns the number of removed
/// elements of each block, on all ranks. Collective.
std::vector<GlobalIndex> remove_elements(const comm::Communicator& ranks, const model::Model& model,
                                         model::State& state);

/// Elements removed so far, on all ranks. Collective.
GlobalIndex removed_elements(const comm::Communicator& ranks, const model::State& state);

}  // namespace brunt::time
