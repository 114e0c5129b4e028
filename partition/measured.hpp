// SPDX-License-Identifier: Apache-2.0
// Weights from what the ranks of a run have measured.
#pragma once
#include <span>

#include "partition/split.hpp"

namespace brunt::partition {

/// Of the ranks of that run, and of each element in canonical order.
struct Measured {
  std::span<const double> element_seconds, contact_seconds;  ///< by rank: own work in a step [s]
  std::span<const Rank> rank;                                ///< that computed the element
  std::span<const double> pairs;                             ///< of contact that it looked at for the element
};

/// The time of a rank goes to its entities in equal shares: that of its elements by their usual cost, that of contact
/// by candidate pairs. Weights::cost is relative to its mean, Weights::contact_faces is 1000 for the mean of the
/// elements with contact. Where no time was measured, the usual cost stays, and contact weighs nothing.
Weights weigh(const Weights& usual, const Measured& measured);

}  // namespace brunt::partition
