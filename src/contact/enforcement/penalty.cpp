// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/penalty.hpp"

#include <algorithm>
#include <cmath>

namespace brunt::contact {
namespace {

/// Has it a spring now? Of the others nothing must be seen, not even in the row sums: which faces a node has in reach
/// depends on how the scene is turned.
bool has_spring(const RowMatrix& rows, std::size_t q) {
  return rows.laws[q].cone == Cone::free || rows.figures[q].gap < 0;
}

/// The impulse of one row's spring and damper; zero where it is open. stiffness: of springs in units of 1 / (h dt^2)
Vec3 spring_impulse(const RowLaw& law, double gap, const Vec3& missing, double stiffness, double damping, double dt,
                    double h) {
  if (law.cone == Cone::free) return admitted(law, missing / h);
  if (!(gap < 0)) return Vec3::Zero();
  const double closing = law.normal.dot(missing) - law.required;
  const double along = -stiffness * gap / dt + damping * closing;
  const Vec3 across = missing - law.normal.dot(missing) * law.normal;
  return admitted(law, (along * law.normal + across) / h);
}

}  // namespace

EnforcementResult enforce_penalty(const System& system, const EnforcementSettings& settings, double damping, double dt,
                                  Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                  EnforcementScratch& scratch) {
  const double violation = start_from_prediction(system, exchange, velocity);
  form_row_sums(system, exchange, scratch, has_spring);
  // the springs are those of the inverse masses: mass damping makes nothing stiffer
  const double stiffness = system.mobility_scale * settings.stiffness;
  double largest = 0;
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const RowLaw& law = system.rows.laws[q];
    const double h = scratch.diagonal[q];
    const Vec3 missing = missing_rate(law, relative_velocity(system.rows, q, velocity));
    impulses[q] =
        h > 0 ? spring_impulse(law, system.rows.figures[q].gap, missing, stiffness, damping, dt, h) : Vec3::Zero();
    keep_max(largest, impulses[q].norm());
  }
  exchange.max({&largest, 1});
  if (largest == 0) return {.violation = violation};
  demand_finite(largest);
  apply_impulses(system, impulses, largest, exchange, velocity, scratch);
  return {.violation = violation, .iterations = 1, .acted = true};
}

}  // namespace brunt::contact
