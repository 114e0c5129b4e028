// SPDX-License-Identifier: Apache-2.0
// The canonical order of a mesh: elements of a block along a space-filling curve through their centroids, blocks as
// given, nodes by first touch. A function of the mesh alone: good for the cache, and every sum that must not depend on
// the ranks runs in this order.
#pragma once
#include <vector>

#include "brunt/mesh/mesh.hpp"

namespace brunt::mesh {

struct CanonicalMesh {
  Mesh mesh;                            ///< element gid: position over all blocks in order; node gid: position
  Vec3 origin = Vec3::Zero();           ///< rounded common origin already taken off the coordinates
  std::vector<GlobalIndex> input_node;  ///< position in the input of each node
  std::vector<std::vector<GlobalIndex>> input_element;  ///< per block: position in the input's block-by-block order
};

/// Takes out the nodes that no element uses, also from the node sets; the others keep their order. Returns how many.
LocalIndex drop_unused_nodes(Mesh& mesh);

/// Drops unused nodes first (positions "in the input" count the nodes kept), then orders. The curve is Hilbert's in the
/// cube over the mesh's bounding box, ties go by input position. Sets come out ascending, each entry once. The origin
/// is zero in each direction where the box lies within 8 of its sizes from zero; subtracting it is always exact.
CanonicalMesh canonical_order(Mesh&& mesh);

}  // namespace brunt::mesh
