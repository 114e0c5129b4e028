// SPDX-License-Identifier: Apache-2.0
#include "outline.hpp"

#include <algorithm>
#include <cmath>

namespace brunt::mesh {

Outline::Outline(const Nose& nose, double radius, double inner)
    : shape_(nose.shape), radius_(radius), end_(std::max(nose.tip_radius, inner)) {
  if (shape_ == Nose::Shape::cone) {
    height_ = nose.length * (radius - end_) / (radius - nose.tip_radius);
    return;
  }
  arc_ = shape_ == Nose::Shape::ogive ? 2 * nose.crh * radius : radius;
  opening_ = std::acos(std::clamp(1 - (radius - end_) / arc_, -1.0, 1.0));
}

std::array<double, 2> Outline::at(double share) const {
  const double angle = opening_ * share;
  if (shape_ == Nose::Shape::cone) return {radius_ + (end_ - radius_) * share, height_ * share};
  if (share == 1) return {end_, arc_ * std::sin(angle)};
  return {radius_ - arc_ * (1 - std::cos(angle)), arc_ * std::sin(angle)};
}

double Outline::length() const {
  return shape_ == Nose::Shape::cone ? std::hypot(radius_ - end_, height_) : arc_ * opening_;
}

}  // namespace brunt::mesh
