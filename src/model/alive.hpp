// SPDX-License-Identifier: Apache-2.0
// Elements that have not been removed. Blocks that never lose an element have no flags.
#pragma once
#include "model/model.hpp"

namespace brunt::model {

[[nodiscard]] inline bool lives(const State& state, std::size_t block, LocalIndex element) {
  return block >= state.alive.size() || state.alive[block].empty() || nth(state.alive[block], element) > 0;
}

/// Whether the element of a face of this rank has not been removed.
[[nodiscard]] bool lives(const Model& model, const State& state, const mesh::ExteriorFace& face);

/// The data that depend on the flags.
[[nodiscard]] Living follow(const Model& model, const State& state);

}  // namespace brunt::model
