// SPDX-License-Identifier: Apache-2.0
// The candidate lists of one rank: nodes and faces that may touch until the admissible motion is used up, their contact
// nodes, and the links to copies on other ranks.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/halo.hpp"
#include "contact/detection/detection.hpp"
#include "contact/detection/edges.hpp"
#include "contact/lists/halo_exchange.hpp"
#include "contact/mortar_rows/candidates.hpp"
#include "contact/search/box_overlaps.hpp"
#include "contact/search/methods.hpp"
#include "contact/surface/surface.hpp"

namespace brunt::contact {

/// Contact nodes in ascending gid: slaves and wall candidates owned here, corners of candidate faces, and nodes owned
/// here that other ranks need.
struct NodeTable {
  std::vector<GlobalIndex> gid;
  std::vector<Place> home;               ///< surface node on the owner
  std::vector<LocalIndex> surface_node;  ///< here, or no_index where this rank's mesh does not have it
};

struct ContactLists {
  NodeTable nodes;
  std::vector<MasterFace> faces;
  Candidates candidates;
  EdgeCandidates edges;
  MortarCandidates mortar;
  std::vector<WallCandidate> wall_candidates;  ///< ordered by (wall, node)
  Ragged<LocalIndex> wall_facets;              ///< of each of them, as Candidates::slave_facets; empty if not needed
  HaloExchange exchange;
  comm::Halo facets;  ///< roots: area vectors of this rank's surface faces; leaves: facets of slaves, edges
  std::vector<char> facet_needed;  ///< surface faces whose area vector some rank needs
  LocalIndex facet_count = 0;
  bool any_facets = false;  ///< on any rank: otherwise there are no candidates
  bool any_rows = false;    ///< on any rank: candidates exist
  bool any_edges = false;   ///< on any rank: pairs of edges exist
  std::size_t most_rows = 0, most_faces_of_a_slave = 0;
};

/// Pairs of facets and faces that lists contain.
enum class FacetPairs : std::int8_t {
  none,
  mortar,  ///< of pairs with mortar rows
  tied     ///< of tied pairs, at the start
};

struct ListSettings {
  const Tolerances* tolerances = &standard_tolerances;  ///< lists contain everything within its reach
  double wall_capture = 0;                              ///< [length]
  double motion = 0;        ///< admissible motion of each node and wall [length], including the coming step
  bool faces = true;        ///< search faces at all
  bool two_passes = false;  ///< some pair has two passes
  FacetPairs facets = FacetPairs::none;  ///< whose facets may share segments
  bool keeps = false;                    ///< on any rank rows may be kept, of mortar rows or ties
  std::span<const GlobalIndex> kept{};   ///< nodes of kept mortar rows, which stay contact nodes; ascending
  std::span<const GlobalIndex> tied{};   ///< the same of ties
  std::size_t tied_rows = 0;             ///< of this rank, with integrated weights
  bool wall_facets = false;              ///< areas around nodes near walls are wanted
  std::span<const double> thickness{};   ///< thickness of blocks that are sheets, see ContactSettings [length]
  SearchMethod search = SearchMethod::automatic;

  [[nodiscard]] double thickness_of(std::int32_t block) const {
    return static_cast<std::size_t>(block) < thickness.size() ? nth(thickness, block) : 0.0;
  }
  /// The largest clearance between a node and a face.
  [[nodiscard]] double most_clearance() const { return thickness.empty() ? 0.0 : std::ranges::max(thickness); }
};

/// Data that a search reuses from earlier ones; results do not depend on it.
struct ListScratch {
  MethodScratch faces;
  OverlapScratch bodies, rims, edges, facets;
};

/// positions: of this rank's surface nodes. held(wall, surface node) as flags, wall by wall; empty without walls.
/// Collective.
ContactLists build_lists(const comm::Communicator& ranks, const Surface& surface, const Specification& specification,
                         const Roles& roles, std::span<const Vec3> positions, std::span<const Wall> walls,
                         std::span<const char> held, const ListSettings& settings, ListScratch& scratch);

}  // namespace brunt::contact
