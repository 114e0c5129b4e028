// SPDX-License-Identifier: Apache-2.0
#include "pseudo_normals.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "triangle_point.hpp"

namespace brunt::geometry {
namespace {

struct ByCoordinates {
  bool operator()(const Vec3& a, const Vec3& b) const {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  }
};

/// A number for each place that holds corners, in the order of the coordinates.
std::vector<std::array<std::size_t, 3>> corner_places(std::span<const Triangle> triangles, std::size_t& count) {
  std::vector<Vec3> places;
  for (const Triangle& t : triangles) places.insert(places.end(), t.begin(), t.end());
  std::sort(places.begin(), places.end(), ByCoordinates());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<std::array<std::size_t, 3>> result;
  for (const Triangle& t : triangles) {
    auto& corners = result.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = static_cast<std::size_t>(std::lower_bound(places.begin(), places.end(), t[i], ByCoordinates()) -
                                            places.begin());
  }
  count = places.size();
  return result;
}

/// Unit, or zero where it is not clear.
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

/// A sum of normals in the order of the triangles, zero for good once one of them is.
struct NormalSum {
  Vec3 sum = Vec3::Zero();
  bool clear = true;
  void add(const Vec3& normal, double weight) {
    clear = clear && !normal.isZero(0);
    sum += weight * normal;
  }
  [[nodiscard]] Vec3 result() const {
    const double size = sum.norm();  // of two faces folded flat onto each other it is rounding
    return clear && size > clear_height ? Vec3(sum / size) : Vec3::Zero();
  }
};

}  // namespace

std::vector<TriangleNormals> pseudo_normals(std::span<const Triangle> triangles) {
  std::size_t count = 0;
  const auto places = corner_places(triangles, count);
  std::vector<TriangleNormals> normals(triangles.size());
  std::vector<NormalSum> at_corner(count);
  std::map<std::pair<std::size_t, std::size_t>, NormalSum> at_edge;
  const auto edge_key = [&](std::size_t t, std::size_t i) {
    return std::minmax({places[t][i], places[t][(i + 1) % 3]});
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Vec3 normal = clear_normal(triangles[t]);
    normals[t][0] = normal;
    for (std::size_t i = 0; i < 3; ++i) {
      at_edge[edge_key(t, i)].add(normal, 1);
      at_corner[places[t][i]].add(normal, angle_at(triangles[t], i));
    }
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      normals[t][1 + i] = at_edge[edge_key(t, i)].result();
      normals[t][4 + i] = at_corner[places[t][i]].result();
    }
  return normals;
}

}  // namespace brunt::geometry
