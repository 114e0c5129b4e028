// SPDX-License-Identifier: Apache-2.0
#include "force/watched.hpp"

#include <algorithm>

namespace brunt::force {

std::vector<model::WatchedCorner> watched_corners(const model::ElementBlock& block, std::span<const LocalIndex> nodes) {
  std::vector<model::WatchedCorner> corners;
  if (nodes.empty()) return corners;
  for (LocalIndex batch = 0; batch < block.batches(); ++batch)
    for (const model::BorderCorner& kept : block.border.row(batch)) {
      const LocalIndex element = batch * pack_width + kept.lane, node = block.corner_node(element, kept.corner);
      if (std::ranges::binary_search(nodes, node)) corners.push_back({element, node, kept.slot});
    }
  return corners;
}

void book_interface(const model::Model& model, model::State& state, const model::Scratch& scratch, double dt_mean) {
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    for (const model::WatchedCorner& corner : model.between_parts.corners[b]) {
      const auto i = static_cast<std::size_t>(corner.node);
      const Vec3 twice_mean_v = scratch.before[i] + Eigen::Map<const Vec3>(state.nodes[i].v);
      double twice_power = twice_mean_v.dot(corner_force(scratch, corner));
      if (model.blocks[b].turns()) {
        const Quad& before = scratch.rate_before[i];
        const Vec3 twice_mean_rate = Vec3(before[0], before[1], before[2]) + Vec3(state.rotations[i].rate);
        twice_power += twice_mean_rate.dot(corner_moment(scratch, corner));
      }
      nth(state.interface_work[b], corner.element) += 0.5 * dt_mean * twice_power;
    }
}

void add_interface_work(const model::Model& model, model::State& state, const model::Scratch& scratch, double time) {
  for (std::size_t b = 0; b < state.interface_work.size(); ++b)
    for (const model::WatchedCorner& corner : model.between_parts.corners[b]) {
      const Vec3 v = Eigen::Map<const Vec3>(nth(state.nodes, corner.node).v);
      double power = v.dot(corner_force(scratch, corner));
      if (model.blocks[b].turns())
        power += Vec3(nth(state.rotations, corner.node).rate).dot(corner_moment(scratch, corner));
      nth(state.interface_work[b], corner.element) += time * power;
    }
}

}  // namespace brunt::force
