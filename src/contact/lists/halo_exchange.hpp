// SPDX-License-Identifier: Apache-2.0
// The exchange of contact nodes between ranks.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/halo.hpp"
#include "contact/data/exchange.hpp"
#include "core/types.hpp"

namespace brunt::contact {

/// Links between the contact nodes of this rank and those of others.
struct NodeLinks {
  std::vector<LocalIndex> copies;             ///< contact nodes owned elsewhere
  std::vector<comm::RemoteSlot> source;       ///< of each copy: the contact node on its owner
  std::vector<LocalIndex> copied;             ///< contact nodes owned here, once for each copy elsewhere
  std::vector<comm::RemoteSlot> destination;  ///< those copies: the contact node on the other rank
};

class HaloExchange final : public Exchange {
 public:
  HaloExchange() = default;
  /// Collective. Memory for sums and copies of up to `widest` doubles for each node, for both arrays if there are two,
  /// is allocated here and never later.
  HaloExchange(const comm::Communicator& ranks, LocalIndex node_count, NodeLinks links, int widest);

  void share(std::span<double> values, int width) override;
  void sum_to_owner(std::span<double> values, int width) override;
  void share_both(const NodeValues& one, const NodeValues& other) override;
  void sum_both_to_owner(const NodeValues& one, const NodeValues& other) override;
  /// Other work and messages of other halos may occur between the two; `values` must not change.
  void begin_share(std::span<const double> values, int width);
  void end_share(std::span<double> values, int width);
  void max(std::span<double> values) override;
  void reduce(std::span<double> largest, std::span<std::int64_t> sums) override;
  void sum(std::span<std::int64_t> values) override;
  void max_to_owner(std::span<double> values, int width) override;
  void unite(std::vector<double>& values) override;

 private:
  [[nodiscard]] std::span<double> room_for(std::size_t nodes, int width, std::size_t before = 0);
  [[nodiscard]] std::array<std::span<double>, 2> carry_both(const comm::Halo& halo, std::size_t nodes,
                                                            const NodeValues& one, const NodeValues& other);
  void take_copies(std::span<const double> received, const NodeValues& into) const;
  void add_from_copies(std::span<const double> received, const NodeValues& into) const;

  std::vector<comm::Communicator> ranks_;  ///< one, or none before the first list
  NodeLinks links_;
  comm::Halo to_copies_, to_owners_;
  bool linked_ = false;  ///< some rank has a copy
  std::vector<double> received_;
};

}  // namespace brunt::contact
