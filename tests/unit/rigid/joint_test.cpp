// SPDX-License-Identifier: Apache-2.0
// Joints: slopes against differences, systems of bodies against the equations that they solve, closed chains.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "rigid/joint_group.hpp"

using namespace brunt;
using namespace brunt::rigid;

namespace {

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  Vec3 vector() { return {number(), number(), number()}; }
  Mat3 turn() { return Eigen::Quaterniond(number(), number(), number(), number()).normalized().toRotationMatrix(); }
  Pose pose() { return {vector(), turn()}; }
  Mat6 mobility() {
    Mat6 root;
    for (double& value : root.reshaped()) value = number();
    return root * root.transpose() + Mat6::Identity();
  }

 private:
  double number() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }
  std::mt19937 engine_;
};

/// Shifted and turned by a small motion.
Pose moved(const Pose& pose, const Vec3& shift, const Vec3& turn) {
  return {pose.centre + shift, Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * pose.turn};
}

/// Four bodies in a ring of hinges about z, in a plane, at the corners of a square.
std::pair<std::vector<Joint>, std::vector<Pose>> ring() {
  std::vector<Joint> joints;
  std::vector<Pose> poses;
  for (int k = 0; k < 4; ++k) {
    const double angle = 0.5 * std::numbers::pi * k;
    poses.push_back({{std::cos(angle), std::sin(angle), 0}, Mat3::Identity()});
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 point = poses[k].centre + poses[(k + 1) % 4].centre;
    joints.push_back(make_revolute({point - poses[k].centre, point - poses[(k + 1) % 4].centre}, Vec3::UnitZ()));
  }
  return {joints, poses};
}

}  // namespace

TEST_CASE("slopes of joints are derivatives of their gaps", "[rigid][joint]") {
  Draw draw(1);
  for (int trial = 0; trial < 100; ++trial) {
    Joint joint = trial % 2 == 0 ? make_revolute({draw.vector(), draw.vector()}, draw.vector())
                                 : Joint{.kind = JointKind::ball, .arm = {draw.vector(), draw.vector()}};
    if (trial % 4 == 3) joint.holds[1] = false;
    const std::array<Pose, 2> pose{draw.pose(), draw.pose()};
    const std::array<Vec3, 2> shift{draw.vector(), draw.vector()}, turn{draw.vector(), draw.vector()};
    constexpr double h = 1e-6;
    std::array<std::array<JointRow, most_joint_rows>, 3> rows;
    std::size_t count = joint_rows(joint, pose, rows[1]);
    REQUIRE(count == rows_of(joint));
    for (const int sign : {-1, 1}) {
      const std::array<Pose, 2> there{moved(pose[0], sign * h * shift[0], sign * h * turn[0]),
                                      moved(pose[1], sign * h * shift[1], sign * h * turn[1])};
      joint_rows(joint, there, rows[static_cast<std::size_t>(sign + 1)]);
    }
    for (std::size_t k = 0; k < count; ++k) {
      double rate = 0;
      for (std::size_t side = 0; side < 2; ++side)
        rate += rows[1][k].shift[side].dot(shift[side]) + rows[1][k].turn[side].dot(turn[side]);
      CHECK(std::abs((rows[2][k].gap - rows[0][k].gap) / (2 * h) - (rate)) < 1e-8);
      // a rigid motion of both opens nothing
      const Vec3 about = turn[0], lever = pose[0].centre - pose[1].centre;
      const double together = rows[1][k].shift[0].dot(shift[0] + about.cross(lever)) +
                              rows[1][k].shift[1].dot(shift[0]) + rows[1][k].turn[0].dot(about) +
                              rows[1][k].turn[1].dot(about);
      // but what is open already, which turns with them
      std::array<Pose, 2> turned{pose[0], pose[1]};
      turned[0].centre += h * (shift[0] + about.cross(lever));
      turned[0].turn = moved(pose[0], Vec3::Zero(), h * about).turn;
      turned[1] = moved(pose[1], h * shift[0], h * about);
      std::array<JointRow, most_joint_rows> after;
      joint_rows(joint, turned, after);
      const double already = (after[k].gap - rows[1][k].gap) / h;
      CHECK(std::abs(together - (already)) < 1e-5);
    }
  }
}

TEST_CASE("the angle of a hinge", "[rigid][joint]") {
  const Joint joint = make_revolute({Vec3::Zero(), Vec3::Zero()}, Vec3(0, 0, 2));
  for (const double angle : {-3.0, -1.0, 0.0, 0.5, 3.1}) {
    const Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
    CHECK(std::abs(joint_angle(joint, {Pose{}, Pose{Vec3::Zero(), turn}}) - (angle)) < 1e-14);
  }
}

TEST_CASE("joints give their rows the wanted change and answer impulses without opening", "[rigid][joint]") {
  Draw draw(2);
  for (int trial = 0; trial < 20; ++trial) {
    // a chain of five bodies from the ground, a ball and a hinge by turns
    std::vector<Joint> joints;
    std::vector<std::array<LocalIndex, 2>> bodies;
    std::vector<Pose> pose;
    std::vector<Mat6> mobility;
    for (LocalIndex k = 0; k < 5; ++k) {
      pose.push_back(draw.pose());
      mobility.push_back(draw.mobility());
      joints.push_back(k % 2 == 0 ? make_revolute({draw.vector(), draw.vector()}, draw.vector())
                                  : Joint{.kind = JointKind::ball, .arm = {draw.vector(), draw.vector()}});
      bodies.push_back({k - 1, k});
    }
    const std::vector<JointGroup> groups = group_bodies(joints, bodies, 7);
    REQUIRE(groups.size() == 1);
    REQUIRE(groups[0].bodies.size() == 5);
    JointSystem system;
    system.form(groups[0], pose, mobility);
    REQUIRE(system.redundant() == 0);
    Eigen::VectorXd change(groups[0].rows);
    for (double& value : change) value = draw.vector()[0];
    const Eigen::VectorXd answer = system.rates(system.moved(system.on_bodies(system.impulses(change))));
    CHECK((answer - change).norm() < 1e-10 * change.norm());
    Eigen::VectorXd impulse(30);
    for (double& value : impulse) value = draw.vector()[0];
    const Eigen::VectorXd moved = system.coupled_mobility() * impulse;
    CHECK(system.rates(moved).norm() < 1e-10 * system.rates(system.moved(impulse)).norm());
    CHECK(impulse.dot(moved) > 0);
    CHECK(impulse.dot(moved) < impulse.dot(system.moved(impulse)));
  }
}

TEST_CASE("groups are joined by bodies, not by the ground", "[rigid][joint]") {
  const std::vector<Joint> joints(4);
  const std::vector<std::array<LocalIndex, 2>> bodies{{no_index, 4}, {1, no_index}, {3, 1}, {4, 5}};
  const std::vector<JointGroup> groups = group_bodies(joints, bodies, 6);
  REQUIRE(groups.size() == 2);
  CHECK(groups[0].bodies == std::vector<LocalIndex>{1, 3});
  CHECK(groups[1].bodies == std::vector<LocalIndex>{4, 5});
  CHECK(groups[0].rows == 6);
  CHECK(groups[1].joints[0].body == std::array<LocalIndex, 2>{no_index, 0});
}

TEST_CASE("a plane ring of four hinges has three redundant rows and opens nowhere", "[rigid][joint]") {
  const auto [joints, pose] = ring();
  const std::vector<JointGroup> groups =
      group_bodies(joints, std::vector<std::array<LocalIndex, 2>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}}, 4);
  REQUIRE(groups.size() == 1);
  JointSystem system;
  const std::vector<Mat6> mobility(4, Mat6::Identity());
  system.form(groups[0], pose, mobility);
  CHECK(system.redundant() == 3);
  CHECK(JointSystem::gaps(groups[0], pose).norm() < 1e-15);
  Eigen::VectorXd impulse = Eigen::VectorXd::LinSpaced(24, -1, 2);
  CHECK(system.rates(system.coupled_mobility() * impulse).norm() < 1e-12);
}
