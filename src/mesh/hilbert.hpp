// SPDX-License-Identifier: Apache-2.0
// Position of a point along the three-dimensional Hilbert curve.
#pragma once
#include <array>
#include <cstdint>

namespace brunt::mesh {

constexpr int hilbert_bits = 21;  ///< a coordinate; three of them fill 63 bits

/// Position along the curve of the cell with the given integer coordinates, each below 2^hilbert_bits.
/// J. Skilling, Programming the Hilbert curve, AIP Conf. Proc. 707 (2004) 381-387.
std::uint64_t hilbert_position(std::array<std::uint32_t, 3> cell);

}  // namespace brunt::mesh
