// SPDX-License-Identifier: Apache-2.0
// Exchange between ranks as seen by enforcement, which does not know about ranks. Arrays have `width` doubles for each
// contact node of this rank; a node has one owner and any number of copies.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/sorted.hpp"

namespace brunt::contact {

/// Of contact nodes, `width` doubles each.
struct NodeValues {
  std::span<double> values;
  int width = 0;
};

class Exchange {
 public:
  virtual ~Exchange() = default;
  /// Copies the owner's values to its copies.
  virtual void share(std::span<double> values, int width) = 0;
  /// The owner's value becomes the sum over all copies; copies are unchanged. Only for values whose sums are exact
  /// (slices of binned sums, counts), so that the order does not matter.
  virtual void sum_to_owner(std::span<double> values, int width) = 0;
  /// Exchanges two arrays at once.
  virtual void share_both(const NodeValues& one, const NodeValues& other) {
    share(one.values, one.width);
    share(other.values, other.width);
  }
  virtual void sum_both_to_owner(const NodeValues& one, const NodeValues& other) {
    sum_to_owner(one.values, one.width);
    sum_to_owner(other.values, other.width);
  }
  /// Maximum over all ranks, element by element, in place.
  virtual void max(std::span<double> values) = 0;
  /// The maximum of `largest` and the sums of `sums` over all ranks in one message; at most six of each.
  virtual void reduce(std::span<double> largest, std::span<std::int64_t> sums) = 0;
  /// Sums over all ranks, element by element, in place: any number of them in one message.
  virtual void sum(std::span<std::int64_t> values) = 0;
  /// The owner's value becomes the maximum over all copies; copies are unchanged. Of one rank: nothing to do.
  virtual void max_to_owner(std::span<double> /*values*/, int /*width*/) {}
  /// The distinct values of all ranks, ascending, in place of this rank's. It allocates memory: not for ordinary steps.
  virtual void unite(std::vector<double>& values) { sort_unique(values); }
};

/// One rank with all nodes: nothing to exchange.
class OneRankExchange final : public Exchange {
 public:
  void share(std::span<double> /*values*/, int /*width*/) override {}
  void sum_to_owner(std::span<double> /*values*/, int /*width*/) override {}
  void max(std::span<double> /*values*/) override {}
  void reduce(std::span<double> /*largest*/, std::span<std::int64_t> /*sums*/) override {}
  void sum(std::span<std::int64_t> /*values*/) override {}
};

}  // namespace brunt::contact
