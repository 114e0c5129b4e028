// SPDX-License-Identifier: Apache-2.0
// Rows of single nodes on the facets of the other side: for nodes of sharp edges, which sink between the nodes of a
// coarse slave while the mean gaps of its rows stay open. Row A of a node over a facet:
//   w_AA = a_A, w_AC = - a_A N_C below the node, G_A = a_A (x_A - sum_C N_C x_C),
// with a_A the node's share of its surface in the reference configuration. The normal of the row is that of the
// master's smooth patch, interpolated over the facet. All else is as for other rows.
//
// The point below the node is where the line through the node along its own outward normal crosses the master: of a
// surface without holes this line finds one facet, whether the surface is convex or concave there. All weights have a
// factor that fades to 0 where the master ends (NodePatches::rims).
#pragma once
#include <span>

#include "contact/mortar/interface.hpp"

namespace brunt::contact {

/// surfaces.slave: facets around the nodes of the rows; surfaces.master_patches: of all master facets around the facets
/// below. Otherwise as mortar_rows.
void point_rows(const MortarSurfaces& surfaces, const MortarTopology& topology, const Ragged<LocalIndex>& candidates,
                std::span<const Vec3> x, MortarRows& rows);

/// The same with derivatives; arguments as of mortar_rows_and_slopes. Sources of patches are rows.
void point_rows_and_slopes(const MortarSurfaces& surfaces, const MortarTopology& topology,
                           const Ragged<LocalIndex>& candidates, std::span<const Vec3> x,
                           std::span<const Vec3> tractions, MortarRows& rows, MortarSlopes& slopes,
                           std::span<const Vec3> fixed = {}, std::span<const Vec3> transposed = {});

}  // namespace brunt::contact
