// SPDX-License-Identifier: Apache-2.0
// The search against testing every point with every box.
#include "brunt/contact/search/search.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

using namespace brunt;
using geometry::Box;

namespace {

std::vector<std::vector<LocalIndex>> brute_force(const std::vector<Box>& boxes, const std::vector<Vec3>& points) {
  std::vector<std::vector<LocalIndex>> pairs(boxes.size());
  for (std::size_t b = 0; b < boxes.size(); ++b)
    for (std::size_t p = 0; p < points.size(); ++p)
      if (geometry::contains(boxes[b], points[p])) pairs[b].push_back(static_cast<LocalIndex>(p));
  return pairs;
}

void check_against_brute_force(const std::vector<Box>& boxes, const std::vector<Vec3>& points) {
  Ragged<LocalIndex> pairs;
  contact::find_pairs(boxes, points, pairs);
  const auto expected = brute_force(boxes, points);
  REQUIRE(pairs.rows() == static_cast<LocalIndex>(boxes.size()));
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    const auto row = std::as_const(pairs).row(static_cast<LocalIndex>(b));
    REQUIRE(std::vector<LocalIndex>(row.begin(), row.end()) == expected[b]);
  }
}

}  // namespace

TEST_CASE("pairs equal brute force on random scenes, also shifted and with a far outlier") {
  std::mt19937 random(11);
  for (int scene = 0; scene < 60; ++scene) {
    std::uniform_int_distribution<int> count(0, 120);
    std::uniform_real_distribution<double> place(0, 1), size(0, scene % 3 == 0 ? 0.5 : 0.1);
    const double shift = scene % 4 == 1 ? 1e6 : scene % 4 == 2 ? 1.0 / 3 : 0.0;
    const double grid = scene % 2 == 0 ? 0.0 : 0.125;  // many equal coordinates, points on box borders
    const auto snap = [&](double value) { return grid > 0 ? grid * std::floor(value / grid) : value; };
    std::vector<Vec3> points(static_cast<std::size_t>(count(random)));
    for (Vec3& p : points) p = Vec3(snap(place(random)), snap(place(random)), snap(place(random))).array() + shift;
    if (!points.empty() && scene % 5 == 0) points.front() = Vec3(1e12, -1e12, 3e11);
    std::vector<Box> boxes(static_cast<std::size_t>(count(random)));
    for (Box& box : boxes) {
      const Vec3 low = Vec3(snap(place(random)), snap(place(random)), snap(place(random))).array() + shift;
      box = {low, low + Vec3(snap(size(random)), snap(size(random)), snap(size(random)))};
    }
    check_against_brute_force(boxes, points);
  }
}

TEST_CASE("empty input, coincident points and values that are not finite") {
  check_against_brute_force({}, {});
  check_against_brute_force({Box{Vec3::Zero(), Vec3::Ones()}}, {});
  check_against_brute_force({}, {Vec3::Zero()});
  check_against_brute_force({Box{Vec3::Zero(), Vec3::Zero()}, Box{}}, std::vector<Vec3>(40, Vec3::Zero()));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check_against_brute_force({Box{Vec3::Zero(), Vec3::Ones()}}, {Vec3(0.5, nan, 0.5), Vec3(0.5, 0.5, 0.5)});
}

TEST_CASE("the two blocks of the paper: master surface 5 pairs with 27, 28, 30, 31") {
  // Heinstein et al. 2000, Fig. 7: two 2 x 2 x 2 blocks of cubes of side 1/2 touching on y = 1, nodes by y, then z
  // downward, then x; the interior node of the middle layers is left out. Paper numbers, 1-based.
  std::vector<Vec3> points;
  for (const auto& layers : {std::array{0.0, 0.5, 1.0}, std::array{1.0, 1.5, 2.0}})
    for (const double y : layers)
      for (const double z : {1.0, 0.5, 0.0})
        for (const double x : {0.0, 0.5, 1.0})
          if (!(x == 0.5 && z == 0.5 && (y == 0.5 || y == 1.5))) points.emplace_back(x, y, z);
  REQUIRE(points.size() == 52);
  // Face 18, 19, 22, 21 swept over one step of 1.1e-6 s at 500 in/s, grown by the same on all sides.
  const double reach = 500 * 1.1e-6;
  const Box capture{Vec3(0 - reach, 1 - reach, 0.5 - reach), Vec3(0.5 + reach, 1 + 2 * reach, 1 + reach)};
  Ragged<LocalIndex> pairs;
  contact::find_pairs(std::array{capture}, points, pairs);
  const std::vector<LocalIndex> face{17, 18, 21, 20};  // nodes of the face itself are no partners of it
  std::vector<LocalIndex> partners;
  for (const LocalIndex p : pairs.values)
    if (std::find(face.begin(), face.end(), p) == face.end()) partners.push_back(p + 1);
  CHECK(partners == std::vector<LocalIndex>{27, 28, 30, 31});
}
