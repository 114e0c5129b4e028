// SPDX-License-Identifier: Apache-2.0
#include "force/trial.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <numbers>

#include "support/element_block.hpp"

using namespace brunt;
using element::ElementKind;
using force::History;
using test::ElementBlockBench;

namespace {

bool same_bits(const History& a, const History& b) {
  return a.size() == b.size() && a[0].size() == b[0].size() &&
         std::memcmp(a[0].data(), b[0].data(), a[0].size() * sizeof(double)) == 0;
}
bool same_bits(const AlignedVector<Quad>& a, const AlignedVector<Quad>& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(Quad)) == 0;
}

/// Bent, twisted and stretched more with every step: plastic where the law is.
auto pose(int step) {
  return [step](const Vec3& X) {
    const double t = 0.02 * step;
    return Vec3(X[0] + t * X[1] * X[2], X[1] + t * X[0] * X[0], X[2] * (1 + t) - 0.5 * t * X[0] * X[1]);
  };
}

const std::vector<material::Law>& laws() {
  using material::StressRate;
  static const std::vector<material::Law> all = {
      material::Elastic{1, 100, 0.3},
      material::Elastic{1, 100, 0.3, StressRate::logarithmic},
      material::J2{1, 100, 0.3, 0.5, 2, {}, 0},
      material::J2{1, 100, 0.3, 0.5, 2, {}, 0.5},
      material::J2{1, 100, 0.3, 0, 0, {{0, 0.5}, {0.02, 0.7}, {0.1, 0.8}}, 0.3, StressRate::logarithmic},
      material::NeoHookean{1, 60, 40},
  };
  return all;
}

}  // namespace

TEST_CASE(
    "a trial leaves what is committed, says the same twice, and once committed is the explicit step, to the bit") {
  for (const ElementKind kind : {ElementKind::hex8, ElementKind::hex8_full, ElementKind::hex8_bbar, ElementKind::tet4})
    for (const material::Law& law : laws()) {
      CAPTURE(element::name_of(kind), law.index());
      ElementBlockBench bench(kind, law, {3, 2, 2});
      const auto forces = [&](const History& committed, History& trial) {
        return force::trial_forces(bench.model, bench.motion(true), committed, trial, bench.scratch);
      };
      for (int step = 1; step <= 3; ++step) {
        const History committed = bench.state.history;
        History trial = committed;
        bench.place(pose(step), 0.25);
        forces(bench.state.history, trial);
        const AlignedVector<Quad> first = bench.scratch.force;
        const History remembered = trial;

        const auto nodes = bench.state.nodes;
        bench.shift(0.01 * Eigen::VectorXd::Random(bench.unknowns()));
        forces(bench.state.history, trial);
        CHECK_FALSE(same_bits(bench.scratch.force, first));
        bench.state.nodes = nodes;
        const double rate = forces(bench.state.history, trial).rate;
        CHECK(same_bits(bench.scratch.force, first));
        CHECK(same_bits(trial, remembered));
        CHECK(same_bits(bench.state.history, committed));

        CHECK(force::internal_forces(bench.model, bench.state, bench.scratch).rate == rate);
        CHECK(same_bits(bench.scratch.force, first));
        History kept = committed;
        force::commit(trial, kept);
        CHECK(same_bits(kept, bench.state.history));
      }
    }
}

TEST_CASE("without viscosity forces do not depend on the time that a step takes") {
  for (const ElementKind kind : {ElementKind::hex8, ElementKind::hex8_full, ElementKind::hex8_bbar, ElementKind::tet4})
    for (const material::Law& law : laws()) {
      CAPTURE(element::name_of(kind), law.index());
      Eigen::VectorXd force[2], viscous[2];
      for (const int slow : {0, 1}) {
        ElementBlockBench bench(kind, law, {2, 1, 1}, element::HourglassKind::viscous);
        History trial = bench.state.history;
        bench.place(pose(1), slow ? 1 : 1.0 / 1024);  // powers of two: increments are exact
        force[slow] = bench.internal_force(trial);
        viscous[slow] = bench.internal_force(trial, true);
      }
      CHECK((force[0] - force[1]).norm() <= 1e-13 * force[0].norm());
      CHECK((viscous[0] - viscous[1]).norm() > 1e-3 * force[0].norm());
    }
}

// Second order in the turn, whatever the strain: 0.9 % of the force at 10 degrees, 8.4 % at 30.
TEST_CASE("uniaxial strain and a turn in one step: how far the midpoint update is from the stress of ln U, turned") {
  material::Elastic law{1, 100, 0.3};
  const auto fault = [&](double strain, double degrees) {
    ElementBlockBench bench(ElementKind::hex8_full, law, {1, 1, 1});
    const double angle = degrees * std::numbers::pi / 180;
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    const Eigen::Matrix3d U = Eigen::Vector3d(1 + strain, 1, 1).asDiagonal();
    bench.place([&](const Vec3& X) { return Vec3(R * U * X); }, 1);
    History trial = bench.state.history;
    const Eigen::VectorXd found = bench.internal_force(trial);
    // nodal forces of a uniform stress s: V s F^-T of the shape functions' gradients; of a box the same for all laws
    const double h = std::log(1 + strain), lambda = 100 * 0.3 / (1.3 * 0.4), mu = 100 / 2.6;
    const Eigen::Matrix3d stress = Eigen::Vector3d(lambda * h + 2 * mu * h, lambda * h, lambda * h).asDiagonal();
    const Eigen::Matrix3d first_piola = (1 + strain) * R * stress * U.inverse();
    Eigen::VectorXd expected(bench.unknowns());
    for (std::size_t i = 0; i < bench.state.nodes.size(); ++i) {
      const Vec3 gradient = (bench.reference(i).array() - 0.5) * 0.5;  // integral of grad N over the unit cube
      expected.segment<3>(static_cast<Eigen::Index>(3 * i)) = first_piola * gradient;
    }
    return (found - expected).norm() / expected.norm();
  };
  CHECK(fault(0.01, 0) < 1e-4);
  CHECK(fault(0.01, 10) < 0.009);
  CHECK(fault(0.01, 30) < 0.085);
  CHECK(fault(0.1, 30) < 0.085);
}
