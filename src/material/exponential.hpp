// SPDX-License-Identifier: Apache-2.0
// Exponential and powers of all lanes at once.
#pragma once
#include <bit>
#include <limits>

#include "material/logarithm.hpp"

namespace brunt::material {

/// e^a to about one unit in the last place; arguments beyond +-700 count as +-700, not-a-number stays what it is.
/// Method of fdlibm's e_exp.c (Sun Microsystems 1993): a = k ln 2 + r with |r| <= ln 2 / 2, and
/// e^r = 1 + r + r c / (2 - c), c = r - r^2 P(r^2) (Remez polynomial of degree 5, error 2^-59).
inline Pack pack_exp(Pack a) {
  constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
  constexpr double over_ln2 = 1.44269504088896338700, largest = 700;
  constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to a whole number
  const Pack bounded = pack_max(pack_min(a, broadcast(largest)), broadcast(-largest));
  const Pack k = (bounded * over_ln2 + shift) - shift;
  const Pack high = bounded - k * ln2_high, low = k * ln2_low;
  const Pack r = high - low;
  const Pack t = r * r;
  Pack series = t * 4.13813679705723846039e-08 - 1.65339022054652515390e-06;
  series = t * series + 6.61375632143793436117e-05;
  series = t * series - 2.77777777770155933842e-03;
  series = t * series + 1.66666666666666019037e-01;
  const Pack c = r - t * series;
  const Pack fraction = 1.0 - ((low - r * c / (2.0 - c)) - high);
  const PackMask exponent = __builtin_convertvector(k, PackMask);
  const Pack power = std::bit_cast<Pack>((exponent + 1023) << 52);
  return select(a == a, fraction * power, a);
}

/// a^b for a >= 0 and b > 0; 0 where a is below the smallest normal number.
inline Pack pack_power(Pack a, double b) {
  const PackMask is_positive = a >= std::numeric_limits<double>::min();
  const Pack power = pack_exp(b * pack_log(select(is_positive, a, broadcast(1.0))));
  return select(is_positive, power, Pack{});
}

/// a -> a^b near an a whose power is known: (a (1 + x))^b = a^b (1 + b x + b (b - 1)/2 x^2 + ...), with six terms for
/// |x| <= 0.01 (the seventh is below 1e-14), otherwise by logarithm and exponential.
class NearPower {
 public:
  explicit NearPower(double exponent) : exponent_(exponent) {
    double factor = 1;
    for (int k = 0; k < terms; ++k) coefficient_[k] = factor *= (exponent - k) / (k + 1);
  }

  [[nodiscard]] double exponent() const { return exponent_; }

  /// power = base^b, base > 0 or power = 0.
  [[nodiscard]] Pack operator()(Pack base, Pack power, Pack now) const {
    const Pack x = now / pack_max(base, broadcast(std::numeric_limits<double>::min())) - 1.0;
    Pack series = broadcast(coefficient_[terms - 1]);
    for (int k = terms - 2; k >= 0; --k) series = coefficient_[k] + x * series;
    const PackMask far = ~(pack_abs(x) <= 0.01);
    const Pack near = power * (1.0 + x * series);
    return any(far) ? select(far, pack_power(now, exponent_), near) : near;
  }

 private:
  static constexpr int terms = 6;
  double exponent_;
  double coefficient_[terms];
};

}  // namespace brunt::material
