// SPDX-License-Identifier: Apache-2.0
// Points that weights name over the corners of a face, a little beside it too.
#pragma once
#include <array>
#include <span>

#include "brunt/core/types.hpp"

namespace brunt::geometry {

/// Mean of the corners.
Vec3 middle_of(std::span<const Vec3> corners);

/// Moves the point that the weights name by what of `by` is across the normal (unit): the least change of the weights
/// that does it, sum zero. So a point beside the face is named too, by weights some of which are negative.
void shift_weights(std::span<const Vec3> corners, const Vec3& normal, const Vec3& by, std::array<double, 4>& weights);

}  // namespace brunt::geometry
