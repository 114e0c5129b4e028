// SPDX-License-Identifier: Apache-2.0
// The second order of a gap against the exact motion of bodies that turn, and where no multiple of impulses gains
// enough.
#include "contact/jams.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

using namespace brunt;
using namespace brunt::contact;

namespace {

Vec3 turned(const Vec3& angle, const Vec3& v) {
  return angle.norm() > 0 ? Vec3(Eigen::AngleAxisd(angle.norm(), angle.normalized()) * v) : v;
}

/// Of a slave against the plane of a face, both on bodies that move; less its linear part.
double beyond_linear(const SecondOrder& gap, const SecondOrder::Motion& motion) {
  const Vec3 slave = gap.reach + motion.shift - motion.turn.cross(gap.arm) - gap.arm + turned(motion.turn, gap.arm);
  const double exact = turned(motion.master_turn, gap.normal).dot(slave) - gap.normal.dot(gap.reach);
  return exact - gap.normal.dot(motion.shift - motion.master_turn.cross(gap.reach));
}

}  // namespace

TEST_CASE("the second order of a gap is what a turn of both bodies leaves beyond the linear motion") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1, 1);
  const auto vector = [&] { return Vec3(part(random), part(random), part(random)); };
  for (int k = 0; k < 20; ++k) {
    const SecondOrder gap{.normal = vector().normalized(), .arm = vector(), .reach = vector()};
    const SecondOrder::Motion motion{1e-4 * vector(), 1e-4 * vector(), 1e-4 * vector()};
    CHECK(beyond_linear(gap, motion) == Approx(gap.of(motion)).margin(1e-11));  // 1e-8 and its third order
  }
}

TEST_CASE("a face on a pivot that is pressed beside the line to it gives way by lever^2 / (2 distance), and no more") {
  const double distance = 15, lever = 0.3, most = lever * lever / (2 * distance);
  for (const double pressed : {0.9, 1.1}) {
    const double gain = pressed * most, turn = gain / lever;  // of the linear solution
    const SecondOrder gap{.normal = Vec3::UnitX(), .reach = Vec3(distance, lever, 0)};
    const double second = gap.of({.master_turn = Vec3(0, 0, turn)});
    CHECK(second == Approx(-0.5 * distance * turn * turn));
    CHECK(has_no_multiple(gain, second, gain) == (pressed > 1));
  }
}
