// SPDX-License-Identifier: Apache-2.0
#include "material/j2.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <type_traits>

#include "support/material_point.hpp"

using namespace brunt;
using material::J2;
using material::J2Response;
using test::Matrix;
using test::RatePoint;

namespace {

Matrix uniaxial(double strain) {
  Matrix m = Matrix::Zero();
  m(0, 0) = strain;
  return m;
}

Matrix shear(double tensor_shear) {
  Matrix m = Matrix::Zero();
  m(0, 1) = m(1, 0) = tensor_shear;
  return m;
}

J2 steel(double kinematic = 0) {
  return {7800, 200e9, 0.3, 400e6, 2e9, {}, kinematic};
}

constexpr double G = 200e9 / 2.6;

/// Signed sx - s_lateral of a uniaxial state.
template <class Response>
double axial(const RatePoint<Response>& point) {
  return point.cauchy()(0, 0) - point.cauchy()(1, 1);
}

}  // namespace

// Closed form of J2 with linear hardening in uniaxial strain, E = 200 GPa, nu = 0.3, sy = 400 MPa, H = 2 GPa: the flow
// direction is constant, so p = (2 G e - sy) / (3 G + H) with e the strain. Columns: strain, p, sx, s_lateral [MPa].
TEST_CASE("J2 in uniaxial strain follows the closed form") {
  const double table[7][4] = {{0.001, 0, 269.230769231, 115.384615385},
                              {0.0026, 0, 700, 300},
                              {0.005, 0.00158625247852, 1102.1150033, 698.942498348},
                              {0.01, 0.0048909451421, 1939.85459352, 1530.07270324},
                              {0.02, 0.0115003304693, 3615.33377396, 3192.33311302},
                              {0.05, 0.0313284864508, 8641.77131527, 8179.11434237},
                              {0.1, 0.0643754130866, 17019.1672174, 16490.4163913}};
  RatePoint<J2Response<false, false>> isotropic{J2Response<false, false>(steel())};
  RatePoint<J2Response<false, true>> kinematic{J2Response<false, true>(steel(1))};
  double strain = 0;
  for (const auto& [end, p, sx, lateral] : table) {
    isotropic.strain(uniaxial(end - strain));
    kinematic.strain(uniaxial(end - strain));
    strain = end;
    CHECK(isotropic.cauchy()(0, 0) == Approx(sx * 1e6).epsilon(1e-10));
    CHECK(isotropic.cauchy()(2, 2) == Approx(lateral * 1e6).epsilon(1e-10));
    CHECK(isotropic.plastic_strain() == Approx(p).epsilon(1e-10).margin(1e-15));
    CHECK(kinematic.cauchy()(0, 0) == Approx(sx * 1e6).epsilon(1e-10));  // under monotonic loading both agree
    CHECK(kinematic.plastic_strain() == Approx(p).epsilon(1e-10).margin(1e-15));
  }
}

TEST_CASE("elastic range after plastic flow: 2 sy where kinematic, 2 (sy + H p) where isotropic") {
  const double share = GENERATE(0.0, 0.5, 1.0);
  RatePoint<J2Response<false, true>> point{J2Response<false, true>(steel(share))};
  point.strain(uniaxial(0.05));
  const double p = point.plastic_strain(), top = axial(point);
  CHECK(top == Approx(400e6 + 2e9 * p).epsilon(1e-12));
  const double range = 2 * (400e6 + (1 - share) * 2e9 * p);
  point.strain(uniaxial(-0.999 * range / (2 * G)));
  CHECK(point.plastic_strain() == p);
  CHECK(axial(point) == Approx(top - 0.999 * range).epsilon(1e-10));
  point.strain(uniaxial(-0.011 * range / (2 * G)));  // 1 % beyond the far side
  CHECK(point.plastic_strain() - p == Approx(0.010 * range / (3 * G + 2e9)).epsilon(1e-8));
}

TEST_CASE("kinematic cycles between fixed strains close after the first; isotropic ones shake down") {
  RatePoint<J2Response<false, true>> kinematic{J2Response<false, true>(steel(1))};
  RatePoint<J2Response<false, false>> isotropic{J2Response<false, false>(steel())};
  const auto cycle = [](auto& point, double half) {
    point.strain(shear(-2 * half));
    point.strain(shear(2 * half));
  };
  kinematic.strain(shear(0.004));
  isotropic.strain(shear(0.004));
  const double first = kinematic.cauchy()(0, 1);
  for (int i = 0; i < 5; ++i) cycle(kinematic, 0.004);
  CHECK(kinematic.cauchy()(0, 1) == Approx(first).epsilon(1e-10));
  double before = isotropic.plastic_strain(), growth = 1;
  for (int i = 0; i < 400; ++i) {
    cycle(isotropic, 0.004);
    growth = isotropic.plastic_strain() - before;
    before = isotropic.plastic_strain();
  }
  CHECK(growth < 1e-6);  // what is left is elastic: q = sqrt(3) 2 G e within the grown surface
  CHECK(test::equivalent(isotropic.cauchy()) == Approx(std::sqrt(3.0) * 2 * G * 0.004).epsilon(1e-3));
}

TEST_CASE("a straight table is the linear law") {
  const double share = GENERATE(0.0, 0.4, 1.0);
  J2 constants = steel(share);
  RatePoint<J2Response<false, true>> line{J2Response<false, true>(constants)};
  constants.table = {{0, 400e6}, {0.003, 406e6}, {1, 2400e6}};
  RatePoint<J2Response<true, true>> table{J2Response<true, true>(constants)};
  std::mt19937 engine(3);
  for (int step = 0; step < 50; ++step) {
    Matrix increment = test::random_matrix(engine, 0.004);
    increment = (0.5 * (increment + increment.transpose())).eval();
    line.strain(increment);
    table.strain(increment);
    CHECK((line.cauchy() - table.cauchy()).norm() < 1e-10 * line.cauchy().norm());
    CHECK(table.plastic_strain() == Approx(line.plastic_strain()).epsilon(1e-10));
  }
  CHECK(line.plastic_strain() > 0.05);
}

TEST_CASE("one step across several pieces of a table ends on the curve") {
  // hardening, flat, softening, hardening, then flat beyond the table; Y(p) by hand
  const std::vector<std::array<double, 2>> curve = {
      {0, 400e6}, {0.01, 450e6}, {0.02, 450e6}, {0.04, 430e6}, {0.1, 700e6}};
  const double expected[][2] = {{0.005, 425e6}, {0.015, 450e6}, {0.03, 440e6},
                                {0.07, 565e6},  {0.1, 700e6},   {0.3, 700e6}};
  for (const double share : {0.0, 0.3, 1.0}) {
    J2 constants = steel(share);
    constants.table = curve;
    for (const auto& [p, yield] : expected) {
      RatePoint<J2Response<true, true>> one{J2Response<true, true>(constants)};
      const double trial = yield + 3 * G * p;
      one.strain(shear(trial / (2 * std::sqrt(3.0) * G)));
      CHECK(one.plastic_strain() == Approx(p).epsilon(1e-12));
      CHECK(test::equivalent(one.cauchy()) == Approx(yield).epsilon(1e-9));
      RatePoint<J2Response<true, true>> three{J2Response<true, true>(constants)};
      for (int i = 0; i < 3; ++i) three.strain(shear(trial / (6 * std::sqrt(3.0) * G)));
      CHECK(three.plastic_strain() == Approx(p).epsilon(1e-10));
    }
  }
}

TEST_CASE("no strain, no stress, no change, and no division by zero") {
  RatePoint<J2Response<false, true>> line{J2Response<false, true>(steel(1))};
  line.strain(Matrix::Zero());
  CHECK(line.cauchy().isZero(0));
  line.strain(Matrix::Identity() * 1e-3);  // purely volumetric: no flow at any pressure
  CHECK(line.plastic_strain() == 0);
  CHECK(test::equivalent(line.cauchy()) < 1e-6);
  CHECK(line.cauchy().trace() == Approx(3e-3 * 200e9 / (1 - 2 * 0.3)).epsilon(1e-12));
}

TEST_CASE("a lane does not see its neighbours, to the bit") {
  J2 constants = steel(0.5);
  constants.table = {{0, 400e6}, {0.01, 450e6}, {0.5, 500e6}};
  const J2Response<true, true> law(constants);
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> entry(-0.004, 0.004);
  Pack together[6], history[7]{}, stress[6]{};
  for (Pack& c : together)
    for (int lane = 0; lane < pack_width; ++lane) c[lane] = entry(engine) * (lane % 3);
  law.update(together, stress, history, history + 6);
  for (int lane = 0; lane < pack_width; ++lane) {
    Pack alone[6], own_history[7]{}, own[6]{};
    for (int c = 0; c < 6; ++c) alone[c] = broadcast(together[c][lane]);
    law.update(alone, own, own_history, own_history + 6);
    for (int c = 0; c < 6; ++c) CHECK(own[c][pack_width - 1] == stress[c][lane]);
    for (int c = 0; c < 7; ++c) CHECK(own_history[c][pack_width - 1] == history[c][lane]);
  }
}

TEST_CASE("the stress stays on the yield surface and the back stress a deviator on any path") {
  RatePoint<J2Response<false, true>> point{J2Response<false, true>(steel(0.7))};
  std::mt19937 engine(5);
  for (int step = 0; step < 100; ++step) {
    Matrix increment = test::random_matrix(engine, 0.01);
    increment = (0.5 * (increment + increment.transpose())).eval();
    point.strain(increment);
    const Matrix back = test::symmetric_matrix(point.tensors);
    const double radius = 400e6 + 0.3 * 2e9 * point.plastic_strain();
    CHECK(test::equivalent(point.cauchy() - back) <= radius * (1 + 1e-10));
    CHECK(std::abs(back.trace()) < 1e-8 * radius);
  }
  CHECK(point.plastic_strain() > 0.2);
}

// The largest power over the bound's, of any velocity gradient: exact for unloading, which is what is stiffest.
TEST_CASE("the tangent of the stable step bounds the true one at every plastic state, loading and unloading") {
  std::mt19937 engine(17);
  double tightest = 1;
  for (int sample = 0; sample < 100; ++sample) {
    const J2 soft{1, 1.0, 0.3, sample % 2 == 0 ? 0.02 : 0.3, 0.1, {}, 0};  // stress up to a third of Young's modulus
    RatePoint<J2Response<false, false>> state{J2Response<false, false>(soft)};
    for (int step = 0; step < 4; ++step) {
      Matrix increment = test::random_matrix(engine, 0.3);
      state.strain(0.5 * (increment + increment.transpose()));
    }
    REQUIRE(state.plastic_strain() > 0);
    const auto nominal_of = [&](const auto& law, const Matrix& H) -> Matrix {
      RatePoint<std::decay_t<decltype(law)>> point{law};
      std::copy(state.stress, state.stress + 6, point.stress);
      if constexpr (std::is_same_v<std::decay_t<decltype(law)>, J2Response<false, false>>)
        point.scalars[0] = state.scalars[0];
      const Matrix F = Matrix::Identity() + H;
      point.deform(Matrix::Identity(), F);
      return F.determinant() * point.cauchy() * F.inverse().transpose();
    };
    Pack lambda, mu;
    state.law.tangent(state.stress, lambda, mu);
    const test::Matrix9 bound = test::bound_form(lambda[0], mu[0]);
    const material::ElasticResponse elastic({1, 1.0, 0.3});
    const test::Matrix9 unloading = test::stiffness_form([&](const Matrix& H) { return nominal_of(elastic, H); }, 1e-5);
    const Eigen::GeneralizedSelfAdjointEigenSolver<test::Matrix9> shares(unloading, bound);
    CHECK(shares.eigenvalues().maxCoeff() <= 1 + 1e-8);
    tightest = std::min(tightest, shares.eigenvalues().maxCoeff());
    constexpr double step = 1e-5;
    const Matrix at_rest = nominal_of(state.law, Matrix::Zero());
    for (int direction = 0; direction < 9; ++direction) {
      const test::Matrix9& axes = shares.eigenvectors();
      const Matrix L = Eigen::Map<const Matrix>(axes.col(direction).data());
      for (const double sign : {1.0, -1.0}) {
        const Matrix H = sign * step * L;
        const double power = (L * sign).cwiseProduct((nominal_of(state.law, H) - at_rest) / step).sum();
        CHECK(power <= 1 + 1e-3);  // of the bound's, which is 1 along these; one-sided differences: step / stress
      }
    }
  }
  CAPTURE(tightest);
  CHECK(tightest > 0.4);  // or the step would be cut for nothing
}
