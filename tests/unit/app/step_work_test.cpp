// SPDX-License-Identifier: Apache-2.0
// Samples add up where they are wanted; pairs of contact go to elements on the side that is searched.
#include "app/state/step_work.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "comm/message_time.hpp"
#include "unit/app/prepared_scene.hpp"

using namespace brunt;

TEST_CASE("step work: samples are taken where they are on") {
  double on = 0, off = 0;
  for (const bool sampled : {true, false}) {
    const app::WorkSample sample(sampled ? on : off, sampled);
    const double end = comm::processor_seconds() + 0.002;
    while (comm::processor_seconds() < end) {
    }
  }
  CHECK(on >= 0.0019);  // of 0.002, less rounding
  CHECK(off == 0);
}

TEST_CASE("step work: what is no motion of nodes is contact, if there is any") {
  app::StepWork work{.evaluate = 3, .advance = 2, .motion = 0.5, .steps = 1, .contact = true};
  CHECK(work.of_elements() == 3.5);
  CHECK(work.of_contact() == 1.5);
  work.contact = false;
  CHECK(work.of_elements() == 5);
  CHECK(work.of_contact() == 0);
}

TEST_CASE("step work: pairs of contact belong to elements that may touch") {
  support::PreparedScene scene(support::two_bodies + "contact: [{between: all}]\n");
  scene.evaluate();
  scene.advance();
  const auto pairs = app::pairs_of_elements(scene.run->model, scene.run->contact.get());
  REQUIRE(pairs.size() == 2);
  CHECK(pairs[0].size() == 4);
  CHECK(pairs[1].size() == 1);
  double sum = 0;
  for (const auto& block : pairs) sum += std::accumulate(block.begin(), block.end(), 0.0);
  double candidates = static_cast<double>(scene.run->contact->lists.candidates.faces.values.size()) +
                      static_cast<double>(scene.run->contact->lists.edges.near.values.size());
  CHECK(sum == candidates);
  CHECK(sum > 0);
  const auto none = app::pairs_of_elements(scene.run->model, nullptr);
  CHECK(none[0] == std::vector<double>(4, 0.0));
}
