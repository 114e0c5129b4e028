// SPDX-License-Identifier: Apache-2.0
// Batches with removed elements. A kernel computes all lanes of a batch together; the lanes of removed elements repeat
// a living one, as padding does, so that no data of a removed element (whose nodes may be anywhere) are used. The
// histories of removed elements remain unchanged.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/simd.hpp"
#include "element/batch.hpp"
#include "model/model.hpp"

namespace brunt::force {

constexpr std::uint8_t every_lane = 0xff;

/// A bit for each lane of the batch with a living element. `lanes`: of the block; empty if all live.
BRUNT_INLINE std::uint8_t living_lanes(std::span<const std::uint8_t> lanes, LocalIndex batch) {
  return lanes.empty() ? every_lane : nth(lanes, batch);
}

/// Those of a block.
inline std::span<const std::uint8_t> lanes_of(std::span<const std::vector<std::uint8_t>> lanes, LocalIndex block) {
  const auto b = static_cast<std::size_t>(block);
  return b < lanes.size() ? std::span(lanes[b]) : std::span<const std::uint8_t>{};
}

BRUNT_INLINE bool lives(std::uint8_t living, int lane) {
  return (living >> lane & 1) != 0;
}

template <int nodes, int history_size>
struct RepeatedLane {
  std::array<LocalIndex, static_cast<std::size_t>(nodes* pack_width)> node;  ///< as input of the kernel
  std::array<Pack, static_cast<std::size_t>(history_size)> memory, kept;     ///< likewise, and the original values
  int used = history_size;                                                   ///< entries of an element

  /// Replaces each removed element by a living one.
  void put(const LocalIndex* nodes_of_batch, std::uint8_t living, const Pack* committed) {
    const int shown = std::countr_zero(living);
    for (int c = 0; c < nodes; ++c)
      for (int lane = 0; lane < pack_width; ++lane)
        nth(node, c * pack_width + lane) = nodes_of_batch[c * pack_width + (lives(living, lane) ? lane : shown)];
    std::copy_n(committed, used, kept.begin());
    std::copy_n(committed, used, memory.begin());
    for (Pack& value : std::span(memory).first(static_cast<std::size_t>(used)))
      for (int lane = 0; lane < pack_width; ++lane)
        if (!lives(living, lane)) value[lane] = value[shown];
  }
  /// Restores the histories of removed elements.
  void take_off(std::uint8_t living, Pack* trial) const {
    for (int k = 0; k < used; ++k)
      for (int lane = 0; lane < pack_width; ++lane)
        if (!lives(living, lane)) trial[k][lane] = nth(kept, k)[lane];
  }
};

/// Storage for the forces of a block's elements (see Scratch::element_force); null if they are not stored.
struct KeptForces {
  Pack *force = nullptr, *power = nullptr;
  Pack* bounds = nullptr;  ///< rate and volume, of blocks that erode
};

inline KeptForces kept_forces(model::Scratch& scratch, LocalIndex block) {
  const auto b = static_cast<std::size_t>(block);
  if (b >= scratch.element_force.size() || scratch.element_force[b].empty()) return {};
  return {reinterpret_cast<Pack*>(scratch.element_force[b].data()),
          reinterpret_cast<Pack*>(scratch.element_power[b].data()),
          scratch.element_bounds[b].empty() ? nullptr : reinterpret_cast<Pack*>(scratch.element_bounds[b].data())};
}

/// Treatment of collapsed elements in a block with erosion.
struct Collapse {
  bool is_taken = false;    ///< they are deleted: none stops the run or bounds the step
  double largest_rate = 0;  ///< [1/time] elements with a larger rate have collapsed
  static Collapse of(const model::ElementBlock& block) {
    if (!block.erosion || !block.erosion->takes_collapsed()) return {};
    const double step = block.erosion->step.value_or(0);
    return {true, step > 0 ? 1 / step : std::numeric_limits<double>::infinity()};
  }
};

/// Stores rate and volume of a batch, the volume over that of the reference configuration. Lanes without volume have no
/// forces and lose their histories except the mass; they and those with too large a rate are excluded from the bounds
/// of the step.
template <int nodes>
BRUNT_INLINE void keep_bounds(const Collapse& collapse, double density, LocalIndex batch, int history_size,
                              const KeptForces& kept, Pack* history, element::BatchForce<nodes>& out) {
  const Pack mass = history[0];
  kept.bounds[2 * batch] = out.rate;
  kept.bounds[2 * batch + 1] = out.volume * density / mass;
  if (!collapse.is_taken) return;
  const PackMask folded = ~(out.volume > 0.0);
  const PackMask gone = folded | ~(out.rate <= collapse.largest_rate);
  if (!any(gone)) return;
  out.rate = select(gone, Pack{}, out.rate);
  if (!any(folded)) return;
  for (auto& component : out.f)
    for (Pack& force : component) force = select(folded, Pack{}, force);
  for (int entry = 1; entry < history_size; ++entry) history[entry] = select(folded, Pack{}, history[entry]);
  out.volume = select(folded, broadcast(1.0), out.volume);
}

/// Stores the forces of a batch, zero for removed elements, and their power with the velocities before the step.
template <int nodes>
BRUNT_INLINE void keep_forces(const Pack (&f)[3][nodes], const Pack (&v)[3][nodes], std::uint8_t living,
                              LocalIndex batch, const KeptForces& kept) {
  Pack* force = kept.force + std::ptrdiff_t{batch} * 3 * nodes;
  Pack sum = broadcast(0.0);
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < nodes; ++c) {
      sum += f[i][c] * v[i][c];
      force[i * nodes + c] = f[i][c];
    }
  for (int lane = 0; lane < pack_width; ++lane) {
    if (lives(living, lane)) continue;
    sum[lane] = 0;
    for (int k = 0; k < 3 * nodes; ++k) force[k][lane] = 0;
  }
  kept.power[batch] = sum;
}

}  // namespace brunt::force
