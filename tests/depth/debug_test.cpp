// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>

#include "brunt/depth/penetration_depth.hpp"
#include "brunt/depth/starts.hpp"
#include "brunt/depth/walk.hpp"
#include "tests/depth/cases.hpp"
using namespace brunt;
TEST_CASE("debug", "[.][table]") {
  const auto cases = test::mesh_pairs();
  const auto& c = cases[static_cast<std::size_t>(atoi(getenv("CASE")))];
  const depth::Body a = depth::make_body(c.a.surface), b = depth::make_body(c.b.surface);
  depth::Encounter e{a, b, c.a_in_b};
  depth::StartOptions o;
  const int m = atoi(getenv("METRIC"));
  o.metric = static_cast<depth::Metric>(m);
  const auto starts = depth::find_starts(e, o);
  fmt::print("{} starts {} queries ref {}\n", starts.size(), e.queries, c.depth[static_cast<std::size_t>(m)]);
  depth::Walker w;
  depth::WalkOptions wo;
  wo.metric = o.metric;
  for (const auto& s : starts) {
    const auto r = w.walk(e, s.motion, wo);
    fmt::print("{:.4f} turn {:.3f} -> {:.4f} turn {:.3f} steps {} stat {} conds {}\n", s.length, depth::rotation_vector(s.motion.turn).norm(), r.length,
               depth::rotation_vector(r.motion.turn).norm(), r.steps, r.stationary, w.conditions().size());
  }
}

TEST_CASE("profile", "[.][table]") {
  const auto cases = test::mesh_pairs();
  const auto& c = cases[static_cast<std::size_t>(atoi(getenv("CASE")))];
  const depth::Body a = depth::make_body(c.a.surface), b = depth::make_body(c.b.surface);
  for (int i = 0; i < 10; ++i) {
    depth::Query q;
    q.a_in_b = c.a_in_b;
    q.metric = static_cast<depth::Metric>(atoi(getenv("METRIC")));
    q.careful = getenv("CAREFUL") != nullptr;
    CHECK(depth::penetration_depth(a, b, q).depth > 0);
  }
}
