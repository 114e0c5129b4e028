// SPDX-License-Identifier: Apache-2.0
// Share with which a pair of facets counts, so that pairs enter and leave rows without a jump.
#pragma once
#include "contact/mortar/segment.hpp"

namespace brunt::contact {

/// Facets count fully where minus the product of their unit normals is above `facing` (60 degrees from parallel), and
/// not at all below - `opposing_normals`; in between they come in by a cubic. Likewise open ones from `near` of the
/// capture distance to the whole of it. Penetrations do not fade.
constexpr double facing = 0.5, near_share = 0.5;

/// Multiplies the integrals of a segment by its share, and adapts the derivatives.
void fade(const SlavePlane& plane, FacetCorners master, double capture, SegmentIntegrals& integrals,
          SegmentSlopes* slopes);

}  // namespace brunt::contact
