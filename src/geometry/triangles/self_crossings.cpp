// SPDX-License-Identifier: Apache-2.0
// Triangles of one surface that intersect outside their shared corners and edges.
#include <algorithm>
#include <utility>
#include <vector>

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

/// visit_pair(i, j) for each pair, i < j.
template <class VisitPair>
SelfCrossings find_crossings(const SlabTree& tree, const VisitPair& visit_pair) {
  SelfCrossings found;
  auto visit = [&](LocalIndex i, const Triangle& a, LocalIndex j) {
    const Triangle& b = nth(tree.triangles, j);
    if (i >= j || without_area(a) || without_area(b) || !cross_beyond_shared(a, b)) return false;
    visit_pair(i, j);
    if (found.count++ == 0 || std::pair(i, j) < std::pair(found.first_a, found.first_b)) {
      found.first_a = i;
      found.first_b = j;
    }
    return false;
  };
  SlabWalk(tree, tree, Placement(), 0, visit).run();
  return found;
}

struct EarlierPosition {
  bool operator()(const Vec3& a, const Vec3& b) const {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  }
};

}  // namespace

SelfCrossings self_crossings(const SlabTree& tree) {
  return find_crossings(tree, [](LocalIndex, LocalIndex) {});
}

SelfCrossings distrust_crossings(SlabTree& tree) {
  std::vector<Vec3> corners;  // of triangles that cross
  const SelfCrossings found = find_crossings(tree, [&](LocalIndex i, LocalIndex j) {
    for (const LocalIndex t : {i, j})
      for (const Vec3& x : nth(tree.triangles, t)) corners.push_back(x);
  });
  if (corners.empty()) return found;
  std::sort(corners.begin(), corners.end(), EarlierPosition());
  const auto crosses_at = [&](const Vec3& x) {
    return std::binary_search(corners.begin(), corners.end(), x, EarlierPosition());
  };
  for (std::size_t t = 0; t < tree.triangles.size(); ++t)
    if (std::any_of(tree.triangles[t].begin(), tree.triangles[t].end(), crosses_at)) tree.normals[t].fill(Vec3::Zero());
  return found;
}

}  // namespace brunt::geometry
