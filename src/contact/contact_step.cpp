// SPDX-License-Identifier: Apache-2.0
// Contact in one time step, the central file: gather, detect, assemble rows, solve, store history, scatter, record
// work.
//
//   rows:   G v >= required, friction across the normals       of positions x_n, predicted velocities v* and history
//   solve:  v = v* + W G^T p, p admitted by the rows           iterated; W the mobility of the nodes
//   book:   work and impulses of p, for the ledger at t_n
#include <algorithm>

#include "assemble_rows.hpp"
#include "book.hpp"
#include "contact/contact.hpp"
#include "detect.hpp"
#include "gather.hpp"
#include "impact_step.hpp"
#include "jams.hpp"
#include "watch_driven.hpp"

namespace brunt::contact {
namespace {

void begin_step(Contact& contact, double dt) {
  ++contact.ledger.statistics.steps;
  contact.ledger.clock += dt;
  contact.ledger.statistics.last = {};
  contact.step.rows.clear();
  contact.step.impulses.clear();
  contact.unmet.rows.clear();
  contact.unmet.jammed.clear();
  contact.unmet.any = false;
  contact.unmet.excess = 0;
}

/// Results of a step without candidates.
void stay_idle(Contact& contact) {
  ++contact.ledger.statistics.idle_steps;
  contact.history.clear();
}

/// Rows that contradict each other keep long steps from converging, and what these leave is arbitrary. Sweeps alone
/// never give energy, wherever they end.
EnforcementResult solve_by_sweeps(Contact& contact, const System& system, const StepInput& input, int iterations) {
  StepData& step = contact.step;
  EnforcementSettings sweeps = contact.derived.enforcement;
  sweeps.method = Method::row_sum;
  step.impulses.assign(contact.unmet.start.begin(), contact.unmet.start.end());
  EnforcementResult result = enforce(system, sweeps, input.dt, contact.lists.exchange, step.impulses,
                                     step.nodes.velocity, step.scratch.enforcement);
  result.iterations += iterations;
  return result;
}

/// Of the compressed rows.
System system_of(const Contact& contact, const StepInput& input) {
  const StepData& step = contact.step;
  return {step.scratch.enforcement.matrix, step.nodes.motion,    step.nodes.mobility,
          contact.derived.two_passes,      input.mobility_scale, carriers_of(contact, input),
          contact.lists.nodes.gid};
}

EnforcementResult solve(Contact& contact, const StepInput& input) {
  StepData& step = contact.step;
  const DerivedSettings& derived = contact.derived;
  step.impulses.assign(step.rows.size(), Vec3::Zero());
  if (derived.enforcement.warm_start)
    start_impulses(step.rows, contact.history.pairs, input.dt, step.impulses, *derived.detection.tolerances);
  if (derived.may_jam) contact.unmet.start.assign(step.impulses.begin(), step.impulses.end());
  if (derived.elastic_impact) step.scratch.impact.start.assign(step.impulses.begin(), step.impulses.end());
  EnforcementScratch& scratch = step.scratch.enforcement;
  compress(step.rows, scratch.matrix);
  lay_rows_on_bodies(carriers_of(contact, input), step.nodes.motion, scratch.carried, scratch.matrix);
  const System system = system_of(contact, input);
  const EnforcementResult result = enforce(system, derived.enforcement, input.dt, contact.lists.exchange, step.impulses,
                                           step.nodes.velocity, scratch);
  if (!derived.may_jam || !ended_at_limit(result, derived.enforcement) || result.residual < unmet_numbers.astray)
    return result;
  return solve_by_sweeps(contact, system, input, result.iterations);
}

/// Without the rows that no turn of their bodies satisfies.
EnforcementResult solve_what_can_be_met(Contact& contact, const StepInput& input) {
  EnforcementResult result = solve(contact, input);
  if (!contact.derived.may_jam) return result;
  while (drop_jammed_rows(contact, input, result)) {
    const int iterations = result.iterations;
    result = solve(contact, input);
    result.iterations += iterations;
  }
  if (!result.acted) return result;
  const EnforcementScratch& scratch = contact.step.scratch.enforcement;
  find_unmet_rows({system_of(contact, input), scratch, contact.step.impulses, contact.step.nodes.velocity},
                  unmet_numbers.remainder * contact.derived.enforcement.tolerance * result.violation,
                  contact.lists.exchange, contact.unmet);
  return result;
}

}  // namespace

void correct(Contact& contact, const StepInput& input) {
  begin_step(contact, input.dt);
  if (nothing_can_meet(contact)) return stay_idle(contact);
  gather(input, contact.list_state.gather, contact.lists, contact.step);
  detect_rows(contact, input);
  assemble_rows(contact, input);
  const bool elastic = contact.derived.elastic_impact;
  if (elastic) begin_impacts(contact, input);
  EnforcementResult result = solve_what_can_be_met(contact, input);
  if (elastic) return_energy(contact, input, system_of(contact, input), result);
  if (contact.derived.may_be_driven) watch_driven(contact, input);
  remember(contact, input);
  book_iterations(result, contact.derived.enforcement, !contact.unmet.any, contact.ledger.statistics);
  if (!result.acted) return;  // v* is unchanged
  scatter(contact, input.velocity);
  book_impulses(contact);
}

}  // namespace brunt::contact
