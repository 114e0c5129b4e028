// SPDX-License-Identifier: Apache-2.0
#include "time/flow.hpp"

#include <algorithm>
#include <limits>

namespace brunt::time {
namespace {

/// Dissipates without a plastic strain: it flows at any time.
bool always_flows(const model::ElementBlock& block) {
  return std::holds_alternative<material::Foam>(block.law);
}

bool flows(const model::ElementBlock& block) {
  return always_flows(block) || std::holds_alternative<material::J2>(block.law) ||
         std::holds_alternative<material::Metal>(block.law);
}

void plan(const model::Model& model, std::span<const LocalIndex> surface, SurfaceFlow& flow) {
  std::vector<char> at_surface(model.mesh.node_gid.size(), 0);
  for (const LocalIndex node : surface) nth(at_surface, node) = 1;
  flow.elements.clear();
  flow.targets.clear();
  std::size_t slots = 0;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    slots += block.border.values.size();
    if (!flows(block)) continue;
    for (LocalIndex e = 0; e < block.count; ++e) {
      std::vector<LocalIndex> corners;
      for (int c = 0; c < block.corners(); ++c) corners.push_back(block.corner_node(e, c));
      if (std::ranges::none_of(corners, [&](LocalIndex node) { return nth(at_surface, node) != 0; })) continue;
      for (const model::BorderCorner& border : block.border.row(e / pack_width))
        if (border.lane == e % pack_width) nth(corners, LocalIndex{border.corner}) = -1 - border.slot;
      flow.elements.push_back({static_cast<LocalIndex>(b), e});
      flow.targets.insert(flow.targets.end(), corners.begin(), corners.end());
    }
  }
  flow.slots.assign(slots, 0.0);
  flow.of_node.assign(model.mesh.node_gid.size() + 1, 0.0);
  flow.planned = true;
}

/// Of an element, over its points; 0 once it has been removed.
double plastic_strain(const model::ElementBlock& block, const model::State& state, std::size_t b, LocalIndex e) {
  if (b < state.alive.size() && !state.alive[b].empty() && !(nth(state.alive[b], e) > 0)) return 0;
  if (always_flows(block)) return std::numeric_limits<double>::infinity();
  const model::HistoryRange* range = block.find("plastic_strain");
  double sum = 0;
  for (int p = 0; p < range->components; ++p)
    sum += state.history[b][(static_cast<std::size_t>(e / pack_width) * static_cast<std::size_t>(block.history_size) +
                             static_cast<std::size_t>(range->first + p)) *
                                pack_width +
                            static_cast<std::size_t>(e % pack_width)];
  return sum;
}

}  // namespace

bool has_flow(const model::Model& model) {
  return std::ranges::any_of(model.blocks, flows);
}

void sum_flow(const model::Model& model, const model::State& state, std::span<const LocalIndex> surface,
              comm::OrderedSum& corner_sum, SurfaceFlow& flow) {
  if (!flow.planned) plan(model, surface, flow);
  std::ranges::fill(flow.of_node, 0.0);
  auto target = flow.targets.begin();
  for (const auto& [b, e] : flow.elements) {
    const model::ElementBlock& block = nth(model.blocks, b);
    const double strain = plastic_strain(block, state, static_cast<std::size_t>(b), e);
    for (const auto end = target + block.corners(); target != end; ++target) {
      if (*target < 0)
        nth(flow.slots, -1 - *target) = strain;
      else
        nth(flow.of_node, *target) += strain;
    }
  }
  corner_sum.begin(flow.slots, 1);
  corner_sum.end(flow.slots, 1, flow.of_node, 1);
}

}  // namespace brunt::time
