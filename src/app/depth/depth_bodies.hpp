// SPDX-License-Identifier: Apache-2.0
// Bodies for penetration depth: surfaces of files, or of the parts of a scene, checked and the same on every rank.
#pragma once
#include <string>
#include <vector>

#include "app/program/depth_options.hpp"
#include "comm/communicator.hpp"
#include "core/triangle_surface.hpp"
#include "scene/input.hpp"

namespace brunt::app {

struct NamedSurface {
  std::string name;  ///< of the file, or of the part
  TriangleSurface surface;
  std::vector<std::string> notes;  ///< what was merged, what crosses itself: on the root
};

/// Reads, merges and checks the surface of a file. merge: see DepthOptions. Collective; throws InputError on all ranks.
[[nodiscard]] NamedSurface read_closed_surface(const comm::Communicator& ranks, const std::string& path, double merge);

/// Surfaces of all parts of a scene, block by block. Collective; throws InputError on all ranks.
[[nodiscard]] std::vector<NamedSurface> surfaces_of_scene(const comm::Communicator& ranks, const scene::Input& input);

/// Convex pieces inside both bodies: a YAML file `{a: [[[x, y, z], ...], ...], b: ...}`, corners of each piece in the
/// coordinates of its body's file. Collective; throws InputError on all ranks.
struct ConvexPieces {
  std::vector<std::vector<Vec3>> a, b;
};
[[nodiscard]] ConvexPieces read_pieces(const std::string& path);

}  // namespace brunt::app
