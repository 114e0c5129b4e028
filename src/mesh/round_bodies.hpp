// SPDX-License-Identifier: Apache-2.0
// Volume and centroid of generated round bodies, of the mesh and of the exact body.
#pragma once
#include "mesh/mesh.hpp"
#include "mesh/primitives.hpp"

namespace brunt::mesh {

struct Moments {
  double volume = 0;
  Vec3 centre = Vec3::Zero();
};

/// Moments of a mesh of hexahedra, integrated with 2 x 2 x 2 points in each element. This is exact for the volume and
/// first moment of a trilinear element (polynomials of degree 2 and 3 in each direction; two Gauss points are exact to
/// degree 3).
Moments moments(const Mesh& mesh);

/// A ball centred at the origin. The centroid of half a ball lies at 3/8 of the radius from each cut plane.
Moments exact_sphere(double radius, const Half& half);

/// Axis z, lower end at the origin; a solid cylinder has inner_radius 0. The centroid of half a disk lies at 4 radius /
/// (3 pi) from each cut plane. Noses are integrated over 4096 conical slices: error below 1e-7.
Moments exact_tube(double inner_radius, double outer_radius, double length, const RoundForm& form);

/// Centre at the origin: 2 pi^2 radius (outer_radius^2 - inner_radius^2), by Pappus.
Moments exact_torus(double radius, double inner_radius, double outer_radius);

}  // namespace brunt::mesh
