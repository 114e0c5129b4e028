// SPDX-License-Identifier: Apache-2.0
// The binary sort against the vectors printed by Heinstein et al. 2000, section 4.4.
#include "contact/search/binary_sort.hpp"

#include <catch2/catch.hpp>
#include <numeric>
#include <random>

#include "two_blocks.hpp"

using namespace brunt;
using contact::BinarySort;
using contact::PlaceRange;

namespace {

BinarySort sorted(const std::vector<Vec3>& points) {
  BinarySort sorted;
  contact::sort_along_axes(points, sorted);
  return sorted;
}

std::vector<LocalIndex> in_places(const std::vector<LocalIndex>& index, PlaceRange range) {
  return {index.begin() + range.first, index.begin() + range.last};
}

}  // namespace

TEST_CASE("two blocks: index and rank vectors as printed") {
  const BinarySort sort = sorted(two_blocks::nodes());
  CHECK(two_blocks::from_one(sort.index[0]) == two_blocks::i_x);
  CHECK(two_blocks::from_one(sort.index[1]) == two_blocks::i_y);
  CHECK(two_blocks::from_one(sort.index[2]) == two_blocks::i_z);
  CHECK(two_blocks::from_one(sort.rank[0]) == two_blocks::r_x);
  CHECK(two_blocks::from_one(sort.rank[1]) == two_blocks::r_y);
  CHECK(two_blocks::from_one(sort.rank[2]) == two_blocks::r_z);
}

TEST_CASE("two blocks: bounds, lists and pairs of master surface 5 as printed") {
  const std::vector<Vec3> points = two_blocks::nodes();
  const BinarySort sort = sorted(points);
  const auto range = contact::places_between(sort, points, two_blocks::capture_box());
  const std::array<std::array<LocalIndex, 2>, 3> printed{{{1, 34}, {18, 35}, {19, 52}}};  // first and last, from 1
  for (std::size_t a = 0; a < 3; ++a) {
    CHECK(range[a].first + 1 == printed[a][0]);
    CHECK(range[a].last == printed[a][1]);
  }
  CHECK(two_blocks::from_one(in_places(sort.index[0], range[0])) == two_blocks::l_x);
  CHECK(two_blocks::from_one(in_places(sort.index[1], range[1])) == two_blocks::l_y);
  CHECK(two_blocks::from_one(in_places(sort.index[2], range[2])) == two_blocks::l_z);
  std::vector<LocalIndex> found;
  contact::append_points_in_box(sort, points, two_blocks::capture_box(), found);
  CHECK(two_blocks::from_one(found) == std::vector<LocalIndex>{18, 19, 21, 22, 27, 28, 30, 31});
  CHECK(two_blocks::partners(found) == std::vector<LocalIndex>{27, 28, 30, 31});
}

TEST_CASE("two blocks renumbered and shifted: the same pairs") {
  std::mt19937 random(3);
  for (int k = 0; k < 20; ++k)
    for (const double shift : {0.0, 1.0 / 3, 1e6}) {
      const std::vector<Vec3> points = two_blocks::nodes();
      std::vector<LocalIndex> number(points.size());  // new -> old
      std::iota(number.begin(), number.end(), 0);
      std::shuffle(number.begin(), number.end(), random);
      std::vector<Vec3> renumbered;
      for (const LocalIndex old : number)
        renumbered.emplace_back(points[static_cast<std::size_t>(old)].array() + shift);
      const geometry::Box capture = two_blocks::capture_box();
      const geometry::Box box = geometry::grown({capture.low.array() + shift, capture.high.array() + shift},
                                                shift == 0 ? 0 : 1e-9);  // shifted coordinates are rounded
      std::vector<LocalIndex> found;
      contact::append_points_in_box(sorted(renumbered), renumbered, box, found);
      for (LocalIndex& p : found) p = number[static_cast<std::size_t>(p)];
      CHECK(two_blocks::partners(found) == std::vector<LocalIndex>{27, 28, 30, 31});
    }
}
