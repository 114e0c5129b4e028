// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/softness.hpp"

#include <catch2/catch.hpp>

#include "problem.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

const EnforcementSettings exact{.tolerance = 1e-13, .max_iterations = 2000};

/// Two points on two points, each held off the other side in its pass: all four rows say that both sides move alike.
Problem pressed_twice(double friction = 0) {
  Problem p;
  const LocalIndex a = p.add_node(1, {0.4, 0, -1}), b = p.add_node(2, {0.4, 0, -1.5}), c = p.add_node(3, {0, 0, 0}),
                   d = p.add_node(1.5, {0, 0, 0.2});
  const auto add = [&](LocalIndex slave, LocalIndex one, LocalIndex other, double share, double side) {
    Row& row = p.add_row({{slave, 1}, {one, -share}, {other, share - 1}}, side * Vec3::UnitZ());
    row.softness = 0.05;
    row.friction = friction;
  };
  add(a, c, d, 0.9, 1);
  add(b, c, d, 0.2, 1);
  add(c, a, b, 0.8, -1);
  add(d, a, b, 0.1, -1);
  return p;
}

}  // namespace

TEST_CASE("soft rows: the law is held, whatever was borne before, and what is taken back") {
  Problem p = pressed_twice();
  for (std::size_t q = 0; q < p.rows.size(); ++q) {
    p.rows[q].gap_share = 0.04;
    p.impulses.emplace_back(0.1 * (1 + static_cast<double>(q)) * p.rows[q].normal);
  }
  const std::vector<Vec3> before = p.impulses;
  const EnforcementResult result = p.solve(exact);
  CHECK(result.residual <= 1e-12);
  int pushing = 0;
  for (std::size_t q = 0; q < p.rows.size(); ++q) {
    const Row& row = p.rows[q];
    const double c = row.softness * p.mobility[static_cast<std::size_t>(row.nodes[0])].inverse_mass;
    const double left = p.rate(q) + c * (p.push(q) - (1 - row.gap_share) * row.normal.dot(before[q])) - row.required;
    CHECK(p.push(q) >= 0);
    CHECK(left >= -1e-11);
    CHECK(std::min(left, p.push(q)) <= 1e-11);
    pushing += p.push(q) > 0 ? 1 : 0;
  }
  CHECK(pushing >= 2);
  CHECK(p.momentum_change().norm() < 1e-14);
}

TEST_CASE("soft rows with friction: sticking gives way across the normal in the same measure") {
  Problem p = pressed_twice(0.9);
  for (Row& row : p.rows) row.drift_share = 0.1;
  for (const Row& row : p.rows) p.impulses.emplace_back(0.3 * row.normal + Vec3(-0.05, 0, 0) * row.normal.z());
  const std::vector<Vec3> before = p.impulses;
  p.solve(exact);
  int sticking = 0;
  for (std::size_t q = 0; q < p.rows.size(); ++q) {
    const Row& row = p.rows[q];
    const double limit = row.friction * p.push(q), across = p.impulses[q].x();
    if (p.push(q) == 0 || std::abs(across) > 0.999 * limit) continue;
    const double c = row.softness * p.mobility[static_cast<std::size_t>(row.nodes[0])].inverse_mass;
    const double rate = relative_velocity(row, p.velocity).x();
    CHECK(std::abs(rate + c * (across - (1 - row.drift_share) * before[q].x())) < 1e-10);
    ++sticking;
  }
  CHECK(sticking >= 2);
}

TEST_CASE("soft rows: rigid ones beside them, and those of nodes that nothing moves, stay as they are") {
  Problem p = pressed_twice();
  p.rows[1].softness = 0;
  p.mobility[2].inverse_mass = 0;
  p.impulses.assign(4, Vec3::UnitZ());
  EnforcementScratch scratch;
  scratch.diagonal.assign(4, 2.0);
  OneRankExchange exchange;
  p.velocity.resize(p.motion.size(), Vec3::Zero());
  soften(p.system(), p.impulses, p.velocity, exchange, scratch);
  CHECK(scratch.compliance == std::vector<double>{0.05, 0, 0, 0.05 / 1.5});
  CHECK(scratch.diagonal == std::vector<double>{2.05, 2, 2, 2 + 0.05 / 1.5});
  CHECK(scratch.borne[1].isZero(0));
  CHECK(scratch.borne[0].isApprox(0.05 * Vec3::UnitZ()));
}
