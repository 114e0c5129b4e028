// SPDX-License-Identifier: Apache-2.0
// Sums of doubles as integer multiples of one small unit: exact in any order, and one integer each. They suffice where
// few digits are needed (quotients that determine a step length). See core/binned_sum.hpp for sums that keep all
// digits.
#pragma once
#include <cmath>
#include <cstdint>

namespace brunt {

class FixedUnit {
 public:
  /// bound: the magnitude of the largest terms, equal on all ranks. Sums may reach 2^32 times this bound (in general
  /// 2^(62 - digits) times).
  explicit FixedUnit(double bound, int digits = 30) {
    if (!(bound > 0) || !std::isfinite(bound)) return;
    int exponent = 0;
    std::frexp(bound, &exponent);
    unit_ = std::ldexp(1.0, exponent - digits);
    per_unit_ = std::ldexp(1.0, digits - exponent);
  }
  [[nodiscard]] std::int64_t of(double term) const { return std::llrint(term * per_unit_); }
  [[nodiscard]] double value(std::int64_t sum) const { return static_cast<double>(sum) * unit_; }

 private:
  double unit_ = 0, per_unit_ = 0;  // without a bound every sum is zero
};

}  // namespace brunt
