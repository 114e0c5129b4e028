// SPDX-License-Identifier: Apache-2.0
// Sums of a few terms of each row over its island, of all ranks: exact, so that no order matters.
#pragma once
#include <span>
#include <vector>

#include "contact/data/exchange.hpp"
#include "contact/enforcement/islands.hpp"

namespace brunt::contact {

struct IslandSums {
  std::vector<double> values;       ///< `width` an island
  std::vector<double> bounds;       ///< largest |term| of each island
  std::vector<std::int64_t> parts;  ///< scratch
};

/// terms: `width` a row; those of rows without an island do not count. Collective.
void sum_over_islands(std::span<const double> terms, std::size_t width, const Islands& islands, Exchange& exchange,
                      IslandSums& sums);

}  // namespace brunt::contact
