// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/enforcement/averaged.hpp"

#include <algorithm>

namespace brunt::contact {
namespace {

/// What a row's impulse in one of its passes counts for in the mean; each is exact.
double share_of(const Row& row, Pass pass) {
  return row.pass == Pass::both || row.pass == pass ? 0.5 : 0.0;
}

/// Rows of one pass only, on any rank? Else the passes are one and the same.
bool passes_differ(const System& system, Exchange& exchange) {
  double split = std::ranges::any_of(system.rows, [](const Row& row) { return row.pass != Pass::both; }) ? 1 : 0;
  exchange.max({&split, 1});
  return split > 0;
}

/// Solves the rows of one pass and adds its share to the sum. start: of all rows, the mean of before.
EnforcementResult solve_pass(Pass pass, const System& system, const EnforcementSettings& settings, double dt,
                             Exchange& exchange, std::span<const Vec3> start, std::span<Vec3> sum,
                             std::span<Vec3> velocity, EnforcementScratch& scratch) {
  scratch.pass_rows.clear();
  scratch.pass_impulses.clear();
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const Row& row = system.rows[q];
    if (share_of(row, pass) == 0) continue;
    scratch.pass_rows.push_back(row);
    scratch.pass_impulses.push_back(row.pass == pass ? Vec3(2 * start[q]) : start[q]);
  }
  const System rows{scratch.pass_rows, system.motion, system.mobility};
  const EnforcementResult result = enforce(rows, settings, dt, exchange, scratch.pass_impulses, velocity, scratch);
  std::size_t next = 0;
  for (std::size_t q = 0; q < system.rows.size(); ++q)
    if (const double share = share_of(system.rows[q], pass); share > 0) sum[q] += share * scratch.pass_impulses[next++];
  return result;
}

}  // namespace

EnforcementResult enforce_averaged(const System& system, const EnforcementSettings& settings, double dt,
                                   Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                   EnforcementScratch& scratch) {
  if (!passes_differ(system, exchange))
    return enforce({system.rows, system.motion, system.mobility}, settings, dt, exchange, impulses, velocity, scratch);
  scratch.start.assign(impulses.begin(), impulses.end());
  std::fill(impulses.begin(), impulses.end(), Vec3::Zero());
  EnforcementResult result;
  for (const Pass pass : {Pass::first, Pass::second}) {
    const EnforcementResult one =
        solve_pass(pass, system, settings, dt, exchange, scratch.start, impulses, velocity, scratch);
    result.violation = std::max(result.violation, one.violation);
    result.residual = std::max(result.residual, one.residual);
    result.iterations = std::max(result.iterations, one.iterations);
    result.acted = result.acted || one.acted;
  }
  if (!result.acted) return result;  // velocity is v*
  double largest = largest_impulse_on_a_node(system.rows, impulses);
  exchange.max({&largest, 1});
  demand_finite(largest);
  apply_impulses(system, impulses, largest, exchange, velocity, scratch);
  return result;
}

}  // namespace brunt::contact
