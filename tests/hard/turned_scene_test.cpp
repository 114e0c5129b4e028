// SPDX-License-Identifier: Apache-2.0
// Nothing in the physics knows the axes: a scene that is turned as a whole gives the same motion, turned.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

/// A cube comes down on a larger one, askew and off its middle.
Simulation impact(const std::string& method, const Vec3& axis, double degrees) {
  mesh::Mesh mesh = mesh::box("low", {1, 1, 1}, {3, 3, 3});
  mesh::Mesh top = mesh::box("top", {0.8, 0.8, 0.8}, {3, 3, 3});
  mesh::place(top, 1, {0, 0, 1}, 5, {0.13, 0.07, 1.01});
  mesh::append(mesh, std::move(top));
  mesh::place(mesh, 1, axis, degrees, {0, 0, 0});
  const Vec3 v = Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()) *
                 Vec3(0.05, 0.03, -0.5);  // faster, penalties let nodes in to the
                                          // end of the capture, which is told by boxes
  return {
      std::move(mesh),
      fmt::format("materials: {{m: {{model: elastic, density: 1, young: 100, poisson: 0.3}}}}\n"
                  "parts: {{low: {{material: m}}, top: {{material: m}}}}\n"
                  "initial: [{{part: top, velocity: [{:.17g}, {:.17g}, {:.17g}]}}]\n"
                  "contact: [{{between: all, method: {}, friction: 0.3, tolerance: 1.0e-10, max_iterations: 2000}}]\n",
                  v[0], v[1], v[2], method)};
}

}  // namespace

TEST_CASE("a scene that is turned as a whole moves as it did, by every method", "[law]") {
  const std::string method = GENERATE("rate", "row_sum", "kinematic", "gap_penalty", "penalty");
  const Vec3 axis(1, 2, 3);
  constexpr double degrees = 37;
  const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, axis.normalized());
  Simulation one = impact(method, {0, 0, 1}, 0), other = impact(method, axis, degrees);
  const auto nodes = static_cast<GlobalIndex>(one.nodes());
  double difference = 0, largest = 0;
  for (int step = 0; step < 12; ++step) {  // the first penalties turn rounding into motion before long
    one.step();
    other.step();
    for (GlobalIndex n = 0; n < nodes; ++n) {
      const Vec3 v = one.velocity(one.node(n)), turned = other.velocity(other.node(n));
      difference = std::max(difference, (turn.inverse() * turned - v).norm());
      largest = std::max(largest, v.norm());
    }
    CHECK(other.report.dt == Approx(one.report.dt).epsilon(1e-9));
  }
  CAPTURE(method, difference, largest);
  CHECK(one.ledger().contact != 0);
  CHECK(difference <= 1e-8 * largest);  // 1e-2 where the step saw the axes, or the penalty faces that are far
}
