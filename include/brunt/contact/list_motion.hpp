// SPDX-License-Identifier: Apache-2.0
// How far nodes and walls have moved since candidate lists were built. Which nodes and faces may touch is a matter of
// how they move against each other, so the motion that all have in common does not count: a body that flies alone, or
// one that drives another before it, uses up nothing by that. Bounds of the velocities tell for most steps that the
// lists hold; the nodes themselves are looked at where the bounds do not.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "brunt/core/types.hpp"

namespace brunt::contact {

/// Of all nodes of a rank, the largest vx, vy, vz, -vx, -vy, -vz [velocity] of v_{n-1/2}, then of v*. The maximum of
/// each over all ranks is that of all. Not finite where a velocity is not.
using VelocitySpan = std::array<double, 12>;
/// Nothing is known of the velocities.
VelocitySpan unbounded_velocities();

/// What the nodes themselves tell, likewise: the farthest from the middle [length], then the largest x, y, z, -x, -y,
/// -z of their motion so far [length].
using MotionSpan = std::array<double, 7>;

class ListMotion {
 public:
  /// Lists are built now, with the things that are `put` where they are.
  void start();
  /// One of the things that move, in an order that stays.
  void put(const Vec3& position) { start_.push_back(position); }
  [[nodiscard]] std::span<const Vec3> starts() const { return start_; }

  /// A step to come, of length dt; `last_dt`: of the one before, if that came after the lists. Both spans: of all
  /// ranks.
  void advance(const VelocitySpan& velocities, double last_dt, double dt);
  /// One of the things that `put` knows and the velocities do not: a wall.
  void advance_one(std::size_t thing, const Vec3& position, const Vec3& velocity, double dt);
  /// No thing is farther from the middle of all motions than this, up to the end of the step to come [length].
  [[nodiscard]] double bound() const { return 0.5 * (high_ - low_).norm(); }

  /// The same from the things themselves, which may come to less than the bound.
  class Sum {
   public:
    Sum(const ListMotion& motion, double dt) : motion_(motion), middle_(motion.middle()), dt_(dt) {}
    void add(std::size_t thing, const Vec3& position, const Vec3& velocity) {
      const Vec3 moved = position - motion_.start_[thing];
      low_ = low_.cwiseMin(moved);
      high_ = high_.cwiseMax(moved);
      keep((moved - middle_).squaredNorm());
      keep((moved + dt_ * velocity - middle_).squaredNorm());
    }
    [[nodiscard]] MotionSpan span() const;

   private:
    void keep(double square) {
      if (!(square <= farthest_square_)) keep_more(square);
    }
    void keep_more(double square);

    const ListMotion& motion_;
    Vec3 middle_;
    double dt_, farthest_square_ = 0;
    Vec3 low_ = Vec3::Constant(far_away), high_ = Vec3::Constant(-far_away);
  };
  /// What was found on all ranks, from which the next bounds go on.
  void correct(const MotionSpan& found);

 private:
  static constexpr double far_away = 1e300;
  [[nodiscard]] Vec3 middle() const;

  std::vector<Vec3> start_;
  Vec3 moved_low_ = Vec3::Zero(), moved_high_ = Vec3::Zero();  // a box around the motions up to now,
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();              // and up to the end of the step
};

}  // namespace brunt::contact
