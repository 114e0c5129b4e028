// SPDX-License-Identifier: Apache-2.0
#include "impact_step.hpp"

#include <algorithm>

#include "contact/data/tolerances.hpp"

namespace brunt::contact {
namespace {

/// Not ties, rows that yield, rows that cannot be satisfied, or rows that recover an overlap.
bool may_return(const Contact& contact, std::size_t q) {
  const Row& row = contact.step.rows[q];
  if (row.holds || row.cone != Cone::compression || row.softness > 0 || contact.unmet.is(q)) return false;
  return row.gap >= -contact.derived.detection.tolerances->ledge * contact.surface.mean_edge;
}

double flow_around(const RowMatrix& rows, std::size_t q, std::span<const double> flow) {
  double sum = 0;
  for (std::size_t k = rows.begin(q); k < rows.end(q) && !flow.empty(); ++k) sum += flow[rows.point(k)];
  return sum;
}

void collect_rows(Contact& contact, double dt, const System& system) {
  StepData& step = contact.step;
  ImpactScratch& impact = step.scratch.impact;
  impact.rows.assign(step.rows.size(), {});
  impact.states.resize(step.rows.size());
  read_impacts(step.rows, contact.history.impacts, impact.states);
  for (std::size_t q = 0; q < step.rows.size(); ++q) {
    if (!may_return(contact, q)) continue;
    ImpactRow& row = impact.rows[q];
    row.transit = transit_of(system.rows, q, step.nodes.transit);
    if (!(row.transit > 0)) continue;
    row.state = impact.states[q];
    row.step = impact_step(system, q, step.nodes.transit, dt, step.impulses[q], step.nodes.velocity);
    row.step.flow = flow_around(system.rows, q, impact.flow);
  }
}

}  // namespace

void begin_impacts(Contact& contact, const StepInput& input) {
  ImpactScratch& impact = contact.step.scratch.impact;
  impact.flow.clear();
  if (input.flow.empty()) return;
  impact.flow.resize(contact.lists.nodes.gid.size(), 0.0);
  for (const auto& [contact_node, node] : contact.list_state.gather.nodes)
    nth(impact.flow, contact_node) = nth(input.flow, node);
  contact.lists.exchange.share(impact.flow, 1);
}

void return_energy(Contact& contact, const StepInput& input, const System& system, EnforcementResult& result) {
  StepData& step = contact.step;
  ImpactScratch& impact = step.scratch.impact;
  collect_rows(contact, input.dt, system);
  impact.returned = false;
  if (!contact.unmet.any)
    return_at_opening(system, step.scratch.enforcement.matrix, contact.derived.enforcement, input.dt,
                      contact.lists.exchange, step.impulses, step.nodes.velocity, step.scratch.enforcement, impact,
                      result);
  follow_impacts(system, input.dt, step.impulses, step.nodes.velocity, impact);
  write_impacts(step.rows, impact.states, contact.history.impacts);
}

}  // namespace brunt::contact
