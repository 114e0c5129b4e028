// SPDX-License-Identifier: Apache-2.0
// Principal values and axes of symmetric tensors, all lanes at once.
#pragma once
#include <limits>

#include "core/simd.hpp"

namespace brunt::material {

/// Cyclic Jacobi rotations (C. G. J. Jacobi 1846; G. H. Golub, C. F. Van Loan, Matrix Computations, section 8.5), a
/// fixed number of sweeps: convergence is quadratic, and five leave rounding of any 3x3.
struct Principal {
  Pack value[3];
  Pack axis[3][3];  ///< axis[i][k]: component i of the axis of value k

  /// s: xx, yy, zz, xy, yz, zx.
  explicit Principal(const Pack (&s)[6]) {
    Pack A[3][3] = {{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}};
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) axis[i][k] = broadcast(i == k ? 1.0 : 0.0);
    constexpr int sweeps = 5;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      rotate(A, 0, 1);
      rotate(A, 1, 2);
      rotate(A, 0, 2);
    }
    for (int k = 0; k < 3; ++k) value[k] = A[k][k];
  }

  /// Back to xx, yy, zz, xy, yz, zx.
  void compose(Pack (&s)[6]) const {
    constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
    for (int c = 0; c < 6; ++c) {
      s[c] = Pack{};
      for (int k = 0; k < 3; ++k) s[c] += value[k] * axis[row[c]][k] * axis[column[c]][k];
    }
  }

 private:
  /// Makes A[p][q] zero: t = sign(d) / (|d| + sqrt(d^2 + 1)) with d = (A_qq - A_pp) / (2 A_pq), without that division.
  void rotate(Pack (&A)[3][3], int p, int q) {
    const Pack off = 2.0 * A[p][q], apart = A[q][q] - A[p][p];
    const Pack length = pack_abs(apart) + pack_sqrt(apart * apart + off * off);
    const Pack floor = broadcast(std::numeric_limits<double>::min());
    const Pack t = select(apart < 0.0, -off, off) / pack_max(length, floor);
    const Pack c = 1.0 / pack_sqrt(t * t + 1.0), s = t * c;
    const Pack shift = 0.5 * t * off;
    A[p][p] -= shift;
    A[q][q] += shift;
    A[p][q] = A[q][p] = Pack{};
    const int r = 3 - p - q;
    const Pack rp = A[r][p], rq = A[r][q];
    A[r][p] = A[p][r] = c * rp - s * rq;
    A[r][q] = A[q][r] = s * rp + c * rq;
    for (auto& row : axis) {
      const Pack vp = row[p], vq = row[q];
      row[p] = c * vp - s * vq;
      row[q] = s * vp + c * vq;
    }
  }
};

}  // namespace brunt::material
