// SPDX-License-Identifier: Apache-2.0
// Finite rotations and their derivatives. A small spatial rotation ds changes D to exp(ds) D; derivatives are by ds.
#pragma once
#include <Eigen/Geometry>

#include "core/types.hpp"

namespace brunt::rigid {

/// The rotation by |turn| [rad] about turn. Of small angles exact to rounding.
[[nodiscard]] Eigen::Quaterniond rotation_by(const Vec3& turn);

/// Axis times angle of the smaller rotation [rad].
[[nodiscard]] Vec3 rotation_vector(Eigen::Quaterniond rotation);
/// d(rotation_vector)/ds at this vector, whose length is below 2 pi.
[[nodiscard]] Mat3 rotation_vector_slope(const Vec3& turn);

/// h = axis tan(angle/2): the rotation is cay(2 h), and maps r to r' = r + 2 h x (r + r')/2. Infinite at half a
/// revolution.
[[nodiscard]] Vec3 half_turn(const Eigen::Quaterniond& rotation);
/// dh/ds.
[[nodiscard]] Mat3 half_turn_slope(const Vec3& half_turn);

}  // namespace brunt::rigid
