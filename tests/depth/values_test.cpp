// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <catch2/catch.hpp>
#include <chrono>

#include "brunt/depth/penetration_depth.hpp"
#include "tests/depth/cases.hpp"

using namespace brunt;

namespace {

constexpr std::array<depth::Metric, 3> metrics{depth::Metric::translation, depth::Metric::displacement,
                                               depth::Metric::object_norm};
constexpr std::array<const char*, 3> names{"PDt", "DISP", "rms"};

void print(const test::DepthCase& c, bool careful) {
  const depth::Body a = depth::make_body(c.a.surface, {400, c.a.pieces}),
                    b = depth::make_body(c.b.surface, {400, c.b.pieces});
  fmt::print("{:24}", c.name);
  for (std::size_t m = 0; m < 3; ++m) {
    depth::Query query;
    query.a_in_b = c.a_in_b;
    query.metric = metrics[m];
    query.careful = careful;
    const auto before = std::chrono::steady_clock::now();
    const depth::Answer answer = depth::penetration_depth(a, b, query);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before).count();
    fmt::print(" | {:4} {:.6f} {:+8.4f} % (ref {:.6f}) >= {:.4f} {:2} walks {:3} steps {:5} queries {:6.1f} ms",
               names[m], answer.depth, c.depth[m] > 0 ? 100 * (answer.depth / c.depth[m] - 1) : 0, c.depth[m],
               answer.bound, answer.walks, answer.steps, answer.queries, ms);
  }
  fmt::print("\n");
}

}  // namespace

TEST_CASE("table of values", "[.][table]") {
  for (const bool careful : {false, true}) {
    fmt::print("{}\n", careful ? "careful" : "fast");
    for (const auto& set : {test::closed_forms(), test::interlocked_boxes(), test::mesh_pairs()})
      for (const test::DepthCase& c : set) print(c, careful);
  }
}
