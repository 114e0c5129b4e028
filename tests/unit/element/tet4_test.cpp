// SPDX-License-Identifier: Apache-2.0
#include "element/tet4.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "material/elastic.hpp"
#include "material/neo_hookean.hpp"
#include "support/element_bench.hpp"

using namespace brunt;
using element::Tet4;
using material::ElasticResponse;
using material::NeoHookeanResponse;
using test::Corners;
using test::ElementBench;
using test::Matrix;

namespace {

constexpr element::BulkViscosity no_viscosity{0, 0};

Corners<4> random_tet(std::mt19937& engine) {
  std::uniform_real_distribution<double> entry(-1, 1);
  for (;;) {
    Corners<4> X = Corners<4>::NullaryExpr([&] { return entry(engine); });
    const Matrix edges = X.rightCols<3>().colwise() - X.col(0);
    if (edges.determinant() > 0.2) return X;
  }
}

double volume_of(const Corners<4>& X) {
  return (X.rightCols<3>().colwise() - X.col(0)).determinant() / 6;
}

ElementBench<Tet4<ElasticResponse>> elastic_bench(const Corners<4>& X, double poisson = 0.3, double mass = 1) {
  return {{ElasticResponse({1, 1, poisson}), no_viscosity}, X, mass};
}

/// V B^T C B from the inverse of the matrix (1, x, y, z) of the corners, whose rows are the shape functions.
test::Stiffness<4> textbook_stiffness(const Corners<4>& X, double lambda, double mu) {
  Eigen::Matrix4d corners;
  corners << Eigen::RowVector4d::Ones(), X;
  const Eigen::Matrix<double, 4, 3> gradient = corners.inverse().rightCols<3>();
  Eigen::Matrix<double, 6, 12> B = Eigen::Matrix<double, 6, 12>::Zero();
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      B(i, 3 * c + i) = gradient(c, i);
      B(3 + i, 3 * c + i) = gradient(c, j);
      B(3 + i, 3 * c + j) = gradient(c, i);
    }
  Eigen::Matrix<double, 6, 6> C = Eigen::Matrix<double, 6, 6>::Zero();
  C.topLeftCorner<3, 3>().setConstant(lambda);
  for (int i = 0; i < 6; ++i) C(i, i) += i < 3 ? 2 * mu : mu;
  return volume_of(X) * B.transpose() * C * B;
}

}  // namespace

TEST_CASE("tetrahedron: stiffness of the textbook, six zero-energy modes") {
  std::mt19937 engine(1);
  for (int sample = 0; sample < 20; ++sample) {
    const Corners<4> X = random_tet(engine);
    const auto bench = elastic_bench(X);
    const auto K = bench.stiffness(X);
    const auto expected = textbook_stiffness(X, bench.kernel.law.lambda, bench.kernel.law.mu);
    CHECK((K - expected).norm() < 1e-8 * expected.norm());
    const Eigen::VectorXd found = test::eigenvalues(K);
    CHECK(std::abs(found[0]) < 1e-8 * found[11]);
    CHECK(std::abs(found[5]) < 1e-8 * found[11]);
    CHECK(found[6] > 1e-5 * found[11]);
  }
}

TEST_CASE("tetrahedron: linear displacement gives its stress, forces balance, volume is right") {
  std::mt19937 engine(2);
  const Corners<4> X = random_tet(engine);
  const Matrix gradient = 1e-7 * test::random_matrix(engine, 1);
  auto bench = elastic_bench(X);
  const auto answer = bench.move(X, X + gradient * X);
  const ElasticResponse& law = bench.kernel.law;
  const Matrix strain = 0.5 * (gradient + gradient.transpose());
  const Matrix expected = law.lambda * strain.trace() * Matrix::Identity() + 2 * law.mu * strain;
  CHECK((bench.stress() - expected).norm() < 1e-6 * expected.norm());
  CHECK(answer.force.rowwise().sum().norm() < 1e-14 * answer.force.norm());
  CHECK((X * answer.force.transpose() + volume_of(X) * expected).norm() < 1e-6 * volume_of(X) * expected.norm());
  CHECK(answer.volume == Approx(volume_of(X)).epsilon(1e-6));
}

TEST_CASE("tetrahedron: rigid rotation in steps of 30 degrees gives no stress and carries prestress") {
  std::mt19937 engine(3);
  const Corners<4> X = random_tet(engine);
  const auto rotation = [](double angle) -> Matrix {
    return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 1, 1).normalized()).toRotationMatrix();
  };
  auto free = elastic_bench(X), loaded = free;
  const Matrix prestress = Eigen::Vector3d(0.01, 0, -0.02).asDiagonal().toDenseMatrix();
  loaded.set_stress(prestress);
  for (int step = 1; step <= 12; ++step) {
    const double angle = std::numbers::pi / 6;
    free.move(rotation((step - 1) * angle) * X, rotation(step * angle) * X);
    loaded.move(rotation((step - 1) * angle) * X, rotation(step * angle) * X);
    const Matrix R = rotation(step * angle);
    CHECK(free.stress().norm() < 1e-14);
    CHECK((loaded.stress() - R * prestress * R.transpose()).norm() < 1e-14);
  }
}

TEST_CASE("tetrahedron: the step bound is never above the exact one and close to it") {
  std::mt19937 engine(4);
  for (int sample = 0; sample < 100; ++sample) {
    const Corners<4> X = random_tet(engine);
    auto bench = elastic_bench(X, 0.1 * (sample % 5), 0.7);
    const double omega2 = 4 / 0.7 * test::eigenvalues(bench.stiffness(X)).maxCoeff();
    const double rate = bench.move(X, X).rate;
    CHECK(rate >= 0.5 * std::sqrt(omega2) * (1 - 1e-7));
    CHECK(rate < 1.25 * 0.5 * std::sqrt(omega2));
  }
}

TEST_CASE("tetrahedron of rubber: force is minus the derivative of volume times energy") {
  std::mt19937 engine(5);
  const Corners<4> X = random_tet(engine);
  ElementBench<Tet4<NeoHookeanResponse>> bench({NeoHookeanResponse({1, 4, 1}), no_viscosity}, X, 1);
  const Matrix edges = X.rightCols<3>().colwise() - X.col(0);
  const auto energy = [&](const Corners<4>& x) {
    const Matrix F = (x.rightCols<3>().colwise() - x.col(0)) * edges.inverse();
    const double log_J = std::log(F.determinant());
    return volume_of(X) * (0.5 * (F.squaredNorm() - 3) - log_J + 2 * log_J * log_J);
  };
  const Corners<4> x = (Matrix::Identity() + test::random_matrix(engine, 0.3)) * X;
  const auto answer = bench.move(x, x);
  for (int c = 0; c < 12; ++c) {
    Corners<4> step = Corners<4>::Zero();
    step.data()[c] = 1e-5;
    CHECK(answer.force.data()[c] == Approx(-(energy(x + step) - energy(x - step)) / 2e-5).epsilon(1e-6).margin(1e-7));
  }
}

TEST_CASE("tetrahedron: bulk viscosity resists the rate of volume, books its energy, and shortens the step") {
  std::mt19937 engine(6);
  const Corners<4> X = random_tet(engine);
  ElementBench<Tet4<ElasticResponse>> viscous({ElasticResponse({1, 1, 0.3}), {0.06, 1.2}}, X, volume_of(X));
  auto plain = elastic_bench(X, 0.3, volume_of(X));
  const Corners<4> before = 1.01 * X;  // compressed to X over the step
  constexpr int at_bulk_energy = Tet4<ElasticResponse>::Memory::at_bulk_energy;
  const auto with = viscous.move(before, X), without = plain.move(before, X);
  const Corners<4> drag = with.force - without.force, motion = X - before;
  CHECK(drag.cwiseProduct(motion).sum() < 0);
  const double half = viscous.history[at_bulk_energy][0];  // the first step starts from no stress: trapezoidal rule
  viscous.move(before, X);
  const double booked = viscous.history[at_bulk_energy][0] - half;
  CHECK(booked == Approx(-drag.cwiseProduct(motion).sum()).epsilon(0.02));  // V at the end, B at the end, e at midstep
  CHECK(with.rate > without.rate);
}
