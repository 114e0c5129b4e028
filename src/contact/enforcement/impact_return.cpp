// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/impact_return.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/enforcement/energy_guard.hpp"

namespace brunt::contact {
namespace {

constexpr std::size_t terms_of_work = 5;

/// Of row q, relative to a moving wall.
Vec3 relative_to_wall(const RowMatrix& rows, std::size_t q, std::span<const Vec3> velocity) {
  return relative_velocity(rows, q, velocity) - rows.figures[q].wall_rate * rows.laws[q].normal;
}

Vec3 before_relative_to_wall(const System& system, std::size_t q) {
  const auto before = [&](LocalIndex node) -> const Vec3& { return nth(system.motion, node).old_velocity; };
  return relative_velocity(system.rows, q, before) - system.rows.figures[q].wall_rate * system.rows.laws[q].normal;
}

/// Notes what each row that opens offers. Is there any on any rank?
bool find_offers(Exchange& exchange, std::span<ImpactRow> rows) {
  double any = 0;
  for (ImpactRow& row : rows) {
    row.offered = row.transit > 0 && opens(row.state, row.step) ? energy_to_return(row.state, row.step.flow) : 0.0;
    if (row.offered > 0) any = 1;
  }
  exchange.max({&any, 1});
  return any > 0;
}

/// Rows that offer energy require the rates that return it.
void require_returns(std::span<const ImpactRow> of_rows, std::span<const double> answer, RowMatrix& rows,
                     std::vector<double>& required) {
  required.resize(rows.size());
  for (std::size_t q = 0; q < rows.size(); ++q) {
    RowLaw& law = rows.laws[q];
    required[q] = law.required;
    if (!(of_rows[q].offered > 0) || !(answer[q] > 0)) continue;
    const double rate = returning_rate(of_rows[q].step, of_rows[q].offered, answer[q]);
    law.required = std::max(law.required, rate + rows.figures[q].wall_rate);
  }
}

/// p_0 (r_- + r_0)/2 along the normal.
double work_of_first(const ImpactStep& step) {
  return 0.5 * step.push * (step.before + step.after);
}

/// What the row may do beyond its work by p_0: w B less what p_0 gives already; or minus what it owes.
double allowance(const ImpactRow& row) {
  return row.offered > 0 ? row.offered - std::max(0.0, work_of_first(row.step)) : std::min(0.0, row.state.bank);
}

/// Of the work beyond that of p_0, linear theta + quadratic theta^2 / 2: along the normal and in all; the allowance.
std::array<double, terms_of_work> work_of_row(const System& system, std::size_t q, const Vec3& impulse,
                                              std::span<const Vec3> velocity, const ImpactScratch& impact) {
  const Vec3& normal = system.rows.laws[q].normal;
  const Vec3 rate = relative_to_wall(system.rows, q, impact.velocity);
  const Vec3 change = relative_to_wall(system.rows, q, velocity) - rate, more = impulse - impact.first[q];
  const Vec3 both = rate + before_relative_to_wall(system, q);
  return {0.5 * (normal.dot(more) * normal.dot(both) + normal.dot(impact.first[q]) * normal.dot(change)),
          normal.dot(more) * normal.dot(change), 0.5 * (more.dot(both) + impact.first[q].dot(change)), more.dot(change),
          allowance(impact.rows[q])};
}

/// theta of each island. Collective.
void find_shares(const System& system, Exchange& exchange, std::span<const Vec3> impulses,
                 std::span<const Vec3> velocity, ImpactScratch& impact) {
  const std::size_t rows = system.rows.size();
  impact.takes_part.resize(rows);
  for (std::size_t q = 0; q < rows; ++q)
    impact.takes_part[q] = impulses[q].isZero(0) && impact.first[q].isZero(0) ? 0 : 1;
  find_islands(system, impact.takes_part, exchange, impact.islands);
  impact.terms.assign(terms_of_work * rows, 0.0);
  for (std::size_t q = 0; q < rows; ++q)
    if (impact.islands.of_row[q] != no_index)
      std::ranges::copy(work_of_row(system, q, impulses[q], velocity, impact), &impact.terms[terms_of_work * q]);
  sum_over_islands(impact.terms, terms_of_work, impact.islands, exchange, impact.sums);
  impact.share.resize(impact.islands.labels.size());
  for (std::size_t i = 0; i < impact.share.size(); ++i) {
    const double* work = &impact.sums.values[terms_of_work * i];
    const double allowed = work[4];
    impact.share[i] = allowed > 0 ? std::min(share_without_gain(work[0], work[1], allowed),
                                             share_without_gain(work[2], work[3], allowed))
                                  : 0.0;
  }
}

/// p_0 + theta (p_1 - p_0). Does every row keep p_1?
bool combine(const ImpactScratch& impact, std::span<Vec3> impulses) {
  bool whole = true;
  for (std::size_t q = 0; q < impulses.size(); ++q) {
    const LocalIndex island = impact.islands.of_row[q];
    const double share = island == no_index ? 0.0 : nth(impact.share, island);
    if (share == 1) continue;
    whole = whole && impulses[q] == impact.first[q];
    impulses[q] = share == 0 ? impact.first[q] : Vec3(impact.first[q] + share * (impulses[q] - impact.first[q]));
  }
  return whole;
}

}  // namespace

void ImpactScratch::reserve(std::size_t most_rows, std::size_t nodes, std::size_t bodies) {
  for (std::vector<Vec3>* of_rows : {&start, &first}) of_rows->reserve(most_rows);
  velocity.reserve(nodes);
  flow.reserve(nodes);
  rows.reserve(most_rows);
  states.reserve(most_rows);
  required.reserve(most_rows);
  takes_part.reserve(most_rows);
  terms.reserve(terms_of_work * most_rows);
  share.reserve(most_rows);
  islands.reserve(most_rows, nodes, bodies);
}

ImpactStep impact_step(const System& system, std::size_t q, std::span<const double> transit, double dt,
                       const Vec3& impulse, std::span<const Vec3> velocity) {
  const RowMatrix& rows = system.rows;
  const Vec3& normal = rows.laws[q].normal;
  Vec3 pressed = Vec3::Zero();
  for (std::size_t k = rows.begin(q); k < rows.end(q); ++k) {
    const NodeMotion& node = system.motion[rows.point(k)];
    pressed += rows.weights[k] * transit[rows.point(k)] * (node.predicted - node.old_velocity);
  }
  return {.before = normal.dot(before_relative_to_wall(system, q)),
          .after = normal.dot(relative_to_wall(rows, q, velocity)),
          .push = normal.dot(impulse),
          .pressing = std::max(0.0, -normal.dot(pressed) / dt)};
}

double transit_of(const RowMatrix& rows, std::size_t q, std::span<const double> transit) {
  double longest = 0;
  for (std::size_t k = rows.begin(q); k < rows.end(q); ++k) longest = std::max(longest, transit[rows.point(k)]);
  return longest;
}

void return_at_opening(const System& system, RowMatrix& rows, const EnforcementSettings& settings, double dt,
                       Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                       EnforcementScratch& scratch, ImpactScratch& impact, EnforcementResult& result) {
  impact.returned = false;
  if (!find_offers(exchange, impact.rows)) return;
  if (result.violation == 0) form_row_sums(system, exchange, scratch);
  impact.first.assign(impulses.begin(), impulses.end());
  impact.velocity.assign(velocity.begin(), velocity.end());
  require_returns(impact.rows, scratch.diagonal, rows, impact.required);
  const bool soft = settings.softness > 0 || !system.carriers.bodies.empty();  // those yield from the last step's
  if (soft) std::ranges::copy(impact.start, impulses.begin());
  const EnforcementResult second = enforce(system, settings, dt, exchange, impulses, velocity, scratch);
  for (std::size_t q = 0; q < rows.size(); ++q) rows.laws[q].required = impact.required[q];
  result.iterations += second.iterations;
  bool whole = false;
  if (second.acted && !ended_at_limit(second, settings)) {
    find_shares(system, exchange, impulses, velocity, impact);
    whole = combine(impact, impulses);
    impact.returned = true;
    result.acted = true;
  } else {
    std::ranges::copy(impact.first, impulses.begin());
    for (ImpactRow& row : impact.rows) row.offered = 0;
  }
  std::array<double, 2> largest{largest_impulse_on_a_node(rows, impulses), whole ? 0.0 : 1.0};
  exchange.max(largest);
  demand_finite(largest[0]);
  if (largest[1] > 0) apply_impulses(system, impulses, largest[0], exchange, velocity, scratch);
}

void follow_impacts(const System& system, double dt, std::span<const Vec3> impulses, std::span<const Vec3> velocity,
                    ImpactScratch& impact) {
  impact.states.assign(impact.rows.size(), {});
  for (std::size_t q = 0; q < impact.rows.size(); ++q) {
    const ImpactRow& row = impact.rows[q];
    if (!(row.transit > 0)) continue;
    const bool gave = row.offered > 0;
    const bool open = row.step.push == 0 && (opens(row.state, row.step) || !(row.state.bank > 0));
    if (gave || open) continue;
    const Vec3& normal = system.rows.laws[q].normal;
    const double rates = row.step.before + normal.dot(relative_to_wall(system.rows, q, velocity));
    // what it takes of the returns of its neighbours is not taken from the bodies
    const double work = std::max(work_of_first(row.step), 0.5 * normal.dot(impulses[q]) * rates);
    impact.states[q] = closed_state(row.state, row.step, work, dt / (impact_numbers.memory * row.transit));
  }
}

}  // namespace brunt::contact
