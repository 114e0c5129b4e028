// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/energy_guard.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/fixed_sum.hpp"

namespace brunt::contact {
namespace {

/// Digits of the sums, and of the sums of what they leave: 2^22 rows of an island fit in 63 bits.
constexpr int digits = 40;
/// Share of the largest term below which an energy is rounding of velocities: a thousand times its last bit.
constexpr double rounding = 1e-13;
constexpr std::size_t terms_of_energy = 3;
constexpr std::size_t parts_of_sum = 2;

/// A sum of terms up to a bound as two whole numbers, exact in any order.
struct SplitUnit {
  FixedUnit coarse, fine;
  explicit SplitUnit(double bound) : coarse(bound, digits), fine(std::ldexp(bound, -digits), digits) {}
  void add(double term, std::int64_t* sum) const {
    const std::int64_t units = coarse.of(term);
    sum[0] += units;
    sum[1] += fine.of(term - coarse.value(units));
  }
  [[nodiscard]] double value(const std::int64_t* sum) const { return coarse.value(sum[0]) + fine.value(sum[1]); }
};

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

/// Sums of all islands, of all ranks. bounds: largest |term| of each.
std::vector<Energy> sums_of_islands(std::span<const Energy> of_rows, const Islands& islands, Exchange& exchange,
                                    std::vector<double>& bounds) {
  const std::size_t count = islands.labels.size();
  bounds.assign(count, 0.0);
  for (std::size_t q = 0; q < of_rows.size(); ++q)
    if (const LocalIndex island = islands.of_row[q]; island != no_index)
      for (const double term : of_rows[q].terms()) keep_max(nth(bounds, island), std::abs(term));
  exchange.max(bounds);
  constexpr std::size_t width = terms_of_energy * parts_of_sum;
  std::vector<std::int64_t> sums(width * count, 0);
  for (std::size_t q = 0; q < of_rows.size(); ++q) {
    if (islands.of_row[q] == no_index) continue;
    const auto island = static_cast<std::size_t>(islands.of_row[q]);
    const SplitUnit unit(bounds[island]);
    std::int64_t* sum = &sums[width * island];
    for (const double term : of_rows[q].terms()) {
      unit.add(term, sum);
      sum += parts_of_sum;
    }
  }
  exchange.sum(sums);
  std::vector<Energy> energies(count);
  for (std::size_t i = 0; i < count; ++i) {
    const SplitUnit unit(bounds[i]);
    const std::int64_t* sum = &sums[width * i];
    energies[i] = {unit.value(sum), unit.value(sum + parts_of_sum), unit.value(sum + 2 * parts_of_sum)};
  }
  return energies;
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
  std::vector<Energy> of_rows(rows);
  for (std::size_t q = 0; q < rows; ++q)
    if (islands.of_row[q] != no_index) of_rows[q] = energy_of_row(system, q, impulses[q], velocity, scratch);
  std::vector<double> bounds;
  const std::vector<Energy> energies = sums_of_islands(of_rows, islands, exchange, bounds);
  std::vector<double> share(energies.size(), 1.0);
  for (std::size_t i = 0; i < share.size(); ++i) {
    const auto& [linear, quadratic, stored] = energies[i];
    if (linear + 0.5 * quadratic - stored <= rounding * bounds[i]) continue;
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
