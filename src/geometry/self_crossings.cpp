// SPDX-License-Identifier: Apache-2.0
// Triangles of one surface that intersect outside their shared corners and edges.
#include <utility>

#include "exact_sign.hpp"
#include "slab_walk.hpp"

namespace brunt::geometry {
namespace {

/// Coincident corners: pairs of corners of a and b.
struct Shared {
  std::size_t count = 0;
  std::array<std::size_t, 9> of_a{}, of_b{};
  Shared(const Triangle& a, const Triangle& b) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (a[i] == b[j]) {
          of_a[count] = i;
          of_b[count++] = j;
        }
  }
};

/// Two triangles with a common edge have other common points only if they are coplanar and overlap.
bool folded(const Vec3& from, const Vec3& to, const Vec3& c, const Vec3& d) {
  if (orientation(from, to, c, d) != 0) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (turn(from, to, c, axis) * turn(from, to, d, axis) > 0) return true;
  return false;
}

/// Of triangles with area.
bool cross_beyond_shared(const Triangle& a, const Triangle& b) {
  const Shared shared(a, b);
  if (shared.count == 0) return triangles_cross(a, b);
  const std::size_t i = shared.of_a[0], j = shared.of_b[0];
  // From the shared corner a common line extends to the opposite edge of one of the two.
  if (shared.count == 1)
    return segment_meets(a[(i + 1) % 3], a[(i + 2) % 3], b) || segment_meets(b[(j + 1) % 3], b[(j + 2) % 3], a);
  if (shared.count > 2) return true;
  return folded(a[i], a[shared.of_a[1]], a[3 - i - shared.of_a[1]], b[3 - j - shared.of_b[1]]);
}

}  // namespace

SelfCrossings self_crossings(const SlabTree& tree) {
  SelfCrossings found;
  auto visit = [&](LocalIndex i, const Triangle& a, LocalIndex j) {
    const Triangle& b = tree.triangles[static_cast<std::size_t>(j)];
    if (i >= j || without_area(a) || without_area(b) || !cross_beyond_shared(a, b)) return false;
    if (found.count++ == 0 || std::pair(i, j) < std::pair(found.first_a, found.first_b)) {
      found.first_a = i;
      found.first_b = j;
    }
    return false;
  };
  SlabWalk(tree, tree, Placement(), 0, visit).run();
  return found;
}

}  // namespace brunt::geometry
