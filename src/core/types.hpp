// SPDX-License-Identifier: Apache-2.0
// Index and small-vector types used in every room.
#pragma once
#include <Eigen/Core>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace brunt {

using LocalIndex = std::int32_t;   ///< index into arrays of one rank
using GlobalIndex = std::int64_t;  ///< index in the canonical order of the whole model
using Rank = int;

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

constexpr LocalIndex no_index = -1;

/// The element of an array that an index of any integer or enumeration type names. Not for negative ones.
template <class Array, class Index>
requires std::integral<Index> || std::is_enum_v<Index>
[[nodiscard]] [[gnu::always_inline]] constexpr decltype(auto) nth(Array&& array, Index index) {
  return array[static_cast<std::size_t>(index)];
}

}  // namespace brunt
