// SPDX-License-Identifier: Apache-2.0
// Ledges: under load a body settles slightly below its flush neighbour, which then protrudes. A node that slides over
// both meets the lateral face of the neighbour slightly below its upper edge. A row there would stop the body or
// reverse its motion.
#pragma once
#include <span>

#include "contact/data/tolerances.hpp"
#include "contact/detection/encounter.hpp"

namespace brunt::contact {

/// Lateral faces of ledges become Meeting::none. If a node moves into a face, but along the neighbouring face across a
/// convex edge, and is behind that face by no more than a ledge, only the neighbouring face is used, and the height is
/// recovered slowly (see required_rate). If the node moves equally into the neighbour, or hardly at all, there is no
/// ledge, and the nearest face is used. encounters: of one slave with the faces of one body, with their opposition,
/// after detect_path_hits.
void remove_lateral_faces_of_ledges(const FacesInMotion& scene, const NodeMotion& slave,
                                    std::span<Encounter> encounters);

/// Whether this motion in a step [length] is into the face of one normal, but along the face of the other. size:
/// longest edge [length].
inline bool slides_into(const Vec3& motion, const Vec3& normal, const Vec3& along, double size,
                        const Tolerances& tolerances) {
  const double into = -motion.dot(normal);
  return into > tolerances.rounding * size && -motion.dot(along) < tolerances.competing * into;
}

}  // namespace brunt::contact
