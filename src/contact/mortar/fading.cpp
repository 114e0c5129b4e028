// SPDX-License-Identifier: Apache-2.0
#include "fading.hpp"

#include "normal_change.hpp"

namespace brunt::contact {

namespace {

using Slopes = SegmentSlopes::Slopes;

struct Share {
  double value = 1, slope = 0;
};

/// A cubic from 0 to 1, with zero derivative at both ends.
Share cubic(double from, double to, double x) {
  const double s = (x - from) / (to - from);
  if (s >= 1) return {1, 0};
  if (s <= 0) return {0, 0};
  return {s * s * (3 - 2 * s), 6 * s * (1 - s) / (to - from)};
}

struct Corners {
  std::array<Vec3, 4> of;
  std::size_t count;

  explicit Corners(const SlavePlane& plane) : count(static_cast<std::size_t>(plane.corners)) {
    for (std::size_t a = 0; a < count; ++a)
      of[a] = plane.centre + plane.point[a].x * plane.first + plane.point[a].y * plane.second +
              plane.height[a] * plane.normal;
  }
  [[nodiscard]] FacetCorners span() const { return {of.data(), count}; }
};

void add(const Vec3& slope, std::size_t corner, Slopes& to) {
  for (std::size_t i = 0; i < 3; ++i) to[3 * corner + i] += slope[static_cast<Eigen::Index>(i)];
}

/// Derivative of the product of the unit normals, times `factor`.
void add_facing(const NormalChange& slave, std::size_t corners, const NormalChange& master, std::size_t master_corners,
                double factor, Slopes& to) {
  for (std::size_t a = 0; a < corners; ++a) add(factor * slave.by_corner(a).transpose() * master.normal(), a, to);
  for (std::size_t c = 0; c < master_corners; ++c)
    add(factor * master.by_corner(c).transpose() * slave.normal(), 4 + c, to);
}

/// Derivative of the mean distance, times `factor`.
void add_distance(const SlavePlane& plane, const Corners& corners, const NormalChange& slave, FacetCorners master,
                  const SegmentIntegrals& integrals, const SegmentSlopes& slopes, double factor, Slopes& to) {
  const double over = factor / integrals.area;
  Vec3 turned = Vec3::Zero();  // sum of weights times places
  const auto take = [&](std::size_t corner, const Vec3& x, double weight, const Slopes& of_weight) {
    const double height = plane.normal.dot(x - plane.centre);
    for (std::size_t d = 0; d < to.size(); ++d) to[d] += over * height * of_weight[d];
    add(over * weight * plane.normal, corner, to);
    turned += weight * (x - plane.centre);
  };
  Slopes area{};
  for (std::size_t a = 0; a < corners.count; ++a) {
    Slopes of_share{};
    for (std::size_t b = 0; b < corners.count; ++b)
      for (std::size_t d = 0; d < to.size(); ++d) of_share[d] -= slopes.slave[SegmentSlopes::pair_of_corners(a, b)][d];
    for (std::size_t d = 0; d < to.size(); ++d) area[d] -= of_share[d];
    take(a, corners.of[a], -integrals.share[a], of_share);
  }
  for (std::size_t c = 0; c < master.size(); ++c) {
    Slopes of_weight{};
    double weight = 0;
    for (std::size_t a = 0; a < corners.count; ++a) {
      weight += integrals.master[a][c];
      for (std::size_t d = 0; d < to.size(); ++d) of_weight[d] += slopes.master[a][c][d];
    }
    take(4 + c, master[c], weight, of_weight);
  }
  for (std::size_t a = 0; a < corners.count; ++a) add(over * slave.by_corner(a).transpose() * turned, a, to);
  for (std::size_t d = 0; d < to.size(); ++d) to[d] -= over * integrals.distance * area[d];
}

void scale(double share, const Slopes& of_share, SegmentIntegrals& integrals, SegmentSlopes* slopes) {
  const auto one = [&](double& value, Slopes* slope) {
    if (slope != nullptr)
      for (std::size_t d = 0; d < slope->size(); ++d) (*slope)[d] = share * (*slope)[d] + of_share[d] * value;
    value *= share;
  };
  integrals.area *= share;
  for (std::size_t a = 0; a < 4; ++a) {
    integrals.share[a] *= share;
    for (std::size_t b = 0; b < 4; ++b) {
      one(integrals.master[a][b], slopes != nullptr ? &slopes->master[a][b] : nullptr);
      const bool first = slopes != nullptr && a <= b;
      one(integrals.slave[a][b], first ? &slopes->slave[SegmentSlopes::pair_of_corners(a, b)] : nullptr);
    }
  }
}

}  // namespace

void fade(const SlavePlane& plane, FacetCorners master, double capture, SegmentIntegrals& integrals,
          SegmentSlopes* slopes) {
  const NormalChange of_master(master);
  const Share by_angle = cubic(-opposing_normals, facing, -plane.normal.dot(of_master.normal()));
  const bool near = integrals.distance <= near_share * capture;  // capture may be infinite
  const Share by_distance = near ? Share{} : cubic(-capture, -near_share * capture, -integrals.distance);
  const double share = by_angle.value * by_distance.value;
  if (share == 1) return;
  Slopes of_share{};
  if (slopes != nullptr) {
    const Corners corners(plane);
    const NormalChange of_slave(corners.span());
    if (by_angle.slope != 0)
      add_facing(of_slave, corners.count, of_master, master.size(), -by_angle.slope * by_distance.value, of_share);
    if (by_distance.slope != 0)
      add_distance(plane, corners, of_slave, master, integrals, *slopes, -by_distance.slope * by_angle.value, of_share);
  }
  scale(share, of_share, integrals, slopes);
}

}  // namespace brunt::contact
