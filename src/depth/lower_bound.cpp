// SPDX-License-Identifier: Apache-2.0
#include "depth/lower_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "depth_ascent.hpp"

namespace brunt::depth {
namespace {

constexpr double mean_distance = 0.48030;  // of a cube's points from its centre, in sides: .480296, rounded up
constexpr std::size_t balls_tried = 200;   // of each body, the largest ones
constexpr std::size_t most_ascents = thorough_bound.ascents;
constexpr double start_spacing = 0.1;  // of the smaller radius: nearer points ascend to the same maximum

/// The root of a lower sum of (1/V) integral over A of max(0, phi_A + phi_B)^2. Depths change by at most the distance,
/// and the square is convex, so its mean over a cell is at least the square of the mean (Jensen).
double volume_bound(const Encounter& encounter) {
  const InnerCells& cells = encounter.a.cells;
  const double loss = 2 * mean_distance * cells.side;
  double sum = 0;
  for (std::size_t i = 0; i < cells.centres.size(); ++i) {
    const double needed = loss - cells.depths[i] - encounter.apart;
    const double depth = depth_above(encounter.b.tree, encounter.start(cells.centres[i]), needed);
    if (depth > needed) sum += (depth - needed) * (depth - needed);
  }
  return std::sqrt(sum * cells.side * cells.side * cells.side / encounter.a.mass.mass);
}

struct Candidate {
  double value;
  Vec3 y;
};

/// The best candidates with distances of at least `spacing`: nearer ones ascend to the same maximum.
struct Candidates {
  std::array<Candidate, most_ascents> list;  // the best first
  double spacing;

  explicit Candidates(double d) : spacing(d) { list.fill({-std::numeric_limits<double>::infinity(), Vec3::Zero()}); }

  [[nodiscard]] double least() const { return list.back().value; }
  void offer(double value, const Vec3& y) {
    if (!(value > least())) return;
    std::size_t k = list.size() - 1;
    for (std::size_t i = 0; i < list.size(); ++i)
      if (std::isfinite(list[i].value) && (list[i].y - y).norm() < spacing) {
        if (!(value > list[i].value)) return;
        k = i;
        break;
      }
    list[k] = {value, y};
    for (; k > 0 && list[k].value > list[k - 1].value; --k) std::swap(list[k], list[k - 1]);
  }
};

void offer_balls(const Encounter& encounter, bool norm, const DepthAscent& ascent, Candidates& best) {
  const auto &balls_a = encounter.a.balls, &balls_b = encounter.b.balls;
  for (std::size_t i = 0; i < std::min(balls_tried, balls_a.size()); ++i) {
    const InnerBall& ball = balls_a[i];
    const double scale = norm ? std::sqrt(ball.factor) : 1;
    const Vec3 y = encounter.start(ball.centre);
    const double needed = best.least() * scale - ball.depth;
    const double depth = depth_above(encounter.b.tree, y, needed);
    if (depth > needed) best.offer((ball.depth + depth) / scale, y);
  }
  for (std::size_t i = 0; i < std::min(balls_tried, balls_b.size()); ++i) {
    const InnerBall& ball = balls_b[i];
    const Vec3 in_a = encounter.start.back(ball.centre);
    const double largest = norm && best.least() < 0 ? encounter.a.shape.ratio : 1;  // scales are between 1 and this
    const double needed = best.least() * largest - ball.depth;
    const double depth = depth_above(encounter.a.tree, in_a, needed);
    if (depth > needed) best.offer((ball.depth + depth) / ascent.scale_of(in_a), ball.centre);
  }
}

/// Vertices of each surface inside the other body: a shallow overlap may lie far from all balls.
void offer_outposts(const Encounter& encounter, const DepthAscent& ascent, Candidates& best) {
  const auto depth_in = [&](const Body& body, const Vec3& x) {
    return geometry::contains(body.tree.box, x) ? depth_above(body.tree, x, std::max(0.0, best.least())) : 0.0;
  };
  const Body &a = encounter.a, &b = encounter.b;
  for (const Vec3& in_a : a.outposts) {
    const Vec3 y = encounter.start(in_a);
    if (const double depth = depth_in(b, y); depth > 0) best.offer(depth / ascent.scale_of(in_a), y);
  }
  for (const Vec3& y : b.outposts) {
    const Vec3 in_a = encounter.start.back(y);
    if (const double depth = depth_in(a, in_a); depth > 0) best.offer(depth / ascent.scale_of(in_a), y);
  }
}

}  // namespace

LowerBound lower_bound(const Encounter& encounter, Metric metric, const BoundEffort& effort) {
  DepthAscent ascent(encounter, metric);
  const bool norm = metric == Metric::object_norm;
  Candidates best(start_spacing * std::min(encounter.a.shape.radius, encounter.b.shape.radius));
  offer_balls(encounter, norm, ascent, best);
  offer_outposts(encounter, ascent, best);
  SeenPoint top;
  for (std::size_t k = 0; k < std::min(effort.ascents, best.list.size()); ++k) {
    if (!std::isfinite(best.list[k].value)) continue;
    const SeenPoint here = ascent.climb(ascent.look(best.list[k].y), effort.looks);
    if (here.value > top.value) top = here;
  }
  LowerBound result;
  if (top.value > 0) {
    top = ascent.climb(top, effort.more_looks);
    result = {top.value, top.y};
  }
  if (norm) result.value = std::max(result.value, volume_bound(encounter));
  if (!norm)
    for (const ConvexPiece& a : encounter.a.pieces)
      for (const ConvexPiece& b : encounter.b.pieces)
        if (const double depth = translation_depth(a, b, encounter.start, result.value - encounter.apart); depth > 0)
          result.value = std::max(result.value, encounter.apart + depth);
  return result;
}

}  // namespace brunt::depth
