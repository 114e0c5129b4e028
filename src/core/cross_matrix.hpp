// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/types.hpp"

namespace brunt {

/// The matrix [a]x of the cross product, [a]x b = a x b.
inline Mat3 cross_matrix(const Vec3& a) {
  Mat3 matrix;
  matrix << 0, -a[2], a[1],  //
      a[2], 0, -a[0],        //
      -a[1], a[0], 0;
  return matrix;
}

}  // namespace brunt
