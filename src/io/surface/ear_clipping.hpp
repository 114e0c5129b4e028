// SPDX-License-Identifier: Apache-2.0
// Splits a polygon in space into triangles by clipping ears in the plane of its area vector.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace brunt::io {

enum class Split {
  done,
  crosses_itself,  ///< in the plane of its area vector
  too_concave,     ///< more concave corners than the time for one polygon allows
};

/// Keeps its arrays from one polygon to the next.
class EarClipping {
 public:
  /// Appends n - 2 triangles of positions in `corners` (at least three), in the sense of the polygon. Every side of the
  /// polygon is the side of one triangle. Thin ears are avoided where others exist, so that corners on a straight side
  /// give no triangle without area. A polygon without area becomes a fan. After `done` alone the triangles are of use.
  ///
  /// The order is fixed: rounds over the corners, in which neighbours of a clipped corner wait for the next round. A
  /// convex polygon of any size takes time in proportion to its corners. Others take it to the product of all corners
  /// and concave ones, and are refused when this exceeds `tests_per_corner` a corner.
  Split split(std::span<const Vec3> corners, std::vector<std::array<LocalIndex, 3>>& triangles);

  /// Tests of a point in a triangle, on average over the corners of a polygon: it bounds the time of a file by its size
  /// (about 10 microseconds a corner). Polygons of up to about 800 concave corners never reach it.
  static constexpr std::size_t tests_per_corner = 4096;

 private:
  /// Which ears are clipped: sound ones first, then thin ones, then those without area.
  enum class Ears { sound, thin, degenerate };
  struct Point {
    double x, y;
    bool operator==(const Point&) const = default;
  };

  bool project(std::span<const Vec3> corners);
  void start();
  bool clip(Ears kind, std::vector<std::array<LocalIndex, 3>>& triangles);
  [[nodiscard]] double area(LocalIndex a, LocalIndex b, LocalIndex c) const;
  [[nodiscard]] bool is_ear(LocalIndex corner, Ears kind);
  void remove_concave(LocalIndex corner);
  void retest(LocalIndex corner);

  std::vector<Point> points_;
  std::vector<LocalIndex> previous_, next_;  // ring of the corners that are left
  std::vector<LocalIndex> concave_, place_;  // corners that are not convex; the place of each there, or no_index
  std::vector<LocalIndex> now_, later_;      // corners to test in this round and in the next one
  std::vector<char> is_later_, is_left_;
  LocalIndex left_ = 0;      // number of corners
  double rounding_ = 0;      // of an area [length^2]
  std::size_t tests_ = 0;    // of a point in a triangle, so far
  std::size_t allowed_ = 0;  // of them
};

/// Splits a quadrilateral as `EarClipping::split` does: along its shorter diagonal (equal ones: 0-2) of those that lie
/// inside.
Split split_quadrilateral(std::span<const Vec3, 4> corners, std::vector<std::array<LocalIndex, 3>>& triangles);

}  // namespace brunt::io
