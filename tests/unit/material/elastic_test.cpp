// SPDX-License-Identifier: Apache-2.0
#include "material/elastic.hpp"

#include <catch2/catch.hpp>

#include "support/material_point.hpp"

using namespace brunt;
using test::Matrix;

TEST_CASE("moduli of steel: cp and cs as tabulated for E = 200 GPa, nu = 0.3, rho = 7800") {
  const material::ElasticModuli steel = material::initial_moduli(material::Elastic{7800, 200e9, 0.3});
  CHECK(steel.lambda == Approx(200e9 * 0.3 / (1.3 * 0.4)).epsilon(1e-14));
  CHECK(steel.mu == Approx(200e9 / 2.6).epsilon(1e-14));
  CHECK(material::initial_moduli(material::J2{7800, 200e9, 0.3, 4e8, 0, {}, 0}).mu == steel.mu);
  CHECK(material::initial_moduli(material::NeoHookean{1, 4, 2}).lambda == 4);
}

TEST_CASE("elastic stress is Hooke's law, inverted by Young's modulus and Poisson's ratio") {
  test::RatePoint<material::ElasticResponse> point{material::ElasticResponse({1, 200e9, 0.3})};
  Matrix strain = Matrix::Zero();
  strain.diagonal() << 1e-3, -0.3e-3, -0.3e-3;  // uniaxial stress along x
  strain(0, 1) = strain(1, 0) = 2e-4;
  point.strain(strain);
  const Matrix s = point.cauchy();
  CHECK(s(0, 0) == Approx(200e6).epsilon(1e-13));
  CHECK(std::abs(s(1, 1)) < 1e-6);
  CHECK(std::abs(s(2, 2)) < 1e-6);
  CHECK(s(0, 1) == Approx(2 * 200e9 / 2.6 * 2e-4).epsilon(1e-13));
  CHECK(s(1, 2) == 0);
}

TEST_CASE("rate-law tangent bounds the power of the nominal stress, initial stress included") {
  std::mt19937 engine(7);
  const material::ElasticResponse law({1, 1.0, 0.3});
  for (int sample = 0; sample < 200; ++sample) {
    Matrix s0 = test::random_matrix(engine, sample < 100 ? 0.05 : 0.5);
    s0 = (0.5 * (s0 + s0.transpose())).eval();
    const auto nominal = [&](const Matrix& H) -> Matrix {
      test::RatePoint<material::ElasticResponse> point{law};
      test::set_symmetric(s0, point.stress);
      const Matrix F = Matrix::Identity() + H;
      point.deform(Matrix::Identity(), F);
      return F.determinant() * point.cauchy() * F.inverse().transpose();
    };
    Pack stress[6], lambda, mu;
    test::set_symmetric(s0, stress);
    law.tangent(stress, lambda, mu);
    const test::Matrix9 slack = test::bound_form(lambda[0], mu[0]) - test::stiffness_form(nominal, 1e-5);
    CHECK(test::smallest_eigenvalue(slack) > -1e-8);
  }
}

TEST_CASE("rate-law tangent without stress is the elastic one: nothing of the step is given away") {
  const material::ElasticResponse law({1, 1.0, 0.3});
  Pack stress[6]{}, lambda, mu;
  law.tangent(stress, lambda, mu);
  CHECK(lambda[3] == law.lambda);
  CHECK(mu[3] == law.mu);
}

TEST_CASE("the rate-law tangent, and with it the stable step, does not see how the scene is turned") {
  std::mt19937 engine(11);
  const material::ElasticResponse law({1, 1.0, 0.3});
  for (int sample = 0; sample < 50; ++sample) {
    Matrix s = test::random_matrix(engine, 0.3);
    s = (0.5 * (s + s.transpose())).eval();
    const Matrix turn = Eigen::HouseholderQR<Matrix>(test::random_matrix(engine, 1.0)).householderQ();
    Pack stress[6], lambda, mu, turned_lambda, turned_mu;
    test::set_symmetric(s, stress);
    law.tangent(stress, lambda, mu);
    test::set_symmetric(turn * s * turn.transpose(), stress);
    law.tangent(stress, turned_lambda, turned_mu);
    CHECK(turned_lambda[0] == Approx(lambda[0]).epsilon(1e-13));
    CHECK(turned_mu[0] == Approx(mu[0]).epsilon(1e-13));
  }
}
