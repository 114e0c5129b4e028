// SPDX-License-Identifier: Apache-2.0
// Nodes of two bodies that lie on each other, in two passes: is one row enough for both?
#pragma once
#include <span>

#include "brunt/contact/detection/encounter.hpp"

namespace brunt::contact {

/// A node with the unit normals of its own faces.
struct NodeOnSurface {
  const NodeMotion& motion;
  std::span<const LocalIndex> facets;  ///< rows of facet_normal
  std::span<const Vec3> facet_normal;
  bool two_sided = false;  ///< it lies on a sheet, whose facets look to both sides
};

/// A contact node of another body that may come to lie where a slave does.
struct CoincidentCandidate {
  LocalIndex node = 0;
  std::int32_t body = 0;
};

/// Is a corner of the faces `near` (of one body) nearer to the node than `distance` [length], so that one row holds
/// both, that of the corner's node on the node's own faces? It does where the surfaces lie on each other (whatever
/// looks at the other side by 60 degrees or less has a face there to which it is opposed within 20), and where two
/// sharp corners meet. A sharp corner that stands on a face, or has pressed a dent into it, does not coincide with the
/// node there: that node meets one side of the corner, and its row would leave the corner to fall along that side into
/// the dent. possible: all nodes that may be so near.
bool is_held_by_coincident_node(const FacesInMotion& scene, const NodeOnSurface& node, std::span<const LocalIndex> near,
                                std::span<const CoincidentCandidate> possible, double distance,
                                const Tolerances& tolerances);

}  // namespace brunt::contact
