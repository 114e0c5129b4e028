// SPDX-License-Identifier: Apache-2.0
// The hexahedron with 2x2x2 integration, full or with the dilatation averaged over the element (B-bar).
//
// At each Gauss point the stress follows the velocity gradient of the midpoint configuration (objective.hpp), or the
// deformation gradient where the law is hyperelastic. B-bar (T. J. R. Hughes, Int. J. Numer. Meth. Eng. 15 (1980) 1413;
// J. C. Simo, R. L. Taylor, K. S. Pister, CMAME 51 (1985) 177): tr L_p becomes the volume's mean, and the mean stress
// acts through the mean gradient B; hyperelastic laws see F (theta/J)^(1/3), theta = V/V_0, weighted by theta V_0p, so
// that the force stays the derivative of the stored energy. Bulk viscosity acts through B, once for the element.
#pragma once
#include <bit>
#include <cmath>
#include <vector>

#include "brunt/element/batch.hpp"
#include "brunt/element/bulk_viscosity.hpp"
#include "brunt/element/hex8_frequency.hpp"
#include "brunt/element/hex8_modes.hpp"
#include "brunt/element/hex8_point.hpp"
#include "brunt/element/logarithmic_rate.hpp"
#include "brunt/element/memory.hpp"
#include "brunt/element/objective.hpp"
#include "brunt/element/options.hpp"

namespace brunt::element {

template <class Response, bool bbar>
struct Hex8Full {
  static constexpr int nodes = 8;

  Response law;
  BulkViscosity bulk;

  using Memory = SolidMemory<Response, hex_points>;
  static constexpr int history_size = Memory::size;

  static std::vector<HistoryField> history() { return Memory::fields(); }

  void operator()(const BatchMotion<8>& in, Pack* history, BatchForce<8>& out) const;
};

namespace hex8_full_detail {

/// What the eight points add up to.
struct PointSums {
  Pack force[3][hex_modes]{};                         ///< on the modes of the velocity
  HourglassGram gram;                                 ///< for the stable step
  Pack pressure{};                                    ///< sum of weight times mean stress, where B-bar
  Pack lambda = broadcast(0.0), mu = broadcast(0.0);  ///< largest current tangent
  Pack smallest_det = broadcast(HUGE_VAL);
};

BRUNT_INLINE void coordinate_modes(const Pack (&u)[3][8], Pack (&mode)[hex_modes][3]) {
  for (int i = 0; i < 3; ++i) {
    Pack of_component[hex_modes];
    to_modes(u[i], of_component);
    for (int m = 0; m < hex_modes; ++m) mode[m][i] = of_component[m];
  }
}

/// Cube root of a > 0: a third of the exponent and mantissa read as one number is within 5 %, and three of Halley's
/// cubic iterations bring it to rounding.
BRUNT_INLINE Pack cube_root(Pack a) {
  constexpr double third_of_bias = 0x2a9f789300000000;  // fdlibm, s_cbrt.c
  const Pack bits = __builtin_convertvector(std::bit_cast<PackMask>(a), Pack);
  Pack root = std::bit_cast<Pack>(__builtin_convertvector(bits * (1.0 / 3.0) + third_of_bias, PackMask));
  for (int iteration = 0; iteration < 3; ++iteration) {
    const Pack cube = root * root * root;
    root *= (cube + 2.0 * a) / (2.0 * cube + a);
  }
  return root;
}

BRUNT_INLINE void deformation_gradient(const HexPoint& p, const Pack (&x)[hex_modes][3], const Pack (&X)[hex_modes][3],
                                       Pack (&F)[9]) {
  Pack now[9], reference[9];
  parent_gradient(p, x, now);
  parent_gradient(p, X, reference);
  space_gradient(now, reference, F);
}

BRUNT_INLINE Pack determinant(const Pack (&F)[9]) {
  Pack K[9];
  return cofactors(F, K);
}

/// Stress in `s` to parent forces; the mean stress apart where B-bar. `weight`: of the point's volume, 1 but for
/// hyperelastic B-bar.
template <bool bbar>
BRUNT_INLINE void add_point(const HexPoint& p, const Pack (&x)[hex_modes][3], Pack (&s)[6], Pack weight,
                            PointSums& sums) {
  Pack J[9], K[9], A[9];
  parent_gradient(p, x, J);
  const Pack det = cofactors(J, K);
  sums.smallest_det = pack_min(det, sums.smallest_det);
  sums.gram.add(p, K, det);
  if constexpr (bbar) {
    const Pack mean = (s[0] + s[1] + s[2]) * (1.0 / 3.0);
    for (int i = 0; i < 3; ++i) s[i] -= mean;
    for (Pack& c : s) c *= weight;
    sums.pressure += weight * det * mean;
  }
  stress_times_cofactors(s, K, A);
  subtract_parent_force(p, A, sums.force);
}

BRUNT_INLINE void keep_largest(Pack lambda, Pack mu, PointSums& sums) {
  sums.lambda = pack_max(lambda, sums.lambda);
  sums.mu = pack_max(mu, sums.mu);
}

}  // namespace hex8_full_detail

template <class Response, bool bbar>
void Hex8Full<Response, bbar>::operator()(const BatchMotion<8>& in, Pack* history, BatchForce<8>& out) const {
  using namespace hex8_full_detail;
  Pack x[hex_modes][3], v[hex_modes][3], x_mid[hex_modes][3], g_mid[6][3], g[6][3];
  coordinate_modes(in.x, x);
  coordinate_modes(in.v, v);
  for (int m = 0; m < hex_modes; ++m)
    for (int i = 0; i < 3; ++i) x_mid[m][i] = x[m][i] - (0.5 * in.dt) * v[m][i];
  const Pack volume_mid = gradient_modes(x_mid, g_mid);
  const Pack volume = gradient_modes(x, g);
  Pack volume_rate = broadcast(0.0);
  for (int m = 0; m < 6; ++m)
    for (int i = 0; i < 3; ++i) volume_rate += v[m][i] * g_mid[m][i];
  volume_rate /= volume_mid;

  PointSums sums;
  [[maybe_unused]] Pack X[hex_modes][3], theta;
  if constexpr (Response::hyperelastic) {
    Pack G[6][3];
    coordinate_modes(in.X, X);
    theta = volume / gradient_modes(X, G);
  }
  for (int p = 0; p < hex_points; ++p) {
    const HexPoint point(p);
    Pack* stress = history + Memory::at_stress + 6 * p;
    Pack s[6], lambda, mu, weight = broadcast(1.0);
    if constexpr (Response::hyperelastic) {
      Pack F[9];
      deformation_gradient(point, x, X, F);
      if constexpr (bbar) {
        weight = theta / determinant(F);
        const Pack scale = cube_root(weight);
        for (Pack& entry : F) entry *= scale;
      }
      law.stress(F, s);
      law.tangent(F, lambda, mu);
      for (int c = 0; c < 6; ++c) stress[c] = s[c];
    } else {
      Pack v_parent[9], x_parent[9], L[9];
      parent_gradient(point, v, v_parent);
      parent_gradient(point, x_mid, x_parent);
      space_gradient(v_parent, x_parent, L);
      if constexpr (bbar) {
        const Pack correction = (volume_rate - (L[0] + L[4] + L[8])) * (1.0 / 3.0);
        for (int i = 0; i < 3; ++i) L[4 * i] += correction;
      }
      const StrainStep<Pack> strain = strain_step_of<Response>(L, in.dt, history + Memory::at_log_strain + 6 * p);
      update_stress(law, strain, stress, history + Memory::at_tensors + 6 * Response::tensors * p,
                    history + Memory::at_scalars + Response::scalars * p);
      for (int c = 0; c < 6; ++c) s[c] = stress[c];
      law.tangent(s, lambda, mu);
    }
    keep_largest(weight * lambda, weight * mu, sums);
    add_point<bbar>(point, x, s, weight, sums);
  }

  Pack S[6];
  gradient_gram(g, S);
  const Pack mass = history[Memory::at_mass];
  const Pack rho_length2 = mass * volume / (2.0 * largest_eigenvalue_bound(S));
  const Pack viscosity = bulk_viscosity(bulk, law.lambda + 2.0 * law.mu, rho_length2, volume_rate);
  book_bulk_work(history + Memory::at_bulk_energy, viscosity * volume_rate, volume, volume_rate, in.dt);
  const Pack through_mean = viscosity * volume_rate + sums.pressure / volume;
  for (int i = 0; i < 3; ++i) {
    for (int m = 0; m < 6; ++m) sums.force[i][m] -= through_mean * g[m][i];
    from_modes(sums.force[i], out.f[i]);
  }

  const Pack point_modulus = bbar ? 2.0 * sums.mu : 3.0 * sums.lambda + 2.0 * sums.mu;
  const Pack stiffness = largest_stiffness(x, g, volume, S, sums.gram, sums.lambda, sums.mu, point_modulus);
  const Pack damping = (8.0 / mass) * viscosity * (S[0] + S[1] + S[2]) / volume;
  out.rate = stable_rate((8.0 / mass) * stiffness, damping);
  out.volume = select(volume > 0.0, 8.0 * sums.smallest_det, volume);  // a NaN shows in the volume
}

}  // namespace brunt::element
