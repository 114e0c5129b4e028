// SPDX-License-Identifier: Apache-2.0
// What needs no template stands here: Eigen's decompositions take seconds to compile, once in place of once a test.
#include "support/material_point.hpp"

namespace brunt::test {

Matrix symmetric_matrix(const Pack* s, int lane) {
  Matrix m;
  m << s[0][lane], s[3][lane], s[5][lane], s[3][lane], s[1][lane], s[4][lane], s[5][lane], s[4][lane], s[2][lane];
  return m;
}

void set_symmetric(const Matrix& m, Pack (&s)[6]) {
  const double entry[6] = {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)};
  for (int c = 0; c < 6; ++c) s[c] = broadcast(entry[c]);
}

void set_full(const Matrix& m, Pack (&F)[9]) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) F[3 * i + j] = broadcast(m(i, j));
}

Matrix random_matrix(std::mt19937& engine, double size) {
  std::uniform_real_distribution<double> entry(-size, size);
  return Matrix::NullaryExpr([&] { return entry(engine); });
}

double equivalent(const Matrix& s) {
  const Matrix deviator = s - Matrix::Identity() * (s.trace() / 3);
  return std::sqrt(1.5) * deviator.norm();
}

Matrix midpoint_gradient(const Matrix& before, const Matrix& after) {
  return (after - before) * (0.5 * (before + after)).inverse();
}

Matrix9 bound_form(double lambda, double mu) {
  const Matrix unit = Matrix::Identity();
  const Eigen::Map<const Eigen::Matrix<double, 9, 1>> trace(unit.data());
  return 2 * mu * Matrix9::Identity() + lambda * trace * trace.transpose();
}

double smallest_eigenvalue(const Matrix9& form) {
  return Eigen::SelfAdjointEigenSolver<Matrix9>(form).eigenvalues()[0];
}

}  // namespace brunt::test
