// SPDX-License-Identifier: Apache-2.0
#include "brunt/depth/cover.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "brunt/depth/convex_pair.hpp"

namespace brunt::depth {
namespace {

constexpr std::size_t batch = 512;       // boxes judged together: the same on any number of ranks
constexpr std::int32_t balls_used = 80;  // of A, the greatest
constexpr double sqrt3 = std::numbers::sqrt3;
constexpr double safety = 1e-9;  // of A's radius: rounding of depths and lengths

double chord(double half_turn) {
  return 2 * std::sin(0.5 * std::min(sqrt3 * half_turn, std::numbers::pi));
}

double motion_inside(const CoverBox& box, double arm) {
  return sqrt3 * box.half_shift + chord(box.half_turn) * arm;
}

/// The greatest length of a motion from the middle to a placement in the box.
double radius_of(const MetricShape& shape, Metric metric, double widest, const CoverBox& box) {
  if (metric != Metric::object_norm) return motion_inside(box, shape.radius);
  return std::hypot(sqrt3 * box.half_shift, chord(box.half_turn) * widest);
}

/// Piece pairs first, then balls.
struct Proofs {
  const Encounter& encounter;
  Placement now;
  const CoverBox& box;
  std::int32_t pairs, balls;

  Proofs(const Encounter& e, const CoverBox& b)
      : encounter(e),
        now(e.placement(b.middle())),
        box(b),
        pairs(static_cast<std::int32_t>(e.a.pieces.size() * e.b.pieces.size())),
        balls(std::min(balls_used, static_cast<std::int32_t>(e.a.balls.size()))) {}

  [[nodiscard]] std::int32_t count() const { return pairs + balls; }

  /// Depth beyond the motion inside the box: positive is a proof. Not exact where no greater than `least`.
  [[nodiscard]] double excess(std::int32_t i, double least) const {
    const double less = safety * encounter.a.shape.radius - encounter.apart;
    if (i < pairs) {
      const std::size_t a = static_cast<std::size_t>(i) / encounter.b.pieces.size(),
                        b = static_cast<std::size_t>(i) % encounter.b.pieces.size();
      const double motion = motion_inside(box, encounter.a.piece_reach[a]) + less;
      return translation_depth(encounter.a.pieces[a], encounter.b.pieces[b], now, least + motion) - motion;
    }
    const InnerBall& ball = encounter.a.balls[static_cast<std::size_t>(i - pairs)];
    const double motion = motion_inside(box, (ball.centre - encounter.a.shape.centroid).norm()) + less - ball.depth;
    return depth_above(encounter.b.tree, now(ball.centre), least + motion) - motion;
  }
};

bool longer(const CoverBox& x, const CoverBox& y) {
  return x.least > y.least;
}

}  // namespace

CoverVerdict judge(const Encounter& encounter, Metric metric, double upper, const CoverBox& box) {
  const Proofs proofs(encounter, box);
  CoverVerdict verdict;
  verdict.length = length_of(encounter.a.shape, metric, box.middle());
  double best = -std::numeric_limits<double>::infinity();
  for (std::int32_t k = -1; k < proofs.count(); ++k) {
    const std::int32_t i = k < 0 ? box.hint : k;
    if (k == box.hint || i >= proofs.count()) continue;
    const double excess = proofs.excess(i, std::min(best, 0.0));
    if (excess > best) {
      best = excess;
      verdict.hint = i;
    }
    if (best > 0) {
      verdict.collides = true;
      return verdict;
    }
  }
  verdict.free = verdict.length < upper && !encounter.bodies_collide(proofs.now);
  return verdict;
}

CoverResult cover(const Encounter& encounter, double upper, const CoverOptions& options,
                  const std::function<double(const RigidMotion&)>& improve) {
  const MetricShape& shape = encounter.a.shape;
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(shape.gyration, Eigen::EigenvaluesOnly);
  const double widest = std::sqrt(axes.eigenvalues()[2]), slimmest = std::sqrt(axes.eigenvalues()[0]);
  const auto evaluate = [&](std::span<const CoverBox> boxes, std::span<CoverVerdict> verdicts) {
    if (options.evaluate) return options.evaluate(boxes, upper, verdicts);
    for (std::size_t i = 0; i < boxes.size(); ++i) verdicts[i] = judge(encounter, options.metric, upper, boxes[i]);
  };
  CoverBox root;
  root.half_shift = upper;
  if (options.metric != Metric::translation)  // rms >= 2 sin(phi/2) sqrt(least moment)
    root.half_turn = std::min(std::numbers::pi, 2 * std::asin(std::min(1.0, 0.5 * upper / slimmest)) * (1 + 1e-12));
  root.least = options.known;
  std::vector<CoverBox> heap{root}, now;
  std::vector<CoverVerdict> verdicts;
  CoverResult result{options.known, upper, 0, false};
  while (!heap.empty() && result.boxes < options.most_boxes && !(options.stop && options.stop())) {
    now.clear();
    while (!heap.empty() && now.size() < batch) {
      std::pop_heap(heap.begin(), heap.end(), longer);
      if (heap.back().least < upper) now.push_back(heap.back());
      heap.pop_back();
    }
    if (now.empty()) break;
    result.bound = std::max(result.bound, now.front().least);
    if (result.bound >= (1 - options.gap) * upper) {
      result.reached = true;
      break;
    }
    verdicts.assign(now.size(), {});
    evaluate(now, verdicts);
    result.boxes += static_cast<std::int64_t>(now.size());
    std::size_t best = now.size();
    for (std::size_t i = 0; i < now.size(); ++i) {
      const CoverBox& box = now[i];
      if (verdicts[i].free && verdicts[i].length < upper &&
          (best == now.size() || verdicts[i].length < verdicts[best].length))
        best = i;
      if (verdicts[i].collides) continue;
      const bool cut_turn = chord(box.half_turn) * shape.radius > sqrt3 * box.half_shift;
      CoverBox child = box;
      child.hint = verdicts[i].hint;
      (cut_turn ? child.half_turn : child.half_shift) *= 0.5;
      const double half = cut_turn ? child.half_turn : child.half_shift;
      const double radius = radius_of(shape, options.metric, widest, child);
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 off = half * Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        child.turn = box.turn + (cut_turn ? off : Vec3(Vec3::Zero()));
        child.shift = box.shift + (cut_turn ? Vec3(Vec3::Zero()) : off);
        if (child.turn.norm() - sqrt3 * child.half_turn > std::numbers::pi) continue;  // the same as others
        const double least = length_of(shape, options.metric, child.middle()) - radius;
        child.least = std::max(box.least, least - safety * shape.radius);
        if (child.least >= upper) continue;
        heap.push_back(child);
        std::push_heap(heap.begin(), heap.end(), longer);
      }
    }
    if (best < now.size()) upper = std::min(upper, improve(now[best].middle()));
  }
  if (heap.empty()) {  // nothing shorter is left
    result.bound = upper;
    result.reached = true;
  }
  result.upper = upper;
  return result;
}

}  // namespace brunt::depth
