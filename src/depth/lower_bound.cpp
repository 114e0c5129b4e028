// SPDX-License-Identifier: Apache-2.0
#include "brunt/depth/lower_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace brunt::depth {
namespace {

constexpr double mean_distance = 0.48030;  // of a cube's points from its middle, in sides: .480296, rounded up
constexpr std::size_t balls_tried = 200;   // of each body, the greatest first
constexpr std::size_t ascents = 3;         // from so many of the best points
constexpr int ascent_steps = 25;
constexpr double first_step = 0.5, longer = 1.2, shorter = 0.5;  // of the steps' length, in units of the depth

/// A point with its depths in both bodies.
struct Seen {
  Vec3 y = Vec3::Zero();
  Vec3 up = Vec3::Zero();  // sum of the depths' gradients
  double sum = 0;          // phi_A + phi_B, and what is to be left between them
  double value = 0;        // the bound
};

struct Bound {
  const Encounter& encounter;
  Metric metric;

  [[nodiscard]] double value_of(double sum, const Vec3& in_a) const {
    if (metric != Metric::object_norm || !(sum > 0)) return sum;
    return sum / std::sqrt(point_factor(encounter.a.shape.gyration, in_a - encounter.a.shape.centroid));
  }

  [[nodiscard]] Seen look(const Vec3& y) const {
    const Vec3 in_a = encounter.start.back(y);
    const geometry::PointDepth a = point_depth(encounter.a.tree, in_a), b = point_depth(encounter.b.tree, y);
    const auto gradient = [](const Vec3& x, const geometry::PointDepth& d) {
      const Vec3 away = x - d.nearest;
      const double length = away.norm();
      return length > 0 ? Vec3(away * ((d.depth > 0 ? 1 : -1) / length)) : Vec3(Vec3::Zero());
    };
    Seen seen;
    seen.y = y;
    seen.sum = a.depth + b.depth + encounter.apart;
    seen.up = encounter.start.rotation * gradient(in_a, a) + gradient(y, b);
    seen.value = value_of(seen.sum, in_a);
    return seen;
  }

  [[nodiscard]] Seen ascend(Seen seen) const {
    double step = first_step * std::max(seen.sum, 0.05 * encounter.a.shape.radius);
    for (int i = 0; i < ascent_steps; ++i) {
      if (!(seen.up.norm() > 1e-6)) break;
      const Seen next = look(seen.y + step * seen.up.normalized());
      if (next.value > seen.value) {
        seen = next;
        step *= longer;
      } else {
        step *= shorter;
      }
    }
    return seen;
  }
};

/// The root of a lower sum of (1/V) integral over A of max(0, phi_A + phi_B)^2. Depths change by no more than the
/// distance, and the square is convex: its mean over a cell is no less than that of the mean (Jensen).
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

}  // namespace

LowerBound lower_bound(const Encounter& encounter, Metric metric) {
  const Bound bound{encounter, metric};
  struct Candidate {
    double value;
    Vec3 y;
  };
  std::array<Candidate, ascents> best;
  best.fill({-std::numeric_limits<double>::infinity(), Vec3::Zero()});
  const auto offer = [&](double value, const Vec3& y) {
    if (!(value > best.back().value)) return;
    best.back() = {value, y};
    for (std::size_t k = best.size() - 1; k > 0 && best[k].value > best[k - 1].value; --k)
      std::swap(best[k], best[k - 1]);
  };
  const auto &balls_a = encounter.a.balls, &balls_b = encounter.b.balls;
  const bool norm = metric == Metric::object_norm;
  for (std::size_t i = 0; i < std::min(balls_tried, balls_a.size()); ++i) {
    const InnerBall& ball = balls_a[i];
    const double scale = norm ? std::sqrt(ball.factor) : 1;
    const Vec3 y = encounter.start(ball.centre);
    const double needed = best.back().value * scale - ball.depth;
    const double depth = depth_above(encounter.b.tree, y, needed);
    if (depth > needed) offer((ball.depth + depth) / scale, y);
  }
  for (std::size_t i = 0; i < std::min(balls_tried, balls_b.size()); ++i) {
    const InnerBall& ball = balls_b[i];
    const Vec3 in_a = encounter.start.back(ball.centre);
    const double needed = best.back().value - ball.depth;  // the factor is at least 1
    const double depth = depth_above(encounter.a.tree, in_a, needed);
    if (depth > needed) offer(bound.value_of(ball.depth + depth, in_a), ball.centre);
  }
  LowerBound result;
  for (const Candidate& candidate : best) {
    if (!std::isfinite(candidate.value)) continue;
    const Seen top = bound.ascend(bound.look(candidate.y));
    if (top.value > result.value) result = {top.value, top.y};
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
