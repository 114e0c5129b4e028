// SPDX-License-Identifier: Apache-2.0
// Interface of the kernels of one element type. Each type has its own source: with all material laws these take longest
// to compile, and can be compiled in parallel.
#pragma once
#include <vector>

#include "force/internal.hpp"
#include "force/trial.hpp"

namespace brunt::force {

/// All data that a pass over a block reads and changes.
struct BlockPass {
  const model::Model& model;
  const Motion& motion;
  const History& committed;
  History& trial;  ///< may be `committed` itself
  model::Scratch& scratch;
  ElementReport& report;
};

/// The kernels of one element type with every law; called once for each block.
struct Kernels {
  std::vector<element::HistoryField> (*history)(const model::ElementBlock& block);
  void (*forces)(const model::ElementBlock& block, LocalIndex block_index, const BlockPass& pass);
};

extern const Kernels hex8_kernels;
extern const Kernels hex8_full_kernels;
extern const Kernels hex8_bbar_kernels;
extern const Kernels tet4_kernels;
extern const Kernels shell4_kernels;
extern const Kernels shell4_full_kernels;
extern const Kernels shell3_kernels;

}  // namespace brunt::force
