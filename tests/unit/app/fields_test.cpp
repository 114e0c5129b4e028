// SPDX-License-Identifier: Apache-2.0
// Fields of state.h5 from a state whose values are known.
#include "app/report/fields.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "prepared_scene.hpp"

using namespace brunt;

TEST_CASE("fields: those asked for, in their order, a value a component of each node or element") {
  const support::PreparedScene scene(support::two_bodies);
  scene.run->input.output.fields = {"velocity", "mass", "stress", "displacement"};
  const std::vector<io::StateField> fields = app::state_fields(*scene.run);
  REQUIRE(fields.size() == 4);
  CHECK(fields[0].name == "velocity");
  CHECK(fields[0].components == 3);
  REQUIRE(fields[0].values.size() == 3 * 26);
  double falling = 0;
  for (std::size_t n = 0; n < 26; ++n) falling += fields[0].values[3 * n + 2];
  CHECK(falling == -2 * 8);
  CHECK(fields[1].components == 1);
  CHECK(std::accumulate(fields[1].values.begin(), fields[1].values.end(), 0.0) == Approx(15));
  CHECK(fields[2].place == io::Place::element);
  CHECK(fields[2].values == std::vector<double>(6 * 5, 0.0));
  CHECK(fields[3].values == std::vector<double>(3 * 26, 0.0));
}

TEST_CASE("fields: von Mises stress of the element that has one") {
  const support::PreparedScene scene(support::two_bodies);
  scene.run->input.output.fields = {"mises"};
  const model::ElementBlock& block = scene.run->model.blocks[0];
  const auto first = static_cast<std::size_t>(block.find("stress")->first) * pack_width;
  std::vector<double> all(6, 0.0);
  all[0] = 5;  // with a shear of 2: sqrt(25 + 3 * 4)
  all[3] = 2;
  for (std::size_t c = 0; c < 6; ++c) scene.run->state.history[0][first + c * pack_width + 1] = all[c];
  const std::vector<io::StateField> fields = app::state_fields(*scene.run);
  REQUIRE(fields.size() == 1);
  REQUIRE(fields[0].values.size() == 5);
  for (std::size_t e = 0; e < 5; ++e) CHECK(fields[0].values[e] == Approx(e == 1 ? std::sqrt(37.0) : 0.0));
}

TEST_CASE("fields: contact fields come by themselves, zero without contact") {
  const std::string asked = "output: {every: 1, fields: [contact_pressure, displacement, gap]}\n";
  const support::PreparedScene without(support::two_bodies + asked);
  const std::vector<io::StateField> none = app::contact_fields(*without.run, 1.0);
  REQUIRE(none.size() == 2);
  CHECK(none[0].values == std::vector<double>(26, 0.0));

  support::PreparedScene with(support::two_bodies + asked + "contact: [{between: all, passes: one}]\n");
  with.evaluate();
  with.advance();
  const std::vector<io::StateField> fields = app::contact_fields(*with.run, with.report.dt_mean);
  REQUIRE(fields.size() == 2);
  CHECK(fields[0].name == "contact_pressure");
  CHECK(*std::ranges::max_element(fields[0].values) > 0);
  CHECK(std::ranges::count_if(fields[0].values, [](double p) { return p > 0; }) == 4);  // the cube's foot
  CHECK(app::state_fields(*with.run).size() == 1);
}
