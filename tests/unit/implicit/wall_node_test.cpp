// SPDX-License-Identifier: Apache-2.0
#include "implicit/walls/wall_node.hpp"

#include <Eigen/Geometry>
#include <array>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

using namespace brunt;
using namespace brunt::implicit;

namespace {

constexpr double stiffness = 50;

/// A node on springs: what is left is linear in its travel.
struct Springs {
  Mat3 spring;
  Vec3 load;
  Mat3 free = Mat3::Identity();
  std::vector<WallMeeting> walls;  // gaps at no travel
  bool first = false;

  [[nodiscard]] WallAction at(const Vec3& travel, const WallChoice& solved) const {
    std::vector<WallMeeting> meetings = walls;
    for (WallMeeting& wall : meetings) wall.gap += wall.normal.dot(travel);
    return act({meetings, free, free * (spring * travel - load), travel, Vec3::Zero(), stiffness, first}, solved);
  }
  [[nodiscard]] double left_at(const Vec3& travel, const WallChoice& solved) const {
    return (at(travel, solved).left + stiffness * (travel - free * travel)).norm();
  }
  /// Newton's iteration from rest, as a step makes it: later corrections that leave more than before are halved.
  [[nodiscard]] Vec3 solve(WallAction& action) const {
    Vec3 travel = Vec3::Zero();
    WallChoice solved;
    for (int i = 0; i < 40; ++i) {
      action = at(travel, solved);
      const Mat3 slope = action.rows * (free * spring) + action.own + stiffness * (Mat3::Identity() - free);
      const Vec3 left = action.left + stiffness * (travel - free * travel);
      if (i > 0 && left.norm() < 1e-12) break;
      const Vec3 step = slope.partialPivLu().solve(left);
      solved = action.choice;
      double share = 1;
      while (i > 4 && share > 0.05 && left_at(travel - share * step, solved) > left.norm()) share *= 0.5;
      travel -= share * step;
    }
    return travel;
  }
};

Springs random_springs(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  Springs springs;
  const Mat3 root = Mat3::NullaryExpr([&] { return any(random); });
  springs.spring = 10 * Mat3::Identity() + 3 * root * root.transpose();
  springs.load = Vec3::NullaryExpr([&] { return 5 * any(random); });
  return springs;
}

}  // namespace

TEST_CASE("a node far from all walls keeps its equations", "[oracle]") {
  std::mt19937 random(1);
  Springs springs = random_springs(random);
  springs.walls = {{Vec3::UnitZ(), 5, 0.3, false}};
  const WallAction action = springs.at(Vec3(0.1, 0.2, 0.3), {});
  CHECK(action.rows == Mat3::Identity());
  CHECK(action.own == Mat3::Zero());
  CHECK(action.left == springs.spring * Vec3(0.1, 0.2, 0.3) - springs.load);
  CHECK(action.pressure[0] == 0);
}

TEST_CASE("a node at walls without friction: no wall is passed, none pulls, what moves is in balance", "[oracle]") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1, 1);
  int pressed = 0, open = 0;
  for (int trial = 0; trial < 500; ++trial) {
    CAPTURE(trial);
    Springs springs = random_springs(random);
    // a corner of one to three walls about perpendicular to each other, in any direction
    const Eigen::Quaterniond turn(Eigen::Vector4d::NullaryExpr([&] { return any(random); }).normalized());
    for (int w = 0; w <= trial % 3; ++w)
      springs.walls.push_back({(turn * (Vec3::Unit(w) + 0.2 * any(random) * Vec3::Ones())).normalized(),
                               0.1 * std::abs(any(random)), 0, false});
    WallAction action;
    const Vec3 travel = springs.solve(action);
    Vec3 force = springs.load - springs.spring * travel;
    for (std::size_t w = 0; w < springs.walls.size(); ++w) {
      const double gap = springs.walls[w].gap + springs.walls[w].normal.dot(travel);
      CHECK(gap > -1e-12);
      CHECK(action.pressure[w] >= 0);
      CHECK(std::abs(gap * action.pressure[w]) < 1e-10);
      force += action.pressure[w] * springs.walls[w].normal;
      (action.pressure[w] > 0 ? pressed : open) += 1;
    }
    CHECK(force.norm() < 1e-10);
  }
  CHECK(pressed > 200);
  CHECK(open > 200);
}

TEST_CASE("friction at a wall: within Coulomb's cone, against the slip where it slides", "[oracle]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  int sticks = 0, slides = 0;
  for (int trial = 0; trial < 500; ++trial) {
    CAPTURE(trial);
    Springs springs = random_springs(random);
    const Vec3 normal = Vec3::NullaryExpr([&] { return any(random); }).normalized();
    const double friction = 0.2 + 0.3 * std::abs(any(random));
    springs.load -= 6 * normal;
    springs.walls = {{normal, 0, friction, false}};
    WallAction action;
    const Vec3 travel = springs.solve(action);
    const Vec3 force = springs.load - springs.spring * travel + action.pressure[0] * normal + action.friction;
    CHECK(force.norm() < 1e-9);
    CHECK(normal.dot(travel) > -1e-11);
    if (action.pressure[0] == 0) continue;  // pulled off the wall
    CHECK(normal.dot(travel) < 1e-11);
    if (!action.choice.slides) {
      CHECK((action.friction + sticking_at_walls * stiffness * travel).norm() < 1e-9);
      CHECK(action.friction.norm() <= friction * action.pressure[0] * (1 + 1e-12));
      ++sticks;
    } else {
      CHECK(action.friction.norm() == Approx(friction * action.pressure[0]).epsilon(1e-9));
      CHECK((action.friction.normalized() + travel.normalized()).norm() < 1e-7);
      ++slides;
    }
  }
  CHECK(sticks > 50);
  CHECK(slides > 50);
}

TEST_CASE("rows and diagonal of a node at walls are the derivatives of what is left", "[oracle]") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-1, 1);
  int sticks = 0, slides = 0;
  for (int trial = 0; trial < 60; ++trial) {
    CAPTURE(trial);
    Springs springs = random_springs(random);
    const Vec3 normal = Vec3::NullaryExpr([&] { return any(random); }).normalized();
    springs.load -= 8 * normal;
    springs.walls = {{normal, -0.01, trial % 3 == 0 ? 0.0 : 0.3, false}};
    if (trial % 4 == 1) springs.walls.push_back({(normal + Vec3(0.3, 0.5, -0.4)).normalized(), -0.02, 0.2, false});
    WallChoice solved;
    solved.active[0] = solved.active[1] = true;
    const Vec3 travel = (trial % 2 == 0 ? 1e-3 : 0.1) * Vec3::NullaryExpr([&] { return any(random); });
    const WallAction action = springs.at(travel, solved);
    (action.choice.slides ? slides : sticks) += 1;
    const Mat3 slope = action.rows * springs.spring + action.own;
    constexpr double h = 1e-6;
    for (int c = 0; c < 3; ++c) {
      const WallAction up = springs.at(travel + h * Vec3::Unit(c), solved),
                       down = springs.at(travel - h * Vec3::Unit(c), solved);
      CHECK(((up.left - down.left) / (2 * h) - slope.col(c)).norm() < 1e-7 * slope.norm());
    }
  }
}

TEST_CASE("walls that hold what supports or other walls hold already are redundant", "[oracle]") {
  std::mt19937 random(5);
  Springs springs = random_springs(random);
  springs.load = Vec3(1, -2, -8);
  springs.free = Vec3(1, 1, 0).asDiagonal();
  springs.walls = {{Vec3::UnitZ(), 0, 0, false}, {-Vec3::UnitY(), 0, 0, false}, {-Vec3::UnitY(), 0, 0, false}};
  springs.load[1] = 20;
  WallAction action;
  const Vec3 travel = springs.solve(action);
  CHECK(std::abs(travel[1]) < 1e-12);
  CHECK(std::abs(travel[2]) < 1e-12);
  CHECK(action.pressure[0] == 0);
  CHECK(action.pressure[1] > 10);
  CHECK(action.pressure[2] == 0);
}

TEST_CASE("a bilateral wall pulls, and the first iterate takes places for balance", "[oracle]") {
  std::mt19937 random(6);
  Springs springs = random_springs(random);
  springs.load = Vec3(0, 0, 30);
  springs.walls = {{Vec3::UnitZ(), 0, 0, true}};
  WallAction action;
  CHECK(std::abs(springs.solve(action)[2]) < 1e-12);
  CHECK(action.pressure[0] < -10);
  springs.walls = {{Vec3::UnitZ(), -1e-9, 0, false}};
  springs.first = true;
  CHECK(springs.at(Vec3::Zero(), {}).choice.active[0]);
  springs.walls[0].gap = 1e-9;
  CHECK_FALSE(springs.at(Vec3::Zero(), {}).choice.active[0]);
}

TEST_CASE("a node that supports drive along a wall has friction against all of its travel", "[oracle]") {
  // driven along x, free along y: friction is mu N against the whole slip, of which y feels its share
  WallMeeting wall{Vec3::UnitZ(), 0, 0.3, false};
  WallChoice solved;
  solved.active[0] = true;
  const Mat3 free = Vec3(0, 1, 1).asDiagonal();
  const WallAction action =
      act({{&wall, 1}, free, Vec3(0, 0.5, 10), Vec3(3, 4, 0), Vec3::Zero(), stiffness, false}, solved);
  CHECK(action.choice.slides);
  CHECK(action.pressure[0] == Approx(10));
  CHECK((action.friction - Vec3(-1.8, -2.4, 0)).norm() < 1e-14);
  CHECK(action.left[1] == Approx(0.5 + 2.4));
  CHECK(action.left[0] == 0);
}

TEST_CASE("friction of a bilateral wall goes by the size of its pressure, and goes on from t_n", "[oracle]") {
  WallMeeting wall{Vec3::UnitZ(), 0, 0.5, true};
  WallChoice solved;
  const WallAction action =
      act({{&wall, 1}, Mat3::Identity(), Vec3(2, 0, -10), Vec3::Zero(), Vec3(2, 0, 1), stiffness, false}, solved);
  CHECK_FALSE(action.choice.slides);
  CHECK(action.friction == Vec3(2, 0, 0));
  CHECK(action.left.norm() < 1e-14);
  CHECK(action.pressure[0] == Approx(-10));
}
