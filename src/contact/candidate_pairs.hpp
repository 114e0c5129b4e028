// SPDX-License-Identifier: Apache-2.0
// Which slaves and masters of this rank and its ghosts may touch: the search of one rebuild, before contact nodes are
// numbered.
#pragma once
#include <span>
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/contact/ghosting.hpp"
#include "brunt/contact/lists.hpp"
#include "brunt/contact/surface/surface.hpp"

namespace brunt::contact {

/// What a rebuild knows.
struct ListBuild {
  const comm::Communicator& ranks;
  const Surface& surface;
  const PairTable& pairs;
  const Roles& roles;
  std::span<const Vec3> positions;  ///< of this rank's surface nodes
  const ListSettings& settings;
  ListScratch& scratch;

  [[nodiscard]] double finest_cell() const { return 2 * (surface.mean_edge + 2 * settings.motion); }
};

struct CandidatePair {
  LocalIndex slave = 0;   ///< surface node, or one of surface.edges
  LocalIndex master = 0;  ///< into the masters
};

template <class Traveller>
struct CandidatePairs {
  std::vector<Traveller> masters;    ///< of this rank and ghosts
  std::vector<CandidatePair> pairs;  ///< by slave, then master body and key (edges: gids)
};

/// Nodes near faces. Collective.
CandidatePairs<TravellingFace> find_face_pairs(const ListBuild& build);
/// Convex edges near convex edges of which one is sharp. Collective.
CandidatePairs<TravellingEdge> find_edge_pairs(const ListBuild& build);

}  // namespace brunt::contact
