// SPDX-License-Identifier: Apache-2.0
// The normal cone of a slave node: the directions of its own surface. At a convex corner a body can touch others along
// any direction between the normals of the faces at the corner; within a smooth surface only along the normal.
#pragma once
#include <span>

#include "core/types.hpp"

namespace brunt::contact {

/// The unit normals of the faces around a node, as rows of `normals`.
struct NormalCone {
  std::span<const LocalIndex> facets;
  std::span<const Vec3> normals;
  bool two_sided = false;  ///< the node lies on a sheet: every facet has two sides

  [[nodiscard]] const Vec3& operator[](std::size_t i) const { return nth(normals, facets[i]); }
};

/// Whether the normals of all facets agree with the first one by at least this cosine. The cone is then represented by
/// these normals.
bool is_smooth(const NormalCone& cone, double aligned);

/// Cosine of the smallest angle between the reversed normal of a face and the cone: 1 if the node's surface can lie on
/// the face without rotation, 0 or less if it faces sideways or away. A node without facets admits all directions.
/// smooth: result of is_smooth; the arcs between the normals of facets are then skipped.
double admission(const NormalCone& cone, const Vec3& normal, bool smooth);

}  // namespace brunt::contact
