// SPDX-License-Identifier: Apache-2.0
// Supports of a rigid body: constrained or driven directions of its six degrees of freedom.
//
// Let P be the projector on the free axes of rotation and g the prescribed angular velocity along the others. The
// angular velocity is omega = g + P s. Supports give a moment along the other axes only, so forces change P l only, and
//   P I (g + P s) = P l,   omega = g + (P I P)^+ (l - I g),   l <- I omega.
// Over the step P l is constant in space. The body rotates by R_{n+1} = exp(dt omega_m) R_n, with omega_m of P l at the
// middle orientation exp(dt/2 omega_m) R_n. This is of second order and symmetric in time. It is exact for constant
// omega, that is if at most one axis is free and drives rotate about this axis or not at all; a driven angle is then
// reached up to rounding.
#pragma once
#include <span>

#include "core/types.hpp"
#include "rigid/body.hpp"

namespace brunt::rigid {

struct Support {
  Mat3 free_shift = Mat3::Identity();  ///< projector on free directions of the centre
  Mat3 free_turn = Mat3::Identity();   ///< on free axes of rotation
  bool holds_shift = false, holds_turn = false;
  [[nodiscard]] bool any() const { return holds_shift || holds_turn; }
};

/// held_shift, held_turn: directions of any length but 0; they need not be independent.
[[nodiscard]] Support make_support(std::span<const Vec3> held_shift, std::span<const Vec3> held_turn);

/// omega of the angular momentum l and of the prescribed part; inertia: I in space.
[[nodiscard]] Vec3 supported_spin(const Mat3& free_turn, const Mat3& inertia, const Vec3& angular_momentum,
                                  const Vec3& given);

/// Response of the angular velocity to the impulse of a moment: (P I P)^+.
[[nodiscard]] Mat3 supported_mobility(const Mat3& free_turn, const Mat3& inertia);

/// I_n in space.
[[nodiscard]] Mat3 inertia_now(const Body& body, const BodyState& state);

/// Changes of the angular momentum by the moment of supports during a step without forces: I turns with the body, so
/// the supports supply the integral of omega x (I omega) along the axes that are not free [mass length^2/time].
struct Gyroscopic {
  Vec3 first_half = Vec3::Zero(), second_half = Vec3::Zero();  ///< up to the middle of the step, and from there
};

/// As rigid::move, with constrained or driven rotations. The angular momentum of the state corresponds to omega in the
/// configuration at the end.
Gyroscopic move_supported(const Body& body, const Mat3& free_turn, const Vec3& given, double dt, BodyState& state);

}  // namespace brunt::rigid
