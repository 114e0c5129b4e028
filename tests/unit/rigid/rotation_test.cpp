// SPDX-License-Identifier: Apache-2.0
#include "rigid/rotation.hpp"

#include <catch2/catch.hpp>

using namespace brunt;
using namespace brunt::rigid;

namespace {

/// Central differences of a vector of a rotation by small rotations of space.
template <class Vector>
Mat3 slope_of(const Eigen::Quaterniond& rotation, const Vector& vector) {
  constexpr double h = 1e-5;  // an error of h^2 and of rounding over h
  Mat3 slope;
  for (int c = 0; c < 3; ++c)
    slope.col(c) =
        (vector(rotation_by(h * Vec3::Unit(c)) * rotation) - vector(rotation_by(-h * Vec3::Unit(c)) * rotation)) /
        (2 * h);
  return slope;
}

}  // namespace

TEST_CASE("rotation vectors: there and back, small and large, their slopes against differences", "[oracle]") {
  const Vec3 turn =
      GENERATE(Vec3(0, 0, 0), Vec3(1e-9, 2e-9, 0), Vec3(3e-3, -4e-3, 1e-3), Vec3(0.3, -0.2, 0.5), Vec3(1.5, 1.2, -2));
  const Eigen::Quaterniond rotation = rotation_by(turn);
  CHECK((rotation_vector(rotation) - turn).norm() <= 1e-15 * (1 + turn.norm()));
  CHECK((rotation.toRotationMatrix() -
         Mat3(Eigen::AngleAxisd(turn.norm(), turn.norm() > 0 ? Vec3(turn.normalized()) : Vec3(Vec3::UnitX()))))
            .norm() < 2e-15);
  const Mat3 slope = slope_of(rotation, [](const Eigen::Quaterniond& q) { return rotation_vector(q); });
  CHECK((rotation_vector_slope(turn) - slope).norm() < 1e-9);
}

TEST_CASE("half turns: r' - r = 2 h x (r + r')/2, slope against differences", "[oracle]") {
  const Eigen::Quaterniond rotation = rotation_by(Vec3(0.7, -0.4, 1.1));
  const Vec3 h = half_turn(rotation), r(1, 2, -0.5), turned = rotation * r;
  CHECK(h.norm() == Approx(std::tan(0.5 * Vec3(0.7, -0.4, 1.1).norm())).epsilon(1e-14));
  CHECK((turned - r - h.cross(r + turned)).norm() < 1e-14);
  const Mat3 slope = slope_of(rotation, [](const Eigen::Quaterniond& q) { return half_turn(q); });
  CHECK((half_turn_slope(h) - slope).norm() < 1e-9);
}
