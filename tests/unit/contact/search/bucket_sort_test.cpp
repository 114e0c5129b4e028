// SPDX-License-Identifier: Apache-2.0
// The bucket sort against the vectors printed by Heinstein et al. 2000, section 4.3.
#include "contact/search/bucket_sort.hpp"

#include <catch2/catch.hpp>
#include <numeric>
#include <random>

#include "two_blocks.hpp"

using namespace brunt;
using contact::BucketSort;
using geometry::Box;

namespace {

BucketSort sorted(const std::vector<Vec3>& points, double size) {
  BucketSort sorted;
  contact::sort_into_buckets(points, contact::bucket_grid(points, size), sorted);
  return sorted;
}

std::vector<LocalIndex> in_box(const BucketSort& sort, const Box& box, const std::vector<Vec3>& points) {
  Ragged<LocalIndex> by_point, by_box;
  contact::find_pairs_in_buckets(sort, std::array{box}, points, by_point);
  transpose(by_point, 1, by_box);
  return by_box.values;
}

}  // namespace

TEST_CASE("two blocks: lbox, nbox, npoint and ndsort as printed") {
  const std::vector<Vec3> points = two_blocks::nodes();
  const BucketSort sort = sorted(points, 0.5);
  CHECK(sort.grid.slices == std::array<LocalIndex, 3>{3, 5, 3});
  CHECK(sort.grid.bucket_count() == 45);
  CHECK(two_blocks::from_one(sort.lbox) == two_blocks::lbox);
  CHECK(sort.nbox == two_blocks::nbox);
  CHECK(two_blocks::from_one(sort.npoint) == two_blocks::npoint);
  CHECK(two_blocks::from_one(sort.ndsort) == two_blocks::ndsort);
  // "slave nodes at location 26 and 27 in ndsort are in bucket 23"
  CHECK(sort.ndsort[25] + 1 == 22);
  CHECK(sort.ndsort[26] + 1 == 31);
}

TEST_CASE("two blocks: buckets and pairs of master surface 5") {
  // The printed jbox_min is 3; the printed formula gives 2, so that three nodes of the layer y = 0.5 come along until
  // the box is asked.
  const std::vector<Vec3> points = two_blocks::nodes();
  const BucketSort sort = sorted(points, 0.5);
  const contact::BucketRange range = contact::buckets_of(sort.grid, two_blocks::capture_box());
  CHECK(range.first == std::array<LocalIndex, 3>{1 - 1, 2 - 1, 2 - 1});
  CHECK(range.last == std::array<LocalIndex, 3>{2 - 1, 3 - 1, 3 - 1});
  std::vector<LocalIndex> candidates;
  contact::append_candidates(sort, two_blocks::capture_box(), candidates);
  CHECK(two_blocks::partners(candidates) == std::vector<LocalIndex>{10, 11, 13, 27, 28, 30, 31});
  CHECK(two_blocks::partners(in_box(sort, two_blocks::capture_box(), points)) ==
        std::vector<LocalIndex>{27, 28, 30, 31});
}

TEST_CASE("two blocks renumbered: the same buckets hold the same nodes") {
  const std::vector<Vec3> points = two_blocks::nodes();
  std::mt19937 random(3);
  for (int k = 0; k < 20; ++k) {
    std::vector<LocalIndex> number(points.size());  // new -> old
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), random);
    std::vector<Vec3> renumbered;
    for (const LocalIndex old : number) renumbered.push_back(points[static_cast<std::size_t>(old)]);
    const BucketSort sort = sorted(renumbered, 0.5);
    CHECK(sort.nbox == two_blocks::nbox);
    CHECK(two_blocks::from_one(sort.npoint) == two_blocks::npoint);
    for (std::size_t i = 0; i < number.size(); ++i)
      CHECK(sort.lbox[i] + 1 == two_blocks::lbox[static_cast<std::size_t>(number[i])]);
    std::vector<LocalIndex> candidates;
    contact::append_candidates(sort, two_blocks::capture_box(), candidates);
    for (LocalIndex& candidate : candidates) candidate = number[static_cast<std::size_t>(candidate)];
    CHECK(two_blocks::partners(candidates) == std::vector<LocalIndex>{10, 11, 13, 27, 28, 30, 31});
  }
}

TEST_CASE("two blocks shifted and in buckets of any size: the same pairs after the box check") {
  for (const double shift : {0.0, 1.0 / 3, -1.0 / 3, 1e6})
    for (const double size : {0.5, 0.1, 0.3, 0.7, 5.0}) {
      std::vector<Vec3> points = two_blocks::nodes();
      for (Vec3& point : points) point.array() += shift;
      Box box = two_blocks::capture_box();
      const double slack = shift == 0 ? 0 : 1e-9;  // shifted coordinates are rounded, and the box touches nodes
      box = geometry::grown({box.low.array() + shift, box.high.array() + shift}, slack);
      CHECK(two_blocks::partners(in_box(sorted(points, size), box, points)) == std::vector<LocalIndex>{27, 28, 30, 31});
    }
}

TEST_CASE("bucket size: the smallest face, unless memory is short") {
  const std::vector<Vec3> points = two_blocks::nodes();
  const std::vector<Box> boxes{{Vec3::Zero(), Vec3(2, 1, 0)}, {Vec3::Zero(), Vec3(0.5, 0, 0.25)}};
  CHECK(contact::bucket_grid(points, boxes, 1000).size == 0.5);
  CHECK(contact::bucket_grid(points, boxes, 45).size == 0.5);
  const contact::BucketGrid coarse = contact::bucket_grid(points, boxes, 44);
  CHECK(coarse.size > 0.5);
  CHECK(coarse.bucket_count() <= 44);
  CHECK(contact::bucket_grid(points, boxes, 1).bucket_count() == 1);
  const std::vector<Vec3> far{Vec3::Zero(), Vec3::Constant(1e30)};
  CHECK(contact::bucket_grid(far, boxes, 1000).bucket_count() <= 1000);
}
