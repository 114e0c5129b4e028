// SPDX-License-Identifier: Apache-2.0
// Generated round bodies against the exact ones; bodies that stand twice; what is said of blocks that are left out.
#include "app/whole/bodies.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "core/error.hpp"
#include "scene/read/read.hpp"

using namespace brunt;
using Catch::Contains;

namespace {

scene::Input with_mesh(const std::string& mesh, const std::string& parts = "a: {material: s}") {
  return scene::read_scene(
      fmt::format("units: none\nmesh: {}\nmaterials: {{s: {{model: elastic, density: 1, young: 1, poisson: 0}}}}\n"
                  "parts: {{{}}}\nrun: {{steps: 1}}\n",
                  mesh, parts),
      "a.yaml");
}

std::string warning_of(const std::string& body) {
  const app::RoundBodies found = app::round_bodies(with_mesh("{" + body + "}"));
  CHECK(found.lines.size() == 1);
  return found.warnings.empty() ? "" : found.warnings[0];
}

}  // namespace

TEST_CASE("a round body that loses more than a hundredth is warned of", "[bodies]") {
  const std::string sphere = "sphere: {{part: a, radius: 3, elements: {}, finer: {}, half: [{}]}}";
  const auto ball = [&](int n, double finer, const char* half) {
    return warning_of(fmt::format(fmt::runtime(sphere), n, finer, half));
  };
  CHECK_THAT(ball(12, 8, "x"), Contains("a.yaml:2: mesh: the mesh of a has 87.9"));
  CHECK_THAT(ball(12, 8, "x, y"), Contains("elements across the radius would suffice, or finer: 1."));
  for (const int n : {2, 4, 6, 8, 9})
    CHECK_THAT(ball(n, 1, "-y"), Contains("about 10 elements across the radius would suffice"));
  CHECK(ball(10, 1, "x").empty());
  CHECK(ball(12, 1.5, "x").empty());
  CHECK_THAT(ball(12, 8, "-z"), Contains("98.5"));
  CHECK_THAT(warning_of("cylinder: {part: a, radius: 2, length: 9, elements: [4, 2]}"), Contains("elements across"));
  CHECK(warning_of("cylinder: {part: a, radius: 2, length: 9, elements: [7, 2], quarter: [x, y]}").empty());
  for (const int around : {3, 8, 24})
    CHECK_THAT(warning_of(fmt::format(
                   "tube: {{part: a, inner_radius: 1, outer_radius: 2, length: 1, elements: [1, {}, 1]}}", around)),
               Contains("about 28 elements around would suffice"));
  CHECK(warning_of("tube: {part: a, inner_radius: 1, outer_radius: 2, length: 1, elements: [1, 28, 1]}").empty());
  const std::string torus = "torus: {{part: a, radius: 76, tube: [19.5, 24], elements: [{}, {}, 2]}}";
  CHECK_THAT(warning_of(fmt::format(fmt::runtime(torus), 40, 20)),
             Contains("97.96 %") && Contains("around the ring and 29 around the tube would suffice"));
  CHECK(warning_of(fmt::format(fmt::runtime(torus), 80, 40)).empty());
  CHECK(app::round_bodies(with_mesh("{box: {part: a, size: [1, 1, 1], elements: [1, 1, 1]}}")).lines.empty());
}

TEST_CASE("the same body twice is a fault, bodies apart are none", "[bodies]") {
  const std::string two =
      "[{{box: {{part: a, size: [1, 1, 1], elements: [2, 2, 2]}}}}, {{box: {{part: b, size: [1, 1, 1], elements: [2, "
      "2, 2], at: [{}, 0, 0]}}}}]";
  const auto faults = [&](double at) {
    std::vector<std::string> warnings;
    try {
      app::assemble(with_mesh(fmt::format(fmt::runtime(two), at), "a: {material: s}, b: {material: s}"), warnings);
    } catch (const InputError& error) {
      return error.faults();
    }
    return std::vector<std::string>();
  };
  REQUIRE(faults(0).size() == 1);
  CHECK_THAT(faults(0)[0],
             Catch::StartsWith("a.yaml:2: mesh: invalid block a and block b: 8 elements of one coincide"));
  CHECK_THAT(faults(0.5)[0], Contains("4 elements"));
  CHECK(faults(1).empty());
  CHECK(faults(0.25).empty());
  CHECK_THAT(faults(1e15)[0], Contains("a.yaml:2: mesh.1: ") && Contains("rounding"));
}

TEST_CASE("a torus turned upright and then about z stands where M8 has it", "[bodies]") {
  std::vector<std::string> warnings;
  const mesh::Mesh mesh = app::assemble(
      with_mesh("{torus: {part: a, radius: 76, tube: [19.5, 24], elements: [40, 20, 2], at: [140, 0, 140], rotate: "
                "[{axis: [1, 0, 0], degrees: 90}, {axis: [0, 0, 1], degrees: 45}]}}"),
      warnings);
  const auto node = [&](int i, int j, int k) {
    return mesh.coordinates[static_cast<std::size_t>((i * 20 + j) * 3 + k)];
  };
  const double s = std::sqrt(0.5);
  CHECK((node(0, 0, 2) - Vec3(100 * s + 140, 100 * s, 140)).norm() < 1e-12);
  CHECK((node(0, 5, 2) - Vec3((76 + 24) * s + 140, (76 - 24) * s, 140)).norm() < 1e-12);
  CHECK((node(10, 0, 0) - Vec3(140, 0, 76 + 19.5 + 140)).norm() < 1e-12);
  CHECK(warnings.empty());
}
