// SPDX-License-Identifier: Apache-2.0
// Slaves and masters of this rank and its ghosts that may touch: the search of one rebuild, before contact nodes are
// numbered.
#pragma once
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "contact/lists/ghosting.hpp"
#include "contact/lists/lists.hpp"
#include "contact/surface/surface.hpp"

namespace brunt::contact {

/// What a rebuild knows.
struct ListBuild {
  const comm::Communicator& ranks;
  const Surface& surface;
  const Specification& specification;
  const Roles& roles;
  std::span<const Vec3> positions;  ///< of this rank's surface nodes
  const ListSettings& settings;
  ListScratch& scratch;

  [[nodiscard]] const Vec3& position(LocalIndex node) const { return nth(positions, node); }
  [[nodiscard]] double finest_cell() const { return 2 * (surface.mean_edge + 2 * settings.motion); }
};

struct CandidatePair {
  LocalIndex slave = 0;   ///< surface node, or one of surface.edges
  LocalIndex master = 0;  ///< into the masters
};

template <class Ghost>
struct CandidatePairs {
  std::vector<Ghost> masters;        ///< of this rank and ghosts
  std::vector<CandidatePair> pairs;  ///< by slave, then master body and key (edges: gids)
};

/// The reach of detection from a master with this longest edge, after both sides have moved towards each other by the
/// admissible motion (which may stretch an edge by twice this).
geometry::Box capture_box(const ListBuild& build, std::span<const Vec3> corners, double edge, double element_depth);

template <class Ghost>
std::vector<geometry::Box> capture_boxes(const std::vector<Ghost>& masters) {
  std::vector<geometry::Box> boxes;
  boxes.reserve(masters.size());
  for (const Ghost& master : masters) boxes.push_back(master.capture.box());
  return boxes;
}

/// Those of other ranks that may touch a `wanted` box. Collective.
template <class Ghost>
void add_ghosts(const ListBuild& build, std::span<const geometry::Box> wanted, std::vector<Ghost>& masters) {
  const std::vector<Ghost> ghosts = ghost(build.ranks, std::span<const Ghost>(masters), wanted, build.finest_cell());
  masters.insert(masters.end(), ghosts.begin(), ghosts.end());
}

/// Nodes near faces. also: boxes of facets whose masters are wanted besides. Collective.
CandidatePairs<GhostFace> find_face_pairs(const ListBuild& build, std::span<const geometry::Box> also = {});
/// Edges near edges of which one is sharp. Collective.
CandidatePairs<GhostEdge> find_edge_pairs(const ListBuild& build);

}  // namespace brunt::contact
