// SPDX-License-Identifier: Apache-2.0
// Integrals of a segment to rounding, for weights that are integrated once.
#pragma once
#include "contact/mortar/segment.hpp"

namespace brunt::contact {

/// As integrate_segment without slopes. Between parallelograms and triangles, where all products are polynomials of
/// degree four, the rule is exact. Elsewhere shape functions are no polynomials: each triangle of the rule is cut into
/// sixteen, which leaves 1 / 64^2 of its error.
bool integrate_finely(const SlavePlane& plane, FacetCorners master, double capture, SegmentIntegrals& integrals);

}  // namespace brunt::contact
