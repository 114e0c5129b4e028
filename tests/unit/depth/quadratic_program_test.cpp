// SPDX-License-Identifier: Apache-2.0
// The dual active-set method against enumeration of all active sets (3 unknowns) and the conditions of Karush, Kuhn and
// Tucker, which are sufficient here (6 and 7 unknowns); proofs of infeasibility are checked as such.
#include "depth/quadratic_program.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <random>
#include <utility>
#include <vector>

using namespace brunt::depth;

namespace {

struct Random {
  std::mt19937_64 engine;
  std::normal_distribution<double> normal;
  double operator()() { return normal(engine); }
  int below(int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); }
};

template <int N>
struct Problem {
  Eigen::Matrix<double, N, N> G;
  Eigen::Matrix<double, N, 1> g;
  std::vector<Row<N>> rows;
};

/// Kinds: 0 rows at random; 1 feasible (x = 0 satisfies all); 2 degenerate: all rows meet in one point; 3 redundant:
/// rows repeated, scaled, and sums of others; 4 scaled badly.
template <int N>
Problem<N> problem(Random& random, int kind, int most) {
  Problem<N> p;
  Eigen::Matrix<double, N, N> root;
  for (double& entry : root.reshaped()) entry = random();
  p.G = root * root.transpose() + 1e-3 * Eigen::Matrix<double, N, N>::Identity();
  for (double& entry : p.g) entry = 3 * random();
  Eigen::Matrix<double, N, 1> meeting;
  for (double& entry : meeting) entry = random();
  const int count = random.below(most + 1);
  for (int i = 0; i < count; ++i) {
    Row<N> row;
    for (double& entry : row.normal) entry = random();
    row.bound = kind == 1 ? -std::abs(random()) : kind == 2 ? row.normal.dot(meeting) : random();
    if (kind == 3 && i > 1) {
      const Row<N>&a = p.rows[static_cast<std::size_t>(random.below(i))],
            &b = p.rows[static_cast<std::size_t>(random.below(i))];
      const double s = std::abs(random()), t = random.below(2) ? std::abs(random()) : 0;
      row.normal = s * a.normal + t * b.normal;
      row.bound = s * a.bound + t * b.bound - (random.below(2) ? std::abs(random()) : 0);
    }
    if (kind == 4) {
      const double s = std::exp(5 * random());
      row.normal *= s;
      row.bound *= s;
    }
    p.rows.push_back(row);
  }
  return p;
}

template <int N>
bool feasible(const Problem<N>& p, const Eigen::Matrix<double, N, 1>& x, double tolerance) {
  for (const Row<N>& row : p.rows)
    if (row.normal.dot(x) < row.bound - tolerance * row.normal.norm()) return false;
  return true;
}

constexpr std::size_t unknowns = 6;
using Small = std::array<std::array<double, unknowns + 1>, unknowns>;  // the right-hand side in the last column

/// By elimination with row pivots; false where singular.
bool solve(Small K, std::array<double, unknowns>& x) {
  for (std::size_t c = 0; c < unknowns; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c; r < unknowns; ++r)
      if (std::abs(K[r][c]) > std::abs(K[pivot][c])) pivot = r;
    std::swap(K[c], K[pivot]);
    if (std::abs(K[c][c]) < 1e-10) return false;
    for (std::size_t r = 0; r < unknowns; ++r) {
      const double factor = r == c ? 0 : K[r][c] / K[c][c];
      for (std::size_t k = c; k <= unknowns; ++k) K[r][k] -= factor * K[c][k];
    }
  }
  for (std::size_t c = 0; c < unknowns; ++c) x[c] = K[c][unknowns] / K[c][c];
  return true;
}

/// Least value over all feasible stationary points of the faces of up to three rows.
double enumerate(const Problem<3>& p) {
  const int m = static_cast<int>(p.rows.size());
  double best = std::numeric_limits<double>::infinity();
  const auto attempt = [&](std::vector<int> set) {
    Small K{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) K[i][j] = p.G(static_cast<int>(i), static_cast<int>(j));
      K[i][unknowns] = -p.g[static_cast<int>(i)];
      K[3 + i][3 + i] = 1;  // of rows not used
    }
    for (std::size_t i = 0; i < set.size(); ++i) {
      const Row<3>& row = p.rows[static_cast<std::size_t>(set[i])];
      const double length = row.normal.norm();
      for (std::size_t j = 0; j < 3; ++j) K[j][3 + i] = K[3 + i][j] = row.normal[static_cast<int>(j)] / length;
      K[3 + i][3 + i] = 0;
      K[3 + i][unknowns] = row.bound / length;
    }
    std::array<double, unknowns> solution{};
    if (!solve(K, solution)) return;
    const Eigen::Vector3d x(solution[0], solution[1], solution[2]);
    if (feasible(p, x, 1e-8)) best = std::min(best, 0.5 * x.dot(p.G * x) + p.g.dot(x));
  };
  attempt({});
  for (int i = 0; i < m; ++i) {
    attempt({i});
    for (int j = 0; j < i; ++j) {
      attempt({i, j});
      for (int k = 0; k < j; ++k) attempt({i, j, k});
    }
  }
  return best;
}

template <int N>
void check_solution(const Problem<N>& p, const QuadraticProgram<N>& program) {
  CHECK(feasible(p, program.x(), 1e-9));
  Eigen::Matrix<double, N, 1> residual = p.G * program.x() + p.g;
  double scale = 1 + p.g.norm();
  for (std::size_t k = 0; k < program.active().size(); ++k) {
    const Row<N>& row = p.rows[static_cast<std::size_t>(program.active()[k])];
    const double weight = program.weights()[k];
    CHECK(weight >= 0);
    CHECK(std::abs(row.normal.dot(program.x()) - row.bound) <= 1e-7 * row.normal.norm() * (1 + program.x().norm()));
    residual -= weight * row.normal;
    scale += weight * row.normal.norm();
  }
  CHECK(residual.norm() <= 1e-8 * scale);
}

template <int N>
void check_proof(const Problem<N>& p, const QuadraticProgram<N>& program) {
  Eigen::Matrix<double, N, 1> sum = Eigen::Matrix<double, N, 1>::Zero();
  double bounds = 0, scale = 0;
  for (std::size_t k = 0; k < program.active().size(); ++k) {
    const Row<N>& row = p.rows[static_cast<std::size_t>(program.active()[k])];
    CHECK(program.weights()[k] >= 0);
    sum += program.weights()[k] * row.normal;
    bounds += program.weights()[k] * row.bound;
    scale += program.weights()[k] * row.normal.norm();
  }
  CHECK(sum.norm() <= 1e-8 * scale);
  CHECK(bounds > 0);
}

template <int N>
void sweep(int problems, int most) {
  Random random{std::mt19937_64(N), {}};
  int solved = 0, infeasible = 0;
  for (int i = 0; i < problems; ++i) {
    const int kind = i % 5;
    const Problem<N> p = problem<N>(random, kind, most);
    QuadraticProgram<N> program(p.G, p.g);
    const Outcome outcome = program.solve(p.rows, 1e-10);
    INFO("problem " << i << " of " << N << " unknowns, " << p.rows.size() << " rows");
    REQUIRE(outcome != Outcome::stalled);
    if (outcome == Outcome::solved) {
      check_solution(p, program);
      ++solved;
    } else {
      CHECK((kind != 1 && kind != 2));
      check_proof(p, program);
      ++infeasible;
    }
  }
  CHECK(solved > problems / 3);
  CHECK(infeasible > problems / 20);
}

}  // namespace

TEST_CASE("quadratic programs in six and seven unknowns satisfy the optimality conditions") {
  sweep<6>(6000, 40);
  sweep<7>(4000, 40);
}

TEST_CASE("quadratic programs in three unknowns have the least value of all active sets") {
  Random random{std::mt19937_64(1), {}};
  for (int i = 0; i < 4000; ++i) {
    const Problem<3> p = problem<3>(random, i % 5, 9);
    QuadraticProgram<3> program(p.G, p.g);
    const Outcome outcome = program.solve(p.rows, 1e-11);
    REQUIRE(outcome != Outcome::stalled);
    if (outcome == Outcome::infeasible) {
      check_proof(p, program);
      continue;
    }
    check_solution(p, program);
    CHECK(program.value() == Approx(enumerate(p)).epsilon(1e-7).margin(1e-7));
  }
}

TEST_CASE("rows that are appended later lead to the same minimum") {
  Random random{std::mt19937_64(2), {}};
  for (int i = 0; i < 500; ++i) {
    const Problem<6> p = problem<6>(random, 1, 30);
    QuadraticProgram<6> whole(p.G, p.g), grown(p.G, p.g);
    REQUIRE(whole.solve(p.rows, 1e-11) == Outcome::solved);
    for (std::size_t k = 0; k <= p.rows.size(); ++k)
      REQUIRE(grown.solve(std::span(p.rows).first(k), 1e-11) == Outcome::solved);
    CHECK((whole.x() - grown.x()).norm() <= 1e-7 * (1 + whole.x().norm()));
  }
}
