// SPDX-License-Identifier: Apache-2.0
#include "brunt/force/internal.hpp"

#include <algorithm>

#include "block_loop.hpp"
#include "brunt/element/hex8.hpp"
#include "brunt/force/kernel_choice.hpp"

namespace brunt::force {

std::vector<element::HistoryField> history_fields(const model::ElementBlock& block) {
  return with_kernel(block, [](const auto& kernel) { return kernel.history(); });
}

ElementReport internal_forces(const model::Model& model, model::State& state, model::Scratch& scratch) {
  std::fill(scratch.force.begin(), scratch.force.end(), Quad{});
  ElementReport report;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    if (block.count == 0) continue;
    with_kernel(block, [&](const auto& kernel) {
      run_block(kernel, block, static_cast<LocalIndex>(b), model, state, scratch, report);
    });
  }
  return report;
}

}  // namespace brunt::force
