// SPDX-License-Identifier: Apache-2.0
// Improves the partition of METIS, which uses the whole imbalance that it is allowed, and cuts a quarter more faces if
// none is allowed. Elements at the border of the part with the largest cost move to a lighter neighbour, first those
// that leave the shortest border (C. Fiduccia, R. Mattheyses, A linear-time heuristic for improving network partitions,
// DAC 1982).
#pragma once
#include <span>

#include "core/ragged.hpp"
#include "partition/split.hpp"

namespace brunt::partition {

/// Moves elements until no part costs more than 1 + tolerance times the mean, or no move is possible. No part gets more
/// contact faces than 1.02 times their mean, or than the initial maximum. The same input gives the same partition; no
/// part becomes empty.
void level(const Ragged<LocalIndex>& graph, const Weights& weights, int parts, double tolerance, std::span<Rank> part);

/// Moves single elements to an adjacent part if this reduces the number of cut faces, unless a part would newly exceed
/// 1 + tolerance times the mean cost: smooths borders along clusters of elements.
void smooth(const Ragged<LocalIndex>& graph, const Weights& weights, int parts, double tolerance, std::span<Rank> part);

}  // namespace brunt::partition
