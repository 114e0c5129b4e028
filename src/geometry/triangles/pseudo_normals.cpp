// SPDX-License-Identifier: Apache-2.0
#include "pseudo_normals.hpp"

#include <algorithm>
#include <cmath>
#include <compare>

#include "triangle_point.hpp"

namespace brunt::geometry {
namespace {

struct Corner {
  Vec3 at;
  std::size_t triangle, corner;
  friend bool operator<(const Corner& a, const Corner& b) {
    return std::lexicographical_compare(a.at.data(), a.at.data() + 3, b.at.data(), b.at.data() + 3);
  }
};

/// A number for each position of corners, in the order of the coordinates.
std::vector<std::array<std::size_t, 3>> corner_places(std::span<const Triangle> triangles, std::size_t& count) {
  std::vector<Corner> corners;
  corners.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) corners.push_back({triangles[t][i], t, i});
  std::sort(corners.begin(), corners.end());
  std::vector<std::array<std::size_t, 3>> places(triangles.size());
  count = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (k > 0 && corners[k].at != corners[k - 1].at) ++count;
    places[corners[k].triangle][corners[k].corner] = count;
  }
  ++count;
  return places;
}

/// Unit, or zero if it is undefined.
Vec3 clear_normal(const Triangle& t) {
  const Vec3 normal = accurate_cross(t[1] - t[0], t[2] - t[0]);
  const double longest2 =
      std::max({(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
  const double size = normal.norm();
  return size > clear_height * longest2 ? Vec3(normal / size) : Vec3::Zero();
}

double angle_at(const Triangle& t, std::size_t corner) {
  const Vec3 u = t[(corner + 1) % 3] - t[corner], v = t[(corner + 2) % 3] - t[corner];
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// A sum of normals in the order of the triangles; zero if any of them is zero.
struct NormalSum {
  Vec3 sum = Vec3::Zero();
  bool clear = true;
  void add(const Vec3& normal, double weight) {
    clear = clear && !normal.isZero(0);
    sum += weight * normal;
  }
  [[nodiscard]] Vec3 result() const {
    const double size = sum.norm();  // for two coincident opposite faces it is rounding
    return clear && size > clear_height ? Vec3(sum / size) : Vec3::Zero();
  }
};

}  // namespace

std::vector<TriangleNormals> pseudo_normals(std::span<const Triangle> triangles) {
  struct Edge {
    std::size_t low, high, triangle, edge;
    auto operator<=>(const Edge&) const = default;
  };
  std::size_t count = 0;
  const auto places = corner_places(triangles, count);
  std::vector<TriangleNormals> normals(triangles.size());
  std::vector<NormalSum> at_corner(count);
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    normals[t][0] = clear_normal(triangles[t]);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax({places[t][i], places[t][(i + 1) % 3]});
      edges.push_back({low, high, t, i});
      at_corner[places[t][i]].add(normals[t][0], angle_at(triangles[t], i));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (auto first = edges.begin(); first != edges.end();) {
    NormalSum sum;
    auto last = first;
    for (; last != edges.end() && last->low == first->low && last->high == first->high; ++last)
      sum.add(normals[last->triangle][0], 1);
    for (; first != last; ++first) normals[first->triangle][1 + first->edge] = sum.result();
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) normals[t][4 + i] = at_corner[places[t][i]].result();
  return normals;
}

}  // namespace brunt::geometry
