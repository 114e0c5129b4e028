// SPDX-License-Identifier: Apache-2.0
// Rims across faces: where a rim's mesh is coarser than that of the body it presses, it lies between that body's nodes,
// and none of its own is near. It sank in there by half of an element (a punch of one element in a block of nine).
// What it crosses then are the edges between the faces, flat as they are.
#pragma once
#include "edge_scene.hpp"

namespace brunt::contact {

/// Do a rim and an edge that lies within a face of the other body touch, or will within the step? Along the normal of
/// that face. One of the two is flat. Where the flat edge ends at a rim of its own, rims meet. met: where, if so.
bool rim_crosses_flat(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master, double size,
                      EdgeMeeting& met);

}  // namespace brunt::contact
