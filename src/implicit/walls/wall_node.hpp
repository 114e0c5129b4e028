// SPDX-License-Identifier: Apache-2.0
// A node at rigid walls: along the normals of active walls its equations constrain it to their planes, along the other
// directions friction acts. No unknowns are added: pressures are the residual of the node's own balance.
#pragma once
#include <cstddef>
#include <span>

#include "core/types.hpp"

namespace brunt::implicit {

/// A wall and a node that it may meet, at one iterate.
struct WallMeeting {
  Vec3 normal = Vec3::UnitZ();  ///< unit, out of the wall
  double gap = 0;               ///< of the node at the iterate; below 0: behind the plane [length]
  double friction = 0;          ///< Coulomb's coefficient
  bool bilateral = false;       ///< constrains the node in both directions
};

/// The active walls of a node: determined anew at every iterate from those of the last linear solve.
struct WallChoice {
  static constexpr std::size_t most = 3;  ///< walls a node can touch: more are redundant
  bool active[most] = {false, false, false};
  bool slides = false;  ///< friction has reached its Coulomb limit
};

/// The node's equations and the forces of the walls.
struct WallAction {
  WallChoice choice;
  Mat3 rows = Mat3::Identity();                   ///< factor of the node's rows of the matrix
  Mat3 free = Mat3::Identity();                   ///< projector onto directions free of supports and walls
  Mat3 own = Mat3::Zero();                        ///< added to its diagonal block [force/length]
  Mat3 by_pressure = Mat3::Zero();                ///< of springs: the part of `own` by which friction follows pressure
  Vec3 left = Vec3::Zero();                       ///< residual of the node's equations [force]
  double pressure[WallChoice::most] = {0, 0, 0};  ///< of each wall along its normal [force]
  Vec3 friction = Vec3::Zero();                   ///< of all walls on the node [force]
};

struct WallQuestion {
  std::span<const WallMeeting> meetings;  ///< at most WallChoice::most
  Mat3 free = Mat3::Identity();           ///< projector onto the directions left free by supports
  Vec3 left = Vec3::Zero();             ///< residual without walls, along `free`: inertia minus applied forces [force]
  Vec3 travel = Vec3::Zero();           ///< displacement since t_n, including prescribed displacements [length]
  Vec3 friction_before = Vec3::Zero();  ///< at t_n [force]
  double stiffness = 0;      ///< of constrained directions in the matrix: does not influence pressures [force/length]
  bool first = false;        ///< the first iterate of a step: the given active set is kept, penetrated walls are active
  Mat3 tied = Mat3::Zero();  ///< projector onto directions along which ties constrain the node to its walls
};

/// The primal-dual active set: a wall is active if pressure - stiffness gap > 0. Friction is a spring of `sticking`
/// times the stiffness between the node and the walls, which starts from its force at t_n and slides by Coulomb's law
/// (Hueber and Wohlmuth 2005; return mapping: J. C. Simo, T. A. Laursen 1992).
WallAction act(const WallQuestion& question, const WallChoice& solved);

/// Sticking stiffness over that of constrained directions, which is about that of an element: at stresses of the order
/// of the modulus the elastic slip of a node is a tenth of an edge. As in mortar contact.
constexpr double sticking_at_walls = 10;

}  // namespace brunt::implicit
