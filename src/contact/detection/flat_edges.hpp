// SPDX-License-Identifier: Apache-2.0
// Rims across faces: if the mesh of a rim is coarser than that of the body below it, the rim passes between the nodes
// of that body, and none of its own nodes is near. Without these rows it penetrates by up to half of an element. The
// rim crosses the edges between the faces, although these are flat.
#pragma once
#include <optional>

#include "edge_scene.hpp"

namespace brunt::contact {

/// The meeting of a rim with an edge that lies within a face of the other body, if they touch or will within the step,
/// along the normal of that face. One of the two is flat. Where the flat edge ends at a rim of its own, the rims are in
/// contact instead.
std::optional<EdgeMeeting> cross_rim(const EdgeScene& scene, const EdgePair& pair);

}  // namespace brunt::contact
