// SPDX-License-Identifier: Apache-2.0
// Coincident nodes of two bodies in two-pass contact: whether one row is sufficient for both.
#pragma once
#include <span>

#include "brunt/contact/detection/encounter.hpp"

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

/// Whether a corner of the faces `near` (of one body) is closer to the node than `distance` [length], so that one row,
/// that of the corner's node on the node's own faces, constrains both. This holds where the surfaces coincide (every
/// facet that faces the other side within 60 degrees has an opposed face there within 20 degrees), and where two sharp
/// corners meet. A sharp corner that stands on a face, or has deformed it, does not coincide with the node below it:
/// that node touches one side of the corner, and its row would let the corner penetrate along that side. possible: all
/// nodes that may be this near.
bool is_held_by_coincident_node(const FacesInMotion& scene, const NodeOnSurface& node, std::span<const LocalIndex> near,
                                std::span<const CoincidentCandidate> possible, double distance,
                                const Tolerances& tolerances);

}  // namespace brunt::contact
