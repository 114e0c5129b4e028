// SPDX-License-Identifier: Apache-2.0
// Whether two triangles have a common point: sides of planes that the filter determines with certainty, two
// determinants (Guigue and Devillers, Fast and robust triangle-triangle overlap test using orientation predicates,
// 2003), or all edges by exact predicates.
#include "geometry/triangles/triangle_pair.hpp"

#include "exact_sign.hpp"

namespace brunt::geometry {
namespace {

bool finite(const Triangle& t) {
  return t[0].allFinite() && t[1].allFinite() && t[2].allFinite();
}

/// Of the corners of a triangle, of the plane of another.
struct Sides {
  std::array<int, 3> of{};
  Sides(const SidePlane& plane, const Triangle& t)
      : of{plane.certain_side(t[0]), plane.certain_side(t[1]), plane.certain_side(t[2])} {}
  /// If the filter is not certain, by exact predicates.
  void settle(const Triangle& face, const Triangle& t) {
    for (std::size_t i = 0; i < 3; ++i)
      if (of[i] == 0) of[i] = orientation(face[0], face[1], face[2], t[i]);
  }
  [[nodiscard]] bool apart() const { return std::abs(of[0] + of[1] + of[2]) == 3; }
  [[nodiscard]] bool off_plane() const { return of[0] * of[1] * of[2] != 0; }
  /// The corner that is alone on its side.
  [[nodiscard]] std::size_t alone() const { return of[0] == of[1] ? 2 : (of[0] == of[2] ? 1 : 0); }
};

/// No corner lies in the other plane, and not all are on one side of it: the planes intersect in a line, and the
/// triangles intersect if the two intervals on it overlap.
bool intervals_overlap(const Triangle& a, const Triangle& b, const Sides& sides_a, const Sides& sides_b) {
  const std::size_t i = sides_a.alone(), j = sides_b.alone();
  const Vec3 *a0 = &a[i], *a1 = &a[(i + 1) % 3], *a2 = &a[(i + 2) % 3];
  const Vec3 *b0 = &b[j], *b1 = &b[(j + 1) % 3], *b2 = &b[(j + 2) % 3];
  if (sides_a.of[i] < 0) std::swap(b1, b2);
  if (sides_b.of[j] < 0) std::swap(a1, a2);
  return orientation(*a0, *a1, *b0, *b1) <= 0 && orientation(*a0, *a2, *b2, *b0) <= 0;
}

bool edges_meet(const Triangle& a, const Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (segment_meets(a[i], a[(i + 1) % 3], b) || segment_meets(b[i], b[(i + 1) % 3], a)) return true;
  return false;
}

}  // namespace

bool triangles_cross(const Triangle& a, const Triangle& b) {
  Sides sides_b(SidePlane(a), b);
  if (sides_b.apart()) return false;
  Sides sides_a(SidePlane(b), a);
  if (sides_a.apart()) return false;
  if (!sides_a.off_plane() || !sides_b.off_plane()) {
    if (!finite(a) || !finite(b)) return false;
    sides_b.settle(a, b);
    sides_a.settle(b, a);
    if (sides_b.apart() || sides_a.apart()) return false;
    if (!sides_a.off_plane() || !sides_b.off_plane()) return edges_meet(a, b);
  }
  return intervals_overlap(a, b, sides_a, sides_b);
}

}  // namespace brunt::geometry
