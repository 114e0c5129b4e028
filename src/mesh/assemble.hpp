// SPDX-License-Identifier: Apache-2.0
// Placement of bodies and their assembly into one mesh.
#pragma once
#include <array>
#include <string>

#include "mesh/mesh.hpp"

namespace brunt::mesh {

/// Cosine and sine, exact at multiples of 90 degrees.
std::array<double, 2> cosine_sine(double degrees);

/// About an axis of any length, right-handed; exact for multiples of 90 degrees about a coordinate axis.
Mat3 rotation(const Vec3& axis, double degrees);

/// x -> R(axis, degrees) (scale x) + at: scaling, then a right-handed rotation about the coordinate origin, then a
/// translation. Multiples of 90 degrees about a coordinate axis are exact. Throws InputError for a scale <= 0 (it would
/// mirror the elements), a zero axis, or a value that is not finite.
void place(Mesh& mesh, double scale, const Vec3& axis, double degrees, const Vec3& at);

/// Adds `piece` as separate bodies: nodes are not merged, even if they coincide. The names of its blocks and sets are
/// preceded by `prefix`; with a prefix, an unnamed block is named prefix + id. Node and element ids follow the largest
/// ones of `whole`, and are unchanged if `whole` is empty. A block id that is in use is replaced by the next free one.
/// Throws InputError if a block name, the id of an unnamed block, or a set name is in use: a prefix distinguishes them.
/// file: the mesh file that is read; empty: a generated body.
void append(Mesh& whole, Mesh&& piece, const std::string& prefix = "", const std::string& file = "");

}  // namespace brunt::mesh
