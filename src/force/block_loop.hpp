// SPDX-License-Identifier: Apache-2.0
// The loop over the batches of a block, for any kernel. No allocation, no branch on options.
#pragma once
#include <algorithm>
#include <type_traits>

#include "element/batch.hpp"
#include "force/assembled.hpp"
#include "force/internal.hpp"
#include "kernels.hpp"
#include "living.hpp"
#include "model/model.hpp"

namespace brunt::force {

/// Of one block; null if not required.
struct WatchedBlock {
  const Pack* baseline = nullptr;
  Pack* linear = nullptr;
};

inline WatchedBlock watched_block(const StepWatch& watch, LocalIndex block) {
  const auto b = static_cast<std::size_t>(block);
  WatchedBlock watched;
  if (b < watch.baseline.size()) watched.baseline = reinterpret_cast<const Pack*>(watch.baseline[b].data());
  if (b < watch.linear.size()) watched.linear = reinterpret_cast<Pack*>(watch.linear[b].data());
  return watched;
}

template <int nodes>
BRUNT_INLINE void keep_linear(const element::BatchForce<nodes>& out, Pack* linear) {
  const element::BatchStiffness& now = out.stiffness;
  linear[at_lambda] = pack_max(now.lambda, broadcast(0.0));
  linear[at_mu] = now.mu;
  linear[at_viscosity] = now.viscosity;
  linear[at_spring] = now.spring;
  linear[at_dashpot] = now.dashpot;
  linear[at_plane2] = now.plane2;
  linear[at_rate] = out.rate;
}

/// Collapsed elements in a block that deletes them have no rate (see keep_bounds) and are ignored.
template <int nodes>
BRUNT_INLINE void see_growth(const element::BatchForce<nodes>& out, const Pack* baseline, int lanes,
                             std::uint8_t living, double& largest) {
  const Pack growth = pack_max(out.rate * out.rate * baseline[0], out.stiffness.plane2 * baseline[1]);
  if (!any(growth > largest)) return;
  for (int lane = 0; lane < lanes; ++lane)
    if (lives(living, lane) && out.rate[lane] > 0) largest = std::max(largest, growth[lane]);
}

/// Corner values of a batch: one cache line for each node in, components out.
template <int nodes>
BRUNT_INLINE void gather_motion(const LocalIndex* node, const model::NodeLine* lines,
                                element::BatchMotion<nodes>& motion) {
  for (int c = 0; c < nodes; ++c) {
    const LocalIndex* corner = node + c * pack_width;
    const auto position = [&](int lane) { return *reinterpret_cast<const Quad*>(lines[corner[lane]].x); };
    const auto velocity = [&](int lane) { return *reinterpret_cast<const Quad*>(lines[corner[lane]].v); };
    components_of(position, motion.x[0][c], motion.x[1][c], motion.x[2][c]);
    components_of(velocity, motion.v[0][c], motion.v[1][c], motion.v[2][c]);
  }
}

template <int nodes>
BRUNT_INLINE void gather_reference(const LocalIndex* node, const Quad* reference, element::BatchMotion<nodes>& motion) {
  for (int c = 0; c < nodes; ++c) {
    const LocalIndex* corner = node + c * pack_width;
    components_of([&](int lane) { return reference[corner[lane]]; }, motion.X[0][c], motion.X[1][c], motion.X[2][c]);
  }
}

/// Adds corner forces to the nodes, element by element in canonical order; stores those of border nodes separately.
/// Removed elements have none.
template <int nodes>
BRUNT_INLINE void scatter_forces(const LocalIndex* node, int lanes, std::uint8_t living, const Pack (&f)[3][nodes],
                                 std::span<const model::BorderCorner> border, Quad* force, Quad* slots) {
  Pack pair[nodes][4];
  const auto quad = [&](int c, int lane) -> const Quad& {
    return reinterpret_cast<const Quad*>(&pair[c][lane % 4])[lane / 4];
  };
  for (int c = 0; c < nodes; ++c) quads_of(f[0][c], f[1][c], f[2][c], pair[c]);
  if (lanes == pack_width && living == every_lane) {
    for (int lane = 0; lane < pack_width; ++lane)
      for (int c = 0; c < nodes; ++c) force[node[c * pack_width + lane]] += quad(c, lane);
  } else {
    for (int lane = 0; lane < lanes; ++lane)
      for (int c = 0; c < nodes && lives(living, lane); ++c) force[node[c * pack_width + lane]] += quad(c, lane);
  }
  for (const model::BorderCorner& kept : border)
    slots[kept.slot] = lives(living, kept.lane) ? quad(kept.corner, kept.lane) : Quad{};
}

/// A batch of removed elements only: clears all stored data of their forces.
template <int nodes>
void leave_out(std::span<const model::BorderCorner> border, Quad* slots, const KeptForces& kept, LocalIndex batch) {
  for (const model::BorderCorner& corner : border) slots[corner.slot] = Quad{};
  if (kept.force == nullptr) return;
  std::fill_n(kept.force + std::ptrdiff_t{batch} * 3 * nodes, 3 * nodes, broadcast(0.0));
  kept.power[batch] = broadcast(0.0);
}

/// The element with the largest rate; rare. Lanes of padding are ignored: their histories are neither saved nor
/// restored.
BRUNT_INLINE void note_rate(Pack rate, std::uint8_t living, int lanes, LocalIndex block, LocalIndex batch,
                            ElementReport& report, Pack& largest) {
  if (!any(rate > largest)) return;
  for (int lane = 0; lane < lanes; ++lane)
    if (lives(living, lane) && rate[lane] > report.rate) {
      report.rate = rate[lane];
      report.block = block;
      report.element = batch * pack_width + lane;
    }
  largest = broadcast(report.rate);
}

template <class Kernel>
void run_block(const Kernel& kernel, const model::ElementBlock& block, LocalIndex block_index, const BlockPass& pass) {
  constexpr int nodes = Kernel::nodes;
  const auto& [model, moved, committed, trial, scratch, report] = pass;
  element::BatchMotion<nodes> motion;
  motion.dt = moved.dt;
  element::BatchForce<nodes> out;
  const auto* before = reinterpret_cast<const Pack*>(nth(committed, block_index).data());
  auto* after = reinterpret_cast<Pack*>(nth(trial, block_index).data());
  Quad* slots = reinterpret_cast<Quad*>(scratch.slots.data());
  const std::span<const std::uint8_t> of_block = lanes_of(moved.living, block_index);
  const KeptForces kept = kept_forces(scratch, block_index);
  const Collapse collapse = Collapse::of(block);
  const WatchedBlock watched = watched_block(moved.watch, block_index);
  RepeatedLane<nodes, Kernel::history_size> repeated;
  Pack largest = broadcast(report.rate);
  for (LocalIndex batch = 0; batch < block.batches(); ++batch) {
    const LocalIndex* node = block.node.data() + static_cast<std::ptrdiff_t>(batch) * nodes * pack_width;
    const LocalIndex* seen = node;
    const std::ptrdiff_t memory = static_cast<std::ptrdiff_t>(batch) * Kernel::history_size;
    const Pack* remembered = before + memory;
    const std::uint8_t living = living_lanes(of_block, batch);
    if (living == 0) {
      leave_out<nodes>(block.border.row(batch), slots, kept, batch);
      continue;
    }
    if (living != every_lane) {
      repeated.put(node, living, remembered);
      seen = repeated.node.data();
      remembered = repeated.memory.data();
    }
    gather_motion<nodes>(seen, moved.nodes.data(), motion);
    if constexpr (std::decay_t<decltype(kernel.law)>::hyperelastic)
      gather_reference<nodes>(seen, model.reference.data(), motion);
    kernel(motion, remembered, after + memory, out);
    if (kept.bounds != nullptr)
      keep_bounds<nodes>(collapse, kernel.law.density, batch, Kernel::history_size, kept, after + memory, out);
    if (living != every_lane) repeated.take_off(living, after + memory);
    if (kept.force != nullptr) keep_forces<nodes>(out.f, motion.v, living, batch, kept);
    const int lanes = std::min(pack_width, block.count - batch * pack_width);
    scatter_forces<nodes>(node, lanes, living, out.f, block.border.row(batch), scratch.force.data(), slots);
    if (watched.linear != nullptr) keep_linear<nodes>(out, watched.linear + std::ptrdiff_t{batch} * linear_entries);
    if (watched.baseline != nullptr)
      see_growth<nodes>(out, watched.baseline + std::ptrdiff_t{batch} * 2, lanes, living, report.growth);

    note_rate(out.rate, living, lanes, block_index, batch, report, largest);
    if (any(~(out.volume > 0.0)) && report.inverted_block < 0) {
      for (int lane = pack_width - 1; lane >= 0; --lane)  // padding repeats the last element
        if (lives(living, lane) && !(out.volume[lane] > 0.0))
          report.inverted_element = std::min(batch * pack_width + lane, block.count - 1);
      report.inverted_block = block_index;
    }
  }
}

/// Choice::with_kernel(block, viscous, use) calls use(kernel) with the kernel of the block, without viscosity on
/// request.
template <class Choice>
constexpr Kernels kernels_of() {
  return {[](const model::ElementBlock& block) {
            return Choice::with_kernel(block, true, [](const auto& kernel) { return kernel.history(); });
          },
          [](const model::ElementBlock& block, LocalIndex block_index, const BlockPass& pass) {
            Choice::with_kernel(block, pass.motion.viscous,
                                [&](const auto& kernel) { run_block(kernel, block, block_index, pass); });
          }};
}

}  // namespace brunt::force
