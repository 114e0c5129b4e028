// SPDX-License-Identifier: Apache-2.0
// Triangles of polygons: their areas add up, and none is turned over.
#include "io/surface/ear_clipping.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>
#include <random>

using namespace brunt;
using io::EarClipping;
using io::Split;

namespace {

struct Areas {
  double sum = 0, least = 1e300;
};

Areas areas(const std::vector<Vec3>& x, const std::vector<std::array<LocalIndex, 3>>& triangles, const Vec3& normal) {
  Areas result;
  for (const auto& [a, b, c] : triangles) {
    const Vec3 &p = x[static_cast<std::size_t>(a)], &q = x[static_cast<std::size_t>(b)],
               &r = x[static_cast<std::size_t>(c)];
    const double part = normal.dot((q - p).cross(r - p)) / 2;
    result.sum += part;
    result.least = std::min(result.least, part);
  }
  return result;
}

double polygon_area(const std::vector<Vec3>& x, const Vec3& normal) {
  double sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += normal.dot(x[k].cross(x[(k + 1) % x.size()])) / 2;
  return sum;
}

/// Every side of the polygon is the side of one triangle; every other side is shared by two.
bool sides_match(std::size_t corners, const std::vector<std::array<LocalIndex, 3>>& triangles) {
  std::vector<std::pair<LocalIndex, LocalIndex>> sides;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) sides.emplace_back(t[k], t[(k + 1) % 3]);
  std::ranges::sort(sides);
  if (std::ranges::adjacent_find(sides) != sides.end()) return false;
  std::size_t alone = 0;
  for (const auto& [from, to] : sides) {
    if (std::ranges::binary_search(sides, std::pair(to, from))) continue;
    if (to != (from + 1) % static_cast<LocalIndex>(corners)) return false;
    ++alone;
  }
  return alone == corners && triangles.size() == corners - 2;
}

}  // namespace

TEST_CASE("Random star-shaped and spiral polygons in any plane are split into triangles of one sense") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  EarClipping clipping;
  for (int trial = 0; trial < 2000; ++trial) {
    const Mat3 rotation =
        Eigen::AngleAxisd(6 * unit(random), Vec3(unit(random), unit(random), 1).normalized()).toRotationMatrix();
    const Vec3 offset(10 * unit(random), unit(random), -5);
    std::vector<Vec3> x;
    if (trial % 2 == 0) {
      const int count = 5 + trial % 97;
      for (int k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * k / count, radius = 0.1 + unit(random);
        x.emplace_back(rotation * Vec3(radius * std::cos(angle), radius * std::sin(angle), 0) + offset);
      }
    } else {  // out along a spiral of several turns, and back beside it
      const int count = 10 + trial % 89;
      const double width = 0.2 + 0.6 * unit(random);
      const auto add = [&](int k, double r) {
        const double angle = 0.3 * k, radius = 1 + angle / (2 * std::numbers::pi) + r;
        x.emplace_back(rotation * Vec3(radius * std::cos(angle), radius * std::sin(angle), 0) + offset);
      };
      for (int k = 0; k < count; ++k) add(k, width);
      for (int k = count - 1; k >= 0; --k) add(k, 0);
    }
    std::vector<std::array<LocalIndex, 3>> triangles;
    REQUIRE(clipping.split(x, triangles) == Split::done);
    const Vec3 normal = rotation.col(2);
    const Areas parts = areas(x, triangles, normal);
    CHECK(parts.least > 0);
    CHECK(parts.sum == Approx(polygon_area(x, normal)).epsilon(1e-11));
    CHECK(sides_match(x.size(), triangles));
  }
}

TEST_CASE("Rounding to floats and large coordinates leave no turned triangle in straight sides") {
  EarClipping clipping;
  std::vector<Vec3> x;
  const auto add = [&](double a, double b) {
    x.emplace_back(static_cast<double>(static_cast<float>(1000 + a * 0.6 - b * 0.8)),
                   static_cast<double>(static_cast<float>(2000 + a * 0.8 + b * 0.6)), 3);
  };
  for (int k = 0; k < 10; ++k) add(k, 0);
  for (int k = 0; k < 10; ++k) add(10, k);
  for (int k = 10; k > 0; --k) add(k, 10);
  for (int k = 10; k > 0; --k) add(0, k);
  std::vector<std::array<LocalIndex, 3>> triangles;
  REQUIRE(clipping.split(x, triangles) == Split::done);
  CHECK(areas(x, triangles, Vec3::UnitZ()).least > 0.1);
  CHECK(areas(x, triangles, Vec3::UnitZ()).sum == Approx(100).epsilon(1e-3));
}

TEST_CASE("A polygon without area is a fan; one that crosses itself, or is too concave, is refused") {
  EarClipping clipping;
  std::vector<std::array<LocalIndex, 3>> triangles;
  const std::vector<Vec3> line = {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}, {1.5, 1.5, 0}};
  CHECK(clipping.split(line, triangles) == Split::done);
  CHECK(triangles == std::vector<std::array<LocalIndex, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  const std::vector<Vec3> bow = {{0, 0, 0}, {1, 0, 0}, {4, 4, 0}, {0, 4, 0}, {4, 1, 0}};
  CHECK(clipping.split(bow, triangles) == Split::crosses_itself);
  // combs: every other corner of one side is concave, and every ear has most of them to test
  const auto comb = [](int teeth) {
    std::vector<Vec3> x = {{0, -1, 0}, {1, -1, 0}};
    for (int k = teeth; k >= 0; --k) {
      x.emplace_back((k + 0.5) / (teeth + 1), 1, 0);
      if (k > 0) x.emplace_back(k / (teeth + 1.), 0, 0);
    }
    return x;
  };
  triangles.clear();
  CHECK(clipping.split(comb(1000), triangles) == Split::done);
  CHECK(sides_match(comb(1000).size(), triangles));
  CHECK(clipping.split(comb(20'000), triangles) == Split::too_concave);
}
