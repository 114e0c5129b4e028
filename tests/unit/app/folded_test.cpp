// SPDX-License-Identifier: Apache-2.0
// Hexahedra turned inside out at a corner are found, counted and named; wedges and sheared ones are none.
#include "force/folded.hpp"

#include <catch2/catch.hpp>

#include "prepared_scene.hpp"

using namespace brunt;

namespace {

/// Three unit cubes in a row along x.
std::string row_of_cubes(const std::string& element) {
  return "units: none\nmesh: {box: {part: row, size: [3, 1, 1], elements: [3, 1, 1]}}\n"
         "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
         "parts: {row: {material: m, element: " +
         element + "}}\nrun: {end: 1}\n";
}

/// Moves the nodes of the row: place(x) is where the one at x goes to.
template <class Place>
force::FoldedElements folded_where(support::PreparedScene& scene, Place&& place) {
  const model::Model& model = scene.run->model;
  model::State& state = scene.run->state;
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const Quad& X = model.reference[i];
    const Vec3 x = place(Vec3(X[0], X[1], X[2]) + model.mesh.origin);
    for (int c = 0; c < 3; ++c) state.nodes[i].x[c] = x[c];
  }
  return force::folded_elements(model, state);
}

/// The node at the row's far end in the corner (1, 1) goes back by this.
auto pulled_back(double by) {
  return [by](const Vec3& x) { return x == Vec3(3, 1, 1) ? Vec3(3 - by, 1, 1) : x; };
}

}  // namespace

TEST_CASE("folded elements: a corner is folded once its edges span no volume the right way round") {
  support::PreparedScene scene(row_of_cubes("hex8"));
  CHECK(folded_where(scene, [](const Vec3& x) { return x; }).count == 0);
  CHECK(folded_where(scene, pulled_back(0.9)).count == 0);
  const force::FoldedElements one = folded_where(scene, pulled_back(1.2));
  CHECK(one.count == 1);
  CHECK(one.block == 0);
  CHECK(one.element == 2);
  // the corner's own Jacobian is 1 - 1.2, those of the other seven are 1 or, at its ends across x, 1 too
  CHECK(one.worst == Approx(-0.2));
}

TEST_CASE("folded elements: neither rotation, shear nor a squeeze is a fold") {
  support::PreparedScene scene(row_of_cubes("hex8"));
  CHECK(folded_where(scene, [](const Vec3& x) { return Vec3(x[0] + 3 * x[1], x[1], x[2]); }).count == 0);
  CHECK(folded_where(scene, [](const Vec3& x) { return Vec3(-x[0], -x[1], 1e-3 * x[2]); }).count == 0);
  CHECK(folded_where(scene, [](const Vec3& x) { return Vec3(-x[0], x[1], x[2]); }).count == 3);  // the mirror image
}

TEST_CASE("folded elements: corners of a wedge that lie on each other are flat, not folded") {
  support::PreparedScene scene(row_of_cubes("hex8"));
  const auto wedge = [](const Vec3& x) { return x[0] == 3 && x[2] == 1 ? Vec3(3, x[1], 0) : x; };
  CHECK(folded_where(scene, wedge).count == 0);
  const auto turned = [&](const Vec3& x) { return Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * wedge(x); };
  CHECK(folded_where(scene, turned).count == 0);
}

TEST_CASE("folded elements: those with more points are counted too, since contact loses nodes behind their faces") {
  support::PreparedScene scene(row_of_cubes("hex8_full"));
  CHECK(folded_where(scene, pulled_back(1.2)).count == 1);
}
