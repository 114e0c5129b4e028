// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "brunt/geometry/slab_tree.hpp"
#include "triangle_point.hpp"

namespace brunt::geometry {
namespace {

/// Where the vector from the nearest point is nearer than this to the plane across the pseudo-normal (sine of the
/// angle), rounding may decide the sign: of sharp edges, and of points that are on the surface to rounding.
constexpr double clear_sine = 1e-6;

struct NearestTriangle {
  double distance2 = std::numeric_limits<double>::infinity();
  LocalIndex triangle = no_index;
};

NearestTriangle nearest_triangle(const SlabTree& tree, const Vec3& x, double at_most2) {
  NearestTriangle nearest;
  for (std::size_t i = 0; i < tree.triangles.size(); ++i) {
    const double distance2 = distance2_to(tree.triangles[i], x);
    if (distance2 < nearest.distance2) nearest = {distance2, static_cast<LocalIndex>(i)};
  }
  return nearest.distance2 <= at_most2 ? nearest : NearestTriangle();
}

bool inside(const SlabTree& tree, const Vec3& x, const Vec3& away, const Vec3& normal) {
  const double outward = away.dot(normal), distance = away.norm();
  if (std::abs(outward) > clear_sine * distance) return outward < 0;
  return winding_number(tree.triangles, x) > 0.5;
}

PointDepth depth_at(const SlabTree& tree, const Vec3& x, LocalIndex triangle) {
  const auto t = static_cast<std::size_t>(triangle);
  const OnTriangle on = nearest_on(tree.triangles[t], x);
  const Vec3 away = x - on.point;
  const double distance = away.norm();
  if (distance == 0) return {0, on.point, triangle};
  const Vec3& normal = tree.normals[t][static_cast<std::size_t>(on.feature)];
  return {inside(tree, x, away, normal) ? distance : -distance, on.point, triangle};
}

}  // namespace

PointDepth point_depth(const SlabTree& tree, const Vec3& x) {
  return point_depth(tree, x, std::numeric_limits<double>::infinity());
}

PointDepth point_depth(const SlabTree& tree, const Vec3& x, double at_most) {
  const NearestTriangle nearest = nearest_triangle(tree, x, at_most * at_most);
  if (nearest.triangle == no_index) return {at_most, x, no_index};
  return depth_at(tree, x, nearest.triangle);
}

double depth_above(const SlabTree& tree, const Vec3& x, double least) {
  const double depth = point_depth(tree, x).depth;
  return depth > least ? depth : -std::numeric_limits<double>::infinity();
}

bool contains(const SlabTree& tree, const Vec3& x) {
  return contains(tree.box, x) && point_depth(tree, x).depth >= 0;
}

double winding_number(std::span<const Triangle> triangles, const Vec3& x) {
  constexpr double pi = 3.14159265358979323846;
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Vec3 a = t[0] - x, b = t[1] - x, c = t[2] - x;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2 * pi);
}

double winding_number(const TriangleSurface& surface, const Vec3& x) {
  std::vector<Triangle> triangles;
  for (const auto& corners : surface.triangles) {
    Triangle& triangle = triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = surface.points[static_cast<std::size_t>(corners[i])];
  }
  return winding_number(triangles, x);
}

}  // namespace brunt::geometry
