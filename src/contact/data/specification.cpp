// SPDX-License-Identifier: Apache-2.0
#include "contact/data/specification.hpp"

#include "core/error.hpp"

namespace brunt::contact {
namespace {

PairRule turned(PairRule rule) {
  if (rule == PairRule::slave) return PairRule::master;
  return rule == PairRule::master ? PairRule::slave : rule;
}

}  // namespace

PairTable::PairTable(std::size_t block_count, const PairSpecification& all)
    : block_count_(block_count), pairs_(block_count * block_count, all) {
  demand(turned(all.rule) == all.rule, "a rule for all pairs of blocks must be symmetric");
}

void PairTable::set(std::int32_t a, std::int32_t b, const PairSpecification& pair) {
  const auto exists = [&](std::int32_t block) { return block >= 0 && static_cast<std::size_t>(block) < block_count_; };
  demand(exists(a) && exists(b), "pair of blocks out of range");
  PairSpecification other = pair;
  other.rule = turned(pair.rule);
  pairs_[place(b, a)] = other;
  pairs_[place(a, b)] = pair;
}

bool PairTable::any_acts() const {
  return any([](const PairSpecification& pair) { return pair.rule != PairRule::apart; });
}

bool PairTable::any_tied() const {
  return any([](const PairSpecification& pair) { return pair.tied != Tied::no; });
}

bool PairTable::any_friction() const {
  return any([](const PairSpecification& pair) { return pair.friction.any(); });
}

bool PairTable::forces_a_side() const {
  return any([](const PairSpecification& pair) { return pair.rule == PairRule::slave; });
}

bool PairTable::averages() const {
  return any(
      [](const PairSpecification& pair) { return pair.rule != PairRule::apart && pair.passes == Passes::averaged; });
}

bool holds_rims(const Specification& specification) {
  return holds_rates(specification.enforcement.method) && !specification.pairs.averages();
}

}  // namespace brunt::contact
