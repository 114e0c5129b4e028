// SPDX-License-Identifier: Apache-2.0
// What the geometry of the start takes for the bodies is what contact takes for them in the run.
#include "app/start_rules.hpp"

#include <catch2/catch.hpp>

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
