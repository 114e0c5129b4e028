// SPDX-License-Identifier: Apache-2.0
// Rigid bodies of a model: constants of a run, state, and data of one step. Every rank has all bodies with the same
// bits, and those of their nodes that it holds.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "rigid/body.hpp"
#include "rigid/support.hpp"

namespace brunt::model {

/// Given properties that replace the sums over the elements of the part.
struct GivenMass {
  std::optional<double> mass;
  std::optional<Vec3> centre;       ///< less the mesh's origin
  std::optional<Mat3> inertia;      ///< about the centre
  std::optional<Vec3> reference{};  ///< the point that supports hold and drive, less the mesh's origin
};

/// Initial motion of a body: velocity of its point at the origin of the mesh, and angular velocity.
struct StartMotion {
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
};

/// A plane of symmetry of the scene.
struct MirrorPlane {
  Vec3 normal = Vec3::UnitX();
  bool touches = false;  ///< the body has nodes in it
};

struct RigidBody {
  std::string part;                  ///< whose name it has
  std::vector<std::int32_t> blocks;  ///< of its elements, that of `part` first; several parts may be one body
  GivenMass given;
  StartMotion start;
  std::vector<Vec3> held_shift, held_turn;  ///< directions that supports hold or drive
  std::array<std::optional<std::int32_t>, 6>
      drive;  ///< of x, y, z and of the rotations: index into Model::supports.drives
  std::vector<MirrorPlane> mirrors;

  rigid::MassProperties own;  ///< of its parts alone
  rigid::Body body;           ///< with the masses of deformable elements on its nodes: the body that moves
  rigid::Support support;

  std::vector<LocalIndex> nodes;   ///< on this rank, ascending
  std::vector<Vec3> arm;           ///< of each: X less the body's centre
  std::vector<LocalIndex> forced;  ///< positions in `nodes` of those on which elements or loads may act, the rank's own
  bool is_forced = false;          ///< whether there are such nodes on any rank
  bool is_jointed = false;         ///< part of a joint, or supported at a point
};

/// Sums over the steps since t = 0; doubles only, since a checkpoint stores them. Those of supports contain what the
/// turning body takes up to t_{n+1}; rows of history.csv leave out BodyStep::late_turn and late_work.
struct BodyAccount {
  double element_work = 0;  ///< of deformable elements that share nodes with the body [energy]
  double load_work = 0;     ///< of gravity, pressure, dead loads
  double damping_work = 0;
  double reaction_work = 0;                      ///< of its supports
  Vec3 load_impulse = Vec3::Zero();              ///< of loads and damping [momentum]
  Vec3 impulse = Vec3::Zero();                   ///< of all but supports
  Vec3 angular_impulse = Vec3::Zero();           ///< the same about the centre [mass length^2/time]
  Vec3 reaction_impulse = Vec3::Zero();          ///< of supports
  Vec3 reaction_angular_impulse = Vec3::Zero();  ///< about the centre
};
constexpr int body_account_width = sizeof(BodyAccount) / sizeof(double);

/// A force and its moment about a body's centre, or their impulses.
struct Wrench {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
};

/// Momentum and angular momentum of a body, with the corresponding velocities at x_n.
struct BodyMomentum {
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero(), angular_momentum = Vec3::Zero();
};

/// Data of one step.
struct BodyStep {
  Wrench elements, loads;                                         ///< forces at t_n
  Mat3 turn;                                                      ///< R_n
  Mat3 inertia, inverse;                                          ///< I_n and I_n^-1 in space
  Vec3 centre = Vec3::Zero();                                     ///< at t_n
  BodyMomentum before;                                            ///< of v_{n-1/2}
  BodyMomentum predicted;                                         ///< by forces and supports; the start of contact
  BodyMomentum after;                                             ///< of v_{n+1/2}
  Vec3 given_velocity = Vec3::Zero(), given_spin = Vec3::Zero();  ///< by drives
  Wrench reaction;                                                ///< impulses of supports at t_n
  Wrench pivot;                                                   ///< those of supports of a point, about the centre
  double pivot_work = 0;                                          ///< of the driven ones, [energy]
  double pivot_late = 0;                                          ///< the half of it that is done with v_{n+1/2}
  Vec3 late_turn = Vec3::Zero();  ///< angular impulse of supports on the turning body, from t_{n+1/2} to t_{n+1}
  double late_work = 0;           ///< work of supports on the turning body, from t_n to t_{n+1} [energy]
};

}  // namespace brunt::model
