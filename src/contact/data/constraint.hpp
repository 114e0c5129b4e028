// SPDX-License-Identifier: Apache-2.0
// The data shared by detection, enforcement and ghosting: contact nodes and constraint rows.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/data/row_key.hpp"
#include "core/types.hpp"

namespace brunt::contact {

/// Response of a node to an impulse: its velocity changes by inverse_mass * projector * impulse.
struct Mobility {
  double inverse_mass = 0;            ///< [1/mass]; 0 for an immovable node
  Mat3 projector = Mat3::Identity();  ///< zero along constrained directions

  [[nodiscard]] bool is_free() const { return projector.trace() == 3; }  ///< the trace of a projector is its rank
  /// Whether an impulse along this unit vector can move the node. Rounding errors of a constrained direction count as
  /// zero.
  [[nodiscard]] bool is_free_along(const Vec3& normal) const {
    return is_free() || (projector * normal).norm() > rounding;
  }
  static constexpr double rounding = 1e-6;
};

/// Data of a node before contact in a step.
struct NodeMotion {
  Vec3 position = Vec3::Zero();      ///< x_n
  Vec3 old_velocity = Vec3::Zero();  ///< v at n - 1/2
  Vec3 predicted = Vec3::Zero();     ///< v*, the velocity at n + 1/2 without contact
};
constexpr int node_motion_width = 9;
static_assert(sizeof(NodeMotion) == node_motion_width * sizeof(double));

/// Admissible impulses of a row.
enum class Cone : std::int8_t {
  compression,  ///< compression only
  free          ///< compression and tension
};

/// The pass to which a row belongs.
enum class Pass : std::int8_t {
  both,   ///< walls, edges, one-pass contact: part of each pass
  first,  ///< nodes of one side on faces of the other
  second  ///< the reverse
};

/// Rows of detection but for mortar rows: a node and a face of four corners.
constexpr std::size_t most_nodes_of_a_row = 5;
/// Rows of detection: the slave and the master.
constexpr std::size_t most_bodies_of_a_row = 2;

/// The lever arm of a point of a row: its velocity v contributes turn v to the rate in addition to its weight, and it
/// receives turn^T p of an impulse. The points of a tie turn its offset: a common rotation has no rate, and the
/// impulses have no moment.
struct Arm {
  Mat3 turn = Mat3::Zero();
  double size = 0;  ///< bound of |turn v| / |v|
};

/// One constraint on the relative velocity r = sum_i weights[i] v[nodes[i]]: normal . r >= required (equality for a
/// free cone). With friction, also r = drift across the normal as long as the impulse across it stays within friction
/// times the impulse along it, plus the lagging part. An impulse p [momentum] changes the momentum of node i by
/// weights[i] p. Rows are ordered by their keys. `points` and `shares` are the nodes and weights of rows of any length;
/// a mortar row, of a tie or not, has its own node in nodes[0] and a node of the master in nodes[1].
struct Row {
  RowKey key{};
  std::array<LocalIndex, most_nodes_of_a_row> nodes{};  ///< contact nodes, the slave (or the slave edge's two) first
  std::array<double, most_nodes_of_a_row>
      weights{};  ///< of the slave, sum 1, then minus the weights of the master's nodes
  std::int32_t node_count = 0;
  std::int32_t slave_body = 0, master_body = 0;
  std::int32_t slave_block = 0;       ///< of a slave edge; a node may have several
  std::int32_t master_block = 0;      ///< walls have neither body nor block
  LocalIndex master_face = no_index;  ///< of a node on a face: its place in the lists, if known
  Vec3 normal = Vec3::Zero();         ///< unit, out of the master
  double gap = 0;                     ///< at x_n: > 0 open, < 0 penetration
  double required = 0;  ///< smallest admissible rate [velocity]: -gap/dt when open, a limited recovery when closed
  Cone cone = Cone::compression;
  Pass pass = Pass::both;
  double softness = 0;          ///< s of enforcement/softness.hpp; 0: rigid
  double gap_share = 0;         ///< share of the penetration that `required` recovers
  double drift_share = 0;       ///< share of the slip that `drift` recovers
  double wall_rate = 0;         ///< of a moving wall itself, along the normal [velocity]; part of `required`
  double slab = 0;              ///< Z1 Z2 / (Z1 + Z2) A of eq. (29) in Heinstein et al. 2000 [mass/time]; 0: not known
  double friction = 0;          ///< Coulomb coefficient for this step; 0: none
  bool holds = false;           ///< it constrains the tangential directions without a limit: a tie
  bool lags = false;            ///< friction follows the pressure late: see FrictionLaw::lag
  double lagging = 0;           ///< tangential impulse that is admissible for the previous pressure [momentum]
  double noise = 0;             ///< bound of the error of the required rate due to rounding of positions [velocity]
  Vec3 drift = Vec3::Zero();    ///< tangential velocity required in sticking [velocity]: recovers the slip
  std::span<const Arm> arms{};  ///< one a point, or none: of ties; live as long as the rows of a step
  /// One a point, or none: of rows with friction across a gap, see detection/tilts.hpp. Across the normal; the velocity
  /// v of the point contributes tilt (normal . v) to r, and the point receives normal (tilt . p). Live as the arms.
  std::span<const Vec3> tilts{};
  /// Of a row with more points than `nodes` has room for, all of them and their weights; live as long as the rows.
  std::span<const LocalIndex> wide_points{};
  std::span<const double> wide_weights{};

  [[nodiscard]] std::span<const LocalIndex> points() const {
    return wide_points.empty() ? std::span(nodes).first(static_cast<std::size_t>(node_count)) : wide_points;
  }
  [[nodiscard]] std::span<const double> shares() const {
    return wide_points.empty() ? std::span(weights).first(static_cast<std::size_t>(node_count)) : wide_weights;
  }
  [[nodiscard]] bool is_mortar() const { return key.kind == RowKind::mortar; }
  [[nodiscard]] bool is_mortar_tie() const { return key.kind == RowKind::mortar_tie; }
  [[nodiscard]] bool is_wall() const { return key.kind == RowKind::wall; }
  [[nodiscard]] bool is_edge() const { return key.kind == RowKind::edge; }
};

/// Contribution of arms to the relative velocity.
template <std::invocable<LocalIndex> VelocityOf>
[[gnu::noinline]] void add_turned(const Row& row, const VelocityOf& velocity_of, Vec3& relative) {
  for (std::size_t i = 0; i < row.points().size(); ++i) relative += row.arms[i].turn * velocity_of(row.points()[i]);
}

/// Contribution of tilts to the relative velocity.
template <std::invocable<LocalIndex> VelocityOf>
[[gnu::noinline]] void add_tilted(const Row& row, const VelocityOf& velocity_of, Vec3& relative) {
  Vec3 tilted = Vec3::Zero();
  for (std::size_t i = 0; i < row.points().size(); ++i)
    tilted += row.normal.dot(velocity_of(row.points()[i])) * row.tilts[i];
  relative += tilted;
}

/// The relative velocity of the row; velocity_of(node): of a contact node.
template <std::invocable<LocalIndex> VelocityOf>
[[gnu::always_inline]] inline Vec3 relative_velocity(const Row& row, const VelocityOf& velocity_of) {
  Vec3 relative = Vec3::Zero();
  const std::span<const LocalIndex> points = row.points();
  const std::span<const double> shares = row.shares();
  for (std::size_t i = 0; i < points.size(); ++i) relative += shares[i] * velocity_of(points[i]);
  if (!row.arms.empty()) [[unlikely]]
    add_turned(row, velocity_of, relative);
  if (!row.tilts.empty()) add_tilted(row, velocity_of, relative);
  return relative;
}

/// The part of the row's impulse that acts on point i [momentum].
inline Vec3 impulse_on_node(const Row& row, std::size_t i, const Vec3& impulse) {
  Vec3 share = row.shares()[i] * impulse;
  if (!row.arms.empty()) share += row.arms[i].turn.transpose() * impulse;
  if (!row.tilts.empty()) share += row.tilts[i].dot(impulse) * row.normal;
  return share;
}

/// Upper bound of the factor between a row's impulse and that on one of its nodes.
inline double largest_share(const Row& row) {
  constexpr double beside = 2;  // weights of a tied node a little beside its face
  if (row.wide_points.empty() && row.arms.empty() && row.tilts.empty()) return row.holds ? beside : 1.0;
  double most = 0;
  for (std::size_t i = 0; i < row.points().size(); ++i)
    most = std::max(most, std::abs(row.shares()[i]) + (row.arms.empty() ? 0.0 : row.arms[i].size) +
                              (row.tilts.empty() ? 0.0 : row.tilts[i].norm()));
  return most;
}

/// The largest admissible tangential impulse [momentum] for this normal impulse.
inline double friction_limit(const Row& row, double along) {
  return row.friction * std::abs(along) + row.lagging;
}

}  // namespace brunt::contact
