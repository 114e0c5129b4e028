// SPDX-License-Identifier: Apache-2.0
// Linear elements against the elements that they stand for.
#include "force/assembled.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/eigenvalues.hpp"
#include "support/element_block.hpp"

using namespace brunt;
using element::ElementKind;
using test::ElementBlockBench;

namespace {

ElementBlockBench distorted(ElementKind kind, const material::Law& law, double amount, std::mt19937& engine) {
  ElementBlockBench bench(kind, law, {2, 2, 2});
  std::uniform_real_distribution<double> move(-amount, amount);
  for (Quad& X : bench.model.reference)
    for (int c = 0; c < 3; ++c) X[c] += move(engine);
  bench.scratch.force.assign(bench.scratch.force.size(), Quad{});
  force::lump_mass(bench.model, bench.state, bench.scratch);
  bench.place([](const Vec3& X) { return X; }, 0);
  bench.state.dt = 1;
  return bench;
}

/// What a pass over the elements at rest keeps.
force::LinearElements linear_elements(ElementBlockBench& bench, double& rate) {
  force::LinearElements linear = force::sized_linear(bench.model);
  force::History trial = bench.state.history;
  force::Motion motion = bench.motion(true);
  motion.watch.linear = linear;
  rate = force::trial_forces(bench.model, motion, bench.state.history, trial, bench.scratch).rate;
  return linear;
}

Eigen::MatrixXd dense(const ElementBlockBench& bench, const force::LinearElements& linear) {
  std::vector<model::NodeLine> nodes(bench.state.nodes.begin(), bench.state.nodes.end());
  for (model::NodeLine& node : nodes) node.v_late() = Quad{};
  AlignedVector<Quad> force(nodes.size());
  Eigen::MatrixXd K(bench.unknowns(), bench.unknowns());
  for (Eigen::Index column = 0; column < K.cols(); ++column) {
    double& v = nodes[static_cast<std::size_t>(column / 3)].v[column % 3];
    v = 1;
    force::linear_forces(bench.model, linear, {.nodes = nodes, .force = force, .slots = {}});
    v = 0;
    for (Eigen::Index row = 0; row < K.rows(); ++row)
      K(row, column) = -force[static_cast<std::size_t>(row / 3)][row % 3];
  }
  return K;
}

/// By central differences of the elements' own forces.
Eigen::MatrixXd tangent(ElementBlockBench& bench) {
  constexpr double small = 1e-5;
  Eigen::MatrixXd K(bench.unknowns(), bench.unknowns());
  force::History trial = bench.state.history;
  for (Eigen::Index column = 0; column < K.cols(); ++column) {
    const Eigen::VectorXd move = small * Eigen::VectorXd::Unit(K.cols(), column);
    bench.shift(move);
    K.col(column) = bench.internal_force(trial);
    bench.shift(-2 * move);
    K.col(column) -= bench.internal_force(trial);
    bench.shift(move);
  }
  return K / (2 * small);
}

}  // namespace

TEST_CASE("linear elements: those of one point are the elements, in distorted meshes too", "[oracle]") {
  std::mt19937 engine(3);
  for (const material::Law& law :
       {material::Law(material::Elastic{1, 100, 0.3}), material::Law(material::NeoHookean{1, 60, 40})})
    for (const ElementKind kind : {ElementKind::hex8, ElementKind::tet4}) {
      ElementBlockBench bench = distorted(kind, law, 0.15, engine);
      double rate = 0;
      const Eigen::MatrixXd K = dense(bench, linear_elements(bench, rate)), exact = tangent(bench);
      CAPTURE(element::name_of(kind), law.index());
      CHECK((K - K.transpose()).norm() <= 1e-13 * K.norm());
      CHECK((K - exact).norm() <= 1e-6 * exact.norm());
    }
}

TEST_CASE("linear elements: those of eight points resist at least as much as the elements", "[oracle]") {
  std::mt19937 engine(4);
  for (const double amount : {0.0, 0.1, 0.2})
    for (const ElementKind kind : {ElementKind::hex8_full, ElementKind::hex8_bbar}) {
      CAPTURE(element::name_of(kind), amount);
      ElementBlockBench bench = distorted(kind, material::Elastic{1, 100, 0.3}, amount, engine);
      double rate = 0;
      const Eigen::MatrixXd K = dense(bench, linear_elements(bench, rate)), exact = tangent(bench);
      CHECK(test::eigenvalues(K - exact)[0] >= -1e-6 * exact.norm());
      // springs as stiff as the stiffest strain, 3 lambda + 2 mu, in place of at least 2 mu: (1 + nu) / (1 - 2 nu)
      CHECK(K.norm() <= 3.25 * exact.norm());
    }
}

TEST_CASE("damping counts as stiffness, more for shorter steps") {
  std::mt19937 engine(5);
  ElementBlockBench bench = distorted(ElementKind::hex8, material::Elastic{1, 100, 0.3}, 0.1, engine);
  double rate = 0;
  const force::LinearElements linear = linear_elements(bench, rate);
  const auto with_damping = [&](double dt) {
    force::LinearElements springs = linear;
    force::include_damping(springs, dt);
    return dense(bench, springs);
  };
  const Eigen::MatrixXd K = dense(bench, linear), once = with_damping(0.1) - K, twice = with_damping(0.05) - K;
  CHECK((twice - 2 * once).norm() <= 1e-10 * twice.norm());
  CHECK(test::eigenvalues(once)[0] >= -1e-10 * once.norm());
  CHECK(once.norm() > 0.01 * K.norm());
}

TEST_CASE("growth is that of the element that has stiffened most, by its bound or by its plane waves") {
  ElementBlockBench bench(ElementKind::hex8, material::NeoHookean{1, 60, 40}, {3, 3, 3});
  bench.state.dt = 1e6;
  double rate = 0;
  force::Baseline baseline = force::sized_baseline(bench.model);
  force::take_baseline(linear_elements(bench, rate), baseline);
  const auto growth = [&](const Mat3& F) {
    bench.place([&](const Vec3& X) { return Vec3(F * X); }, 1e6);
    force::History trial = bench.state.history;
    force::Motion motion = bench.motion(false);
    motion.watch.baseline = baseline;
    return force::trial_forces(bench.model, motion, bench.state.history, trial, bench.scratch).growth;
  };
  CHECK(growth(Mat3::Identity()) == Approx(1).epsilon(1e-12));
  CHECK(growth(1.1 * Mat3::Identity()) < 1);
  // pressed flat at constant volume: plane waves across it take the time of its thickness; stretch adds some
  const double thin = 0.8, wide = 1 / std::sqrt(thin);
  const double flat = growth(Vec3(thin, wide, wide).asDiagonal());
  CHECK(flat >= 1 / (thin * thin));
  CHECK(flat <= 1.25 / (thin * thin));
}
