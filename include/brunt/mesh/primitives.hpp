// SPDX-License-Identifier: Apache-2.0
// Generated bodies of hexahedra: one block named after the part, ids from 1, named node sets and side sets.
//
// A set PART_xmin is there twice under one name: as the nodes and as the element sides of that surface.
// Lengths are in the scene's unit. Each function throws InputError (one line a fault) where a length is not positive
// and finite, or an element count is too small or the mesh would outgrow 32-bit indices.
#pragma once
#include <array>
#include <string>

#include "brunt/mesh/division.hpp"
#include "brunt/mesh/mesh.hpp"
#include "brunt/mesh/round_form.hpp"

namespace brunt::mesh {

/// From the origin to `size`; nodes and elements in lexicographic order, x fastest.
/// Sets PART_xmin, _xmax, _ymin, _ymax, _zmin, _zmax.
Mesh box(const std::string& part, const Vec3& size, const Divisions<3>& elements);

/// In the x-y plane, centre of the lower face at the origin; order and sets as in `box`.
Mesh plate(const std::string& part, const std::array<double, 2>& size, double thickness, const Divisions<3>& elements);

/// Elements around a cylinder, and around a great circle of a sphere, that has so many across its radius: 8 for each
/// half cell of the core, which takes 0.6 of the radius; where sizes at places say how the radius is divided, 0.6 of
/// the first place above 0.
int elements_around(const Division& across_radius);

/// Solid, axis z, foot centre at the origin. elements: across the radius (>= 2), along the axis; around the whole there
/// are `elements_around`. The section is a butterfly: a rounded square core within rings; all its outer nodes lie on
/// the circle. Where sizes at places divide the radius, rings are circles from the first place above 0 on. A half (of
/// x, y) has the nodes and elements of the whole on its side. A sector of a solid cylinder is a tube's.
/// Sets PART_bottom, _top, _side; with a nose PART_nose, and PART_top if its tip is flat.
Mesh cylinder(const std::string& part, double radius, double length, const Divisions<2>& elements,
              const RoundForm& form = {});

/// Axis z, foot centre at the origin. elements: through the wall, around the whole (>= 3), along. A half (of x, y)
/// needs an even number around, a quarter a multiple of 4; its elements begin at a cut plane. Of a sector the elements
/// around are those within it; its inner radius may be 0: the elements at the axis are prisms, hexahedra with repeated
/// nodes, whose axis nodes lie in both cut planes.
/// Sets PART_bottom, _top, _side (outside), _inner (unless solid); with a nose as of a cylinder.
Mesh tube(const std::string& part, double inner_radius, double outer_radius, double length,
          const Divisions<3>& elements, const RoundForm& form = {});

/// What makes of a whole, even sphere another one.
struct SphereForm {
  double finer = 1;  ///< >= 1: elements at the lowest point are so many times smaller, at the highest larger
  Half half{};       ///< with `finer` along z only -1, the half with the fine pole
};

/// Solid, centre at the origin. elements: across the radius (>= 2). A rounded cube core within shells, each of its
/// faces projected from the centre with equal angles; `finer` moves the nodes by the conformal map of the ball onto
/// itself, which keeps the elements' shapes. Of a half along z only the pole is finer by so much, and the plane z = 0
/// stays where it is: there elements are up to 3 times as long along z as across. Sets PART_surface and PART_xmin, ...
/// for the halves' planes.
Mesh sphere(const std::string& part, double radius, int elements, const SphereForm& form = {});

/// Hollow, axis z, centre at the origin; `radius` of the circle on which the centres of the tube lie, > outer_radius.
/// elements: around the ring (>= 3), around the tube (>= 3), through the wall. Nodes lie on circles of the tube at
/// equal angles of the ring. Sets PART_side (outside), _inner.
Mesh torus(const std::string& part, double radius, double inner_radius, double outer_radius,
           const Divisions<3>& elements);

}  // namespace brunt::mesh
