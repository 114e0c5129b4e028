// SPDX-License-Identifier: Apache-2.0
// Rigid bodies under the rows of their points: exact answers, conservation, and iterations that do not grow with the
// number of points.
#include "contact/enforcement/carried.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "boxes.hpp"

using namespace brunt;
using namespace brunt::contact;

TEST_CASE("a box that falls flat on the floor stops, by 4, 100, 10000 points") {
  const int n = GENERATE(2, 10, 100);
  BoxProblem p;
  p.add_box({.centre = {0.3, 0.2, 0.5}, .mass = 3, .velocity = {0.7, -0.2, -2}});
  p.rest_on_floor(0, n);
  const EnforcementResult result = p.solve_boxes({.tolerance = 1e-10});
  CHECK((p.velocity_of(0) - Vec3(0.7, -0.2, 0)).norm() < 1e-9);
  CHECK(p.spin_of(0).norm() < 1e-8);
  CHECK((p.answer(0).impulse.head<3>() - Vec3(0, 0, 6)).norm() < 1e-8);
  for (std::size_t q = 0; q < p.rows.size(); ++q) CHECK(p.rate(q) >= -1e-9);
  CHECK(result.iterations <= 4);  // seen: 3
}

TEST_CASE("a box that spins comes down on the corner that the exact solution names") {
  BoxProblem p;
  p.add_box({.centre = {0, 0, 0.5}, .size = {1, 2, 1}, .mass = 2, .velocity = {0, 0, -1}, .spin = {0.4, -0.7, 0.2}});
  p.rest_on_floor(0, 8);
  BoxProblem exact = p;
  exact.solve_boxes({.method = Method::reference});
  p.solve_boxes({.tolerance = 1e-11, .max_iterations = 10000});
  CHECK((p.answer(0).change - exact.answer(0).change).norm() < 1e-8);
  CHECK(p.energy(true) < p.energy(false));
}

TEST_CASE("one point under a corner: the impulse of rigid-body mechanics in one iteration") {
  BoxProblem p;
  p.add_box({.centre = {0, 0, 0.5}, .mass = 2, .velocity = {0, 0, -1}});
  p.add_row({{p.add_point(0, {0.5, 0.5, 0}), 1}}, Vec3::UnitZ());
  const EnforcementResult result = p.solve_boxes({});
  // 1/p = 1/m + (r x n) . I^-1 (r x n), I = m a^2 / 6
  const double answer = 1 / 2.0 + 0.5 / (2 / 6.0);
  CHECK(p.push(0) == Approx(1 / answer).epsilon(1e-14));
  CHECK(result.iterations == 1);
  CHECK(std::abs(p.rate(0)) < 1e-15);
}

TEST_CASE("boxes that meet in the air keep momentum and angular momentum to rounding, with friction and without") {
  const double friction = GENERATE(0.0, 0.4);
  BoxProblem p;
  p.add_box({.centre = {0.1, 0, -0.5}, .mass = 3, .velocity = {0.2, 0, 1}, .spin = {0.3, 0.1, -0.4}});
  p.add_box({.centre = {0.3, 0.2, 0.5}, .mass = 0.7, .velocity = {-0.5, 0.3, -1}, .spin = {-0.2, 0.5, 0.1}});
  for (int i = 0; i < 12; ++i) {
    const Vec3 place(0.2 + 0.15 * std::cos(i), 0.1 + 0.2 * std::sin(2 * i), 0);
    p.add_row({{p.add_point(1, place), 1}, {p.add_point(0, place), -1}}, Vec3::UnitZ()).friction = friction;
  }
  p.solve_boxes({.tolerance = 1e-9, .max_iterations = 1000});
  const Vec6 &one = p.answer(0).impulse, &other = p.answer(1).impulse;
  CHECK(one.head<3>().norm() > 0.5);
  CHECK((one.head<3>() + other.head<3>()).norm() <= 4e-16 * one.norm());
  Vec3 spin = Vec3::Zero();
  for (const LocalIndex b : {0, 1})
    spin += p.answer(b).impulse.tail<3>() +
            p.boxes[static_cast<std::size_t>(b)].centre.cross(Vec3(p.answer(b).impulse.head<3>()));
  CHECK(spin.norm() <= 4e-16 * one.norm());
  CHECK(p.energy(true) < p.energy(false));
  for (std::size_t q = 0; q < p.rows.size(); ++q) CHECK(p.rate(q) >= -1e-6);
}

TEST_CASE("a box on deformable nodes and on another box: row sums bound the operator") {
  BoxProblem p;
  p.add_box({.centre = {0, 0, 0.5}, .mass = 5, .velocity = {0, 0, -1}});
  p.add_box({.centre = {0, 0, 1.5}, .mass = 0.5, .velocity = {0, 0, -2}});
  for (const LocalIndex point : p.add_side(0, 5, -1)) {
    const LocalIndex node = p.add_node(0.05, {0, 0, 0});
    p.add_row({{node, 1}, {point, -1}}, -Vec3::UnitZ()).friction = 0.3;
  }
  p.rest_on_box(1, 0, 4);
  const EnforcementResult result = p.solve_boxes({.tolerance = 1e-8, .max_iterations = 5000});
  CHECK(result.residual <= 1e-8);
  const std::vector<double> diagonal = p.scratch.diagonal;
  OneRankExchange exchange;
  const System system{p.matrix, p.motion, p.mobility, false, 1, p.carriers()};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(-1, 1);
  for (int trial = 0; trial < 50; ++trial) {
    double bound = 0, work = 0;
    for (Vec3& impulse : p.impulses) impulse = Vec3(part(random), part(random), trial == 0 ? 1 : part(random));
    for (std::size_t q = 0; q < p.rows.size(); ++q) {
      if (p.rows[q].friction == 0) p.impulses[q] = p.impulses[q].z() * Vec3::UnitZ();
      bound += diagonal[q] * p.impulses[q].squaredNorm();
    }
    velocities_of_impulses(system, p.impulses, 2, exchange, p.velocity, p.scratch);
    for (std::size_t q = 0; q < p.rows.size(); ++q) work += p.impulses[q].dot(relative_velocity(p.rows[q], p.velocity));
    CHECK(work > 0);
    CHECK(work <= bound);
  }
}

TEST_CASE("held freedoms of a body: rows along them are left out, others act") {
  BoxProblem p;
  p.add_box({.centre = {0, 0, 0.5}, .mass = 2, .velocity = {-1, 0, -1}});
  for (const int held : {2, 3, 4, 5}) {
    p.bodies[0].mobility.row(held).setZero();
    p.bodies[0].mobility.col(held).setZero();
  }
  p.rest_on_floor(0, 3);
  p.add_row({{p.add_point(0, {-0.5, 0.2, 0.4}), 1}}, Vec3::UnitX());
  const EnforcementResult result = p.solve_boxes({});
  CHECK((p.answer(0).impulse.head<3>() - Vec3(2, 0, 0)).norm() < 1e-15);
  CHECK((p.velocity_of(0) - Vec3(0, 0, -1)).norm() < 1e-15);
  CHECK(result.violation == 1);  // of the row that can act
}

TEST_CASE("a body that is held altogether is told the impulse that it takes") {
  BoxProblem p;
  p.add_box({.centre = {0, 0, -0.5}});
  p.bodies[0].mobility.setZero();
  const LocalIndex node = p.add_node(2, {0.3, 0, -3});
  p.add_row({{node, 1}, {p.add_point(0, {0.2, 0.1, 0}), -1}}, Vec3::UnitZ());
  p.solve_boxes({});
  CHECK(p.velocity[0] == Vec3(0.3, 0, 0));
  CHECK(p.answer(0).impulse.head<3>() == Vec3(0, 0, -6));
  CHECK((p.answer(0).impulse.tail<3>() - Vec3(0.2, 0.1, 0.5).cross(Vec3(0, 0, -6))).norm() < 1e-15);
  CHECK(p.answer(0).change.isZero(0));
}

TEST_CASE("averaged passes: a body that has rows of one pass alone gets its share") {
  BoxProblem p;
  p.add_box({.centre = {0, 0, 0.5}, .mass = 2, .velocity = {0, 0, -1}});
  p.add_box({.centre = {5, 0, 0.5}, .mass = 2, .velocity = {0, 0, -1}});
  p.rest_on_floor(0, 3);
  for (Row& row : p.rows) row.pass = Pass::first;
  const std::size_t first = p.rows.size();
  p.rest_on_floor(1, 3);
  for (std::size_t q = first; q < p.rows.size(); ++q) p.rows[q].pass = Pass::second;
  OneRankExchange exchange;
  p.solve_boxes({.averaged = true}, exchange, true);
  Vec3 given = Vec3::Zero();
  for (const Vec3& impulse : p.impulses) given += impulse;
  const Vec6 taken = p.answer(0).impulse + p.answer(1).impulse;
  CHECK((taken.head<3>() - given).norm() < 1e-14);
  CHECK((p.answer(0).impulse - p.answer(1).impulse).norm() < 1e-14);
  CHECK(p.answer(0).impulse[2] > 0.5);
}

TEST_CASE("a tie with arms on a body: its work is that of the body's impulse") {
  BoxProblem p;
  p.add_box({.centre = {0, 0, 0.5}, .mass = 2, .velocity = {0, 0, -1}, .spin = {0.3, 0, 0}});
  std::array<Arm, 3> arms;
  arms[1].turn << 0, 0.6, 0, -0.5, 0, 0.2, 0, 0, 0.3;
  arms[2].turn = -arms[1].turn;
  arms[1].size = arms[2].size = 1;
  Row& row = p.add_row(
      {{p.add_node(0.5, {1, 0, 0}), 1}, {p.add_point(0, {0.5, 0, 0}), -0.5}, {p.add_point(0, {0, 0.5, 0}), -0.5}},
      Vec3::UnitZ());
  row.cone = Cone::free;
  row.holds = true;
  row.arms = arms;
  p.solve_boxes({.tolerance = 1e-12, .max_iterations = 1000});
  CHECK(relative_velocity(p.rows[0], p.velocity).norm() < 1e-11);
  Vec3 before = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i)
    before += (p.rows[0].weights[i] * Mat3::Identity() + arms[i].turn) * p.motion[i].predicted;
  const double work = p.impulses[0].dot(-before);  // p . G W G^T p
  const double nodes = p.impulses[0].squaredNorm() / 0.5;
  CHECK(work == Approx(nodes + p.answer(0).impulse.dot(p.answer(0).change)).epsilon(1e-10));
  CHECK(work <= p.scratch.diagonal[0] * p.impulses[0].squaredNorm());
}

TEST_CASE("few points beside many on one body: iterations do not grow with the many") {
  const auto [friction, most] = GENERATE(std::pair(0.0, 10), std::pair(0.3, 100));
  for (const int n : {2, 10, 100}) {
    BoxProblem p;
    p.add_box({.centre = {0, 0, 0.5}, .velocity = {0.5, 0, -1}});
    p.add_box({.centre = {0, 0, 1.5}, .velocity = {-0.5, 0.2, -1}});
    p.rest_on_floor(0, n);
    p.rest_on_box(1, 0, 2);
    for (Row& row : p.rows) row.friction = friction;
    const EnforcementResult result = p.solve_boxes({.max_iterations = 1000});
    CAPTURE(n, friction);
    CHECK(result.iterations <= most);  // seen: 6, 6, 6; 44, 49, 51 (with plain row sums 44, 87, 272)
    CHECK(result.residual <= 1e-3);
  }
}

TEST_CASE("a stack of boxes that falls flat: iterations grow with its height, not with the points") {
  const auto [boxes, most] = GENERATE(std::pair(1, 4), std::pair(10, 60), std::pair(100, 1000));
  for (const int n : {2, 10}) {
    BoxProblem p;
    for (int b = 0; b < boxes; ++b) {
      p.add_box({.centre = {0, 0, 0.5 + b}, .velocity = {0, 0, -1e-3}});
      if (b == 0)
        p.rest_on_floor(0, n);
      else
        p.rest_on_box(b, b - 1, n);
    }
    const EnforcementResult result = p.solve_boxes({.max_iterations = 2000});
    CAPTURE(boxes, n);
    CHECK(result.iterations <= most);  // seen: 3; 40, 32; 640, 345
    CHECK(result.residual <= 1e-3);
  }
}

TEST_CASE("what hangs on a joint is felt by the body that meets the floor") {
  // a bar of two thin halves comes down flat on one end: the exact impulse of the two bodies with a ball joint
  BoxProblem p;
  p.add_box({.centre = {0.5, 0, 0}, .size = {1, 0.1, 0.1}, .mass = 1, .velocity = {0, 0, -1}});
  p.add_box({.centre = {1.5, 0, 0}, .size = {1, 0.1, 0.1}, .mass = 1, .velocity = {0, 0, -1}});
  const double alone = 1 / (1 + 0.25 / (1.01 / 12));
  BoxProblem free = p;
  free.add_row({{free.add_point(0, {0, 0, 0}), 1}}, Vec3::UnitZ());
  free.solve_boxes({});
  CHECK(free.push(0) == Approx(alone).epsilon(1e-12));
  p.join(0, 1, {1, 0, 0});
  p.add_row({{p.add_point(0, {0, 0, 0}), 1}}, Vec3::UnitZ());
  p.solve_boxes({.tolerance = 1e-12});
  // Lagrange: the end changes its velocity by 1, the joint and the far end so that the energy of the change is least
  const double inertia = 1.01 / 12;
  Eigen::Matrix2d hesse;
  hesse << 2 * (0.25 + inertia), 0.25 - inertia, 0.25 - inertia, 0.25 + inertia;
  const Eigen::Vector2d ends = hesse.inverse() * Eigen::Vector2d(-(0.25 - inertia), 0);
  const double felt = 0.25 + inertia + (0.25 - inertia) * ends[0];
  CHECK(p.push(0) == Approx(felt).epsilon(1e-10));
  CHECK(felt > alone);
  const Vec3 joint(1, 0, 0);
  const auto at_joint = [&](LocalIndex b) {
    return Vec3(p.velocity_of(b) + p.spin_of(b).cross(joint - p.boxes[static_cast<std::size_t>(b)].centre));
  };
  CHECK((at_joint(0) - at_joint(1)).norm() < 1e-12);
  CHECK(p.energy(true) < p.energy(false));
}
