// SPDX-License-Identifier: Apache-2.0
// What the geometry of the start takes for the bodies is what contact takes for them in the run.
#include "app/whole/start_rules.hpp"

#include <catch2/catch.hpp>

#include "app/whole/whole_scene.hpp"
#include "prepared_scene.hpp"

using namespace brunt;

TEST_CASE("start rules: the figures that choose the slave are those of the run") {
  const support::PreparedScene scene(support::two_bodies +
                                     "contact: [{between: all}]\nsymmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}]\n");
  std::vector<std::string> warnings;
  const mesh::CanonicalMesh whole = app::whole_mesh(scene.run->input, warnings);
  const setup::StartRules rules = app::start_rules(scene.run->input, whole.mesh);
  const std::vector<contact::BodyFigures> foretold =
      setup::body_figures(whole.mesh, setup::contact_faces(whole.mesh, rules.symmetric), rules.density);
  const std::vector<contact::BodyFigures>& bodies = scene.run->contact->surface.bodies;
  REQUIRE(foretold.size() == bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    CHECK(foretold[b].mean_area == Approx(bodies[b].mean_area).epsilon(1e-12));
    CHECK(foretold[b].longest_edge == bodies[b].longest_edge);
    CHECK(foretold[b].shortest_edge == bodies[b].shortest_edge);
    CHECK(foretold[b].mean_mass == Approx(bodies[b].mean_mass).epsilon(1e-12));
  }
}

TEST_CASE("start rules: nodes are held in the directions of supports, not about the axes of rotations") {
  const support::PreparedScene scene(
      "units: none\nmesh: {box: {part: b, size: [1, 1, 1], elements: [1, 1, 1]}}\n"
      "materials: {m: {model: rigid, density: 1}}\nparts: {b: {material: m}}\n"
      "fixed: [{part: b, dofs: [y, rx]}]\n"
      "prescribed: [{part: b, dof: rz, velocity: 1}, {part: b, dof: x, velocity: 2}]\nrun: {end: 1, step: 0.1}\n");
  std::vector<std::string> warnings;
  const mesh::CanonicalMesh whole = app::whole_mesh(scene.run->input, warnings);
  const app::HeldByScene held = app::held_nodes(scene.run->input, whole.mesh);
  REQUIRE(held.key == std::vector<std::string>{"fixed.0", "prescribed.1"});
  REQUIRE(held.nodes.size() == 2);
  CHECK(held.nodes[0].direction == Vec3::UnitY());
  CHECK(held.nodes[1].direction == Vec3::UnitX());
  CHECK(held.nodes[1].nodes.size() == 8);
}
