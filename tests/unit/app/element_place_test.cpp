// SPDX-License-Identifier: Apache-2.0
// The element that a message names: where it is, and how far it is compressed.
#include "app/watch/element_place.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "app/watch/stop_causes.hpp"
#include "prepared_scene.hpp"

using namespace brunt;

namespace {

/// x = map(X) in the coordinates of the mesh.
void map_nodes(app::Prepared& run, const Mat3& map) {
  for (std::size_t i = 0; i < run.state.nodes.size(); ++i) {
    const Quad& X = run.model.reference[i];
    Eigen::Map<Vec3>(run.state.nodes[i].x) = map * Vec3(X[0], X[1], X[2]);
  }
}

LocalIndex element_of_input(const model::ElementBlock& block, GlobalIndex input) {
  LocalIndex element = 0;
  while (block.input[static_cast<std::size_t>(element)] != input) ++element;
  return element;
}

double& history_value(app::Prepared& run, std::size_t block, GlobalIndex input, const char* field) {
  const model::ElementBlock& of = run.model.blocks[block];
  const LocalIndex e = element_of_input(of, input);
  const std::ptrdiff_t row = std::ptrdiff_t{e / pack_width} * of.history_size + of.find(field)->first;
  return run.state.history[block][static_cast<std::size_t>(row * pack_width + e % pack_width)];
}

}  // namespace

TEST_CASE("element place: centre, shortest edge and volume of an element that is flattened, turned and far away") {
  std::string text = support::two_bodies;
  for (const auto& [here, far] :
       {std::pair<std::string, std::string>("elements: [2, 2, 1]}", "elements: [2, 2, 1], at: [1000, 0, 0]}"),
        std::pair<std::string, std::string>("at: [0.5, 0.5, 1]", "at: [1000.5, 0.5, 1]")})
    text.replace(text.find(here), here.size(), far);
  const support::PreparedScene scene(text);
  app::Prepared& run = *scene.run;
  const Mat3 turn = Eigen::AngleAxisd(2, Vec3(1, 2, -1).normalized()).matrix();
  const Mat3 map = turn * Vec3(1.5, 1, 0.25).asDiagonal();
  map_nodes(run, map);
  const Vec3 origin = run.model.mesh.origin;
  REQUIRE(origin[0] > 900);
  const app::ElementPlace third = app::place_of(run, 0, element_of_input(run.model.blocks[0], 2));
  CHECK(third.element == 2);
  CHECK(third.part == "low");
  CHECK((third.center - origin - map * (Vec3(1000.5, 1.5, 0.5) - origin)).norm() < 1e-12);
  CHECK(third.shortest_edge == Approx(0.25).epsilon(1e-12));
  CHECK(third.volume == Approx(0.375).epsilon(1e-12));
  const app::ElementPlace top = app::place_of(run, 1, 0);
  CHECK(top.element == 4);
  CHECK(top.block == 1);
  CHECK((top.center - origin - map * (Vec3(1001, 1, 1.5) - origin)).norm() < 1e-9);
  CHECK(app::place_of(run, -1, 0).element == -1);
  map_nodes(run, Vec3(1, 1, -1).asDiagonal());
  CHECK(app::place_of(run, 1, 0).volume == Approx(-1));
  CHECK(app::place_of(run, 1, 0).shortest_edge == Approx(1));
}

TEST_CASE("element place: the collapsed edges of wedges are no edges") {
  const support::PreparedScene scene(
      "units: none\nmesh: {tube: {part: a, inner_radius: 0, outer_radius: 1, length: 3, elements: [1, 3, 1], sector: "
      "[0, 90]}}\n"
      "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\nparts: {a: {material: m}}\nrun: {end: 1}\n");
  const double chord = 2 * std::sin(15 * std::numbers::pi / 180);  // the shortest edge; others are 1 and 3
  for (const double along : {1.0, 0.1, 0.0}) {
    map_nodes(*scene.run, Vec3(1, 1, along).asDiagonal());
    const app::ElementPlace place = app::place_of(*scene.run, 0, 0);
    CHECK(place.shortest_edge == Approx(std::min(1.0, 3 * along / chord)).margin(1e-12));
    CHECK(place.volume == Approx(along).margin(1e-12));
  }
  map_nodes(*scene.run, Vec3(0.05, 0.05, 4000).asDiagonal());
  CHECK_THAT(app::cause_of_collapse(app::place_of(*scene.run, 0, 0)), Catch::Contains("flattened"));
}

TEST_CASE("element place: the least value of a field, of equal ones the last element of the input that lives") {
  const support::PreparedScene scene(support::two_bodies);
  app::Prepared& run = *scene.run;
  const char* field = "hourglass_energy";
  for (const GlobalIndex input : {0, 1, 2, 3}) history_value(run, 0, input, field) = 7;
  history_value(run, 1, 4, field) = 7;
  CHECK(app::place_of_least(run, field).element == 4);
  history_value(run, 0, 1, field) = history_value(run, 0, 2, field) = -2;
  CHECK(app::place_of_least(run, field).element == 2);
  run.state.alive = {std::vector<double>(4, 1.0), {}};
  run.state.alive[0][static_cast<std::size_t>(element_of_input(run.model.blocks[0], 2))] = 0;
  CHECK(app::place_of_least(run, field).element == 1);
  CHECK(app::place_of_least(run, "no_such_field").element == -1);
}

TEST_CASE("element place: elements are counted from 1, and points have the mesh's origin put back") {
  CHECK(app::text_of(app::ElementPlace{.element = 16, .block = 0, .part = "a", .center = {0, 0.1, -0.2}}) ==
        "element 17 (position in the input) of part 'a' at (0, 0.1, -0.2)");
  const support::PreparedScene scene(support::two_bodies);
  scene.run->model.mesh.origin = {10, 20, -30};
  CHECK(app::text_of_point(*scene.run, {1, 0.5, 30}) == "(11, 20.5, 0)");
}
