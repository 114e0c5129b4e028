// SPDX-License-Identifier: Apache-2.0
// Impulses of contacts with probes.
#pragma once
#include <span>
#include <vector>

#include "contact/contact.hpp"

namespace brunt::contact {

/// Adds what a row between bodies gives to the sums of the tracked contacts.
void book_tracked(Contact& contact, const Row& row, const Vec3& impulse);

/// Sums of a tracked contact in a row: impulse, friction, the two sizes.
constexpr std::size_t tracked_width = 8;
void append(const TrackedSums& tracked, std::vector<comm::ExactAccumulator>& sums);
TrackedTotals tracked_totals(std::span<const double, tracked_width> totals);

}  // namespace brunt::contact
