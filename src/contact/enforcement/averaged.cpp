// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/enforcement/averaged.hpp"

#include <algorithm>
#include <array>

namespace brunt::contact {
namespace {

constexpr std::array passes{Pass::first, Pass::second};

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

/// Each pass starts from the impulses of the mean.
void start_passes(const System& system, std::span<const Vec3> impulses, EnforcementScratch& scratch) {
  for (std::vector<Vec3>& start : scratch.start) start.clear();
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const Row& row = system.rows[q];
    for (std::size_t k = 0; k < passes.size(); ++k)
      scratch.start[k].push_back(row.pass == passes[k] ? Vec3(2 * impulses[q]) : impulses[q]);
  }
}

/// Solves the rows of one pass and adds its share to the sum.
EnforcementResult solve_pass(std::size_t k, const System& system, const EnforcementSettings& settings, double dt,
                             Exchange& exchange, std::span<Vec3> sum, std::span<Vec3> velocity,
                             EnforcementScratch& scratch) {
  scratch.pass_rows.clear();
  scratch.pass_impulses.clear();
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    if (share_of(system.rows[q], passes[k]) == 0) continue;
    scratch.pass_rows.push_back(system.rows[q]);
    scratch.pass_impulses.push_back(scratch.start[k][q]);
  }
  const System rows{scratch.pass_rows, system.motion, system.mobility};
  const EnforcementResult result = enforce(rows, settings, dt, exchange, scratch.pass_impulses, velocity, scratch);
  std::size_t next = 0;
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const double share = share_of(system.rows[q], passes[k]);
    if (share == 0) continue;
    sum[q] += share * scratch.pass_impulses[next++];
  }
  return result;
}

}  // namespace

EnforcementResult enforce_averaged(const System& system, const EnforcementSettings& settings, double dt,
                                   Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                   EnforcementScratch& scratch) {
  if (!passes_differ(system, exchange))
    return enforce({system.rows, system.motion, system.mobility}, settings, dt, exchange, impulses, velocity, scratch);
  start_passes(system, impulses, scratch);
  EnforcementResult result;
  std::fill(impulses.begin(), impulses.end(), Vec3::Zero());
  for (std::size_t k = 0; k < passes.size(); ++k) {
    const EnforcementResult one = solve_pass(k, system, settings, dt, exchange, impulses, velocity, scratch);
    result.violation = std::max(result.violation, one.violation);
    result.residual = std::max(result.residual, one.residual);
    result.iterations = std::max(result.iterations, one.iterations);
    result.acted = result.acted || one.acted;
  }
  if (!result.acted) return result;
  double largest = largest_impulse_on_a_node(system.rows, impulses);
  exchange.max({&largest, 1});
  demand_finite(largest);
  apply_impulses(system, impulses, largest, exchange, velocity, scratch);
  return result;
}

}  // namespace brunt::contact
