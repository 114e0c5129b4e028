// SPDX-License-Identifier: Apache-2.0
// Sharp edges at ledges (see ledges.hpp). As nodes do, they slide over a ledge without a row.
#pragma once
#include <optional>

#include "edge_scene.hpp"

namespace brunt::contact {

/// Whether the edges meet at a ledge over which they slide: nearly parallel edges of which one slides along a face of
/// the other, or an edge that stands with its end on the surface along which it slides. near: candidates of the slave
/// edge.
bool is_on_ledge(const EdgeScene& scene, const EdgePair& pair, const EdgeMeeting& met,
                 std::span<const LocalIndex> near);

/// The normal, out of the master, of a face on which one of two nearly parallel edges lies, if both of its ends have
/// rows along this normal with any body: a block that slides over the seam of two plates has rows with both. The edges
/// meet along this normal: a row along the mean of their faces' normals would act against the sliding.
std::optional<Vec3> face_below(const EdgeScene& scene, const EdgePair& pair);

}  // namespace brunt::contact
