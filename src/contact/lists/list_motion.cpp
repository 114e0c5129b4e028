// SPDX-License-Identifier: Apache-2.0
#include "contact/lists/list_motion.hpp"

#include <cmath>
#include <limits>

namespace brunt::contact {

void ListMotion::start() {
  start_.clear();
  moved_low_ = moved_high_ = low_ = high_ = Vec3::Zero();
}

void ListMotion::advance(const VelocitySpan& velocities, double last_dt, double dt) {
  const Vec3 high_before(&velocities[0]), low_before = -Vec3(&velocities[3]);
  const Vec3 high_after(&velocities[6]), low_after = -Vec3(&velocities[9]);
  moved_low_ += last_dt * low_before;
  moved_high_ += last_dt * high_before;
  low_ = moved_low_.cwiseMin(moved_low_ + dt * low_after);
  high_ = moved_high_.cwiseMax(moved_high_ + dt * high_after);
}

void ListMotion::advance_one(std::size_t thing, const Vec3& position, const Vec3& velocity, double dt) {
  const Vec3 moved = position - start_[thing], then = moved + dt * velocity;
  low_ = low_.cwiseMin(moved.cwiseMin(then));
  high_ = high_.cwiseMax(moved.cwiseMax(then));
}

MotionSpan ListMotion::Sum::span() const {
  return {std::sqrt(farthest_square_), high_[0], high_[1], high_[2], -low_[0], -low_[1], -low_[2]};
}

/// What is not a number must not be lost: it compares false with everything.
void ListMotion::Sum::keep_more(double square) {
  farthest_square_ = std::isnan(square) ? std::numeric_limits<double>::infinity() : square;
}

void ListMotion::correct(const MotionSpan& found) {
  moved_high_ = Vec3(&found[1]);
  moved_low_ = -Vec3(&found[4]);
}

/// Where the bounds are not finite, any point serves that is the same on all ranks.
Vec3 ListMotion::middle() const {
  const Vec3 middle = 0.5 * (low_ + high_);
  return middle.allFinite() ? middle : Vec3(Vec3::Zero());
}

}  // namespace brunt::contact
