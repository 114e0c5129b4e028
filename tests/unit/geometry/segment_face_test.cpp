// SPDX-License-Identifier: Apache-2.0
// Segments through triangles and bilinear quadrilaterals.
#include "geometry/segment_face.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "shots.hpp"

using brunt::Vec3;
using namespace brunt::geometry;
using namespace brunt::geometry::testing;

namespace {

const std::array<Vec3, 3> triangle{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
/// z = x y: the hyperbolic paraboloid on the square [-1, 1]^2.
const std::array<Vec3, 4> saddle{Vec3(-1, -1, 1), Vec3(1, -1, -1), Vec3(1, 1, 1), Vec3(-1, 1, -1)};

}  // namespace

TEST_CASE("a segment through a triangle: where, and from which side") {
  const auto in = segment_crosses_face({{0.25, 0.5, 3}, {0.25, 0.5, -1}}, triangle);
  REQUIRE(in);
  CHECK(in->along == Approx(0.75).epsilon(1e-15));
  CHECK((in->point - Vec3(0.25, 0.5, 0)).norm() < 1e-15);
  CHECK((in->normal - Vec3::UnitZ()).norm() < 1e-15);
  CHECK(in->inward);
  CHECK(in->region == Region::face);
  CHECK(in->weights[1] == Approx(0.25).epsilon(1e-15));
  CHECK_FALSE(segment_crosses_face({{0.25, 0.5, -1}, {0.25, 0.5, 3}}, triangle)->inward);

  CHECK_FALSE(segment_crosses_face({{0.6, 0.6, 1}, {0.6, 0.6, -1}}, triangle));       // beside
  CHECK_FALSE(segment_crosses_face({{0.2, 0.2, 1}, {0.2, 0.2, 0.001}}, triangle));    // too short
  CHECK_FALSE(segment_crosses_face({{-1, 0.2, 0}, {2, 0.2, 0}}, triangle));           // in the plane
  CHECK_FALSE(segment_crosses_face({{0.2, 0.2, 0}, {0.2, 0.2, 0}}, triangle));        // no length
  CHECK(segment_crosses_face({{0.2, 0.2, 0}, {0.2, 0.2, 1}}, triangle)->along == 0);  // starts on it
  CHECK(segment_crosses_face({{0.5, 0.5, 1}, {0.5, 0.5, -1}}, triangle)->region == Region::edge1);
  CHECK(segment_crosses_face({{0, 0, 1}, {0, 0, -1}}, triangle)->region == Region::vertex0);
  CHECK(segment_crosses_face({{0, 1, 1}, {0, 1, -1}}, triangle)->region == Region::vertex2);
}

TEST_CASE("a segment through a saddle meets z = x y, twice where the quadratic says so, and names the first") {
  // along x = y = p, z = 0.25: 0.25 = p^2 at p = -1/2 and p = 1/2
  const auto first = segment_crosses_face({{-1, -1, 0.25}, {1, 1, 0.25}}, saddle);
  REQUIRE(first);
  CHECK((first->point - Vec3(-0.5, -0.5, 0.25)).norm() < 1e-14);
  CHECK(first->along == Approx(0.25).epsilon(1e-14));
  const auto back = segment_crosses_face({{1, 1, 0.25}, {-1, -1, 0.25}}, saddle);
  REQUIRE(back);
  CHECK((back->point - Vec3(0.5, 0.5, 0.25)).norm() < 1e-14);
  CHECK_FALSE(segment_crosses_face({{-1, -1, -0.01}, {1, 1, -0.01}}, saddle));  // p^2 = -0.01
  CHECK_FALSE(segment_crosses_face({{-0.4, -0.4, 0.25}, {0.4, 0.4, 0.25}}, saddle));
}

TEST_CASE("random segments through random faces against the plane and against the quadratic of the saddle") {
  Random random(6);
  int different = 0, hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const Segment s{random_vector(random, 1.5), random_vector(random, 1.5)};
    const Vec3 d = s.end - s.start;
    // z(a) - x(a) y(a) = 0 along the segment: roots of a quadratic
    const double p = -d.x() * d.y(), q = d.z() - s.start.x() * d.y() - s.start.y() * d.x(),
                 r = s.start.z() - s.start.x() * s.start.y(), discriminant = q * q - 4 * p * r;
    double first = 2;
    if (discriminant > 0) {
      for (const double sign : {-1.0, 1.0}) {
        const double a = (-q + sign * std::sqrt(discriminant)) / (2 * p);
        const Vec3 x = s.start + a * d;
        if (a >= 0 && a <= 1 && x.head<2>().cwiseAbs().maxCoeff() <= 1) first = std::min(first, a);
      }
    }
    const auto hit = segment_crosses_face(s, saddle);
    if (hit.has_value() != (first <= 1) || (hit && std::abs(hit->along - first) > 1e-9)) ++different;
    hits += hit.has_value();
  }
  CHECK(different == 0);
  CHECK(hits > 500);
}

TEST_CASE("segments through shared edges pierce one of the two faces at least") {
  Random random(9);
  int missed = 0;
  for (int i = 0; i < 2000; ++i) {
    std::array<Vec3, 6> x{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(2, 1, 0)};
    for (Vec3& corner : x) corner += random_vector(random, 0.2);
    const double share = between(random, 0, 1);
    const Vec3 place = (1 - share) * x[1] + share * x[4], through = Vec3(0, 0, 1) + random_vector(random, 0.2);
    const Segment s{place + 0.7 * through, place - 0.4 * through};
    const std::array<Vec3, 4> left{x[0], x[1], x[4], x[3]}, right{x[1], x[2], x[5], x[4]};
    if (!segment_crosses_face(s, left) && !segment_crosses_face(s, right)) ++missed;
  }
  CHECK(missed == 0);
}

TEST_CASE("faces without area and input that is not finite give nothing") {
  const std::array<Vec3, 3> line{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)};
  const std::array<Vec3, 4> row{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)};
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  CHECK_FALSE(segment_crosses_face({{0.5, 0, 1}, {0.5, 0, -1}}, line));
  CHECK_FALSE(segment_crosses_face({{0.5, 0, 1}, {0.5, 0, -1}}, row));
  CHECK_FALSE(segment_crosses_face({{nan, 0.2, 1}, {0.2, 0.2, -1}}, triangle));
  CHECK_FALSE(segment_crosses_face({{0.2, 0.2, infinity}, {0.2, 0.2, -1}}, triangle));
}
