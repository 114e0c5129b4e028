// SPDX-License-Identifier: Apache-2.0
// Nodal normals of the slave surface and their derivatives.
#pragma once
#include <span>
#include <vector>

#include "brunt/contact/mortar/interface.hpp"

namespace brunt::contact {

/// Normal of each row, out of the master: minus the normalised mean of the unit normals of the slave facets around its
/// node, after its components along the normals of the symmetry planes through the node are removed. Slopes where
/// `slopes` is given. A row whose mean vanishes gets a zero normal, and no slope.
void nodal_normals(const MortarSurfaces& surfaces, const MortarTopology& topology, std::span<const Vec3> x,
                   std::vector<Vec3>& normals, NodeBlocks<Mat3>* slopes = nullptr);

}  // namespace brunt::contact
