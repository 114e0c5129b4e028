// SPDX-License-Identifier: Apache-2.0
// Volume and centre of generated round bodies, of the mesh and of the exact body.
#pragma once
#include "brunt/mesh/mesh.hpp"
#include "brunt/mesh/primitives.hpp"

namespace brunt::mesh {

struct Moments {
  double volume = 0;
  Vec3 centre = Vec3::Zero();
};

/// Of a mesh of hexahedra: integrated with 2 x 2 x 2 points an element, which is exact for volume and first moment of a
/// trilinear element (polynomials of degree 2 and 3 in each direction; Gauss with two points is exact to degree 3).
Moments moments(const Mesh& mesh);

/// A ball at the origin. The centre of half a ball lies 3/8 radius off each cut plane.
Moments exact_sphere(double radius, const Half& half);

/// Axis z, foot at the origin; a solid cylinder has inner_radius 0. The centre of half a disk lies 4 radius / (3 pi)
/// off each cut plane. Noses are summed over 4096 slices, conical ones each: to 1e-7.
Moments exact_tube(double inner_radius, double outer_radius, double length, const RoundForm& form);

/// Centre at the origin: 2 pi^2 radius (outer_radius^2 - inner_radius^2), by Pappus.
Moments exact_torus(double radius, double inner_radius, double outer_radius);

}  // namespace brunt::mesh
