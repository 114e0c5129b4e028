// SPDX-License-Identifier: Apache-2.0
// The canonical order of a mesh: elements of a block along a space-filling curve through their centroids, blocks as
// given, nodes by first use. It depends on the mesh only. It improves the use of the cache, and every sum that must not
// depend on the ranks follows it.
#pragma once
#include <vector>

#include "mesh/mesh.hpp"

namespace brunt::mesh {

struct CanonicalMesh {
  Mesh mesh;                            ///< element gid: position over all blocks in order; node gid: position
  Vec3 origin = Vec3::Zero();           ///< rounded common origin already taken off the coordinates
  std::vector<GlobalIndex> input_node;  ///< position in the input of each node
  std::vector<std::vector<GlobalIndex>> input_element;  ///< per block: position in the input's block-by-block order
};

/// Removes the nodes that no element uses, also from the node sets; the others keep their order. Returns their number.
LocalIndex drop_unused_nodes(Mesh& mesh);

/// Drops unused nodes first (positions "in the input" count the remaining nodes), then orders. The curve is Hilbert's
/// in the cube around the bounding box of the mesh; ties are ordered by input position. Sets are ascending, with each
/// entry once. The origin is zero in each direction in which the box lies within 8 of its sizes from zero; its
/// subtraction is always exact.
CanonicalMesh canonical_order(Mesh&& mesh);

}  // namespace brunt::mesh
