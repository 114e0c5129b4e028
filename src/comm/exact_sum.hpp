// SPDX-License-Identifier: Apache-2.0
// Exact sums of doubles, hence the same in any order and on any number of ranks: a long fixed-point accumulator over
// the whole range of double (after U. Kulisch, Computer Arithmetic and Validity, 2008), rounded once at the end.
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "comm/communicator.hpp"

namespace brunt::comm {

class ExactAccumulator {
 public:
  /// Non-finite values are counted, and the sum is then NaN. Inline, since several values are added for every
  /// constraint in a step.
  void add(double value);
  void add(const ExactAccumulator& other);
  [[nodiscard]] double round() const;  ///< nearest double to the exact sum
  void clear();

  static constexpr int limbs = 70;              // 32 bits each, carries kept in the upper halves
  [[nodiscard]] std::span<std::int64_t> raw();  ///< carries normalised: safe to add across up to 2^30 ranks

 private:
  // Bit 0 of limb 0 is 2^-1074, the smallest double. The largest double has its first bit at position 2097, in limb 65,
  // so four limbs remain for carries.
  static constexpr int limb_bits = 32;
  static constexpr std::uint64_t limb_mask = 0xffffffffu;
  // Each addition changes a limb by less than 2^32. Two accumulators with this many pending additions stay below 2^63
  // when added.
  static constexpr std::int64_t most_pending = std::int64_t{1} << 29;

  void normalise();
  std::array<std::int64_t, limbs + 1> limb_{};  // the last one counts non-finite values
  std::int64_t pending_ = 0;                    // additions since the last carry
};

inline void ExactAccumulator::add(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto biased = static_cast<std::uint32_t>(bits >> 52) & 0x7ffU;
  if (biased == 0x7ff) [[unlikely]] {
    limb_[limbs] += 1;
    return;
  }
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t significand = fraction | static_cast<std::uint64_t>(biased != 0) << 52;
  const std::uint32_t position = biased - static_cast<std::uint32_t>(biased != 0);  // of its last bit, above 2^-1074
  const std::uint32_t shift = position % limb_bits;
  const std::uint64_t low = significand << shift;  // the 53 + 31 bits in two words
  const std::uint64_t high = significand >> 1 >> (63 - shift);
  const std::int64_t sign = -static_cast<std::int64_t>(bits >> 63);  // 0, or all bits: (x ^ sign) - sign is x or -x
  const auto with_sign = [sign](std::uint64_t part) { return (static_cast<std::int64_t>(part) ^ sign) - sign; };
  std::int64_t* limb = limb_.data() + position / limb_bits;
  limb[0] += with_sign(low & limb_mask);
  limb[1] += with_sign(low >> limb_bits);
  limb[2] += with_sign(high);
  if (++pending_ >= most_pending) [[unlikely]]
    normalise();
}

/// One rounded sum over all ranks for each accumulator. Collective: one message for all of them.
void exact_sum(const Communicator& ranks, std::span<ExactAccumulator> sums, std::span<double> results);

/// Sum of all values of all ranks.
double exact_sum(const Communicator& ranks, std::span<const double> values);

}  // namespace brunt::comm
