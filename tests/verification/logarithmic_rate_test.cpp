// SPDX-License-Identifier: Apache-2.0
// Rate laws with the logarithmic rate: elastic stress of ln V, whatever the path, in every kind of element.
#include <catch2/catch.hpp>
#include <numbers>

#include "element/hex8.hpp"
#include "element/hex8_full.hpp"
#include "element/tet4.hpp"
#include "material/elastic.hpp"
#include "material/j2.hpp"
#include "support/element_bench.hpp"

using namespace brunt;
using element::HourglassKind;
using test::Corners;
using test::ElementBench;
using test::Matrix;
using test::RatePoint;

namespace {

using Elastic = material::Logarithmic<material::ElasticResponse>;
const Elastic unit_shear{material::Elastic{1, 2.6, 0.3}};  // mu = 1

Matrix rotation(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
}

Matrix shear(double g) {
  Matrix F = Matrix::Identity();
  F(0, 1) = g;
  return F;
}

/// lambda tr(ln V) 1 + 2 mu ln V
Matrix stress_of(const Matrix& F, const Elastic& law = unit_shear) {
  const Eigen::SelfAdjointEigenSolver<Matrix> axes(F * F.transpose());
  const Eigen::Vector3d half_log = 0.5 * axes.eigenvalues().array().log();
  const Matrix h = axes.eigenvectors() * half_log.asDiagonal() * axes.eigenvectors().transpose();
  return law.lambda * h.trace() * Matrix::Identity() + 2 * law.mu * h;
}

/// Largest deviation from stress_of along F(0 .. 1) in equal steps, over the largest stress.
template <class Path>
double path_error(const Path& F, int steps) {
  RatePoint<Elastic> point{unit_shear};
  double error = 0, largest = 0;
  for (int i = 1; i <= steps; ++i) {
    const Matrix now = F(static_cast<double>(i) / steps);
    point.deform(F(static_cast<double>(i - 1) / steps), now);
    const Matrix expected = stress_of(now);
    error = std::max(error, (point.cauchy() - expected).norm());
    largest = std::max(largest, expected.norm());
  }
  return error / largest;
}

Corners<4> unit_tetrahedron() {
  Corners<4> X;
  X << 0, 1, 0, 0,  //
      0, 0, 1, 0,   //
      0, 0, 0, 1;
  return X;
}

template <class Kernel>
Kernel kernel_of() {
  if constexpr (requires(Kernel k) { k.control; })
    return {unit_shear, {HourglassKind::stiffness, 0.05}, {0, 0}};
  else
    return {unit_shear, {0, 0}};
}

template <class Kernel>
Corners<Kernel::nodes> shape_of() {
  if constexpr (Kernel::nodes == 4)
    return unit_tetrahedron();
  else
    return test::unit_cube();
}

}  // namespace

// reference/cases A8: the table of closed forms, 2 ln V for mu = 1.
TEST_CASE("simple shear with the logarithmic rate gives 2 ln V, of second order in the step", "[oracle]") {
  struct Known {
    double g, s12, s11;
  };
  for (const Known& known : {Known{0.5, 0.4801555, 0.1200389}, Known{1, 0.8608179, 0.4304089}}) {
    RatePoint<Elastic> point{unit_shear};
    const int steps = 2000;
    for (int i = 1; i <= steps; ++i) point.deform(shear(known.g * (i - 1) / steps), shear(known.g * i / steps));
    CHECK(point.cauchy()(0, 1) == Approx(known.s12).margin(1e-7));
    CHECK(point.cauchy()(0, 0) == Approx(known.s11).margin(1e-7));
    CHECK(point.cauchy()(1, 1) == Approx(-known.s11).margin(1e-7));
  }
  // beyond, up to where the continued fraction of the spin ends: the error that stays is that of its last term
  struct Beyond {
    double g, error;
  };
  for (const Beyond& far : {Beyond{2, 1e-6}, Beyond{4, 1e-5}, Beyond{10, 1e-3}})
    CHECK(path_error([&](double s) { return shear(far.g * s); }, 8000) < far.error);
  for (const double g : {0.5, 1.0, 2.0}) {
    const auto path = [&](double s) { return shear(g * s); };
    CHECK(std::log2(path_error(path, 20) / path_error(path, 40)) == Approx(2).margin(0.1));
  }
}

TEST_CASE("the logarithmic rate: stretch, shear and turns at once give the stress of ln V, of second order",
          "[oracle]") {
  std::mt19937 engine(1);
  for (int sample = 0; sample < 10; ++sample) {
    const Matrix G = test::random_matrix(engine, 0.6), H = test::random_matrix(engine, 0.3);
    const auto path = [&](double s) -> Matrix {
      return rotation(4 * s) * (Matrix::Identity() + s * G + std::sin(3 * s) * H);
    };
    if (path(1).determinant() < 0.3 || path(0.5).determinant() < 0.3) continue;
    CHECK(path_error(path, 4000) < 3e-6);
    CHECK(std::log2(path_error(path, 200) / path_error(path, 400)) == Approx(2).margin(0.15));
  }
}

// What no other corotational rate does (M. Kojic, K. J. Bathe, Int. J. Numer. Meth. Eng. 24 (1987) 1531).
TEST_CASE("a closed path of large strain leaves no stress with the logarithmic rate; with Jaumann's it does", "[law]") {
  const auto path = [](double s) -> Matrix {
    const double turn = 2 * std::numbers::pi * s;
    Matrix F = shear(0.7 * std::sin(turn));
    F(1, 1) = std::exp(0.35 * (1 - std::cos(turn)));
    return F;
  };
  RatePoint<Elastic> logarithmic{unit_shear};
  RatePoint<material::ElasticResponse> jaumann{material::ElasticResponse(material::Elastic{1, 2.6, 0.3})};
  const int steps = 4000;
  for (int cycle = 0; cycle < 5; ++cycle)
    for (int i = 1; i <= steps; ++i) {
      const Matrix before = path(static_cast<double>(i - 1) / steps), now = path(static_cast<double>(i) / steps);
      logarithmic.deform(before, now);
      jaumann.deform(before, now);
    }
  CHECK(logarithmic.cauchy().norm() < 1e-5);
  CHECK(jaumann.cauchy().norm() > 0.1);
}

TEST_CASE("the logarithmic rate: rigid rotation carries the stress of a strained body with it", "[law]") {
  RatePoint<Elastic> point{unit_shear};
  const int steps = 500;
  for (int i = 1; i <= steps; ++i) point.deform(shear(1.0 * (i - 1) / steps), shear(1.0 * i / steps));
  const Matrix start = point.cauchy();
  for (int i = 1; i <= 36; ++i) {
    const double step = std::numbers::pi / 18;
    point.deform(rotation((i - 1) * step) * shear(1), rotation(i * step) * shear(1));
    CHECK((point.cauchy() - rotation(i * step) * start * rotation(i * step).transpose()).norm() < 1e-13);
  }
}

TEMPLATE_TEST_CASE("every kind of element takes the logarithmic rate: shear to 1 while it turns", "[oracle]",
                   (element::Hex8<Elastic, HourglassKind::stiffness>), (element::Hex8<Elastic, HourglassKind::viscous>),
                   (element::Hex8Full<Elastic, false>), (element::Hex8Full<Elastic, true>), (element::Tet4<Elastic>)) {
  const auto X = shape_of<TestType>();
  const auto error = [&](int steps) {
    ElementBench<TestType> bench{kernel_of<TestType>(), X, 1};
    const auto F = [&](int i) -> Matrix {
      const double s = static_cast<double>(i) / steps;
      return rotation(2 * s) * shear(s);
    };
    bench.move(X, X);
    for (int i = 1; i <= steps; ++i) bench.move(F(i - 1) * X, F(i) * X);
    double worst = 0;
    for (int p = 0; p < (TestType::Memory::at_tensors - 1) / 6; ++p)
      worst = std::max(worst, (bench.stress(p) - stress_of(F(steps))).norm());
    return worst;
  };
  CHECK(error(1000) < 1e-5);
  CHECK(std::log2(error(100) / error(200)) == Approx(2).margin(0.1));
}

TEMPLATE_TEST_CASE("the step bound holds for a free element with the logarithmic rate, strained and turned", "[law]",
                   (element::Hex8<Elastic, HourglassKind::none>), (element::Hex8Full<Elastic, false>),
                   (element::Tet4<Elastic>)) {
  std::mt19937 engine(2);
  const auto X = shape_of<TestType>();
  for (int sample = 0; sample < 40; ++sample) {
    const Matrix G = test::random_matrix(engine, 0.04 * (sample % 10));
    ElementBench<TestType> bench{kernel_of<TestType>(), X, 1};
    const int steps = 20;
    const auto F = [&](int i) -> Matrix { return rotation(0.1 * i) * (Matrix::Identity() + G * i / steps); };
    for (int i = 1; i <= steps; ++i) bench.move(F(i - 1) * X, F(i) * X);
    const Corners<TestType::nodes> x = F(steps) * X;
    const auto answer = bench.move(x, x);
    const double stiffest = test::eigenvalues(bench.stiffness(x)).maxCoeff();
    CAPTURE(sample, answer.rate, stiffest);
    CHECK(answer.rate >= 0.5 * std::sqrt(TestType::nodes * stiffest) * (1 - 1e-6));
  }
}

// J. C. Nagtegaal, J. E. de Jong 1982: with Jaumann's rate the back stress of kinematic hardening swings in large
// shear.
TEST_CASE("kinematic hardening in large shear: the stress swings with Jaumann's rate, and does not with this one",
          "[law]") {
  const material::J2 constants{1, 2600, 0.3, 1, 20, {}, 1};  // mu = 1000
  using Law = material::J2Response<false, true>;
  RatePoint<Law> jaumann{Law(constants)};
  RatePoint<material::Logarithmic<Law>> logarithmic{material::Logarithmic<Law>(constants)};
  const double end = 6;
  const int steps = 12000;
  double largest = 0, least_jaumann = 0, before = 0, falls = 0;
  for (int i = 1; i <= steps; ++i) {
    const Matrix from = shear(end * (i - 1) / steps), to = shear(end * i / steps);
    jaumann.deform(from, to);
    logarithmic.deform(from, to);
    least_jaumann = std::min(least_jaumann, jaumann.cauchy()(0, 1));
    const double now = logarithmic.cauchy()(0, 1);
    falls = std::max(falls, largest - now);
    largest = std::max(largest, now);
    before = now;
  }
  CHECK(before > 0);
  CHECK(least_jaumann < 0);  // it comes to push back
  CHECK(falls < 0.5 * largest);
  CHECK(logarithmic.plastic_strain() == Approx(end / std::sqrt(3.0)).epsilon(0.01));
}
