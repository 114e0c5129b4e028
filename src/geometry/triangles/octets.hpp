// SPDX-License-Identifier: Apache-2.0
// Operations on eight doubles that g++ does not compile to one instruction.
#pragma once
#include <cstdint>
#include <type_traits>

#include "core/simd.hpp"

#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace brunt::geometry {

BRUNT_INLINE Octet octet_abs(Octet a) {
  return (Octet)((OctetMask)a & (OctetMask() + INT64_MAX));  // the same bits as another type: NOLINT
}

/// a > b ? a : b
BRUNT_INLINE Octet octet_max(Octet a, Octet b) {
#ifdef __AVX512F__
  return _mm512_maskz_max_pd(0xFF, a, b);  // without a mask g++ 12 warns of its own header
#else
  return a > b ? a : b;
#endif
}

/// Bit l: a <= b in lane l; not for NaN.
BRUNT_INLINE unsigned lanes_up_to(Octet a, Octet b) {
#if defined(__AVX512F__)
  return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ);
#elif defined(__AVX2__)
  const auto half = [&](auto low) {
    constexpr int i = low;
    const __m256d x = __builtin_shufflevector(a, a, i, i + 1, i + 2, i + 3);
    const __m256d y = __builtin_shufflevector(b, b, i, i + 1, i + 2, i + 3);
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(x, y, _CMP_LE_OQ)));
  };
  return half(std::integral_constant<int, 0>()) | half(std::integral_constant<int, 4>()) << 4;
#else
  unsigned bits = 0;
  for (int lane = 0; lane < 8; ++lane) bits |= static_cast<unsigned>(a[lane] <= b[lane]) << lane;
  return bits;
#endif
}

}  // namespace brunt::geometry
