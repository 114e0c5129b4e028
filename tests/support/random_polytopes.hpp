// SPDX-License-Identifier: Apache-2.0
// Random convex polytopes with triangulated surfaces, and their penetration depth by brute force.
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "tests/support/depth_bodies.hpp"
#include "tests/support/random_motion.hpp"

namespace brunt::test {

/// Calls f(i, j, k, normal, height) for the three points of each supporting plane n . x = height of the set. All
/// triples are tried; `rounding` is relative to the size: points so far above a plane still lie in it.
template <class Function>
void for_each_facet(std::span<const Vec3> points, double rounding, const Function& f) {
  Vec3 low = points[0], high = low;
  for (const Vec3& x : points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const double size = (high - low).norm();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const Vec3 product = (points[j] - points[i]).cross(points[k] - points[i]);
        if (!(product.norm() > 1e-9 * size * size)) continue;
        const Vec3 normal = product.normalized();
        const double height = normal.dot(points[i]);
        bool above = false, below = false;
        for (std::size_t p = 0; p < points.size() && !(above && below); ++p) {
          if (p == i || p == j || p == k) continue;
          const double over = normal.dot(points[p]) - height;
          above = above || over > rounding * size;
          below = below || over < -rounding * size;
        }
        if (!above) f(i, j, k, normal, height);
        if (!below) f(i, k, j, Vec3(-normal), -height);
      }
}

/// Closed surface of the convex hull of points in general position (no four in a facet).
inline TriangleSurface hull_surface(const std::vector<Vec3>& points) {
  TriangleSurface surface;
  std::vector<LocalIndex> number(points.size(), no_index);
  for_each_facet(points, 0, [&](std::size_t i, std::size_t j, std::size_t k, const Vec3&, double) {
    std::array<LocalIndex, 3> triangle{};
    for (std::size_t c = 0; const std::size_t p : {i, j, k}) {
      if (number[p] == no_index) {
        number[p] = static_cast<LocalIndex>(surface.points.size());
        surface.points.push_back(points[p]);
      }
      triangle[c++] = number[p];
    }
    surface.triangles.push_back(triangle);
  });
  return surface;
}

/// The hull of `count` random points of an ellipsoid with half axes between 0.4 and 1.
inline TriangleSurface random_polytope(Random& random, int count) {
  Vec3 half;
  for (int c = 0; c < 3; ++c) half[c] = random.uniform(0.4, 1);
  std::vector<Vec3> points;
  for (int k = 0; k < count; ++k) points.push_back(random.direction().cwiseProduct(half));
  return hull_surface(points);
}

/// Overlapping more often than not.
inline Placement near_placement(Random& random) {
  return {random.rotation().toRotationMatrix(), random.uniform(0, 1.2) * random.direction()};
}

/// PDt of two convex hulls: the distance of the origin from the facets of the Minkowski difference A - B, of which all
/// corners are differences of corners. Negative where they are apart (then some lower bound of the distance). [length]
inline double minkowski_depth(std::span<const Vec3> a, std::span<const Vec3> b, const Placement& a_in_b) {
  std::vector<Vec3> differences;
  for (const Vec3& x : a)
    for (const Vec3& y : b) differences.push_back(a_in_b(x) - y);
  double depth = std::numeric_limits<double>::infinity();
  constexpr double rounding = 1e-13;  // corners of one facet, by rounding above each other's plane
  for_each_facet(differences, rounding, [&](std::size_t, std::size_t, std::size_t, const Vec3&, double height) {
    depth = std::min(depth, height);
  });
  return depth;
}

}  // namespace brunt::test
