// SPDX-License-Identifier: Apache-2.0
// What a search leaves for the next one: the same pairs, bit for bit, whatever was searched before.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "contact/search/search.hpp"

using namespace brunt;
using contact::SearchScratch;
using geometry::Box;

namespace {

struct Scene {
  std::vector<Vec3> points;
  std::vector<Box> boxes;
};

class Maker {
 public:
  Vec3 place() {
    const double x = unit_(random_), y = unit_(random_);
    return {x, y, unit_(random_)};
  }

  Scene make(std::size_t points, std::size_t boxes) {
    Scene scene;
    for (std::size_t i = 0; i < points; ++i) scene.points.push_back(place());
    for (std::size_t b = 0; b < boxes; ++b) {
      const Vec3 low = place();
      scene.boxes.push_back({low, low + 0.1 * place()});
    }
    return scene;
  }

  /// Every point and box by itself.
  void move(Scene& scene, double by) {
    for (Vec3& point : scene.points) point += by * place();
    for (Box& box : scene.boxes) {
      const Vec3 u = by * place();
      box = {box.low + u, box.high + u};
    }
  }

  void shuffle(Scene& scene) {
    std::shuffle(scene.points.begin(), scene.points.end(), random_);
    std::shuffle(scene.boxes.begin(), scene.boxes.end(), random_);
  }

 private:
  std::mt19937 random_{21};
  std::uniform_real_distribution<double> unit_{0, 1};
};

/// Whether a search with what is kept has the orders of a fresh one.
struct SameOrder {
  bool points = false, boxes = false;
};

SameOrder check(const Scene& scene, SearchScratch& kept) {
  SearchScratch fresh;
  Ragged<LocalIndex> pairs, expected;
  contact::find_pairs(scene.boxes, scene.points, kept, pairs);
  contact::find_pairs(scene.boxes, scene.points, fresh, expected);
  REQUIRE(pairs.offsets == expected.offsets);
  REQUIRE(pairs.values == expected.values);
  REQUIRE(!pairs.values.empty());
  return {kept.blocks.point == fresh.blocks.point, kept.boxes == fresh.boxes};
}

}  // namespace

TEST_CASE("a search after small motions keeps the order and sorts again after many; pairs are a fresh one's") {
  Maker maker;
  SearchScratch kept;
  Scene scene = maker.make(5000, 3000);
  check(scene, kept);
  std::vector<LocalIndex> points = kept.blocks.point, boxes = kept.boxes;
  int point_sorts = 0, box_sorts = 0;
  for (int k = 0; k < 100; ++k) {
    maker.move(scene, 0.05);
    check(scene, kept);
    point_sorts += kept.blocks.point != points ? 1 : 0;
    box_sorts += kept.boxes != boxes ? 1 : 0;
    points = kept.blocks.point;
    boxes = kept.boxes;
  }
  CHECK(point_sorts >= 1);
  CHECK(point_sorts <= 20);
  CHECK(box_sorts >= 1);
  CHECK(box_sorts <= 20);
}

TEST_CASE("what is like nothing before is sorted as by a first search") {
  Maker maker;
  SearchScratch kept;
  Scene scene = maker.make(4000, 4000);
  check(scene, kept);
  maker.shuffle(scene);
  SameOrder same = check(scene, kept);
  CHECK(same.points);
  CHECK(same.boxes);
  for (Vec3& point : scene.points) point = maker.place();
  CHECK(check(scene, kept).points);
  scene.points[7] = Vec3::Constant(1e9);
  CHECK(check(scene, kept).points);
  scene.boxes[5] = {Vec3::Constant(1e9), Vec3::Constant(1e9)};
  check(scene, kept);
  scene.boxes[9] = {Vec3::Constant(-std::numeric_limits<double>::infinity()), Vec3::Zero()};
  check(scene, kept);
  scene.points[3] = Vec3::Constant(std::nan(""));
  CHECK(check(scene, kept).points);
  scene = maker.make(4100, 300);
  same = check(scene, kept);
  CHECK(same.points);
  CHECK(same.boxes);
  scene.points.resize(50);
  CHECK(check(scene, kept).points);
  Ragged<LocalIndex> pairs;
  contact::find_pairs({}, scene.points, kept, pairs);
  CHECK(pairs.values.empty());
  contact::find_pairs(scene.boxes, {}, kept, pairs);
  CHECK(pairs.values.empty());
  CHECK(check(scene, kept).points);
}

TEST_CASE("four hundred searches in a row, motions small and large, points lost and found") {
  Maker maker;
  std::mt19937 random(4);
  SearchScratch kept;
  Scene scene = maker.make(700, 500);
  for (int k = 0; k < 400; ++k) {
    const auto what = random() % 8;
    if (what < 5) maker.move(scene, std::pow(10.0, -static_cast<double>(what) - 1));
    if (what == 5) maker.shuffle(scene);
    if (what == 6) scene.points[random() % scene.points.size()] += Vec3::Constant(0.5);
    if (what == 7) scene = maker.make(600 + random() % 200, 400 + random() % 200);
    check(scene, kept);
  }
}
