// SPDX-License-Identifier: Apache-2.0
#include "depth/extreme_points.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/support/random_motion.hpp"

using namespace brunt;

TEST_CASE("no vertex of the convex hull is lost, and most points inside are") {
  test::Random random(5);
  for (int i = 0; i < 20; ++i) {
    std::vector<Vec3> points;
    for (int k = 0; k < 400; ++k) {
      Vec3 x = random.vector();
      if (i % 2) x = x.cwiseMax(-1).cwiseMin(1);  // many on the faces of a cube
      points.push_back(x);
    }
    const std::vector<Vec3> kept = depth::extreme_points(points);
    CHECK(kept.size() < points.size() / 2);
    for (int k = 0; k < 2000; ++k) {
      const Vec3 u = random.direction();
      const auto height = [&](const std::vector<Vec3>& set) {
        double most = -1e300;
        for (const Vec3& x : set) most = std::max(most, u.dot(x));
        return most;
      };
      CHECK(height(kept) >= height(points) - 1e-12);
    }
  }
}

TEST_CASE("directions are unit vectors that leave no great gap") {
  const std::vector<Vec3> directions = depth::spread_directions(200);
  test::Random random(6);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 u = random.direction();
    double nearest = -1;
    for (const Vec3& d : directions) nearest = std::max(nearest, u.dot(d));
    CHECK(nearest > 0.98);
  }
  for (const Vec3& d : directions) CHECK(d.norm() == Approx(1).epsilon(1e-14));
}
