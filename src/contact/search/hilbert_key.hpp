// SPDX-License-Identifier: Apache-2.0
// Position along the three-dimensional Hilbert curve from interleaved coordinates, by table.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace brunt::contact {

constexpr int key_levels = 10;  ///< bits a coordinate

/// The curve's orientation in a cube: the corner where it enters (3 bits) and the axis along which it leaves.
/// C. Hamilton, Compact Hilbert indices, Dalhousie University CS-2006-07, section 2.
struct HilbertState {
  unsigned entry = 0, axis = 0;

  /// Number of the octant along the curve; the state becomes that in the octant.
  constexpr unsigned enter(unsigned octant) {
    const unsigned turned = rotated(octant ^ entry, 3 - (axis + 1) % 3);
    const unsigned number = turned ^ turned >> 1 ^ turned >> 2;  // of a Gray code
    const unsigned even = number == 0 ? 0 : (number - 1) & ~1U;
    entry ^= rotated(even ^ even >> 1, (axis + 1) % 3);
    const unsigned along = number == 0 ? 0 : static_cast<unsigned>(std::countr_one(number - 1 + number % 2)) % 3;
    axis = (axis + along + 1) % 3;
    return number;
  }

 private:
  static constexpr unsigned rotated(unsigned bits, unsigned by) { return (bits << by | bits >> (3 - by)) & 7U; }
};

constexpr unsigned state_count = 24;

/// table[state * 64 + two levels of octants]: the state after them times 64, and the two numbers in the lowest six
/// bits.
constexpr auto hilbert_table = [] {
  std::array<std::uint32_t, std::size_t{state_count} * 64> table{};
  for (unsigned s = 0; s < state_count; ++s)
    for (unsigned octants = 0; octants < 64; ++octants) {
      HilbertState state{s / 3, s % 3};
      const unsigned first = state.enter(octants >> 3), second = state.enter(octants & 7U);
      table[s * 64 + octants] = (state.entry * 3 + state.axis) << 6 | first << 3 | second;
    }
  return table;
}();

/// abc... -> a00b00c00...
constexpr std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 16) & 0x030000FFU;
  bits = (bits | bits << 8) & 0x0300F00FU;
  bits = (bits | bits << 4) & 0x030C30C3U;
  return (bits | bits << 2) & 0x09249249U;
}

constexpr std::size_t key_batch = 64;
using KeyBatch = std::array<std::uint32_t, key_batch>;

/// Positions along the curve of cells given by their coordinates, key_levels bits each; 3 * key_levels bits. In
/// batches, for a key is a chain of look-ups, and many chains go on at once.
inline void hilbert_keys(const std::array<KeyBatch, 3>& cells, const HilbertState& start, KeyBatch& keys) {
  static_assert(key_levels % 2 == 0);
  alignas(64) KeyBatch octants, states;
  for (std::size_t i = 0; i < key_batch; ++i)
    octants[i] = spread(cells[0][i]) | spread(cells[1][i]) << 1 | spread(cells[2][i]) << 2;
  states.fill((start.entry * 3 + start.axis) << 6);
  keys.fill(0);
  for (int shift = 3 * key_levels - 6; shift >= 0; shift -= 6)
    for (std::size_t i = 0; i < key_batch; ++i) {
      const std::uint32_t entry = hilbert_table[states[i] | (octants[i] >> shift & 63U)];
      keys[i] = keys[i] << 6 | (entry & 63U);
      states[i] = entry & ~63U;
    }
}

}  // namespace brunt::contact
