// SPDX-License-Identifier: Apache-2.0
// Element matrices by forward differentiation of the kernel itself: one element in each call, one direction in each
// lane.
#pragma once
#include <vector>

#include "core/dual.hpp"
#include "core/error.hpp"
#include "element/batch.hpp"
#include "element/memory.hpp"
#include "force/tangent.hpp"

namespace brunt::force {

struct TangentPass {
  const model::Model& model;
  LocalIndex block_index;
  std::span<const LocalIndex> elements;
  const Motion& motion;
  const History& committed;
  std::span<double> matrices;
};

using Tangents = void (*)(const model::ElementBlock& block, const TangentPass& pass);
extern const Tangents hex8_full_tangents, hex8_bbar_tangents, tet4_tangents;

/// One element in all lanes; zero derivatives.
template <class Kernel>
void spread_element(const model::ElementBlock& block, LocalIndex element, const TangentPass& pass,
                    element::BatchMotion<Kernel::nodes, Dual>& motion, Pack* committed) {
  for (int c = 0; c < Kernel::nodes; ++c) {
    const auto node = static_cast<std::size_t>(block.corner_node(element, c));
    const model::NodeLine& line = pass.motion.nodes[node];
    for (int i = 0; i < 3; ++i) {
      motion.x[i][c] = line.x[i];
      motion.v[i][c] = line.v[i];
      motion.X[i][c] = broadcast(pass.model.reference[node][i]);
    }
  }
  const double* history = nth(pass.committed, pass.block_index).data() +
                          std::ptrdiff_t{element / pack_width} * Kernel::history_size * pack_width +
                          element % pack_width;
  for (int entry = 0; entry < Kernel::history_size; ++entry) committed[entry] = broadcast(history[entry * pack_width]);
}

/// Kernel calls of pack_width directions each. A change of a position changes the mean velocity by its share of the
/// step.
template <class Kernel>
void run_tangents(const Kernel& kernel, const model::ElementBlock& block, const TangentPass& pass) {
  constexpr int size = 3 * Kernel::nodes;
  element::BatchMotion<Kernel::nodes, Dual> motion;
  element::BatchForce<Kernel::nodes, Dual> out;
  motion.dt = pass.motion.dt;
  const double over_dt = 1 / motion.dt;
  Pack committed[Kernel::history_size];
  Dual trial[Kernel::history_size];
  double* matrix = pass.matrices.data();
  for (const LocalIndex element : pass.elements) {
    spread_element<Kernel>(block, element, pass, motion, committed);
    for (int first = 0; first < size; first += pack_width) {
      const int lanes = std::min(pack_width, size - first);
      const auto seed = [&](double x, double v) {
        for (int lane = 0; lane < lanes; ++lane) {
          const int c = (first + lane) / 3, i = (first + lane) % 3;
          motion.x[i][c].slope[lane] = x;
          motion.v[i][c].slope[lane] = v;
        }
      };
      seed(1, over_dt);
      kernel(motion, committed, trial, out);
      seed(0, 0);
      for (int row = 0; row < size; ++row)
        for (int lane = 0; lane < lanes; ++lane)
          matrix[row * size + first + lane] = -out.f[row % 3][row / 3].slope[lane];
    }
    matrix += size * size;
  }
}

template <class Choice>
constexpr Tangents tangents_of() {
  return [](const model::ElementBlock& block, const TangentPass& pass) {
    Choice::with_kernel(block, pass.motion.viscous, [&](const auto& kernel) {
      if constexpr (element::Thermodynamic<std::decay_t<decltype(kernel.law)>>)
        throw InputError("part " + block.part +
                         ": invalid material: its law has no tangent; expected elastic, j2 or neo_hookean");
      else
        run_tangents(kernel, block, pass);
    });
  };
}

}  // namespace brunt::force
