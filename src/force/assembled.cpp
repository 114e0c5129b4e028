// SPDX-License-Identifier: Apache-2.0
#include "force/assembled.hpp"

namespace brunt::force {
namespace {

std::vector<AlignedVector<double>> sized(const model::Model& model, int entries) {
  std::vector<AlignedVector<double>> blocks(model.blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b)
    if (const model::ElementBlock& block = model.blocks[b]; !material::is_rigid(block.law))
      blocks[b].assign(static_cast<std::size_t>(block.batches() * entries * pack_width), 0.0);
  return blocks;
}

Pack* packs(AlignedVector<double>& values) {
  return reinterpret_cast<Pack*>(values.data());
}

/// Calls use(linear, batch) for each batch of a block, with its entries.
template <class Use>
void for_each_batch(const AlignedVector<double>& linear, const Use& use) {
  constexpr std::size_t stride = static_cast<std::size_t>(linear_entries) * pack_width;
  for (std::size_t batch = 0; batch < linear.size() / stride; ++batch) use(batch);
}

/// 0 for lanes without stiffness: padding and removed elements.
Pack inverse(Pack value) {
  return select(value > 0.0, 1.0 / value, Pack{});
}

}  // namespace

LinearElements sized_linear(const model::Model& model) {
  return sized(model, linear_entries);
}

Baseline sized_baseline(const model::Model& model) {
  return sized(model, 2);
}

void take_baseline(const LinearElements& linear, Baseline& baseline) {
  for (std::size_t b = 0; b < linear.size(); ++b) {
    const auto* from = reinterpret_cast<const Pack*>(linear[b].data());
    Pack* to = packs(baseline[b]);
    for_each_batch(linear[b], [&](std::size_t batch) {
      const Pack rate = from[batch * linear_entries + at_rate];
      to[2 * batch] = inverse(rate * rate);
      to[2 * batch + 1] = inverse(from[batch * linear_entries + at_plane2]);
    });
  }
}

void include_damping(LinearElements& linear, double dt) {
  for (AlignedVector<double>& block : linear)
    for_each_batch(block, [&](std::size_t batch) {
      Pack* entry = packs(block) + batch * linear_entries;
      entry[at_lambda] += (2 / dt) * entry[at_viscosity];
      entry[at_spring] += (2 / dt) * entry[at_dashpot];
    });
}

}  // namespace brunt::force
