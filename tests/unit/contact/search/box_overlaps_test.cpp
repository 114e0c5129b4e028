// SPDX-License-Identifier: Apache-2.0
// Overlaps of boxes against all pairs tried: sizes far apart, boxes without extent, boxes that only touch or are not
// finite. (Random scenes over ranks: tests/ranks/contact/search_oracle_test.cpp.)
#include "contact/search/box_overlaps.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <set>

using namespace brunt;
using namespace brunt::contact;
using geometry::Box;

namespace {

using Pair = std::pair<LocalIndex, LocalIndex>;

/// Cubes along x whose faces touch, each twice as large as the one before it; then points in their corners.
std::vector<Box> row_of_cubes(int count) {
  std::vector<Box> boxes;
  for (int k = 0; k < count; ++k) {
    const double edge = std::ldexp(1.0, k - count / 2), start = edge;  // 1/4 to 1/2, 1/2 to 1, 1 to 2
    boxes.push_back({Vec3(start, 0, 0), Vec3(start + edge, edge, edge)});
  }
  for (int k = 0; k < count; ++k)
    boxes.push_back({boxes[static_cast<std::size_t>(k)].high, boxes[static_cast<std::size_t>(k)].high});
  return boxes;
}

std::multiset<Pair> overlaps_of(std::span<const Box> first, std::span<const Box> second, OverlapScratch& scratch) {
  std::multiset<Pair> found;
  for_each_overlap(first, second, scratch, [&](LocalIndex i, LocalIndex k) { found.emplace(i, k); });
  return found;
}

std::multiset<Pair> all_tried(std::span<const Box> first, std::span<const Box> second) {
  std::multiset<Pair> found;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t k = 0; k < second.size(); ++k)
      if (geometry::overlaps(first[i], second[k]))
        found.emplace(static_cast<LocalIndex>(i), static_cast<LocalIndex>(k));
  return found;
}

}  // namespace

TEST_CASE("boxes of sizes from 1e-9 to 1e9 and of none, that only touch: each pair once, also in a second call") {
  const std::vector<Box> boxes = row_of_cubes(60);
  const std::multiset<Pair> expected = all_tried(boxes, boxes);
  CHECK(expected.size() >= 60 + 2 * 59 + 3 * 60);  // itself, its neighbours, its corner's point
  OverlapScratch scratch;
  CHECK(overlaps_of(boxes, boxes, scratch) == expected);
  CHECK(overlaps_of(boxes, boxes, scratch) == expected);
  CHECK(overlaps_of({}, boxes, scratch).empty());
  CHECK(overlaps_of(boxes, {}, scratch).empty());
}

TEST_CASE("boxes that are not finite overlap nothing, the others all that they do") {
  constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const Box unit{Vec3::Zero(), Vec3::Ones()};
  std::vector<Box> first{unit, {Vec3::Constant(-infinity), Vec3::Constant(infinity)}, Box{}, unit};
  first.push_back({Vec3(nan, 0, 0), Vec3(nan, 1, 1)});
  OverlapScratch scratch;
  CHECK(overlaps_of(first, std::vector<Box>{unit}, scratch) == std::multiset<Pair>{{0, 0}, {3, 0}});
}
