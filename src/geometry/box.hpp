// SPDX-License-Identifier: Apache-2.0
// Axis-aligned boxes, closed on all sides.
#pragma once
#include <limits>
#include <span>

#include "core/types.hpp"

namespace brunt::geometry {

struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());  ///< a new box is empty
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
};

inline void extend(Box& box, const Vec3& point) {
  box.low = box.low.cwiseMin(point);
  box.high = box.high.cwiseMax(point);
}

inline Box bounding_box(std::span<const Vec3> points) {
  Box box;
  for (const Vec3& point : points) extend(box, point);
  return box;
}

/// Moved outward by `margin` [length] on all sides.
inline Box grown(const Box& box, double margin) {
  return {box.low.array() - margin, box.high.array() + margin};
}

inline bool contains(const Box& box, const Vec3& point) {
  return (box.low.array() <= point.array()).all() && (point.array() <= box.high.array()).all();
}

inline bool overlaps(const Box& a, const Box& b) {
  bool apart = false;  // evaluates all six comparisons without a branch: branches would be unpredictable
  for (int c = 0; c < 3; ++c) apart |= !(a.low[c] <= b.high[c]) | !(b.low[c] <= a.high[c]);  // NOLINT
  return !apart;
}

}  // namespace brunt::geometry
