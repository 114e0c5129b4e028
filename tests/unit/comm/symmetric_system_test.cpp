// SPDX-License-Identifier: Apache-2.0
// The inertia of symmetric matrices L D L^T with known D (Sylvester's law), and of saddle points.
#include "comm/symmetric_system.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

using namespace brunt;

namespace {

using Dense = std::vector<std::vector<double>>;

comm::SparseRows halves_of(const Dense& matrix) {
  comm::SparseRows rows;
  rows.begin.push_back(0);
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    rows.row.push_back(static_cast<GlobalIndex>(i));
    for (std::size_t j = 0; j < matrix.size(); ++j)
      if (matrix[i][j] != 0) {
        rows.column.push_back(static_cast<GlobalIndex>(j));
        rows.value.push_back(i == j ? matrix[i][j] : 0.5 * matrix[i][j]);
      }
    rows.begin.push_back(static_cast<std::int64_t>(rows.column.size()));
  }
  return rows;
}

void check(const Dense& matrix, GlobalIndex negative) {
  const comm::SparseRows rows = halves_of(matrix);
  comm::SymmetricSystem system(comm::Communicator::self(), comm::LinearMethod::direct,
                               static_cast<GlobalIndex>(matrix.size()), rows.row);
  for (int again = 0; again < 2; ++again) {
    const comm::Inertia inertia = system.factorise(rows);
    INFO(inertia.message);
    REQUIRE(inertia.found);
    CHECK(inertia.negative == negative);
  }
  std::vector<double> x(matrix.size());
  system.solve(std::vector<double>(matrix.size(), 1.0), x);
  for (const std::vector<double>& row : matrix) {
    double sum = 0;
    for (std::size_t j = 0; j < row.size(); ++j) sum += row[j] * x[j];
    CHECK(sum == Approx(1).epsilon(1e-7));
  }
}

/// L D L^T with a sparse random L.
Dense product(std::mt19937& random, const std::vector<double>& diagonal) {
  std::uniform_real_distribution<double> number(-1, 1);
  const std::size_t n = diagonal.size();
  Dense lower(n, std::vector<double>(n, 0.0)), matrix = lower;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) lower[i][j] = i == j ? 1 : number(random) > 0.4 ? number(random) : 0.0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < n; ++k) matrix[i][j] += lower[i][k] * diagonal[k] * lower[j][k];
  return matrix;
}

}  // namespace

TEST_CASE("Negative eigenvalues of random symmetric matrices are counted, and the factors solve") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (std::size_t size = 2; size < 24; ++size) {
    std::vector<double> diagonal;
    GlobalIndex negative = 0;
    for (std::size_t i = 0; i < size; ++i) {
      diagonal.push_back(number(random) > 0 ? 1 : -1);
      negative += diagonal.back() < 0 ? 1 : 0;
    }
    check(product(random, diagonal), negative);
  }
}

TEST_CASE("Each constraint of a stable body counts as one negative eigenvalue") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (std::size_t constraints = 0; constraints < 6; ++constraints) {
    constexpr std::size_t unknowns = 15;
    Dense matrix = product(random, std::vector<double>(unknowns, 1.0));
    for (std::vector<double>& row : matrix) row.resize(unknowns + constraints, 0.0);
    for (std::size_t c = 0; c < constraints; ++c) {
      std::vector<double> row(unknowns + constraints, 0.0);
      for (std::size_t k = 0; k < 4; ++k) row[(3 * c + k) % unknowns] = number(random);
      for (std::size_t i = 0; i < unknowns; ++i) matrix[i][unknowns + c] = row[i];
      matrix.push_back(std::move(row));
    }
    check(matrix, static_cast<GlobalIndex>(constraints));
  }
}
