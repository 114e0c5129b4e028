// SPDX-License-Identifier: Apache-2.0
// Jacobi's elliptic functions by the arithmetic-geometric mean (M. Abramowitz, I. A. Stegun, Handbook of Mathematical
// Functions, 16.4).
#pragma once
#include <array>
#include <cmath>

namespace brunt::support {

struct Jacobi {
  double sn = 0, cn = 1, dn = 1;
};

/// k: modulus, 0 <= k < 1.
inline Jacobi jacobi(double u, double k) {
  std::array<double, 16> a{}, c{};
  a[0] = 1;
  c[0] = k;
  double b = std::sqrt(1 - k * k);
  std::size_t n = 0;
  while (n + 1 < a.size() && std::abs(c[n]) > 1e-17) {
    a[n + 1] = 0.5 * (a[n] + b);
    c[n + 1] = 0.5 * (a[n] - b);
    b = std::sqrt(a[n] * b);
    ++n;
  }
  double phase = std::ldexp(a[n] * u, static_cast<int>(n));
  for (; n > 0; --n) phase = 0.5 * (phase + std::asin(c[n] * std::sin(phase) / a[n]));
  const double sn = std::sin(phase);
  return {sn, std::cos(phase), std::sqrt(1 - k * k * sn * sn)};
}

}  // namespace brunt::support
