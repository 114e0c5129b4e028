// SPDX-License-Identifier: Apache-2.0
// All searches against testing every point with every box.
#include "contact/search/search.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <random>
#include <string_view>
#include <utility>

#include "contact/search/binary_sort.hpp"
#include "contact/search/bucket_sort.hpp"
#include "two_blocks.hpp"

using namespace brunt;
using geometry::Box;

namespace {

struct Scene {
  std::vector<Vec3> points;
  std::vector<Box> boxes;
};

Ragged<LocalIndex> brute_force(const Scene& scene) {
  Ragged<LocalIndex> pairs;
  for (const Vec3& point : scene.points) {
    for (std::size_t b = 0; b < scene.boxes.size(); ++b)
      if (point.allFinite() && geometry::contains(scene.boxes[b], point))
        pairs.values.push_back(static_cast<LocalIndex>(b));
    pairs.close_row();
  }
  return pairs;
}

bool same(const Ragged<LocalIndex>& a, const Ragged<LocalIndex>& b) {
  return a.offsets == b.offsets && a.values == b.values;
}

/// The scratch is the caller's: it serves scenes of all kinds one after the other.
void check_all(const Scene& scene, contact::SearchScratch& scratch) {
  const Ragged<LocalIndex> expected = brute_force(scene);
  Ragged<LocalIndex> pairs;
  contact::find_pairs(scene.boxes, scene.points, scratch, pairs);
  REQUIRE(same(pairs, expected));
  contact::BucketSort buckets;
  contact::sort_into_buckets(scene.points, contact::bucket_grid(scene.points, scene.boxes, 8 * scene.points.size() + 8),
                             buckets);
  contact::find_pairs_in_buckets(buckets, scene.boxes, scene.points, pairs);
  REQUIRE(same(pairs, expected));
  contact::BinarySort sorted;
  contact::sort_along_axes(scene.points, sorted);
  contact::find_pairs_by_bisection(sorted, scene.boxes, scene.points, pairs);
  REQUIRE(same(pairs, expected));
}

/// Random scenes of many kinds; bits of `kind` choose.
class Maker {
 public:
  explicit Maker(unsigned seed) : random_(seed) {}

  Scene make(int kind) {
    const bool snapped = kind % 2 == 1, graded = kind % 3 == 1, planar = kind % 5 == 2, crowded = kind % 7 == 3;
    const double shift = std::array{0.0, 1.0 / 3, 1e6, -1e6}[static_cast<std::size_t>(kind / 4 % 4)];
    Scene scene;
    scene.points.resize(static_cast<std::size_t>(count(kind % 10 == 0 ? 700 : 150)));
    for (Vec3& point : scene.points) {
      point = place(snapped);
      if (planar) point[kind % 3] = 0.25;
      if (crowded && count(2) == 0) point = Vec3::Constant(0.5);
    }
    scene.boxes.resize(static_cast<std::size_t>(count(kind % 10 == 0 ? 300 : 100)));
    for (Box& box : scene.boxes) {
      const double size = graded ? std::pow(10.0, -3 * uniform()) : 0.5;
      const Vec3 low = place(snapped);
      box = {low, low + size * place(snapped)};
      if (count(20) == 0) box.high = box.low;            // a point
      if (count(20) == 0) std::swap(box.low, box.high);  // holds nothing, or is a point
      if (count(20) == 0 && !scene.points.empty()) touch(box, scene.points[index(scene.points)]);
      if (count(40) == 0) box.high[count(2)] = std::numeric_limits<double>::infinity();
    }
    if (kind % 6 == 0) add_outliers(scene);
    for (Vec3& point : scene.points) point.array() += shift;
    for (Box& box : scene.boxes) box = {box.low.array() + shift, box.high.array() + shift};
    return scene;
  }

  void shuffle(Scene& scene) { std::shuffle(scene.points.begin(), scene.points.end(), random_); }

 private:
  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  int count(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }
  template <class T>
  std::size_t index(const std::vector<T>& values) {
    return static_cast<std::size_t>(count(static_cast<int>(values.size()) - 1));
  }
  /// In the unit cube; snapped, many coordinates are equal and points lie on borders of boxes.
  Vec3 place(bool snapped) {
    const auto coordinate = [&] { return snapped ? std::floor(8 * uniform()) / 8 : uniform(); };
    const double x = coordinate(), y = coordinate();
    return {x, y, coordinate()};
  }
  /// A side, edge or corner exactly at the point, or the next number beyond it.
  void touch(Box& box, const Vec3& point) {
    for (int a = 0; a < 3; ++a) {
      const double beyond = std::nextafter(point[a], count(1) == 0 ? 10.0 : -10.0);
      (count(1) == 0 ? box.low[a] : box.high[a]) = count(1) == 0 ? point[a] : beyond;
    }
  }
  void add_outliers(Scene& scene) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 far = std::pow(10.0, 3.0 * (k + 1)) * (place(false).array() - 0.5);
      scene.points.push_back(far);
      scene.boxes.push_back({far.array() - 0.1, far.array() + 0.1});
    }
  }

  std::mt19937 random_;
};

}  // namespace

TEST_CASE("pairs of a thousand random scenes equal brute force") {
  Maker maker(11);
  contact::SearchScratch scratch;
  std::size_t pairs = 0;
  for (int kind = 0; kind < 1000; ++kind) {
    Scene scene = maker.make(kind);
    check_all(scene, scratch);
    maker.shuffle(scene);
    check_all(scene, scratch);
    pairs += brute_force(scene).values.size();
  }
  CHECK(pairs > 50000);  // scenes in which nothing is found would prove nothing
}

TEST_CASE("pairs of larger scenes equal brute force, and a second search needs no more memory") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto place = [&] {
    const double x = unit(random), y = unit(random);
    return Vec3(x, y, unit(random));
  };
  for (const char* kind : {"volume", "plane", "graded", "one place", "two scales"}) {
    CAPTURE(kind);
    const std::string_view name(kind);
    Scene scene;
    for (int i = 0; i < 6000; ++i) {
      Vec3 x = place();
      if (name == "plane") x[1] = 0.5;
      if (name == "graded") x *= std::pow(10.0, -9 * unit(random));
      if (name == "one place" && i % 2 == 0) x = Vec3::Constant(0.25);
      if (name == "two scales" && i % 2 == 0) x = 1e-7 * x + Vec3(1e6, -1e6, 3);
      scene.points.push_back(x);
    }
    for (std::size_t i = 0; i < 1200; ++i) {
      const Vec3& x = scene.points[i];
      const double size = name == "graded" ? 0.1 * x.norm() : name == "two scales" && i % 2 == 0 ? 1e-8 : 0.05;
      scene.boxes.push_back(geometry::grown({x, x + size * place()}, size * (i % 3 == 0 ? 0 : 1)));
    }
    scene.boxes.push_back({Vec3::Zero(), Vec3::Ones()});
    contact::SearchScratch scratch;
    check_all(scene, scratch);
    const std::size_t bytes = scratch.memory_bytes();
    check_all(scene, scratch);
    CHECK(scratch.memory_bytes() == bytes);
    CHECK(bytes < 200 * (scene.points.size() + scene.boxes.size()) + 8 * brute_force(scene).values.size());
  }
}

TEST_CASE("empty input, coincident points and values that are not finite") {
  contact::SearchScratch scratch;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Box unit{Vec3::Zero(), Vec3::Ones()}, all{Vec3::Constant(-inf), Vec3::Constant(inf)};
  check_all({}, scratch);
  check_all({{}, {unit, all}}, scratch);
  check_all({{Vec3::Zero()}, {}}, scratch);
  check_all({std::vector<Vec3>(1000, Vec3::Zero()), {Box{Vec3::Zero(), Vec3::Zero()}, Box{}, all, unit}}, scratch);
  check_all({{Vec3(0.5, nan, 0.5), Vec3(0.5, 0.5, 0.5), Vec3(inf, 0, 0), Vec3(0, -inf, 0)}, {unit, all}}, scratch);
  check_all({{Vec3::Zero(), Vec3::Ones()}, {{Vec3(0, nan, 0), Vec3::Ones()}, {Vec3::Zero(), Vec3(1, 1, nan)}}},
            scratch);
  check_all({{Vec3::Constant(-1e308), Vec3::Constant(1e308), Vec3::Zero()}, {unit, all}}, scratch);
}

TEST_CASE("points that differ in the last bit are told apart at any distance") {
  contact::SearchScratch scratch;
  for (const double x : {1.0, 1e6, 1e-300, 1e15}) {
    Scene scene;
    double value = x;
    for (int k = 0; k < 400; ++k, value = std::nextafter(value, 2 * x)) {
      scene.points.emplace_back(value, -value, 3 * value);
      scene.boxes.push_back({scene.points.back(), Vec3(value + 5 * (value - x), 0, 3 * value)});
    }
    check_all(scene, scratch);
  }
}

TEST_CASE("the two blocks of the paper: master surface 5 pairs with 27, 28, 30, 31") {
  contact::SearchScratch scratch;
  Ragged<LocalIndex> pairs, by_box;
  const std::vector<Vec3> points = two_blocks::nodes();
  contact::find_pairs(std::array{two_blocks::capture_box()}, points, scratch, pairs);
  transpose(pairs, 1, by_box);
  CHECK(two_blocks::partners(by_box.values) == std::vector<LocalIndex>{27, 28, 30, 31});
}
