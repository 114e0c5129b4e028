// SPDX-License-Identifier: Apache-2.0
// Generated bodies of hexahedra: one block named after the part, ids from 1, named node sets and side sets.
//
// A set PART_xmin exists twice under one name: as the nodes and as the element sides of that surface. Lengths are in
// the unit of the scene. Each function throws InputError (one line for each fault) if a length is not positive and
// finite, the number of elements is too small, or the mesh would exceed 32-bit indices.
#pragma once
#include <array>
#include <string>

#include "mesh/division.hpp"
#include "mesh/mesh.hpp"
#include "mesh/round_form.hpp"

namespace brunt::mesh {

/// From the origin to `size`; nodes and elements in lexicographic order, x fastest.
/// Sets PART_xmin, _xmax, _ymin, _ymax, _zmin, _zmax.
Mesh box(const std::string& part, const Vec3& size, const Divisions<3>& elements);

/// In the x-y plane, centre of the lower face at the origin; order and sets as in `box`.
Mesh plate(const std::string& part, const std::array<double, 2>& size, double thickness, const Divisions<3>& elements);

/// Number of elements around a cylinder, or around a great circle of a sphere: 8 for each half cell of the core, which
/// takes 0.6 of the radius. If sizes at places divide the radius, the core takes 0.6 of the first place above 0.
int elements_around(const Division& across_radius);

/// Solid cylinder, axis z, centre of the lower end at the origin. elements: across the radius (>= 2) and along the
/// axis; the number around is `elements_around`. The section is a butterfly mesh: a rounded square core within rings;
/// all its outer nodes lie on the circle. If sizes at places divide the radius, rings are circles from the first place
/// above 0. A half (in x, y) has the nodes and elements of the complete body on its side. A sector is available for
/// tubes only. Sets PART_bottom, _top, _side; with a nose PART_nose, and PART_top if its tip is flat.
Mesh cylinder(const std::string& part, double radius, double length, const Divisions<2>& elements,
              const RoundForm& form = {});

/// Tube, axis z, centre of the lower end at the origin. elements: through the wall, around the complete circle (>= 3),
/// along. A half (in x, y) needs an even number around, a quarter a multiple of 4; its elements begin at a cut plane.
/// In a sector, the elements around are those within it. Its inner radius may be 0: the elements at the axis are then
/// prisms, hexahedra with repeated nodes, whose axis nodes lie in both cut planes. Sets PART_bottom, _top, _side
/// (outside), _inner (unless solid); with a nose as for a cylinder.
Mesh tube(const std::string& part, double inner_radius, double outer_radius, double length,
          const Divisions<3>& elements, const RoundForm& form = {});

/// Modifications of a complete, uniform sphere.
struct SphereForm {
  double finer = 1;  ///< >= 1: elements at the lowest point are smaller by this factor, those at the highest larger
  Half half{};       ///< with `finer` along z only -1, the half with the fine pole
};

/// Solid sphere, centre at the origin. elements: across the radius (>= 2). A rounded cube core within shells; each face
/// of the cube is projected from the centre with equal angles. `finer` moves the nodes by the conformal map of the ball
/// onto itself, which preserves the shapes of the elements. For a half along z, only the pole is refined by this
/// factor, and the plane z = 0 is unchanged: elements there are up to 3 times as long along z as across. Sets
/// PART_surface, and PART_xmin, ... for the planes of halves.
Mesh sphere(const std::string& part, double radius, int elements, const SphereForm& form = {});

/// Hollow torus, axis z, centre at the origin. `radius`: of the circle of the tube's centres, > outer_radius. elements:
/// around the ring (>= 3), around the tube (>= 3), through the wall. Nodes lie on circles of the tube at equal angles
/// of the ring. Sets PART_side (outside), _inner.
Mesh torus(const std::string& part, double radius, double inner_radius, double outer_radius,
           const Divisions<3>& elements);

}  // namespace brunt::mesh
