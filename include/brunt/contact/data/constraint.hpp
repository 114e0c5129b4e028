// SPDX-License-Identifier: Apache-2.0
// The data that detection, enforcement and ghosting share: contact nodes and constraint rows.
#pragma once
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <vector>

#include "brunt/contact/data/row_key.hpp"
#include "brunt/core/types.hpp"

namespace brunt::contact {

/// How a node answers an impulse: its velocity changes by inverse_mass * projector * impulse.
struct Mobility {
  double inverse_mass = 0;            ///< [1/mass]; 0 for a node that nothing moves
  Mat3 projector = Mat3::Identity();  ///< nothing along constrained directions

  [[nodiscard]] bool is_free() const { return projector.trace() == 3; }  ///< the trace of a projector is its rank
  /// Can an impulse along this unit vector move it? What rounding leaves of a direction that is held counts as nothing.
  [[nodiscard]] bool is_free_along(const Vec3& normal) const {
    return is_free() || (projector * normal).norm() > rounding;
  }
  static constexpr double rounding = 1e-6;
};

/// What the step knows of a node before contact.
struct NodeMotion {
  Vec3 position = Vec3::Zero();      ///< x_n
  Vec3 old_velocity = Vec3::Zero();  ///< v at n - 1/2
  Vec3 predicted = Vec3::Zero();     ///< v*, the velocity at n + 1/2 without contact
};
constexpr int node_motion_width = 9;
static_assert(sizeof(NodeMotion) == node_motion_width * sizeof(double));

/// Which impulses a row admits.
enum class Cone : std::int8_t {
  compression,  ///< it pushes or does nothing
  free          ///< it holds both ways
};

/// Of two passes, the one that a row belongs to.
enum class Pass : std::int8_t {
  both,   ///< walls, edges, contact in one pass: it holds in each of them
  first,  ///< nodes of one side on faces of the other
  second  ///< the other way
};

/// Of rows that detection makes: a node and a face of four corners.
constexpr std::size_t most_nodes_of_a_row = 5;
/// Of those rows: the slave and the master.
constexpr std::size_t most_bodies_of_a_row = 2;

/// Of a node that is held off its master's face: where that face turns, the node goes with it. Each node's velocity v
/// counts in r by turn v besides its weight, and each takes turn^T p of an impulse, so that the row asks for nothing
/// where all nodes turn together, and its impulses have no moment.
struct Lever {
  std::array<Mat3, most_nodes_of_a_row> turn = all_zero();  ///< of each node of the row
  std::array<double, most_nodes_of_a_row> bound{};          ///< bounds of |turn v| / |v|
  double most = 1;  ///< bound of what one node takes of an impulse: the largest |weight| + bound

  /// A matrix that is made from nothing has no values of its own.
  static std::array<Mat3, most_nodes_of_a_row> all_zero() {
    std::array<Mat3, most_nodes_of_a_row> turn;
    turn.fill(Mat3::Zero());
    return turn;
  }
};

/// One constraint on the relative velocity r = sum_i weights[i] v[nodes[i]]: normal . r >= required (equal, for a free
/// cone) and, with friction, r = drift across the normal for as long as the impulse across it stays within friction
/// times the impulse along it, and what friction lags behind by. An impulse p [momentum] changes the momentum of node i
/// by weights[i] p. Rows are ordered by their keys.
struct Row {
  RowKey key{};
  std::array<LocalIndex, most_nodes_of_a_row> nodes{};  ///< contact nodes, the slave (or the slave edge's two) first
  std::array<double, most_nodes_of_a_row>
      weights{};  ///< of the slave, sum 1, then minus the weights of the master's nodes
  std::int32_t node_count = 0;
  std::int32_t slave_body = 0, master_body = 0;
  std::int32_t slave_block = 0;   ///< of a slave edge; a node may have several
  std::int32_t master_block = 0;  ///< walls have neither body nor block
  Vec3 normal = Vec3::Zero();     ///< unit, out of the master
  double gap = 0;                 ///< at x_n: > 0 open, < 0 penetration
  double required = 0;            ///< least rate [velocity]: -gap/dt when open, a limited recovery when closed
  Cone cone = Cone::compression;
  Pass pass = Pass::both;
  double softness = 0;        ///< s of enforcement/softness.hpp; 0: rigid
  double gap_share = 0;       ///< share of the penetration that `required` takes back
  double drift_share = 0;     ///< share of the slip that `drift` takes back
  double slab = 0;            ///< Z1 Z2 / (Z1 + Z2) A of eq. (29) in Heinstein et al. 2000 [mass/time]; 0: not known
  double friction = 0;        ///< Coulomb coefficient for this step; 0: none
  bool holds = false;         ///< across the normal it holds whatever the impulse: a tie
  bool lags = false;          ///< friction follows the pressure late: see FrictionLaw::lag
  double lagging = 0;         ///< what it admits for the pressure of before [momentum]
  double noise = 0;           ///< of what it asks for: bound of what the rounding of positions makes of it [velocity]
  Vec3 drift = Vec3::Zero();  ///< velocity across the normal that sticking asks for [velocity]: takes back what slid
  const Lever* lever = nullptr;  ///< of a tie across a gap or an overlap; lives as long as the rows of a step

  [[nodiscard]] bool is_wall() const { return key.kind == RowKind::wall; }
  [[nodiscard]] bool is_edge() const { return key.kind == RowKind::edge; }
};

/// What levers add to it.
template <std::invocable<LocalIndex> VelocityOf>
[[gnu::noinline]] void add_turned(const Row& row, const VelocityOf& velocity_of, Vec3& relative) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i)
    relative += row.lever->turn[i] * velocity_of(row.nodes[i]);
}

/// The row's relative velocity; velocity_of(node): of a contact node.
template <std::invocable<LocalIndex> VelocityOf>
[[gnu::always_inline]] inline Vec3 relative_velocity(const Row& row, const VelocityOf& velocity_of) {
  Vec3 relative = Vec3::Zero();
  const auto count = static_cast<std::size_t>(row.node_count);
  for (std::size_t i = 0; i < count; ++i) relative += row.weights[i] * velocity_of(row.nodes[i]);
  if (row.lever != nullptr) [[unlikely]]
    add_turned(row, velocity_of, relative);
  return relative;
}

/// What node i of the row takes of its impulse [momentum].
inline Vec3 impulse_on_node(const Row& row, std::size_t i, const Vec3& impulse) {
  const Vec3 share = row.weights[i] * impulse;
  return row.lever == nullptr ? share : Vec3(share + row.lever->turn[i].transpose() * impulse);
}

/// No node takes more than this times the row's impulse.
inline double largest_share(const Row& row) {
  constexpr double beside = 2;  // weights of a tied node a little beside its face
  if (row.lever != nullptr) return row.lever->most;
  return row.holds ? beside : 1.0;
}

/// The largest impulse across the normal [momentum] beside this one along it.
inline double friction_limit(const Row& row, double along) {
  return row.friction * std::abs(along) + row.lagging;
}

}  // namespace brunt::contact
