// SPDX-License-Identifier: Apache-2.0
// The yardstick of the element benchmark: a stripped one-point hexahedron as small codes have it. Gradient at the end
// of the step only, Jaumann rate without a finite rotation, hourglass stiffness that is not turned, no bulk viscosity,
// step from sound speed and the trace of B B^T. First-order accurate in rotation: to measure against, not to use.
#pragma once
#include "element/hex8.hpp"

namespace brunt::bench {

template <class Response>
struct PrototypeHex8 {
  static constexpr int nodes = 8;
  static constexpr int history_size = 1 + 6 + Response::scalars + 12;
  Response law;
  double coefficient = 0.05;

  void operator()(const element::BatchMotion<8>& in, const Pack* /*committed*/, Pack* history,
                  element::BatchForce<8>& out) const {
    using namespace element;
    Pack x[hex_modes][3], v[hex_modes][3], g[6][3], L[9], de[6];
    vector_modes(in.x, x);
    vector_modes(in.v, v);
    const Pack volume = gradient_modes(x, g), over = 1.0 / volume;
    mean_gradient(v, g, over, L);
    Pack* stored = history + 1;
    Pack s[6];
    for (int c = 0; c < 6; ++c) s[c] = stored[c];
    const Pack xy = (0.5 * in.dt) * (L[1] - L[3]), yz = (0.5 * in.dt) * (L[5] - L[7]),
               zx = (0.5 * in.dt) * (L[6] - L[2]);
    const Pack s0 = s[0], s1 = s[1], s2 = s[2], s3 = s[3], s4 = s[4], s5 = s[5];
    s[0] += 2.0 * (xy * s3 - zx * s5);
    s[1] += 2.0 * (yz * s4 - xy * s3);
    s[2] += 2.0 * (zx * s5 - yz * s4);
    s[3] += xy * (s1 - s0) - zx * s4 + yz * s5;
    s[4] += yz * (s2 - s1) - xy * s5 + zx * s3;
    s[5] += zx * (s0 - s2) - yz * s3 + xy * s4;
    for (int i = 0; i < 3; ++i) de[i] = in.dt * L[4 * i];
    de[3] = (0.5 * in.dt) * (L[1] + L[3]);
    de[4] = (0.5 * in.dt) * (L[5] + L[7]);
    de[5] = (0.5 * in.dt) * (L[2] + L[6]);
    law.update(de, s, nullptr, history + 7);
    for (int c = 0; c < 6; ++c) stored[c] = s[c];

    Pack B2 = broadcast(0.0);
    for (int m = 0; m < 6; ++m) B2 += g[m][0] * g[m][0] + g[m][1] * g[m][1] + g[m][2] * g[m][2];
    const Pack stiffness = (coefficient * law.mu * in.dt) * B2 * over;
    Pack* hourglass = history + 7 + Response::scalars;
    Pack full[9] = {s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2]};
    Pack Q[4][3];
    for (int a = 0; a < 4; ++a)
      for (int i = 0; i < 3; ++i) {
        const Pack q = v[3 + a][i] - (L[3 * i] * x[3 + a][0] + L[3 * i + 1] * x[3 + a][1] + L[3 * i + 2] * x[3 + a][2]);
        Q[a][i] = hourglass[3 * a + i] += stiffness * q;
        for (int j = 0; j < 3; ++j) full[3 * i + j] -= over * Q[a][i] * x[3 + a][j];
      }
    for (int i = 0; i < 3; ++i) {
      Pack force[hex_modes];
      for (int m = 0; m < 6; ++m)
        force[m] = -(full[3 * i] * g[m][0] + full[3 * i + 1] * g[m][1] + full[3 * i + 2] * g[m][2]);
      force[6] = broadcast(0.0);
      for (int a = 0; a < 4; ++a) force[3 + a] -= Q[a][i];
      from_modes(force, out.f[i]);
    }
    out.rate = pack_sqrt((law.lambda + 2.0 * law.mu) / law.density * 8.0 * B2 * over * over);
    out.volume = volume;
  }
};

}  // namespace brunt::bench
