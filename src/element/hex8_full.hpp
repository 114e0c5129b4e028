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
#include <type_traits>
#include <vector>

#include "core/dual.hpp"
#include "element/batch.hpp"
#include "element/bulk_viscosity.hpp"
#include "element/hex8_frequency.hpp"
#include "element/hex8_modes.hpp"
#include "element/hex8_point.hpp"
#include "element/logarithmic_rate.hpp"
#include "element/memory.hpp"
#include "element/objective.hpp"
#include "element/options.hpp"

namespace brunt::element {

namespace hex8_full_detail {

/// Sums over the eight points.
template <class Number>
struct ForceSums {
  Number force[3][hex_modes]{};  ///< on the modes of the velocity
  Number pressure{};             ///< sum of weight times mean stress, where B-bar
};

/// Sums for the stable step.
struct BoundSums {
  HourglassGram gram;
  Pack lambda = broadcast(0.0), mu = broadcast(0.0);  ///< largest current tangent
  Pack smallest_det = broadcast(HUGE_VAL);
};

template <class Number>
BRUNT_INLINE void coordinate_modes(const Number (&u)[3][8], Number (&mode)[hex_modes][3]) {
  for (int i = 0; i < 3; ++i) {
    Number of_component[hex_modes];
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
BRUNT_INLINE Dual cube_root(const Dual& a) {
  const Pack root = cube_root(a.value);
  return {root, (1.0 / 3.0) * root / a.value * a.slope};
}

template <class Number>
BRUNT_INLINE void deformation_gradient(const HexPoint& p, const Number (&x)[hex_modes][3],
                                       const Pack (&X)[hex_modes][3], Number (&F)[9]) {
  Number now[9];
  Pack reference[9];
  parent_gradient(p, x, now);
  parent_gradient(p, X, reference);
  space_gradient(now, reference, F);
}

template <class Number>
BRUNT_INLINE Number determinant(const Number (&F)[9]) {
  Number K[9];
  return cofactors(F, K);
}

/// Stress in `s` to parent forces; the mean stress apart where B-bar. `weight`: of the point's volume, 1 but for
/// hyperelastic B-bar.
template <bool bbar, class Number, class Weight>
BRUNT_INLINE void add_point(const HexPoint& p, const Number (&x)[hex_modes][3], Number (&s)[6], Weight weight,
                            ForceSums<Number>& sums, BoundSums& bounds) {
  Number J[9], K[9], A[9];
  parent_gradient(p, x, J);
  const Number det = cofactors(J, K);
  if constexpr (bounds_step<Number>) {
    bounds.smallest_det = pack_min(det, bounds.smallest_det);
    bounds.gram.add(p, K, det);
  }
  if constexpr (bbar) {
    const Number mean = (s[0] + s[1] + s[2]) * (1.0 / 3.0);
    for (int i = 0; i < 3; ++i) s[i] -= mean;
    for (Number& c : s) c *= weight;
    sums.pressure += weight * det * mean;
  }
  stress_times_cofactors(s, K, A);
  subtract_parent_force(p, A, sums.force);
}

}  // namespace hex8_full_detail

template <class Response, bool bbar>
struct Hex8Full {
  static constexpr int nodes = 8;

  Response law;
  BulkViscosity bulk;

  using Memory = SolidMemory<Response, hex_points>;
  static constexpr int history_size = Memory::size;

  [[nodiscard]] std::vector<HistoryField> history() const { return Memory::fields(law); }

  template <class Number>
  void operator()(const BatchMotion<8, Number>& in, const Pack* committed, Number* trial,
                  BatchForce<8, Number>& out) const;

 private:
  /// Modes of positions, of velocities and of the midpoint's positions; rate of volume strain at the midpoint.
  template <class Number>
  struct Motion {
    Number x[hex_modes][3], v[hex_modes][3], x_mid[hex_modes][3];
    Pack X[hex_modes][3];  // of hyperelastic laws, as theta
    Number volume, volume_rate, theta;
    Pack relative_volume, viscous_work;  // of laws that are told of circumstances
    Number g[6][3];
    double dt;
  };
  template <class Number>
  using Weight = std::conditional_t<Response::hyperelastic, Number, Pack>;

  template <class Number>
  BRUNT_INLINE static void move(const BatchMotion<8, Number>& in, Motion<Number>& motion);
  template <class Number>
  BRUNT_INLINE Weight<Number> stress(const HexPoint& point, const Motion<Number>& motion,
                                     const PointMemory<const Pack>& committed, const PointMemory<Number>& trial,
                                     Number (&s)[6], hex8_full_detail::BoundSums& bounds) const;
  template <class Number>
  BRUNT_INLINE Number damp(const Motion<Number>& motion, const Number (&S)[6], const Pack* committed, Number* trial,
                           Number& work) const;
  BRUNT_INLINE auto mean_modulus(const Pack* committed) const;
};

template <class Response, bool bbar>
template <class Number>
void Hex8Full<Response, bbar>::move(const BatchMotion<8, Number>& in, Motion<Number>& motion) {
  using namespace hex8_full_detail;
  auto& [x, v, x_mid, X, volume, volume_rate, theta, relative_volume, viscous_work, g, dt] = motion;
  Number g_mid[6][3];
  dt = in.dt;
  coordinate_modes(in.x, x);
  coordinate_modes(in.v, v);
  for (int m = 0; m < hex_modes; ++m)
    for (int i = 0; i < 3; ++i) x_mid[m][i] = x[m][i] - (0.5 * in.dt) * v[m][i];
  const Number volume_mid = gradient_modes(x_mid, g_mid);
  volume = gradient_modes(x, g);
  volume_rate = broadcast(0.0);
  for (int m = 0; m < 6; ++m)
    for (int i = 0; i < 3; ++i) volume_rate += v[m][i] * g_mid[m][i];
  volume_rate /= volume_mid;
  if constexpr (Response::hyperelastic) {
    Pack G[6][3];
    coordinate_modes(in.X, X);
    theta = volume / gradient_modes(X, G);
  }
}

/// Stress at the end of the step; returns the weight of the point's volume.
template <class Response, bool bbar>
template <class Number>
auto Hex8Full<Response, bbar>::stress(const HexPoint& point, const Motion<Number>& motion,
                                      const PointMemory<const Pack>& committed, const PointMemory<Number>& trial,
                                      Number (&s)[6], hex8_full_detail::BoundSums& bounds) const -> Weight<Number> {
  using namespace hex8_full_detail;
  Weight<Number> weight = broadcast(1.0);
  [[maybe_unused]] Pack lambda, mu;
  if constexpr (Response::hyperelastic) {
    Number F[9];
    deformation_gradient(point, motion.x, motion.X, F);
    if constexpr (bbar) {
      weight = motion.theta / determinant(F);
      const Number scale = cube_root(weight);
      for (Number& entry : F) entry *= scale;
    }
    law.stress(F, s);
    if constexpr (bounds_step<Number>) law.tangent(F, lambda, mu);
    for (int c = 0; c < 6; ++c) trial.stress[c] = s[c];
  } else {
    Number v_parent[9], x_parent[9], L[9];
    parent_gradient(point, motion.v, v_parent);
    parent_gradient(point, motion.x_mid, x_parent);
    space_gradient(v_parent, x_parent, L);
    if constexpr (bbar) {
      const Number correction = (motion.volume_rate - (L[0] + L[4] + L[8])) * (1.0 / 3.0);
      for (int i = 0; i < 3; ++i) L[4 * i] += correction;
    }
    const StrainStep<Number> strain = strain_step_of<Response>(L, motion.dt, committed, trial);
    if constexpr (Thermodynamic<Response>) {
      Pack relative = motion.relative_volume;
      if constexpr (!bbar && Response::at_volume >= 0)
        relative = committed.scalars[Response::at_volume * committed.stride] * volume_ratio(L, motion.dt);
      update_stress(law, strain, {motion.dt, relative, motion.viscous_work}, committed, trial, s, lambda, mu);
    } else {
      update_stress(law, strain, committed, trial, s);
      if constexpr (bounds_step<Number>) law.tangent(s, lambda, mu);
    }
  }
  if constexpr (bounds_step<Number>) {
    bounds.lambda = pack_max(weight * lambda, bounds.lambda);
    bounds.mu = pack_max(weight * mu, bounds.mu);
  }
  return weight;
}

/// Viscosity of the element; `work`: what it did in the step.
template <class Response, bool bbar>
template <class Number>
Number Hex8Full<Response, bbar>::damp(const Motion<Number>& motion, const Number (&S)[6], const Pack* committed,
                                      Number* trial, Number& work) const {
  const Number rho_length2 = committed[Memory::at_mass] * motion.volume / (2.0 * largest_eigenvalue_bound(S));
  const Number viscosity = bulk_viscosity(bulk, mean_modulus(committed), rho_length2, motion.volume_rate);
  work = book_bulk_work(committed + Memory::at_bulk_energy, trial + Memory::at_bulk_energy,
                        viscosity * motion.volume_rate, motion.volume, motion.volume_rate, motion.dt);
  return viscosity;
}

/// rho c^2 of pressure waves, mean of the points where it changes.
template <class Response, bool bbar>
auto Hex8Full<Response, bbar>::mean_modulus(const Pack* committed) const {
  if constexpr (Thermodynamic<Response>) {
    Pack sum{};
    for (int p = 0; p < hex_points; ++p) sum += wave_modulus(law, Memory::point(committed, p));
    return sum * (1.0 / hex_points);
  } else {
    return law.lambda + 2.0 * law.mu;
  }
}

template <class Response, bool bbar>
template <class Number>
void Hex8Full<Response, bbar>::operator()(const BatchMotion<8, Number>& in, const Pack* committed, Number* trial,
                                          BatchForce<8, Number>& out) const {
  using namespace hex8_full_detail;
  Motion<Number> motion;
  move(in, motion);
  const auto& [x, v, x_mid, X, volume, volume_rate, theta, relative_volume, viscous_work, g, dt] = motion;
  Number S[6], work;
  gradient_gram(g, S);
  const Pack mass = committed[Memory::at_mass];
  const Number viscosity = damp(motion, S, committed, trial, work);
  if constexpr (Thermodynamic<Response>) {
    const Pack over_reference = law.density / mass;
    motion.relative_volume = volume * over_reference;
    motion.viscous_work = work * over_reference;
  }

  ForceSums<Number> sums;
  BoundSums bounds;
  for (int p = 0; p < hex_points; ++p) {
    const HexPoint point(p);
    Number s[6];
    const auto weight = stress(point, motion, Memory::point(committed, p), Memory::point(trial, p), s, bounds);
    add_point<bbar>(point, x, s, weight, sums, bounds);
  }

  const Number through_mean = viscosity * volume_rate + sums.pressure / volume;
  for (int i = 0; i < 3; ++i) {
    for (int m = 0; m < 6; ++m) sums.force[i][m] -= through_mean * g[m][i];
    from_modes(sums.force[i], out.f[i]);
  }

  if constexpr (bounds_step<Number>) {
    const Pack point_modulus = bbar ? 2.0 * bounds.mu : 3.0 * bounds.lambda + 2.0 * bounds.mu;
    BatchStiffness& linear = out.stiffness;
    linear.lambda = bounds.lambda;
    linear.mu = bounds.mu;
    linear.viscosity = viscosity;
    const Pack stiffness =
        largest_stiffness(x, g, volume, S, bounds.gram, bounds.lambda, bounds.mu, point_modulus, linear.spring);
    linear.plane2 = (8.0 / mass) * ((bounds.lambda + 2.0 * bounds.mu) * largest_eigenvalue_bound(S) * (1.0 / volume));
    const Pack damping = (8.0 / mass) * viscosity * (S[0] + S[1] + S[2]) / volume;
    out.rate = stable_rate((8.0 / mass) * stiffness, damping);
    out.volume = select(volume > 0.0, 8.0 * bounds.smallest_det, volume);  // a NaN appears in the volume
  }
}

}  // namespace brunt::element
