// SPDX-License-Identifier: Apache-2.0
// Surfaces of parts in triangles, on the outer side of warped faces.
#pragma once
#include "core/triangle_surface.hpp"
#include "mesh/mesh.hpp"

namespace brunt::app {

/// The surface of one block in triangles: for a warped face, the diagonal with the larger volume of the body. Points
/// are the nodes of the surface alone.
[[nodiscard]] TriangleSurface outer_surface(const mesh::Mesh& mesh, std::size_t block);

}  // namespace brunt::app
