// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "geometry/triangles/slab_tree.hpp"

namespace brunt::geometry {

/// Triangles whose height is less than this share of their longest edge have no defined normal: the rounding of their
/// corners rotates it by more than 1e-6.
constexpr double clear_height = 1e-10;

/// Of all features of all triangles; coincident corners are one corner.
std::vector<TriangleNormals> pseudo_normals(std::span<const Triangle> triangles);

}  // namespace brunt::geometry
