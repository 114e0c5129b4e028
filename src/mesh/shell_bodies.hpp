// SPDX-License-Identifier: Apache-2.0
// Generated bodies of shells: surfaces of quadrilaterals in one block named after the part, ids from 1, with node sets
// and side sets as of the solid bodies (mesh/primitives.hpp).
//
// A side set contains the tops (face 0) or the bottoms (face 1) of elements, so that a positive pressure pushes into
// the body that the surface bounds, as on a solid body. Lengths are in the unit of the scene. Each function throws
// InputError as those of the solid bodies do.
#pragma once
#include <array>
#include <string>

#include "mesh/division.hpp"
#include "mesh/mesh.hpp"
#include "mesh/primitives.hpp"
#include "mesh/round_form.hpp"

namespace brunt::mesh {

/// In the plane z = 0, centre at the origin, normal +z; elements along x and y, x fastest. Sets: the edges PART_xmin,
/// _xmax, _ymin, _ymax (nodes); PART_zmax, _zmin: all nodes, and the tops and bottoms.
Mesh shell_plate(const std::string& part, const std::array<double, 2>& size, const Divisions<2>& elements);

/// Cylindrical surface, axis z, centre of the lower end at the origin, normal outwards; elements around the complete
/// circle (>= 3; in a sector those within it) and along. A half or quarter as of a solid tube; no nose. Sets:
/// the edges PART_bottom, _top and those in planes of a cut (nodes); PART_side, _inner: all nodes, and the tops and
/// bottoms.
Mesh shell_tube(const std::string& part, double radius, double length, const Divisions<2>& elements,
                const RoundForm& form = {});

/// Sides of a box, in the order xmin, xmax, ymin, ymax, zmin, zmax.
using BoxSides = std::array<bool, 6>;

/// The sides of the box from the origin to `size` that are not open, normals outwards; they share the nodes of their
/// edges. Sets PART_xmin, ..., _zmax: all nodes on that side, and the tops of its elements unless it is open. At least
/// one side is not open.
Mesh shell_box(const std::string& part, const Vec3& size, const Divisions<3>& elements, const BoxSides& open = {});

/// The surface of `sphere` with these parameters, normals outwards. Sets PART_surface: all nodes, and the
/// tops; and the edges in the planes of halves (nodes).
Mesh shell_sphere(const std::string& part, double radius, int elements, const SphereForm& form = {});

/// Splits each quadrilateral of a block of shells into two triangles, numbered in the order of the quadrilaterals.
/// Neighbours have alternating diagonals: those of a grid meet in every second node, like the stripes of a flag. Side
/// sets follow.
void split_into_triangles(Mesh& mesh);

}  // namespace brunt::mesh
