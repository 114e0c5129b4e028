// SPDX-License-Identifier: Apache-2.0
// Ledges: where a body slides from one to another that lies flush with it, the first has settled by a little under the
// load, and the second stands out by so much. A node that slides along comes to the side of the second then, a hair
// below its edge, and a row there would stop the body dead, or throw it back.
#pragma once
#include <span>

#include "brunt/contact/data/tolerances.hpp"
#include "brunt/contact/detection/encounter.hpp"

namespace brunt::contact {

/// Sides of ledges become Meeting::none: a node that moves into a face, but along the neighbour across a convex edge,
/// and is behind that by no more than a ledge, is left to the neighbour, which takes back the height slowly (see
/// required_rate). What moves as much into the neighbour, or hardly at all, has no ledge: there the nearest face holds.
/// encounters: of one slave with the faces of one body, with their opposition, after detect_path_hits.
void remove_ledge_sides(const FacesInMotion& scene, const Tolerances& tolerances, const NodeMotion& slave,
                        std::span<Encounter> encounters);

/// Does what moves like this in a step [length] move into what has one normal, but along what has the other?
/// size: longest edge [length].
inline bool slides_into(const Vec3& motion, const Vec3& normal, const Vec3& along, double size,
                        const Tolerances& tolerances) {
  const double into = -motion.dot(normal);
  return into > tolerances.rounding * size && -motion.dot(along) < tolerances.competing * into;
}

}  // namespace brunt::contact
