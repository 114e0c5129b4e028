// SPDX-License-Identifier: Apache-2.0
// A surface as faces, edges and vertices, each with its normal cone. The feature nearest to a node, and the sign of its
// distance, determine whether the node is inside, and through which faces it may have entered.
#pragma once
#include <span>

#include "contact/data/options.hpp"
#include "contact/detection/encounter.hpp"

namespace brunt::contact {

/// Keeps `inside` and `above` where the surface as a whole admits them; otherwise the encounter becomes
/// Meeting::deferred or Meeting::none. The zones of a face are on the page (README.md, "Zones around a face").
///
/// In front of a face (zones 1 to 3), a node is above it if its projection lies on the face, or beside it by at most
/// the rim if no other admissible face of the same edge or vertex has the node in front. Otherwise the node is in the
/// cone of the edge, and touches it by a hit.
///
/// Behind a face (zones 4 to 6), a node is inside if its projection lies on the face, or beside it by at most the rim,
/// or if it is nearest to a concave edge or vertex around which all faces are within reach. The penetration is false,
/// however, if a feature nearer to the node has it outside, or inside by less: the node entered there. The sign of the
/// distance to that feature is that of its angle-weighted normal (Baerentzen and Aanaes, IEEE Trans. Vis. Comput.
/// Graph. 11 (2005) 243). Features that the slave's own cone does not admit count only for penetrations deeper than the
/// rim with the node clearly in front of them: lateral faces of flush bodies slide and bulge, and rounding would decide
/// on which side a node is. encounters: of one slave with the faces of one body, with their opposition. criterion:
/// penetrations through nearer features compete unless it is `automatic`.
void resolve_features(const FacesInMotion& scene, Criterion criterion, std::span<Encounter> encounters);

}  // namespace brunt::contact
