// SPDX-License-Identifier: Apache-2.0
// A node at rigid walls: along normals of walls that press it its equations say that it lies in their planes, along the
// rest that friction does what it can. No unknowns are added: pressures are what is left of the node's own balance.
#pragma once
#include <cstddef>
#include <span>

#include "brunt/core/types.hpp"

namespace brunt::implicit {

/// A wall and a node that it may meet, at one iterate.
struct WallMeeting {
  Vec3 normal = Vec3::UnitZ();  ///< unit, out of the wall
  double gap = 0;               ///< of the node at the iterate; below 0: behind the plane [length]
  double friction = 0;          ///< Coulomb's coefficient
  bool bilateral = false;       ///< holds the node back as well
};

/// What the walls do at a node: chosen anew at every iterate from what the last linear solve took them to do.
struct WallChoice {
  static constexpr std::size_t most = 3;  ///< walls a node can touch: more are redundant
  bool active[most] = {false, false, false};
  bool slides = false;  ///< friction is all that it can be
};

/// The node's equations and what the walls give.
struct WallAction {
  WallChoice choice;
  Mat3 rows = Mat3::Identity();                   ///< multiplies the node's rows of the matrix
  Mat3 free = Mat3::Identity();                   ///< projector on directions that neither supports nor walls hold
  Mat3 own = Mat3::Zero();                        ///< added to its diagonal block [force/length]
  Vec3 left = Vec3::Zero();                       ///< of the node's equations [force]
  double pressure[WallChoice::most] = {0, 0, 0};  ///< of each wall along its normal [force]
  Vec3 friction = Vec3::Zero();                   ///< of all walls on the node [force]
};

struct WallQuestion {
  std::span<const WallMeeting> meetings;  ///< at most WallChoice::most
  Mat3 free = Mat3::Identity();           ///< projector on the directions that supports leave free
  Vec3 left = Vec3::Zero();               ///< left without walls, along `free`: inertia less what acts [force]
  Vec3 travel = Vec3::Zero();             ///< since t_n, that which supports give included [length]
  Vec3 friction_before = Vec3::Zero();    ///< at t_n [force]
  double stiffness = 0;                   ///< of held directions in the matrix: does not enter pressures [force/length]
  bool first = false;  ///< the first iterate of a step: the choice given stands, and what lies behind a wall is pressed
  Mat3 tied = Mat3::Zero();  ///< projector on directions along which ties hold the node in its walls
};

/// The primal-dual active set: a wall presses where pressure - stiffness gap > 0. Friction is a spring of `sticking`
/// times the stiffness between the node and the walls, from its force at t_n on, that gives way where Coulomb's law
/// does (Hueber and Wohlmuth 2005; return mapping: J. C. Simo, T. A. Laursen 1992).
WallAction act(const WallQuestion& question, const WallChoice& solved);

/// Stiffness of sticking over that of held directions, which is about that of an element: at stresses of the order of
/// the modulus a node slips by a tenth of an edge before it slides. As in mortar contact.
constexpr double sticking_at_walls = 10;

}  // namespace brunt::implicit
