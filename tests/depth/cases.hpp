// SPDX-License-Identifier: Apache-2.0
// Pairs of bodies with known penetration depths.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/triangle_surface.hpp"

namespace brunt::test {

/// A body and convex pieces that fill it (none: not known).
struct Shape {
  TriangleSurface surface;
  std::vector<std::vector<Vec3>> pieces;
};

struct DepthCase {
  std::string name;
  Shape a, b;
  Placement a_in_b;
  /// PDt, DISP, rms: best known values, and certified lower bounds (0: none).
  std::array<double, 3> depth{}, bound{};
};

/// x -> R x with R of the quaternion (w, x, y, z) of any length.
Mat3 turned(double w, double x, double y, double z);
/// exp(v)
Mat3 turned_by(const Vec3& v);

/// Section A: closed forms (A1 boxes, A2 to A6).
std::vector<DepthCase> closed_forms();
/// Section B: interlocked shapes made of boxes.
std::vector<DepthCase> interlocked_boxes();
/// Section D, fixed poses. The bounds are 0: those of the table are indicative only.
std::vector<DepthCase> mesh_pairs();

}  // namespace brunt::test
