// SPDX-License-Identifier: Apache-2.0
// Ties by weights that are integrated over the segments of facets (contact/TIES.md). The weights are those of the start
// and of the elements that remain: a function of these alone, so that a restart finds the same bits without saving
// them.
#pragma once
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/ragged.hpp"
#include "core/types.hpp"

namespace brunt::contact {

/// One row of a slave node.
struct MortarTie {
  GlobalIndex slave = 0;                                    ///< gid
  std::int32_t body = 0;                                    ///< of the master
  std::int32_t number = 0;                                  ///< among the rows of the node with this body
  std::int32_t slave_body = 0, slave_block = 0, block = 0;  ///< block: the lowest one of the master's faces
  std::int32_t weighted = 0;                                ///< leading terms whose weight is not zero
  /// Master's terms at the place below the node, -1 to fill; none where the node lies beside the faces.
  std::array<std::int32_t, 4> below{-1, -1, -1, -1};
  bool apart = false;  ///< some facet has a height
  double area = 0;     ///< integral of the row's function [length^2]
  double size = 0;     ///< longest edge of the facets [length]
};

/// A slave facet of a row.
struct TiedFacet {
  std::array<std::int32_t, 4> corner{};  ///< among the row's terms, counter-clockwise seen from outside
  std::int32_t corner_count = 0;
  double share = 0;   ///< of the row's area
  double height = 0;  ///< part of the row's offset along the facet's unit normal [length]
};

/// Slave facet and master face, keys.
using TiedPair = std::pair<GlobalIndex, GlobalIndex>;
/// Slave node (gid) and body of the master.
using TiedNode = std::pair<GlobalIndex, std::int32_t>;

/// Of slaves owned here. Terms of a row: the slave node, the master's nodes in ascending gid, other nodes of the
/// slave's surface likewise, those without weight last.
struct MortarTies {
  std::vector<MortarTie> rows;  ///< in ascending order of slave, body and number
  Ragged<GlobalIndex> nodes;    ///< of each row's terms, gids
  std::vector<double> weights;  ///< of the same, of sum 1 over the slave's nodes and -1 over the master's
  Ragged<TiedFacet> facets;     ///< of each row
  std::vector<TiedNode> held;   ///< nodes of facets that are covered, whether they have a row or not; ascending
  std::vector<TiedPair> pairs;  ///< that have a segment; ascending
};

}  // namespace brunt::contact
