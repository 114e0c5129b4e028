// SPDX-License-Identifier: Apache-2.0
// What elements cost a rank, and which faces bring contact its work.
#include "app/whole/weights.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "app/whole/start_rules.hpp"
#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "scene/build/select.hpp"
#include "scene/read/read.hpp"

using namespace brunt;

namespace {

/// A fine cube of 3^3 elements that stands, or falls, over a slab of 2 x 2 x 1.
struct Scene {
  scene::Input input;
  mesh::CanonicalMesh whole;

  explicit Scene(const std::string& more, double height = 0.01)
      : input(scene::read_scene("units: none\nmesh: {file: of_the_test}\nrun: {end: 1}\n"
                                "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
                                "parts: {slab: {material: m}, cube: {material: m, element: hex8_full}}\n" +
                                    more,
                                "scene of the test")) {
    mesh::Mesh mesh;
    mesh::append(mesh, mesh::box("slab", Vec3(4, 4, 1), {2, 2, 1}), "");
    mesh::Mesh cube = mesh::box("cube", Vec3(1, 1, 1), {3, 3, 3});
    for (Vec3& x : cube.coordinates) x += Vec3(0, 1.5, 1 + height);
    mesh::append(mesh, std::move(cube), "");
    whole = mesh::canonical_order(std::move(mesh));
    scene::select(input, whole);
  }
  [[nodiscard]] partition::Weights weights() const { return app::weigh(input, whole); }
};

std::int64_t faces_of(const partition::Weights& weights, std::size_t from, std::size_t to) {
  std::int64_t sum = 0;
  for (std::size_t e = from; e < to; ++e) sum += weights.contact_faces[e];
  return sum;
}

constexpr std::size_t slab = 4, both = 4 + 27;

}  // namespace

TEST_CASE("weights: a fully integrated element costs five of one point") {
  const partition::Weights weights = Scene("").weights();
  REQUIRE(weights.cost.size() == both);
  for (std::size_t e = 0; e < both; ++e) CHECK(weights.cost[e] == Approx(weights.cost[0] * (e < slab ? 1 : 5)));
  CHECK(faces_of(weights, 0, both) == 0);  // no contact
}

TEST_CASE("weights: faces of the slave that are near the master, or fall onto it, count") {
  const partition::Weights near = Scene("contact: [{between: all}]\n").weights();
  CHECK(faces_of(near, 0, slab) == 0);
  CHECK(faces_of(near, slab, both) >= 9);       // its foot
  CHECK(faces_of(near, slab, both) <= 9 + 12);  // and what of its sides is near
  const std::string fast = "contact: [{between: all}]\ninitial: [{part: cube, velocity: [0, 0, -10]}]\n";
  CHECK(faces_of(Scene(fast, 5).weights(), slab, both) == 9);
}

TEST_CASE("weights: faces in a plane of symmetry touch nothing") {
  const Scene whole("contact: [{between: all}]\n"),
      half("contact: [{between: all}]\nsymmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}]\n");
  const std::size_t exterior = (2 * 4 + 4 * 2) + 6 * 9;
  const auto touching = [](const Scene& scene) {
    const mesh::Mesh& mesh = scene.whole.mesh;
    return setup::contact_faces(mesh, app::start_rules(scene.input, mesh).symmetric).size();
  };
  CHECK(touching(whole) == exterior);
  CHECK(touching(half) == exterior - 2 - 9);
}
