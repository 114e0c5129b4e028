// SPDX-License-Identifier: Apache-2.0
#include "rigid/surface_moments.hpp"

#include <array>

namespace brunt::rigid {

MassMoments surface_moments(const TriangleSurface& surface, const Vec3& origin, double density) {
  MassMoments sum;
  for (const auto& triangle : surface.triangles) {
    std::array<Vec3, 4> corners{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    for (std::size_t k = 0; k < 3; ++k) corners[k + 1] = nth(surface.points, triangle[k]) - origin;
    sum = sum + tetrahedron_moments(corners, density);
  }
  return sum;
}

MassProperties surface_properties(const TriangleSurface& surface, double density) {
  if (surface.points.empty()) return {};
  Vec3 low = surface.points.front(), high = low;
  for (const Vec3& point : surface.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Vec3 middle = 0.5 * (low + high);
  MassProperties properties = properties_of(surface_moments(surface, middle, density));
  properties.centre += middle;
  return properties;
}

}  // namespace brunt::rigid
