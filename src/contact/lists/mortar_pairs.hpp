// SPDX-License-Identifier: Apache-2.0
// Facets around slaves whose pairs have mortar rows, on the ranks that own these nodes, and the faces near them.
#pragma once
#include <span>
#include <vector>

#include "contact/lists/candidate_pairs.hpp"

namespace brunt::contact {

struct MortarPairs {
  std::vector<GhostFace> facets;     ///< around slaves owned here, on whichever rank, by key; capture: their own box
  std::vector<CandidatePair> pairs;  ///< slave: facet; by facet, then master body and key
};

/// Facets around the slaves of this rank. Collective.
std::vector<GhostFace> facets_around_slaves(const ListBuild& build);

/// Pairs of those facets with masters.
std::vector<CandidatePair> find_mortar_pairs(const ListBuild& build, std::span<const GhostFace> facets,
                                             std::span<const GhostFace> masters);

/// Where nodes of the surface are, by ascending gid. Collective.
std::vector<Place> homes_of(const comm::Communicator& ranks, const Surface& surface, std::span<const GlobalIndex> gids);

}  // namespace brunt::contact
