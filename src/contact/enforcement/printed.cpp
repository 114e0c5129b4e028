// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/printed.hpp"

#include "contact/enforcement/rate_constraint.hpp"

namespace brunt::contact {

EnforcementResult enforce_printed(const System& system, const EnforcementSettings& settings, double dt,
                                  Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                  EnforcementScratch& scratch) {
  const double violation = start_from_prediction(system, exchange, velocity);
  for (Vec3& impulse : impulses) impulse.setZero();
  if (violation == 0) return {};
  form_row_sums(system, exchange, scratch);
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const double slab = system.rows.figures[q].slab;
    if (slab > 0 && scratch.diagonal[q] > 0) scratch.diagonal[q] = system.mobility_scale / (slab * dt);
  }
  constexpr bool coupled = true;  // the printed H is exact nowhere
  return iterate(system, settings, StepLength::row_sum, coupled, violation, exchange, impulses, velocity, scratch);
}

}  // namespace brunt::contact
