// SPDX-License-Identifier: Apache-2.0
// Nodal normals of the slave surface and their derivatives.
#pragma once
#include <span>
#include <vector>

#include "brunt/contact/mortar/interface.hpp"

namespace brunt::contact {

/// How much of each slave facet lies under the master.
struct FacetCoverage {
  std::vector<double> area;  ///< of the overlap [length^2]
  NodeBlocks<Vec3> slopes;   ///< by nodes, a row a facet [length]; no rows where slopes are not asked for
  void clear() {
    area.clear();
    slopes.clear();
  }
};

/// Normal of each row, out of the master: minus the normalised mean of the unit normals of the slave facets around its
/// node, after its components along the normals of the symmetry planes through the node are removed. Slopes where
/// `slopes` is given. A row whose mean vanishes gets a zero normal, and no slope.
/// coverage: each facet counts with the share of it that lies under the master, so that at the edge of a body the
/// facets that face the master decide alone (with all of them the normal of an edge leans by half its angle, and
/// pressure pushes it sideways). Without it, and in rows of which nothing is covered, all facets count alike.
void nodal_normals(const MortarSurfaces& surfaces, const MortarTopology& topology, std::span<const Vec3> x,
                   std::vector<Vec3>& normals, NodeBlocks<Mat3>* slopes = nullptr,
                   const FacetCoverage* coverage = nullptr);

}  // namespace brunt::contact
