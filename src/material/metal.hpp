// SPDX-License-Identifier: Apache-2.0
// Metals under impact. Deviator: radial return to a yield stress that depends on strain, rate, temperature and damage.
// Pressure: an equation of state or a constant bulk modulus.
//
// The rate is that of the equivalent deviatoric strain, sqrt(2/3 d':d'), averaged over about `rate_steps` steps N by
//   r <- r + 2/(N + 1) (r_now - r):
// Otherwise waves of the mesh frequency would appear in the yield stress. The total rate instead of the plastic rate is
// the usual default of crash codes; it needs no iteration, and during plastic flow the two differ by dY/dt / (3 G).
// Temperature, adiabatic: density capacity dT = taylor_quinney q dp J, with q the mean of the yield stresses before and
// after. A change of volume alone causes no heating here (the energy of the equation of state contains it). Damage: D
// grows by critical dp / e_f (Fracture). A failed point has no deviator and carries no tension; an opened point carries
// pressure again when its volume is that of the reference, -K ln J without an equation of state. With an equation of
// state, its energy includes the work of the deviator (with the mean stress) and that of bulk viscosity.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "material/circumstances.hpp"
#include "material/elastic.hpp"
#include "material/equation_of_state.hpp"
#include "material/exponential.hpp"
#include "material/law.hpp"
#include "material/logarithm.hpp"
#include "material/strength.hpp"

namespace brunt::material {

/// See RateFactor. rate >= 0.
inline Pack rate_factor(const RateFactor& law, Pack rate) {
  const Pack relative = rate * (1 / law.reference);
  switch (law.form) {
    case RateFactor::Form::logarithm:
      return 1.0 + law.c * pack_log(pack_max(relative, broadcast(1.0)));
    case RateFactor::Form::power:
      return pack_exp(law.c * pack_log(1.0 + relative));
    case RateFactor::Form::cowper_symonds:
      return 1.0 + pack_power(relative, law.c);
    case RateFactor::Form::none:
      break;
  }
  return broadcast(1.0);
}

template <bool with_eos>
struct MetalResponse {
  static constexpr bool thermodynamic = true;
  using Step = Circumstances;
  static constexpr bool hyperelastic = false;
  static constexpr bool logarithmic = false;
  static constexpr int tensors = 0;
  enum At { plastic_strain, temperature, damage, strain_rate, relative_volume, energy };
  static constexpr int scalars = with_eos ? 6 : 4;
  static constexpr int at_volume = with_eos ? relative_volume : -1;  ///< its position, if there is one

  explicit MetalResponse(const Metal& law)
      : density(law.density),
        lambda(law.bulk - 2.0 / 3.0 * law.shear),
        mu(law.shear),
        constants(law),
        strength(law),
        pressure_law(law.eos.value_or(EquationOfState{}), law.density),
        heat_of_work(law.heat.capacity > 0 ? law.heat.taylor_quinney / (law.density * law.heat.capacity) : 0) {}

  [[nodiscard]] std::array<ScalarField, scalars> fields() const {
    const std::array<ScalarField, 6> all{{{"plastic_strain", 0},
                                          {"temperature", constants.heat.start},
                                          {"damage", 0},
                                          {"strain_rate", 0},
                                          {"relative_volume", 1},
                                          {"energy", constants.eos ? constants.eos->start_energy : 0}}};
    std::array<ScalarField, scalars> mine;
    std::copy_n(all.begin(), scalars, mine.begin());
    return mine;
  }

  /// Stress and scalars at the end of the step, from the stress rotated there; returns the remaining share of the trial
  /// deviator.
  Pack update(const Pack (&de)[6], const Circumstances& step, Pack (&stress)[6], Pack* state) const {
    const Pack pressure = mean_of(stress), volume_strain = de[0] + de[1] + de[2];
    Pack old[6], now[6], strain[6];  // deviators
    for (int i = 0; i < 3; ++i) {
      old[i] = stress[i] + pressure;
      old[i + 3] = stress[i + 3];
      strain[i] = de[i] - volume_strain * (1.0 / 3.0);
      strain[i + 3] = de[i + 3];
    }
    for (int c = 0; c < 6; ++c) now[c] = old[c] + 2.0 * mu * strain[c];
    follow_rate(strain, step.dt, state);
    const PackMask failed = state[damage] >= failure();
    const Pack floor = broadcast(std::numeric_limits<double>::min());
    const Pack trial = pack_max(pack_sqrt(1.5 * square(now)), floor);
    const FlowEnd end = flow(trial, pressure, step, state, failed);
    const Pack left = select(failed, Pack{}, 1.0 - 3.0 * mu * end.increment / trial);
    for (Pack& entry : now) entry *= left;

    Pack next = pressure - constants.bulk * volume_strain;
    if constexpr (with_eos) {
      const Pack change = step.volume - state[relative_volume];
      const Pack shear = 0.5 * (step.volume + state[relative_volume]) * work(old, now, strain);
      const auto answer =
          pressure_law.close(step.volume, change, pressure, state[energy] + shear + step.viscous_work, failed);
      next = answer.pressure;
      state[energy] = answer.energy;
      state[relative_volume] = step.volume;
    }
    if constexpr (!with_eos)
      if (any(failed)) next = select(failed, pack_max(-constants.bulk * pack_log(step.volume), Pack{}), next);
    damage_by(end.increment, next, left * trial, state);
    for (int i = 0; i < 3; ++i) {
      stress[i] = now[i] - next;
      stress[i + 3] = now[i + 3];
    }
    return left;
  }

  [[nodiscard]] Pack modulus(const Pack (&stress)[6], const Pack* state) const {
    return bulk_now(stress, state) + 4.0 / 3.0 * mu;
  }

  /// See rate_law_tangent: plastic flow never stiffens the elastic response.
  void tangent(const Pack (&stress)[6], const Pack* state, Pack& lambda_bound, Pack& mu_bound) const {
    rate_law_tangent(bulk_now(stress, state) - 2.0 / 3.0 * mu, mu, stress, lambda_bound, mu_bound);
  }

  double density, lambda, mu;
  Metal constants;
  Strength strength;
  PressureLaw pressure_law;
  double heat_of_work;  ///< dT over plastic work, by reference volume

 private:
  static Pack mean_of(const Pack (&stress)[6]) { return (stress[0] + stress[1] + stress[2]) * (-1.0 / 3.0); }
  static Pack square(const Pack (&s)[6]) {
    return s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
  }
  /// Of the mean stress, by current volume.
  static Pack work(const Pack (&old)[6], const Pack (&now)[6], const Pack (&strain)[6]) {
    Pack sum{};
    for (int i = 0; i < 3; ++i) sum += 0.5 * (old[i] + now[i]) * strain[i] + (old[i + 3] + now[i + 3]) * strain[i + 3];
    return sum;
  }

  [[nodiscard]] double failure() const {
    return constants.fracture ? constants.fracture->critical : std::numeric_limits<double>::infinity();
  }

  [[nodiscard]] Pack bulk_now([[maybe_unused]] const Pack (&stress)[6], [[maybe_unused]] const Pack* state) const {
    if constexpr (with_eos)
      return pack_max(pressure_law.bulk_modulus(state[relative_volume], mean_of(stress), state[energy]), Pack{});
    else
      return broadcast(constants.bulk);
  }

  void follow_rate(const Pack (&strain)[6], double dt, Pack* state) const {
    if (dt <= 0) return;
    const Pack rate = pack_sqrt((2.0 / 3.0) * square(strain)) * (1 / dt);
    state[strain_rate] += 2 / (constants.rate_steps + 1) * (rate - state[strain_rate]);
  }

  FlowEnd flow(Pack trial, Pack pressure, const Circumstances& step, Pack* state, PackMask failed) const {
    Pack scale = rate_factor(constants.rate, state[strain_rate]);
    if (constants.fracture && constants.fracture->softens) scale *= pack_max(1.0 - state[damage], Pack{});
    const FlowStart start{trial, state[plastic_strain], state[temperature], scale, pressure, heat_of_work};
    const Yield before = strength.yield(start);
    FlowEnd end{Pack{}, before.value};
    if (!any(trial > before.value)) return end;
    end = strength.close(start, before);
    end.increment = select(failed, Pack{}, end.increment);
    state[plastic_strain] += end.increment;
    const Pack heat = with_eos ? heat_of_work * step.volume : broadcast(heat_of_work);
    state[temperature] += 0.5 * heat * (before.value + end.yield) * end.increment;
    return end;
  }

  void damage_by(Pack increment, Pack pressure, Pack equivalent, Pack* state) const {
    if (!constants.fracture || !any(increment > 0.0)) return;
    const Fracture& c = *constants.fracture;
    const Pack triaxiality = -pressure / pack_max(equivalent, broadcast(std::numeric_limits<double>::min()));
    constexpr double most = 700;  // largest exponent; beyond it the strain at fracture is practically infinite or zero
    const Pack exponent = pack_min(pack_max(c.d3 * triaxiality, broadcast(-most)), broadcast(most));
    const Pack at_rest = c.d1 + c.d2 * pack_exp(exponent);
    const Pack strain =
        at_rest * rate_factor(c.rate, state[strain_rate]) * (1.0 + c.d5 * strength.homologous(state[temperature]));
    const Pack share = select(strain > 0.0, increment / pack_max(strain, increment), broadcast(1.0));
    state[damage] =
        pack_min(state[damage] + select(increment > 0.0, c.critical * share, Pack{}), broadcast(c.critical));
  }
};

}  // namespace brunt::material
