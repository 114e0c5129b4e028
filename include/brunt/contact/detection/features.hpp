// SPDX-License-Identifier: Apache-2.0
// One picture of a surface: faces, edges and vertices, each with its normal cone. The feature that is nearest to a
// node, and the sign of its distance there, say whether the node is inside, and through which faces it may have come.
#pragma once
#include <span>

#include "brunt/contact/data/options.hpp"
#include "brunt/contact/detection/encounter.hpp"

namespace brunt::contact {

/// Leaves `inside` and `above` where the surface as a whole allows them; the other meetings become Meeting::none.
///
/// In front of a face a node is above it where its foot lies on the face, or beside it by at most `rim` where no other
/// admissible face of the same edge or vertex has the node in front: there it is in the cone of the edge, and meets it
/// by a hit.
///
/// Behind a face a node is inside where its foot lies on the face, beside it by at most `rim`, or nearest to a concave
/// edge or vertex. But the penetration is false where the surface falls away to a feature nearer to the node that has
/// it outside, or inside by less: it came in there. The sign of the distance to that feature is that of its
/// angle-weighted normal (Baerentzen and Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005) 243). Features that the
/// slave's own cone does not admit have a say only for penetrations deeper than `rim`, where the node is clearly in
/// front of them: sides of flush bodies slide and bulge, and rounding decides on which side of them a node is. A face
/// around a smooth edge is left as `above`, since it shares in the normal of the row (see select_rows).
///
/// encounters: of one slave with the faces of one body, with their opposition. criterion: penetrations through nearer
/// features compete where it is another than `automatic`.
void resolve_features(const FacesInMotion& scene, const Tolerances& tolerances, Criterion criterion,
                      std::span<Encounter> encounters);

}  // namespace brunt::contact
