// SPDX-License-Identifier: Apache-2.0
// The doubles that are computed together, as many as one register holds. Wider packs are kept in memory between
// operations by g++ (with AVX2, a step with packs of eight took 2.2 times as long as with packs of four). A batch of
// elements has one Pack for each quantity. The result of a lane never depends on the other lanes, so results do not
// depend on how elements are grouped into batches.
#pragma once
#include <cmath>
#include <cstdint>

namespace brunt {

#ifdef __AVX512F__
constexpr int pack_width = 8;
#else
constexpr int pack_width = 4;
#endif

using Quad = double __attribute__((vector_size(32)));  ///< four doubles: x, y, z and an unused one
using QuadMask = std::int64_t __attribute__((vector_size(32)));
using Octet = double __attribute__((vector_size(64)));  ///< eight doubles, independent of the machine
using OctetMask = std::int64_t __attribute__((vector_size(64)));
using Pack = double __attribute__((vector_size(8 * pack_width)));
using PackMask =
    std::int64_t __attribute__((vector_size(8 * pack_width)));  ///< result of comparisons: -1 where true, 0 where false

/// Kernels are long sequences of operations on packs: a call that is not inlined would store and reload all of them.
/// (The build with sanitizers defines it as `inline`.)
#ifndef BRUNT_INLINE
#define BRUNT_INLINE [[gnu::always_inline]] inline
#endif

BRUNT_INLINE Pack broadcast(double a) {
  Pack all;
  for (int lane = 0; lane < pack_width; ++lane) all[lane] = a;
  return all;
}
BRUNT_INLINE Pack select(PackMask mask, Pack yes, Pack no) {
  return mask ? yes : no;
}
BRUNT_INLINE Pack pack_max(Pack a, Pack b) {
  return a > b ? a : b;
}
BRUNT_INLINE Pack pack_min(Pack a, Pack b) {
  return a < b ? a : b;
}
BRUNT_INLINE Pack pack_abs(Pack a) {
  return a < 0.0 ? -a : a;
}

BRUNT_INLINE Pack pack_sqrt(Pack a) {
  Pack root = a;
  for (int lane = 0; lane < pack_width; ++lane) root[lane] = std::sqrt(a[lane]);
  return root;
}

BRUNT_INLINE bool any(PackMask mask) {
  std::int64_t seen = 0;
  for (int lane = 0; lane < pack_width; ++lane) seen |= mask[lane];
  return seen != 0;
}

BRUNT_INLINE bool any_of_eight(OctetMask mask) {
  std::int64_t seen = 0;
  for (int lane = 0; lane < 8; ++lane) seen |= mask[lane];
  return seen != 0;
}

BRUNT_INLINE bool all(QuadMask mask) {
  return (mask[0] & mask[1] & mask[2] & mask[3]) != 0;
}

#ifdef __AVX512F__
/// The first three components of one quad per lane, component by component: x[lane] = quad(lane)[0] ... `quad(lane)` is
/// called once for each lane. Half of the moves are loads directly into the upper half of a register.
template <class QuadOfLane>
BRUNT_INLINE void components_of(const QuadOfLane& quad, Pack& x, Pack& y, Pack& z) {
  Pack pair[4];  // quads of lanes k and k+4
  for (int k = 0; k < 4; ++k) pair[k] = __builtin_shufflevector(quad(k), quad(k + 4), 0, 1, 2, 3, 4, 5, 6, 7);
  const Pack even01 = __builtin_shufflevector(pair[0], pair[1], 0, 8, 2, 10, 4, 12, 6, 14);
  const Pack odd01 = __builtin_shufflevector(pair[0], pair[1], 1, 9, 3, 11, 5, 13, 7, 15);
  const Pack even23 = __builtin_shufflevector(pair[2], pair[3], 0, 8, 2, 10, 4, 12, 6, 14);
  const Pack odd23 = __builtin_shufflevector(pair[2], pair[3], 1, 9, 3, 11, 5, 13, 7, 15);
  x = __builtin_shufflevector(even01, even23, 0, 1, 8, 9, 4, 5, 12, 13);
  y = __builtin_shufflevector(odd01, odd23, 0, 1, 8, 9, 4, 5, 12, 13);
  z = __builtin_shufflevector(even01, even23, 2, 3, 10, 11, 6, 7, 14, 15);
}

/// The inverse: pair[k] receives the quads (x, y, z, 0) of lanes k and k+4.
BRUNT_INLINE void quads_of(Pack x, Pack y, Pack z, Pack (&pair)[4]) {
  const Pack zero = broadcast(0.0);
  const Pack xy_even = __builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14);
  const Pack xy_odd = __builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15);
  const Pack z_even = __builtin_shufflevector(z, zero, 0, 8, 2, 10, 4, 12, 6, 14);
  const Pack z_odd = __builtin_shufflevector(z, zero, 1, 9, 3, 11, 5, 13, 7, 15);
  pair[0] = __builtin_shufflevector(xy_even, z_even, 0, 1, 8, 9, 4, 5, 12, 13);
  pair[1] = __builtin_shufflevector(xy_odd, z_odd, 0, 1, 8, 9, 4, 5, 12, 13);
  pair[2] = __builtin_shufflevector(xy_even, z_even, 2, 3, 10, 11, 6, 7, 14, 15);
  pair[3] = __builtin_shufflevector(xy_odd, z_odd, 2, 3, 10, 11, 6, 7, 14, 15);
}
#else
template <class QuadOfLane>
BRUNT_INLINE void components_of(const QuadOfLane& quad, Pack& x, Pack& y, Pack& z) {
  const Quad lane[4] = {quad(0), quad(1), quad(2), quad(3)};
  const Pack even01 = __builtin_shufflevector(lane[0], lane[1], 0, 4, 2, 6);
  const Pack odd01 = __builtin_shufflevector(lane[0], lane[1], 1, 5, 3, 7);
  const Pack even23 = __builtin_shufflevector(lane[2], lane[3], 0, 4, 2, 6);
  const Pack odd23 = __builtin_shufflevector(lane[2], lane[3], 1, 5, 3, 7);
  x = __builtin_shufflevector(even01, even23, 0, 1, 4, 5);
  y = __builtin_shufflevector(odd01, odd23, 0, 1, 4, 5);
  z = __builtin_shufflevector(even01, even23, 2, 3, 6, 7);
}

/// The inverse: of[k] is the quad (x, y, z, 0) of lane k.
BRUNT_INLINE void quads_of(Pack x, Pack y, Pack z, Pack (&of)[4]) {
  const Pack zero = broadcast(0.0);
  const Pack xy_even = __builtin_shufflevector(x, y, 0, 4, 2, 6), xy_odd = __builtin_shufflevector(x, y, 1, 5, 3, 7);
  const Pack z_even = __builtin_shufflevector(z, zero, 0, 4, 2, 6),
             z_odd = __builtin_shufflevector(z, zero, 1, 5, 3, 7);
  of[0] = __builtin_shufflevector(xy_even, z_even, 0, 1, 4, 5);
  of[1] = __builtin_shufflevector(xy_odd, z_odd, 0, 1, 4, 5);
  of[2] = __builtin_shufflevector(xy_even, z_even, 2, 3, 6, 7);
  of[3] = __builtin_shufflevector(xy_odd, z_odd, 2, 3, 6, 7);
}
#endif

}  // namespace brunt
