// SPDX-License-Identifier: Apache-2.0
#include "normal_change.hpp"

#include <Eigen/Geometry>

namespace brunt::contact {

namespace {

using Diagonals = std::array<Vec3, 2>;

Diagonals diagonals(FacetCorners x) {
  if (x.size() == 3) return {x[1] - x[0], x[2] - x[0]};
  return {x[2] - x[0], x[3] - x[1]};
}

Vec3 unit_normal(const Diagonals& d) {
  return d[0].cross(d[1]).normalized();
}

/// The vectors with products 1 with one of these and 0 with the others.
std::array<Vec3, 3> dual_of(const Diagonals& d, const Vec3& normal) {
  const double volume = d[0].cross(d[1]).dot(normal);
  return {d[1].cross(normal) / volume, normal.cross(d[0]) / volume, d[0].cross(d[1]) / volume};
}

}  // namespace

NormalChange::NormalChange(FacetCorners before, FacetCorners now) : triangle_(now.size() == 3), share_(0.5) {
  const Diagonals old = diagonals(before), last = diagonals(now);
  normal_ = unit_normal(last);
  mean_normal_ = 0.5 * (unit_normal(old) + normal_);
  dual_ = dual_of({0.5 * (old[0] + last[0]), 0.5 * (old[1] + last[1])}, mean_normal_);
  const std::array<Vec3, 3> dual_now = dual_of(last, normal_);
  dual_now_ = {dual_now[0], dual_now[1]};
}

NormalChange::NormalChange(FacetCorners x) : triangle_(x.size() == 3), share_(1) {
  const Diagonals d = diagonals(x);
  normal_ = mean_normal_ = unit_normal(d);
  dual_ = dual_of(d, normal_);
  dual_now_ = {dual_[0], dual_[1]};
}

double NormalChange::sign(std::size_t corner, std::size_t diagonal) const {
  if (triangle_) return corner == 0 ? -1.0 : corner == diagonal + 1 ? 1.0 : 0.0;
  return corner == diagonal ? -1.0 : corner == diagonal + 2 ? 1.0 : 0.0;
}

Mat3 NormalChange::by_corner(std::size_t corner) const {
  return -(sign(corner, 0) * dual_[0] + sign(corner, 1) * dual_[1]) * mean_normal_.transpose();
}

/// The force on diagonal j is - (q . dual_j) n. A change of the basis changes its dual by
/// d dual_j = - sum_i dual_i (d basis_i . dual_j), and the end's normal changes by - sum_k dual_now_k n . d d_k.
Mat3 NormalChange::slope(const Vec3& q, std::size_t corner, std::size_t by) const {
  Mat3 sum = Mat3::Zero();
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t k = 0; k < 2; ++k) {
      const double both = sign(corner, j) * sign(by, k);
      if (both == 0) continue;
      const Vec3 by_mean = q.dot(dual_[k]) * dual_[j];
      const Vec3 by_normal = -q.dot(dual_[2]) * dual_[j].dot(dual_now_[k]) * normal_;
      sum += both * share_ *
             (mean_normal_ * (by_mean + by_normal).transpose() + q.dot(dual_[j]) * dual_now_[k] * normal_.transpose());
    }
  return sum;
}

}  // namespace brunt::contact
