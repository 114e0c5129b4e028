// SPDX-License-Identifier: Apache-2.0
// The rate constraint against impacts of mass points that have exact answers.
#include "contact/enforcement/rate_constraint.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "core/error.hpp"
#include "problem.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

EnforcementSettings to(double tolerance, int most, Method method = Method::rate) {
  return {.method = method, .tolerance = tolerance, .max_iterations = most, .warm_start = false};
}

}  // namespace

TEST_CASE("node on node: exact after one iteration (Heinstein et al. 2000, eq. 27)") {
  Problem p;
  const LocalIndex one = p.add_node(2, {0, 0, -3}), two = p.add_node(5, {0, 0, 1});
  p.add_row({{one, 1}, {two, -1}}, Vec3::UnitZ());
  const EnforcementResult result = p.solve(to(1e-12, 10));
  const double common = (2 * -3 + 5 * 1) / 7.0;
  CHECK(result.iterations == 1);
  CHECK(result.violation == 4.0);
  CHECK(p.velocity[0].z() == Approx(common).epsilon(1e-14));
  CHECK(p.velocity[1].z() == Approx(common).epsilon(1e-14));
  CHECK(p.push(0) == Approx(2 * 5 / 7.0 * 4).epsilon(1e-14));
}

TEST_CASE("an open gap closes exactly, a separating pair is left alone") {
  Problem p;
  const LocalIndex one = p.add_node(1, {0, 0, -3}), two = p.add_node(1, {0, 0, 0});
  p.add_row({{one, 1}, {two, -1}}, Vec3::UnitZ(), -2.5);
  p.solve(to(1e-12, 10));
  CHECK((p.velocity[0] - p.velocity[1]).z() == Approx(-2.5).epsilon(1e-14));

  p.motion[0].predicted.z() = 3;
  const EnforcementResult apart = p.solve(to(1e-12, 10));
  CHECK(apart.iterations == 0);
  CHECK(apart.violation == 0);
  CHECK(p.push(0) == 0);
  CHECK(p.velocity[0] == p.motion[0].predicted);
}

TEST_CASE("random patches: complementarity, momentum, and no energy, also when stopped early") {
  const Method method = GENERATE(Method::rate, Method::row_sum);
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    Problem p = random_patch(seed);
    for (auto& row : p.rows) row.required = 0;
    double previous = p.kinetic(false);
    for (const int limit : {1, 2, 3, 5, 10, 100, 3000}) {
      const EnforcementResult result = p.solve(to(1e-9, limit, method));
      const double scale = 40.0 * static_cast<double>(p.rows.size());
      CHECK(p.momentum_change().norm() < 1e-13 * scale);
      CHECK(p.kinetic(true) <= previous * (1 + 1e-14));
      if (method == Method::row_sum) previous = p.kinetic(true);  // it descends with every iteration
      if (limit == 3000) CHECK(result.residual <= 1e-9);
    }
    for (std::size_t q = 0; q < p.rows.size(); ++q) {
      CHECK(p.push(q) >= 0);
      CHECK(p.rate(q) >= -1e-7);
      CHECK(std::min(p.push(q), p.rate(q)) <= 1e-7);
    }
  }
}

TEST_CASE("iterations on patches: few, and not more on finer ones") {
  // Measured beforehand for unit masses, residual 1e-3 and 1e-8: 7 and 17, row sums 14 and 46 (20 on 13).
  struct Count {
    int slaves, masters, rough, fine;
  };
  for (const Count& count : {Count{20, 13, 8, 20}, {40, 26, 9, 22}, {80, 52, 9, 24}}) {
    Problem p = patch(count.slaves, count.masters, 1, 1);
    const EnforcementResult rough = p.solve(to(1e-3, 100)), fine = p.solve(to(1e-8, 100));
    INFO(count.slaves << " on " << count.masters << ": " << rough.iterations << ", " << fine.iterations);
    CHECK(rough.iterations <= count.rough);
    CHECK(fine.iterations <= count.fine);
    CHECK(fine.residual <= 1e-8);
  }
  Problem light = patch(20, 13, 100, 1);  // the wrong side for a slave; row sums take 407 and 1798
  CHECK(light.solve(to(1e-3, 1000)).iterations <= 60);
  CHECK(light.solve(to(1e-8, 1000)).residual <= 1e-8);
}

TEST_CASE("gaps that close in the step never give energy either") {
  for (const unsigned seed : {6U, 7U}) {
    Problem p = random_patch(seed);
    p.solve(to(1e-6, 2000));
    CHECK(p.kinetic(true) <= p.kinetic(false));
  }
}

TEST_CASE("constrained nodes do not move along what holds them") {
  Problem p;
  const LocalIndex ball = p.add_node(1, {0, 0, -2}), floor = p.add_node(1, {0, 0, 0});
  p.mobility[static_cast<std::size_t>(floor)].projector = Mat3(Vec3(1, 1, 0).asDiagonal());
  p.add_row({{ball, 1}, {floor, -1}}, Vec3::UnitZ());
  p.solve(to(1e-12, 10));
  CHECK(p.velocity[1] == Vec3::Zero());
  CHECK(std::abs(p.velocity[0].z()) < 1e-15);

  p.mobility[static_cast<std::size_t>(ball)].inverse_mass = 0;  // nothing can move: no impulse, no division by zero
  const EnforcementResult stuck = p.solve(to(1e-12, 10));
  CHECK(stuck.iterations == 0);
  CHECK(stuck.violation == 0);
  CHECK(p.push(0) == 0);
}

TEST_CASE("the rounding of a projector along a held direction is no freedom") {
  Problem p;
  const Vec3 normal = Vec3(1, 2, 3).normalized();
  const LocalIndex held = p.add_node(1, {0, 0, 0}), free = p.add_node(1, {0, 0, -1});
  p.mobility[static_cast<std::size_t>(held)].projector = Mat3::Identity() - normal * normal.transpose();
  p.add_row({{held, 1}}, normal, 1.0);
  p.add_row({{free, 1}}, Vec3::UnitZ());
  const EnforcementResult result = p.solve(to(1e-12, 10));
  CHECK(result.violation == 1.0);
  CHECK(p.push(0) == 0);
  CHECK(p.push(1) == Approx(1));
  CHECK(p.velocity[0] == Vec3::Zero());
}

TEST_CASE("a free row pulls, a compression row does not") {
  Problem p;
  const LocalIndex node = p.add_node(3, {1, 0, 2});
  p.add_row({{node, 1}}, Vec3::UnitZ());
  p.rows[0].cone = Cone::free;
  p.solve(to(1e-12, 10));
  CHECK(std::abs(p.velocity[0].z()) < 1e-15);
  CHECK(p.push(0) == Approx(-6));
  CHECK(p.velocity[0].x() == 1.0);
}

TEST_CASE("the bits do not depend on the order of the rows; a warm start ends at the same velocities") {
  const double friction = GENERATE(0.0, 0.4);
  Problem p = random_patch(9);
  for (Row& row : p.rows) row.friction = friction;
  p.solve(to(1e-6, 200));
  const std::vector<Vec3> expected = p.velocity;
  Problem reversed = p;
  std::reverse(reversed.rows.begin(), reversed.rows.end());
  reversed.solve(to(1e-6, 200));
  CHECK(reversed.velocity == expected);

  EnforcementSettings warm = to(1e-6, 200);
  warm.warm_start = true;
  CHECK(p.solve(warm).iterations <= 20);  // to 0.03 of what the cold start left, and it takes 50 to 100
  for (std::size_t n = 0; n < expected.size(); ++n) CHECK((p.velocity[n] - expected[n]).norm() < 1e-5);
}

TEST_CASE("a warm start goes on below the tolerance, to 0.03 of what is left at a time, and then sweeps once") {
  Problem p = random_patch(9);
  EnforcementSettings settings = to(1e-3, 200);
  double left = p.solve(settings).residual;
  settings.warm_start = true;
  for (int step = 0; left > 1e-11; ++step) {
    REQUIRE(step < 7);
    const double before = left;
    left = p.solve(settings).residual;  // before the last sweep
    CHECK(left <= std::max(0.033 * before, 1e-11));
  }
  const std::vector<Vec3> impulses = p.impulses;
  const EnforcementResult still = p.solve(settings);
  CHECK(still.iterations == 0);
  CHECK(still.acted);
  CHECK(p.impulses != impulses);  // a force answers what moves it, however little that is
}

TEST_CASE("a step that ends at max_iterations has ended at the limit only above the tolerance") {
  Problem p = random_patch(9);
  const EnforcementSettings short_of = to(1e-3, 2);
  const EnforcementResult cold = p.solve(short_of);
  CHECK(cold.iterations == 2);
  CHECK(ended_at_limit(cold, short_of));
  p.solve(to(1e-3, 200));
  EnforcementSettings warm = short_of;  // goes on below the tolerance, for half of the iterations
  warm.warm_start = true;
  const EnforcementResult within = p.solve(warm);
  CHECK(within.iterations == 1);
  CHECK(within.residual <= 1e-3);
  CHECK_FALSE(ended_at_limit(within, warm));
}

TEST_CASE("velocities that are not finite stop the run") {
  Problem p;
  const LocalIndex one = p.add_node(1, {0, 0, std::numeric_limits<double>::quiet_NaN()}),
                   two = p.add_node(1, {0, 0, 0});
  p.add_row({{one, 1}, {two, -1}}, Vec3::UnitZ());
  CHECK_THROWS_AS(p.solve(to(1e-3, 50)), GuardError);
}

TEST_CASE("a rank without nodes iterates as long as the others do") {
  class BusyElsewhere final : public Exchange {
   public:
    int shares = 0;
    void share(std::span<double> values, int /*width*/) override {
      CHECK(values.empty());
      ++shares;
    }
    void sum_to_owner(std::span<double> /*values*/, int /*width*/) override {}
    void max(std::span<double> values) override {
      for (double& value : values) value = 1.0;
    }
    void reduce(std::span<double> largest, std::span<std::int64_t> /*sums*/) override { max(largest); }
    void sum(std::span<std::int64_t> /*values*/) override {}
  } exchange;
  EnforcementScratch scratch;
  const RowMatrix none;
  const EnforcementResult result = enforce(System{none, {}, {}}, to(1e-3, 7), 1.0, exchange, {}, {}, scratch);
  CHECK(result.iterations == 7);
  CHECK(exchange.shares >= 7);
}
