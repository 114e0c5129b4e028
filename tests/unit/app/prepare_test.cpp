// SPDX-License-Identifier: Apache-2.0
// From a scene file to model and state.
#include "app/start/prepare.hpp"

#include <catch2/catch.hpp>

#include "app/whole/whole_scene.hpp"
#include "core/error.hpp"
#include "prepared_scene.hpp"

using namespace brunt;

TEST_CASE("prepare: parts, masses, velocities and contact as the scene has them") {
  const support::PreparedScene scene(support::two_bodies + "contact: [{between: all}]\n");
  const app::Prepared& run = *scene.run;
  REQUIRE(run.model.blocks.size() == 2);
  CHECK(run.model.blocks[0].part == "low");
  CHECK(run.model.mesh.global_nodes == 26);
  CHECK(run.warnings.empty());
  REQUIRE(run.contact);
  double mass = 0, momentum = 0;
  for (const model::NodeLine& node : run.state.nodes) {
    mass += node.mass;
    momentum += node.mass * node.v[2];
  }
  CHECK(mass == Approx(15));
  CHECK(momentum == Approx(-6));
}

TEST_CASE("prepare: a value that is overridden, and the fingerprint of what may not change") {
  const support::SceneFolder folder;
  const std::string file = folder.write("scene.yaml", support::two_bodies);
  const comm::Communicator self = comm::Communicator::self();
  std::string as_is, longer, heavier;
  CHECK(app::read_input(self, file, {}, &as_is).run.end == 1);
  CHECK(app::read_input(self, file, {"run.end=7"}, &longer).run.end == 7);
  (void)app::read_input(self, file, {"materials.m.density=4"}, &heavier);
  CHECK(longer == as_is);
  CHECK(heavier != as_is);
}

TEST_CASE("prepare: what cannot be read is an input error with its name") {
  const support::SceneFolder folder;
  const comm::Communicator self = comm::Communicator::self();
  CHECK_THROWS_WITH(app::read_input(self, folder.path.string(), {}), Catch::Contains("is a folder"));
  CHECK_THROWS_AS(app::read_input(self, folder.file("none.yaml"), {}), InputError);
  const std::string no_mesh = folder.write("scene.yaml",
                                           "units: SI\nmesh: {file: nowhere.exo}\n"
                                           "materials: {m: {model: elastic, density: 1, young: 1, "
                                           "poisson: 0}}\nparts: {p: {block: 1, material: m}}\n"
                                           "run: {end: 1}\n");
  CHECK_THROWS_WITH(app::prepare(self, no_mesh, {}), Catch::Contains("nowhere.exo"));
}

TEST_CASE("prepare: overlaps at the start are refused unless the scene accepts them") {
  std::string text = support::two_bodies;
  text.replace(text.find("at: [0.5, 0.5, 1]"), 17, "at: [0.5, 0.5, 0.9]");
  support::PreparedScene refused(text + "contact: [{between: all}]\n");
  CHECK_THROWS_AS(app::refuse_overlaps(*refused.run), InputError);
  support::PreparedScene accepted(text + "contact: [{between: all, initial_overlap: warn}]\n");
  app::refuse_overlaps(*accepted.run);
  CHECK_FALSE(accepted.run->warnings.empty());
}

TEST_CASE("prepare: a registry of the state takes the run back to where it was") {
  support::PreparedScene scene(support::two_bodies + "contact: [{between: all}]\n");
  scene.evaluate();
  scene.advance();
  model::Registry registry = scene.run->registry();
  const double work = contact::collect(*scene.run->contact).contact_work, height = scene.run->state.nodes[0].x[2];
  CHECK(work > 0);
  scene.run->contact->ledger.sums.work.contact.add(5);
  scene.run->state.nodes[0].x[2] = 99;  // not in the registry: it follows from the displacement
  scene.run->after_restart();
  CHECK(contact::collect(*scene.run->contact).contact_work == work);
  CHECK(scene.run->state.nodes[0].x[2] == height);
  CHECK(std::ranges::any_of(registry.arrays, [](const model::StateArray& a) { return a.name == "contact_sums"; }));
}
