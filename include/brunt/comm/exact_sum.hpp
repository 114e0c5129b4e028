// SPDX-License-Identifier: Apache-2.0
// Sums of doubles that are exact, hence the same in any order and on any number of ranks: a long fixed-point
// accumulator over the whole range of double (after U. Kulisch, Computer Arithmetic and Validity, 2008),
// rounded once at the end.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "brunt/comm/communicator.hpp"

namespace brunt::comm {

class ExactAccumulator {
 public:
  void add(double value);  ///< non-finite values are remembered and returned as NaN
  void add(const ExactAccumulator& other);
  [[nodiscard]] double round() const;  ///< nearest double to the exact sum
  void clear();

  static constexpr int limbs = 70;              // 32 bits each, carries kept in the upper halves
  [[nodiscard]] std::span<std::int64_t> raw();  ///< carries normalised: safe to add across up to 2^30 ranks

 private:
  void normalise();
  std::array<std::int64_t, limbs + 1> limb_{};  // the last one counts non-finite values
  std::int64_t pending_ = 0;                    // additions since the last carry
};

/// One rounded sum over all ranks for each accumulator. Collective: one message for all of them.
void exact_sum(const Communicator& ranks, std::span<ExactAccumulator> sums, std::span<double> results);

/// Sum of all values of all ranks.
double exact_sum(const Communicator& ranks, std::span<const double> values);

}  // namespace brunt::comm
