// SPDX-License-Identifier: Apache-2.0
// Bodies put in their places and gathered into one mesh.
#pragma once
#include <array>
#include <string>

#include "brunt/mesh/mesh.hpp"

namespace brunt::mesh {

/// Cosine and sine, exact at multiples of 90 degrees.
std::array<double, 2> cosine_sine(double degrees);

/// About an axis of any length, right-handed; exact for multiples of 90 degrees about a coordinate axis.
Mat3 rotation(const Vec3& axis, double degrees);

/// x -> R(axis, degrees) (scale x) + at: scaled, then turned about the coordinate origin (right-handed), then moved.
/// Multiples of 90 degrees about a coordinate axis are exact. Throws InputError for a scale <= 0 (it would mirror the
/// elements), an axis of no length, or a value that is not finite.
void place(Mesh& mesh, double scale, const Vec3& axis, double degrees, const Vec3& at);

/// Adds `piece` as bodies of their own: nodes are not merged, even where they coincide. The names of its blocks and
/// sets get `prefix`; with one, an unnamed block is named prefix + id. Node and element ids follow after the largest in
/// `whole`, and stay as they are if `whole` is empty; a block id that is taken becomes the next free one.
/// Throws InputError where a block name, an unnamed block's id or a set name is taken: a prefix tells them apart.
void append(Mesh& whole, Mesh&& piece, const std::string& prefix = "");

}  // namespace brunt::mesh
