// SPDX-License-Identifier: Apache-2.0
#include "comm/exact_sum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "comm/message_time.hpp"
#include "comm/native.hpp"
#include "core/error.hpp"

namespace brunt::comm {

namespace {

constexpr int lowest_exponent = -1074;

}  // namespace

void ExactAccumulator::add(const ExactAccumulator& other) {
  for (std::size_t i = 0; i <= limbs; ++i) limb_[i] += other.limb_[i];
  pending_ += other.pending_ + 1;
  if (pending_ >= most_pending) normalise();
}

void ExactAccumulator::clear() {
  limb_.fill(0);
  pending_ = 0;
}

/// All limbs but the last are normalised to [0, 2^32); the last carries the sign of the sum.
void ExactAccumulator::normalise() {
  std::int64_t carry = 0;
  for (std::size_t i = 0; i + 1 < limbs; ++i) {
    const std::int64_t total = limb_[i] + carry;
    carry = total >> limb_bits;  // arithmetic: rounds down
    limb_[i] = total & static_cast<std::int64_t>(limb_mask);
  }
  limb_[limbs - 1] += carry;
  pending_ = 0;
}

std::span<std::int64_t> ExactAccumulator::raw() {
  normalise();
  return limb_;
}

double ExactAccumulator::round() const {
  if (limb_[limbs] != 0) return std::numeric_limits<double>::quiet_NaN();
  ExactAccumulator magnitude = *this;
  magnitude.normalise();
  const bool negative = magnitude.limb_[limbs - 1] < 0;
  if (negative) {
    for (std::int64_t& limb : magnitude.limb_) limb = -limb;
    magnitude.normalise();
  }
  const auto limb = [&](int i) { return i < 0 ? 0 : static_cast<std::uint64_t>(nth(magnitude.limb_, i)); };
  int top = limbs - 1;
  while (top >= 0 && limb(top) == 0) --top;
  if (top < 0) return 0.0;

  // The leading 64 bits of the sum, in one word with its first bit set; lower bits only break ties.
  const int leading = std::countl_zero(static_cast<std::uint32_t>(limb(top)));
  const std::uint64_t upper = limb(top) << limb_bits | limb(top - 1);
  std::uint64_t word = upper << leading | (limb(top - 2) << leading) >> limb_bits;
  bool below = ((limb(top - 2) << leading) & limb_mask) != 0;
  for (int i = top - 3; i >= 0 && !below; --i) below = limb(i) != 0;

  // Exponent of the word's last bit. A sum of doubles is a multiple of 2^-1074, so a subnormal result is exact.
  const int exponent = lowest_exponent + (top - 1) * limb_bits - leading;
  constexpr int spare = 64 - 53;
  constexpr std::uint64_t half = std::uint64_t{1} << (spare - 1);
  std::uint64_t significand = word >> spare;
  const std::uint64_t rest = word & ((std::uint64_t{1} << spare) - 1);
  const bool is_odd = (significand & 1) != 0;
  if (rest > half || (rest == half && (below || is_odd))) ++significand;
  const double rounded = std::ldexp(static_cast<double>(significand), exponent + spare);
  return negative ? -rounded : rounded;
}

void exact_sum(const Communicator& ranks, std::span<ExactAccumulator> sums, std::span<double> results) {
  demand(results.size() >= sums.size(), "exact_sum has room for each result");
  static thread_local std::vector<std::int64_t> message;  // kept, so that a step allocates nothing
  constexpr std::size_t stride = ExactAccumulator::limbs + 1;
  message.resize(sums.size() * stride);
  for (std::size_t i = 0; i < sums.size(); ++i) std::ranges::copy(sums[i].raw(), message.data() + i * stride);
  count_collective(ranks, message.size() * sizeof(std::int64_t));
  {
    const MessageTime timed;
    MPI_Allreduce(MPI_IN_PLACE, message.data(), static_cast<int>(message.size()), MPI_INT64_T, MPI_SUM, native(ranks));
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    ExactAccumulator total;
    std::copy_n(message.data() + i * stride, stride, total.raw().data());
    results[i] = total.round();
  }
}

double exact_sum(const Communicator& ranks, std::span<const double> values) {
  ExactAccumulator sum;
  for (const double value : values) sum.add(value);
  double result = 0.0;
  exact_sum(ranks, {&sum, 1}, {&result, 1});
  return result;
}

}  // namespace brunt::comm
