// SPDX-License-Identifier: Apache-2.0
// Exponential and powers of all lanes at once.
#pragma once
#include <bit>
#include <limits>

#include "brunt/material/logarithm.hpp"

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

}  // namespace brunt::material
