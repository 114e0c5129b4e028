// SPDX-License-Identifier: Apache-2.0
// Natural logarithm of all lanes at once.
#pragma once
#include <bit>
#include <limits>

#include "core/dual.hpp"

namespace brunt::material {

/// ln(a) to about one unit in the last place for normal a > 0; not-a-number for a <= 0.
/// Method of fdlibm's e_log.c (Sun Microsystems 1993): a = 2^k m with m in [sqrt(1/2), sqrt(2)),
/// ln m = f - s (f - R) with f = m - 1, s = f / (2 + f), R even in s (Remez polynomial of degree 14, error 2^-58.45).
inline Pack pack_log(Pack a) {
  constexpr std::int64_t mantissa = 0x000fffffffffffff, one = 0x3ff0000000000000, root_half = 0x3fe6a09e667f3bcd;
  const PackMask bits = std::bit_cast<PackMask>(a);
  const PackMask shifted = bits + (one - root_half);
  const PackMask exponent = (shifted >> 52) - 1023;
  const PackMask reduced = (shifted & mantissa) + root_half;
  const Pack k = __builtin_convertvector(exponent, Pack);
  const Pack f = std::bit_cast<Pack>(reduced) - 1.0;
  const Pack s = f / (2.0 + f);
  const Pack z = s * s;
  Pack series = z * 1.479819860511658591e-01 + 1.531383769920937332e-01;
  series = z * series + 1.818357216161805012e-01;
  series = z * series + 2.222219843214978396e-01;
  series = z * series + 2.857142874366239149e-01;
  series = z * series + 3.999999999940941908e-01;
  series = z * series + 6.666666666666735130e-01;
  constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
  const Pack half_square = 0.5 * f * f;
  const Pack value = k * ln2_high - ((half_square - (s * (half_square + z * series) + k * ln2_low)) - f);
  return select(a > 0.0, value, broadcast(std::numeric_limits<double>::quiet_NaN()));
}

inline Dual pack_log(const Dual& a) {
  return {pack_log(a.value), a.slope / a.value};
}

}  // namespace brunt::material
