// SPDX-License-Identifier: Apache-2.0
#include "triangle_point.hpp"

#include "geometry/triangles/triangle_pair.hpp"

namespace brunt::geometry {
namespace {

TriangleFeature edge_feature(std::size_t edge, double along) {
  constexpr int first_edge = static_cast<int>(TriangleFeature::edge0);
  constexpr int first_corner = static_cast<int>(TriangleFeature::corner0);
  if (along <= 0) return static_cast<TriangleFeature>(first_corner + static_cast<int>(edge));
  if (along >= 1) return static_cast<TriangleFeature>(first_corner + static_cast<int>((edge + 1) % 3));
  return static_cast<TriangleFeature>(first_edge + static_cast<int>(edge));
}

}  // namespace

OnTriangle nearest_on(const Triangle& t, const Vec3& p) {
  OnTriangle nearest{t[0], TriangleFeature::corner0};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 edge = t[(i + 1) % 3] - t[i], from_corner = p - t[i];
    const double s = clamp_to_unit(from_corner.dot(edge) / edge.squaredNorm());
    const double distance2 = (from_corner - s * edge).squaredNorm();
    if (!(distance2 < least)) continue;
    least = distance2;
    nearest = {s < 1 ? Vec3(t[i] + s * edge) : t[(i + 1) % 3], edge_feature(i, s)};
  }
  const Vec3 u = t[1] - t[0], v = t[2] - t[0], normal = accurate_cross(u, v);
  const double normal2 = normal.squaredNorm();
  if (!(normal2 > 0)) return nearest;
  const Vec3 from_corner = p - t[0];
  const double weight1 = from_corner.cross(v).dot(normal) / normal2,
               weight2 = u.cross(from_corner).dot(normal) / normal2;
  if (!(weight1 > 0 && weight2 > 0 && weight1 + weight2 < 1)) return nearest;
  const Vec3 away = p - nearest.point;  // short in a sliver
  const Vec3 inward = away.cross(v).dot(normal) / normal2 * u + u.cross(away).dot(normal) / normal2 * v;
  if ((away - inward).squaredNorm() < least) nearest = {nearest.point + inward, TriangleFeature::face};
  return nearest;
}

Vec3 nearest_point(const Triangle& triangle, const Vec3& p) {
  return nearest_on(triangle, p).point;
}

}  // namespace brunt::geometry
