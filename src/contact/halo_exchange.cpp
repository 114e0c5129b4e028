// SPDX-License-Identifier: Apache-2.0
// Two halos: owners to copies, and every copy's own value back to the owner, who adds.
#include "brunt/contact/halo_exchange.hpp"

#include <algorithm>

namespace brunt::contact {

HaloExchange::HaloExchange(const comm::Communicator& ranks, LocalIndex node_count, NodeLinks links, int widest)
    : ranks_{ranks}, links_(std::move(links)), linked_(ranks.any(!links_.copies.empty())) {
  if (!linked_) return;
  to_copies_ = comm::Halo(ranks, node_count, links_.source);
  to_owners_ = comm::Halo(ranks, node_count, links_.destination);
  received_.resize(std::max(links_.copies.size(), links_.copied.size()) * static_cast<std::size_t>(widest));
}

void HaloExchange::begin_share(std::span<const double> values, int width) {
  if (!linked_) return;
  to_copies_.begin(values, std::span(received_).first(links_.copies.size() * static_cast<std::size_t>(width)), width);
}

void HaloExchange::end_share(std::span<double> values, int width) {
  if (!linked_) return;
  const auto w = static_cast<std::size_t>(width);
  to_copies_.end(values, std::span(received_).first(links_.copies.size() * w), width);
  for (std::size_t i = 0; i < links_.copies.size(); ++i)
    std::copy_n(&received_[i * w], w, &values[static_cast<std::size_t>(links_.copies[i]) * w]);
}

void HaloExchange::sum_to_owner(std::span<double> values, int width) {
  if (!linked_) return;
  const auto w = static_cast<std::size_t>(width);
  to_owners_.forward(values, std::span(received_).first(links_.copied.size() * w), width);
  for (std::size_t i = 0; i < links_.copied.size(); ++i)
    for (std::size_t c = 0; c < w; ++c)
      values[static_cast<std::size_t>(links_.copied[i]) * w + c] += received_[i * w + c];
}

void HaloExchange::max(std::span<double> values) {
  if (!ranks_.empty()) ranks_.front().max(values);
}

void HaloExchange::reduce(std::span<double> largest, std::span<std::int64_t> sums) {
  if (!ranks_.empty()) ranks_.front().max_and_sum(largest, sums);
}

}  // namespace brunt::contact
