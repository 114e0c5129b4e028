// SPDX-License-Identifier: Apache-2.0
// Rigid walls in implicit steps: planes that nodes cannot pass, at rest or in motion along their normals.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/implicit/scheme.hpp"
#include "brunt/implicit/unknowns.hpp"
#include "brunt/implicit/wall_node.hpp"
#include "brunt/model/model.hpp"

namespace brunt::implicit {

/// A node that this rank owns and the walls that may meet it.
struct WallNode {
  std::size_t own = 0;                    ///< place in Unknowns::node
  std::int32_t first = 0, count = 0;      ///< its entries in WallContact::wall
  std::int32_t kept[WallChoice::most]{};  ///< walls looked at in this step: its nearest
  std::int32_t looked_at = 0;
  bool springs = false;      ///< of a rigid body: walls push it as springs do (wall_spring.hpp)
  Mat3 tied = Mat3::Zero();  ///< projector on directions along which a tie holds it in its walls, at the iterate
  WallChoice solved;         ///< what the last linear solve took the walls to do
  WallAction action;         ///< at the iterate
};

/// What walls have done since t = 0: saved.
struct WallAccount {
  double normal = 0, friction = 0;  ///< taken from the bodies [energy]
};
constexpr int wall_account_width = sizeof(WallAccount) / sizeof(double);

struct WallContact {
  double touching = 0;              ///< gaps below it at t_n belong to nodes that are pressed at first [length]
  bool first = true;                ///< no linear solve has been made in this step
  std::vector<double> place;        ///< of each wall at t_{n+1}: normal . x of its plane [length]
  std::vector<WallNode> nodes;      ///< ascending by `own`
  std::vector<std::int32_t> wall;   ///< by node
  std::vector<std::uint8_t> holds;  ///< of each of `wall`: the node lay in the plane of a bilateral wall at the start
  std::vector<LocalIndex> node_of;  ///< by place in Unknowns::node: index into `nodes`, or no_index
  WallAccount account;
  std::vector<double> impulse;  ///< of each wall on the bodies since t = 0, three each [momentum]: saved
  std::vector<double> force;    ///< of each wall at t_n, three each [force]: saved
  [[nodiscard]] bool any() const { return !place.empty(); }
};

/// spacing: mean distance of nodes [length].
WallContact make_walls(const model::Model& model, const Unknowns& unknowns, double spacing);

/// Walls go to their places at `time`, a step after `state`'s; what is pressed at first follows from the state of t_n.
void begin_walls(const model::Model& model, const model::State& state, const Unknowns& unknowns, double time_before,
                 double time, WallContact& walls);

/// What walls do at a node (place in Unknowns::node) at x; nullptr where none may meet it. question: all but the walls.
const WallAction* meet_walls(const model::Model& model, const Vec3& x, std::size_t own, WallQuestion question,
                             WallContact& walls);
/// As it was last found.
const WallAction* action_of(const WallContact& walls, std::size_t own);

/// The matrix is laid as walls are now.
void remember_choice(WallContact& walls);

/// Appends what walls do at each node of this rank as a number: rows and slip change together with it.
void add_branches(const WallContact& walls, std::vector<std::uint8_t>& branches);

/// Has every node that is pressed been so chosen by its balance, and not by its place alone? Collective.
bool chosen_by_balance(const comm::Communicator& ranks, const WallContact& walls);

/// Normal and tangential forces of walls on a node at the iterate [force].
struct WallForces {
  Vec3 normal = Vec3::Zero(), friction = Vec3::Zero();
};
WallForces forces_of(const model::Model& model, const WallContact& walls, std::size_t own);

/// The step of length dt is accepted: impulses of each wall, of_impulse of the forces now and the rest of those at t_n,
/// which become those of now. Collective.
void keep_walls(const comm::Communicator& ranks, const model::Model& model, double dt, double of_impulse,
                WallContact& walls);

/// Rows that press a node. Collective.
GlobalIndex pressed(const comm::Communicator& ranks, const WallContact& walls);

}  // namespace brunt::implicit
