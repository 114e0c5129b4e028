// SPDX-License-Identifier: Apache-2.0
// Seams between bodies that were flush at the start (contact/joined/seams.hpp). Under load one body settles, and the
// lateral face of the other one is exposed. For other bodies that face begins only at the depth of the possible
// settlement: down to there, the normal cone of the edge is that of the face that continues beyond it.
#pragma once
#include <span>

#include "contact/detection/edges.hpp"
#include "contact/detection/encounter.hpp"

namespace brunt::contact {

/// The faces of a slave's own body around it.
struct OwnFacets {
  std::span<const LocalIndex> facets;  ///< rows of facet_normal
  std::span<const double>
      seam_sag;  ///< of each: settlement of a seam that ends in the slave, 0: none [length]; or empty
  std::span<const Vec3> facet_normal;
};

/// Lateral faces of seams become Meeting::none if the node is no farther than Tolerances::max_penetration from the
/// plane of the continuing face: either one of the master's, or one of the slave's own faces that continues and lies on
/// the master's face. encounters: of one slave with the faces of one body that is flush with bodies other than the
/// slave's.
void remove_lateral_faces_of_seams(const FacesInMotion& scene, const OwnFacets& own, std::span<Encounter> encounters);

struct EdgeScene;
struct EdgePair;
struct EdgeMeeting;

/// Whether the edges meet at the lateral face of a seam that one of them forms, or below which one of them ends, where
/// the other one reaches no farther below it.
bool meet_at_lateral_face_of_seam(const EdgeScene& scene, const EdgePair& pair, const EdgeMeeting& met);

}  // namespace brunt::contact
