// SPDX-License-Identifier: Apache-2.0
// Motion of nodes and walls since the candidate lists were built. Possible contacts depend on relative motion, so the
// common motion does not count: a body in free flight, or bodies that move together, do not use up the lists. In most
// steps, bounds of the velocities prove that the lists are valid; otherwise the nodes themselves are examined.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace brunt::contact {

/// Over all nodes of a rank, the largest vx, vy, vz, -vx, -vy, -vz [velocity] of v_{n-1/2}, then of v*. The values of
/// all ranks are the maxima of each. Not finite if a velocity is not.
using VelocitySpan = std::array<double, 12>;

/// The corresponding values from the nodes themselves: the largest distance from the centre [length], then the largest
/// x, y, z, -x, -y, -z of their motion so far [length].
using MotionSpan = std::array<double, 7>;

class ListMotion {
 public:
  /// Starts a new list, with the objects given to `put` at their positions.
  void start();
  /// Adds one of the moving objects, in a fixed order.
  void put(const Vec3& position) { start_.push_back(position); }
  [[nodiscard]] std::span<const Vec3> starts() const { return start_; }

  /// The coming step, of length dt; `last_dt`: of the previous one, if it followed the creation of the lists. Both
  /// spans: of all ranks.
  void advance(const VelocitySpan& velocities, double last_dt, double dt);
  /// A moving object given to `put` that the velocities do not include: a wall.
  void advance_one(std::size_t thing, const Vec3& position, const Vec3& velocity, double dt);
  /// Upper bound of the distance of every object from the centre of all motions, up to the end of the coming step
  /// [length].
  [[nodiscard]] double bound() const { return 0.5 * (high_ - low_).norm(); }

  /// The same from the objects themselves, which may be less than the bound.
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
  /// The result on all ranks, from which the next bounds continue.
  void correct(const MotionSpan& found);

 private:
  static constexpr double far_away = 1e300;
  [[nodiscard]] Vec3 middle() const;

  std::vector<Vec3> start_;
  Vec3 moved_low_ = Vec3::Zero(), moved_high_ = Vec3::Zero();  // a box around the motions up to now,
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();              // and up to the end of the step
};

}  // namespace brunt::contact
