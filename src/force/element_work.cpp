// SPDX-License-Identifier: Apache-2.0
#include "force/element_work.hpp"

#include <algorithm>

namespace brunt::force {
namespace {

/// Power of the stored forces of a batch with the current velocities of the nodes.
Pack power_now(const model::ElementBlock& block, LocalIndex batch, const model::State& state, const Pack* force) {
  const LocalIndex* node = block.node.data() + std::ptrdiff_t{batch} * block.corners() * pack_width;
  Pack sum = broadcast(0.0);
  for (int c = 0; c < block.corners(); ++c) {
    const auto velocity = [&](int lane) {
      return *reinterpret_cast<const Quad*>(nth(state.nodes, node[c * pack_width + lane]).v);
    };
    Pack v[3];
    components_of(velocity, v[0], v[1], v[2]);
    for (int i = 0; i < 3; ++i) sum += force[i * block.corners() + c] * v[i];
    if (!block.turns()) continue;
    const auto rate = [&](int lane) {
      return *reinterpret_cast<const Quad*>(nth(state.rotations, node[c * pack_width + lane]).rate);
    };
    components_of(rate, v[0], v[1], v[2]);
    for (int i = 0; i < 3; ++i) sum += force[(i + 3) * block.corners() + c] * v[i];
  }
  return sum;
}

/// Calls use(block, element, power before the step, current power) for the elements whose forces are stored.
template <class Use>
void for_kept(const model::Model& model, const model::State& state, const model::Scratch& scratch, Use&& use) {
  for (std::size_t b = 0; b < scratch.element_force.size(); ++b) {
    if (scratch.element_force[b].empty()) continue;
    const model::ElementBlock& block = model.blocks[b];
    const auto* force = reinterpret_cast<const Pack*>(scratch.element_force[b].data());
    const auto* before = reinterpret_cast<const Pack*>(scratch.element_power[b].data());
    for (LocalIndex batch = 0; batch < block.batches(); ++batch) {
      const Pack now =
          power_now(block, batch, state, force + std::ptrdiff_t{batch} * block.corner_components() * block.corners());
      const int lanes = std::min(pack_width, block.count - batch * pack_width);
      for (int lane = 0; lane < lanes; ++lane)
        use(b, static_cast<std::size_t>(batch * pack_width + lane), before[batch][lane], now[lane]);
    }
  }
}

}  // namespace

void book_element_work(const model::Model& model, model::State& state, model::Scratch& scratch, double dt_mean) {
  for_kept(model, state, scratch, [&](std::size_t b, std::size_t element, double before, double now) {
    scratch.last_work[b][element] = 0.5 * dt_mean * now;
    state.element_work[b][element] += 0.5 * dt_mean * (before + now);
  });
}

void add_element_work(const model::Model& model, model::State& state, const model::Scratch& scratch, double time) {
  for_kept(model, state, scratch, [&](std::size_t b, std::size_t element, double /*before*/, double now) {
    state.element_work[b][element] += time * now;
  });
}

}  // namespace brunt::force
