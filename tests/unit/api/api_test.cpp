// SPDX-License-Identifier: Apache-2.0
// Arguments that do not fit together; tests/package judges what comes out.
#include <catch2/catch.hpp>
#include <functional>
#include <limits>
#include <stdexcept>

#include "brunt/contact_step.hpp"
#include "brunt/penetration_depth.hpp"
#include "brunt/search.hpp"

using namespace brunt;

namespace {

/// A tetrahedron of part 0.
api::ContactMesh tetrahedron() {
  return {.node_number = {7, 3, 9, 5},
          .position = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1},
          .element_number = {1},
          .corner = {0, 1, 2, 3, -1, -1, -1, -1},
          .part = {0},
          .mass = {1, 1, 1, std::numeric_limits<double>::infinity()}};
}

}  // namespace

TEST_CASE("a step of contact: what is wrong with a mesh is said") {
  const auto refused = [](const std::function<void(api::ContactMesh&)>& change, const std::string& says) {
    api::ContactMesh mesh = tetrahedron();
    change(mesh);
    CHECK_THROWS_WITH(api::ContactStep(MPI_COMM_WORLD, mesh), Catch::Contains(says));
  };
  CHECK_NOTHROW(api::ContactStep(MPI_COMM_WORLD, tetrahedron()));
  refused([](api::ContactMesh& m) { m.position.pop_back(); }, "position has three numbers");
  refused([](api::ContactMesh& m) { m.part.clear(); }, "corner has eight numbers and part one");
  refused([](api::ContactMesh& m) { m.mass[1] = 0; }, "masses are positive");
  refused([](api::ContactMesh& m) { m.part[0] = -1; }, "parts count from 0");
  refused([](api::ContactMesh& m) { m.corner[3] = 4; }, "corners are positions in node_number");
  refused([](api::ContactMesh& m) { m.node_number[1] = 9; }, "a rank has each node once");
  refused([](api::ContactMesh& m) { std::swap(m.corner[0], m.corner[1]); }, "element 1");  // inside out
  refused([](api::ContactMesh& m) { m.position[0] = std::numeric_limits<double>::quiet_NaN(); }, "");
}

TEST_CASE("a step of contact: a body alone keeps its velocity, and wrong arrays are refused") {
  api::ContactStep step(MPI_COMM_WORLD, tetrahedron());
  const std::vector<double> position = tetrahedron().position, before(12, 2.0);
  std::vector<double> velocity(12, 2.0), impulse(12, 1.0);
  const api::ContactReport report = step.correct(position, before, velocity, 0.01, impulse);
  CHECK(velocity == before);
  CHECK(impulse == std::vector<double>(12, 0.0));
  CHECK(report.active == 0);
  CHECK_THROWS_AS(step.correct(position, before, velocity, 0, impulse), std::invalid_argument);
  velocity.pop_back();
  CHECK_THROWS_AS(step.correct(position, before, velocity, 0.01), std::invalid_argument);
}

TEST_CASE("search and depth: arrays of the wrong length are refused") {
  const std::vector<double> five(5);
  CHECK_THROWS_AS(api::find_points_in_boxes(MPI_COMM_WORLD, five, {}), std::invalid_argument);
  CHECK_THROWS_AS(api::find_points_in_boxes(MPI_COMM_WORLD, {}, five), std::invalid_argument);
  CHECK(api::find_points_in_boxes(MPI_COMM_WORLD, {}, {}).first == std::vector<std::int64_t>{0});
  const std::vector<std::int32_t> triangle{0, 1, 2};
  CHECK_THROWS_AS(api::DepthBody(five, triangle), std::invalid_argument);
  const std::vector<double> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
  CHECK_THROWS_AS(api::DepthBody(corners, triangle), std::invalid_argument);  // open
  const std::vector<std::int32_t> outside{0, 1, 3};
  CHECK_THROWS_AS(api::DepthBody(corners, outside), std::invalid_argument);
}
