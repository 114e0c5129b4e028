// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/system.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "problem.hpp"

using namespace brunt;
using namespace brunt::contact;

TEST_CASE("admitted impulses: no pull, Coulomb's disc, ties hold everything") {
  Row row{.normal = Vec3::UnitZ()};
  CHECK(admitted(law_of(row), {1, 2, 3}) == Vec3(0, 0, 3));
  CHECK(admitted(law_of(row), {1, 2, -3}) == Vec3::Zero());
  row.friction = 0.5;
  CHECK(admitted(law_of(row), {0.3, 0.4, 2}) == Vec3(0.3, 0.4, 2));
  CHECK((admitted(law_of(row), {3, 4, 2}) - Vec3(0.6, 0.8, 2)).norm() < 1e-15);
  CHECK(admitted(law_of(row), {3, 4, -2}) == Vec3::Zero());
  row.holds = true;
  CHECK(admitted(law_of(row), {3, 4, 2}) == Vec3(3, 4, 2));
  CHECK(admitted(law_of(row), {3, 4, -2}) == Vec3::Zero());
  row.cone = Cone::free;
  CHECK(admitted(law_of(row), {3, 4, -2}) == Vec3(3, 4, -2));
  CHECK(admitted(law_of(row), {3, 4, 0}) == Vec3(3, 4, 0));
}

TEST_CASE("a row asks for its rate along the normal and, with friction, for its drift across it") {
  Row row{.normal = Vec3::UnitZ(), .required = -1};
  CHECK(missing_rate(law_of(row), {5, 6, -3}) == Vec3(0, 0, 2));
  row.friction = 0.1;
  row.drift = {1, 0, 0};
  CHECK(missing_rate(law_of(row), {5, 6, -3}) == Vec3(-4, -6, 2));
}

TEST_CASE("row sums bound the operator: 1 for lone pairs, more where rows share a node") {
  Problem p;
  const LocalIndex a = p.add_node(1, {0, 0, -1}), b = p.add_node(1, {0, 0, 0}), c = p.add_node(1, {0, 0, -1});
  p.add_row({{a, 1}, {b, -1}}, Vec3::UnitZ());
  OneRankExchange exchange;
  EnforcementScratch scratch;
  CHECK_FALSE(form_row_sums(p.system(), exchange, scratch));
  CHECK(scratch.diagonal[0] == 2);
  p.add_row({{c, 1}, {b, -1}}, Vec3::UnitZ());
  CHECK(form_row_sums(p.system(), exchange, scratch));
  CHECK(scratch.diagonal == std::vector<double>{3, 3});
  form_diagonal(p.system(), scratch);
  CHECK(scratch.diagonal == std::vector<double>{2, 2});
}

TEST_CASE("a lever: nodes take what the row's rate is the transpose of, and the row sums bound the operator") {
  Problem p;
  const LocalIndex a = p.add_node(1, {0, 0, -1}), b = p.add_node(2, {0, 0, 0}), c = p.add_node(3, {1, 0, 2});
  std::array<Arm, 3> arms;
  arms[1].size = arms[2].size = 1;
  arms[1].turn << 0, 0.6, 0, -0.5, 0, 0.2, 0, 0, 0.3;
  arms[2].turn = -arms[1].turn;
  Row& row = p.add_row({{a, 1}, {b, -0.5}, {c, -0.5}}, Vec3::UnitZ());
  row.cone = Cone::free;
  row.holds = true;
  row.arms = arms;
  OneRankExchange exchange;
  EnforcementScratch scratch;
  CHECK(form_row_sums(p.system(), exchange, scratch));  // a bound: one step is not the solution
  p.velocity.resize(3);
  const Vec3 before = relative_velocity(row, std::vector<Vec3>{{0, 0, -1}, {0, 0, 0}, {1, 0, 2}});
  for (const Vec3& impulse : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.5, -0.3, 0.8)}) {
    apply_impulses(p.system(), std::vector<Vec3>{impulse}, 2 * largest_share(row), exchange, p.velocity, scratch);
    CHECK(p.momentum_change().norm() < 1e-15);
    const Vec3 answer = relative_velocity(row, p.velocity) - before;  // G W G^T p
    CHECK(impulse.dot(answer) > 0);
    CHECK(answer.norm() <= scratch.diagonal[0] * impulse.norm());
  }
  p.solve({.tolerance = 1e-12, .max_iterations = 1000});
  CHECK(relative_velocity(row, p.velocity).norm() < 1e-11);
  CHECK(p.kinetic(true) < p.kinetic(false));
}
