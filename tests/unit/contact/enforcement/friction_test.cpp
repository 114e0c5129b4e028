// SPDX-License-Identifier: Apache-2.0
// Coulomb friction in the iteration of the rate constraint.
#include <catch2/catch.hpp>
#include <limits>

#include "contact/enforcement/enforce.hpp"
#include "problem.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

EnforcementSettings exact() {
  return {.tolerance = 1e-12, .max_iterations = 1000};
}

}  // namespace

TEST_CASE("a mass on a plane sticks below the friction angle and slides above it") {
  for (const double mu : {0.1, 0.3, 1.0}) {
    for (const double slip : {0.05, 0.5, 5.0}) {
      Problem p;
      const LocalIndex node = p.add_node(2, {0.6 * slip, 0.8 * slip, -1});
      p.add_row({{node, 1}}, Vec3::UnitZ()).friction = mu;
      const EnforcementResult result = p.solve(exact());
      CHECK(result.iterations == 1);  // one node, one row: exact at once
      CHECK(p.push(0) == Approx(2));
      const double left = std::max(0.0, slip - mu);
      CHECK(p.velocity[0].x() == Approx(0.6 * left).margin(1e-14));
      CHECK(p.velocity[0].y() == Approx(0.8 * left).margin(1e-14));
      CHECK(std::abs(p.velocity[0].z()) < 1e-15);
    }
  }
}

TEST_CASE("sliding changes no normal impulse where normals are parallel (as the cone relaxation would)") {
  for (const double mu : {0.1, 0.3, 1.0}) {
    Problem smooth = patch(20, 13, 1, 1);
    smooth.solve(exact());
    Problem rough = patch(20, 13, 1, 1);
    for (Row& row : rough.rows) row.friction = mu;
    for (NodeMotion& node : rough.motion)
      if (node.predicted.z() != 0) node.predicted += Vec3(30, 10, 0);  // the slaves
    rough.solve(exact());
    for (std::size_t q = 0; q < rough.rows.size(); ++q) {
      CHECK(std::abs(rough.push(q) - smooth.push(q)) < 1e-12);
      const Vec3 across = rough.impulses[q] - rough.push(q) * Vec3::UnitZ();
      CHECK(std::abs(across.norm() - mu * rough.push(q)) < 1e-12);
      const Vec3 slip = relative_velocity(rough.rows[q], rough.velocity);
      CHECK(across.dot(slip) <= 0);
    }
  }
}

TEST_CASE("random patches with friction: Coulomb's law in every row, momentum, no energy; also when stopped early") {
  for (const unsigned seed : {1U, 2U, 3U}) {
    Problem p = random_patch(seed);
    for (std::size_t q = 0; q < p.rows.size(); ++q) {
      p.rows[q].required = 0;
      p.rows[q].friction = 0.1 * static_cast<double>(q % 7);
    }
    for (const int limit : {1, 2, 5, 1000}) {
      EnforcementSettings settings = exact();
      settings.max_iterations = limit;
      const EnforcementResult result = p.solve(settings);
      CHECK(p.momentum_change().norm() < 1e-11);
      CHECK(p.kinetic(true) <= p.kinetic(false) * (1 + 1e-14));
      if (limit == 1000) CHECK(result.residual <= 1e-12);
    }
    for (std::size_t q = 0; q < p.rows.size(); ++q) {
      const Row& row = p.rows[q];
      const Vec3 slip = relative_velocity(row, p.velocity) - p.rate(q) * row.normal,
                 across = p.impulses[q] - p.push(q) * row.normal;
      CHECK(p.push(q) >= 0);
      CHECK(p.rate(q) >= -1e-9);
      CHECK(across.norm() <= row.friction * p.push(q) + 1e-12);
      if (slip.norm() > 1e-6 && row.friction > 0 && p.push(q) > 1e-6)  // slides: full friction against the slip
        CHECK((across + row.friction * p.push(q) * slip.normalized()).norm() < 1e-6);
    }
  }
}

TEST_CASE("a tied node follows its face in all directions, pulled as well") {
  Problem p;
  std::array<LocalIndex, 4> corners{};
  for (LocalIndex& corner : corners) corner = p.add_node(1, {0, 0, 0});
  const LocalIndex slave = p.add_node(3, {1, -2, 4});
  Row& row = p.add_row_over(slave, corners, 0.2, 0.7, Vec3::UnitZ());
  row.holds = true;
  row.cone = Cone::free;
  const EnforcementResult result = p.solve(exact());
  CHECK(result.residual <= 1e-12);
  CHECK(relative_velocity(p.rows[0], p.velocity).norm() < 1e-12);
  CHECK(p.momentum_change().norm() < 1e-13);
}

TEST_CASE("drift is taken back within the friction cone") {
  Problem p;
  const LocalIndex node = p.add_node(1, {0, 0, -1});
  Row& row = p.add_row({{node, 1}}, Vec3::UnitZ());
  row.friction = 0.5;
  row.drift = {0.2, 0, 0};
  p.solve(exact());
  CHECK((p.velocity[0] - Vec3(0.2, 0, 0)).norm() < 1e-14);
  p.rows[0].drift = {3, 0, 0};
  p.solve(exact());
  CHECK((p.velocity[0] - Vec3(0.5, 0, 0)).norm() < 1e-14);
}
