// SPDX-License-Identifier: Apache-2.0
// Segments: crossings, and meetings of moving edges built backwards (case E3).
#include "geometry/segments.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "shots.hpp"

using brunt::Vec3;
using namespace brunt::geometry;
using namespace brunt::geometry::testing;

namespace {

constexpr double degree = 3.14159265358979323846 / 180;

double distance_to(const Vec3& x, const Segment& a) {
  const Vec3 p = a.end - a.start;
  const double s = p.squaredNorm() > 0 ? std::clamp((x - a.start).dot(p) / p.squaredNorm(), 0.0, 1.0) : 0.0;
  return (x - a.start - s * p).norm();
}

/// The distance to a segment is convex along another: ternary search.
double searched_distance(const Segment& a, const Segment& b) {
  double low = 0, high = 1;
  const auto at = [&](double s) { return distance_to((1 - s) * a.start + s * a.end, b); };
  for (int cut = 0; cut < 80; ++cut) {
    const double one = low + (high - low) / 3, two = high - (high - low) / 3;
    (at(one) < at(two) ? high : low) = at(one) < at(two) ? two : one;
  }
  return std::min({at(low), at(0), at(1)});
}

Segment random_segment(Random& random, double size) {
  return {random_vector(random, size), random_vector(random, size)};
}

Segment at_time(const MovingSegment& a, double tau) {
  return {(1 - tau) * a.start.start + tau * a.end.start, (1 - tau) * a.start.end + tau * a.end.end};
}

Vec3 along_segment(const Segment& a, double s) {
  return (1 - s) * a.start + s * a.end;
}

/// Two edges of length 2 that meet at (s, t, tau) with the given angle; a moves by `relative` against b.
struct Meeting {
  MovingSegment a, b;
};

Meeting meeting(Random& random, double angle, double s, double t, double tau, double turn, const Vec3& relative) {
  const brunt::Mat3 placed = random_rotation(random, 2.0);
  const Vec3 p = placed * Vec3(2, 0, 0), q = placed * Vec3(2 * std::cos(angle), 2 * std::sin(angle), 0);
  const Vec3 place = random_vector(random, 1), carried = random_vector(random, 1);
  const Vec3 p_rate = turn * random_vector(random, 1), q_rate = turn * random_vector(random, 1);
  const auto moving = [&](const Vec3& edge, const Vec3& rate, double share, const Vec3& motion) {
    const auto at = [&](double when) {
      const Vec3 centre = place + (when - tau) * motion, now = edge + (when - tau) * rate;
      return Segment{centre - share * now, centre + (1 - share) * now};
    };
    return MovingSegment{at(0), at(1)};
  };
  return {moving(p, p_rate, s, carried + placed * relative), moving(q, q_rate, t, carried)};
}

/// As seen along a x b.
std::optional<CommonPerpendicular> common_perpendicular(const Segment& a, const Segment& b, double kink = 0) {
  return crossing_along(a, b, (a.end - a.start).cross(b.end - b.start).normalized(), kink);
}

}  // namespace

TEST_CASE("where segments cross as seen along a direction: points that lie over each other, and how far apart") {
  const Segment x{{-1, 0, 0}, {1, 0, 0}}, oblique{{0.5, -1, -0.5}, {0.5, 1, 0.5}};  // rises along y
  const auto above = crossing_along(x, oblique, Vec3::UnitZ());
  REQUIRE(above);
  CHECK(above->s == Approx(0.75).epsilon(1e-15));
  CHECK(above->gap == Approx(0).margin(1e-15));
  const Vec3 slanted = Vec3(0.2, 0, 1).normalized();
  const auto seen = crossing_along({{-1, 0, 0.5}, {1, 0, 0.5}}, oblique, slanted);
  REQUIRE(seen);
  CHECK(seen->s == Approx(0.8).epsilon(1e-15));  // by 0.2 of the height farther
  CHECK(((seen->on_a - seen->on_b) - seen->gap * slanted).norm() < 1e-15);
  CHECK_FALSE(crossing_along(x, oblique, Vec3::UnitX()));  // seen along one of them
}

TEST_CASE("common perpendicular: points, normal and signed gap; none when it misses or the edges are parallel") {
  const Segment x{{-1, 0, 0}, {1, 0, 0}}, y{{0.5, -1, -0.25}, {0.5, 1, -0.25}};
  const auto found = common_perpendicular(x, y);
  REQUIRE(found);
  CHECK(found->s == Approx(0.75).epsilon(1e-15));
  CHECK(found->t == Approx(0.5).epsilon(1e-15));
  CHECK((found->normal - Vec3::UnitZ()).norm() < 1e-15);
  CHECK(found->gap == Approx(0.25).epsilon(1e-15));
  CHECK(((found->on_a - found->on_b) - found->gap * found->normal).norm() < 1e-15);

  CHECK_FALSE(common_perpendicular(x, {{1.1, -1, 1}, {1.1, 1, 1}}));
  CHECK_FALSE(common_perpendicular(x, {{0, 0, 1}, {1, 0.5e-6, 1}}));
  CHECK(common_perpendicular(x, {{-1, -2e-6, 1}, {1, 2e-6, 1}}));
  CHECK_FALSE(common_perpendicular(x, {{0, 1, 1}, {0, 1, 1}}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(common_perpendicular(x, {{nan, 1, 1}, {0, 1, 1}}));
  CHECK(common_perpendicular(x, {{1, -1, 1}, {1, 1, 1}}));  // at the very end

  const Segment past{{1.1, -1, 1}, {1.1, 1, 1}};  // by 0.1 at a gap of 1
  CHECK_FALSE(common_perpendicular(x, past, 0.09));
  const auto beyond = common_perpendicular(x, past, 0.11);
  REQUIRE(beyond);
  CHECK(beyond->s == 1);
  CHECK(beyond->t == Approx(0.5));
  CHECK(std::abs(beyond->gap) == Approx(1));
}

TEST_CASE("moving edges meet when they were built to: 90 degrees, 1 degree, any angle, near the ends") {
  struct Kind {
    double angle, turn, low, high, accuracy;
  };
  const Kind kind = GENERATE(Kind{90 * degree, 0.0, 0.001, 0.999, 1e-13}, Kind{degree, 0.0, 0.001, 0.999, 1e-12},
                             Kind{0, 0.5, 0.001, 0.999, 1e-11}, Kind{90 * degree, 0.1, 0, 0, 1e-12},
                             Kind{60 * degree, 0.1, 1, 1, 1e-12});
  Random random(4);
  int missed = 0, wrong_normal = 0, earlier = 0;
  double worst = 0, worst_place = 0;
  for (int i = 0; i < 10000; ++i) {
    const double angle = kind.angle > 0 ? kind.angle : between(random, 5 * degree, 175 * degree);
    const double s = between(random, kind.low, kind.high), t = between(random, kind.low, kind.high);
    const double tau = between(random, 0.001, 0.999);
    const Vec3 relative(between(random, -1, 1), between(random, -1, 1), (i % 2 ? 1 : -1) * between(random, 0.2, 3));
    const Meeting m = meeting(random, angle, s, t, tau, kind.turn, relative);
    const auto hit = edge_crossing(m.a, m.b);
    if (!hit) {
      ++missed;
      continue;
    }
    const Segment a = at_time(m.a, hit->tau), b = at_time(m.b, hit->tau);
    const Vec3 p = (a.end - a.start).normalized(), q = (b.end - b.start).normalized();
    const Vec3 velocity = along_segment(m.a.end, hit->s) - along_segment(m.a.start, hit->s) -
                          along_segment(m.b.end, hit->t) + along_segment(m.b.start, hit->t);
    const bool square = std::abs(hit->normal.dot(p)) + std::abs(hit->normal.dot(q)) < 1e-9;
    if (!square || !(velocity.dot(hit->normal) < 0) || std::abs(hit->normal.norm() - 1) > 1e-14) ++wrong_normal;
    if ((along_segment(a, hit->s) - along_segment(b, hit->t)).norm() > 1e-6 * 4) ++wrong_normal;
    if (hit->tau < tau - 1e-9) {
      ++earlier;
      continue;
    }
    worst = std::max(worst, std::abs(hit->tau - tau));
    worst_place = std::max({worst_place, std::abs(hit->s - s), std::abs(hit->t - t)});
  }
  CAPTURE(kind.angle, kind.turn, kind.low);
  CHECK(missed == 0);
  CHECK(wrong_normal == 0);
  CHECK(earlier < 500);
  CHECK(worst < kind.accuracy);
  CHECK(worst_place < 100 * kind.accuracy);
}

TEST_CASE("edges that miss, slide or stay parallel do not meet") {
  const Segment x{{-1, 0, 0}, {1, 0, 0}}, above{{-1, 0, 1}, {1, 0, 1}}, below{{-1, 0, -1}, {1, 0, -1}};
  const Segment y{{0, -1, 0}, {0, 1, 0}}, beside{{3, -1, 0}, {3, 1, 0}};
  CHECK_FALSE(edge_crossing({above, below}, {x, x}));                                        // parallel
  CHECK_FALSE(edge_crossing({{{-2, -1, 0}, {-2, 1, 0}}, beside}, {x, x}));                   // in one plane
  CHECK_FALSE(edge_crossing({{{3, -1, 1}, {3, 1, 1}}, {{3, -1, -1}, {3, 1, -1}}}, {x, x}));  // beside
  CHECK_FALSE(edge_crossing({above, {{-1, 0, 0.1}, {1, 0, 0.1}}}, {y, y}));                  // not far enough
  CHECK_FALSE(edge_crossing({{{0, 0, 1}, {0, 0, 1}}, {{0, 0, -1}, {0, 0, -1}}}, {x, x}));    // without length
  const auto hit = edge_crossing({above, below}, {y, y});
  REQUIRE(hit);
  CHECK(hit->tau == Approx(0.5).epsilon(1e-15));
  CHECK((hit->normal - Vec3::UnitZ()).norm() < 1e-15);
  CHECK(hit->point.norm() < 1e-15);
}

TEST_CASE("random moving edges that never come near each other do not meet, and those that meet do so in space") {
  Random random(8);
  int hits = 0, misses = 0, wrong = 0;
  for (int i = 0; i < 400; ++i) {
    const MovingSegment a{random_segment(random, 1), random_segment(random, 1)},
        b{random_segment(random, 1), random_segment(random, 1)};
    const auto hit = edge_crossing(a, b);
    constexpr int samples = 1000;
    double least = std::numeric_limits<double>::infinity(), fastest = 0;
    for (int k = 0; k <= samples; ++k)
      least = std::min(least, searched_distance(at_time(a, double(k) / samples), at_time(b, double(k) / samples)));
    for (const Vec3& motion : {Vec3(a.end.start - a.start.start), Vec3(a.end.end - a.start.end)})
      for (const Vec3& other : {Vec3(b.end.start - b.start.start), Vec3(b.end.end - b.start.end)})
        fastest = std::max(fastest, (motion - other).norm());
    if (hit && searched_distance(at_time(a, hit->tau), at_time(b, hit->tau)) > 1e-11) ++wrong;
    if (hit && least > fastest / samples) ++wrong;          // the samples say that they stay apart
    if (!hit && least < 1e-3 * fastest / samples) ++wrong;  // a miss cannot be as near as that
    ++(hit ? hits : misses);
  }
  CHECK(wrong == 0);
  CHECK(hits > 40);
  CHECK(misses > 40);
}
