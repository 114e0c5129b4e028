// SPDX-License-Identifier: Apache-2.0
// Eight doubles that are computed together. A batch of eight elements is one Pack a quantity; what one lane
// computes never depends on what the other lanes hold, so results do not depend on how elements are batched.
#pragma once
#include <cmath>
#include <cstdint>

namespace brunt {

constexpr int pack_width = 8;

using Pack = double __attribute__((vector_size(64)));
using PackMask =
    std::int64_t __attribute__((vector_size(64)));     ///< -1 where true, 0 where false (a comparison's result)
using Quad = double __attribute__((vector_size(32)));  ///< four doubles: x, y, z and one to spare

inline Pack broadcast(double a) {
  return Pack{a, a, a, a, a, a, a, a};
}
inline Pack select(PackMask mask, Pack yes, Pack no) {
  return mask ? yes : no;
}
inline Pack pack_max(Pack a, Pack b) {
  return a > b ? a : b;
}
inline Pack pack_min(Pack a, Pack b) {
  return a < b ? a : b;
}
inline Pack pack_abs(Pack a) {
  return a < 0.0 ? -a : a;
}

inline Pack pack_sqrt(Pack a) {
  Pack root;
  for (int lane = 0; lane < pack_width; ++lane) root[lane] = std::sqrt(a[lane]);
  return root;
}

inline bool any(PackMask mask) {
  std::int64_t seen = 0;
  for (int lane = 0; lane < pack_width; ++lane) seen |= mask[lane];
  return seen != 0;
}

/// Rows become columns: a[i] lane j and a[j] lane i change places.
inline void transpose(Pack a[8]) {
#define BRUNT_SHUFFLE __builtin_shufflevector
  Pack b[8];
  for (int i = 0; i < 8; i += 2) {
    b[i] = BRUNT_SHUFFLE(a[i], a[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    b[i + 1] = BRUNT_SHUFFLE(a[i], a[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  Pack c[8];
  for (int i = 0; i < 8; i += 4) {
    for (int k = 0; k < 2; ++k) {
      c[i + k] = BRUNT_SHUFFLE(b[i + k], b[i + k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      c[i + k + 2] = BRUNT_SHUFFLE(b[i + k], b[i + k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  for (int i = 0; i < 4; ++i) {
    a[i] = BRUNT_SHUFFLE(c[i], c[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    a[i + 4] = BRUNT_SHUFFLE(c[i], c[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
#undef BRUNT_SHUFFLE
}

}  // namespace brunt
