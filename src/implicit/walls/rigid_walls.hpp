// SPDX-License-Identifier: Apache-2.0
// Rigid walls in implicit steps: impenetrable planes, at rest or moving along their normals.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "implicit/data/scheme.hpp"
#include "implicit/data/unknowns.hpp"
#include "implicit/walls/wall_node.hpp"
#include "model/model.hpp"

namespace brunt::implicit {

/// A node that this rank owns and the walls that may meet it.
struct WallNode {
  std::size_t own = 0;                    ///< place in Unknowns::node
  std::int32_t first = 0, count = 0;      ///< its entries in WallContact::wall
  std::int32_t kept[WallChoice::most]{};  ///< walls considered in this step: the nearest ones
  std::int32_t looked_at = 0;
  bool springs = false;      ///< of a rigid body: walls act on it by springs (wall_spring.hpp)
  Mat3 tied = Mat3::Zero();  ///< projector onto directions along which a tie constrains it to its walls, at the iterate
  double behind = 0;  ///< depth behind a wall at the iterate, 0 in front of all; bilateral ones excepted [length]
  double behind_before = 0;  ///< likewise at t_n
  WallChoice solved;         ///< the active walls assumed in the last linear solve
  WallAction action;         ///< at the iterate
};

/// Sums over walls since t = 0: saved.
struct WallAccount {
  double normal = 0, friction = 0;  ///< taken from the bodies [energy]
};
constexpr int wall_account_width = sizeof(WallAccount) / sizeof(double);

struct WallContact {
  double touching = 0;              ///< nodes with a smaller gap at t_n are active at first [length]
  bool first = true;                ///< before the first linear solve of this step
  std::vector<double> place;        ///< of each wall at t_{n+1}: normal . x of its plane [length]
  std::vector<WallNode> nodes;      ///< ascending by `own`
  std::vector<std::int32_t> wall;   ///< by node
  std::vector<std::uint8_t> holds;  ///< for each of `wall`: the node lay initially in the plane of a bilateral wall
  std::vector<LocalIndex> node_of;  ///< by place in Unknowns::node: index into `nodes`, or no_index
  WallAccount account;
  double penetration = 0;       ///< the largest depth at t_n since t = 0 [length]: saved
  std::vector<double> impulse;  ///< of each wall on the bodies since t = 0, three each [momentum]: saved
  std::vector<double> force;    ///< of each wall at t_n, three each [force]: saved
  [[nodiscard]] bool any() const { return !place.empty(); }
};

/// spacing: mean distance of nodes [length].
WallContact make_walls(const model::Model& model, const Unknowns& unknowns, double spacing);

/// Moves walls to their positions at `time`, one step after that of `state`; the first active set follows from the
/// state of t_n.
void begin_walls(const model::Model& model, const model::State& state, const Unknowns& unknowns, double time_before,
                 double time, WallContact& walls);

/// Action of the walls on a node (place in Unknowns::node) at x; nullptr if no wall can meet it. question: all data
/// except walls.
const WallAction* meet_walls(const model::Model& model, const Vec3& x, std::size_t own, WallQuestion question,
                             WallContact& walls);
/// The last result.
const WallAction* action_of(const WallContact& walls, std::size_t own);

/// The matrix is assembled with the current active walls.
void remember_choice(WallContact& walls);

/// Appends the branch of the walls at each node of this rank as a number: it changes with the active set and with slip.
void add_branches(const WallContact& walls, std::vector<std::uint8_t>& branches);

/// Whether the active set of every node follows from its balance, and not only from its position. Collective.
bool chosen_by_balance(const comm::Communicator& ranks, const WallContact& walls);

/// Normal and tangential forces of walls on a node at the iterate [force].
struct WallForces {
  Vec3 normal = Vec3::Zero(), friction = Vec3::Zero();
};
WallForces forces_of(const model::Model& model, const WallContact& walls, std::size_t own);

/// Accepts the step of length dt: adds to the impulses of each wall the share of_impulse of the current forces and the
/// rest of those at t_n, which are then replaced by the current ones; records the depth. Collective.
void keep_walls(const comm::Communicator& ranks, const model::Model& model, double dt, double of_impulse,
                WallContact& walls);

/// Number of active rows. Collective.
GlobalIndex pressed(const comm::Communicator& ranks, const WallContact& walls);

}  // namespace brunt::implicit
