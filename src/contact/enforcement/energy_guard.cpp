// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/energy_guard.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/enforcement/island_sums.hpp"

namespace brunt::contact {
namespace {

/// Share of the largest term below which an energy is rounding of velocities: a thousand times its last bit.
constexpr double rounding = 1e-13;
constexpr std::size_t terms_of_energy = 3;

/// Terms of E(theta) = linear theta + quadratic theta^2 / 2 - stored.
struct Energy {
  double linear = 0, quadratic = 0, stored = 0;
  [[nodiscard]] std::array<double, terms_of_energy> terms() const { return {linear, quadratic, stored}; }
};

/// Work that recovery may do: along the normal and across it, where the row asks for it.
double work_of_recovery(const RowLaw& law, double wall_rate, const Vec3& impulse) {
  const double push = law.normal.dot(impulse);
  const double along = std::max(0.0, push * (law.required - wall_rate));
  return law.across == Across::slips ? along : along + std::max(0.0, impulse.dot(law.drift));
}

Energy energy_of_row(const System& system, std::size_t q, const Vec3& impulse, std::span<const Vec3> velocity,
                     const EnforcementScratch& scratch) {
  const RowLaw& law = system.rows.laws[q];
  const double wall_rate = system.rows.figures[q].wall_rate, compliance = scratch.compliance[q];
  const Vec3 before = relative_velocity(
      system.rows, q, [&](LocalIndex node) -> const Vec3& { return nth(system.motion, node).predicted; });
  const Vec3 change = relative_velocity(system.rows, q, velocity) - before;
  Energy energy{
      .linear = impulse.dot(before) - law.normal.dot(impulse) * wall_rate - work_of_recovery(law, wall_rate, impulse),
      .quadratic = impulse.dot(change)};
  if (compliance > 0) {
    energy.quadratic += compliance * impulse.squaredNorm();
    energy.stored = 0.5 * scratch.borne[q].squaredNorm() / compliance;
  }
  return energy;
}

}  // namespace

double share_without_gain(double linear, double quadratic, double stored) {
  if (linear + 0.5 * quadratic <= stored) return 1;
  if (!(quadratic > 0)) return linear > stored ? std::max(0.0, stored / linear) : 1.0;
  // both roots have the sign of `linear` where nothing is stored: the larger one, without cancellation
  const double root = std::sqrt(linear * linear + 2 * quadratic * stored);
  const double share = linear > 0 ? 2 * stored / (linear + root) : (root - linear) / quadratic;
  return std::clamp(share, 0.0, 1.0);
}

void guard_energy(const System& system, Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                  EnforcementScratch& scratch, EnforcementResult& result) {
  const std::size_t rows = system.rows.size();
  std::vector<char> takes_part(rows);
  for (std::size_t q = 0; q < rows; ++q) takes_part[q] = impulses[q].isZero(0) && scratch.borne[q].isZero(0) ? 0 : 1;
  Islands islands;
  find_islands(system, takes_part, exchange, islands);
  std::vector<double> of_rows(terms_of_energy * rows);
  for (std::size_t q = 0; q < rows; ++q)
    if (islands.of_row[q] != no_index)
      std::ranges::copy(energy_of_row(system, q, impulses[q], velocity, scratch).terms(),
                        &of_rows[terms_of_energy * q]);
  IslandSums sums;
  sum_over_islands(of_rows, terms_of_energy, islands, exchange, sums);
  std::vector<double> share(islands.labels.size(), 1.0);
  for (std::size_t i = 0; i < share.size(); ++i) {
    const double* energy = &sums.values[terms_of_energy * i];
    const double linear = energy[0], quadratic = energy[1], stored = energy[2];
    if (linear + 0.5 * quadratic - stored <= rounding * sums.bounds[i]) continue;
    share[i] = share_without_gain(linear, quadratic, stored);
    ++result.scaled_islands;
    result.least_share = std::min(result.least_share, share[i]);
  }
  if (result.scaled_islands == 0) return;
  for (std::size_t q = 0; q < rows; ++q)
    if (islands.of_row[q] != no_index) impulses[q] *= nth(share, islands.of_row[q]);
  double largest = largest_impulse_on_a_node(system.rows, impulses);
  exchange.max({&largest, 1});
  demand_finite(largest);
  apply_impulses(system, impulses, largest, exchange, velocity, scratch);
}

}  // namespace brunt::contact
