// SPDX-License-Identifier: Apache-2.0
// Rules of who may meet whom, and as what.
#include "brunt/contact/surface/surface.hpp"

#include <algorithm>
#include <cmath>

#include "brunt/core/error.hpp"

namespace brunt::contact {

PairTable::PairTable(std::int32_t block_count, PairRule rule)
    : block_count_(block_count),
      rule_(static_cast<std::size_t>(block_count) * static_cast<std::size_t>(block_count), rule) {
  demand(rule == PairRule::apart || rule == PairRule::automatic, "a rule for all pairs of blocks must be symmetric");
}

void PairTable::set(std::int32_t a, std::int32_t b, PairRule rule) {
  demand(a >= 0 && b >= 0 && a < block_count_ && b < block_count_, "pair of blocks out of range");
  const auto place = [&](std::int32_t row, std::int32_t column) -> PairRule& {
    return rule_[static_cast<std::size_t>(row) * static_cast<std::size_t>(block_count_) +
                 static_cast<std::size_t>(column)];
  };
  place(b, a) = rule == PairRule::slave ? PairRule::master : rule == PairRule::master ? PairRule::slave : rule;
  place(a, b) = rule;
}

PairRule PairTable::at(std::int32_t a, std::int32_t b) const {
  return rule_[static_cast<std::size_t>(a) * static_cast<std::size_t>(block_count_) + static_cast<std::size_t>(b)];
}

bool PairTable::forces_a_side() const {
  return std::find(rule_.begin(), rule_.end(), PairRule::slave) != rule_.end();
}

bool is_slave(std::span<const BodyFigures> bodies, std::int32_t a, std::int32_t b) {
  const BodyFigures &one = bodies[static_cast<std::size_t>(a)], &other = bodies[static_cast<std::size_t>(b)];
  constexpr double alike = 0.01;
  const auto differ = [](double x, double y) {
    return std::isinf(x) != std::isinf(y) || std::abs(x - y) > alike * std::max(x, y);
  };
  if (differ(one.mean_area, other.mean_area)) return one.mean_area < other.mean_area;
  if (differ(one.mean_mass, other.mean_mass)) return one.mean_mass < other.mean_mass;
  return a < b;
}

namespace {

bool may_meet_itself(const BodyFigures& body, const PairTable& pairs) {
  return std::ranges::any_of(body.blocks, [&](std::int32_t a) {
    return std::ranges::any_of(body.blocks, [&](std::int32_t b) { return pairs.at(a, b) != PairRule::apart; });
  });
}

}  // namespace

Roles roles_of(std::span<const BodyFigures> bodies, const PairTable& pairs) {
  const char unknown = pairs.forces_a_side() ? 1 : 0;
  Roles roles{std::vector<char>(bodies.size(), unknown), std::vector<char>(bodies.size(), unknown)};
  const auto count = static_cast<std::int32_t>(bodies.size());
  for (std::int32_t a = 0; a < count; ++a) {
    for (std::int32_t b = 0; b < count; ++b) {
      const auto i = static_cast<std::size_t>(a);
      if (roles.slave[i] != 0 && roles.master[i] != 0) break;
      if (a == b && may_meet_itself(bodies[i], pairs)) roles.slave[i] = roles.master[i] = 1;
      if (a != b) (is_slave(bodies, a, b) ? roles.slave : roles.master)[i] = 1;
    }
  }
  return roles;
}

bool may_meet(const PairTable& pairs, std::span<const BodyFigures> bodies, std::span<const std::int32_t> node_blocks,
              std::int32_t node_body, std::int32_t face_block, std::int32_t face_body) {
  return std::any_of(node_blocks.begin(), node_blocks.end(), [&](std::int32_t block) {
    const PairRule rule = pairs.at(block, face_block);
    if (rule == PairRule::automatic) return node_body == face_body || is_slave(bodies, node_body, face_body);
    return rule == PairRule::slave;
  });
}

}  // namespace brunt::contact
