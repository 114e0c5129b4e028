// SPDX-License-Identifier: Apache-2.0
// What rows are given besides what detection finds: their passes, friction, and the slabs of the printed method.
#include <algorithm>
#include <cmath>

#include "brunt/contact/contact.hpp"

namespace brunt::contact {

/// A node that belongs to several blocks has the roughest one's friction.
FrictionLaw Contact::friction_of(const Row& row, std::span<const Wall> walls) const {
  if (row.is_wall()) return walls[static_cast<std::size_t>(-1 - row.master_key)].friction;
  if (settings_.friction.empty()) return {};
  const std::size_t blocks = settings_.pairs.block_count();
  const auto law_of = [&](std::int32_t slave) {
    return settings_.friction[static_cast<std::size_t>(slave) * blocks + static_cast<std::size_t>(row.master_block)];
  };
  if (row.is_edge()) return law_of(row.slave_block);
  FrictionLaw roughest;
  for (const std::int32_t block :
       surface_.blocks.row(lists_.nodes.surface_node[static_cast<std::size_t>(row.nodes[0])]))
    if (const FrictionLaw law = law_of(block); law.fixed > roughest.fixed) roughest = law;
  return roughest;
}

bool Contact::has_twin(const Row& row) const {
  const auto motion = [&](LocalIndex node) { return motion_of_[static_cast<std::size_t>(node)]; };
  return std::any_of(row.nodes.begin() + 1, row.nodes.begin() + row.node_count, [&](LocalIndex node) {
    return are_twins(motion(row.nodes[0]), motion(node), settings_.detection);
  });
}

/// The row of a node that has a twin holds in both passes, since the twin has none in the second (see detect_faces).
void Contact::lay_passes(double dt) {
  if (!two_passes_) return;
  const bool remembers_impulses = settings_.enforcement.warm_start && !settings_.enforcement.averaged;
  const double softness = remembers_impulses ? settings_.enforcement.softness : 0.0;
  for (Row& row : rows_) {
    if (row.is_wall() || row.is_edge() || row.cone != Cone::compression) continue;  // ties hold in both
    row.pass = pass_of(row, surface_.node(lists_.nodes.surface_node[static_cast<std::size_t>(row.nodes[0])]),
                       settings_.pairs, surface_.bodies);
    if (row.pass == Pass::first && row.slave_body != row.master_body && has_twin(row)) row.pass = Pass::both;
    if (row.pass == Pass::both || softness == 0) continue;
    row.softness = softness;
    if (row.gap < 0) row.gap_share = row.required * dt / -row.gap;
  }
}

AnchorScene Contact::anchor_scene(std::span<const Wall> walls) const {
  return {lists_.faces, faces_by_key_, motion_of_, walls, settings_.detection.encounter};
}

void Contact::lay_friction(std::span<const Wall> walls, double dt) {
  if (!rubs_) return;
  for (Row& row : rows_) {
    if (std::isinf(row.friction)) continue;  // a tie
    const FrictionLaw law = friction_of(row, walls);
    if (!law.any()) continue;
    row.friction = friction_coefficient(law, row, motion_of_);
    if (law.lag > 0) let_friction_lag(row, history_.limits, law.lag, dt);
  }
  const DetectionSettings& detection = settings_.detection;
  aim_at_anchors(rows_, anchor_scene(walls), history_.anchors,
                 {detection.recovery, detection.recovery_limit * surface_.mean_edge}, dt);
}

/// The slave node's share of each face around it, as far as the face looks against the normal: sides of a body carry
/// nothing [length^2].
double Contact::area_of_slave(const Row& row) const {
  const auto slave = std::ranges::lower_bound(lists_.candidates.slave, row.nodes[0]) - lists_.candidates.slave.begin();
  double area = 0;
  for (const LocalIndex facet : lists_.candidates.slave_facets.row(static_cast<LocalIndex>(slave)))
    area += std::max(0.0, -row.normal.dot(facet_area_[static_cast<std::size_t>(facet)]));
  return area;
}

/// Rows of edges and walls have none: an edge has no area, and a wall's candidates no facets.
void Contact::lay_slabs() {
  for (Row& row : rows_) {
    if (row.is_wall() || row.is_edge()) continue;
    const LocalIndex slave = lists_.nodes.surface_node[static_cast<std::size_t>(row.nodes[0])];
    const double one = settings_.impedance[static_cast<std::size_t>(surface_.blocks.row(slave).front())],
                 two = settings_.impedance[static_cast<std::size_t>(row.master_block)];
    row.slab = one * two / (one + two) * area_of_slave(row);
  }
}

}  // namespace brunt::contact
