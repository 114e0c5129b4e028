// SPDX-License-Identifier: Apache-2.0
// Mass moments of the solid that a closed surface of triangles bounds.
//
// Each triangle spans a tetrahedron with a common point; its volume counts negative if the triangle faces that point.
// The sum is exact for any closed surface (divergence theorem), including surfaces with cavities or several parts.
#pragma once
#include "core/triangle_surface.hpp"
#include "rigid/mass_properties.hpp"

namespace brunt::rigid {

/// x is measured from `origin`; density [mass/length^3]. Rounding grows with the distance of the surface from `origin`:
/// choose a point near the surface. An inverted surface has negative mass, and the result for an open one is
/// meaningless. The sum runs in the order of the triangles.
[[nodiscard]] MassMoments surface_moments(const TriangleSurface& surface, const Vec3& origin, double density);

/// The same about the middle of the surface's bounding box, with the centre in the coordinates of the points. Values of
/// table D of the reference to all its digits.
[[nodiscard]] MassProperties surface_properties(const TriangleSurface& surface, double density);

}  // namespace brunt::rigid
