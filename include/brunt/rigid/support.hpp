// SPDX-License-Identifier: Apache-2.0
// Supports of a rigid body: directions of its six degrees of freedom that are held or driven.
//
// With P the projector on the free axes of rotation and g the angular velocity that is given along the others, the
// angular velocity is omega = g + P s. Supports give a moment along the other axes only, so that P l is what forces
// change, and
//   P I (g + P s) = P l,   omega = g + (P I P)^+ (l - I g),   l <- I omega.
// Over the step P l is constant in space. The body turns by R_{n+1} = exp(dt omega_m) R_n, omega_m of P l in the middle
// orientation exp(dt/2 omega_m) R_n: of second order and symmetric in time; exact where omega is constant, that is
// where one axis at most is free and drives turn about that axis or not at all: a driven angle is then met to rounding.
#pragma once
#include <span>

#include "brunt/core/types.hpp"
#include "brunt/rigid/body.hpp"

namespace brunt::rigid {

struct Support {
  Mat3 free_shift = Mat3::Identity();  ///< projector on free directions of the centre
  Mat3 free_turn = Mat3::Identity();   ///< on free axes of rotation
  bool holds_shift = false, holds_turn = false;
  [[nodiscard]] bool any() const { return holds_shift || holds_turn; }
};

/// held_shift, held_turn: directions of any length but 0; they need not be independent.
[[nodiscard]] Support make_support(std::span<const Vec3> held_shift, std::span<const Vec3> held_turn);

/// omega of the angular momentum l and of what is given; inertia: I in space.
[[nodiscard]] Vec3 supported_spin(const Mat3& free_turn, const Mat3& inertia, const Vec3& angular_momentum,
                                  const Vec3& given);

/// How the angular velocity answers a moment's impulse: (P I P)^+.
[[nodiscard]] Mat3 supported_mobility(const Mat3& free_turn, const Mat3& inertia);

/// I_n in space.
[[nodiscard]] Mat3 inertia_now(const Body& body, const BodyState& state);

/// As rigid::move, with rotations held or driven. The state's angular momentum goes with omega in the configuration at
/// the end.
void move_supported(const Body& body, const Mat3& free_turn, const Vec3& given, double dt, BodyState& state);

}  // namespace brunt::rigid
