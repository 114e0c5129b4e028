// SPDX-License-Identifier: Apache-2.0
// Convex pairs: spheres, and random polytopes against the Minkowski difference (section A1 of the reference).
#include <fmt/core.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "depth/penetration_depth.hpp"
#include "tests/support/random_polytopes.hpp"

using namespace brunt;

namespace {

constexpr std::array<depth::Metric, 3> metrics{depth::Metric::translation, depth::Metric::displacement,
                                               depth::Metric::object_norm};

/// Of the walk, relative to A's radius: without convex pieces its bound does not tell the answer.
struct Errors {
  int pairs = 0;
  double walk = 0, above = 0, piece = 0;  ///< |PDt - oracle|, DISP - PDt, |translation_depth - oracle|
  std::int64_t worse = 0;                 ///< walks farther off than 1e-6
};

/// The body without its own convex piece, so that walks have no exact bound to end at.
depth::Body without_pieces(const TriangleSurface& surface) {
  depth::Body body = depth::make_body(surface, {.balls = 50, .pieces = {}});
  body.pieces.clear();
  body.piece_reach.clear();
  return body;
}

Errors compare(int bodies, int pairs, bool careful) {
  test::Random random(31);
  std::vector<TriangleSurface> surfaces;
  std::vector<depth::Body> walked;
  std::vector<depth::ConvexPiece> pieces;
  for (int k = 0; k < bodies; ++k) {
    surfaces.push_back(test::random_polytope(random, 5 + random.below(5)));
    walked.push_back(without_pieces(surfaces.back()));
    pieces.push_back(depth::convex_piece(surfaces.back().points));
  }
  Errors errors;
  while (errors.pairs < pairs) {
    const auto a = static_cast<std::size_t>(random.below(bodies)), b = static_cast<std::size_t>(random.below(bodies));
    depth::Query query;
    query.a_in_b = depth::rounded(test::near_placement(random), walked[a].shape.radius);
    query.careful = careful;
    query.metric = depth::Metric::translation;
    const double exact = test::minkowski_depth(surfaces[a].points, surfaces[b].points, query.a_in_b);
    if (!(exact > 1e-4)) continue;  // overlapping, by more than the clearance of a walk
    ++errors.pairs;
    const double size = walked[a].shape.radius;
    const double piece = depth::translation_depth(pieces[a], pieces[b], query.a_in_b);
    errors.piece = std::max(errors.piece, std::abs(piece - exact) / size);
    const double found = depth::penetration_depth(walked[a], walked[b], query).depth;
    errors.walk = std::max(errors.walk, std::abs(found - exact) / size);
    errors.worse += std::abs(found - exact) > 1e-6 * size ? 1 : 0;
    query.metric = depth::Metric::displacement;
    const double turned = depth::penetration_depth(walked[a], walked[b], query).depth;
    errors.above = std::max(errors.above, std::abs(turned - exact) / size);
  }
  fmt::print(
      "{} convex pairs, {}: PDt within {:.2g} of A's radius, {} beyond 1e-6; DISP within {:.2g}; pieces {:.2g}\n",
      errors.pairs, careful ? "careful" : "fast", errors.walk, errors.worse, errors.above, errors.piece);
  return errors;
}

}  // namespace

TEST_CASE("spheres: the depth of their facets, in all metrics", "[oracle]") {
  const TriangleSurface sphere = test::sphere_grid(36, 40, [](double u, double s) {  // 2,880 triangles
    const double theta = test::pi * s;
    return Vec3(std::sin(theta) * std::cos(u), std::sin(theta) * std::sin(u), std::cos(theta));
  });
  const depth::Body body = depth::make_body(sphere);
  for (const double distance : {1.9, 1.0})
    for (const depth::Metric metric : metrics) {
      depth::Query query;
      query.a_in_b.translation = {distance, 0, 0};
      query.metric = metric;
      query.careful = true;
      const depth::Answer answer = depth::penetration_depth(body, body, query);
      // the flattest facet of 36 x 41 lies 1 - cos(pi/36) cos(pi/82) = .0045 below the sphere, of either body
      CHECK(answer.depth <= 2 - distance);
      CHECK(answer.depth >= 2 - distance - 2 * .0046);
      CHECK(answer.bound <= answer.depth);
      // the balls about both centres that touch that facet overlap by as much
      if (metric != depth::Metric::object_norm) CHECK(answer.bound >= 2 - distance - 2 * .0046);
    }
}

TEST_CASE("random convex pairs have the depth of the Minkowski difference", "[oracle]") {
  for (const bool careful : {false, true}) {
    const Errors errors = compare(30, 60, careful);
    CHECK(errors.piece < 1e-13);
    CHECK(errors.worse == 0);
    CHECK(errors.walk < (careful ? 1e-8 : 1e-6));   // clearance of the mode
    CHECK(errors.above < (careful ? 1e-7 : 1e-3));  // slope at which walks end
  }
}

TEST_CASE("ten thousand random convex pairs have the depth of the Minkowski difference", "[.][long][oracle]") {
  for (const bool careful : {false, true}) {
    const Errors errors = compare(200, std::getenv("PAIRS") ? std::atoi(std::getenv("PAIRS")) : 10000, careful);
    CHECK(errors.piece < 1e-13);
    CHECK(errors.worse <= errors.pairs / 1000);     // walks that ended in another minimum or at a corner
    CHECK(errors.above < (careful ? 1e-6 : 1e-3));  // slope at which walks end
  }
}
