// SPDX-License-Identifier: Apache-2.0
// Nodal sums with the same bits on any number of ranks. The key of a contribution (a corner force of an element, a
// share of a pressure load) does not depend on the partition. Every rank that holds a node receives all its
// contributions separately and adds them in ascending order of keys, starting from zero.
#pragma once
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/halo.hpp"
#include "core/cells.hpp"
#include "core/ragged.hpp"

namespace brunt::comm {

/// A contribution of this rank to a node that other ranks also hold.
struct Contribution {
  GlobalIndex key = 0;  ///< orders the sum; unique for a node (cells::key_of its element and corner)
  GlobalIndex node_gid = 0;
  LocalIndex node = 0;  ///< local index of the node
};

class OrderedSum {
 public:
  OrderedSum() = default;
  /// `contributions[i]` is stored in slot i of the array passed to `sum`; only nodes in `shared` are used. shared_node:
  /// local indices of nodes that other ranks also hold; sharers: these ranks, row by row. Collective.
  OrderedSum(const Communicator& ranks, std::span<const Contribution> contributions,
             std::span<const LocalIndex> shared_node, std::span<const GlobalIndex> shared_gid,
             const Ragged<Rank>& sharers);

  /// Sends the slots to the sharers. Work on interior elements may be done between begin and end.
  void begin(std::span<const double> slots, int width);
  /// node_values[node * stride + c] = ordered sum, for every shared node and c < width. Does not allocate.
  void end(std::span<const double> slots, int width, std::span<double> node_values, int stride);

  [[nodiscard]] std::span<const LocalIndex> shared_nodes() const { return shared_node_; }

 private:
  Halo halo_;  // slots of other ranks -> received_
  std::vector<LocalIndex> shared_node_;
  Ragged<LocalIndex> terms_;      // per shared node: slot index, or received index + number of own slots, by key
  std::vector<double> received_;  // sized for the widest sum
};

}  // namespace brunt::comm
