// SPDX-License-Identifier: Apache-2.0
// Weights from times measured by the ranks of a run.
#pragma once
#include <span>

#include "partition/split.hpp"

namespace brunt::partition {

/// Of the ranks of that run, and of each element in canonical order.
struct Measured {
  std::span<const double> element_seconds, contact_seconds;  ///< by rank: own work in a step [s]
  std::span<const Rank> rank;                                ///< that computed the element
  std::span<const double> pairs;                             ///< contact pairs that it tested for the element
};

/// The time of a rank is distributed to its entities: that of elements in proportion to their standard cost, that of
/// contact to candidate pairs. Weights::cost is relative to its mean, Weights::contact_faces is 1000 for the mean of
/// the elements with contact. Without measured time the standard cost remains, and contact has no weight.
Weights weigh(const Weights& usual, const Measured& measured);

}  // namespace brunt::partition
