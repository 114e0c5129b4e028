// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/softness.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "chains.hpp"
#include "core/fixed_sum.hpp"

namespace brunt::contact {
namespace {

/// Of sums, 2^22 rows of which fit in 63 bits; and the share of their largest term that is rounding.
constexpr int digits = 40;
constexpr double rounding = 1.0 / (1 << 30);

double answer_of(const RowMatrix& rows, std::size_t q) {
  double answer = 0;
  for (const BodyShare& share : rows.bodies_of(q)) answer += share.along * share.along;
  return answer;
}

/// Chain of a row between bodies; no_index: none of them moves along it.
LocalIndex chain_of(const System& system, std::size_t q, const ChainScratch& chains) {
  for (const BodyShare& share : system.rows.bodies_of(q))
    if (share.along > 0) return nth(chains.chain, share.body);
  return no_index;
}

/// s / mass of the slave; of a carried point, what the bodies answer along the normal.
double compliance_of_slave(const System& system, std::size_t q, const CarriedScratch& carried) {
  const std::size_t leader = system.rows.leader(q);
  const bool is_carried = !system.rows.bodies_of(q).empty() && carried.place[leader] != no_index;
  return system.rows.laws[q].softness * (is_carried ? answer_of(system.rows, q) : system.mobility[leader].inverse_mass);
}

/// What a chain's impulses are to change by in this step, as a share of themselves: kept has it behind theta.
double change_in(const ChainScratch& chains, LocalIndex chain) {
  return chains.kept[chains.kept.size() / 2 + static_cast<std::size_t>(chain)];
}

/// Rows yield by C times the change of their impulse: a chain that goes on from its last impulses, as at rest, yields
/// no more with the whole compliance than one that begins from nothing with the bounded one.
double compliance_between_bodies(const System& system, std::size_t q, const ChainScratch& chains) {
  const double pair = pair_of(system, q);
  if (pair < 0) return 0;
  const auto place = std::ranges::lower_bound(chains.pairs, pair) - chains.pairs.begin();
  const double bounded = nth(chains.factor, place), change = change_in(chains, chain_of(system, q, chains));
  return system.rows.laws[q].softness * answer_of(system.rows, q) * (change > bounded ? bounded / change : 1.0);
}

/// Rate of a row that is missing by v*, and with the last impulses [velocity].
std::pair<double, double> missing_of(const System& system, std::size_t q, std::span<const Vec3> velocity) {
  const RowLaw& law = system.rows.laws[q];
  const auto missing = [&](const Vec3& rate) { return std::max(0.0, law.required - law.normal.dot(rate)); };
  return {missing(relative_velocity(
              system.rows, q, [&](LocalIndex node) -> const Vec3& { return nth(system.motion, node).predicted; })),
          missing(relative_velocity(system.rows, q, velocity))};
}

/// What the last impulses of a row would do along them: asked for, and done.
std::pair<double, double> work_of_last(const System& system, std::size_t q, const Vec3& before,
                                       std::span<const Vec3> velocity) {
  const RowLaw& law = system.rows.laws[q];
  const double push = law.normal.dot(before);
  const double predicted = law.normal.dot(relative_velocity(
      system.rows, q, [&](LocalIndex node) -> const Vec3& { return nth(system.motion, node).predicted; }));
  const double change = law.normal.dot(relative_velocity(system.rows, q, velocity)) - predicted;
  return {push * (law.required - predicted), push * change};
}

/// Calls use(chain, asked for, done) for the rows between bodies that have an impulse from the last step.
template <class Use>
void for_each_last(const System& system, std::span<const Vec3> before, std::span<const Vec3> velocity,
                   const ChainScratch& chains, const Use& use) {
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    if (before[q].isZero(0) || !is_between_bodies(system, q)) continue;
    const LocalIndex chain = chain_of(system, q, chains);
    if (chain == no_index) continue;
    const auto [asked, done] = work_of_last(system, q, before[q], velocity);
    use(static_cast<std::size_t>(chain), asked, done);
  }
}

/// Largest missing rates of each chain, behind the bounds of its sums.
void bound_missing(const System& system, std::span<const Vec3> velocity, ChainScratch& chains) {
  const std::size_t bodies = system.carriers.bodies.size();
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    if (!is_between_bodies(system, q)) continue;
    const LocalIndex chain = chain_of(system, q, chains);
    if (chain == no_index) continue;
    const auto [at_first, left] = missing_of(system, q, velocity);
    const std::size_t place = bodies + 2 * static_cast<std::size_t>(chain);
    keep_max(chains.bounds[place], at_first);
    keep_max(chains.bounds[place + 1], left);
  }
}

/// theta and the change of each chain.
void keep_of_last(const System& system, std::span<const Vec3> before, std::span<const Vec3> velocity,
                  Exchange& exchange, ChainScratch& chains) {
  const std::size_t bodies = system.carriers.bodies.size();
  chains.bounds.assign(3 * bodies, 0.0);
  bound_missing(system, velocity, chains);
  for_each_last(system, before, velocity, chains, [&](std::size_t chain, double asked, double done) {
    keep_max(chains.bounds[chain], std::abs(asked));
    keep_max(chains.bounds[chain], std::abs(done));
  });
  exchange.max(chains.bounds);
  chains.sums.assign(2 * bodies, 0);
  for_each_last(system, before, velocity, chains, [&](std::size_t chain, double asked, double done) {
    const FixedUnit unit(chains.bounds[chain], digits);
    chains.sums[2 * chain] += unit.of(asked);
    chains.sums[2 * chain + 1] += unit.of(done);
  });
  exchange.sum(chains.sums);
  chains.kept.assign(2 * bodies, 1.0);
  for (std::size_t chain = 0; chain < bodies; ++chain) {
    const double at_first = chains.bounds[bodies + 2 * chain], left = chains.bounds[bodies + 2 * chain + 1];
    if (left < at_first) chains.kept[bodies + chain] = left / at_first;
    const FixedUnit unit(chains.bounds[chain], digits);
    const double asked = unit.value(chains.sums[2 * chain]), done = unit.value(chains.sums[2 * chain + 1]);
    if (asked < done - rounding * chains.bounds[chain])
      chains.kept[chain] = done > 0 ? std::max(0.0, asked / done) : 0.0;
  }
}

}  // namespace

void soften(const System& system, std::span<const Vec3> before, std::span<const Vec3> velocity, Exchange& exchange,
            EnforcementScratch& scratch) {
  scratch.compliance.assign(system.rows.size(), 0.0);
  scratch.borne.assign(system.rows.size(), Vec3::Zero());
  ChainScratch& chains = scratch.carried.chains;
  const bool chained = !system.carriers.bodies.empty() && scratch.carried.any_soft;
  if (chained) {
    find_chains(system.carriers.bodies.size(), exchange, chains);
    keep_of_last(system, before, velocity, exchange, chains);
  }
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const RowLaw& law = system.rows.laws[q];
    if (law.softness == 0 || !(scratch.diagonal[q] > 0)) continue;
    const bool between_bodies = chained && is_between_bodies(system, q);
    const double compliance =
        between_bodies ? compliance_between_bodies(system, q, chains) : compliance_of_slave(system, q, scratch.carried);
    if (compliance == 0) continue;
    const double kept = between_bodies ? nth(chains.kept, chain_of(system, q, chains)) : 1.0;
    scratch.compliance[q] = compliance;
    scratch.diagonal[q] += compliance;
    const RowFigures& figures = system.rows.figures[q];
    const Vec3 along = law.normal.dot(before[q]) * law.normal;
    scratch.borne[q] =
        kept * compliance * ((1 - figures.gap_share) * along + (1 - figures.drift_share) * (before[q] - along));
  }
}

}  // namespace brunt::contact
