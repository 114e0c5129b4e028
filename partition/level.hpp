// SPDX-License-Identifier: Apache-2.0
// After METIS: it takes all the imbalance that it is allowed, and cuts a quarter more faces where it is allowed none.
// Elements at the border of the fullest part go over to a lighter neighbour, those first that leave the border shortest
// (C. Fiduccia, R. Mattheyses, A linear-time heuristic for improving network partitions, DAC 1982).
#pragma once
#include <span>

#include "brunt/core/ragged.hpp"
#include "partition/split.hpp"

namespace brunt::partition {

/// Moves elements until no part costs more than 1 + tolerance times the mean, or nothing more can move. No part gets
/// more contact faces than 1.02 times their mean, or than the part with most had. The same input gives the same split;
/// no part is emptied.
void level(const Ragged<LocalIndex>& graph, const Weights& weights, int parts, double tolerance, std::span<Rank> part);

/// Moves single elements to a part beside them wherever that leaves fewer faces cut, and no part that costs more than
/// 1 + tolerance times the mean where it did not: borders along clusters of elements lose their corners.
void smooth(const Ragged<LocalIndex>& graph, const Weights& weights, int parts, double tolerance, std::span<Rank> part);

}  // namespace brunt::partition
