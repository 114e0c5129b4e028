// SPDX-License-Identifier: Apache-2.0
// The partitioned kinematic predictor-corrector against a lone node.
#include "contact/enforcement/kinematic.hpp"

#include <catch2/catch.hpp>

#include "problem.hpp"

using namespace brunt;
using namespace brunt::contact;

TEST_CASE("partitioned kinematic (24), (25): a lone node ends on the surface, half of it with beta one half") {
  Problem p = lone_node(-0.01, -3);
  p.solve({.method = Method::kinematic}, 0.5);
  CHECK(-0.01 + 0.5 * p.velocity[0].z() == Approx(0).margin(1e-15));
  Problem half = lone_node(-0.01, -3);
  half.solve({.method = Method::kinematic, .partition = 0.5}, 0.5);
  CHECK(-0.01 + 0.5 * half.velocity[0].z() == Approx(0.25 * (-0.01 - 1.5)));  // a half, and a half of what is left
  Problem open = lone_node(0.2, -0.3);
  open.solve({.method = Method::kinematic}, 0.5);
  CHECK(open.push(0) == 0);
}

TEST_CASE("partitioned kinematic: where the corrector takes all impulses back, velocities are those of no impulse") {
  Problem p;
  const LocalIndex node = p.add_node(2, {0, 0, -3});
  for (int k = 0; k < 3; ++k) p.add_row({{node, 1}}, Vec3::UnitZ());  // each gives all that is asked for
  p.solve({.method = Method::kinematic});
  Vec3 given = Vec3::Zero();
  for (const Vec3& impulse : p.impulses) given += impulse;
  CHECK((p.momentum_change() - given).norm() < 1e-14);
}
