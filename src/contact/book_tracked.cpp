// SPDX-License-Identifier: Apache-2.0
#include "book_tracked.hpp"

#include <algorithm>

#include "slave.hpp"

namespace brunt::contact {
namespace {

void add_vector(std::array<comm::ExactAccumulator, 3>& sum, const Vec3& value) {
  for (std::size_t c = 0; c < 3; ++c) sum[c].add(value[static_cast<int>(c)]);
}

bool is_slave_in(const Contact& contact, const Row& row, std::int32_t block) {
  if (row.is_edge()) return row.slave_block == block;
  return std::ranges::binary_search(blocks_of_slave(contact, row), block);
}

/// Of the slave's impulse the share that is the block's: a node that several blocks share belongs to each alike, so
/// that what all blocks are given sums to zero.
double share_of_slave(const Contact& contact, const Row& row, std::int32_t block) {
  if (!is_slave_in(contact, row, block)) return 0;
  return row.is_edge() ? 1.0 : 1.0 / static_cast<double>(blocks_of_slave(contact, row).size());
}

/// What of the row's impulse counts in a tracked contact; `resultant` acts on its block.
struct Share {
  double resultant = 0, size = 0;
};

Share share_of(const Contact& contact, const Row& row, const TrackedContact& tracked) {
  if (!tracked.other) {
    const double own = share_of_slave(contact, row, tracked.block) - (row.master_block == tracked.block ? 1.0 : 0.0);
    return {own, std::abs(own)};
  }
  if (*tracked.other == tracked.block)
    return {0, row.master_block == tracked.block ? share_of_slave(contact, row, tracked.block) : 0.0};
  if (row.master_block == *tracked.other && is_slave_in(contact, row, tracked.block)) return {1, 1};
  if (row.master_block == tracked.block && is_slave_in(contact, row, *tracked.other)) return {-1, 1};
  return {};
}

}  // namespace

void book_tracked(Contact& contact, const Row& row, const Vec3& impulse) {
  const std::vector<TrackedContact>& tracked = contact.settings.tracked;
  for (std::size_t t = 0; t < tracked.size(); ++t) {
    const Share share = share_of(contact, row, tracked[t]);
    if (share.size == 0) continue;
    TrackedSums& sums = contact.ledger.sums.tracked[t];
    const double along = row.normal.dot(impulse);
    add_vector(sums.impulse, share.resultant * impulse);
    sums.normal_size.add(share.size * std::abs(along));
    if (row.friction == 0 && !row.holds) continue;
    const Vec3 across = impulse - along * row.normal;
    add_vector(sums.friction, share.resultant * across);
    sums.friction_size.add(share.size * across.norm());
  }
}

void append(const TrackedSums& tracked, std::vector<comm::ExactAccumulator>& sums) {
  sums.insert(sums.end(), tracked.impulse.begin(), tracked.impulse.end());
  sums.insert(sums.end(), tracked.friction.begin(), tracked.friction.end());
  sums.push_back(tracked.normal_size);
  sums.push_back(tracked.friction_size);
}

TrackedTotals tracked_totals(std::span<const double, tracked_width> totals) {
  return {Vec3(&totals[0]), Vec3(&totals[3]), totals[6], totals[7]};
}

}  // namespace brunt::contact
