// SPDX-License-Identifier: Apache-2.0
// What the force room asks of the kernels of one kind of element. A source a kind: with every law they are the longest
// to compile, and so they compile side by side.
#pragma once
#include <vector>

#include "brunt/force/internal.hpp"

namespace brunt::force {

/// Everything that a pass over a block reads and changes.
struct BlockPass {
  const model::Model& model;
  model::State& state;
  model::Scratch& scratch;
  ElementReport& report;
};

std::vector<element::HistoryField> hex8_history(const model::ElementBlock& block);
std::vector<element::HistoryField> hex8_full_history(const model::ElementBlock& block);  ///< hex8_bbar too
std::vector<element::HistoryField> tet4_history(const model::ElementBlock& block);

void hex8_forces(const model::ElementBlock& block, LocalIndex block_index, const BlockPass& pass);
void hex8_full_forces(const model::ElementBlock& block, LocalIndex block_index, const BlockPass& pass);
void tet4_forces(const model::ElementBlock& block, LocalIndex block_index, const BlockPass& pass);

}  // namespace brunt::force
