// SPDX-License-Identifier: Apache-2.0
// The one-point hexahedron with a hyperelastic law: strain and hourglass forces are derivatives of one potential.
#include <catch2/catch.hpp>
#include <numbers>

#include "element/hex8.hpp"
#include "material/elastic.hpp"
#include "material/neo_hookean.hpp"
#include "support/element_bench.hpp"

using namespace brunt;
using element::Hex8;
using element::HourglassKind;
using material::NeoHookeanResponse;
using test::Corners;
using test::ElementBench;
using test::Matrix;

namespace {

template <HourglassKind kind>
using Rubber = Hex8<NeoHookeanResponse, kind>;
using Controlled = Rubber<HourglassKind::stiffness>;

struct Moduli {
  double lambda, mu;
};
constexpr Moduli moduli[] = {{1, 1}, {10, 1}, {100, 1}, {0.2, 1}};
constexpr double distortions[] = {0, 0.1, 0.25};
constexpr double spring = 0.05;  ///< coefficient of hourglass control, the default

template <HourglassKind kind = HourglassKind::stiffness>
ElementBench<Rubber<kind>> bench_of(const Corners<8>& X, const Moduli& m, double coefficient = spring) {
  return {Rubber<kind>{NeoHookeanResponse({1, m.lambda, m.mu}), {kind, coefficient}, {0, 0}}, X, 1};
}

Matrix rotation(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
}

/// V grad N_I averaged over the element, from the shape functions at 2x2x2 points; exact for trilinear elements.
Eigen::Matrix<double, 8, 3> mean_gradient(const Corners<8>& X, double& volume) {
  constexpr double sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                 {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  Eigen::Matrix<double, 8, 3> B = Eigen::Matrix<double, 8, 3>::Zero();
  volume = 0;
  for (int p = 0; p < 8; ++p) {
    Eigen::Matrix<double, 8, 3> parent;
    const double at = 1 / std::sqrt(3.0);
    for (int I = 0; I < 8; ++I) {
      const double* s = sign[I];
      const double f[3] = {1 + at * sign[p][0] * s[0], 1 + at * sign[p][1] * s[1], 1 + at * sign[p][2] * s[2]};
      for (int c = 0; c < 3; ++c) parent(I, c) = 0.125 * s[c] * f[(c + 1) % 3] * f[(c + 2) % 3];
    }
    const Matrix J = X * parent;
    B += parent * J.inverse() * J.determinant();
    volume += J.determinant();
  }
  return B;
}

/// Volume times psi(F) of the mean deformation gradient.
double strain_energy(const Corners<8>& X, const Corners<8>& x, const Moduli& m) {
  double volume = 0;
  const Eigen::Matrix<double, 8, 3> B = mean_gradient(X, volume);
  const Matrix F = x * B / volume;
  const double log_J = std::log(F.determinant());
  return volume * (0.5 * m.mu * (F.squaredNorm() - 3) - m.mu * log_J + 0.5 * m.lambda * log_J * log_J);
}

double hourglass_energy(const ElementBench<Controlled>& bench) {
  return bench.history[Controlled::at_hourglass_energy][0];
}

/// Of an element moved to x in one step from anywhere: strain and hourglass energy.
double potential(const Corners<8>& X, const Corners<8>& x, const Moduli& m) {
  auto bench = bench_of(X, m);
  bench.move(x, x);
  return strain_energy(X, x, m) + hourglass_energy(bench);
}

/// A stretch, shear and rotation, then corners moved by up to `bend`.
Corners<8> deformed(std::mt19937& engine, const Corners<8>& X, double strain, double bend) {
  const Matrix F = rotation(2.5) * (Matrix::Identity() + test::random_matrix(engine, strain));
  return F * X + test::distorted_cube(engine, bend) - test::unit_cube();
}

}  // namespace

TEST_CASE("hyperelastic hex8: forces are minus the derivative of strain and hourglass energy, however it is bent") {
  std::mt19937 engine(1);
  for (const Moduli& m : moduli)
    for (const double distortion : distortions)
      for (const double bend : {0.02, 0.2}) {
        const Corners<8> X = test::distorted_cube(engine, distortion), x = deformed(engine, X, 0.25, bend);
        CAPTURE(m.lambda, distortion, bend);
        const Corners<8> force = bench_of(X, m).move(x, x).force;
        Corners<8> expected;
        constexpr double step = 1e-5;
        for (int c = 0; c < 24; ++c) {
          Corners<8> shift = Corners<8>::Zero();
          shift.data()[c] = step;
          expected.data()[c] = -(potential(X, x + shift, m) - potential(X, x - shift, m)) / (2 * step);
        }
        CHECK((force - expected).norm() < 1e-8 * expected.norm());
        CHECK(force.rowwise().sum().norm() < 1e-12 * force.norm());
        const Matrix moment = force * x.transpose();
        CHECK((moment - moment.transpose()).norm() < 1e-12 * moment.norm());
      }
}

TEST_CASE("hyperelastic hex8: no hourglass energy under any homogeneous deformation, the same however it is turned") {
  std::mt19937 engine(2);
  for (int sample = 0; sample < 30; ++sample) {
    const Corners<8> X = test::distorted_cube(engine, 0.25);
    Matrix F = Matrix::Identity() + test::random_matrix(engine, 0.6);
    if (F.determinant() < 0.1) continue;
    F = rotation(sample) * F;
    const Corners<8> shift = Eigen::Vector3d(3, -2, 1).replicate<1, 8>();
    auto bench = bench_of(X, moduli[1], 1.0), bare = bench;
    bare.kernel.control.coefficient = 0;
    const Corners<8> x = F * X + shift;
    const Corners<8> force = bench.move(X, x).force, without = bare.move(X, x).force;
    CHECK(hourglass_energy(bench) < 1e-28);
    CHECK((force - without).norm() < 1e-13 * (without.norm() + 1));

    const Corners<8> bent = x + test::distorted_cube(engine, 0.2) - test::unit_cube();
    const Corners<8> straight = bench.move(x, bent).force;
    const double stored = hourglass_energy(bench);
    CHECK(stored > 1e-4);
    for (const double angle : {0.1, 1.0, 3.0}) {
      const Corners<8> turned = bench.move(bent, rotation(angle) * bent).force;
      CHECK(hourglass_energy(bench) == Approx(stored).epsilon(1e-12));
      CHECK((turned - rotation(angle) * straight).norm() < 1e-12 * straight.norm());
    }
  }
}

// What the force in rate form does not: its springs change with the shape while it is loaded.
TEST_CASE("hyperelastic hex8: a closed cycle of crushing and bending returns all work") {
  std::mt19937 engine(3);
  for (const Moduli& m : moduli) {
    const Corners<8> X = test::distorted_cube(engine, 0.1);
    const Corners<8> bend = test::distorted_cube(engine, 0.25) - test::unit_cube();
    const auto at = [&](double turn) -> Corners<8> {  // crushed and bent out of phase
      const double phase = 2 * std::numbers::pi * turn;
      Corners<8> x = X;
      x.row(2) *= 1 - 0.3 * (1 - std::cos(phase));
      return x + std::sin(phase) * bend;
    };
    const auto work = [&](int steps) {
      auto bench = bench_of(X, m);
      double sum = 0, largest = 0;
      Corners<8> before = at(0), force = bench.move(before, before).force;
      for (int i = 1; i <= steps; ++i) {
        const Corners<8> x = at(static_cast<double>(i) / steps), after = bench.move(before, x).force;
        for (int c = 0; c < 24; ++c)
          sum -= 0.5 * (force.data()[c] + after.data()[c]) * (x.data()[c] - before.data()[c]);
        largest = std::max(largest, sum);
        before = x;
        force = after;
      }
      CHECK(hourglass_energy(bench) < 1e-25);
      return std::abs(sum) / largest;
    };
    CHECK(work(400) < 1e-4);
    CHECK(work(800) < 0.3 * work(400) + 1e-12);  // of second order in the step: nothing but the quadrature
  }
}

TEST_CASE("hyperelastic hex8: for small strains its stiffness is that of the rate form, bending included") {
  std::mt19937 engine(4);
  for (const double distortion : distortions) {
    const Corners<8> X = test::distorted_cube(engine, distortion);
    for (const double poisson : {0.0, 0.3, 0.45}) {
      const material::ElasticResponse law({1, 1, poisson});
      const ElementBench<Hex8<material::ElasticResponse, HourglassKind::stiffness>> rate{
          {law, {HourglassKind::stiffness, spring}, {0, 0}}, X, 1};
      const test::Stiffness<8> expected = rate.stiffness(X);
      CHECK((bench_of(X, {law.lambda, law.mu}).stiffness(X) - expected).norm() < 1e-8 * expected.norm());
    }
  }
}

TEMPLATE_TEST_CASE_SIG("hyperelastic hex8: the step bound is safe for a free element, crushed, sheared and bent", "",
                       ((HourglassKind kind), kind), HourglassKind::stiffness, HourglassKind::none) {
  std::mt19937 engine(5);
  int tried = 0;
  for (int sample = 0; sample < 300; ++sample) {
    const Moduli& m = moduli[sample % 4];
    Corners<8> X = test::distorted_cube(engine, distortions[sample % 3]);
    X.row(2) *= sample % 5 == 0 ? 0.1 : 1.0;
    const Corners<8> x = deformed(engine, X, 0.05 * (sample % 10), 0.02 * (sample % 8));
    auto bench = bench_of<kind>(X, m, sample % 2 ? spring : 2.0);
    const auto answer = bench.move(x, x);
    if (!(answer.volume > 0.05)) continue;
    const double stiffest = test::eigenvalues(bench.stiffness(x)).maxCoeff();
    CAPTURE(sample, answer.rate, stiffest);
    CHECK(answer.rate >= 0.5 * std::sqrt(8 * stiffest) * (1 - 1e-6));
    ++tried;
  }
  CHECK(tried > 150);
}

// Under pressure an element whose forces act through its current gradient loses its hourglass stiffness: the geometric
// part p d2V/dx2 outgrows the springs at p = 0.45 mu.
TEST_CASE("hyperelastic hex8: no hourglass mode turns soft under pressure") {
  for (const Moduli& m : moduli)
    for (const double stretch : {1.3, 1.0, 0.8, 0.5}) {
      const Corners<8> X = test::unit_cube(), x = stretch * X;
      const auto bench = bench_of(X, m);
      test::Stiffness<8> K = bench.stiffness(x);
      Eigen::Matrix<double, 24, 12> modes;  // one component of one hourglass mode each
      constexpr double mode[4][8] = {{1, 1, -1, -1, -1, -1, 1, 1},
                                     {1, -1, -1, 1, -1, 1, 1, -1},
                                     {1, -1, 1, -1, 1, -1, 1, -1},
                                     {-1, 1, -1, 1, 1, -1, 1, -1}};
      modes.setZero();
      for (int a = 0; a < 4; ++a)
        for (int i = 0; i < 3; ++i)
          for (int c = 0; c < 8; ++c) modes(3 * c + i, 3 * a + i) = mode[a][c] / std::sqrt(8.0);
      const Eigen::MatrixXd restricted = modes.transpose() * K * modes;
      const double springs = 8 * spring / 8 * m.mu * 1.5;  // 8 k0 of a unit cube, trace S = 3/2
      const Eigen::VectorXd found = test::eigenvalues(restricted);
      CHECK(found.minCoeff() == Approx(springs).epsilon(1e-5));
      CHECK(found.maxCoeff() == Approx(springs).epsilon(1e-5));
    }
}
