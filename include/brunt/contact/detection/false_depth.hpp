// SPDX-License-Identifier: Apache-2.0
// False penetrations: beside a sharp edge a node may be far behind the plane of a face without having come through
// it, because it is still outside, or because it came in through the neighbour.
#pragma once
#include <span>

#include "brunt/contact/detection/encounter.hpp"

namespace brunt::contact {

/// Meeting::inside becomes Meeting::none where the surface of the body shows that its penetration is false. The sign of
/// the distance to a closed surface is that of its nearest point (the normals of faces that share it are added,
/// weighted with their angles there: Baerentzen and Aanaes, 2005). So a node that is outside there is not deep behind
/// another face, and one that is inside there came in there: faces around a convex edge that lie deeper by more than
/// the rim say nothing. A rim is left in doubt (`Tolerances::rim`): where sides of bodies are flush, rounding
/// decides which of two faces is nearer, and the slave's surface must oppose the nearest face for it to have a say.
/// encounters: of one slave with the faces of one body, with their opposition, after resolve_rim_projections.
void reject_false_depths(const FacesInMotion& scene, const Tolerances& tolerances, std::span<Encounter> encounters);

}  // namespace brunt::contact
