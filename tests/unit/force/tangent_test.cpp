// SPDX-License-Identifier: Apache-2.0
// g++ 12 takes the undefined lanes of its own AVX-512 intrinsics for a fault (GCC bug 105593); Eigen brings them in
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include "force/tangent.hpp"

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "support/eigenvalues.hpp"
#include "support/element_block.hpp"

using namespace brunt;
using element::ElementKind;
using material::StressRate;
using test::ElementBlockBench;

namespace {

constexpr ElementKind kinds[] = {ElementKind::hex8_full, ElementKind::hex8_bbar, ElementKind::tet4};

const material::Law elastic = material::Elastic{1, 100, 0.3};
const material::Law stiff_in_volume = material::Elastic{1, 100, 0.4999};
const material::Law rubber = material::NeoHookean{1, 60, 40};
const material::Law soft_rubber = material::NeoHookean{1, 40000, 40};  // nearly incompressible
const std::vector<std::array<double, 2>> table{{0, 0.5}, {0.02, 0.7}, {0.1, 0.8}};

const std::vector<std::pair<const char*, material::Law>>& laws() {
  static const std::vector<std::pair<const char*, material::Law>> all = {
      {"elastic", elastic},
      {"elastic, nu 0.4999", stiff_in_volume},
      {"elastic, logarithmic", material::Elastic{1, 100, 0.3, StressRate::logarithmic}},
      {"J2 linear isotropic", material::J2{1, 100, 0.3, 0.5, 2, {}, 0}},
      {"J2 linear mixed", material::J2{1, 100, 0.3, 0.5, 2, {}, 0.5}},
      {"J2 linear kinematic, logarithmic", material::J2{1, 100, 0.3, 0.5, 2, {}, 1, StressRate::logarithmic}},
      {"J2 table isotropic", material::J2{1, 100, 0.3, 0, 0, table, 0}},
      {"J2 table mixed", material::J2{1, 100, 0.3, 0, 0, table, 0.4}},
      {"neo-Hookean", rubber},
      {"neo-Hookean, nearly incompressible", soft_rubber},
  };
  return all;
}

/// A step of `size` in strain and `angle` in turn, uneven over the elements.
auto pose(double size, double angle) {
  const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  return [=](const Vec3& X) {
    const Vec3 bent(X[1] * X[2], X[0] * X[0] - 0.5 * X[2], -0.5 * X[0] * X[1] + X[2]);
    return Vec3(R * (X + size * bent));
  };
}

/// Largest entry off in any column of the tangent, over the largest entry of all, by central differences.
double difference(ElementBlockBench bench, bool viscous) {
  const Eigen::MatrixXd K = bench.tangent(viscous);
  force::History trial = bench.state.history;
  constexpr double h = 1e-5;
  double worst = 0;
  for (Eigen::Index c = 0; c < bench.unknowns(); ++c) {
    const auto shifted = [&](double by) {
      const auto nodes = bench.state.nodes;
      bench.shift(by * Eigen::VectorXd::Unit(bench.unknowns(), c));
      Eigen::VectorXd f = bench.internal_force(trial, viscous);
      bench.state.nodes = nodes;
      return f;
    };
    const Eigen::VectorXd slope = (8 * (shifted(h) - shifted(-h)) - (shifted(2 * h) - shifted(-2 * h))) / (12 * h);
    worst = std::max(worst, (slope - K.col(c)).lpNorm<Eigen::Infinity>());
  }
  return worst / K.lpNorm<Eigen::Infinity>();
}

double asymmetry(const Eigen::MatrixXd& K) {
  return (K - K.transpose()).norm() / K.norm();
}

}  // namespace

TEST_CASE("tangents are the slopes of the forces: elastic, plastic, nearly incompressible, large turns") {
  for (const ElementKind kind : kinds)
    for (const auto& [name, law] : laws()) {
      ElementBlockBench bench(kind, law, {2, 1, 1});
      CAPTURE(element::name_of(kind), name);
      const double stages[][2] = {{0.001, 0}, {0.03, 0.1}, {0.1, 0.6}, {0.12, 1.5}};  // strain, turn
      for (const auto& [size, angle] : stages) {
        bench.place(pose(size, angle), 0.5);
        CAPTURE(size, angle);
        CHECK(difference(bench, false) < 1e-9);
        CHECK(difference(bench, true) < 1e-6);
        bench.internal_force(bench.state.history);
      }
    }
}

TEST_CASE("tangents of a potential are symmetric, those of rate laws as nearly as the step is small") {
  for (const ElementKind kind : kinds)
    for (const auto& [name, law] : laws()) {
      CAPTURE(element::name_of(kind), name);
      if (std::holds_alternative<material::NeoHookean>(law)) {
        ElementBlockBench bench(kind, law, {2, 1, 1});
        bench.place(pose(0.2, 1), 1);
        CHECK(asymmetry(bench.tangent()) < 1e-14);
        continue;
      }
      for (const double size : {1e-6, 1e-3, 1e-2, 1e-1}) {
        ElementBlockBench bench(kind, law, {2, 1, 1});
        bench.place(pose(size, size), 1);
        CHECK(asymmetry(bench.tangent()) < 1.5 * size);  // elastic 0.8 to 1.3, plastic 0.07 at the largest
      }
    }
}

TEST_CASE("at rest the tangent is the stiffness matrix: rigid motions cost nothing") {
  for (const ElementKind kind : kinds) {
    ElementBlockBench bench(kind, elastic, {2, 2, 1});
    bench.state.dt = 1;
    const Eigen::MatrixXd K = bench.tangent();
    CHECK(asymmetry(K) < 1e-14);
    const Eigen::VectorXd values = test::eigenvalues(K);
    CHECK(std::abs(values[5]) < 1e-12 * values.maxCoeff());
    CHECK(values[6] > 1e-4 * values.maxCoeff());
  }
}

TEST_CASE("one-point hexahedra give no tangent, and say so") {
  CHECK_FALSE(force::gives_tangents(ElementKind::hex8));
  ElementBlockBench bench(ElementKind::hex8, elastic, {1, 1, 1});
  bench.state.dt = 1;
  CHECK_THROWS_AS(bench.tangent(), InputError);
}
