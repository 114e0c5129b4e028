// SPDX-License-Identifier: Apache-2.0
// The conductor: gather, detect, enforce, scatter.
#include "brunt/contact/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brunt/comm/rendezvous.hpp"
#include "brunt/contact/detection/clearance.hpp"
#include "brunt/contact/join_surface.hpp"
#include "brunt/core/error.hpp"
#include "brunt/geometry/closest_point.hpp"
#include "memory.hpp"

namespace brunt::contact {
namespace {

std::vector<char> held_by_walls(const Surface& surface, const std::vector<Vec3>& reference,
                                std::span<const Wall> walls) {
  constexpr double in_plane = 1e-6;
  std::vector<char> held;
  held.reserve(walls.size() * surface.gid.size());
  for (const Wall& wall : walls)
    for (std::size_t i = 0; i < surface.model_node.size(); ++i) {
      const double gap = (reference[static_cast<std::size_t>(surface.model_node[i])] - wall.point).dot(wall.normal);
      const bool acts = acts_on(wall, surface.blocks.row(static_cast<LocalIndex>(i)));
      held.push_back(wall.bilateral && acts && std::abs(gap) <= in_plane * surface.mean_edge ? 1 : 0);
    }
  return held;
}

/// Of each body, the slowest of its blocks.
std::vector<double> sound_of(std::span<const BodyFigures> bodies, std::span<const double> sound) {
  std::vector<double> slowest;
  if (sound.empty()) return slowest;
  for (const BodyFigures& body : bodies) {
    slowest.push_back(std::numeric_limits<double>::infinity());
    for (const std::int32_t block : body.blocks)
      slowest.back() = std::min(slowest.back(), sound[static_cast<std::size_t>(block)]);
  }
  return slowest;
}

}  // namespace

Contact::Contact(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, std::span<const char> excluded,
                 std::span<const double> inverse_mass, std::span<const ConstrainedNode> constrained,
                 std::span<const Wall> walls, ContactSettings settings)
    : ranks_(ranks),
      settings_(std::move(settings)),
      surface_(join_surface(ranks, mesh, excluded, inverse_mass)),
      roles_(roles_of(surface_.bodies, settings_.pairs)) {
  settings_.detection.wall_size = surface_.mean_edge;
  settings_.detection.sound = sound_of(surface_.bodies, settings_.sound);
  // walls alone are solved at once, other methods start from nothing: no history is kept for them
  const Method method = settings_.enforcement.method;
  settings_.enforcement.warm_start =
      settings_.enforcement.warm_start && settings_.bodies && (method == Method::rate || method == Method::row_sum);
  settings_.enforcement.averaged = settings_.pairs.averages();
  settings_.detection.twin = twin_share * surface_.mean_depth;
  std::vector<comm::RemoteSlot> source;
  for (std::size_t i = 0; i < surface_.gid.size(); ++i) {
    surface_mobility_.push_back({inverse_mass[static_cast<std::size_t>(surface_.model_node[i])], Mat3::Identity()});
    if (surface_.owns(static_cast<LocalIndex>(i), ranks.rank())) continue;
    foreign_.push_back(static_cast<LocalIndex>(i));
    source.push_back({surface_.home[i].rank, surface_.home[i].index});
  }
  for (const ConstrainedNode& held : constrained) {
    const auto found = std::lower_bound(surface_.model_node.begin(), surface_.model_node.end(), held.node);
    if (found == surface_.model_node.end() || *found != held.node) continue;
    surface_mobility_[static_cast<std::size_t>(found - surface_.model_node.begin())].projector = held.projector;
  }
  std::vector<std::vector<LocalIndex>> wanted(static_cast<std::size_t>(ranks.size()));
  for (const comm::RemoteSlot& slot : source) wanted[static_cast<std::size_t>(slot.rank)].push_back(slot.index);
  lent_ = comm::exchange(ranks, wanted).values;
  any_copies_ = ranks.any(!lent_.empty());
  if (any_copies_) surface_copies_ = comm::Halo(ranks, static_cast<LocalIndex>(surface_.gid.size()), source);
  surface_velocity_.resize(3 * surface_.gid.size());
  foreign_velocity_.resize(3 * foreign_.size());
  held_ = held_by_walls(surface_, mesh.coordinates, walls);
  if (!settings_.detection.accepted.empty())
    for (const LocalIndex node : surface_.model_node)
      surface_reference_.push_back(mesh.coordinates[static_cast<std::size_t>(node)]);
  rubs_ = std::ranges::any_of(settings_.friction, &FrictionLaw::any) ||
          std::ranges::any_of(walls, [](const Wall& wall) { return wall.friction.any(); });
  two_passes_ = settings_.bodies && any_two_passes(settings_.pairs, surface_.bodies);
  may_be_driven_ =
      ranks.any(std::ranges::any_of(surface_mobility_, [](const Mobility& node) { return !node.is_free(); }));
  sums_.wall_impulse.resize(walls.size());
  sums_.tracked_impulse.resize(settings_.tracked.size());
  keep_overlaps(mesh.coordinates, walls);
  make_ties(mesh.coordinates, walls);
}

void Contact::gather(VectorView position, VectorView old_velocity, MutableVectorView velocity) {
  const VectorView predicted{velocity.data, velocity.stride};
  for (std::size_t k = 0; k < nodes_here_.size(); ++k) {
    if (k + far_ahead < nodes_here_.size()) {
      position.fetch(nodes_here_[k + far_ahead].model_node);
      old_velocity.fetch(nodes_here_[k + far_ahead].model_node);
      predicted.fetch(nodes_here_[k + far_ahead].model_node);
    }
    const auto [contact_node, node] = nodes_here_[k];
    motion_of_[static_cast<std::size_t>(contact_node)] = {position[node], old_velocity[node], predicted[node]};
  }
  lists_.exchange.begin_share(as_doubles(motion_of_), node_motion_width);
  if (lists_.any_facets) {
    measure_facets(position);
    lists_.facets.begin(as_doubles(own_area_), as_doubles(facet_area_), 3);
  }
  lists_.exchange.end_share(as_doubles(motion_of_), node_motion_width);
  if (lists_.any_facets) lists_.facets.end(as_doubles(own_area_), as_doubles(facet_area_), 3);
}

void Contact::measure_facets(VectorView position) {
  for (const FacetHere& facet : facets_here_) {
    const auto count = static_cast<std::size_t>(facet.corner_count);
    std::array<Vec3, 4> corners;
    for (std::size_t i = 0; i < count; ++i) corners[i] = position[facet.model_nodes[i]];
    own_area_[static_cast<std::size_t>(facet.face)] =
        geometry::area_vector({corners.data(), count}) / static_cast<double>(count);
  }
}

/// The ends of a slave edge may have their rows on other ranks.
void Contact::detect_crossing_edges(double dt) {
  node_normal_.assign(lists_.nodes.gid.size(), Vec3::Zero());
  for (const Row& row : rows_) {
    Vec3& normal = node_normal_[static_cast<std::size_t>(row.nodes[0])];
    if (normal.isZero(0)) normal = row.normal;
  }
  lists_.exchange.share(as_doubles(node_normal_), 3);
  detect_edges(lists_.edges, lists_.nodes.gid, motion_of_, detection_.facet_normal, node_normal_, reference_, dt,
               settings_.detection, rows_);
}

void Contact::detect(std::span<const Wall> walls, double dt) {
  detect_faces(lists_.candidates, lists_.faces, lists_.nodes.gid, motion_of_, facet_area_, dt, settings_.detection,
               history_.pairs, detection_, rows_);
  if (lists_.any_edges) detect_crossing_edges(dt);
  if (!settings_.tied.empty()) drop_tied_rows();
  detect_walls(lists_.wall_candidates, walls, lists_.nodes.gid, motion_of_, dt, settings_.detection, rows_);
  for (const Row& row : rows_) sums_.penetration = std::max(sums_.penetration, -row.gap);
  lay_ties(dt);
  sort_rows(rows_, row_sort_);
}

/// The same on every rank, as the bounds of motion are.
bool Contact::nothing_can_meet() const {
  return !lists_.any_rows || (!lists_are_new_ && 3 * list_motion_.bound() < clearance_);
}

void Contact::measure_clearance(std::span<const Wall> walls, double dt) {
  double least = ties_.empty() ? std::numeric_limits<double>::infinity() : 0.0;
  least = std::min(least, clearance_of_faces(lists_.candidates, detection_.reach, motion_of_, dt));
  least = std::min(least, clearance_of_edges(lists_.edges, motion_of_, dt, settings_.detection));
  least = std::min(least, clearance_of_walls(lists_.wall_candidates, walls, motion_of_, dt, settings_.detection));
  clearance_ = ranks_.min(least);
}

void Contact::remember(std::span<const Wall> walls, double dt) {
  if (settings_.enforcement.warm_start || has_sheets()) {
    write_pairs(rows_, impulses_, dt, detection_.sides, next_pairs_);
    std::swap(history_.pairs, next_pairs_);
  }
  if (!rubs_) return;
  write_anchors(rows_, impulses_, anchor_scene(walls), history_.anchors, next_anchors_);
  std::swap(history_.anchors, next_anchors_);
  write_limits(rows_, impulses_, dt, history_.limits);
}

void Contact::scatter(MutableVectorView velocity) {
  for (const auto& [contact_node, node] : nodes_here_)
    velocity.set(node, velocity_[static_cast<std::size_t>(contact_node)]);
  if (!any_copies_) return;
  for (const LocalIndex node : lent_) {
    const auto i = static_cast<std::size_t>(node);
    Eigen::Map<Vec3>(surface_velocity_.data() + 3 * i) = velocity[surface_.model_node[i]];
  }
  surface_copies_.forward(surface_velocity_, foreign_velocity_, 3);
  for (std::size_t i = 0; i < foreign_.size(); ++i)
    velocity.set(surface_.model_node[static_cast<std::size_t>(foreign_[i])], Vec3(&foreign_velocity_[3 * i]));
}

void Contact::correct(VectorView position, VectorView old_velocity, MutableVectorView velocity,
                      std::span<const Wall> walls, double dt, double mobility) {
  ++statistics_.steps;
  clock_ += dt;
  statistics_.last = {};
  rows_.clear();
  impulses_.clear();
  if (nothing_can_meet()) {
    ++statistics_.idle_steps;
    history_.clear();
    return;
  }
  gather(position, old_velocity, velocity);
  detect(walls, dt);
  if (may_be_driven_) watch_driven(dt);
  if (lists_are_new_) measure_clearance(walls, dt);
  lay_passes(dt);
  lay_friction(walls, dt);
  if (settings_.enforcement.method == Method::printed) lay_slabs();
  impulses_.assign(rows_.size(), Vec3::Zero());
  if (settings_.enforcement.warm_start) start_impulses(rows_, history_.pairs, dt, impulses_);
  const EnforcementResult result = enforce({rows_, motion_of_, mobility_, two_passes_, mobility}, settings_.enforcement,
                                           dt, lists_.exchange, impulses_, velocity_, scratch_);
  statistics_.last = result;
  remember(walls, dt);
  if (!result.acted) return;  // v* is what it was
  ++statistics_.solved_steps;
  statistics_.iterations += result.iterations;
  statistics_.most_iterations = std::max(statistics_.most_iterations, result.iterations);
  statistics_.largest_residual = std::max(statistics_.largest_residual, result.residual);
  if (ended_at_limit(result, settings_.enforcement)) ++statistics_.steps_at_limit;
  scatter(velocity);
  book();
}

}  // namespace brunt::contact
