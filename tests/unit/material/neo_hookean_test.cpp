// SPDX-License-Identifier: Apache-2.0
#include "material/neo_hookean.hpp"

#include <catch2/catch.hpp>

#include "support/material_point.hpp"

using namespace brunt;
using material::NeoHookeanResponse;
using test::Matrix;

namespace {

const NeoHookeanResponse law({1, 4, 1});  // lambda = 4, mu = 1

Matrix stretch(double axial, double lateral) {
  return Eigen::Vector3d(axial, lateral, lateral).asDiagonal().toDenseMatrix();
}

double energy(const Matrix& F) {
  const double log_J = std::log(F.determinant());
  return 0.5 * (F.squaredNorm() - 3) - log_J + 2 * log_J * log_J;
}

/// A deformation gradient with volume ratio at least 0.2.
Matrix random_gradient(std::mt19937& engine, double size) {
  for (;;) {
    const Matrix F = Matrix::Identity() + test::random_matrix(engine, size);
    if (F.determinant() > 0.2) return F;
  }
}

}  // namespace

// Roots of the closed form for mu = 1, lambda = 4. Columns: stretch, lateral stretch of uniaxial stress, its Cauchy
// stress, then axial and lateral Cauchy stress where lateral stretch is held at 1.
TEST_CASE("neo-Hookean solid in uniaxial stress and in confined stretch") {
  const double table[7][5] = {{0.5, 1.29813560415, -1.70329157293, -7.04517744448, -5.54517744448},
                              {0.7, 1.14849930695, -0.897886730667, -2.76671396536, -2.03814253679},
                              {0.9, 1.04267035727, -0.283267206056, -0.67938006959, -0.468268958479},
                              {1.1, 0.96231662477, 0.278745704917, 0.537491562925, 0.346582472016},
                              {1.5, 0.846027890093, 1.42899851876, 1.91457362162, 1.08124028829},
                              {2, 0.747239552695, 3.08187389705, 2.88629436112, 1.38629436112},
                              {3, 0.623219518359, 7.39061147723, 4.13148305156, 1.46481638489}};
  for (const auto& [axial, lateral, uniaxial, confined, confined_lateral] : table) {
    double low = 0.3, high = 2;  // lateral stress rises with lateral stretch
    while (high - low > 1e-14) {
      const double middle = 0.5 * (low + high);
      (test::cauchy_stress(law, stretch(axial, middle))(1, 1) > 0 ? high : low) = middle;
    }
    CHECK(low == Approx(lateral).epsilon(1e-10));
    CHECK(test::cauchy_stress(law, stretch(axial, low))(0, 0) == Approx(uniaxial).epsilon(1e-10));
    const Matrix held = test::cauchy_stress(law, stretch(axial, 1));
    CHECK(held(0, 0) == Approx(confined).epsilon(1e-10));
    CHECK(held(2, 2) == Approx(confined_lateral).epsilon(1e-10));
  }
}

TEST_CASE("neo-Hookean stress is the derivative of its energy") {
  std::mt19937 engine(2);
  const double h = 1e-5;
  for (int sample = 0; sample < 50; ++sample) {
    const Matrix F = random_gradient(engine, 0.5);
    const Matrix nominal = F.determinant() * test::cauchy_stress(law, F) * F.inverse().transpose();
    for (int c = 0; c < 9; ++c) {
      Matrix step = Matrix::Zero();
      step.data()[c] = h;
      const double derivative = (energy(F + step) - energy(F - step)) / (2 * h);
      CHECK(nominal.data()[c] == Approx(derivative).epsilon(1e-6).margin(1e-7));
    }
  }
}

TEST_CASE("neo-Hookean stress turns with the body and vanishes without deformation") {
  CHECK(test::cauchy_stress(law, Matrix::Identity()).isZero(0));
  std::mt19937 engine(4);
  const Matrix F = random_gradient(engine, 0.4);
  const Matrix R = Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  CHECK(test::cauchy_stress(law, R).isZero(1e-14));
  CHECK(test::cauchy_stress(law, R * F).isApprox(R * test::cauchy_stress(law, F) * R.transpose(), 1e-12));
}

TEST_CASE("neo-Hookean tangent bounds the stiffness at any deformation, and is exact without one") {
  std::mt19937 engine(9);
  for (int sample = 0; sample < 300; ++sample) {
    const Matrix F0 = random_gradient(engine, 0.02 + 0.004 * sample);
    const double J0 = F0.determinant();
    const auto nominal = [&](const Matrix& H) -> Matrix {  // with respect to the current configuration
      const Matrix step = Matrix::Identity() + H;
      return step.determinant() * test::cauchy_stress(law, step * F0) * step.inverse().transpose();
    };
    Pack F[9], lambda, mu;
    test::set_full(F0, F);
    law.tangent(F, lambda, mu);
    const test::Matrix9 slack = test::bound_form(lambda[0], mu[0]) - test::stiffness_form(nominal, 1e-5);
    CHECK(test::smallest_eigenvalue(slack) > -1e-7 * (lambda[0] + mu[0]));
    CHECK(lambda[0] == Approx(4 / J0).epsilon(1e-12));
  }
  Pack F[9], lambda, mu;
  test::set_full(Matrix::Identity(), F);
  law.tangent(F, lambda, mu);
  CHECK(lambda[0] == 4);
  CHECK(mu[0] == Approx(1).epsilon(1e-15));
}
