// SPDX-License-Identifier: Apache-2.0
// Sharp edges at a ledge (see ledges.hpp) are ignored as nodes are.
#pragma once
#include <optional>

#include "edge_scene.hpp"

namespace brunt::contact {

/// Edges nearly along each other of which one slides along a face of the other; an edge that stands with its end on the
/// surface along which it slides. near: of the slave edge. holds: as of detect_edges.
bool meet_on_ledge(const EdgeScene& scene, const EdgeCandidates& candidates, std::span<const LocalIndex> near,
                   std::span<const NodeHold> holds, const ContactEdge& slave, const ContactEdge& master,
                   const EdgeMeeting& met);

/// The normal, out of the master, of a face on which one of two nearly parallel edges lies, with both ends held along
/// it by whatever bodies: as where a block slides over the seam of two plates. The edges meet along this normal: a row
/// along the mean of their faces' normals would push against the sliding.
std::optional<Vec3> face_below(const EdgeScene& scene, std::span<const NodeHold> holds, const ContactEdge& slave,
                               const ContactEdge& master);

}  // namespace brunt::contact
