// SPDX-License-Identifier: Apache-2.0
// Sides of halved bodies and blocks to ignore, as a scene writes them.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "scene/read/read.hpp"

using namespace brunt;
using namespace brunt::scene;

namespace {

Input with_mesh(const std::string& mesh) {
  return read_scene(
      fmt::format("units: none\nmesh: {}\nmaterials: {{s: {{model: elastic, density: 1, young: 1, poisson: 0}}}}\n"
                  "parts: {{a: {{material: s}}}}\nrun: {{steps: 1}}\n",
                  mesh),
      "a.yaml");
}

const std::array<std::string, 3> bodies{
    "cylinder: {{part: a, radius: 1, length: 1, elements: [2, 1], {}}}",
    "sphere: {{part: a, radius: 1, elements: 3, {}}}",
    "tube: {{part: a, inner_radius: 1, outer_radius: 2, length: 1, elements: [1, 8, 1], {}}}"};

std::array<int, 3> half_of(const MeshEntry& entry) {
  if (const auto* body = std::get_if<CylinderMesh>(&entry.body)) return body->half.half;
  if (const auto* body = std::get_if<SphereMesh>(&entry.body)) return body->half;
  return std::get<TubeMesh>(entry.body).half.half;
}

}  // namespace

TEST_CASE("half and quarter of round bodies", "[scene]") {
  using Sides = std::array<int, 3>;
  for (const std::string& body : bodies)
    for (const auto& [text, half] : {std::pair<std::string, Sides>{"scale: 1", {0, 0, 0}},
                                     {"half: [x]", {1, 0, 0}},
                                     {"half: [-x]", {-1, 0, 0}},
                                     {"half: [-y, x]", {1, -1, 0}},
                                     {"quarter: [x, -y]", {1, -1, 0}},
                                     {"quarter: [y, x]", {1, 1, 0}}}) {
      INFO(text);
      CHECK(half_of(with_mesh(fmt::format("{{{}}}", fmt::format(fmt::runtime(body), text))).mesh[0]) == half);
    }
  CHECK(half_of(with_mesh("{sphere: {part: a, radius: 1, elements: 3, finer: 3, half: [-z]}}").mesh[0]) ==
        Sides{0, 0, -1});
  CHECK(half_of(with_mesh("{sphere: {part: a, radius: 1, elements: 3, quarter: [z, -x]}}").mesh[0]) == Sides{-1, 0, 1});
}

TEST_CASE("wrong halves are refused at their key", "[scene]") {
  for (const std::string& body : bodies)
    for (const auto& [text, what] : {std::pair<std::string, std::string>{"half: [w]", ".half.0: unknown value 'w'"},
                                     {"half: [x, -x]", ".half.1: invalid side '-x': axis x is named twice"},
                                     {"half: x", ".half: invalid value 'x'"},
                                     {"half: []", ".half: invalid list of 0 entries"},
                                     {"quarter: [x]", ".quarter: invalid list of 1 entries"},
                                     {"quarter: [x, y, -y]", ".quarter: invalid list of 3 entries"},
                                     {"half: [x], quarter: [x, y]", ".quarter: invalid together with half"}}) {
      INFO(body << ' ' << text);
      CHECK_THROWS_WITH(with_mesh(fmt::format("{{{}}}", fmt::format(fmt::runtime(body), text))),
                        Catch::StartsWith("a.yaml:2: mesh.") && Catch::Contains(what) && Catch::Contains("expected "));
    }
  for (const std::size_t k : {0, 2})
    CHECK_THROWS_WITH(with_mesh(fmt::format("{{{}}}", fmt::format(fmt::runtime(bodies[k]), "half: [z]"))),
                      Catch::Contains("unknown value 'z' (did you mean 'x'?); expected one of x, -x, y, -y"));
}

TEST_CASE("blocks to ignore", "[scene]") {
  CHECK(std::get<MeshFile>(with_mesh("{file: a.inp, ignore: [shell, 12]}").mesh[0].body).ignore ==
        std::vector<std::string>{"shell", "12"});
  CHECK(std::get<MeshFile>(with_mesh("{file: a.inp, ignore: []}").mesh[0].body).ignore.empty());
  CHECK_THROWS_WITH(with_mesh("{file: a.inp, ignore: shell}"),
                    Catch::Contains("mesh.ignore: invalid value 'shell'; expected a list"));
  CHECK_THROWS_WITH(with_mesh("{file: a.inp, ignore: [a, a]}"),
                    Catch::Contains("mesh.ignore.1: invalid block 'a': listed twice"));
  CHECK_THROWS_WITH(with_mesh("{file: a.inp, ignore: [[a]]}"), Catch::Contains("mesh.ignore.0: "));
  CHECK_THROWS_WITH(with_mesh("{box: {part: a, size: [1, 1, 1], elements: [1, 1, 1], ignore: [b]}}"),
                    Catch::Contains("unknown key"));
}
