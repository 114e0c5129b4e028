// SPDX-License-Identifier: Apache-2.0
// Linear systems on one rank: accuracy, repeated use, and matrices that cannot be factorised.
#include "comm/linear_system.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "support/sparse_problems.hpp"

using namespace brunt;
using namespace brunt::test;
using comm::Communicator;
using comm::FactorStatus;
using comm::LinearMethod;
using comm::LinearSystem;

namespace {

// Refinement stops at twice the spacing of the numbers, or where it does not help any more.
constexpr double backward_accuracy = 1e-15;

LinearSystem system_of(const SparseMatrix& matrix, LinearMethod method = LinearMethod::direct) {
  return {Communicator::self(), method, static_cast<GlobalIndex>(matrix.size()), all_rows(matrix)};
}

std::vector<double> solution(LinearSystem& system, const SparseMatrix& matrix) {
  const std::vector<GlobalIndex> rows = all_rows(matrix);
  const comm::Factorised done = system.factorise(rows_of(matrix, rows));
  INFO(done.message);
  REQUIRE(done.ok());
  std::vector<double> x(rows.size());
  CHECK(system.solve(load_of(rows), x) < backward_accuracy);
  return x;
}

SparseMatrix held_and_free(int n, double modulus) {
  SparseMatrix matrix;
  add_block(matrix, {.elements = {n, n, n}, .held = true});
  add_block(matrix, {.elements = {n, n, n}, .modulus = modulus});
  return matrix;
}

std::vector<double> product(const SparseMatrix& matrix, const std::vector<double>& x) {
  std::vector<double> y;
  for (const auto& row : matrix) {
    double sum = 0;
    for (const auto& [column, value] : row) sum += value * x[static_cast<std::size_t>(column)];
    y.push_back(sum);
  }
  return y;
}

double largest(const std::vector<double>& values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

}  // namespace

TEST_CASE("a small unsymmetric matrix with a zero on its diagonal is solved to rounding") {
  const SparseMatrix matrix{{{0, 2.0}, {1, 1.0}}, {{0, 1.0}, {2, 3.0}}, {{1, -1.0}, {2, 1.0}}};
  LinearSystem system = system_of(matrix);
  REQUIRE(system.factorise(rows_of(matrix, all_rows(matrix))).ok());
  std::vector<double> x(3);
  const std::vector<double> b{4, 10, 1};  // of x = (1, 2, 3)
  system.solve(b, x);
  for (std::size_t i = 0; i < 3; ++i) CHECK(x[i] == Approx(static_cast<double>(i + 1)).epsilon(1e-14));
}

TEST_CASE("an elastic block and a saddle point system are solved to rounding") {
  for (const SparseMatrix& matrix : {held_block(6), tied_blocks(6)}) {
    LinearSystem system = system_of(matrix);
    const std::vector<double> x = solution(system, matrix);
    const std::vector<double> b = load_of(all_rows(matrix)), product_of_x = product(matrix, x);
    for (std::size_t i = 0; i < b.size(); ++i) CHECK(product_of_x[i] == Approx(b[i]).margin(1e-12));
  }
}

TEST_CASE("the bits of a solution do not depend on the matrices before, nor on whether elimination is ordered anew") {
  const SparseMatrix tied = tied_blocks(4);
  SparseMatrix stiffer = tied, fewer = tied;  // the same pattern; ties that are opened
  for (auto& row : stiffer)
    for (auto& [column, value] : row) value *= 1 + 0.1 * std::sin(static_cast<double>(column));
  for (std::size_t i = fewer.size() - 30; i < fewer.size(); ++i) {
    for (const auto& [column, value] : fewer[i]) fewer[static_cast<std::size_t>(column)].erase(static_cast<long>(i));
    fewer[i] = {{static_cast<GlobalIndex>(i), 1.0}};
  }
  fewer.back() = tied.back();
  for (const auto& [column, value] : tied.back())
    fewer[static_cast<std::size_t>(column)][static_cast<GlobalIndex>(fewer.size()) - 1] = value;

  LinearSystem fresh_stiffer = system_of(tied), fresh_fewer = system_of(tied), used = system_of(tied);
  const std::vector<double> alone = solution(fresh_stiffer, stiffer), opened = solution(fresh_fewer, fewer);
  solution(used, tied);
  CHECK_FALSE(used.factorise(rows_of(stiffer, all_rows(stiffer))).analysed);
  CHECK(solution(used, stiffer) == alone);
  CHECK(used.factorise(rows_of(fewer, all_rows(fewer))).analysed);
  CHECK(solution(used, fewer) == opened);
  CHECK(solution(used, stiffer) == alone);
}

TEST_CASE("a block that floats is found, with its six motions") {
  for (const LinearMethod method : {LinearMethod::direct, LinearMethod::mumps})
    for (const double modulus : {1e-6, 1.0, 1e6}) {
      const SparseMatrix matrix = held_and_free(4, modulus);
      LinearSystem system = system_of(matrix, method);
      const comm::Factorised done = system.factorise(rows_of(matrix, all_rows(matrix)));
      INFO(modulus);
      REQUIRE(done.status == FactorStatus::singular);
      CHECK(done.null_pivots == 6);
      for (GlobalIndex which = 0; which < 6; ++which) {
        const std::vector<double> direction = system.null_direction(which);
        REQUIRE(direction.size() == matrix.size());
        CHECK(largest(direction) == 1);
        CHECK(largest(product(matrix, direction)) < 1e-12 * modulus);
        const auto middle = direction.begin() + static_cast<long>(direction.size() / 2);
        CHECK(largest({direction.begin(), middle}) < 1e-12);
      }
      CHECK(system.null_direction(6).empty());
      std::vector<double> x(matrix.size());
      CHECK_THROWS(system.solve(load_of(all_rows(matrix)), x));
    }
}

TEST_CASE("bodies whose stiffness is lost in rounding are found whatever their shape") {
  SparseMatrix cube, plate, beam, pair;
  add_block(cube, {.elements = {8, 8, 8}});
  add_block(plate, {.elements = {20, 20, 1}, .size = {20, 20, 0.1}});
  add_block(beam, {.elements = {1, 1, 200}, .size = {1, 1, 100}});
  const ElasticBlock soft{.elements = {4, 4, 4}}, stiff{.elements = {4, 4, 4}, .modulus = 1e5};
  const GlobalIndex first = add_block(pair, soft), second = add_block(pair, stiff);
  add_tie(pair, soft, first, second);
  for (const SparseMatrix& matrix : {cube, plate, beam, pair}) {
    LinearSystem system = system_of(matrix);
    const comm::Factorised done = system.factorise(rows_of(matrix, all_rows(matrix)));
    CHECK(done.status == FactorStatus::singular);
    CHECK(done.null_pivots == 6);
  }
}

TEST_CASE("a slender cantilever and a soft body on a stiff one are held") {
  SparseMatrix cantilever, stack;  // 100 times as long as thick: its lowest stiffness is 1e-7 of its highest
  add_block(cantilever, {.elements = {1, 1, 200}, .held = true, .size = {1, 1, 100}});
  const ElasticBlock steel{.elements = {3, 3, 3}, .held = true, .modulus = 2e11},
      rubber{.elements = {3, 3, 3}, .modulus = 1e6};
  const GlobalIndex first = add_block(stack, steel), second = add_block(stack, rubber);
  add_tie(stack, steel, first, second);
  for (const SparseMatrix& matrix : {cantilever, stack}) {
    LinearSystem system = system_of(matrix);
    solution(system, matrix);
  }
}

TEST_CASE("equations and multipliers in units of their own are no sign of a body that floats") {
  for (const double unit : {1e-9, 1e9}) {
    SparseMatrix tied = tied_blocks(4), floats = tied;
    floats.clear();
    add_block(floats, {.elements = {3, 3, 3}});
    for (std::size_t row = 0; row < tied.size(); ++row)
      if (!tied[row].contains(static_cast<GlobalIndex>(row)) || tied[row].at(static_cast<GlobalIndex>(row)) == 0)
        for (auto& [column, value] : tied[row]) value *= unit;  // a multiplier's equation, not its column
    for (auto& [column, value] : floats[7]) value *= unit;
    LinearSystem system = system_of(tied);
    solution(system, tied);
    LinearSystem free = system_of(floats);
    CHECK(free.factorise(rows_of(floats, all_rows(floats))).status == FactorStatus::singular);
  }
}

TEST_CASE("a row of zeros, a row twice: singular, and usable again afterwards") {
  const SparseMatrix good = held_block(2);
  SparseMatrix empty_row = good, twice = good;
  empty_row[40].clear();
  twice[40] = twice[41];
  LinearSystem system = system_of(good);
  const std::vector<double> x = solution(system, good);
  for (const SparseMatrix& matrix : {empty_row, twice}) {
    const comm::Factorised done = system.factorise(rows_of(matrix, all_rows(matrix)));
    CHECK(done.status == FactorStatus::singular);
    CHECK(done.null_pivots == 1);
    CHECK(largest(product(matrix, system.null_direction())) < 1e-14);
    CHECK(solution(system, good) == x);
  }
}

TEST_CASE("values that are not finite are refused") {
  SparseMatrix matrix = held_block(2);
  LinearSystem system = system_of(matrix);
  solution(system, matrix);
  std::vector<double> b = load_of(all_rows(matrix)), x(b.size());
  b[7] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(system.solve(b, x), GuardError);
  matrix[50].begin()->second = std::numeric_limits<double>::infinity();
  const comm::Factorised done = system.factorise(rows_of(matrix, all_rows(matrix)));
  CHECK(done.status == FactorStatus::not_finite);
  CHECK(done.row == 50);
}

TEST_CASE("rows that do not fit the system are a fault of the caller") {
  const SparseMatrix matrix = held_block(1);
  const Communicator self = Communicator::self();
  const std::vector<GlobalIndex> rows = all_rows(matrix), fewer(rows.begin(), rows.end() - 1);
  CHECK_THROWS(LinearSystem(self, LinearMethod::direct, 24, fewer));
  CHECK_THROWS(LinearSystem(self, LinearMethod::direct, 23, rows));
  CHECK_THROWS(LinearSystem(self, LinearMethod::direct, 3, std::vector<GlobalIndex>{0, 2, 1}));
  LinearSystem system = system_of(matrix);
  CHECK_THROWS(system.factorise(rows_of(matrix, fewer)));
  comm::SparseRows unordered = rows_of(matrix, rows);
  std::swap(unordered.column[unordered.column.size() - 1], unordered.column[unordered.column.size() - 2]);
  CHECK_THROWS(system.factorise(unordered));
  CHECK(system.null_direction().empty());
}
