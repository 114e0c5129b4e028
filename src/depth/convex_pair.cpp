// SPDX-License-Identifier: Apache-2.0
#include "depth/convex_pair.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace brunt::depth {
namespace {

constexpr double flat = 1e-9;             // of the size: points with a smaller distance from a plane lie in it
constexpr double parallel = 1e-9;         // sine: directions coincide
constexpr double no_edge_product = 1e-7;  // sine: parallel edges span no facet

void add_direction(std::vector<Vec3>& directions, const Vec3& u) {
  const bool known = std::any_of(directions.begin(), directions.end(),
                                 [&](const Vec3& other) { return other.cross(u).norm() <= parallel; });
  if (!known) directions.push_back(u);
}

struct Facet {
  Vec3 normal;
  double height;
};

std::vector<Facet> facets_of(std::span<const Vec3> points, double size) {
  std::vector<Facet> facets;
  const auto add = [&](const Vec3& normal, double height) {
    for (const Vec3& x : points)
      if (normal.dot(x) > height + flat * size) return;
    for (const Facet& facet : facets)
      if ((facet.normal - normal).norm() <= parallel) return;
    facets.push_back({normal, height});
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k) {
        const Vec3 product = (points[j] - points[i]).cross(points[k] - points[i]);
        if (!(product.norm() > flat * size * size)) continue;
        const Vec3 normal = product.normalized();
        add(normal, normal.dot(points[i]));
        add(-normal, -normal.dot(points[i]));
      }
  return facets;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
};

Range range_along(std::span<const Vec3> points, const Vec3& u) {
  Range range;
  for (const Vec3& x : points) {
    const double height = u.dot(x);
    range.low = std::min(range.low, height);
    range.high = std::max(range.high, height);
  }
  return range;
}

}  // namespace

ConvexPiece convex_piece(std::span<const Vec3> points) {
  Vec3 low = points.front(), high = low;
  for (const Vec3& x : points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const double size = (high - low).norm();
  const std::vector<Facet> facets = facets_of(points, size);
  if (facets.size() < 4) throw std::invalid_argument("the convex piece has no volume");
  ConvexPiece piece;
  for (const Facet& facet : facets) add_direction(piece.normals, facet.normal);
  const auto on = [&](const Vec3& x, const Facet& facet) {
    return std::abs(facet.normal.dot(x) - facet.height) <= flat * size;
  };
  for (const Vec3& x : points)
    if (std::count_if(facets.begin(), facets.end(), [&](const Facet& f) { return on(x, f); }) > 2)
      piece.corners.push_back(x);
  for (std::size_t i = 0; i < piece.corners.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 &p = piece.corners[i], &q = piece.corners[j];
      const auto both = [&](const Facet& f) { return on(p, f) && on(q, f); };
      if (std::count_if(facets.begin(), facets.end(), both) > 1 && (p - q).norm() > flat * size)
        add_direction(piece.edges, (p - q).normalized());
    }
  return piece;
}

Narrowest narrowest_overlap(const ConvexPiece& a, const ConvexPiece& b, const Placement& a_in_b, const Mat3& shifts,
                            double least) {
  Narrowest result{std::numeric_limits<double>::infinity(), Vec3::Zero()};
  const auto narrow = [&](const Vec3& u) {
    const Range range_a = range_along(a.corners, a_in_b.rotation.transpose() * u);
    const double shift = u.dot(a_in_b.translation);
    const Range range_b = range_along(b.corners, u);
    const double overlap = std::min(range_a.high + shift - range_b.low, range_b.high - range_a.low - shift) -
                           (shifts.transpose() * u).cwiseAbs().sum();
    if (overlap < result.depth) result = {overlap, u};
    return result.depth > least;
  };
  for (const Vec3& normal : b.normals)
    if (!narrow(normal)) return result;
  for (const Vec3& normal : a.normals)
    if (!narrow(a_in_b.rotation * normal)) return result;
  for (const Vec3& edge_a : a.edges) {
    const Vec3 e = a_in_b.rotation * edge_a;
    for (const Vec3& edge_b : b.edges) {
      const Vec3 product = e.cross(edge_b);
      const double length = product.norm();
      if (length > no_edge_product && !narrow(product / length)) return result;
    }
  }
  return result;
}

double translation_depth(const ConvexPiece& a, const ConvexPiece& b, const Placement& a_in_b, double least) {
  return narrowest_overlap(a, b, a_in_b, Mat3::Zero(), least).depth;
}

}  // namespace brunt::depth
