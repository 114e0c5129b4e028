// SPDX-License-Identifier: Apache-2.0
// Sharp edges at a ledge (see ledges.hpp) are ignored as nodes are.
#pragma once
#include "edge_scene.hpp"

namespace brunt::contact {

/// Edges nearly along each other of which one slides along a face of the other; an edge that stands with its end on the
/// surface along which it slides. near: of the slave edge. holds: as of detect_edges.
bool meet_on_ledge(const EdgeScene& scene, const EdgeCandidates& candidates, std::span<const LocalIndex> near,
                   std::span<const NodeHold> holds, const ContactEdge& slave, const ContactEdge& master,
                   const EdgeMeeting& met);

}  // namespace brunt::contact
