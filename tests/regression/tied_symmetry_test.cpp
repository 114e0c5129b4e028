// SPDX-License-Identifier: Apache-2.0
// Tied boxes between planes of symmetry on both outer faces: along the normal of these, and of lateral planes, both
// sides of a tie are held, and what a row asked for there was rounding that no iteration could satisfy (200 iterations,
// residuals of 0.05 to 1000 in 295 of 300 steps at rest).
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "tests/support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

constexpr double pi = 3.14159265358979323846;

struct Setting {
  std::array<int, 3> upper{4, 4, 4};  ///< elements of the upper box; the lower one has 4 a side
  int lateral = 0;                    ///< pairs of lateral planes that hold: none, one side each, both sides
  double degrees = 0;                 ///< that all is turned by
  std::string load;
};

Simulation tied_boxes(const Setting& setting, const std::string& more = "") {
  mesh::Mesh mesh = mesh::box("a", {1, 1, 1}, {4, 4, 4}), upper = mesh::box("b", {1, 1, 1}, setting.upper);
  mesh::place(upper, 1, {0, 0, 1}, 0, {0, 0, 1});
  mesh::append(mesh, std::move(upper));
  mesh::place(mesh, 1, {1, 2, 3}, setting.degrees, Vec3::Zero());
  const Mat3 turn = Eigen::AngleAxisd(setting.degrees * pi / 180, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  std::string planes;
  const auto hold = [&](const Vec3& point, const Vec3& normal) {
    const Vec3 p = turn * point, n = turn * normal;
    planes += fmt::format("{}{{point: [{}, {}, {}], normal: [{}, {}, {}]}}", planes.empty() ? "" : ", ", p.x(), p.y(),
                          p.z(), n.x(), n.y(), n.z());
  };
  hold({0, 0, 0}, {0, 0, 1});
  hold({0, 0, 2}, {0, 0, -1});
  if (setting.lateral > 0) hold({0, 0, 0}, {1, 0, 0}), hold({0, 0, 0}, {0, 1, 0});
  if (setting.lateral > 1) hold({1, 0, 0}, {-1, 0, 0}), hold({0, 1, 0}, {0, -1, 0});
  return {std::move(mesh),
          "materials: {s: {model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}}\n"
          "parts: {a: {material: s}, b: {material: s}}\n"
          "symmetry: [" +
              planes + "]\ncontact: [{between: [a, b], tied: true" + more + "}]\n" + setting.load};
}

}  // namespace

TEST_CASE("tied boxes between planes of symmetry are solved in few iterations, at rest and loaded", "[regression]") {
  const auto upper = GENERATE(std::array{4, 4, 4}, std::array{3, 5, 4});
  const int lateral = GENERATE(0, 1, 2);
  const double degrees = GENERATE(0.0, 17.0, 90.0);
  const std::string load =
      GENERATE("", "gravity: {vector: [0, 3, -9.81]}\n", "pressure: [{set: a_xmax, value: 1.0e6}]\n");
  CAPTURE(upper[0], lateral, degrees, load);
  Simulation boxes = tied_boxes({upper, lateral, degrees, load});
  boxes.steps(60);
  CHECK(boxes.contact->ledger.statistics.most_iterations <= 10);  // ours: 6
  CHECK(boxes.contact->ledger.statistics.steps_at_limit == 0);
}

// More rows than the free side has directions: at rest they ask for the rounding of positions, which contradicts
// itself.
TEST_CASE("a finer part that is held and tied to a free one asks for nothing at rest", "[regression]") {
  const double degrees = GENERATE(0.0, 17.0);
  const auto upper = GENERATE(std::array{6, 6, 6}, std::array{8, 5, 7});
  mesh::Mesh mesh = mesh::box("a", {1, 1, 1}, {4, 4, 4}), fine = mesh::box("b", {1, 1, 1}, upper);
  mesh::place(fine, 1, {0, 0, 1}, 0, {0, 0, 1});
  mesh::append(mesh, std::move(fine));
  mesh::place(mesh, 1, {1, 2, 3}, degrees, Vec3::Zero());
  Simulation boxes(std::move(mesh),
                   "materials: {s: {model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}}\n"
                   "parts: {a: {material: s}, b: {material: s}}\n"
                   "fixed: [{part: b, dofs: [x, y, z]}]\n"
                   "contact: [{between: [a, b], tied: true, slave: b}]\n");
  boxes.steps(60);
  CHECK(boxes.contact->ledger.statistics.steps_at_limit == 0);
  CHECK(boxes.contact->ledger.statistics.most_iterations <= 2);  // ours: 0
}
