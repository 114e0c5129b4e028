// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/cones.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace brunt::contact {
namespace {

/// Cosine of the angle between a direction and the arc between two unit vectors, if the nearest point of the arc is not
/// one of its ends; otherwise -1, since the caller examines the ends.
double admission_of_arc(const Vec3& one, const Vec3& other, const Vec3& direction) {
  const Vec3 across = one.cross(other);
  const double area2 = across.squaredNorm();
  if (area2 < 1e-24) return -1;  // equal or opposite directions
  const Vec3 in_plane = direction - (direction.dot(across) / area2) * across;
  if (one.cross(in_plane).dot(across) < 0 || in_plane.cross(other).dot(across) < 0) return -1;
  return in_plane.norm();
}

/// Whether the direction lies within the spherical triangle of three unit vectors.
bool lies_between(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& direction) {
  const double volume = a.dot(b.cross(c));
  if (std::abs(volume) < 1e-12) return false;
  return direction.dot(b.cross(c)) * volume >= 0 && direction.dot(c.cross(a)) * volume >= 0 &&
         direction.dot(a.cross(b)) * volume >= 0;
}

}  // namespace

bool is_smooth(const NormalCone& cone, double aligned) {
  for (std::size_t i = 1; i < cone.facets.size(); ++i)
    if (cone[0].dot(cone[i]) <= aligned) return false;
  return true;
}

double admission(const NormalCone& cone, const Vec3& normal, bool smooth) {
  const std::size_t count = cone.facets.size();
  if (count == 0) return 1;
  double most = -1;
  for (std::size_t i = 0; i < count; ++i) {
    const double cosine = cone[i].dot(normal);
    most = std::max(most, cone.two_sided ? std::abs(cosine) : -cosine);
  }
  if (cone.two_sided || smooth) return most;
  const Vec3 direction = -normal;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j) {
      most = std::max(most, admission_of_arc(cone[i], cone[j], direction));
      for (std::size_t k = j + 1; k < count; ++k)
        if (lies_between(cone[i], cone[j], cone[k], direction)) return 1;
    }
  return most;
}

}  // namespace brunt::contact
