// SPDX-License-Identifier: Apache-2.0
// Coincident nodes of two bodies in two-pass contact: whether one row is sufficient for both.
#pragma once
#include <span>

#include "contact/detection/encounter.hpp"

namespace brunt::contact {

/// A node with the unit normals of its own faces.
struct NodeOnSurface {
  const NodeMotion& motion;
  std::span<const LocalIndex> facets;  ///< rows of facet_normal
  std::span<const Vec3> facet_normal;
  bool two_sided = false;  ///< it lies on a sheet, whose facets have two sides
};

/// A contact node of another body that may become coincident with a slave.
struct CoincidentCandidate {
  LocalIndex node = 0;
  std::int32_t body = 0;
};

/// Whose row is not needed since the row of a coincident node constrains both.
struct RowsToSpare {
  bool first = false, second = false;  ///< in the first and in the second of two passes
};

/// Rows of the node on the faces `near` (of one body) that are not needed, if a corner of them is closer to the node
/// than `distance` [length]. Where the surfaces coincide (every facet that faces the other side within 60 degrees has
/// an opposed face there within 20 degrees), and where two corners meet, the row of the first pass constrains both.
/// Elsewhere the row of the sharper node does (a corner on a rim, either on a flat place): a row of the other node
/// would act against a ridge or a tip, from which it slides off to any side. Two rims that cross keep both rows.
/// possible: all nodes that may be this near.
RowsToSpare rows_to_spare(const FacesInMotion& scene, const NodeOnSurface& node, std::span<const LocalIndex> near,
                          std::span<const CoincidentCandidate> possible, double distance);

}  // namespace brunt::contact
