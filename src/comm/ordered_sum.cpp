// SPDX-License-Identifier: Apache-2.0
#include "comm/ordered_sum.hpp"

#include <algorithm>
#include <unordered_map>

#include "comm/rendezvous.hpp"
#include "core/error.hpp"

namespace brunt::comm {

namespace {

using RowOf = std::unordered_map<GlobalIndex, LocalIndex>;  // node gid -> row of the shared nodes

/// Message of a rank to a sharer of a node about one contribution.
struct Announcement {
  GlobalIndex node_gid = 0;
  GlobalIndex key = 0;
  LocalIndex slot = 0;
  LocalIndex padding = 0;
};

struct Term {
  GlobalIndex key = 0;
  LocalIndex index = 0;  // own slot, or number of own slots + place among the received
};

Ragged<Announcement> announce(const Communicator& ranks, std::span<const Contribution> contributions, const RowOf& row,
                              const Ragged<Rank>& sharers) {
  std::vector<std::vector<Announcement>> to_rank(static_cast<std::size_t>(ranks.size()));
  for (std::size_t slot = 0; slot < contributions.size(); ++slot) {
    const Contribution& contribution = contributions[slot];
    const auto found = row.find(contribution.node_gid);
    if (found == row.end()) continue;
    for (const Rank rank : sharers.row(found->second))
      nth(to_rank, rank).push_back({contribution.node_gid, contribution.key, static_cast<LocalIndex>(slot), 0});
  }
  return comm::exchange(ranks, to_rank);
}

Ragged<LocalIndex> in_key_order(std::vector<std::vector<Term>>& terms) {
  Ragged<LocalIndex> ordered;
  for (std::vector<Term>& row : terms) {
    std::ranges::sort(row, {}, &Term::key);
    demand(std::ranges::adjacent_find(row, {}, &Term::key) == row.end(),
           "the contributions to a node have different keys");
    for (const Term& term : row) ordered.values.push_back(term.index);
    ordered.close_row();
  }
  return ordered;
}

}  // namespace

OrderedSum::OrderedSum(const Communicator& ranks, std::span<const Contribution> contributions,
                       std::span<const LocalIndex> shared_node, std::span<const GlobalIndex> shared_gid,
                       const Ragged<Rank>& sharers)
    : shared_node_(shared_node.begin(), shared_node.end()) {
  demand(shared_gid.size() == shared_node.size() && sharers.rows() == static_cast<LocalIndex>(shared_node.size()),
         "each shared node has a global index and a row of sharers");
  RowOf row;
  for (std::size_t i = 0; i < shared_gid.size(); ++i) row.emplace(shared_gid[i], static_cast<LocalIndex>(i));

  std::vector<std::vector<Term>> terms(shared_node.size());
  for (std::size_t slot = 0; slot < contributions.size(); ++slot)
    if (const auto found = row.find(contributions[slot].node_gid); found != row.end())
      nth(terms, found->second).push_back({contributions[slot].key, static_cast<LocalIndex>(slot)});

  const auto slots = static_cast<LocalIndex>(contributions.size());
  std::vector<RemoteSlot> source;
  const Ragged<Announcement> announced = announce(ranks, contributions, row, sharers);
  for (Rank rank = 0; rank < ranks.size(); ++rank)
    for (const Announcement& told : announced.row(rank)) {
      const auto found = row.find(told.node_gid);
      demand(found != row.end(), "a contribution comes only to ranks that share its node");
      nth(terms, found->second).push_back({told.key, slots + static_cast<LocalIndex>(source.size())});
      source.push_back({rank, told.slot});
    }
  terms_ = in_key_order(terms);
  halo_ = Halo(ranks, slots, source);
}

void OrderedSum::begin(std::span<const double> slots, int width) {
  const std::size_t wanted = static_cast<std::size_t>(halo_.leaves()) * static_cast<std::size_t>(width);
  if (received_.size() < wanted) received_.resize(wanted);
  halo_.begin(slots, received_, width);
}

void OrderedSum::end(std::span<const double> slots, int width, std::span<double> node_values, int stride) {
  halo_.end(slots, received_, width);
  const LocalIndex own = halo_.roots();
  const auto components = static_cast<std::size_t>(width);
  for (LocalIndex row = 0; row < terms_.rows(); ++row) {
    const auto node = static_cast<std::size_t>(nth(shared_node_, row));
    double* sum = node_values.data() + node * static_cast<std::size_t>(stride);
    std::fill_n(sum, components, 0.0);
    for (const LocalIndex term : terms_.row(row)) {
      const double* value = term < own ? slots.data() + static_cast<std::size_t>(term) * components
                                       : received_.data() + static_cast<std::size_t>(term - own) * components;
      for (std::size_t c = 0; c < components; ++c) sum[c] += value[c];
    }
  }
}

}  // namespace brunt::comm
