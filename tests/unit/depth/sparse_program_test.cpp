// SPDX-License-Identifier: Apache-2.0
// Programs of any size with short rows: the same answers as the fixed-size method, the conditions of Karush, Kuhn and
// Tucker with many unknowns, and proofs of infeasibility.
#include "depth/sparse_program.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

using namespace brunt::depth;

namespace {

struct Random {
  std::mt19937_64 engine;
  std::normal_distribution<double> normal;
  double operator()() { return normal(engine); }
  int below(int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); }
};

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

struct Problem {
  int n = 0;
  std::vector<double> G, g;
  std::vector<SparseRow> rows;
};

/// Blocks of 6, rows between two of them.
Problem problem(Random& random, int blocks, int rows, bool feasible) {
  Problem p;
  p.n = 6 * blocks;
  p.G.assign(at(p.n * p.n), 0.0);
  for (int b = 0; b < blocks; ++b) {
    Eigen::Matrix<double, 6, 6> root;
    for (double& entry : root.reshaped()) entry = random();
    const Eigen::Matrix<double, 6, 6> block = root * root.transpose() + 0.1 * Eigen::Matrix<double, 6, 6>::Identity();
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) p.G[at((6 * b + i) * p.n + 6 * b + j)] = block(i, j);
  }
  for (int i = 0; i < p.n; ++i) p.g.push_back(3 * random());
  for (int r = 0; r < rows; ++r) {
    SparseRow& row = p.rows.emplace_back();
    const int one = random.below(blocks), other = random.below(blocks);
    for (int c = 0; c < 6; ++c) row.add(6 * one + c, random());
    for (int c = 0; c < 6 && other != one; ++c) row.add(6 * other + c, random());
    row.bound = feasible ? -std::abs(random()) : random();
  }
  return p;
}

void check_optimal(const Problem& p, const SparseProgram& program) {
  std::vector<double> rest(p.g);  // G x + g - sum w n
  for (int i = 0; i < p.n; ++i)
    for (int j = 0; j < p.n; ++j) rest[at(i)] += p.G[at(i * p.n + j)] * program.x()[at(j)];
  for (std::size_t k = 0; k < program.active().size(); ++k) {
    const SparseRow& row = p.rows[at(program.active()[k])];
    CHECK(program.weights()[k] >= 0);
    CHECK(row.times(program.x().data()) == Approx(row.bound).margin(1e-8));
    for (int i = 0; i < row.count; ++i) rest[at(row.place[at(i)])] -= program.weights()[k] * row.value[at(i)];
  }
  double worst = 0, lack = 0;
  for (const double r : rest) worst = std::max(worst, std::abs(r));
  for (const SparseRow& row : p.rows) lack = std::max(lack, (row.bound - row.times(program.x().data())) / row.norm());
  CHECK(worst < 1e-8);
  CHECK(lack < 1e-9);
}

}  // namespace

TEST_CASE("Random programs of up to 60 unknowns are solved", "[sparse_program]") {
  Random random{std::mt19937_64(3), {}};
  for (const int blocks : {1, 2, 5, 10})
    for (int i = 0; i < 10; ++i) {
      const Problem p = problem(random, blocks, 30 * blocks, true);
      SparseProgram program(p.G, p.g);
      REQUIRE(program.solve(p.rows, 1e-10) == Outcome::solved);
      check_optimal(p, program);
    }
}

TEST_CASE("Rows may be appended after a solution", "[sparse_program]") {
  Random random{std::mt19937_64(4), {}};
  const Problem p = problem(random, 4, 80, true);
  SparseProgram at_once(p.G, p.g), one_by_one(p.G, p.g);
  REQUIRE(at_once.solve(p.rows, 1e-11) == Outcome::solved);
  for (std::size_t count = 0; count <= p.rows.size(); count += 8)
    REQUIRE(one_by_one.solve(std::span(p.rows).first(count), 1e-11) == Outcome::solved);
  for (int i = 0; i < p.n; ++i) CHECK(one_by_one.x()[at(i)] == Approx(at_once.x()[at(i)]).margin(1e-8));
  CHECK(one_by_one.value() == Approx(at_once.value()));
}

TEST_CASE("The same as the method for six unknowns, proofs of infeasibility included", "[sparse_program]") {
  Random random{std::mt19937_64(5), {}};
  int infeasible = 0;
  for (int i = 0; i < 100; ++i) {
    const Problem p = problem(random, 1, 1 + random.below(25), false);
    QuadraticProgram<6>::Matrix G;
    QuadraticProgram<6>::Vector g;
    std::vector<Row<6>> rows;
    for (int a = 0; a < 6; ++a) {
      g[a] = p.g[at(a)];
      for (int b = 0; b < 6; ++b) G(a, b) = p.G[at(a * 6 + b)];
    }
    for (const SparseRow& row : p.rows) {
      Row<6>& full = rows.emplace_back();
      for (int c = 0; c < 6; ++c) full.normal[c] = row.value[at(c)];
      full.bound = row.bound;
    }
    QuadraticProgram<6> fixed(G, g);
    SparseProgram program(p.G, p.g);
    const Outcome outcome = program.solve(p.rows, 1e-10);
    REQUIRE(outcome == fixed.solve(rows, 1e-10));
    if (outcome == Outcome::solved) {
      for (int c = 0; c < 6; ++c) CHECK(program.x()[at(c)] == Approx(fixed.x()[c]).margin(1e-7));
      continue;
    }
    ++infeasible;
    std::vector<double> sum(6, 0.0);
    double bounds = 0;
    for (std::size_t k = 0; k < program.active().size(); ++k) {
      const SparseRow& row = p.rows[at(program.active()[k])];
      for (int c = 0; c < 6; ++c) sum[at(c)] += program.weights()[k] * row.value[at(c)];
      bounds += program.weights()[k] * row.bound;
    }
    for (const double s : sum) CHECK(std::abs(s) < 1e-8);
    CHECK(bounds > 0);
  }
  CHECK(infeasible > 10);
}
