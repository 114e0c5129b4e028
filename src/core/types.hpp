// SPDX-License-Identifier: Apache-2.0
// Index and small-vector types used in every room.
#pragma once
#include <Eigen/Core>
#include <cstdint>

namespace brunt {

using LocalIndex = std::int32_t;   ///< index into arrays of one rank
using GlobalIndex = std::int64_t;  ///< index in the canonical order of the whole model
using Rank = int;

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

constexpr LocalIndex no_index = -1;

}  // namespace brunt
