// SPDX-License-Identifier: Apache-2.0
#include "part_sums.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "comm/exact_sum.hpp"
#include "force/watched.hpp"
#include "model/alive.hpp"

namespace brunt::app {
namespace {

/// A value that each element remembers.
double remembered(const Prepared& run, std::size_t b, LocalIndex element, const model::HistoryRange& range) {
  const model::ElementBlock& block = run.model.blocks[b];
  const std::ptrdiff_t row = std::ptrdiff_t{element / pack_width} * block.history_size + range.first;
  return nth(run.state.history[b], row * pack_width + element % pack_width);
}

/// Calls visit(node, its share of the element's mass) for all corners of the part's elements but those that were
/// dropped with an element.
template <class Visit>
void for_corners(const Prepared& run, const PartNodes& part, Visit&& visit) {
  const model::ElementBlock& block = run.model.blocks[part.block];
  const model::HistoryRange& mass = *block.find("mass");
  for (LocalIndex e = 0; e < block.count; ++e) {
    const double share = remembered(run, part.block, e, mass) / block.corners();
    for (int c = 0; c < block.corners(); ++c)
      if (const auto node = static_cast<std::size_t>(block.corner_node(e, c)); !run.state.nodes[node].is_dropped())
        visit(node, share);
  }
}

/// Calls visit(node, its share of the element's rotary inertia) likewise for a part of shells.
template <class Visit>
void for_turning_corners(const Prepared& run, const PartNodes& part, Visit&& visit) {
  const model::ElementBlock& block = run.model.blocks[part.block];
  if (!block.turns()) return;
  const model::HistoryRange& inertia = *block.find("rotary_inertia");
  for (LocalIndex e = 0; e < block.count; ++e) {
    const double share = remembered(run, part.block, e, inertia) / block.corners();
    for (int c = 0; c < block.corners(); ++c)
      if (const auto node = static_cast<std::size_t>(block.corner_node(e, c)); !run.state.nodes[node].is_dropped())
        visit(node, share);
  }
}

template <std::size_t n>
std::array<double, n> rounded(const Prepared& run, std::array<comm::ExactAccumulator, n>& sums) {
  std::array<double, n> value{};
  comm::exact_sum(run.links.ranks, sums, value);
  return value;
}

/// Exact sum over the corners of share times vector(node).
template <class Vector>
Vec3 weighted_sum(const Prepared& run, const PartNodes& part, Vector&& vector) {
  std::array<comm::ExactAccumulator, 3> sums;
  for_corners(run, part, [&](std::size_t node, double share) {
    const Vec3 value = vector(node);
    for (std::size_t c = 0; c < 3; ++c) sums[c].add(share * value[static_cast<int>(c)]);
  });
  const std::array<double, 3> value = rounded(run, sums);
  return {value[0], value[1], value[2]};
}

Vec3 position(const Prepared& run, std::size_t node) {
  return Eigen::Map<const Vec3>(run.state.nodes[node].x);
}
Vec3 velocity(const Prepared& run, std::size_t node) {
  return Eigen::Map<const Vec3>(run.state.nodes[node].v);
}
Vec3 rate(const Prepared& run, std::size_t node) {
  return Eigen::Map<const Vec3>(run.state.rotations[node].rate);
}

}  // namespace

PartNodes nodes_of_part(const Prepared& run, const std::string& part) {
  PartNodes nodes;
  const auto found = std::ranges::find(run.model.blocks, part, &model::ElementBlock::part);
  nodes.block = static_cast<std::size_t>(found - run.model.blocks.begin());
  std::vector<char> own(static_cast<std::size_t>(run.model.nodes()), 0);
  for (LocalIndex e = 0; e < found->count; ++e)
    for (int c = 0; c < found->corners(); ++c) nth(own, found->corner_node(e, c)) = 1;
  for (const LocalIndex node : run.model.between_parts.nodes) nth(own, node) = 0;
  for (const LocalIndex node : run.model.owned)
    if (nth(own, node)) nodes.own.push_back(node);
  return nodes;
}

double part_mass(const Prepared& run, const PartNodes& part) {
  std::array<comm::ExactAccumulator, 1> sum;
  for_corners(run, part, [&](std::size_t /*node*/, double share) { sum[0].add(share); });
  return rounded(run, sum)[0];
}

Vec3 part_center(const Prepared& run, const PartNodes& part) {
  const Vec3 moment = weighted_sum(run, part, [&](std::size_t node) { return position(run, node); });
  return moment / part_mass(run, part) + run.model.mesh.origin;
}

Vec3 part_momentum(const Prepared& run, const PartNodes& part) {
  return weighted_sum(run, part, [&](std::size_t node) { return velocity(run, node); });
}

Vec3 part_angular_momentum(const Prepared& run, const PartNodes& part, const Vec3& about) {
  const Vec3 point = about - run.model.mesh.origin;
  std::array<comm::ExactAccumulator, 3> sums;
  const auto add = [&](const Vec3& momentum) {
    for (std::size_t c = 0; c < 3; ++c) sums[c].add(momentum[static_cast<int>(c)]);
  };
  for_corners(run, part, [&](std::size_t node, double share) {
    add(share * (position(run, node) - point).cross(velocity(run, node)));
  });
  for_turning_corners(run, part, [&](std::size_t node, double share) { add(share * rate(run, node)); });
  const std::array<double, 3> value = rounded(run, sums);
  return {value[0], value[1], value[2]};
}

PartEnergy part_energy(const Prepared& run, const PartNodes& part, std::span<const Vec3> before, double dt_mean) {
  enum { kinetic, work, hourglass, bulk, terms };
  const model::ElementBlock& block = run.model.blocks[part.block];
  std::array<comm::ExactAccumulator, terms> sums;
  for_corners(run, part, [&](std::size_t node, double share) {
    sums[kinetic].add(0.5 * share * velocity(run, node).dot(before[node]));
  });
  for_turning_corners(run, part, [&](std::size_t node, double share) {
    const Quad& earlier = run.scratch.rate_before[node];
    sums[kinetic].add(0.5 * share * rate(run, node).dot(Vec3(earlier[0], earlier[1], earlier[2])));
  });
  // accounts hold the work of whole steps: half of the last impulse's work is taken off again
  for (const LocalIndex node : part.own) {
    const auto i = static_cast<std::size_t>(node);
    const Quad& f = run.scratch.force[i];
    sums[work].add(run.state.displacement[i][3] - 0.5 * dt_mean * velocity(run, i).dot(Vec3(f[0], f[1], f[2])));
    if (!block.turns()) continue;
    const Quad& m = run.scratch.moment[i];
    sums[work].add(run.state.rotation_accounts[i].element_work -
                   0.5 * dt_mean * rate(run, i).dot(Vec3(m[0], m[1], m[2])));
  }
  if (run.model.between_parts.booked) {
    for (const double done : run.state.interface_work[part.block]) sums[work].add(done);
    for (const model::WatchedCorner& corner : run.model.between_parts.corners[part.block]) {
      const auto node = static_cast<std::size_t>(corner.node);
      double power = velocity(run, node).dot(force::corner_force(run.scratch, corner));
      if (block.turns()) power += rate(run, node).dot(force::corner_moment(run.scratch, corner));
      sums[work].add(-0.5 * dt_mean * power);
    }
  }
  // removed elements have taken theirs along
  const auto lives = [&](LocalIndex e) { return model::lives(run.state, part.block, e); };
  for (LocalIndex e = 0; e < block.count; ++e)
    if (const auto i = static_cast<std::size_t>(e); !lives(e))
      sums[work].add(run.scratch.last_work[part.block][i] - run.state.element_work[part.block][i]);
  const auto add = [&](const char* name, auto term) {
    if (const model::HistoryRange* range = block.find(name))
      for (LocalIndex e = 0; e < block.count; ++e)
        if (lives(e)) sums[term].add(remembered(run, part.block, e, *range));
  };
  add("hourglass_energy", hourglass);
  add("bulk_energy", bulk);
  const std::array<double, terms> value = rounded(run, sums);
  return {value[kinetic], -value[work] - value[hourglass] - value[bulk], value[hourglass], value[bulk]};
}

}  // namespace brunt::app
