// SPDX-License-Identifier: Apache-2.0
// Projected Jacobi with the row-sum diagonal; all sums over rows are binned, so no bit depends on the ranks.
#include "brunt/contact/enforcement/rate_constraint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "brunt/core/binned_sum.hpp"
#include "brunt/core/error.hpp"

namespace brunt::contact {
namespace {

constexpr int row_sum_width = bin_slices + 1, impulse_width = 3 * bin_slices;

struct System {
  std::span<const Row> rows;
  std::span<const NodeMotion> motion;
  std::span<const Mobility> mobility;
};

/// Maximum that does not lose NaN, which compares false with everything.
void keep_max(double& largest, double value) {
  if (!(value <= largest)) largest = std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
}

double rate(const Row& row, std::span<const Vec3> velocity) {
  Vec3 relative = Vec3::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i)
    relative += row.weights[i] * velocity[static_cast<std::size_t>(row.nodes[i])];
  return row.normal.dot(relative);
}

double shortfall(const Row& row, std::span<const Vec3> velocity) {
  const double missing = row.required - rate(row, velocity);
  return row.cone == Cone::free ? std::abs(missing) : std::max(missing, 0.0);
}

/// |G_qn P_n|; what is left of a projector's rounding along a direction that is held counts as nothing.
double projected_weight(const Row& row, std::size_t i, const Mobility& mobility) {
  constexpr double held = 1e-6;
  const double free_part = (mobility.projector * row.normal).norm();
  return free_part > held ? std::abs(row.weights[i]) * free_part : 0.0;
}

/// Can an impulse in this row change its rate? Else the row is left out: prescribed motion has the authority.
bool can_act(const System& system, const Row& row) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i) {
    const Mobility& mobility = system.mobility[static_cast<std::size_t>(row.nodes[i])];
    if (mobility.inverse_mass > 0 && projected_weight(row, i, mobility) > 0) return true;
  }
  return false;
}

void sum_rows_of_nodes(const System& system, Exchange& exchange, RateScratch& scratch) {
  const std::size_t nodes = system.motion.size();
  const BinGrid grid = BinGrid::for_bound(1.0);
  scratch.row_sum_parts.assign(nodes * row_sum_width, 0.0);
  for (const Row& row : system.rows) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i) {
      const auto node = static_cast<std::size_t>(row.nodes[i]);
      double* parts = &scratch.row_sum_parts[node * row_sum_width];
      binned_add(grid, projected_weight(row, i, system.mobility[node]), parts);
      parts[bin_slices] += 1;
    }
  }
  exchange.sum_to_owner(scratch.row_sum_parts, row_sum_width);
  scratch.row_sum.resize(nodes);
  for (std::size_t node = 0; node < nodes; ++node) {
    const double* parts = &scratch.row_sum_parts[node * row_sum_width];
    demand(parts[bin_slices] <= binned_terms, "more rows on one contact node than its sums can hold");
    scratch.row_sum[node] = binned_value(parts);
  }
  exchange.share(scratch.row_sum, 1);
}

void form_diagonal(const System& system, RateScratch& scratch) {
  scratch.diagonal.resize(system.rows.size());
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const Row& row = system.rows[q];
    double h = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i) {
      const auto node = static_cast<std::size_t>(row.nodes[i]);
      const Mobility& mobility = system.mobility[node];
      h += projected_weight(row, i, mobility) * scratch.row_sum[node] * mobility.inverse_mass;
    }
    scratch.diagonal[q] = h;
  }
}

struct Judgement {
  double residual = 0, largest_impulse = 0;
};

/// Next impulses from the velocities of this iterate; the same on every rank.
Judgement update_impulses(const System& system, std::span<const Vec3> velocity, std::span<const double> impulses,
                          Exchange& exchange, RateScratch& scratch) {
  std::array<double, 2> largest{0, 0};
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const Row& row = system.rows[q];
    const double h = scratch.diagonal[q];
    double next = 0;
    if (h > 0) {  // else nothing in this row can move
      next = impulses[q] + (row.required - rate(row, velocity)) / h;
      if (row.cone == Cone::compression) next = next < 0 ? 0.0 : next;
      keep_max(largest[0], h * std::abs(next - impulses[q]));
      keep_max(largest[1], std::abs(next));
    }
    scratch.next[q] = next;
  }
  exchange.max(largest);
  if (!std::isfinite(largest[0]) || !std::isfinite(largest[1]))
    throw GuardError("contact: an impulse is not finite; the velocities that came in are not, or grew without bound");
  return {largest[0], largest[1]};
}

/// v = v* + W G^T impulses on owners, then on every copy.
void apply_impulses(const System& system, std::span<const double> impulses, double largest_impulse, Exchange& exchange,
                    std::span<Vec3> velocity, RateScratch& scratch) {
  const std::size_t nodes = system.motion.size();
  const BinGrid grid = BinGrid::for_bound(largest_impulse);
  scratch.impulse_parts.assign(nodes * impulse_width, 0.0);
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    if (impulses[q] == 0) continue;
    const Row& row = system.rows[q];
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i) {
      double* parts = &scratch.impulse_parts[static_cast<std::size_t>(row.nodes[i]) * impulse_width];
      const double share = row.weights[i] * impulses[q];
      for (int c = 0; c < 3; ++c) binned_add(grid, share * row.normal[c], parts + c * bin_slices);
    }
  }
  exchange.sum_to_owner(scratch.impulse_parts, impulse_width);
  for (std::size_t node = 0; node < nodes; ++node) {
    const double* parts = &scratch.impulse_parts[node * impulse_width];
    const Vec3 impulse(binned_value(parts), binned_value(parts + bin_slices), binned_value(parts + 2 * bin_slices));
    const Mobility& mobility = system.mobility[node];
    velocity[node] = system.motion[node].predicted + mobility.inverse_mass * (mobility.projector * impulse);
  }
  // a rank without nodes takes part all the same
  exchange.share(nodes == 0 ? std::span<double>{} : std::span<double>(velocity.front().data(), 3 * nodes), 3);
}

double largest_shortfall(const System& system, std::span<const Vec3> velocity, Exchange& exchange) {
  double largest = 0;
  for (const Row& row : system.rows) {
    const double missing = shortfall(row, velocity);
    if (missing != 0 && can_act(system, row)) keep_max(largest, missing);
  }
  exchange.max({&largest, 1});
  return largest;
}

}  // namespace

void RateScratch::reserve(std::size_t rows, std::size_t nodes) {
  diagonal.reserve(rows);
  next.reserve(rows);
  row_sum.reserve(nodes);
  row_sum_parts.reserve(nodes * row_sum_width);
  impulse_parts.reserve(nodes * impulse_width);
}

RateResult enforce_rate_constraint(std::span<const Row> rows, std::span<const NodeMotion> motion,
                                   std::span<const Mobility> mobility, const RateSettings& settings, Exchange& exchange,
                                   std::span<double> impulses, std::span<Vec3> velocity, RateScratch& scratch) {
  const System system{rows, motion, mobility};
  for (std::size_t node = 0; node < motion.size(); ++node) velocity[node] = motion[node].predicted;
  RateResult result{.violation = largest_shortfall(system, velocity, exchange)};
  if (result.violation == 0) {
    std::fill(impulses.begin(), impulses.end(), 0.0);
    return result;
  }
  sum_rows_of_nodes(system, exchange, scratch);
  form_diagonal(system, scratch);
  scratch.next.resize(rows.size());

  double largest_start = 0;
  for (const double impulse : impulses) keep_max(largest_start, std::abs(impulse));
  exchange.max({&largest_start, 1});
  result.acted = largest_start > 0;
  if (result.acted) apply_impulses(system, impulses, largest_start, exchange, velocity, scratch);

  while (true) {
    const Judgement now = update_impulses(system, velocity, impulses, exchange, scratch);
    result.residual = now.residual / result.violation;
    if (result.residual <= settings.tolerance || result.iterations == settings.max_iterations) return result;
    std::copy(scratch.next.begin(), scratch.next.end(), impulses.begin());
    apply_impulses(system, impulses, now.largest_impulse, exchange, velocity, scratch);
    result.acted = true;
    ++result.iterations;
  }
}

}  // namespace brunt::contact
