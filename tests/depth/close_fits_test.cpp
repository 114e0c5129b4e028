// SPDX-License-Identifier: Apache-2.0
// Machine parts that overlap a little in their counterparts: the motion back to where they fit is known, and no answer
// may be longer.
#include "tests/depth/close_fits.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>

#include "depth/penetration_depth.hpp"
#include "tests/support/depth_bodies.hpp"

using namespace brunt;

namespace {

constexpr std::array<depth::Metric, 3> metrics{depth::Metric::translation, depth::Metric::displacement,
                                               depth::Metric::object_norm};

double cpu_ms() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

int number(const char* name, int standard) {
  return std::getenv(name) ? std::atoi(std::getenv(name)) : standard;
}

TriangleSurface placed(TriangleSurface surface, const Placement& placement) {
  for (Vec3& x : surface.points) x = placement(x);
  return surface;
}

/// Whether an edge of one surface passes through a triangle of the other, both by more than `tolerance`, or a point of
/// it lies inside by more: by plain products, without the trees and predicates of the program.
bool pierces(const TriangleSurface& one, const TriangleSurface& other, double tolerance) {
  const auto at = [](const TriangleSurface& s, LocalIndex i) { return s.points[static_cast<std::size_t>(i)]; };
  for (const auto& t : other.triangles) {
    const Vec3 a = at(other, t[0]), b = at(other, t[1]), c = at(other, t[2]);
    const Vec3 n = (b - a).cross(c - a).normalized();
    const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (const auto& edges : one.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 p = at(one, edges[k]), q = at(one, edges[(k + 1) % 3]);
        if ((p.cwiseMin(q).array() > high.array()).any() || (p.cwiseMax(q).array() < low.array()).any()) continue;
        const double hp = n.dot(p - a), hq = n.dot(q - a);
        if (!(std::min(hp, hq) < -tolerance && std::max(hp, hq) > tolerance)) continue;
        const Vec3 x = p + hp / (hp - hq) * (q - p);
        const auto beside = [&](const Vec3& u, const Vec3& v) { return n.cross(v - u).normalized().dot(x - u); };
        if (std::min({beside(a, b), beside(b, c), beside(c, a)}) > tolerance) return true;
      }
  }
  return false;
}

bool overlap(const TriangleSurface& a, const TriangleSurface& b, double tolerance) {
  return pierces(a, b, tolerance) || pierces(b, a, tolerance) || geometry::winding_number(b, a.points.front()) > .5 ||
         geometry::winding_number(a, b.points.front()) > .5;
}

depth::Answer answer_of(const depth::Body& a, const depth::Body& b, const Placement& pose, depth::Metric metric,
                        bool careful) {
  depth::Query query;
  query.a_in_b = pose;
  query.metric = metric;
  query.careful = careful;
  return depth::penetration_depth(a, b, query);
}

struct Counts {
  int all = 0, long_ones = 0, silent = 0, overlapping = 0, disorder = 0;
};

/// Asks for the three metrics: the known motion back is an upper bound of each that admits it.
void ask(const test::CloseFit& fit, bool careful, Counts& counts) {
  const depth::Body a = depth::make_body(fit.a), b = depth::make_body(fit.b);
  const depth::RigidMotion back = depth::motion_between(fit.a_in_b, fit.fits, a.shape.centroid);
  double before = std::numeric_limits<double>::infinity();
  for (const depth::Metric metric : metrics) {
    const depth::Answer answer = answer_of(a, b, fit.a_in_b, metric, careful);
    ++counts.all;
    const bool known = metric != depth::Metric::translation || fit.straight;
    const bool too_long = known && answer.depth > 1.01 * depth::length_of(a.shape, metric, back);
    counts.long_ones += too_long ? 1 : 0;
    counts.silent += too_long && !depth::far_above_overlaps(answer) ? 1 : 0;
    counts.overlapping += overlap(placed(fit.a, answer.placement), fit.b, 1e-6 * a.shape.radius) ? 1 : 0;
    counts.disorder += answer.depth > before * (1 + 1e-9) ? 1 : 0;
    CHECK(answer.bound <= answer.depth);
    before = answer.depth;
  }
}

}  // namespace

TEST_CASE("close fits: no answer is longer than the motion back, overlaps, or breaks the order of the metrics",
          "[oracle]") {
  Counts counts;
  for (int kind = 0; kind < test::fit_kinds; ++kind)
    for (std::uint64_t seed = 100; seed < 104; ++seed) ask(test::close_fit(kind, seed % 2 == 0, seed), false, counts);
  CHECK(counts.all == 60);
  CHECK(counts.long_ones == 0);
  CHECK(counts.silent == 0);
  CHECK(counts.overlapping == 0);
  CHECK(counts.disorder == 0);
}

TEST_CASE("three hundred close fits: nine of ten answers are no longer than the motion back, the others warn",
          "[.][long][law]") {
  Counts counts;
  for (int kind = 0; kind < test::fit_kinds; ++kind)
    for (std::uint64_t seed = 200; seed < 260; ++seed) ask(test::close_fit(kind, seed % 2 == 0, seed), false, counts);
  fmt::print("close fits: {} of {} answers longer than the motion back\n", counts.long_ones, counts.all);
  CHECK(counts.long_ones <= counts.all / 10);
  CHECK(counts.silent == 0);
  CHECK(counts.overlapping == 0);
  CHECK(counts.disorder == 0);
}

TEST_CASE("a plate that stands in a block at a quarter turn comes out flat in the object norm", "[oracle]") {
  const depth::Body thin = depth::make_body(test::box({-.5, -.5, -.01}, {.5, .5, .01})),
                    block = depth::make_body(test::box({-2, -2, -2}, {2, 2, 2}));
  Placement pose;
  pose.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  pose.translation = {0, 0, .3};
  const double fast = answer_of(thin, block, pose, depth::Metric::object_norm, false).depth,
               careful = answer_of(thin, block, pose, depth::Metric::object_norm, true).depth;
  CHECK(fast < 1.7593);
  CHECK(careful <= fast);
}

TEST_CASE("a peg askew in its hole turns back instead of leaving", "[oracle]") {
  std::vector<std::array<double, 2>> circle;
  for (int i = 0; i < 48; ++i) circle.push_back({.45 * std::cos(i * test::pi / 24), .45 * std::sin(i * test::pi / 24)});
  const depth::Body peg = depth::make_body(test::prism(circle, -1.5, 1.5)),
                    hole = depth::make_body(test::revolved({{.5, -.4}, {1.5, -.4}, {1.5, .4}, {.5, .4}}, 48));
  Placement pose;
  pose.rotation = depth::rotation_of(8.926076 * test::pi / 180 * Vec3(-0.901597, -0.967702, 1.228235).normalized())
                      .toRotationMatrix();
  pose.translation = {-0.223135, 0.045332, -0.293460};
  CHECK(answer_of(peg, hole, pose, depth::Metric::displacement, false).depth < .253);
}

TEST_CASE("table of close fits", "[.][table]") {
  const int seeds = number("SEEDS", 8), first = number("FIRST", 0);
  const bool all = std::getenv("CAREFUL") != nullptr;
  for (int kind = number("KIND", 0); kind < number("KINDS", test::fit_kinds); ++kind)
    for (int seed = first; seed < first + seeds; ++seed) {
      const test::CloseFit fit = test::close_fit(kind, seed % 2 == 0, static_cast<std::uint64_t>(seed));
      const depth::Body a = depth::make_body(fit.a), b = depth::make_body(fit.b);
      const depth::RigidMotion back = depth::motion_between(fit.a_in_b, fit.fits, a.shape.centroid);
      fmt::print("{:6} {:3} {} c {:.3f} push {:.3f} tris {:5} {:5}", fit.name, seed, fit.straight ? "|" : "/",
                 fit.clearance, fit.push, fit.a.triangles.size(), fit.b.triangles.size());
      for (const depth::Metric metric : metrics) {
        fmt::print(" | back {:6.3f}:", depth::length_of(a.shape, metric, back));
        for (const bool careful : {false, true}) {
          if (careful && !all) continue;
          depth::Query query;
          query.a_in_b = fit.a_in_b;
          query.metric = metric;
          query.careful = careful;
          const double before = cpu_ms();
          const depth::Answer answer = depth::penetration_depth(a, b, query);
          fmt::print(" {:8.5f} >= {:.4f} ({:5.1f} ms)", answer.depth, answer.bound, cpu_ms() - before);
        }
      }
      fmt::print("\n");
      std::fflush(stdout);
    }
}
