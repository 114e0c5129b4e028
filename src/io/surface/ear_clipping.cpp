// SPDX-License-Identifier: Apache-2.0
// Ear clipping with a list of the concave corners (see the header).
//
// Only corners that are not convex can lie in an ear first: of all corners inside, the one nearest to its tip is
// concave. For the same reason a corner becomes an ear only when a neighbour has been clipped, so that each clipped
// corner costs two tests more, and a polygon of n corners at most 5 n tests against the concave ones.
#include "ear_clipping.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace brunt::io {
namespace {

/// Rounding of twice an area, over the square of the polygon's size: some tens of half a unit in the last place
/// (1e-16).
constexpr double area_rounding = 1e-14;
/// Sine of the angle at its tip below which an ear is thin. A corner on a straight side is rounded by less than this in
/// files of single precision (6e-8 of the coordinates) up to a thousand sizes from the origin.
constexpr double thin_ear = 1e-3;

std::size_t at(LocalIndex i) {
  return static_cast<std::size_t>(i);
}

Vec3 area_vector(std::span<const Vec3> corners) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    sum += (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]);
  return sum;
}

double size_squared(std::span<const Vec3> corners) {
  double size = 0;
  for (const Vec3& x : corners) size = std::max(size, (x - corners[0]).squaredNorm());
  return size;
}

bool has_area(const Vec3& area, double size) {
  return area.norm() > area_rounding * size;
}

void add_fan(LocalIndex count, std::vector<std::array<LocalIndex, 3>>& triangles) {
  for (LocalIndex k = 1; k + 1 < count; ++k) triangles.push_back({0, k, k + 1});
}

}  // namespace

double EarClipping::area(LocalIndex a, LocalIndex b, LocalIndex c) const {
  const Point &p = points_[at(a)], &q = points_[at(b)], &r = points_[at(c)];
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// Coordinates in the plane of the area vector; false where that is zero. A plane of two axes keeps them, unrounded.
bool EarClipping::project(std::span<const Vec3> corners) {
  const Vec3 area = area_vector(corners);
  const double size = size_squared(corners);
  if (!has_area(area, size)) return false;
  rounding_ = area_rounding * size;
  const Vec3 normal = area.normalized();
  Eigen::Index axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  const Vec3 first = normal.cross(Vec3::Unit(axis)).normalized();
  const Vec3 second = normal.cross(first);
  points_.clear();
  for (const Vec3& x : corners) points_.push_back({first.dot(x - corners[0]), second.dot(x - corners[0])});
  return true;
}

void EarClipping::start() {
  left_ = static_cast<LocalIndex>(points_.size());
  const std::size_t count = points_.size();
  previous_.resize(count);
  next_.resize(count);
  place_.assign(count, no_index);
  is_later_.assign(count, 0);
  is_left_.assign(count, 1);
  concave_.clear();
  later_.clear();
  tests_ = 0;
  allowed_ = tests_per_corner * count;
  for (LocalIndex i = 0; i < left_; ++i) {
    previous_[at(i)] = i == 0 ? left_ - 1 : i - 1;
    next_[at(i)] = i + 1 == left_ ? 0 : i + 1;
  }
  for (LocalIndex i = 0; i < left_; ++i)
    if (area(previous_[at(i)], i, next_[at(i)]) <= rounding_) {
      place_[at(i)] = static_cast<LocalIndex>(concave_.size());
      concave_.push_back(i);
    }
}

/// Sound and thin ears have an area, and no corner inside or on their sides; a degenerate one has no negative area and
/// no corner inside. Corners that coincide with those of the ear do not count: bridges to holes have such.
bool EarClipping::is_ear(LocalIndex corner, Ears kind) {
  const LocalIndex a = previous_[at(corner)], b = corner, c = next_[at(corner)];
  const Point p = points_[at(a)], q = points_[at(b)], r = points_[at(c)];
  const double doubled = area(a, b, c);
  if (doubled <= (kind == Ears::degenerate ? -rounding_ : rounding_)) return false;
  if (kind == Ears::sound) {
    const double sides = std::hypot(q.x - p.x, q.y - p.y) * std::hypot(r.x - q.x, r.y - q.y);
    if (doubled <= thin_ear * sides) return false;
  }
  const double margin = kind == Ears::degenerate ? rounding_ : -rounding_;
  const double low_x = std::min({p.x, q.x, r.x}), high_x = std::max({p.x, q.x, r.x});
  const double low_y = std::min({p.y, q.y, r.y}), high_y = std::max({p.y, q.y, r.y});
  for (const LocalIndex i : concave_) {
    ++tests_;
    const Point& x = points_[at(i)];
    if (x.x < low_x || x.x > high_x || x.y < low_y || x.y > high_y) continue;
    if (x == p || x == q || x == r) continue;
    if (area(a, b, i) >= margin && area(b, c, i) >= margin && area(c, a, i) >= margin) return false;
  }
  return true;
}

void EarClipping::remove_concave(LocalIndex corner) {
  const LocalIndex place = place_[at(corner)];
  if (place == no_index) return;
  concave_[at(place)] = concave_.back();
  place_[at(concave_.back())] = place;
  concave_.pop_back();
  place_[at(corner)] = no_index;
}

void EarClipping::retest(LocalIndex corner) {
  if (area(previous_[at(corner)], corner, next_[at(corner)]) > rounding_) remove_concave(corner);
  if (is_later_[at(corner)]) return;
  is_later_[at(corner)] = 1;
  later_.push_back(corner);
}

/// Clips ears of this kind while there are some; true when three corners are left.
bool EarClipping::clip(Ears kind, std::vector<std::array<LocalIndex, 3>>& triangles) {
  now_.clear();
  for (LocalIndex i = 0; i < static_cast<LocalIndex>(points_.size()); ++i)
    if (is_left_[at(i)]) now_.push_back(i);
  while (!now_.empty()) {
    for (const LocalIndex corner : now_) {
      if (left_ == 3) return true;
      if (!is_left_[at(corner)] || is_later_[at(corner)] || tests_ > allowed_ || !is_ear(corner, kind)) continue;
      const LocalIndex before = previous_[at(corner)], after = next_[at(corner)];
      triangles.push_back({before, corner, after});
      next_[at(before)] = after;
      previous_[at(after)] = before;
      is_left_[at(corner)] = 0;
      remove_concave(corner);
      --left_;
      retest(before);
      retest(after);
    }
    now_.swap(later_);
    later_.clear();
    for (const LocalIndex corner : now_) is_later_[at(corner)] = 0;
  }
  return left_ == 3;
}

Split EarClipping::split(std::span<const Vec3> corners, std::vector<std::array<LocalIndex, 3>>& triangles) {
  if (!project(corners)) {
    add_fan(static_cast<LocalIndex>(corners.size()), triangles);
    return Split::done;
  }
  start();
  const bool done = clip(Ears::sound, triangles) || clip(Ears::thin, triangles) || clip(Ears::degenerate, triangles);
  if (tests_ > allowed_) return Split::too_concave;
  if (!done) return Split::crosses_itself;
  const auto last = static_cast<LocalIndex>(std::ranges::find(is_left_, char{1}) - is_left_.begin());
  const LocalIndex before = previous_[at(last)], after = next_[at(last)];
  if (area(before, last, after) < -rounding_) return Split::crosses_itself;
  triangles.push_back({before, last, after});
  return Split::done;
}

Split split_quadrilateral(std::span<const Vec3, 4> x, std::vector<std::array<LocalIndex, 3>>& triangles) {
  const Vec3 area = area_vector(x);
  const double size = size_squared(x);
  if (!has_area(area, size)) {
    add_fan(4, triangles);
    return Split::done;
  }
  const Vec3 normal = area.normalized();
  const auto smaller_area = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    const double one = normal.dot((x[b] - x[a]).cross(x[c] - x[a])),
                 other = normal.dot((x[c] - x[a]).cross(x[d] - x[a]));
    return std::min(one, other);
  };
  const double along_02 = smaller_area(0, 1, 2, 3), along_13 = smaller_area(1, 2, 3, 0);
  const bool second_is_shorter = (x[3] - x[1]).squaredNorm() < (x[2] - x[0]).squaredNorm();
  for (const double smallest : {thin_ear * size, -area_rounding * size}) {
    const bool first = along_02 > smallest, second = along_13 > smallest;
    if (!first && !second) continue;
    if (second && (!first || second_is_shorter)) {
      triangles.push_back({0, 1, 3});
      triangles.push_back({1, 2, 3});
    } else {
      triangles.push_back({0, 1, 2});
      triangles.push_back({0, 2, 3});
    }
    return Split::done;
  }
  return Split::crosses_itself;
}

}  // namespace brunt::io
