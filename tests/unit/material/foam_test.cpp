// SPDX-License-Identifier: Apache-2.0
#include "material/foam.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "support/metal_point.hpp"

using namespace brunt;
using test::Matrix;
using Point = test::MetalPoint<material::FoamResponse>;

namespace {

const material::Foam foam{200, 50e6, {{0, 1e6}, {0.6, 1.2e6}}, 0.3e6};

void crush_to(Point& point, double& lost, double end) {
  const int steps = 200;
  for (int k = 0; k < steps; ++k) {
    Matrix before = Matrix::Identity(), after = before;
    before(2, 2) = 1 - lost;
    lost += (end - lost) / (steps - k);
    after(2, 2) = 1 - lost;
    point.deform(before, after, 1e-6);
  }
}

}  // namespace

TEST_CASE("foam that is crushed follows its table, and is elastic beyond it", "[oracle]") {
  const double table[][2] = {{0.005, 0.25},        {0.02, 1},  {0.1, 1.03333333333}, {0.3, 1.1},
                             {0.5, 1.16666666667}, {0.6, 1.2}, {0.65, 3.7}};  // a9_foam.csv, MPa
  Point point{material::FoamResponse(foam)};
  double lost = 0;
  for (const auto& [end, stress] : table) {
    crush_to(point, lost, end);
    CHECK(-point.cauchy()(2, 2) == Approx(stress * 1e6).epsilon(1e-4));
    CHECK(point.cauchy()(0, 0) == 0);
  }
}

TEST_CASE("foam unloads elastically and breaks in tension", "[oracle]") {
  Point point{material::FoamResponse(foam)};
  double lost = 0;
  crush_to(point, lost, 0.3);
  crush_to(point, lost, 0.29);
  CHECK(-point.cauchy()(2, 2) == Approx(1.1e6 - 50e6 * 0.01).epsilon(1e-4));
  crush_to(point, lost, 0.2);
  CHECK(point.cauchy()(2, 2) == Approx(0.3e6).epsilon(1e-9));
}

TEST_CASE("principal values and axes are those of a dense solver", "[oracle]") {
  std::mt19937 engine(3);
  for (int k = 0; k < 200; ++k) {
    Matrix m = test::random_matrix(engine, 1);
    m = (m + m.transpose()).eval();
    if (k % 4 == 1) m = Matrix(Eigen::Vector3d(1, 1, -2).asDiagonal());
    if (k % 4 == 2) m *= 1e-9;
    Pack s[6], back[6];
    test::set_symmetric(m, s);
    const material::Principal principal(s);
    Eigen::Vector3d values(principal.value[0][0], principal.value[1][0], principal.value[2][0]);
    std::sort(values.data(), values.data() + 3);
    const Eigen::Vector3d exact = Eigen::SelfAdjointEigenSolver<Matrix>(m).eigenvalues();
    CHECK((values - exact).norm() <= 1e-14 * m.norm());
    principal.compose(back);
    CHECK((test::symmetric_matrix(back) - m).norm() <= 2e-14 * m.norm());
  }
}

TEST_CASE("the stress of foam does not depend on the frame", "[law]") {
  std::mt19937 engine(5);
  const Matrix turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  Point one{material::FoamResponse(foam)}, other{material::FoamResponse(foam)};
  Matrix F = Matrix::Identity();
  for (int k = 0; k < 50; ++k) {
    Matrix next = F + 0.01 * test::random_matrix(engine, 1) - 0.004 * Matrix::Identity();
    one.deform(F, next, 1e-6);
    other.deform(turn * F * turn.transpose(), turn * next * turn.transpose(), 1e-6);
    F = next;
  }
  CHECK((turn * one.cauchy() * turn.transpose() - other.cauchy()).norm() < 1e-9 * 1e6);
}
