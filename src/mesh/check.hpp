// SPDX-License-Identifier: Apache-2.0
// Validity of a mesh for a run. One line for each fault, in the numbers of the input.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace brunt::mesh {

struct CheckReport {
  std::vector<std::string> faults;    ///< the mesh cannot be run
  std::vector<std::string> warnings;  ///< the mesh can be run, but the user should know this
};

/// Faults: a node index out of range; a coordinate that is not finite; nodes repeated in an element other than as in a
/// legal degenerate hexahedron; a Jacobian that is not positive (hex8: at the centre and at the corners, except
/// collapsed ones; tet4: the volume; shells: at the corners, about the normal of the whole); an element with the nodes
/// of another one; a side or node of a set out of range; a block without elements; a mesh without blocks. Legal
/// degenerate hexahedra are the wedge (two opposite edges of a face collapsed), the pyramid (a face collapsed to a
/// node) and the tetrahedron (a face, and an edge of the opposite face). Warnings: nodes that no element uses; shells
/// with mixed normals; coincident nodes of one body (to 1e-9 of the size of the mesh). At most ten lines of each kind
/// are followed by the number of omitted ones. A Jacobian counts as positive above 1e-12 of the product of the three
/// edge lengths. Generated bodies cannot have repeated elements or nodes, so these checks are skipped for them.
enum class MeshSource { file, generated };
CheckReport check(const Mesh& mesh, MeshSource source = MeshSource::file);

}  // namespace brunt::mesh
