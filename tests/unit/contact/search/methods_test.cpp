// SPDX-License-Identifier: Apache-2.0
// All methods of a run find the same pairs.
#include "contact/search/methods.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

using namespace brunt;
using contact::SearchMethod;

namespace {

/// Points in a cube, some of them in one plane, some far away, some nowhere; boxes of all sizes, flat, empty and
/// endless ones among them.
struct Scene {
  std::vector<Vec3> points;
  std::vector<geometry::Box> boxes;

  explicit Scene(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> anywhere(0, 1), exponent(-4, 0);
    const auto place = [&] { return Vec3(anywhere(random), anywhere(random), anywhere(random)); };
    const double none = std::numeric_limits<double>::quiet_NaN(), endless = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 400; ++i) {
      Vec3 x = place();
      if (i % 5 == 0) x[2] = 0.5;
      if (i % 40 == 0) x *= 1e7;
      if (i % 97 == 0) x[1] = none;
      points.push_back(x);
    }
    for (int k = 0; k < 150; ++k) {
      const Vec3 low = k % 2 == 0 ? place() : points[static_cast<std::size_t>(k)];
      Vec3 high = low + std::pow(10, exponent(random)) * place();
      if (k % 7 == 0) high[2] = low[2];
      if (k % 31 == 0) high[0] = low[0] - 0.1;
      if (k % 37 == 0) high[1] = endless;
      boxes.push_back({low, high});
    }
  }
};

std::vector<std::vector<LocalIndex>> rows(const Ragged<LocalIndex>& pairs) {
  std::vector<std::vector<LocalIndex>> all;
  for (LocalIndex r = 0; r < pairs.rows(); ++r) all.emplace_back(pairs.row(r).begin(), pairs.row(r).end());
  return all;
}

}  // namespace

TEST_CASE("search by every method: the same pairs, again after motion") {
  contact::MethodScratch scratch[4];
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const Scene scene(seed);
    std::vector<std::vector<std::vector<LocalIndex>>> found;
    for (int m = 0; m < 4; ++m) {
      Ragged<LocalIndex> pairs;
      contact::find_pairs_by(static_cast<SearchMethod>(m), scene.boxes, scene.points, scratch[m], pairs);
      found.push_back(rows(pairs));
    }
    CAPTURE(seed);
    std::size_t count = 0;
    for (const auto& row : found[0]) count += row.size();
    CHECK(count > 100);
    for (std::size_t m = 1; m < 4; ++m) CHECK(found[m] == found[0]);
  }
}
