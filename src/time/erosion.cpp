// SPDX-License-Identifier: Apache-2.0
#include "time/erosion.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "time/removal.hpp"

namespace brunt::time {
namespace {

using model::Erosion;

/// Fields in the histories of a block's elements, entry by entry.
class Histories {
 public:
  Histories(const model::ElementBlock& block, const model::State& state, const model::Scratch& scratch, std::size_t b)
      : block_(block), history_(state.history[b]), bounds_(scratch.element_bounds[b]) {}

  /// The maximum over the points, or their mean; 0 without the field. NaN counts as infinite.
  [[nodiscard]] double measure(const model::HistoryRange* range, LocalIndex e, Erosion::Points rule) const {
    if (range == nullptr) return 0;
    double largest = 0, sum = 0;
    for (int p = 0; p < range->components; ++p) {
      const double value = at(range->first + p, e);
      if (!(value <= largest)) largest = value;
      sum += value;
    }
    return counted(rule == Erosion::Points::any ? largest : sum / range->components);
  }

  /// Mean stress of the points times the sign: the maximum, or the mean.
  [[nodiscard]] double pressure(LocalIndex e, Erosion::Points rule, double sign) const {
    const bool shell = block_.turns();  // xx, yy and shears of plane stress
    const model::HistoryRange& stress = *block_.find(shell ? "local_stress" : "stress");
    const int stride = shell ? 5 : 6, normal = shell ? 2 : 3, points = stress.components / stride;
    double largest = -HUGE_VAL, sum = 0;
    for (int p = 0; p < points; ++p) {
      double trace = 0;
      for (int c = 0; c < normal; ++c) trace += at(stress.first + stride * p + c, e);
      const double value = -sign * trace / 3;
      if (!(value <= largest)) largest = value;
      sum += value;
    }
    return counted(rule == Erosion::Points::any ? largest : sum / points);
  }

  [[nodiscard]] double rate(LocalIndex e) const { return bound(0, e); }
  [[nodiscard]] double volume(LocalIndex e) const { return bound(1, e); }

 private:
  static double counted(double value) { return std::isnan(value) ? HUGE_VAL : value; }
  [[nodiscard]] double at(int entry, LocalIndex e) const {
    return history_[(static_cast<std::size_t>(e / pack_width) * static_cast<std::size_t>(block_.history_size) +
                     static_cast<std::size_t>(entry)) *
                        pack_width +
                    static_cast<std::size_t>(e % pack_width)];
  }
  [[nodiscard]] double bound(std::size_t which, LocalIndex e) const {
    return bounds_[(2 * static_cast<std::size_t>(e / pack_width) + which) * pack_width +
                   static_cast<std::size_t>(e % pack_width)];
  }

  const model::ElementBlock& block_;
  std::span<const double> history_, bounds_;
};

/// The criterion that an element meets; null: none.
GlobalIndex* met(const model::ElementBlock& block, const Histories& histories, LocalIndex e, ErosionCount& count) {
  const Erosion& erosion = *block.erosion;
  if (erosion.damage && histories.measure(block.find("damage"), e, erosion.points) >= *erosion.damage)
    return &count.damage;
  if (erosion.plastic_strain &&
      histories.measure(block.find("plastic_strain"), e, erosion.points) >= *erosion.plastic_strain)
    return &count.plastic_strain;
  if (erosion.pressure) {
    const double sign = *erosion.pressure > 0 ? 1 : -1;
    if (histories.pressure(e, erosion.points, sign) >= std::abs(*erosion.pressure)) return &count.pressure;
  }
  if (!erosion.takes_collapsed()) return nullptr;
  if (!(histories.volume(e) > erosion.volume.value_or(0))) return &count.volume;
  if (!(histories.rate(e) * erosion.step.value_or(0) <= 1)) return &count.step;
  return nullptr;
}

}  // namespace

bool erode(const comm::Communicator& ranks, const model::Model& model, model::State& state,
           const model::Scratch& scratch, std::vector<ErosionCount>& counts) {
  if (!model.any_erosion()) return false;
  counts.assign(model.blocks.size(), {});
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    if (!block.erosion) continue;
    const Histories histories(block, state, scratch, b);
    for (LocalIndex e = 0; e < block.count; ++e) {
      double& alive = nth(state.alive[b], e);
      if (alive <= 0) continue;
      GlobalIndex* count = met(block, histories, e, counts[b]);
      if (count == nullptr) continue;
      ++*count;
      alive = block.erosion->keeps_nodes ? 0 : -1;
    }
  }
  static_assert(sizeof(ErosionCount) == 5 * sizeof(GlobalIndex));
  ranks.sum(std::span(reinterpret_cast<GlobalIndex*>(counts.data()), 5 * counts.size()));
  const bool any = std::ranges::any_of(counts, [](const ErosionCount& count) { return count.all() > 0; });
  if (any) follow_alive(ranks, model, state);
  return any;
}

}  // namespace brunt::time
