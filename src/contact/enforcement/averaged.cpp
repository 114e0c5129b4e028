// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/averaged.hpp"

#include <algorithm>
#include <array>

namespace brunt::contact {
namespace {

constexpr std::array passes{Pass::first, Pass::second};

/// What a row's impulse in one of its passes counts for in the mean; each is exact.
double share_of(const RowFigures& row, Pass pass) {
  return row.pass == Pass::both || row.pass == pass ? 0.5 : 0.0;
}

/// Rows of one pass only, on any rank? Else the passes are one and the same.
bool passes_differ(const System& system, Exchange& exchange) {
  double split =
      std::ranges::any_of(system.rows.figures, [](const RowFigures& row) { return row.pass != Pass::both; }) ? 1 : 0;
  exchange.max({&split, 1});
  return split > 0;
}

/// Every row asks for what it requires, and each pass starts from the impulses of the mean.
void start_passes(const System& system, std::span<const Vec3> impulses, EnforcementScratch& scratch) {
  scratch.asked.clear();
  for (std::vector<Vec3>& start : scratch.start) start.clear();
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    scratch.asked.push_back(system.rows.laws[q].required);
    for (std::size_t k = 0; k < passes.size(); ++k)
      scratch.start[k].push_back(system.rows.figures[q].pass == passes[k] ? Vec3(2 * impulses[q]) : impulses[q]);
  }
}

/// Solves the rows of one pass, adds its share to the sum and keeps its impulses to start from.
EnforcementResult solve_pass(std::size_t k, const System& system, const EnforcementSettings& settings, double dt,
                             Exchange& exchange, std::span<Vec3> sum, std::span<Vec3> velocity,
                             EnforcementScratch& scratch) {
  scratch.pass_rows.clear();
  scratch.pass_impulses.clear();
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    if (share_of(system.rows.figures[q], passes[k]) == 0) continue;
    scratch.pass_rows.append(system.rows, q);
    scratch.pass_rows.laws.back().required = scratch.asked[q];
    scratch.pass_impulses.push_back(scratch.start[k][q]);
  }
  const System rows{scratch.pass_rows,     system.motion,   system.mobility, false,
                    system.mobility_scale, system.carriers, system.gid};
  const EnforcementResult result = enforce(rows, settings, dt, exchange, scratch.pass_impulses, velocity, scratch);
  std::size_t next = 0;
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const double share = share_of(system.rows.figures[q], passes[k]);
    if (share == 0) continue;
    scratch.start[k][q] = scratch.pass_impulses[next++];
    sum[q] += share * scratch.start[k][q];
  }
  return result;
}

/// Solves both passes and applies the mean of their impulses, unless there is none.
void solve_both(const System& system, const EnforcementSettings& settings, double dt, Exchange& exchange,
                std::span<Vec3> impulses, std::span<Vec3> velocity, EnforcementScratch& scratch,
                EnforcementResult& result) {
  std::fill(impulses.begin(), impulses.end(), Vec3::Zero());
  int iterations = 0;
  for (std::size_t k = 0; k < passes.size(); ++k) {
    const EnforcementResult one = solve_pass(k, system, settings, dt, exchange, impulses, velocity, scratch);
    result.violation = std::max(result.violation, one.violation);
    result.residual = std::max(result.residual, one.residual);
    iterations = std::max(iterations, one.iterations);
    result.acted = result.acted || one.acted;
    result.scaled_islands += one.scaled_islands;
    result.least_share = std::min(result.least_share, one.least_share);
  }
  result.iterations += iterations;
  if (!result.acted) return;
  if (!system.carriers.bodies.empty())  // of the rows of both passes
    start_bodies(system.carriers, system.motion, system.rows, exchange, scratch.carried);
  double largest = largest_impulse_on_a_node(system.rows, impulses);
  exchange.max({&largest, 1});
  demand_finite(largest);
  apply_impulses(system, impulses, largest, exchange, velocity, scratch);
}

/// Raises what rows of one pass ask for to asked_back. least: what is left below it is the iteration's own error.
/// Is there any such row, on any rank?
bool ask_back(const System& system, double least, Exchange& exchange, std::span<const Vec3> velocity,
              EnforcementScratch& scratch) {
  double any = 0;
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    if (system.rows.figures[q].pass == Pass::both) continue;
    const RowLaw& law = system.rows.laws[q];
    const double averaged = law.normal.dot(relative_velocity(system.rows, q, velocity));
    if (law.required - averaged <= least) continue;
    const double predicted = law.normal.dot(relative_velocity(
        system.rows, q, [&](LocalIndex node) -> const Vec3& { return nth(system.motion, node).predicted; }));
    scratch.asked[q] = asked_back(law.required, predicted, averaged);
    if (scratch.asked[q] > law.required) any = 1;
  }
  exchange.max({&any, 1});
  return any > 0;
}

/// The others close gaps by themselves.
bool asks_back(Method method) {
  return method == Method::rate || method == Method::row_sum || method == Method::printed ||
         method == Method::reference;
}

}  // namespace

double asked_back(double required, double predicted, double averaged) {
  const double left = required - averaged;
  return left > 0 ? std::max(required, std::min(required + 2 * left, -predicted)) : required;
}

EnforcementResult enforce_averaged(const System& system, const EnforcementSettings& settings, double dt,
                                   Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                   EnforcementScratch& scratch) {
  if (!passes_differ(system, exchange))
    return enforce(
        {system.rows, system.motion, system.mobility, false, system.mobility_scale, system.carriers, system.gid},
        settings, dt, exchange, impulses, velocity, scratch);
  start_passes(system, impulses, scratch);
  EnforcementResult result;
  solve_both(system, settings, dt, exchange, impulses, velocity, scratch, result);
  if (!result.acted || !asks_back(settings.method)) return result;
  if (!ask_back(system, settings.tolerance * result.violation, exchange, velocity, scratch)) return result;
  EnforcementSettings again = settings;
  again.warm_start = true;
  solve_both(system, again, dt, exchange, impulses, velocity, scratch, result);
  return result;
}

}  // namespace brunt::contact
