// SPDX-License-Identifier: Apache-2.0
// Points projected along a direction: whether a body that moves in this direction meets one of them.
#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace brunt::setup {

class FlightShadow {
 public:
  /// way: direction of motion, of any length; zero: points are compared at their positions.
  FlightShadow(const Vec3& way, const std::vector<Vec3>& points)
      : direction_(way.norm() > 0 ? way.normalized() : Vec3::Zero()) {
    points_.reserve(points.size());
    for (const Vec3& point : points) points_.push_back(keyed(point));
    std::ranges::sort(points_, {}, &Keyed::key);
  }

  /// Whether the path of this point passes one of the points at a distance below `within` [length].
  [[nodiscard]] bool passes_by(const Vec3& point, double within) const {
    const Keyed wanted = keyed(point);
    auto one = std::ranges::lower_bound(points_, wanted.key - within, {}, &Keyed::key);
    for (; one != points_.end() && one->key <= wanted.key + within; ++one)
      if ((one->place - wanted.place).norm() < within) return true;
    return false;
  }

 private:
  struct Keyed {
    double key;
    Vec3 place;
  };
  [[nodiscard]] Keyed keyed(const Vec3& point) const {
    static const Vec3 askew = Vec3(0.81, 0.47, 0.35).normalized();  // few nodes of a mesh lie in a plane normal to it
    const Vec3 place = point - direction_.dot(point) * direction_;
    return {askew.dot(place), place};
  }

  Vec3 direction_;
  std::vector<Keyed> points_;
};

}  // namespace brunt::setup
