// SPDX-License-Identifier: Apache-2.0
#include "depth/cover.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "depth/convex_pair.hpp"

namespace brunt::depth {
namespace {

constexpr std::size_t batch = 512;       // boxes tested together: the same on any number of ranks
constexpr std::int32_t balls_used = 80;  // the largest balls of A
constexpr double sqrt3 = std::numbers::sqrt3;
constexpr double slimmest_box = 2;  // half widths of translation: largest ratio before other axes are cut
constexpr double safety = 1e-9;     // of A's radius: rounding of depths and lengths

double chord(double half_turn) {
  return 2 * std::sin(0.5 * std::min(sqrt3 * half_turn, std::numbers::pi));
}

/// Lower bound of the length of a motion in the box.
double least_length(const MetricShape& shape, Metric metric, double widest, const CoverBox& box) {
  const auto nearest = [&](const Vec3& d) { return (d.cwiseAbs() - box.half_shift).cwiseMax(0).norm(); };
  const double turning = chord(box.half_turn);
  const Eigen::Quaterniond turn = rotation_of(box.turn);
  if (metric == Metric::translation) return nearest(box.shift);
  if (metric == Metric::object_norm)
    return std::hypot(nearest(box.shift),
                      std::max(0.0, 2 * std::sqrt(turn.vec().dot(shape.gyration * turn.vec())) - turning * widest));
  const Mat3 D = rotation_less_identity(turn);
  double least = 0;
  for (const Vec3& y : shape.extremes) least = std::max(least, nearest(box.shift + D * y) - turning * y.norm());
  return least;
}

/// A proof that all placements in a box collide, by a positive `excess`; and its largest loss.
struct Proof {
  double excess = -std::numeric_limits<double>::infinity();  ///< depth beyond the motion inside the box [length]
  std::int32_t cut = 0;
};

constexpr std::int32_t along_rotation = 3;  ///< as CoverVerdict::cut

/// shifts: the loss of a proof by the half widths. Its own rotational part cannot be used: that of a ball near the
/// centroid is small, although the box may be too large in rotations.
std::int32_t best_cut(const MetricShape& shape, const CoverBox& box, const Vec3& shifts) {
  if (chord(box.half_turn) * shape.radius > shifts.sum()) return along_rotation;
  Eigen::Index axis = 0, widest = 0;
  shifts.maxCoeff(&axis);
  const double most = box.half_shift.maxCoeff(&widest);
  return static_cast<std::int32_t>(most > slimmest_box * box.half_shift[axis] ? widest : axis);
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

  /// Not exact if the result does not exceed `least`.
  [[nodiscard]] Proof proof(std::int32_t i, double least) const {
    return i < pairs ? of_pieces(static_cast<std::size_t>(i), least)
                     : of_ball(static_cast<std::size_t>(i - pairs), least);
  }

 private:
  /// Required excess beyond the motion inside the box: surfaces nearer than `apart` count as colliding.
  [[nodiscard]] double less() const { return safety * encounter.a.shape.radius - encounter.apart; }

  [[nodiscard]] Proof of_pieces(std::size_t i, double least) const {
    const std::size_t a = i / encounter.b.pieces.size(), b = i % encounter.b.pieces.size();
    const double turning = chord(box.half_turn) * encounter.a.piece_reach[a];
    const double motion = turning + less();
    const Mat3 shifts = encounter.start.rotation * box.half_shift.asDiagonal();
    const Narrowest narrowest =
        narrowest_overlap(encounter.a.pieces[a], encounter.b.pieces[b], now, shifts, least + motion);
    const double shell = narrowest.depth > 0 ? 0 : encounter.apart;  // disjoint pieces: an axis gives no distance
    return {narrowest.depth - motion - shell,
            best_cut(encounter.a.shape, box, (shifts.transpose() * narrowest.axis).cwiseAbs())};
  }

  [[nodiscard]] Proof of_ball(std::size_t i, double least) const {
    const InnerBall& ball = encounter.a.balls[i];
    const double turning = chord(box.half_turn) * (ball.centre - encounter.a.shape.centroid).norm();
    const double motion = box.half_shift.norm() + turning + less() - ball.depth;
    return {depth_above(encounter.b.tree, now(ball.centre), least + motion) - motion,
            best_cut(encounter.a.shape, box, box.half_shift)};
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
    const Proof proof = proofs.proof(i, std::min(best, 0.0));
    if (proof.excess > best) {
      best = proof.excess;
      verdict.hint = i;
      verdict.cut = proof.cut;
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
  root.half_shift.setConstant(upper);
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
      CoverBox child = box;
      child.hint = verdicts[i].hint;
      const std::int32_t axis = verdicts[i].cut;
      const bool cut_turn = axis == along_rotation;
      const double half = 0.5 * (cut_turn ? box.half_turn : box.half_shift[axis]);
      (cut_turn ? child.half_turn : child.half_shift[axis]) = half;
      for (int part = 0; part < (cut_turn ? 8 : 2); ++part) {
        if (cut_turn)
          child.turn = box.turn + half * Vec3(part & 1 ? 1 : -1, part & 2 ? 1 : -1, part & 4 ? 1 : -1);
        else
          child.shift[axis] = box.shift[axis] + (part == 0 ? -half : half);
        if (child.turn.norm() - sqrt3 * child.half_turn > std::numbers::pi) continue;  // equivalent to others
        const double least = least_length(shape, options.metric, widest, child);
        child.least = std::max(box.least, least - safety * shape.radius);
        if (child.least >= upper) continue;
        heap.push_back(child);
        std::push_heap(heap.begin(), heap.end(), longer);
      }
    }
    if (best < now.size()) upper = std::min(upper, improve(now[best].middle()));
  }
  if (heap.empty()) {  // no shorter motion remains
    result.bound = upper;
    result.reached = true;
  }
  result.upper = upper;
  return result;
}

}  // namespace brunt::depth
