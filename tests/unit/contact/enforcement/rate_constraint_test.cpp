// SPDX-License-Identifier: Apache-2.0
// The rate constraint against impacts of mass points that have exact answers.
#include "brunt/contact/enforcement/rate_constraint.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "brunt/core/error.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

struct Problem {
  std::vector<Row> rows;
  std::vector<NodeMotion> motion;
  std::vector<Mobility> mobility;
  std::vector<double> impulses;
  std::vector<Vec3> velocity;

  LocalIndex add_node(double mass, const Vec3& v) {
    motion.push_back({Vec3::Zero(), v, v});
    mobility.push_back({1 / mass, Mat3::Identity()});
    return static_cast<LocalIndex>(motion.size()) - 1;
  }
  void add_row(std::initializer_list<std::pair<LocalIndex, double>> terms, const Vec3& normal, double required = 0) {
    Row row{.normal = normal, .required = required};
    for (const auto& [node, weight] : terms) {
      row.nodes[static_cast<std::size_t>(row.node_count)] = node;
      row.weights[static_cast<std::size_t>(row.node_count++)] = weight;
    }
    rows.push_back(row);
  }
  RateResult solve(const RateSettings& settings) {
    OneRankExchange exchange;
    RateScratch scratch;
    impulses.assign(rows.size(), 0.0);
    velocity.resize(motion.size());
    return enforce_rate_constraint(rows, motion, mobility, settings, exchange, impulses, velocity, scratch);
  }
  [[nodiscard]] Vec3 momentum_change() const {
    Vec3 change = Vec3::Zero();
    for (std::size_t n = 0; n < motion.size(); ++n)
      change += (velocity[n] - motion[n].predicted) / mobility[n].inverse_mass;
    return change;
  }
  [[nodiscard]] double kinetic(bool after) const {
    double energy = 0;
    for (std::size_t n = 0; n < motion.size(); ++n)
      energy += 0.5 / mobility[n].inverse_mass * (after ? velocity[n] : motion[n].predicted).squaredNorm();
    return energy;
  }
};

/// A patch of slave points over a grid of master points, with random weights and masses.
Problem random_patch(unsigned seed) {
  Problem p;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> mass(0.5, 20), place(-1, 1), speed(-1, 1);
  constexpr int cells = 4;
  for (int i = 0; i < (cells + 1) * (cells + 1); ++i) p.add_node(mass(random), {speed(random), speed(random), 2});
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      for (int k = 0; k < 3; ++k) {
        const LocalIndex slave = p.add_node(mass(random), {speed(random), speed(random), -1 - speed(random)});
        const double a = 0.5 * (1 + place(random)), b = 0.5 * (1 + place(random));
        const LocalIndex corner = i * (cells + 1) + j;
        p.add_row({{slave, 1},
                   {corner, -(1 - a) * (1 - b)},
                   {corner + 1, -a * (1 - b)},
                   {corner + cells + 2, -a * b},
                   {corner + cells + 1, -(1 - a) * b}},
                  Vec3(0.1 * place(random), 0, 1).normalized(), k == 0 ? -0.5 : 0.0);
      }
    }
  }
  return p;
}

}  // namespace

TEST_CASE("node on node: exact after one iteration (Heinstein et al. 2000, eq. 27)") {
  Problem p;
  const LocalIndex one = p.add_node(2, {0, 0, -3}), two = p.add_node(5, {0, 0, 1});
  p.add_row({{one, 1}, {two, -1}}, Vec3::UnitZ());
  const RateResult result = p.solve({1e-12, 10});
  const double common = (2 * -3 + 5 * 1) / 7.0;
  CHECK(result.iterations == 1);
  CHECK(result.violation == 4.0);
  CHECK(p.velocity[0].z() == Approx(common).epsilon(1e-14));
  CHECK(p.velocity[1].z() == Approx(common).epsilon(1e-14));
  CHECK(p.impulses[0] == Approx(2 * 5 / 7.0 * 4).epsilon(1e-14));
}

TEST_CASE("an open gap closes exactly, a separating pair is left alone") {
  Problem p;
  const LocalIndex one = p.add_node(1, {0, 0, -3}), two = p.add_node(1, {0, 0, 0});
  p.add_row({{one, 1}, {two, -1}}, Vec3::UnitZ(), -2.5);
  p.solve({1e-12, 10});
  CHECK((p.velocity[0] - p.velocity[1]).z() == Approx(-2.5).epsilon(1e-14));

  p.motion[0].predicted.z() = 3;
  const RateResult apart = p.solve({1e-12, 10});
  CHECK(apart.iterations == 0);
  CHECK(apart.violation == 0);
  CHECK(p.impulses[0] == 0);
  CHECK(p.velocity[0] == p.motion[0].predicted);
}

TEST_CASE("random patches: complementarity, momentum, and energy that never grows, also when stopped early") {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    Problem p = random_patch(seed);
    for (auto& row : p.rows) row.required = 0;
    double previous = p.kinetic(false);
    for (const int limit : {1, 2, 3, 5, 10, 100, 3000}) {
      const RateResult result = p.solve({1e-9, limit});
      const double scale = 40.0 * static_cast<double>(p.rows.size());
      CHECK(p.momentum_change().norm() < 1e-13 * scale);
      CHECK(p.kinetic(true) <= previous * (1 + 1e-14));
      previous = p.kinetic(true);
      if (limit == 3000) CHECK(result.residual <= 1e-9);
    }
    for (std::size_t q = 0; q < p.rows.size(); ++q) {
      Vec3 relative = Vec3::Zero();
      for (std::size_t i = 0; i < 5; ++i)
        relative += p.rows[q].weights[i] * p.velocity[static_cast<std::size_t>(p.rows[q].nodes[i])];
      const double rate = p.rows[q].normal.dot(relative);
      CHECK(p.impulses[q] >= 0);
      CHECK(rate >= -1e-7);
      CHECK(std::min(p.impulses[q], rate) <= 1e-7);
    }
  }
}

TEST_CASE("gaps that close in the step never give energy either") {
  for (const unsigned seed : {6U, 7U}) {
    Problem p = random_patch(seed);
    p.solve({1e-6, 2000});
    CHECK(p.kinetic(true) <= p.kinetic(false));
  }
}

TEST_CASE("constrained nodes do not move along what holds them") {
  Problem p;
  const LocalIndex ball = p.add_node(1, {0, 0, -2}), floor = p.add_node(1, {0, 0, 0});
  p.mobility[static_cast<std::size_t>(floor)].projector = Mat3(Vec3(1, 1, 0).asDiagonal());
  p.add_row({{ball, 1}, {floor, -1}}, Vec3::UnitZ());
  p.solve({1e-12, 10});
  CHECK(p.velocity[1] == Vec3::Zero());
  CHECK(std::abs(p.velocity[0].z()) < 1e-15);

  p.mobility[static_cast<std::size_t>(ball)].inverse_mass = 0;  // nothing can move: no impulse, no division by zero
  const RateResult stuck = p.solve({1e-12, 10});
  CHECK(stuck.iterations == 0);
  CHECK(stuck.violation == 0);
  CHECK(p.impulses[0] == 0);
}

TEST_CASE("the rounding of a projector along a held direction is no freedom") {
  Problem p;
  const Vec3 normal = Vec3(1, 2, 3).normalized();
  const LocalIndex held = p.add_node(1, {0, 0, 0}), free = p.add_node(1, {0, 0, -1});
  p.mobility[static_cast<std::size_t>(held)].projector = Mat3::Identity() - normal * normal.transpose();
  p.add_row({{held, 1}}, normal, 1.0);
  p.add_row({{free, 1}}, Vec3::UnitZ());
  const RateResult result = p.solve({1e-12, 10});
  CHECK(result.violation == 1.0);
  CHECK(p.impulses[0] == 0);
  CHECK(p.impulses[1] == Approx(1));
  CHECK(p.velocity[0] == Vec3::Zero());
}

TEST_CASE("a free row pulls, a compression row does not") {
  Problem p;
  const LocalIndex node = p.add_node(3, {1, 0, 2});
  p.add_row({{node, 1}}, Vec3::UnitZ());
  p.rows[0].cone = Cone::free;
  p.solve({1e-12, 10});
  CHECK(std::abs(p.velocity[0].z()) < 1e-15);
  CHECK(p.impulses[0] == Approx(-6));
  CHECK(p.velocity[0].x() == 1.0);
}

TEST_CASE("the bits do not depend on the order of the rows; a warm start ends at the same velocities") {
  Problem p = random_patch(9);
  p.solve({1e-4, 200});
  const std::vector<Vec3> expected = p.velocity;
  Problem reversed = p;
  std::reverse(reversed.rows.begin(), reversed.rows.end());
  reversed.solve({1e-4, 200});
  CHECK(reversed.velocity == expected);

  OneRankExchange exchange;
  RateScratch scratch;
  const RateResult warm =
      enforce_rate_constraint(p.rows, p.motion, p.mobility, {1e-4, 200}, exchange, p.impulses, p.velocity, scratch);
  CHECK(warm.iterations == 0);
  CHECK(p.velocity == expected);
}

TEST_CASE("velocities that are not finite stop the run") {
  Problem p;
  const LocalIndex one = p.add_node(1, {0, 0, std::numeric_limits<double>::quiet_NaN()}),
                   two = p.add_node(1, {0, 0, 0});
  p.add_row({{one, 1}, {two, -1}}, Vec3::UnitZ());
  CHECK_THROWS_AS(p.solve({1e-3, 50}), GuardError);
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
  } exchange;
  RateScratch scratch;
  const RateResult result = enforce_rate_constraint({}, {}, {}, {1e-3, 7}, exchange, {}, {}, scratch);
  CHECK(result.iterations == 7);
  CHECK(exchange.shares >= 7);
}
