// SPDX-License-Identifier: Apache-2.0
// What the force room asks of the kernels of one kind of element. A source a kind: with every law they are the longest
// to compile, and so they compile side by side.
#pragma once
#include <vector>

#include "brunt/force/internal.hpp"
#include "brunt/force/trial.hpp"

namespace brunt::force {

/// Everything that a pass over a block reads and changes.
struct BlockPass {
  const model::Model& model;
  const Motion& motion;
  const History& committed;
  History& trial;  ///< may be `committed` itself
  model::Scratch& scratch;
  ElementReport& report;
};

/// The kernels of one kind of element with every law; called once a block.
struct Kernels {
  std::vector<element::HistoryField> (*history)(const model::ElementBlock& block);
  void (*forces)(const model::ElementBlock& block, LocalIndex block_index, const BlockPass& pass);
};

extern const Kernels hex8_kernels;
extern const Kernels hex8_full_kernels;
extern const Kernels hex8_bbar_kernels;
extern const Kernels tet4_kernels;

}  // namespace brunt::force
