// SPDX-License-Identifier: Apache-2.0
// Penetration depth of convex pairs: a scene, and the libraries that are asked about it.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "core/triangle_surface.hpp"

namespace brunt::bench {

struct ConvexScene {
  std::vector<TriangleSurface> bodies;
  struct Pair {
    std::size_t a, b;
    Placement a_in_b;
    double exact = 0;  ///< PDt [length]
  };
  std::vector<Pair> pairs;
};

/// Writes the depth of each pair [length]; NaN where the library finds no overlap.
using ConvexDepths = std::function<void(std::span<double>)>;

// Each prepares its own form of the bodies. `tolerance` is the library's own setting: its default, or one for
// precision.
ConvexDepths ccd_epa(const ConvexScene& scene, double tolerance);
ConvexDepths ccd_mpr(const ConvexScene& scene, double tolerance);
/// fcl::collide of two fcl::Convex with one contact; `libccd` chooses that solver, else FCL's own.
ConvexDepths fcl_convex(const ConvexScene& scene, bool libccd, double tolerance);

/// Two meshes and placements of one in the other: does fcl::collide find that they cross? For meshes it reports the
/// depth of single pairs of triangles, so that only the answer yes or no can be compared.
struct MeshScene {
  TriangleSurface a, b;
  std::vector<Placement> placements;
};
using MeshCollisions = std::function<void(std::span<char>)>;
MeshCollisions fcl_meshes(const MeshScene& scene);

}  // namespace brunt::bench
