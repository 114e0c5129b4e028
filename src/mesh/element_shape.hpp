// SPDX-License-Identifier: Apache-2.0
// Shape of one element: which repeated corners are legal, and its worst Jacobian.
#pragma once
#include <vector>

#include "mesh/mesh.hpp"

namespace brunt::mesh {

/// All distinct, or a hexahedron collapsed to a wedge, pyramid or tetrahedron.
bool corners_are_legal(Shape shape, const LocalIndex* element);

struct WorstJacobian {
  double scaled = 0;  ///< triple product of the edges over the product of their lengths, in [-1, 1]; of a shell that of
                      ///< two edges and the unit normal of the element, that of its diagonals
  int corner = -1;    ///< -1: the centre (hex8), or the whole (tet4)
};

/// The smallest over the corners that have three distinct edges, and the centre.
WorstJacobian worst_jacobian(Shape shape, const LocalIndex* element, const std::vector<Vec3>& coordinates);

}  // namespace brunt::mesh
