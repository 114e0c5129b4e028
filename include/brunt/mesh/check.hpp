// SPDX-License-Identifier: Apache-2.0
// Is a mesh fit for a run? One line a fault, in the input's own numbers.
#pragma once
#include <string>
#include <vector>

#include "brunt/mesh/mesh.hpp"

namespace brunt::mesh {

struct CheckReport {
  std::vector<std::string> faults;    ///< the mesh cannot be run
  std::vector<std::string> warnings;  ///< it can, but the user should know
};

/// Faults: a node index out of range; a coordinate that is not finite; nodes repeated in an element other than as in a
/// legal degenerate hexahedron; a Jacobian that is not positive (hex8: at the corners, but for collapsed ones, and at
/// the centre; tet4: the volume); an element on the nodes of another one; a side or node of a set out of range; a block
/// without elements; a mesh without any. Legal are wedge (two opposite edges of a face collapsed), pyramid (a face
/// collapsed to a node) and tetrahedron (a face, and an edge of the opposite face). Warnings: nodes that no element
/// uses; distinct nodes of one body at the same place (to 1e-9 of the mesh's size). At most ten lines of a kind, then
/// the number of those left out. Jacobians count as positive above 1e-12 of the product of the three edge lengths.
/// A body that was generated has no element and no node twice: that is not looked for.
enum class MeshSource { file, generated };
CheckReport check(const Mesh& mesh, MeshSource source = MeshSource::file);

}  // namespace brunt::mesh
