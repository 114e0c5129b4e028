// SPDX-License-Identifier: Apache-2.0
// J2 plasticity with associated flow and mixed isotropic-kinematic hardening, by radial return.
#pragma once
#include <limits>
#include <type_traits>

#include "core/dual.hpp"
#include "material/elastic.hpp"
#include "material/law.hpp"
#include "material/yield_curve.hpp"

namespace brunt::material {

/// Result of a return: increment of the equivalent plastic strain, and displacement of the centre of the yield surface.
template <class Number>
struct PlasticReturn {
  Number strain, centre;
};

/// Yield stress linear in the plastic strain: closed form.
class LinearHardening {
 public:
  LinearHardening(const J2& constants, double shear_modulus)
      : yield_(constants.yield),
        isotropic_slope_((1 - constants.kinematic) * constants.hardening),
        kinematic_slope_(constants.kinematic * constants.hardening),
        inverse_stiffness_(1 / (3 * shear_modulus + constants.hardening)) {}

  template <class Number>
  [[nodiscard]] PlasticReturn<Number> close(Number equivalent, Number plastic_strain) const {
    const Number excess = equivalent - (yield_ + isotropic_slope_ * plastic_strain);
    const Number increment = pack_max(excess, Number{}) * inverse_stiffness_;
    return {increment, kinematic_slope_ * increment};
  }

 private:
  double yield_, isotropic_slope_, kinematic_slope_, inverse_stiffness_;
};

/// Yield stress by table: lane by lane, only if a lane may yield.
class TableHardening {
 public:
  TableHardening(const J2& constants, double shear_modulus)
      : curve_(constants.table, shear_modulus), share_(constants.kinematic), smallest_(radius(curve_.smallest())) {}

  [[nodiscard]] PlasticReturn<Pack> close(Pack equivalent, Pack plastic_strain) const {
    PlasticReturn<Pack> step{};
    if (!any(equivalent > smallest_)) return step;
    for (int lane = 0; lane < pack_width; ++lane) {
      if (!(equivalent[lane] > smallest_)) continue;
      const double before = curve_.at(plastic_strain[lane]);
      const double excess = equivalent[lane] - radius(before);
      if (!(excess > 0)) continue;
      const double increment = curve_.plastic_increment(plastic_strain[lane], excess);
      step.strain[lane] = increment;
      step.centre[lane] = share_ * (curve_.at(plastic_strain[lane] + increment) - before);
    }
    return step;
  }

  /// With 3 G dp + dY = excess at the end of the return: dp' = excess' / (3 G + dY/dp). The plastic strain before the
  /// step is committed, and its derivative is zero.
  [[nodiscard]] PlasticReturn<Dual> close(const Dual& equivalent, const Dual& plastic_strain) const {
    const PlasticReturn<Pack> step = close(equivalent.value, plastic_strain.value);
    Pack compliance{}, hardening{};
    for (int lane = 0; lane < pack_width; ++lane) {
      if (!(step.strain[lane] > 0)) continue;
      hardening[lane] = curve_.slope_at(plastic_strain.value[lane] + step.strain[lane]);
      compliance[lane] = 1 / (curve_.three_shear() + hardening[lane]);
    }
    const Pack slope = compliance * equivalent.slope;
    return {{step.strain, slope}, {step.centre, share_ * hardening * slope}};
  }

 private:
  [[nodiscard]] double radius(double yield) const {
    return curve_.initial() + (1 - share_) * (yield - curve_.initial());
  }

  YieldCurve curve_;
  double share_, smallest_;
};

/// Radial return (M. L. Wilkins, Methods in Comput. Physics 3 (1964) 211; with back stress R. D. Krieg, S. W. Key 1976;
/// J. C. Simo, T. J. R. Hughes, Computational Inelasticity (1998), box 3.1).
/// With Y(p) the hardening curve and k the kinematic share, the yield surface has the radius
/// Y(0) + (1 - k) (Y(p) - Y(0)) and its centre moves by k dY along the flow. Then for any k the plastic strain
/// increment solves 3 G dp + dY = q_trial - radius. History: back stress (a deviator) where kinematic, then the
/// equivalent plastic strain p. `tabulated` is true exactly where constants.table is not empty, `kinematic` wherever
/// constants.kinematic > 0.
template <bool tabulated, bool kinematic>
struct J2Response {
  static constexpr bool hyperelastic = false;
  static constexpr bool logarithmic = false;
  static constexpr int tensors = kinematic ? 1 : 0;
  static constexpr int scalars = 1;

  /// Throws InputError where the table is not a hardening curve.
  explicit J2Response(const J2& constants) : J2Response(constants, initial_moduli(constants)) {}

  /// Stress, back stress (six packs) and plastic strain (one) at the end of the step. The tensors come in
  /// rotated to the end of the step; `de` is the strain increment.
  template <class Number>
  Number update(const Number (&de)[6], Number (&stress)[6], [[maybe_unused]] Number* back_stress,
                Number* plastic_strain) const {
    add_elastic_increment(lambda, mu, de, stress);
    const Number mean = (stress[0] + stress[1] + stress[2]) * (1.0 / 3.0);
    Number flow[6];  // trial stress deviator seen from the centre of the yield surface
    for (int i = 0; i < 6; ++i) {
      flow[i] = i < 3 ? stress[i] - mean : stress[i];
      if constexpr (kinematic) flow[i] -= back_stress[i];
    }
    const Number normal = flow[0] * flow[0] + flow[1] * flow[1] + flow[2] * flow[2];
    const Number shear = flow[3] * flow[3] + flow[4] * flow[4] + flow[5] * flow[5];
    // The lower bound keeps the division finite if the trial stress is zero.
    const Pack floor = broadcast(std::numeric_limits<double>::min());
    const Number equivalent = pack_max(pack_sqrt(1.5 * normal + 3.0 * shear), floor);

    const PlasticReturn<Number> step = hardening.close(equivalent, plastic_strain[0]);
    const Number inverse = 1.0 / equivalent;
    const Number back = (3.0 * mu) * step.strain * inverse;
    for (int i = 0; i < 6; ++i) {
      stress[i] -= back * flow[i];
      if constexpr (kinematic) back_stress[i] += step.centre * inverse * flow[i];
    }
    plastic_strain[0] += step.strain;
    return 1.0 - back;
  }

  /// See rate_law_tangent: plastic flow never stiffens the elastic response.
  void tangent(const Pack (&stress)[6], Pack& lambda_bound, Pack& mu_bound) const {
    rate_law_tangent(lambda, mu, stress, lambda_bound, mu_bound);
  }

  double density, lambda, mu;
  std::conditional_t<tabulated, TableHardening, LinearHardening> hardening;

 private:
  J2Response(const J2& constants, const ElasticModuli& moduli)
      : density(moduli.density), lambda(moduli.lambda), mu(moduli.mu), hardening(constants, moduli.mu) {}
};

}  // namespace brunt::material
