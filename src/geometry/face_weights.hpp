// SPDX-License-Identifier: Apache-2.0
// Points defined by weights of the corners of a face, which may lie slightly beside it.
#pragma once
#include <array>
#include <span>

#include "core/types.hpp"

namespace brunt::geometry {

/// Mean of the corners.
Vec3 middle_of(std::span<const Vec3> corners);

/// Moves the point defined by the weights by the tangential part of `by` (perpendicular to the unit normal), with the
/// smallest change of the weights whose sum is zero. Points beside the face are thus represented by weights some of
/// which are negative.
void shift_weights(std::span<const Vec3> corners, const Vec3& normal, const Vec3& by, std::array<double, 4>& weights);

}  // namespace brunt::geometry
