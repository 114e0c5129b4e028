// SPDX-License-Identifier: Apache-2.0
// The loop over the batches of a block of shells: as block_loop.hpp, with rotations and moments at the corners; and the
// choice of its kernel: options and law are resolved once for each block.
#pragma once
#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>

#include "block_loop.hpp"
#include "core/error.hpp"
#include "element/shell_batch.hpp"
#include "material/elastic.hpp"
#include "material/j2.hpp"
#include "material/law.hpp"
#include "material/metal.hpp"

namespace brunt::force {

template <int nodes>
BRUNT_INLINE void gather_shell(const LocalIndex* node, const model::NodeLine* lines,
                               const model::RotationLine* rotations, element::ShellMotion<nodes>& motion) {
  for (int c = 0; c < nodes; ++c) {
    const LocalIndex* corner = node + c * pack_width;
    const auto position = [&](int lane) { return *reinterpret_cast<const Quad*>(lines[corner[lane]].x); };
    const auto velocity = [&](int lane) { return *reinterpret_cast<const Quad*>(lines[corner[lane]].v); };
    const auto rate = [&](int lane) { return *reinterpret_cast<const Quad*>(rotations[corner[lane]].rate); };
    components_of(position, motion.x[0][c], motion.x[1][c], motion.x[2][c]);
    components_of(velocity, motion.v[0][c], motion.v[1][c], motion.v[2][c]);
    components_of(rate, motion.r[0][c], motion.r[1][c], motion.r[2][c]);
  }
}

/// Rate and volume of a batch for erosion, the volume over that of the start; see keep_bounds.
template <int nodes>
BRUNT_INLINE void keep_shell_bounds(const Collapse& collapse, double density, LocalIndex batch, int history_size,
                                    const KeptForces& kept, Pack* history, element::ShellForce<nodes>& out) {
  kept.bounds[2 * batch] = out.rate;
  kept.bounds[2 * batch + 1] = out.volume * density / history[element::at_shell_mass];
  if (!collapse.is_taken) return;
  const PackMask folded = ~(out.volume > 0.0);
  const PackMask gone = folded | ~(out.rate <= collapse.largest_rate);
  if (!any(gone)) return;
  out.rate = select(gone, Pack{}, out.rate);
  if (!any(folded)) return;
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < nodes; ++c) {
      out.f[i][c] = select(folded, Pack{}, out.f[i][c]);
      out.m[i][c] = select(folded, Pack{}, out.m[i][c]);
    }
  for (int entry = 3; entry < history_size; ++entry) history[entry] = select(folded, Pack{}, history[entry]);
  out.volume = select(folded, broadcast(1.0), out.volume);
}

/// Stores forces and moments of a batch, zero for removed elements, and their power before the step.
template <int nodes>
BRUNT_INLINE void keep_shell_forces(const element::ShellForce<nodes>& out, const element::ShellMotion<nodes>& motion,
                                    std::uint8_t living, LocalIndex batch, const KeptForces& kept) {
  Pack* force = kept.force + std::ptrdiff_t{batch} * 6 * nodes;
  Pack sum = broadcast(0.0);
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < nodes; ++c) {
      sum += out.f[i][c] * motion.v[i][c] + out.m[i][c] * motion.r[i][c];
      force[i * nodes + c] = out.f[i][c];
      force[(i + 3) * nodes + c] = out.m[i][c];
    }
  for (int lane = 0; lane < pack_width; ++lane) {
    if (lives(living, lane)) continue;
    sum[lane] = 0;
    for (int k = 0; k < 6 * nodes; ++k) force[k][lane] = 0;
  }
  kept.power[batch] = sum;
}

/// A batch of removed elements only: clears all stored data of their forces.
template <int nodes>
void leave_shells_out(std::span<const model::BorderCorner> border, Quad* slots, Quad* moment_slots,
                      const KeptForces& kept, LocalIndex batch) {
  for (const model::BorderCorner& corner : border) slots[corner.slot] = moment_slots[corner.slot] = Quad{};
  if (kept.force == nullptr) return;
  std::fill_n(kept.force + std::ptrdiff_t{batch} * 6 * nodes, 6 * nodes, broadcast(0.0));
  kept.power[batch] = broadcast(0.0);
}

/// See force/assembled_kernels.cpp: springs of the frequency whose stable step is that of the element.
template <int nodes>
BRUNT_INLINE void keep_springs(Pack rate, Pack mass, Pack* linear) {
  const Pack omega2 = 4.0 * rate * rate;
  for (int entry = 0; entry < linear_entries; ++entry) linear[entry] = broadcast(0.0);
  linear[at_spring] = omega2 * mass * (1.0 / nodes);
  linear[at_plane2] = omega2;
  linear[at_rate] = rate;
}

/// As see_growth.
BRUNT_INLINE void see_shell_growth(Pack rate, const Pack* baseline, int lanes, std::uint8_t living, double& largest) {
  const Pack growth = rate * rate * baseline[0];
  for (int lane = 0; lane < lanes; ++lane)
    if (lives(living, lane) && rate[lane] > 0) largest = std::max(largest, growth[lane]);
}

/// The first element without a volume, or with a rate that gives no step: infinite or not a number.
template <int nodes>
BRUNT_INLINE void note_lost(const element::ShellForce<nodes>& out, std::uint8_t living, int lanes, LocalIndex block,
                            LocalIndex batch, ElementReport& report) {
  const PackMask sound = (out.volume > 0.0) & (out.rate < std::numeric_limits<double>::infinity());
  if (!any(~sound) || report.inverted_block >= 0) return;
  for (int lane = lanes - 1; lane >= 0; --lane)
    if (lives(living, lane) && !sound[lane]) {
      report.inverted_element = batch * pack_width + lane;
      report.inverted_block = block;
    }
}

template <class Kernel>
void run_shell_block(const Kernel& kernel, const model::ElementBlock& block, LocalIndex block_index,
                     const BlockPass& pass) {
  constexpr int nodes = Kernel::nodes;
  const auto& [model, moved, committed, trial, scratch, report] = pass;
  element::ShellMotion<nodes> motion;
  motion.dt = moved.dt;
  element::ShellForce<nodes> out;
  const auto* before = reinterpret_cast<const Pack*>(nth(committed, block_index).data());
  auto* after = reinterpret_cast<Pack*>(nth(trial, block_index).data());
  Quad* slots = reinterpret_cast<Quad*>(scratch.slots.data());
  Quad* moment_slots = reinterpret_cast<Quad*>(scratch.moment_slots.data());
  const std::span<const std::uint8_t> of_block = lanes_of(moved.living, block_index);
  const KeptForces kept = kept_forces(scratch, block_index);
  const Collapse collapse = Collapse::of(block);
  const WatchedBlock watched = watched_block(moved.watch, block_index);
  RepeatedLane<nodes, Kernel::most_history> repeated;
  repeated.used = block.history_size;
  Pack largest = broadcast(report.rate);
  for (LocalIndex batch = 0; batch < block.batches(); ++batch) {
    const LocalIndex* node = block.node.data() + static_cast<std::ptrdiff_t>(batch) * nodes * pack_width;
    const LocalIndex* seen = node;
    const std::ptrdiff_t memory = static_cast<std::ptrdiff_t>(batch) * block.history_size;
    const Pack* remembered = before + memory;
    const std::uint8_t living = living_lanes(of_block, batch);
    const std::span<const model::BorderCorner> border = block.border.row(batch);
    if (living == 0) {
      leave_shells_out<nodes>(border, slots, moment_slots, kept, batch);
      continue;
    }
    if (living != every_lane) {
      repeated.put(node, living, remembered);
      seen = repeated.node.data();
      remembered = repeated.memory.data();
    }
    gather_shell<nodes>(seen, moved.nodes.data(), moved.rotations.data(), motion);
    kernel(motion, remembered, after + memory, out);
    if (kept.bounds != nullptr)
      keep_shell_bounds<nodes>(collapse, kernel.law.density, batch, block.history_size, kept, after + memory, out);
    if (living != every_lane) repeated.take_off(living, after + memory);
    if (kept.force != nullptr) keep_shell_forces<nodes>(out, motion, living, batch, kept);
    const int lanes = std::min(pack_width, block.count - batch * pack_width);
    scatter_forces<nodes>(node, lanes, living, out.f, border, scratch.force.data(), slots);
    scatter_forces<nodes>(node, lanes, living, out.m, border, scratch.moment.data(), moment_slots);
    if (watched.linear != nullptr)
      keep_springs<nodes>(out.rate, before[memory + element::at_shell_mass],
                          watched.linear + std::ptrdiff_t{batch} * linear_entries);
    if (watched.baseline != nullptr)
      see_shell_growth(out.rate, watched.baseline + std::ptrdiff_t{batch} * 2, lanes, living, report.growth);
    note_rate(out.rate, living, lanes, block_index, batch, report, largest);
    note_lost<nodes>(out, living, lanes, block_index, batch, report);
  }
}

/// Calls `use(response)` with the response of a law that shells may have (scene/rules refuses others).
template <class Use>
auto with_shell_response(const material::Law& law, Use&& use) {
  return std::visit(
      [&](const auto& constants) {
        using Constants = std::decay_t<decltype(constants)>;
        if constexpr (std::is_same_v<Constants, material::J2>) {
          const bool table = !constants.table.empty(), kinematic = constants.kinematic > 0;
          if (table && kinematic) return use(material::J2Response<true, true>(constants));
          if (table) return use(material::J2Response<true, false>(constants));
          if (kinematic) return use(material::J2Response<false, true>(constants));
          return use(material::J2Response<false, false>(constants));
        } else if constexpr (std::is_same_v<Constants, material::Metal>) {
          demand(!constants.eos, "shells have no equation of state");
          return use(material::MetalResponse<false>(constants));
        } else if constexpr (std::is_same_v<Constants, material::Elastic>) {
          return use(material::ElasticResponse(constants));
        } else {
          demand(false, "this law has no plane stress");
          return decltype(use(std::declval<material::ElasticResponse>()))();
        }
      },
      law);
}

/// `Shell` with control of hourglass modes or without.
template <template <class> class Shell>
struct ShellChoice {
  template <class Use>
  static auto with_kernel(const model::ElementBlock& block, Use&& use) {
    return with_shell_response(block.law, [&](const auto& response) {
      using Kernel = Shell<std::decay_t<decltype(response)>>;
      if constexpr (requires { Kernel{response, block.section, block.hourglass}; })
        return use(Kernel{response, block.section, block.hourglass});
      else
        return use(Kernel{response, block.section});
    });
  }
};

/// As kernels_of, for shells.
template <class Choice>
constexpr Kernels shell_kernels_of() {
  return {[](const model::ElementBlock& block) {
            return Choice::with_kernel(block, [](const auto& kernel) { return kernel.history(); });
          },
          [](const model::ElementBlock& block, LocalIndex block_index, const BlockPass& pass) {
            Choice::with_kernel(block, [&](const auto& kernel) { run_shell_block(kernel, block, block_index, pass); });
          }};
}

}  // namespace brunt::force
