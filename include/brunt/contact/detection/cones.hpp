// SPDX-License-Identifier: Apache-2.0
// The normal cone of a slave node: the directions in which its own surface looks. A body of a convex corner touches
// others along any direction between the normals of the faces that meet there, a node within a smooth surface along
// one only.
#pragma once
#include <span>

#include "brunt/core/types.hpp"

namespace brunt::contact {

/// The unit normals of the faces around a node, as rows of `normals`.
struct NormalCone {
  std::span<const LocalIndex> facets;
  std::span<const Vec3> normals;
  bool two_sided = false;  ///< the node lies on a sheet: every facet looks both ways

  [[nodiscard]] const Vec3& operator[](std::size_t i) const { return normals[static_cast<std::size_t>(facets[i])]; }
};

/// Do all facets look along the first, by this cosine at least? Then the cone is as good as their normals.
bool is_smooth(const NormalCone& cone, double aligned);

/// Cosine of the least angle between the reversed normal of a face and the cone: 1 where the node's surface can lie on
/// the face without turning, 0 or less where it looks aside or away. A node without facets looks everywhere. smooth: as
/// is_smooth says; then the arcs between the facets' normals are passed over.
double admission(const NormalCone& cone, const Vec3& normal, bool smooth);

}  // namespace brunt::contact
