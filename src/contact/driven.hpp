// SPDX-License-Identifier: Apache-2.0
// Nodes that supports move through faces or walls of other bodies. Neither side can yield along the normal, so contact
// can only report them. The same of rows that no motion of the bodies between them can satisfy (see unmet.hpp).
#pragma once
#include <array>
#include <vector>

#include "contact/data/constraint.hpp"

namespace brunt::contact {

/// The first such node of a pair of blocks on this rank, and the largest depth of this pair.
struct DrivenMeeting {
  std::int32_t slave_block = 0, master_block = 0;  ///< for wall w: -1 - w
  double since = 0;                                ///< ContactLedger::clock when it was first so deep [time]
  GlobalIndex slave = no_index;                    ///< gid
  std::array<GlobalIndex, 4> corners{no_index, no_index, no_index, no_index};  ///< gids of the face; none of a wall
  std::array<double, 4> weights{};                                             ///< of the corners, sum 1
  double penetration = 0;                                                      ///< largest so far [length]
  double limit = 0;       ///< of the penetration, beyond which the run stops, at the first row [length]
  bool is_rigid = false;  ///< the limit is that of a rigid body, otherwise an element
  bool in_chain = false;  ///< bodies between them could move, but not so that all rows are satisfied
  [[nodiscard]] bool is_wall() const { return master_block < 0; }
  /// Whether it concerns these two blocks, in any order.
  [[nodiscard]] bool is_of(std::int32_t one, std::int32_t other) const {
    return (slave_block == one && master_block == other) || (slave_block == other && master_block == one);
  }
};

}  // namespace brunt::contact
