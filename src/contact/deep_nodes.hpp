// SPDX-License-Identifier: Apache-2.0
// How deep nodes and sharp edges lie in other bodies, by their positions in elements alone: independent of candidate
// lists, rows and their history, so it also finds what contact has lost.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact.hpp"
#include "contact/lists/ghosting.hpp"
#include "core/cells.hpp"

namespace brunt::contact {

/// A hexahedron or tetrahedron that lives, with its corners at x_n.
struct GhostElement {
  GlobalIndex gid = 0;
  std::array<GlobalIndex, cells::most_corners> nodes{};  ///< gids, no_index to fill
  std::array<std::array<double, 3>, cells::most_corners> corner{};
  std::int32_t corner_count = 8, block = 0;
  PlainBox capture{};  ///< around it

  friend bool operator<(const GhostElement& a, const GhostElement& b) { return a.gid < b.gid; }
};

/// A node, or a point of an edge that is named by one of its ends, inside an element of another body or of its own one
/// that its elements do not touch.
struct DeepNode {
  GlobalIndex node = no_index;             ///< gid
  std::int32_t node_block = 0, block = 0;  ///< the other: of the element
  double depth = 0;                        ///< distance to the nearest exterior face of that body [length]
  double share = 0;                        ///< of the depth of the element behind that face, or its width if less
  bool on_edge = false;                    ///< it is a point of an edge
};

struct DeepNodes {
  GlobalIndex count = 0;         ///< nodes, and edges with such a point, whose share is above the limit
  DeepNode worst{};              ///< the largest share
  std::vector<double> shares{};  ///< of each node of this rank, then of each sharp edge; the largest, 0: in no element
};

/// The surface that is looked at, with what may meet.
struct WatchedSurface {
  const comm::Communicator& ranks;
  const Surface& surface;
  const PairTable& pairs;
  std::span<const double> thickness{};  ///< of blocks: > 0 of sheets, which have no inside [length]; or empty
  const Tolerances& tolerances;
};

WatchedSurface watched_surface(const Contact& contact);

/// position: of the mesh's local nodes, x_n. elements: of this rank. above: share from which nodes count. Pairs that
/// may not meet or are tied are left out. The same on every rank. Collective.
DeepNodes find_deep_nodes(const WatchedSurface& watched, const VectorView& position,
                          const std::vector<GhostElement>& elements, double above);

}  // namespace brunt::contact
