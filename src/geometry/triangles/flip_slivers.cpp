// SPDX-License-Identifier: Apache-2.0
#include "geometry/triangles/flip_slivers.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "geometry/triangles/closed_surface.hpp"

namespace brunt::geometry {
namespace {

using IndexTriple = std::array<LocalIndex, 3>;

class Flipper {
 public:
  Flipper(TriangleSurface& surface, double tolerance) : surface_(surface), tolerance_(tolerance) {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) enter(t);
  }

  /// Each flip leaves fewer slivers, or as many with shorter sides, so the passes come to an end.
  std::int64_t flip_all() {
    std::vector<std::size_t> slivers;
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
      if (is_sliver(surface_.triangles[t])) slivers.push_back(t);
    std::int64_t flips = 0;
    for (std::int64_t before = -1; flips > before && !slivers.empty();) {
      before = flips;
      std::vector<std::size_t> left;
      for (const std::size_t t : slivers) {
        if (!is_sliver(surface_.triangles[t])) continue;  // as the neighbour of another one
        if (flip(t)) ++flips;
        if (is_sliver(surface_.triangles[t])) left.push_back(t);
      }
      slivers = std::move(left);
    }
    return flips;
  }

 private:
  using Edge = std::pair<LocalIndex, LocalIndex>;

  /// No area, or a corner within the tolerance of the longest side.
  [[nodiscard]] bool is_sliver(const IndexTriple& triangle) const {
    if (!has_area(surface_, triangle)) return true;
    const auto at = [&](std::size_t k) { return nth(surface_.points, triangle[k]); };
    const double longest = std::max(
        {length({triangle[0], triangle[1]}), length({triangle[1], triangle[2]}), length({triangle[2], triangle[0]})});
    return (at(1) - at(0)).cross(at(2) - at(0)).norm() <= tolerance_ * longest;
  }

  void enter(std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++owners(t, k);
      side_[edge(t, k)] = t;
    }
  }
  void leave(std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (--owners(t, k) > 0) continue;
      count_.erase(edge(t, k));
      side_.erase(edge(t, k));
    }
  }
  [[nodiscard]] Edge edge(std::size_t t, std::size_t k) const {
    const IndexTriple& triangle = surface_.triangles[t];
    return {triangle[k], triangle[(k + 1) % 3]};
  }
  int& owners(std::size_t t, std::size_t k) { return count_[edge(t, k)]; }
  [[nodiscard]] double length(const Edge& e) const {
    return (nth(surface_.points, e.second) - nth(surface_.points, e.first)).norm();
  }

  /// a, b, c with b in the side from c to a.
  [[nodiscard]] IndexTriple from_longest(std::size_t t) const {
    std::size_t longest = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (length(edge(t, k)) > length(edge(t, longest))) longest = k;
    const IndexTriple& triangle = surface_.triangles[t];
    return {triangle[(longest + 1) % 3], triangle[(longest + 2) % 3], triangle[longest]};
  }

  /// Slivers of two, and the sum of their longest sides: two that lie on each other along a side have
  /// shorter ones after a flip, which then reach neighbours with area.
  [[nodiscard]] std::pair<int, double> lack_of(const IndexTriple& one, const IndexTriple& two) const {
    std::pair<int, double> lack{0, 0.0};
    for (const IndexTriple& triangle : {one, two}) {
      if (!is_sliver(triangle)) continue;
      ++lack.first;
      lack.second += std::max(
          {length({triangle[0], triangle[1]}), length({triangle[1], triangle[2]}), length({triangle[2], triangle[0]})});
    }
    return lack;
  }

  bool flip(std::size_t t) {
    const IndexTriple from = from_longest(t);
    const LocalIndex a = from[0], b = from[1], c = from[2];
    const auto across = side_.find({a, c});
    if (across == side_.end() || count_.at({a, c}) != 1 || count_.at({c, a}) != 1) return false;
    const std::size_t other = across->second;
    const IndexTriple old = surface_.triangles[t], neighbour = surface_.triangles[other];
    LocalIndex d = neighbour[0];
    for (const LocalIndex p : neighbour)
      if (p != a && p != c) d = p;
    if (d == b || count_.contains({b, d}) || count_.contains({d, b})) return false;
    const IndexTriple one{a, b, d}, two{b, c, d};
    if (!(lack_of(one, two) < lack_of(old, neighbour))) return false;
    leave(t);
    leave(other);
    surface_.triangles[t] = one;
    surface_.triangles[other] = two;
    enter(t);
    enter(other);
    return true;
  }

  TriangleSurface& surface_;
  double tolerance_;                  // [length]
  std::map<Edge, std::size_t> side_;  // the triangle of a directed side
  std::map<Edge, int> count_;         // of triangles that have it
};

}  // namespace

std::int64_t flip_slivers(TriangleSurface& surface, double tolerance) {
  return Flipper(surface, tolerance).flip_all();
}

}  // namespace brunt::geometry
