// SPDX-License-Identifier: Apache-2.0
#include "implicit/walls/wall_spring.hpp"

#include <array>
#include <catch2/catch.hpp>

using namespace brunt;
using namespace brunt::implicit;

namespace {

/// A node that has come to `travel` from (0.1, 0, -0.02), between two oblique walls.
WallAction at(const Vec3& travel, double friction, bool bilateral = false) {
  const Vec3 x = Vec3(0.1, 0, -0.02) + travel;
  const std::array<WallMeeting, 2> meetings{
      WallMeeting{Vec3(0, 0, 1), x[2], friction, bilateral},
      WallMeeting{Vec3(1, 0, 1).normalized(), Vec3(1, 0, 1).normalized().dot(x) - 0.1, 0.5 * friction, false}};
  WallQuestion question;
  question.meetings = meetings;
  question.left = Vec3(1, 2, 3);
  question.travel = travel;
  question.friction_before = Vec3(0.1, -0.2, 0);
  question.stiffness = 50;
  return spring(question, {});
}

}  // namespace

TEST_CASE("springs at walls: forces by penetration, nothing in front of a wall, bilateral walls pull", "[oracle]") {
  const WallAction action = at(Vec3(0.2, 0, 0), 0);
  CHECK(action.pressure[0] == Approx(1).epsilon(1e-14));
  CHECK(action.pressure[1] == 0);
  CHECK((action.left - Vec3(1, 2, 2)).norm() < 1e-14);
  CHECK(action.rows == Mat3::Identity());
  CHECK(at(Vec3(0.2, 0, 0.1), 0).pressure[0] == 0);
  CHECK(at(Vec3(0.2, 0, 0.1), 0, true).pressure[0] == Approx(-4).epsilon(1e-13));
}

TEST_CASE("springs at walls: what touches is stiff in the first iterate", "[oracle]") {
  const WallMeeting meeting{Vec3(0, 0, 1), 0.0, 0.2, false};
  WallQuestion question;
  question.meetings = {&meeting, 1};
  question.stiffness = 7;
  WallChoice touches;
  touches.active[0] = true;
  CHECK(spring(question, touches).own.isZero(0));
  question.first = true;
  CHECK(spring(question, touches).own(2, 2) == 7);
  CHECK(spring(question, touches).own(0, 0) == 7);
  CHECK(spring(question, {}).own.isZero(0));
}

TEST_CASE("springs at walls: sliding friction is Coulomb's, the slope is the derivative", "[oracle]") {
  const WallAction slides = at(Vec3(0.2, 0.3, 0), 0.4);
  CHECK(slides.choice.slides);
  CHECK(slides.friction.norm() == Approx(0.4).epsilon(1e-13));
  for (const Vec3& travel : {Vec3(0.2, 0.3, 0), Vec3(1e-4, -2e-4, -0.01), Vec3(-0.05, 0.1, -0.03)})
    for (const bool bilateral : {false, true})
      for (int c = 0; c < 3; ++c) {
        constexpr double h = 1e-7;
        const Vec3 slope = (at(travel + h * Vec3::Unit(c), 0.4, bilateral).left -
                            at(travel - h * Vec3::Unit(c), 0.4, bilateral).left) /
                           (2 * h);
        CHECK((at(travel, 0.4, bilateral).own.col(c) - slope).norm() < 1e-6 * 500);
      }
}
