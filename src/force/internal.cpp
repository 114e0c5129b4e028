// SPDX-License-Identifier: Apache-2.0
#include "force/internal.hpp"

#include <algorithm>

#include "force/trial.hpp"
#include "kernels.hpp"

namespace brunt::force {
namespace {

const Kernels& kernels_of(element::ElementKind kind) {
  switch (kind) {
    case element::ElementKind::hex8:
      return hex8_kernels;
    case element::ElementKind::hex8_full:
      return hex8_full_kernels;
    case element::ElementKind::hex8_bbar:
      return hex8_bbar_kernels;
    case element::ElementKind::shell4:
      return shell4_kernels;
    case element::ElementKind::shell4_full:
      return shell4_full_kernels;
    case element::ElementKind::shell3:
      return shell3_kernels;
    case element::ElementKind::tet4:
      break;
  }
  return tet4_kernels;
}

}  // namespace

std::vector<element::HistoryField> history_fields(const model::ElementBlock& block) {
  if (material::is_rigid(block.law)) return {{"mass", 1}};
  return kernels_of(block.kind).history(block);
}

ElementReport trial_forces(const model::Model& model, const Motion& motion, const History& committed, History& trial,
                           model::Scratch& scratch) {
  std::fill(scratch.force.begin(), scratch.force.end(), Quad{});
  std::fill(scratch.moment.begin(), scratch.moment.end(), Quad{});
  ElementReport report;
  const BlockPass pass{model, motion, committed, trial, scratch, report};
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    if (block.count > 0 && !material::is_rigid(block.law))
      kernels_of(block.kind).forces(block, static_cast<LocalIndex>(b), pass);
  }
  return report;
}

ElementReport internal_forces(const model::Model& model, model::State& state, model::Scratch& scratch,
                              const StepWatch& watch) {
  const Motion motion{
      .nodes = state.nodes, .dt = state.dt, .living = state.living.lanes, .watch = watch, .rotations = state.rotations};
  return trial_forces(model, motion, state.history, state.history, scratch);
}

void commit(const History& trial, History& committed) {
  for (std::size_t b = 0; b < trial.size(); ++b) std::ranges::copy(trial[b], committed[b].begin());
}

}  // namespace brunt::force
