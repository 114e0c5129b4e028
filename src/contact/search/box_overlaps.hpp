// SPDX-License-Identifier: Apache-2.0
// Overlapping boxes: the search pairs points with boxes, so one side is treated by size classes, as centres.
#pragma once
#include <functional>
#include <map>
#include <span>

#include "contact/search/search.hpp"
#include "core/types.hpp"
#include "geometry/box.hpp"

namespace brunt::contact {

/// Kept between calls like a SearchScratch: one for each size class.
using OverlapScratch = std::map<int, SearchScratch>;

/// Calls visit(i, k) for each i, k with first[i] overlapping second[k] (closed boxes), each pair once, in undefined
/// order. Boxes of `first` that are not finite overlap nothing.
void for_each_overlap(std::span<const geometry::Box> first, std::span<const geometry::Box> second,
                      OverlapScratch& scratch, const std::function<void(LocalIndex, LocalIndex)>& visit);

}  // namespace brunt::contact
