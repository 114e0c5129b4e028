// SPDX-License-Identifier: Apache-2.0
// Rules of who may meet whom, and as what.
#include "contact/surface/surface.hpp"

#include <algorithm>
#include <cmath>

#include "contact/data/tolerances.hpp"

namespace brunt::contact {

bool is_slave(std::span<const BodyFigures> bodies, std::int32_t a, std::int32_t b, const Tolerances& tolerances) {
  const BodyFigures &one = nth(bodies, a), &other = nth(bodies, b);
  const auto differ = [&](double x, double y) {
    return std::isinf(x) != std::isinf(y) || std::abs(x - y) > tolerances.equal_figures * std::max(x, y);
  };
  if (differ(one.mean_area, other.mean_area)) return one.mean_area < other.mean_area;
  if (differ(one.mean_mass, other.mean_mass)) return one.mean_mass < other.mean_mass;
  return a < b;
}

bool have_similar_meshes(const BodyFigures& one, const BodyFigures& other, const Tolerances& tolerances) {
  if (std::isinf(one.mean_mass) || std::isinf(other.mean_mass)) return false;
  const double edges = tolerances.similar_edges;
  const auto near = [](double x, double y, double ratio) { return x <= ratio * y && y <= ratio * x; };
  return near(one.mean_area, other.mean_area, edges * edges) &&
         near(one.mean_mass, other.mean_mass, edges * edges * edges);
}

bool is_finer_everywhere(const BodyFigures& slave, const BodyFigures& master, const Tolerances& tolerances) {
  return slave.longest_edge <= master.shortest_edge * (1 + tolerances.equal_figures);
}

namespace {

/// In one pass nothing holds the nodes of the master between those of the slave.
bool need_two_passes(const Specification& specification, std::span<const BodyFigures> bodies, std::int32_t a,
                     std::int32_t b) {
  if (a == b) return true;
  const Tolerances& tolerances = *specification.tolerances;
  const BodyFigures &one = nth(bodies, a), &other = nth(bodies, b);
  if (have_similar_meshes(one, other, tolerances)) return true;
  return is_slave(bodies, a, b, tolerances) ? !is_finer_everywhere(one, other, tolerances)
                                            : !is_finer_everywhere(other, one, tolerances);
}

bool in_two_passes(const Specification& specification, std::span<const BodyFigures> bodies, std::int32_t block,
                   const SurfaceNode& node, std::int32_t other_block, std::int32_t other_body) {
  const PairSpecification& pair = specification.pairs.at(block, other_block);
  if (pair.rule == PairRule::apart) return false;
  if (pair.passes != Passes::automatic) return pair.passes != Passes::one;
  if (node.on_rim && node.body != other_body && holds_rims(specification)) return true;
  return pair.rule == PairRule::automatic && need_two_passes(specification, bodies, node.body, other_body);
}

bool bodies_in_two_passes(const Specification& specification, std::span<const BodyFigures> bodies, std::int32_t a,
                          std::int32_t b, bool on_rim) {
  const auto blocks_of = [&](std::int32_t body) -> const std::vector<std::int32_t>& {
    return nth(bodies, body).blocks;
  };
  return std::ranges::any_of(blocks_of(a), [&](std::int32_t own) {
    return std::ranges::any_of(blocks_of(b), [&](std::int32_t other) {
      return in_two_passes(specification, bodies, own, {.body = a, .on_rim = on_rim}, other, b);
    });
  });
}

bool may_meet_itself(const BodyFigures& body, const Specification& specification) {
  return std::ranges::any_of(body.blocks, [&](std::int32_t a) {
    return std::ranges::any_of(body.blocks,
                               [&](std::int32_t b) { return specification.pairs.at(a, b).rule != PairRule::apart; });
  });
}

}  // namespace

Roles roles_of(std::span<const BodyFigures> bodies, const Specification& specification) {
  const char unknown = specification.pairs.forces_a_side() ? 1 : 0;
  Roles roles{std::vector<char>(bodies.size(), unknown), std::vector<char>(bodies.size(), unknown),
              std::vector<char>(bodies.size(), 0)};
  const auto count = static_cast<std::int32_t>(bodies.size());
  for (std::int32_t a = 0; a < count; ++a) {
    for (std::int32_t b = 0; b < count; ++b) {
      const auto i = static_cast<std::size_t>(a);
      if (roles.slave[i] != 0 && roles.master[i] != 0) break;
      if (a == b && may_meet_itself(bodies[i], specification)) roles.slave[i] = roles.master[i] = 1;
      if (a != b) (is_slave(bodies, a, b, *specification.tolerances) ? roles.slave : roles.master)[i] = 1;
      if (a != b && bodies_in_two_passes(specification, bodies, a, b, false)) roles.slave[i] = roles.master[i] = 1;
      if (a != b && bodies_in_two_passes(specification, bodies, a, b, true)) roles.slave_rims[i] = roles.master[i] = 1;
    }
  }
  return roles;
}

bool meet_in_two_passes(const Specification& specification, std::span<const BodyFigures> bodies,
                        const SurfaceNode& node, std::int32_t face_block, std::int32_t face_body) {
  return std::ranges::any_of(node.blocks, [&](std::int32_t block) {
    return in_two_passes(specification, bodies, block, node, face_block, face_body);
  });
}

bool any_two_passes(const Specification& specification, std::span<const BodyFigures> bodies) {
  const auto count = static_cast<std::int32_t>(bodies.size());
  for (std::int32_t a = 0; a < count; ++a)
    for (std::int32_t b = a; b < count; ++b)
      if (bodies_in_two_passes(specification, bodies, a, b, true)) return true;
  return false;
}

bool is_primary_slave(const Specification& specification, std::span<const BodyFigures> bodies, const SurfaceNode& node,
                      std::int32_t face_block, std::int32_t face_body) {
  return std::ranges::any_of(node.blocks, [&](std::int32_t block) {
    const PairRule rule = specification.pairs.at(block, face_block).rule;
    if (rule == PairRule::automatic)
      return node.body == face_body || is_slave(bodies, node.body, face_body, *specification.tolerances);
    return rule == PairRule::slave;
  });
}

bool may_meet(const Specification& specification, std::span<const BodyFigures> bodies, const SurfaceNode& node,
              std::int32_t face_block, std::int32_t face_body) {
  return is_primary_slave(specification, bodies, node, face_block, face_body) ||
         meet_in_two_passes(specification, bodies, node, face_block, face_body);
}

}  // namespace brunt::contact
