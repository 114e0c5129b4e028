// SPDX-License-Identifier: Apache-2.0
// Derivative of a pressure force by the positions of the face on which it acts.
#pragma once
#include <array>
#include <span>

#include "core/types.hpp"

namespace brunt::force {

/// Derivatives of the force on one corner of a face under `pressure` [stress] by the positions of its three or four
/// `corners` (counter-clockwise seen from outside), in their order [force/length]. All corners have the same force (see
/// pressure_forces), so these are the derivatives for each. The matrix of a single face is not symmetric; the sum over
/// a closed surface is.
std::array<Mat3, 4> pressure_tangent(double pressure, std::span<const Vec3> corners);

}  // namespace brunt::force
