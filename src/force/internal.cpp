// SPDX-License-Identifier: Apache-2.0
#include "brunt/force/internal.hpp"

#include <algorithm>

#include "kernels.hpp"

namespace brunt::force {

std::vector<element::HistoryField> history_fields(const model::ElementBlock& block) {
  switch (block.kind) {
    case element::ElementKind::hex8:
      return hex8_history(block);
    case element::ElementKind::hex8_full:
    case element::ElementKind::hex8_bbar:
      return hex8_full_history(block);
    case element::ElementKind::tet4:
      return tet4_history(block);
  }
  return {};
}

ElementReport internal_forces(const model::Model& model, model::State& state, model::Scratch& scratch) {
  std::fill(scratch.force.begin(), scratch.force.end(), Quad{});
  ElementReport report;
  const BlockPass pass{model, state, scratch, report};
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    const auto index = static_cast<LocalIndex>(b);
    if (block.count == 0) continue;
    switch (block.kind) {
      case element::ElementKind::hex8:
        hex8_forces(block, index, pass);
        break;
      case element::ElementKind::hex8_full:
      case element::ElementKind::hex8_bbar:
        hex8_full_forces(block, index, pass);
        break;
      case element::ElementKind::tet4:
        tet4_forces(block, index, pass);
        break;
    }
  }
  return report;
}

}  // namespace brunt::force
