// SPDX-License-Identifier: Apache-2.0
// When the lists of contact are made anew, and all that is sized with them.
#include <algorithm>

#include "brunt/contact/anchors.hpp"
#include "brunt/contact/contact.hpp"
#include "brunt/core/error.hpp"
#include "memory.hpp"

namespace brunt::contact {

bool Contact::motion_is_used_up(VectorView position, VectorView predicted, std::span<const Wall> walls, double dt,
                                const VelocitySpan& velocities) {
  const std::size_t nodes = surface_.model_node.size();
  list_motion_.advance(velocities, last_dt_, dt);
  for (std::size_t w = 0; w < walls.size(); ++w)
    list_motion_.advance_one(nodes + w, walls[w].point, walls[w].velocity, dt);
  if (list_motion_.bound() < motion_) return false;

  ListMotion::Sum sum(list_motion_, dt);
  for (std::size_t i = 0; i < nodes; ++i) {
    if (i + far_ahead < nodes) position.fetch(surface_.model_node[i + far_ahead]);
    const LocalIndex node = surface_.model_node[i];
    sum.add(i, position[node], predicted[node]);
  }
  for (std::size_t w = 0; w < walls.size(); ++w) sum.add(nodes + w, walls[w].point, walls[w].velocity);
  MotionSpan found = sum.span();
  ranks_.max(found);
  list_motion_.correct(found);
  return !(found[0] < motion_);
}

/// For reasons other than motion.
bool Contact::must_rebuild() const {
  if (!have_lists_) return true;
  const auto step = static_cast<std::uint64_t>(statistics_.steps);
  switch (settings_.rebuild.when) {
    case Rebuild::When::every:
      return step % static_cast<std::uint64_t>(settings_.rebuild.steps) == 0;
    case Rebuild::When::random:
      return ((step + settings_.rebuild.seed) * 0x9E3779B97F4A7C15ULL >> 40) % 4 == 0;
    case Rebuild::When::motion_used_up:
      break;
  }
  return false;
}

void Contact::rebuild(VectorView position, VectorView predicted, std::span<const Wall> walls, double dt) {
  double fastest = 0;
  list_motion_.start();
  for (const LocalIndex node : surface_.model_node) {
    list_motion_.put(position[node]);
    const double speed = predicted[node].norm();
    if (!(speed <= fastest)) fastest = speed;
  }
  for (const Wall& wall : walls) {
    list_motion_.put(wall.point);
    fastest = std::max(fastest, wall.velocity.norm());
  }
  motion_ = std::max(settings_.motion_share * surface_.mean_depth, 4 * dt * ranks_.max(fastest));
  const ListSettings reach{.encounter = settings_.detection.encounter,
                           .wall_capture = settings_.detection.encounter.capture * settings_.detection.wall_size,
                           .motion = motion_,
                           .faces = settings_.bodies,
                           .two_passes = two_passes_,
                           .thickness = settings_.thickness};
  lists_ = build_lists(ranks_, surface_, settings_.pairs, roles_, list_motion_.starts().first(surface_.gid.size()),
                       walls, held_, reach, list_scratch_);
  have_lists_ = true;
  ++statistics_.searches;

  const std::size_t nodes = lists_.nodes.gid.size();
  motion_of_.assign(nodes, {});
  velocity_.assign(nodes, Vec3::Zero());
  mobility_.assign(nodes, {});
  for (std::size_t i = 0; i < nodes; ++i)
    if (lists_.nodes.surface_node[i] != no_index)
      mobility_[i] = surface_mobility_[static_cast<std::size_t>(lists_.nodes.surface_node[i])];
  static_assert(sizeof(Mobility) == 10 * sizeof(double));
  lists_.exchange.share(as_doubles(mobility_), 10);
  share_reference();
  list_possible_twins();
  plan_gather();
  own_area_.assign(surface_.faces.size(), Vec3::Zero());
  facet_area_.assign(static_cast<std::size_t>(lists_.facet_count), Vec3::Zero());
  detection_.reserve(lists_.faces.size(), facet_area_.size(), lists_.most_faces_of_a_slave);
  node_normal_.reserve(nodes);
  const std::size_t most_rows = lists_.most_rows + ties_.size();
  rows_.reserve(most_rows);
  row_sort_.reserve(most_rows);
  impulses_.reserve(most_rows);
  scratch_.reserve(most_rows, nodes);
  if (two_passes_) scratch_.reserve_passes(most_rows);
  if (rubs_ || may_be_driven_ || !settings_.tied.empty()) faces_by_key_ = order_by_key(lists_.faces);
  if (!settings_.tied.empty()) demand_ties_hold();
  if (!remembers()) return;
  const std::size_t sides = has_sheets() ? lists_.candidates.faces.values.size() : 0;
  detection_.sides.reserve(sides);
  history_.pairs.reserve(most_rows + sides);
  next_pairs_.reserve(most_rows + sides);
  history_.anchors.reserve(most_rows);
  next_anchors_.reserve(most_rows);
  history_.limits.reserve(most_rows);
}

void Contact::share_reference() {
  if (settings_.detection.accepted.empty()) return;
  reference_.assign(lists_.nodes.gid.size(), Vec3::Zero());
  for (std::size_t i = 0; i < reference_.size(); ++i)
    if (const LocalIndex here = lists_.nodes.surface_node[i]; here != no_index)
      reference_[i] = surface_reference_[static_cast<std::size_t>(here)];
  lists_.exchange.share(as_doubles(reference_), 3);
}

void Contact::list_possible_twins() {
  if (!two_passes_) return;
  std::vector<Vec3> positions(lists_.nodes.gid.size(), Vec3::Zero());
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (const LocalIndex here = lists_.nodes.surface_node[i]; here != no_index)
      positions[i] = list_motion_.starts()[static_cast<std::size_t>(here)];
  lists_.exchange.share(as_doubles(positions), 3);
  list_twins(lists_.faces, positions, motion_, settings_.detection, lists_.candidates);
}

/// What `gather` takes from the model, so that it need not look through all of the surface.
void Contact::plan_gather() {
  const auto model_node = [&](LocalIndex node) { return surface_.model_node[static_cast<std::size_t>(node)]; };
  nodes_here_.clear();
  for (std::size_t i = 0; i < lists_.nodes.surface_node.size(); ++i)
    if (const LocalIndex here = lists_.nodes.surface_node[i]; here != no_index)
      nodes_here_.push_back({static_cast<LocalIndex>(i), model_node(here)});
  facets_here_.clear();
  for (std::size_t f = 0; f < surface_.faces.size(); ++f) {
    if (lists_.facet_needed[f] == 0) continue;
    const SurfaceFace& face = surface_.faces[f];
    FacetHere facet{static_cast<LocalIndex>(f), face.corner_count, {}};
    for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i)
      facet.model_nodes[i] = model_node(face.nodes[i]);
    facets_here_.push_back(facet);
  }
}

void Contact::search(VectorView position, VectorView predicted, std::span<const Wall> walls, double dt,
                     const VelocitySpan& velocities) {
  demand(walls.size() == sums_.wall_impulse.size(), "contact was made for another number of walls");
  lists_are_new_ = must_rebuild() || motion_is_used_up(position, predicted, walls, dt, velocities);
  if (lists_are_new_) rebuild(position, predicted, walls, dt);
  last_dt_ = dt;
}

}  // namespace brunt::contact
