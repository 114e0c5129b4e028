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

constexpr double rounding = 1e-12;

/// Nodes of the lowest layer are held, those of the highest go by `top`; the rest is found. Residual norms over the
/// largest of them.
std::vector<double> newton(ElementBlockBench& bench, const Vec3& top, int height) {
  std::vector<Eigen::Index> free;
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(bench.unknowns());
  for (std::size_t i = 0; i < bench.state.nodes.size(); ++i) {
    const double z = bench.reference(i)[2];
    const auto first = static_cast<Eigen::Index>(3 * i);
    if (z == height) moved.segment<3>(first) = top;
    if (z > 0 && z < height)
      for (Eigen::Index c = 0; c < 3; ++c) free.push_back(first + c);
  }
  bench.state.dt = 1;
  for (model::NodeLine& node : bench.state.nodes) std::fill_n(node.v, 3, 0.0);
  bench.shift(moved);
  force::History trial = bench.state.history;
  std::vector<double> residuals;
  for (int iteration = 0; iteration < 12; ++iteration) {
    const Eigen::VectorXd residual = bench.internal_force(trial)(free);
    residuals.push_back(residual.norm());
    if (residuals.back() < rounding * *std::ranges::max_element(residuals)) break;
    const Eigen::MatrixXd K = bench.tangent()(free, free);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(bench.unknowns());
    step(free) = -K.partialPivLu().solve(residual);
    bench.shift(step);
  }
  force::commit(trial, bench.state.history);
  const double largest = *std::ranges::max_element(residuals);
  for (double& residual : residuals) residual /= largest;
  return residuals;
}

}  // namespace

TEST_CASE("Newton's iteration converges quadratically, step after step into plasticity") {
  const std::vector<std::pair<const char*, material::Law>> laws = {
      {"elastic", material::Elastic{1, 100, 0.3}},
      {"elastic, logarithmic", material::Elastic{1, 100, 0.3, material::StressRate::logarithmic}},
      {"J2 linear", material::J2{1, 100, 0.3, 0.5, 5, {}, 0}},
      {"J2 mixed", material::J2{1, 100, 0.3, 0.5, 5, {}, 0.5}},
      {"J2 table", material::J2{1, 100, 0.3, 0, 0, {{0, 0.5}, {0.05, 0.9}, {0.2, 1.2}}, 0.3}},
      {"neo-Hookean", material::NeoHookean{1, 60, 40}},
      {"neo-Hookean, nearly incompressible", material::NeoHookean{1, 40000, 40}},
  };
  for (const ElementKind kind : {ElementKind::hex8_full, ElementKind::hex8_bbar, ElementKind::tet4})
    for (const auto& [name, law] : laws) {
      ElementBlockBench bench(kind, law, {2, 2, 3});
      for (int step = 1; step <= 3; ++step) {
        // full integration locks where volume hardly changes: too large a step is outside of Newton's reach
        const double travel = &law == &laws.back().second ? 0.1 : 1;
        const std::vector<double> residuals = newton(bench, travel * Vec3(0.06, 0.02, 0.04), 3);
        std::string printed;
        for (const double r : residuals) printed += fmt::format(" {:.1e}", r);
        CAPTURE(element::name_of(kind), name, step, printed);
        CHECK(residuals.back() < rounding);
        CHECK(residuals.size() <= 9);
        for (std::size_t k = 0; k + 1 < residuals.size(); ++k)
          if (residuals[k] < 1e-2) CHECK(residuals[k + 1] < std::max(200 * residuals[k] * residuals[k], rounding));
      }
    }
}
