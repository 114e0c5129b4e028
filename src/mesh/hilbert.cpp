// SPDX-License-Identifier: Apache-2.0
// Skilling's transform: undo the curve's rotations bit by bit, then Gray-decode, then interleave.
#include "hilbert.hpp"

namespace brunt::mesh {

std::uint64_t hilbert_position(std::array<std::uint32_t, 3> cell) {
  constexpr std::uint32_t top = std::uint32_t{1} << (hilbert_bits - 1);
  for (std::uint32_t bit = top; bit > 1; bit >>= 1) {
    const std::uint32_t below = bit - 1;
    for (auto& x : cell) {
      if (x & bit) {
        cell[0] ^= below;
      } else {
        const std::uint32_t swap = (cell[0] ^ x) & below;
        cell[0] ^= swap;
        x ^= swap;
      }
    }
  }
  cell[1] ^= cell[0];
  cell[2] ^= cell[1];
  std::uint32_t flip = 0;
  for (std::uint32_t bit = top; bit > 1; bit >>= 1)
    if (cell[2] & bit) flip ^= bit - 1;

  std::uint64_t position = 0;
  for (int bit = hilbert_bits - 1; bit >= 0; --bit)
    for (const auto x : cell) position = (position << 1) | (((x ^ flip) >> bit) & 1U);
  return position;
}

}  // namespace brunt::mesh
