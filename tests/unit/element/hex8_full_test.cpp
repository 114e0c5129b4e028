// SPDX-License-Identifier: Apache-2.0
#include "element/hex8_full.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "material/elastic.hpp"
#include "material/j2.hpp"
#include "material/neo_hookean.hpp"
#include "support/element_bench.hpp"

using namespace brunt;
using element::Hex8Full;
using material::ElasticResponse;
using material::NeoHookeanResponse;
using test::Corners;
using test::ElementBench;
using test::Matrix;

namespace {

constexpr element::BulkViscosity no_viscosity{0, 0};
template <bool bbar>
using Elastic = Hex8Full<ElasticResponse, bbar>;
template <bool bbar>
using Rubber = Hex8Full<NeoHookeanResponse, bbar>;

ElasticResponse unit_law(double poisson = 0.3) {
  return ElasticResponse({1, 1, poisson});
}

template <bool bbar>
ElementBench<Elastic<bbar>> elastic_bench(const Corners<8>& X, double poisson = 0.3) {
  return {Elastic<bbar>{unit_law(poisson), no_viscosity}, X, 1};
}

Matrix rotation(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
}

}  // namespace

// Stiffness of the unit cube, E = 1, nu = 0.3, 2x2x2 points: assembled independently from the shape functions.
TEST_CASE("full 2x2x2 cube has the textbook eigenvalues and six zero-energy modes") {
  const double expected[24] = {0,
                               0,
                               0,
                               0,
                               0,
                               0,  // rigid
                               0.06410256410256396,
                               0.06410256410256406,
                               0.11752136752136742,
                               0.11752136752136746,
                               0.1175213675213675,
                               0.1923076923076922,
                               0.1923076923076923,
                               0.19230769230769235,
                               0.2564102564102563,
                               0.3846153846153843,
                               0.38461538461538436,
                               0.3846153846153844,
                               0.3846153846153844,
                               0.3846153846153846,
                               0.3846153846153847,
                               0.38461538461538475,
                               0.38461538461538475,
                               1.2500000000000007};
  const Eigen::VectorXd found = test::eigenvalues(elastic_bench<false>(test::unit_cube()).stiffness(test::unit_cube()));
  for (int i = 0; i < 24; ++i) CHECK(found[i] == Approx(expected[i]).margin(1e-8));
}

TEMPLATE_TEST_CASE_SIG("a distorted element has only the six rigid modes without energy", "", ((bool bbar), bbar), true,
                       false) {
  std::mt19937 engine(1);
  const Corners<8> X = test::distorted_cube(engine, 0.2);
  const Eigen::VectorXd found = test::eigenvalues(elastic_bench<bbar>(X).stiffness(X));
  CHECK(std::abs(found[0]) < 1e-8);
  CHECK(std::abs(found[5]) < 1e-8);
  CHECK(found[6] > 1e-2);
}

TEST_CASE("B-bar leaves one stiff mode where the material hardly changes volume, full integration many") {
  const double poisson = 0.4999;  // lambda/mu = 4999
  const auto stiff_modes = [](const Eigen::VectorXd& found) { return (found.array() > 10.0).count(); };
  const Corners<8> X = test::unit_cube();
  CHECK(stiff_modes(test::eigenvalues(elastic_bench<true>(X, poisson).stiffness(X))) == 1);
  CHECK(stiff_modes(test::eigenvalues(elastic_bench<false>(X, poisson).stiffness(X))) > 4);
}

TEMPLATE_TEST_CASE_SIG("a linear displacement gives its stress at every point of a distorted element", "",
                       ((bool bbar), bbar), true, false) {
  std::mt19937 engine(2);
  const Corners<8> X = test::distorted_cube(engine, 0.2);
  const Matrix gradient = 1e-7 * test::random_matrix(engine, 1);
  auto bench = elastic_bench<bbar>(X);
  const auto answer = bench.move(X, X + gradient * X);
  const ElasticResponse law = unit_law();
  const Matrix strain = 0.5 * (gradient + gradient.transpose());
  const Matrix expected = law.lambda * strain.trace() * Matrix::Identity() + 2 * law.mu * strain;
  for (int p = 0; p < 8; ++p) CHECK((bench.stress(p) - expected).norm() < 1e-6 * expected.norm());
  CHECK(answer.force.rowwise().sum().norm() < 1e-13 * expected.norm());
  // sum of x (x) f is minus volume times stress: the virial theorem holds for any shape
  const Matrix virial = X * answer.force.transpose();
  CHECK(virial.trace() * expected.trace() < 0);
  CHECK((virial / virial.trace() - expected / expected.trace()).norm() < 1e-5 * (expected / expected.trace()).norm());
}

TEMPLATE_TEST_CASE_SIG("rigid rotation gives no stress and carries prestress, in steps of 30 degrees", "",
                       ((bool bbar), bbar), true, false) {
  std::mt19937 engine(3);
  const Corners<8> X = test::distorted_cube(engine, 0.15);
  auto free = elastic_bench<bbar>(X), loaded = free;
  Matrix prestress = test::random_matrix(engine, 0.01);
  prestress = (prestress + prestress.transpose()).eval();
  for (int p = 0; p < 8; ++p) loaded.set_stress(prestress, p);
  for (int step = 1; step <= 12; ++step) {
    const double angle = std::numbers::pi / 6;
    const Corners<8> before = rotation((step - 1) * angle) * X, after = rotation(step * angle) * X;
    free.move(before, after);
    loaded.move(before, after);
    const Matrix R = rotation(step * angle);
    for (int p = 0; p < 8; ++p) {
      CHECK(free.stress(p).norm() < 1e-14);
      CHECK((loaded.stress(p) - R * prestress * R.transpose()).norm() < 1e-13);
    }
  }
}

TEMPLATE_TEST_CASE_SIG("neo-Hookean forces are the gradient of an energy: their derivative is symmetric", "",
                       ((bool bbar), bbar), true, false) {
  std::mt19937 engine(4);
  const Corners<8> X = test::distorted_cube(engine, 0.15);
  ElementBench<Rubber<bbar>> bench({NeoHookeanResponse({1, 4, 1}), no_viscosity}, X, 1);
  CHECK(bench.move(X, X).force.norm() < 1e-13);
  const Corners<8> x = rotation(1) * (X + test::distorted_cube(engine, 0.2) - test::unit_cube());
  const auto K = bench.stiffness(x, 1e-5);
  CHECK((K - K.transpose()).norm() < 1e-7 * K.norm());
  CHECK(bench.move(x, x).force.norm() > 0.1);
}

TEMPLATE_TEST_CASE_SIG("the step bound is safe for the free element, and exact for bricks where A10 asks", "",
                       ((bool bbar), bbar), true, false) {
  // a free unit cube, step times cp/h: exact values of the element eigenvalue problem
  const double table[3][2] = {{0, 1}, {0.3, 0.7337993857053426}, {0.45, 0.6158817620514397}};
  for (const auto& [poisson, step] : table) {
    auto bench = elastic_bench<bbar>(test::unit_cube(), poisson);
    const auto answer = bench.move(test::unit_cube(), test::unit_cube());
    const ElasticResponse law = unit_law(poisson);
    CHECK(std::sqrt(law.lambda + 2 * law.mu) / answer.rate == Approx(step).epsilon(1e-12));
  }
  std::mt19937 engine(5);
  double loosest = 0;
  for (int sample = 0; sample < 100; ++sample) {
    Corners<8> X = test::distorted_cube(engine, 0.003 * sample);
    X.row(2) *= sample % 5 == 0 ? 0.1 : 1;
    auto bench = elastic_bench<bbar>(X, 0.1 * (sample % 5));
    Matrix prestress = test::random_matrix(engine, 0.05 * (sample % 3));
    prestress = (prestress + prestress.transpose()).eval();
    for (int p = 0; p < 8; ++p) bench.set_stress(prestress, p);
    const auto answer = bench.move(X, X);
    if (!(answer.volume > 0)) continue;
    const double omega2 = 8 * test::eigenvalues(bench.stiffness(X)).maxCoeff();
    CHECK(answer.rate >= 0.5 * std::sqrt(omega2) * (1 - 1e-7));
    if (sample % 3 == 0 && sample < 50) loosest = std::max(loosest, answer.rate / (0.5 * std::sqrt(omega2)));
  }
  CHECK(loosest < 1.3);  // without prestress, corners off by up to 15 % of the edge
}

TEMPLATE_TEST_CASE_SIG("the step bound of rubber is safe at large deformation", "", ((bool bbar), bbar), true, false) {
  std::mt19937 engine(6);
  for (int sample = 0; sample < 60; ++sample) {
    const Corners<8> X = test::distorted_cube(engine, 0.1);
    ElementBench<Rubber<bbar>> bench({NeoHookeanResponse({1, 4, 1}), no_viscosity}, X, 1);
    const Matrix F = Matrix::Identity() + test::random_matrix(engine, 0.4);
    const Corners<8> x = F * (X + 0.5 * (test::distorted_cube(engine, 0.2) - test::unit_cube()));
    const auto answer = bench.move(x, x);
    if (!(answer.volume > 0.2)) continue;
    CHECK(answer.rate >= 0.5 * std::sqrt(8 * test::eigenvalues(bench.stiffness(x, 1e-5)).maxCoeff()));
  }
}

TEST_CASE("bulk viscosity: central differences of a free cube stay bounded at 0.999 of the step and grow at 1.02") {
  const Corners<8> X = test::unit_cube();
  const auto largest_motion = [&](double share) {
    ElementBench<Elastic<false>> bench({unit_law(), {0.06, 1.2}}, X, 1);
    const double dt = share / bench.move(X, X).rate;
    Corners<8> x = X, v = 1e-6 * (X.array() - 0.5).matrix();
    for (int step = 0; step < 2000; ++step) {
      const Corners<8> before = x;
      x += dt * v;
      v += 8 * dt * bench.move(before, x, dt).force;
    }
    return (x - X).norm();
  };
  CHECK(largest_motion(0.999) < 1e-5);
  CHECK_FALSE(largest_motion(1.02) < 1e-3);
}

TEST_CASE("J2 in the element: uniaxial strain reaches the closed form at every point, volume strain elastic") {
  const material::J2 steel{7800, 200e9, 0.3, 400e6, 2e9, {}, 0};
  ElementBench<Hex8Full<material::J2Response<false, false>, true>> bench(
      {material::J2Response<false, false>(steel), no_viscosity}, test::unit_cube(), 7800);
  Corners<8> x = test::unit_cube();
  for (int step = 1; step <= 100; ++step) {
    const Corners<8> before = x;
    x.row(0) = test::unit_cube().row(0) * std::exp(0.02 * step / 100);  // logarithmic strain 0.02 in the end
    bench.move(before, x);
  }
  for (int p = 0; p < 8; ++p) {
    CHECK(bench.stress(p)(0, 0) == Approx(3615.33377396e6).epsilon(1e-6));
    CHECK(bench.stress(p)(1, 1) == Approx(3192.33311302e6).epsilon(1e-6));
  }
}

TEST_CASE("cube root of volume ratios, near one and far from it") {
  for (const double a : {1.0, 1 + 1e-12, 0.999, 0.5, 2.0, 0.01, 27.0, 1e3, 1e-9}) {
    const double root = element::hex8_full_detail::cube_root(broadcast(a))[pack_width - 1];
    CHECK(root == Approx(std::cbrt(a)).epsilon(1e-15));
  }
  CHECK(element::hex8_full_detail::cube_root(broadcast(1.0))[0] == 1);
}

TEST_CASE("an element turned inside out at one corner, or not a number, has no positive volume") {
  auto bench = elastic_bench<false>(test::unit_cube());
  Corners<8> x = test::unit_cube();
  CHECK(bench.move(x, x).volume == Approx(1).epsilon(1e-14));
  x.col(6) << -0.6, -0.6, -0.6;
  CHECK_FALSE(bench.move(x, x).volume > 0);
  x(1, 3) = std::nan("");
  CHECK_FALSE(bench.move(x, x).volume > 0);
}
