// SPDX-License-Identifier: Apache-2.0
// The conductor: gather, detect, enforce, scatter.
#include "brunt/contact/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brunt/comm/rendezvous.hpp"
#include "brunt/contact/join_surface.hpp"
#include "brunt/core/error.hpp"
#include "brunt/geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

template <class T>
std::span<double> as_doubles(std::vector<T>& values) {
  return {reinterpret_cast<double*>(values.data()), values.size() * sizeof(T) / sizeof(double)};
}

constexpr double twin_share = 0.01;  // one pass with nodes that lie so near each other is as good as two

std::vector<char> held_by_walls(const Surface& surface, const std::vector<Vec3>& reference,
                                std::span<const Wall> walls) {
  constexpr double in_plane = 1e-6;
  std::vector<char> held;
  held.reserve(walls.size() * surface.gid.size());
  for (const Wall& wall : walls)
    for (const LocalIndex node : surface.model_node) {
      const double gap = (reference[static_cast<std::size_t>(node)] - wall.point).dot(wall.normal);
      held.push_back(wall.bilateral && std::abs(gap) <= in_plane * surface.mean_edge ? 1 : 0);
    }
  return held;
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
  // walls alone are solved at once, other methods start from nothing: no history is kept for them
  const Method method = settings_.enforcement.method;
  settings_.enforcement.warm_start =
      settings_.enforcement.warm_start && settings_.bodies && (method == Method::rate || method == Method::row_sum);
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
  sums_.wall_impulse.resize(walls.size());
  sums_.tracked_impulse.resize(settings_.tracked.size());
  keep_overlaps(mesh.coordinates, walls);
  make_ties(mesh.coordinates, walls);
}

double Contact::motion_used(VectorView position, VectorView predicted, std::span<const Wall> walls, double dt) const {
  if (!have_lists_) return std::numeric_limits<double>::infinity();
  double largest = 0;
  const auto keep = [&](const Vec3& moved, const Vec3& velocity) {  // what is not finite must not be lost
    const Vec3 coming = dt * velocity;
    if (2 * (moved.squaredNorm() + coming.squaredNorm()) <= largest * largest) return;  // (a + b)^2 <= 2 (a^2 + b^2)
    const double used = moved.norm() + coming.norm();
    if (!(used <= largest)) largest = used;
  };
  for (std::size_t i = 0; i < surface_.gid.size(); ++i) {
    const LocalIndex node = surface_.model_node[i];
    keep(position[node] - list_position_[i], predicted[node]);
  }
  for (std::size_t w = 0; w < walls.size(); ++w) keep(walls[w].point - list_wall_[w], walls[w].velocity);
  return largest / motion_;
}

bool Contact::must_rebuild(double global_motion_used) const {
  if (!(global_motion_used < 1)) return true;
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
  list_position_.clear();
  for (const LocalIndex node : surface_.model_node) {
    list_position_.push_back(position[node]);
    const double speed = predicted[node].norm();
    if (!(speed <= fastest)) fastest = speed;
  }
  list_wall_.clear();
  for (const Wall& wall : walls) {
    list_wall_.push_back(wall.point);
    fastest = std::max(fastest, wall.velocity.norm());
  }
  motion_ = std::max(settings_.motion_share * surface_.mean_depth, 4 * dt * ranks_.max(fastest));
  const ListSettings reach{.encounter = settings_.detection.encounter,
                           .wall_capture = settings_.detection.encounter.capture * settings_.detection.wall_size,
                           .motion = motion_,
                           .faces = settings_.bodies,
                           .two_passes = two_passes_,
                           .thickness = settings_.thickness};
  lists_ = build_lists(ranks_, surface_, settings_.pairs, roles_, list_position_, walls, held_, reach, list_scratch_);
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
  own_area_.assign(surface_.faces.size(), Vec3::Zero());
  facet_area_.assign(static_cast<std::size_t>(lists_.facet_count), Vec3::Zero());
  detection_.reserve(lists_.faces.size(), facet_area_.size(), lists_.most_faces_of_a_slave);
  node_normal_.reserve(nodes);
  const std::size_t most_rows = lists_.most_rows + ties_.size();
  rows_.reserve(most_rows);
  impulses_.reserve(most_rows);
  scratch_.reserve(most_rows, nodes);
  if (two_passes_) scratch_.reserve_passes(most_rows);
  if (rubs_ || !settings_.tied.empty()) faces_by_key_ = order_by_key(lists_.faces);
  if (!settings_.tied.empty()) demand_ties_hold();
  if (!remembers()) return;
  const std::size_t sides = has_sheets() ? lists_.candidates.faces.values.size() : 0;
  detection_.sides.reserve(sides);
  history_.pairs.reserve(most_rows + sides);
  next_pairs_.reserve(most_rows + sides);
  history_.anchors.reserve(most_rows);
  next_anchors_.reserve(most_rows);
}

void Contact::share_reference() {
  if (settings_.detection.accepted.empty()) return;
  reference_.assign(lists_.nodes.gid.size(), Vec3::Zero());
  for (std::size_t i = 0; i < reference_.size(); ++i)
    if (const LocalIndex here = lists_.nodes.surface_node[i]; here != no_index)
      reference_[i] = surface_reference_[static_cast<std::size_t>(here)];
  lists_.exchange.share(as_doubles(reference_), 3);
}

void Contact::gather(VectorView position, VectorView old_velocity, MutableVectorView velocity) {
  for (std::size_t i = 0; i < motion_of_.size(); ++i) {
    const LocalIndex here = lists_.nodes.surface_node[i];
    if (here == no_index) continue;
    const LocalIndex node = surface_.model_node[static_cast<std::size_t>(here)];
    motion_of_[i] = {position[node], old_velocity[node], velocity[node]};
  }
  lists_.exchange.share(as_doubles(motion_of_), node_motion_width);
  if (!lists_.any_facets) return;
  for (std::size_t f = 0; f < surface_.faces.size(); ++f) {
    if (lists_.facet_needed[f] == 0) continue;
    const SurfaceFace& face = surface_.faces[f];
    const auto count = static_cast<std::size_t>(face.corner_count);
    std::array<Vec3, 4> corners;
    for (std::size_t i = 0; i < count; ++i)
      corners[i] = position[surface_.model_node[static_cast<std::size_t>(face.nodes[i])]];
    own_area_[f] = geometry::area_vector({corners.data(), count}) / static_cast<double>(count);
  }
  lists_.facets.forward(as_doubles(own_area_), as_doubles(facet_area_), 3);
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
  tie_rows(ties_, tie_scene(dt), levers_, rows_);
  sort_rows(rows_);
}

void Contact::remember(std::span<const Wall> walls, double dt) {
  if (settings_.enforcement.warm_start || has_sheets()) {
    write_pairs(rows_, impulses_, dt, detection_.sides, next_pairs_);
    std::swap(history_.pairs, next_pairs_);
  }
  if (!rubs_) return;
  write_anchors(rows_, impulses_, anchor_scene(walls), history_.anchors, next_anchors_);
  std::swap(history_.anchors, next_anchors_);
}

void Contact::scatter(MutableVectorView velocity) {
  for (std::size_t i = 0; i < velocity_.size(); ++i) {
    const LocalIndex here = lists_.nodes.surface_node[i];
    if (here != no_index) velocity.set(surface_.model_node[static_cast<std::size_t>(here)], velocity_[i]);
  }
  if (!any_copies_) return;
  for (const LocalIndex node : lent_) {
    const auto i = static_cast<std::size_t>(node);
    Eigen::Map<Vec3>(surface_velocity_.data() + 3 * i) = velocity[surface_.model_node[i]];
  }
  surface_copies_.forward(surface_velocity_, foreign_velocity_, 3);
  for (std::size_t i = 0; i < foreign_.size(); ++i)
    velocity.set(surface_.model_node[static_cast<std::size_t>(foreign_[i])], Vec3(&foreign_velocity_[3 * i]));
}

void Contact::search(VectorView position, VectorView predicted, std::span<const Wall> walls, double dt,
                     double global_motion_used) {
  demand(walls.size() == sums_.wall_impulse.size(), "contact was made for another number of walls");
  if (must_rebuild(global_motion_used)) rebuild(position, predicted, walls, dt);
}

void Contact::correct(VectorView position, VectorView old_velocity, MutableVectorView velocity,
                      std::span<const Wall> walls, double dt) {
  ++statistics_.steps;
  statistics_.last = {};
  rows_.clear();
  impulses_.clear();
  if (!lists_.any_rows) {
    history_.clear();
    return;
  }
  gather(position, old_velocity, velocity);
  detect(walls, dt);
  lay_passes();
  lay_friction(walls, dt);
  if (settings_.enforcement.method == Method::printed) lay_slabs();
  impulses_.assign(rows_.size(), Vec3::Zero());
  if (settings_.enforcement.warm_start) start_impulses(rows_, history_.pairs, dt, impulses_);
  const EnforcementResult result = enforce({rows_, motion_of_, mobility_, two_passes_}, settings_.enforcement, dt,
                                           lists_.exchange, impulses_, velocity_, scratch_);
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
