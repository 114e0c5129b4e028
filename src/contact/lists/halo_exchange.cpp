// SPDX-License-Identifier: Apache-2.0
// Two halos: owners to copies, and every copy's own value back to the owner, who adds.
#include "contact/lists/halo_exchange.hpp"

#include <algorithm>
#include <cstring>

#include "core/sorted.hpp"

namespace brunt::contact {

HaloExchange::HaloExchange(const comm::Communicator& ranks, LocalIndex node_count, NodeLinks links, int widest)
    : ranks_{ranks}, links_(std::move(links)), linked_(ranks.any(!links_.copies.empty())) {
  if (!linked_) return;
  to_copies_ = comm::Halo(ranks, node_count, links_.source);
  to_owners_ = comm::Halo(ranks, node_count, links_.destination);
  received_.resize(std::max(links_.copies.size(), links_.copied.size()) * static_cast<std::size_t>(widest));
}

/// What is received of `nodes`, behind what comes before it.
std::span<double> HaloExchange::room_for(std::size_t nodes, int width, std::size_t before) {
  return std::span(received_).subspan(before, nodes * static_cast<std::size_t>(width));
}

void HaloExchange::take_copies(std::span<const double> received, const NodeValues& into) const {
  const auto w = static_cast<std::size_t>(into.width);
  for (std::size_t i = 0; i < links_.copies.size(); ++i)
    std::copy_n(&received[i * w], w, &into.values[static_cast<std::size_t>(links_.copies[i]) * w]);
}

void HaloExchange::add_from_copies(std::span<const double> received, const NodeValues& into) const {
  const auto w = static_cast<std::size_t>(into.width);
  for (std::size_t i = 0; i < links_.copied.size(); ++i)
    for (std::size_t c = 0; c < w; ++c)
      into.values[static_cast<std::size_t>(links_.copied[i]) * w + c] += received[i * w + c];
}

void HaloExchange::begin_share(std::span<const double> values, int width) {
  if (linked_) to_copies_.begin(values, room_for(links_.copies.size(), width), width);
}

void HaloExchange::end_share(std::span<double> values, int width) {
  if (!linked_) return;
  const std::span<double> received = room_for(links_.copies.size(), width);
  to_copies_.end(values, received, width);
  take_copies(received, {values, width});
}

void HaloExchange::share(std::span<double> values, int width) {
  begin_share(values, width);
  end_share(values, width);
}

/// What `nodes` receive of both.
std::array<std::span<double>, 2> HaloExchange::carry_both(const comm::Halo& halo, std::size_t nodes,
                                                          const NodeValues& one, const NodeValues& other) {
  const std::span<double> first = room_for(nodes, one.width), second = room_for(nodes, other.width, first.size());
  halo.begin(one.values, first, one.width);
  halo.begin(other.values, second, other.width);
  halo.end(one.values, first, one.width);
  halo.end(other.values, second, other.width);
  return {first, second};
}

void HaloExchange::share_both(const NodeValues& one, const NodeValues& other) {
  if (!linked_) return;
  const auto [first, second] = carry_both(to_copies_, links_.copies.size(), one, other);
  take_copies(first, one);
  take_copies(second, other);
}

void HaloExchange::sum_to_owner(std::span<double> values, int width) {
  if (!linked_) return;
  const std::span<double> received = room_for(links_.copied.size(), width);
  to_owners_.forward(values, received, width);
  add_from_copies(received, {values, width});
}

void HaloExchange::sum_both_to_owner(const NodeValues& one, const NodeValues& other) {
  if (!linked_) return;
  const auto [first, second] = carry_both(to_owners_, links_.copied.size(), one, other);
  add_from_copies(first, one);
  add_from_copies(second, other);
}

void HaloExchange::max(std::span<double> values) {
  if (!ranks_.empty()) ranks_.front().max(values);
}

void HaloExchange::reduce(std::span<double> largest, std::span<std::int64_t> sums) {
  if (!ranks_.empty()) ranks_.front().max_and_sum(largest, sums);
}

void HaloExchange::sum(std::span<std::int64_t> values) {
  if (!ranks_.empty()) ranks_.front().sum(values);
}

void HaloExchange::max_to_owner(std::span<double> values, int width) {
  if (!linked_) return;
  const std::span<double> received = room_for(links_.copied.size(), width);
  to_owners_.forward(values, received, width);
  const auto w = static_cast<std::size_t>(width);
  for (std::size_t i = 0; i < links_.copied.size(); ++i)
    for (std::size_t c = 0; c < w; ++c) {
      double& own = values[static_cast<std::size_t>(links_.copied[i]) * w + c];
      own = std::max(own, received[i * w + c]);
    }
}

void HaloExchange::unite(std::vector<double>& values) {
  sort_unique(values);
  if (ranks_.empty() || ranks_.front().size() == 1) return;
  const comm::Communicator& ranks = ranks_.front();
  std::vector<std::byte> bytes;
  const std::vector<std::vector<std::byte>> gathered = ranks.gather(std::as_bytes(std::span(values)));
  if (ranks.is_root()) {
    for (const std::vector<std::byte>& part : gathered) bytes.insert(bytes.end(), part.begin(), part.end());
    values.resize(bytes.size() / sizeof(double));
    if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    sort_unique(values);
    const std::span<const std::byte> distinct = std::as_bytes(std::span(values));
    bytes.assign(distinct.begin(), distinct.end());
  }
  ranks.broadcast(bytes);
  values.resize(bytes.size() / sizeof(double));
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
}

}  // namespace brunt::contact
