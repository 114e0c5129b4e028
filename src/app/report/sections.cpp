// SPDX-License-Identifier: Apache-2.0
#include "sections.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "comm/exact_sum.hpp"
#include "force/watched.hpp"
#include "scene/build/select.hpp"

namespace brunt::app {
namespace {

Vec3 position(const Prepared& run, LocalIndex node) {
  return Eigen::Map<const Vec3>(nth(run.state.nodes, node).x);
}

void add(std::span<comm::ExactAccumulator> sums, const Vec3& value) {
  for (std::size_t c = 0; c < 3; ++c) sums[c].add(value[static_cast<int>(c)]);
}

/// Mean of the current positions of the section's nodes, less the mesh's origin.
Vec3 center(const Prepared& run, const Section& section) {
  std::array<comm::ExactAccumulator, 4> sums;
  for (const LocalIndex node : section.nodes) {
    add(sums, position(run, node));
    sums[3].add(1.0);
  }
  std::array<double, 4> value{};
  comm::exact_sum(run.links.ranks, sums, value);
  return Vec3(value[0], value[1], value[2]) / value[3];
}

}  // namespace

Section find_section(const Prepared& run, std::size_t index) {
  const scene::Probe& probe = run.input.probes[index];
  const auto& sets = run.model.mesh.node_sets;
  const std::vector<LocalIndex>& nodes = sets.at(scene::selection_name("probe", index));
  const auto front = sets.find(scene::selection_name("front", index));
  Section section;
  section.about = probe.about;
  for (const LocalIndex node : nodes)
    if (std::ranges::binary_search(run.model.owned, node)) section.nodes.push_back(node);
  for (const model::ElementBlock& block : run.model.blocks) {
    std::vector<model::WatchedCorner>& corners = section.corners.emplace_back();
    if (std::ranges::find(probe.parts, block.part) == probe.parts.end()) continue;
    corners = force::watched_corners(block, nodes);
    if (front == sets.end()) continue;
    std::erase_if(corners, [&](const model::WatchedCorner& corner) {
      for (int c = 0; c < block.corners(); ++c)
        if (std::ranges::binary_search(front->second, block.corner_node(corner.element, c))) return false;
      return true;
    });
  }
  return section;
}

std::array<Vec3, 2> section_force(const Prepared& run, const Section& section) {
  const Vec3 about = section.about ? Vec3(*section.about - run.model.mesh.origin) : center(run, section);
  std::array<comm::ExactAccumulator, 6> sums;
  for (std::size_t b = 0; b < section.corners.size(); ++b)
    for (const model::WatchedCorner& corner : section.corners[b]) {
      const Vec3 force = force::corner_force(run.scratch, corner);
      if (run.model.blocks[b].turns()) add(std::span(sums).last(3), force::corner_moment(run.scratch, corner));
      add(std::span(sums).first(3), force);
      add(std::span(sums).last(3), (position(run, corner.node) - about).cross(force));
    }
  std::array<double, 6> value{};
  comm::exact_sum(run.links.ranks, sums, value);
  return {Vec3(value[0], value[1], value[2]), Vec3(value[3], value[4], value[5])};
}

}  // namespace brunt::app
