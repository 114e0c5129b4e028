// SPDX-License-Identifier: Apache-2.0
// The order along the curve holds every index once, and neighbours in it are neighbours in space.
#include "contact/search/spatial_order.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>

using namespace brunt;
using namespace brunt::contact;

namespace {

std::vector<LocalIndex> all_of(std::size_t count) {
  std::vector<LocalIndex> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  return order;
}

bool holds_each_once(std::vector<LocalIndex> order, std::size_t count) {
  std::ranges::sort(order);
  std::vector<LocalIndex> every(count);
  std::iota(every.begin(), every.end(), 0);
  return order == every;
}

std::vector<Vec3> cloud(int count, const Vec3& low, const Vec3& size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i)
    points.push_back(low + size.cwiseProduct(Vec3(share(random), share(random), share(random))));
  return points;
}

/// Mean distance from one point to the next in the order [length].
double stride(std::span<const Vec3> points, std::span<const LocalIndex> order) {
  double sum = 0;
  for (std::size_t i = 1; i < order.size(); ++i)
    sum += (points[static_cast<std::size_t>(order[i])] - points[static_cast<std::size_t>(order[i - 1])]).norm();
  return sum / static_cast<double>(order.size() - 1);
}

}  // namespace

TEST_CASE("neighbours in the order are about as near as points lie, in space and in a plane of any place and size") {
  const double size = GENERATE(1.0, 1e-6, 1e9);
  const bool flat = GENERATE(false, true);
  constexpr int count = 8000;
  const Vec3 extent = size * Vec3(1, 1, flat ? 0 : 1);
  const std::vector<Vec3> points = cloud(count, 100 * size * Vec3(1, -2, 3), extent, 3);
  std::vector<LocalIndex> order = all_of(points.size());
  SortScratch scratch;
  order_in_space(points, order, scratch);
  CHECK(holds_each_once(order, points.size()));
  const double spacing = size * std::pow(count, flat ? -1.0 / 2 : -1.0 / 3);
  CAPTURE(size, flat, stride(points, order) / spacing);
  CHECK(stride(points, order) < 1.5 * spacing);  // random order: 13 and 47
}

TEST_CASE("an outlier far away costs no order: what it leaves in one cell is ordered by smaller ones") {
  std::vector<Vec3> points = cloud(4000, Vec3::Zero(), Vec3::Ones(), 5);
  points.emplace_back(1e12, 1e12, 1e12);
  std::vector<LocalIndex> order = all_of(points.size());
  SortScratch scratch;
  order_in_space(points, order, scratch);
  CHECK(holds_each_once(order, points.size()));
  std::erase(order, 4000);
  CHECK(stride(points, order) < 1.5 * std::pow(4000, -1.0 / 3));
}

TEST_CASE("points that coincide, one point, none; only some of them; boxes by their part of the region") {
  SortScratch scratch;
  for (const std::size_t count : {0U, 1U, 15U, 500U}) {
    const std::vector<Vec3> points(count, Vec3(0.1, 0.2, 0.3));
    std::vector<LocalIndex> order = all_of(count);
    order_in_space(points, order, scratch);
    CHECK(holds_each_once(order, count));
  }
  const std::vector<Vec3> points = cloud(1000, Vec3::Zero(), Vec3::Ones(), 9);
  std::vector<LocalIndex> some;
  for (LocalIndex i = 0; i < 1000; i += 3) some.push_back(i);
  std::vector<LocalIndex> ordered = some;
  order_in_space(points, ordered, scratch);
  CHECK(std::ranges::is_permutation(ordered, some));

  const geometry::Box region{Vec3::Zero(), Vec3::Ones()};
  std::vector<geometry::Box> boxes;  // each reaches out of the region without end, but for one corner in it
  for (const Vec3& point : points) boxes.push_back({Vec3::Constant(-1e300), point});
  std::vector<Vec3> middles;
  for (const Vec3& point : points) middles.emplace_back(0.5 * point);
  std::vector<LocalIndex> by_box = all_of(points.size()), by_middle = by_box;
  order_in_space(boxes, region, by_box, scratch);
  order_in_space(middles, by_middle, scratch);
  CHECK(by_box == by_middle);
}
