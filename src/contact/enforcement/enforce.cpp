// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/enforce.hpp"

#include <cmath>

#include "chains.hpp"
#include "contact/enforcement/averaged.hpp"
#include "contact/enforcement/kinematic.hpp"
#include "contact/enforcement/penalty.hpp"
#include "contact/enforcement/printed.hpp"
#include "contact/enforcement/rate_constraint.hpp"
#include "contact/enforcement/reference.hpp"

namespace brunt::contact {

EnforcementResult enforce(const System& system, const EnforcementSettings& settings, double dt, Exchange& exchange,
                          std::span<Vec3> impulses, std::span<Vec3> velocity, EnforcementScratch& scratch) {
  if (!system.carriers.bodies.empty()) {
    note_pairs(system, scratch.carried.chains);
    start_bodies(system.carriers, system.motion, system.rows, exchange, scratch.carried);
  }
  if (system.two_passes && (settings.averaged || !holds_rates(settings.method)))
    return enforce_averaged(system, settings, dt, exchange, impulses, velocity, scratch);
  switch (settings.method) {
    case Method::rate:
      return enforce_rate_constraint(system, settings, StepLength::longer, exchange, impulses, velocity, scratch);
    case Method::row_sum:
      return enforce_rate_constraint(system, settings, StepLength::row_sum, exchange, impulses, velocity, scratch);
    case Method::printed:
      return enforce_printed(system, settings, dt, exchange, impulses, velocity, scratch);
    case Method::kinematic:
      return enforce_kinematic(system, settings, dt, exchange, impulses, velocity, scratch);
    case Method::gap_penalty:
      return enforce_penalty(system, settings, 0.0, dt, exchange, impulses, velocity, scratch);
    case Method::penalty:
      return enforce_penalty(system, settings, settings.damping, dt, exchange, impulses, velocity, scratch);
    case Method::reference:
      return enforce_reference(system, settings, exchange, impulses, velocity, scratch);
  }
  return {};
}

double step_factor(const EnforcementSettings& settings) {
  const bool spring = settings.method == Method::gap_penalty || settings.method == Method::penalty;
  return spring ? std::sqrt(1 - settings.stiffness / 4) : 1.0;
}

}  // namespace brunt::contact
