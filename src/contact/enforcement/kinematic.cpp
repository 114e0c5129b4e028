// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/kinematic.hpp"

namespace brunt::contact {
namespace {

/// What closes the predicted gap within the step, penetrations of before included.
Vec3 missing_gap(const RowLaw& law, double gap, const Vec3& relative, double dt) {
  Vec3 missing = missing_rate(law, relative);
  if (law.cone == Cone::compression) missing += (-gap / dt - law.required) * law.normal;
  return missing;
}

}  // namespace

EnforcementResult enforce_kinematic(const System& system, const EnforcementSettings& settings, double dt,
                                    Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                    EnforcementScratch& scratch) {
  EnforcementResult result{.violation = start_from_prediction(system, exchange, velocity)};
  form_diagonal(system, scratch);
  for (Vec3& impulse : impulses) impulse.setZero();
  constexpr int predictor_and_corrector = 2;
  for (int sweep = 0; sweep < predictor_and_corrector; ++sweep) {
    double largest = 0;
    for (std::size_t q = 0; q < system.rows.size(); ++q) {
      const RowLaw& law = system.rows.laws[q];
      const double h = scratch.diagonal[q];
      if (!(h > 0)) continue;
      const Vec3 missing =
          missing_gap(law, system.rows.figures[q].gap, relative_velocity(system.rows, q, velocity), dt);
      impulses[q] = admitted(law, impulses[q] + settings.partition / h * missing);
      keep_max(largest, impulses[q].norm());
    }
    exchange.max({&largest, 1});
    if (largest == 0 && !result.acted) return result;
    demand_finite(largest);
    apply_impulses(system, impulses, largest, exchange, velocity, scratch);
    ++result.iterations;
    result.acted = true;
  }
  return result;
}

}  // namespace brunt::contact
