// SPDX-License-Identifier: Apache-2.0
#include "contact/search/box_overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace brunt::contact {

using geometry::Box;

void for_each_overlap(std::span<const Box> first, std::span<const Box> second, OverlapScratch& scratch,
                      const std::function<void(LocalIndex, LocalIndex)>& visit) {
  std::map<int, std::vector<LocalIndex>> by_size;  // of extent up to 2^key
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double extent = (first[i].high - first[i].low).maxCoeff();
    if (!std::isfinite(extent)) continue;
    by_size[extent > 0 ? std::ilogb(extent) + 1 : std::numeric_limits<int>::min()].push_back(
        static_cast<LocalIndex>(i));
  }
  for (const auto& [exponent, members] : by_size) {
    const double half = 0.5 * std::ldexp(1.0, std::max(exponent, -1000));
    std::vector<Box> boxes;
    boxes.reserve(second.size());
    for (const Box& box : second) boxes.push_back(geometry::grown(box, half));
    std::vector<Vec3> middles;
    for (const LocalIndex i : members) {
      const Box& box = nth(first, i);
      middles.push_back(0.5 * (box.low + box.high));
    }
    Ragged<LocalIndex> found;
    find_pairs(boxes, middles, scratch[exponent], found);
    for (LocalIndex m = 0; m < found.rows(); ++m)
      for (const LocalIndex k : std::as_const(found).row(m)) {
        const LocalIndex i = nth(members, m);
        if (geometry::overlaps(nth(first, i), nth(second, k))) visit(i, k);
      }
  }
}

}  // namespace brunt::contact
