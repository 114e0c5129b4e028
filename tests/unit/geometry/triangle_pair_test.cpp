// SPDX-License-Identifier: Apache-2.0
// Pairs of triangles against exact integer arithmetic.
#include "geometry/triangles/triangle_pair.hpp"

#include <catch2/catch.hpp>

#include "integer_triangles.hpp"
#include "shots.hpp"

using namespace brunt;
using namespace brunt::geometry;
using namespace brunt::geometry::testing;

namespace {

struct Family {
  const char* name;
  int reach;       ///< coordinates from -reach to reach
  int shared;      ///< corners that both have
  bool one_plane;  ///< coplanar
  int sliver;      ///< corners off a line by at most this; 0: anyhow, -1: exactly on a line
};

int whole(Random& random, int reach) {
  return std::uniform_int_distribution<int>(-reach, reach)(random);
}

IntVec random_point(Random& random, int reach) {
  return {whole(random, reach), whole(random, reach), whole(random, reach)};
}

IntTriangle random_triangle(Random& random, const Family& family) {
  IntTriangle t{random_point(random, family.reach), random_point(random, family.reach),
                random_point(random, family.reach)};
  if (family.sliver == 0) return t;
  for (std::size_t k = 0; k < 3; ++k) {  // the third in the middle of the others, or nearly
    t[0][k] = 2 * (t[0][k] / 2);
    t[1][k] = 2 * (t[1][k] / 2);
    t[2][k] = (t[0][k] + t[1][k]) / 2 + (family.sliver > 0 ? whole(random, family.sliver) : 0);
  }
  return t;
}

/// In the plane of two small vectors, through the origin.
void flatten(Random& random, IntTriangle& a, IntTriangle& b) {
  const IntVec u = random_point(random, 3), v = random_point(random, 3);
  for (IntTriangle* t : {&a, &b})
    for (IntVec& p : *t) {
      const Int128 s = p[0], r = p[1];
      for (std::size_t k = 0; k < 3; ++k) p[k] = s * u[k] + r * v[k];
    }
}

void make_pair_of(Random& random, const Family& family, IntTriangle& a, IntTriangle& b) {
  a = random_triangle(random, family);
  b = random_triangle(random, family);
  if (family.one_plane) flatten(random, a, b);
  for (int k = 0; k < family.shared; ++k)
    b[static_cast<std::size_t>((k + 1) % 3)] = a[static_cast<std::size_t>((2 * k) % 3)];
}

const std::array<Family, 18> families{{{"tiny", 1, 0, false, 0},
                                       {"small", 3, 0, false, 0},
                                       {"middle", 30, 0, false, 0},
                                       {"large", 400000, 0, false, 0},
                                       {"a corner shared", 4, 1, false, 0},
                                       {"an edge shared", 4, 2, false, 0},
                                       {"all shared", 4, 3, false, 0},
                                       {"one plane, tiny", 2, 0, true, 0},
                                       {"one plane", 9, 0, true, 0},
                                       {"one plane, large", 60000, 0, true, 0},
                                       {"one plane, a corner shared", 9, 1, true, 0},
                                       {"one plane, an edge shared", 9, 2, true, 0},
                                       {"slivers", 1000, 0, false, 1},
                                       {"long slivers", 400000, 0, false, 1},
                                       {"slivers, a corner shared", 400000, 1, false, 1},
                                       {"slivers in one plane", 100000, 0, true, 1},
                                       {"without area", 3, 0, false, -1},
                                       {"without area, large", 400000, 0, false, -1}}};

double size_of(const Triangle& a, const Triangle& b) {
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) size = std::max({size, a[i].cwiseAbs().maxCoeff(), b[i].cwiseAbs().maxCoeff()});
  return size;
}

double distance_to_triangle(const Vec3& p, const Triangle& t) {
  return nearest_points({p, p, p}, t).distance;
}

}  // namespace

TEST_CASE("triangles cross, and are apart, exactly as integer arithmetic says") {
  Random random(5);
  for (const Family& family : families) {
    int crossing = 0, wrong = 0, zeros = 0, nan = 0, unlike = 0;
    double worst = 0, off_points = 0;
    for (int k = 0; k < 6000; ++k) {
      IntTriangle ia, ib;
      make_pair_of(random, family, ia, ib);
      const Triangle a = as_doubles(ia), b = as_doubles(ib);
      const long double distance2 = exact_distance2(ia, ib);
      const bool cross = distance2 == 0;
      crossing += static_cast<int>(cross);
      wrong += static_cast<int>(triangles_cross(a, b) != cross) + static_cast<int>(triangles_cross(b, a) != cross);
      const NearestPoints nearest = nearest_points(a, b);
      zeros += static_cast<int>((nearest.distance == 0) != cross);
      nan += static_cast<int>(!nearest.on_a.allFinite() || !nearest.on_b.allFinite());
      const double exact = static_cast<double>(std::sqrt(distance2)), size = size_of(a, b);
      worst = std::max(worst, std::abs(nearest.distance - exact) / (exact + 1e-3 * size));
      off_points = std::max(off_points, std::abs((nearest.on_a - nearest.on_b).norm() - exact) / size);
      off_points = std::max(off_points, distance_to_triangle(nearest.on_a, a) / size);
      off_points = std::max(off_points, distance_to_triangle(nearest.on_b, b) / size);
      const double bound = between(random, 0.5, 2) * exact;
      const NearestPoints bounded = nearest_points(a, b, bound);
      unlike +=
          static_cast<int>(nearest.distance < bound ? bounded.distance != nearest.distance : bounded.distance < bound);
    }
    INFO(family.name << ": " << crossing << " of 6000 cross");
    CHECK(wrong == 0);
    CHECK(zeros == 0);
    CHECK(nan == 0);
    CHECK(unlike == 0);
    CHECK(worst < 1e-12);
    CHECK(off_points < 1e-14);
  }
}
