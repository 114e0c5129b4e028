// SPDX-License-Identifier: Apache-2.0
// Newton's iteration on small problems: only a consistent tangent makes its residuals fall quadratically.
// g++ 12 takes the undefined lanes of its own AVX-512 intrinsics for a fault (GCC bug 105593); Eigen brings them in
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <fmt/core.h>

#include <catch2/catch.hpp>

#include "support/element_block.hpp"

using namespace brunt;
using element::ElementKind;
using test::ElementBlockBench;

namespace {

struct Convergence {
  std::vector<double> residuals;  ///< norms over the largest of them
  double rounding = 0;            ///< what they cannot fall below: 1e-12, or some units in the last place of K x
};

/// Newton's iteration for a step of a box whose lowest layer of nodes is held: the `free` unknowns are found under
/// the loads `external`, the others have moved by `given`.
Convergence newton(ElementBlockBench& bench, const std::vector<Eigen::Index>& free, const Eigen::VectorXd& external,
                   const Eigen::VectorXd& given) {
  bench.state.dt = 1;
  for (model::NodeLine& node : bench.state.nodes) std::fill_n(node.v, 3, 0.0);
  bench.shift(given);
  force::History trial = bench.state.history;
  std::vector<double> residuals;
  double largest = 0, rounding = 0;
  for (int iteration = 0; iteration < 12; ++iteration) {
    const Eigen::VectorXd residual = (bench.internal_force(trial) - external)(free);
    residuals.push_back(residual.norm());
    const Eigen::MatrixXd K = bench.tangent()(free, free);
    largest = std::max(largest, residuals.back());
    rounding = std::max(1e-12, 1e-15 * K.norm() / largest);
    if (residuals.back() < rounding * largest) break;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(bench.unknowns());
    step(free) = -K.partialPivLu().solve(residual);
    bench.shift(step);
  }
  force::commit(trial, bench.state.history);
  for (double& residual : residuals) residual /= largest;
  return {residuals, rounding};
}

std::string printed(const Convergence& found) {
  std::string text;
  for (const double r : found.residuals) text += fmt::format(" {:.1e}", r);
  return text;
}

void check_quadratic(const Convergence& found) {
  const auto& [residuals, rounding] = found;
  CHECK(residuals.back() < rounding);
  CHECK(residuals.size() <= 9);
  for (std::size_t k = 0; k + 1 < residuals.size(); ++k)
    if (residuals[k] < 1e-2) CHECK(residuals[k + 1] < std::max(200 * residuals[k] * residuals[k], rounding));
}

/// The same in all unknowns of the nodes at the height z.
Eigen::VectorXd at_height(const ElementBlockBench& bench, double z, const Vec3& value) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(bench.unknowns());
  for (std::size_t i = 0; i < bench.state.nodes.size(); ++i)
    if (bench.reference(i)[2] == z) all.segment<3>(static_cast<Eigen::Index>(3 * i)) = value;
  return all;
}

std::vector<Eigen::Index> between(const ElementBlockBench& bench, double low, double high) {
  std::vector<Eigen::Index> unknowns;
  for (Eigen::Index c = 0; c < bench.unknowns(); ++c) {
    const double z = bench.reference(static_cast<std::size_t>(c / 3))[2];
    if (z > low && z < high) unknowns.push_back(c);
  }
  return unknowns;
}

struct NamedLaw {
  const char* name;
  material::Law law;
  double share = 1;  ///< of the travel that the others take in a step
};

const std::vector<NamedLaw>& laws() {
  static const std::vector<NamedLaw> all = {
      {"elastic", material::Elastic{1, 100, 0.3}},
      {"elastic, logarithmic", material::Elastic{1, 100, 0.3, material::StressRate::logarithmic}},
      {"J2 linear", material::J2{1, 100, 0.3, 0.5, 5, {}, 0}},
      {"J2 mixed", material::J2{1, 100, 0.3, 0.5, 5, {}, 0.5}},
      {"J2 table", material::J2{1, 100, 0.3, 0, 0, {{0, 0.5}, {0.05, 0.9}, {0.2, 1.2}}, 0.3}},
      {"neo-Hookean", material::NeoHookean{1, 60, 40}},
      // full integration locks where volume hardly changes: too large a step is outside of Newton's reach
      {"neo-Hookean, nearly incompressible", material::NeoHookean{1, 40000, 40}, 0.1},
  };
  return all;
}

}  // namespace

TEST_CASE("Newton's iteration converges quadratically on a block that is pulled, step after step into plasticity") {
  for (const ElementKind kind : {ElementKind::hex8_full, ElementKind::hex8_bbar, ElementKind::tet4})
    for (const auto& [name, law, share] : laws()) {
      ElementBlockBench bench(kind, law, {2, 2, 3});
      for (int step = 1; step <= 3; ++step) {
        const Convergence found = newton(bench, between(bench, 0, 3), Eigen::VectorXd::Zero(bench.unknowns()),
                                         at_height(bench, 3, share * Vec3(0.06, 0.02, 0.04)));
        CAPTURE(element::name_of(kind), name, step, printed(found));
        check_quadratic(found);
      }
    }
}

TEST_CASE("Newton's iteration converges quadratically on a single element under growing forces") {
  for (const ElementKind kind : {ElementKind::hex8_full, ElementKind::hex8_bbar, ElementKind::tet4})
    for (const auto& [name, law, share] : laws()) {
      ElementBlockBench bench(kind, law, {1, 1, 1});
      for (int step = 1; step <= 4; ++step) {  // J2 yields in the third
        const Convergence found =
            newton(bench, between(bench, 0, 2), at_height(bench, 1, step * Vec3(0.005, 0.002, 0.05)),
                   Eigen::VectorXd::Zero(bench.unknowns()));
        CAPTURE(element::name_of(kind), name, step, printed(found));
        check_quadratic(found);
      }
    }
}
