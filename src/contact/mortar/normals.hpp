// SPDX-License-Identifier: Apache-2.0
// Nodal normals of the slave surface and their derivatives.
#pragma once
#include <span>
#include <vector>

#include "contact/mortar/interface.hpp"

namespace brunt::contact {

/// Covered part of each slave facet.
struct FacetCoverage {
  std::vector<double> area;  ///< of the overlap [length^2]
  NodeBlocks<Vec3> slopes;   ///< by nodes, one row for each facet [length]; no rows if derivatives are not required
  void clear() {
    area.clear();
    slopes.clear();
  }
};

/// Normal of each row, out of the master: minus the normalised mean of the unit normals of the slave facets around its
/// node, after removal of its components along the normals of the symmetry planes through the node. With derivatives if
/// `slopes` is given. A row with a zero mean has a zero normal and no derivative.
/// coverage: each facet is weighted with its covered share, so that at the edge of a body only the facets opposite the
/// master determine the normal. (If all facets counted, the normal at an edge would be inclined by half the edge angle,
/// and the pressure would have a tangential component.) Without it, and in rows without a covered part, all facets have
/// equal weight.
void nodal_normals(const MortarSurfaces& surfaces, const MortarTopology& topology, std::span<const Vec3> x,
                   std::vector<Vec3>& normals, NodeBlocks<Mat3>* slopes = nullptr,
                   const FacetCoverage* coverage = nullptr);

}  // namespace brunt::contact
