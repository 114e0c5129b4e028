// SPDX-License-Identifier: Apache-2.0
// Comparison of sixteen floats or eight doubles at once, with one bit for each lane as the result.
#pragma once
#include <bit>
#include <cstdint>

#include "core/simd.hpp"
#include "core/types.hpp"

#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace brunt::contact {

constexpr int float_lanes = 16, double_lanes = 8;
using LaneMask = std::uint16_t;  ///< bit l: lane l

/// Each comparison keeps those bits of `among` whose lane satisfies it. A NaN satisfies none.
#ifdef __AVX512F__

using FloatLanes = __m512;
using DoubleLanes = __m512d;

BRUNT_INLINE FloatLanes load(const float* from) {
  return _mm512_load_ps(from);
}
BRUNT_INLINE DoubleLanes load(const double* from) {
  return _mm512_load_pd(from);
}
BRUNT_INLINE FloatLanes every_lane(float a) {
  return _mm512_set1_ps(a);
}
BRUNT_INLINE DoubleLanes every_lane(double a) {
  return _mm512_set1_pd(a);
}
BRUNT_INLINE LaneMask not_above(LaneMask among, FloatLanes a, FloatLanes b) {
  return _mm512_mask_cmp_ps_mask(among, a, b, _CMP_LE_OQ);
}
BRUNT_INLINE LaneMask below(LaneMask among, FloatLanes a, FloatLanes b) {
  return _mm512_mask_cmp_ps_mask(among, a, b, _CMP_LT_OQ);
}
BRUNT_INLINE LaneMask not_above(LaneMask among, DoubleLanes a, DoubleLanes b) {
  return _mm512_mask_cmp_pd_mask(static_cast<__mmask8>(among), a, b, _CMP_LE_OQ);
}

#elif defined(__AVX2__)

struct FloatLanes {
  __m256 half[2];
};
struct DoubleLanes {
  __m256d half[2];
};

BRUNT_INLINE FloatLanes load(const float* from) {
  return {{_mm256_load_ps(from), _mm256_load_ps(from + 8)}};
}
BRUNT_INLINE DoubleLanes load(const double* from) {
  return {{_mm256_load_pd(from), _mm256_load_pd(from + 4)}};
}
BRUNT_INLINE FloatLanes every_lane(float a) {
  return {{_mm256_set1_ps(a), _mm256_set1_ps(a)}};
}
BRUNT_INLINE DoubleLanes every_lane(double a) {
  return {{_mm256_set1_pd(a), _mm256_set1_pd(a)}};
}
template <int Comparison>
BRUNT_INLINE LaneMask compare(LaneMask among, FloatLanes a, FloatLanes b) {
  const int low = _mm256_movemask_ps(_mm256_cmp_ps(a.half[0], b.half[0], Comparison));
  const int high = _mm256_movemask_ps(_mm256_cmp_ps(a.half[1], b.half[1], Comparison));
  return static_cast<LaneMask>(among & (low | high << 8));
}
BRUNT_INLINE LaneMask not_above(LaneMask among, FloatLanes a, FloatLanes b) {
  return compare<_CMP_LE_OQ>(among, a, b);
}
BRUNT_INLINE LaneMask below(LaneMask among, FloatLanes a, FloatLanes b) {
  return compare<_CMP_LT_OQ>(among, a, b);
}
BRUNT_INLINE LaneMask not_above(LaneMask among, DoubleLanes a, DoubleLanes b) {
  const int low = _mm256_movemask_pd(_mm256_cmp_pd(a.half[0], b.half[0], _CMP_LE_OQ));
  const int high = _mm256_movemask_pd(_mm256_cmp_pd(a.half[1], b.half[1], _CMP_LE_OQ));
  return static_cast<LaneMask>(among & (low | high << 4));
}

#else

template <class T, int Lanes>
struct PlainLanes {
  T value[Lanes];
};
using FloatLanes = PlainLanes<float, float_lanes>;
using DoubleLanes = PlainLanes<double, double_lanes>;

BRUNT_INLINE FloatLanes load(const float* from) {
  FloatLanes lanes;
  for (int l = 0; l < float_lanes; ++l) lanes.value[l] = from[l];
  return lanes;
}
BRUNT_INLINE DoubleLanes load(const double* from) {
  DoubleLanes lanes;
  for (int l = 0; l < double_lanes; ++l) lanes.value[l] = from[l];
  return lanes;
}
BRUNT_INLINE FloatLanes every_lane(float a) {
  FloatLanes lanes;
  for (float& value : lanes.value) value = a;
  return lanes;
}
BRUNT_INLINE DoubleLanes every_lane(double a) {
  DoubleLanes lanes;
  for (double& value : lanes.value) value = a;
  return lanes;
}
template <class T, int Lanes>
BRUNT_INLINE LaneMask not_above(LaneMask among, const PlainLanes<T, Lanes>& a, const PlainLanes<T, Lanes>& b) {
  unsigned mask = 0;
  for (int l = 0; l < Lanes; ++l) mask |= static_cast<unsigned>(a.value[l] <= b.value[l]) << l;
  return static_cast<LaneMask>(among & mask);
}
BRUNT_INLINE LaneMask below(LaneMask among, const FloatLanes& a, const FloatLanes& b) {
  unsigned mask = 0;
  for (int l = 0; l < float_lanes; ++l) mask |= static_cast<unsigned>(a.value[l] < b.value[l]) << l;
  return static_cast<LaneMask>(among & mask);
}

#endif

/// Writes first + l for each set bit l in ascending order and returns the end of the written part. All sixteen entries
/// from `to` must exist: those after the end are undefined.
BRUNT_INLINE LocalIndex* write_lanes(LaneMask mask, LocalIndex first, LocalIndex* to) {
#ifdef __AVX512F__
  const __m512i lane = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(mask, _mm512_add_epi32(lane, _mm512_set1_epi32(first))));
  return to + std::popcount(mask);
#else
  for (; mask != 0; mask = static_cast<LaneMask>(mask & (mask - 1))) *to++ = first + std::countr_zero(mask);
  return to;
#endif
}

}  // namespace brunt::contact
