// SPDX-License-Identifier: Apache-2.0
// Which elements are still there. Blocks that never lose one have no flags.
#pragma once
#include "brunt/model/model.hpp"

namespace brunt::model {

[[nodiscard]] inline bool lives(const State& state, std::size_t block, LocalIndex element) {
  return block >= state.alive.size() || state.alive[block].empty() ||
         state.alive[block][static_cast<std::size_t>(element)] > 0;
}

/// Does the element of a face of this rank live?
[[nodiscard]] bool lives(const Model& model, const State& state, const mesh::ExteriorFace& face);

/// What follows from the flags.
[[nodiscard]] Living follow(const Model& model, const State& state);

}  // namespace brunt::model
