// SPDX-License-Identifier: Apache-2.0
// Answers that travel between ranks arrive whole.
#include "app/depth/depth_message.hpp"

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "depth_rows.hpp"

using namespace brunt;

TEST_CASE("depth_message: rows come back to the bit") {
  app::DepthRow free;
  free.answer.distance = .5;
  const std::vector<app::DepthRow> sent{support::depth_row(), free, support::depth_row()};
  const std::vector<std::byte> bytes = app::packed(sent);
  const std::vector<app::DepthRow> got = app::unpacked(bytes);
  REQUIRE(got.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const depth::Answer &one = sent[k].answer, &other = got[k].answer;
    CHECK(got[k].pose == sent[k].pose);
    CHECK(got[k].a == sent[k].a);
    CHECK(got[k].b == sent[k].b);
    CHECK(got[k].metric == sent[k].metric);
    CHECK(got[k].centroid == sent[k].centroid);
    CHECK(got[k].start.rotation == sent[k].start.rotation);
    CHECK(got[k].seconds == sent[k].seconds);
    CHECK(other.overlap == one.overlap);
    CHECK(other.found == one.found);
    CHECK(other.depth == one.depth);
    CHECK(other.bound == one.bound);
    CHECK(other.distance == one.distance);
    CHECK(other.placement.rotation == one.placement.rotation);
    CHECK(other.placement.translation == one.placement.translation);
    CHECK(other.motion.turn.coeffs() == one.motion.turn.coeffs());
    CHECK(other.motion.shift == one.motion.shift);
    REQUIRE(other.contacts.size() == one.contacts.size());
    for (std::size_t c = 0; c < one.contacts.size(); ++c) {
      CHECK(other.contacts[c].point == one.contacts[c].point);
      CHECK(other.contacts[c].normal == one.contacts[c].normal);
      CHECK(other.contacts[c].gap == one.contacts[c].gap);
    }
    CHECK(other.queries == one.queries);
  }
  CHECK(app::unpacked(app::packed({})).empty());
  CHECK_THROWS(app::unpacked(std::span(bytes).first(bytes.size() - 1)));
}
