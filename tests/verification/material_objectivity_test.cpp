// SPDX-License-Identifier: Apache-2.0
// Large rotation and shear of rate laws against closed forms.
#include <catch2/catch.hpp>
#include <numbers>

#include "material/elastic.hpp"
#include "material/j2.hpp"
#include "support/material_point.hpp"

using namespace brunt;
using test::Matrix;
using test::RatePoint;

namespace {

const material::ElasticResponse unit_shear({1, 2.6, 0.3});  // mu = 1

/// Stress after simple shear to `end` in equal steps.
Matrix sheared(double end, int steps) {
  RatePoint<material::ElasticResponse> point{unit_shear};
  Matrix before = Matrix::Identity();
  for (int i = 1; i <= steps; ++i) {
    Matrix after = Matrix::Identity();
    after(0, 1) = end * i / steps;
    point.deform(before, after);
    before = after;
  }
  return point.cauchy();
}

double shear_error(double end, int steps) {
  const Matrix s = sheared(end, steps);
  return std::hypot(s(0, 1) - std::sin(end), s(0, 0) - (1 - std::cos(end)));
}

Matrix rotation(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 1, 1).normalized()).toRotationMatrix();
}

}  // namespace

// J. K. Dienes, Acta Mechanica 32 (1979) 217: Jaumann rate, mu = 1: s12 = sin g, s11 = -s22 = 1 - cos g.
TEST_CASE("simple shear follows the Jaumann rate, of second order in the step", "[oracle]") {
  for (const double g : {0.1, 0.5, 1.0, 4.0}) {
    CHECK(shear_error(g, 2000) < 1e-6 * g * g);
    const double order = std::log2(shear_error(g, 20) / shear_error(g, 40));
    CHECK(order == Approx(2).margin(0.05));
  }
  const Matrix s = sheared(1, 100);
  CHECK(s(1, 1) == Approx(-s(0, 0)).epsilon(1e-12));
  CHECK(s(2, 2) == 0);
}

TEST_CASE("rigid rotation carries the stress with it: 360 degrees about (1,1,1) in 1000 steps", "[law]") {
  RatePoint<material::ElasticResponse> point{material::ElasticResponse({7800, 200e9, 0.3})};
  const Matrix prestress = Eigen::Vector3d(1e9, 0, 0).asDiagonal().toDenseMatrix();
  test::set_symmetric(prestress, point.stress);
  double worst = 0;
  for (int i = 1; i <= 1000; ++i) {
    const double step = 2 * std::numbers::pi / 1000;
    point.deform(rotation((i - 1) * step), rotation(i * step));
    const Matrix R = rotation(i * step);
    worst = std::max(worst, (point.cauchy() - R * prestress * R.transpose()).norm() / 1e9);
  }
  CHECK(worst < 1e-10);
}

TEST_CASE("plastic flow of a body that also turns is the turned flow, back stress included", "[law]") {
  const material::J2 constants{7800, 200e9, 0.3, 400e6, 2e9, {}, 0.6};
  RatePoint<material::J2Response<false, true>> still{material::J2Response<false, true>(constants)}, turning = still;
  const int steps = 4000;
  const auto stretch = [&](int i) {
    Matrix F = Matrix::Identity();
    F(0, 0) += 0.02 * i / steps;
    F(1, 1) -= 0.01 * i / steps;
    return F;
  };
  for (int i = 1; i <= steps; ++i) {
    still.deform(stretch(i - 1), stretch(i));
    turning.deform(rotation(1.5 * (i - 1) / steps) * stretch(i - 1), rotation(1.5 * i / steps) * stretch(i));
  }
  const Matrix R = rotation(1.5);
  CHECK(still.plastic_strain() > 0.01);
  CHECK(turning.plastic_strain() == Approx(still.plastic_strain()).epsilon(1e-6));
  CHECK(turning.cauchy().isApprox(R * still.cauchy() * R.transpose(), 1e-5));
  CHECK(test::symmetric_matrix(turning.tensors)
            .isApprox(R * test::symmetric_matrix(still.tensors) * R.transpose(), 1e-4));
}
