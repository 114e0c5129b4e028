// SPDX-License-Identifier: Apache-2.0
#include "contact/lists/list_motion.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace brunt;
using namespace brunt::contact;

namespace {

struct Cloud {
  std::vector<Vec3> place, velocity, before;
  ListMotion motion;

  explicit Cloud(const std::vector<Vec3>& start)
      : place(start), velocity(start.size(), Vec3::Zero()), before(start.size(), Vec3::Zero()) {
    motion.start();
    for (const Vec3& one : start) motion.put(one);
  }
  [[nodiscard]] VelocitySpan span() const {
    VelocitySpan span;
    span.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < place.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto k = static_cast<int>(c);
        span[c] = std::max(span[c], before[i][k]);
        span[3 + c] = std::max(span[3 + c], -before[i][k]);
        span[6 + c] = std::max(span[6 + c], velocity[i][k]);
        span[9 + c] = std::max(span[9 + c], -velocity[i][k]);
      }
    return span;
  }
  [[nodiscard]] MotionSpan look(double dt) const {
    ListMotion::Sum sum(motion, dt);
    for (std::size_t i = 0; i < place.size(); ++i) sum.add(i, place[i], velocity[i]);
    return sum.span();
  }
  void move(double dt) {
    for (std::size_t i = 0; i < place.size(); ++i) place[i] += dt * velocity[i];
    before = velocity;
  }
};

}  // namespace

TEST_CASE("motion that all have in common uses up nothing; of what two have against each other each has half") {
  Cloud cloud({Vec3(0, 0, 0), Vec3(5, 0, 0), Vec3(0, 3, 1)});
  for (Vec3& v : cloud.velocity) v = Vec3(300, -20, 7);
  const double dt = 0.01;
  double last_dt = 0;
  for (int step = 0; step < 50; ++step) {
    cloud.motion.advance(cloud.span(), last_dt, dt);
    CHECK(cloud.motion.bound() < 3.1);  // the sweep of one step: 0.5 |dt v|
    CHECK(cloud.look(dt)[0] < 3.1);
    cloud.move(dt);
    last_dt = dt;
  }
  cloud.velocity[1] += Vec3(0, 0, 100);
  for (int step = 0; step < 50; ++step) {
    cloud.motion.advance(cloud.span(), last_dt, dt);
    cloud.move(dt);
  }
  cloud.velocity = cloud.before = std::vector<Vec3>(3, Vec3::Zero());
  cloud.motion.advance(cloud.span(), 0.0, dt);
  CHECK(cloud.motion.bound() ==
        Approx(25.0).margin(1.6));  // half of 50 steps, the last one counted when it was to come
  CHECK(cloud.look(dt)[0] == Approx(25.0).margin(1.6));
}

TEST_CASE("no thing is farther from the middle than the bound, and the bound goes on from what was found") {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const auto any = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  std::vector<Vec3> start(40);
  for (Vec3& one : start) one = any();
  Cloud cloud(start);
  double last_dt = 0, before_correction = 0;
  for (int step = 0; step < 200; ++step) {
    const double dt = 0.01 * (1 + 0.5 * std::sin(step));
    for (Vec3& v : cloud.velocity) v = Vec3(10, 0, 0) + any();
    cloud.motion.advance(cloud.span(), last_dt, dt);
    const MotionSpan found = cloud.look(dt);
    CHECK(found[0] <= cloud.motion.bound() * (1 + 1e-12));
    double farthest = 0;  // by hand, of every two things, at the end of the step
    for (std::size_t i = 0; i < start.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        farthest = std::max(farthest, (cloud.place[i] + dt * cloud.velocity[i] - start[i] -
                                       (cloud.place[k] + dt * cloud.velocity[k] - start[k]))
                                          .norm());
    CHECK(farthest <= 2 * found[0] * (1 + 1e-12));
    if (step == 150) {
      before_correction = cloud.motion.bound();
      cloud.motion.correct(found);
    }
    if (step == 151) CHECK(cloud.motion.bound() < 0.5 * before_correction);  // what goes to and fro gets nowhere
    cloud.move(dt);
    last_dt = dt;
  }
}

TEST_CASE("a wall counts with its motion; what is not finite allows nothing") {
  Cloud cloud({Vec3(0, 0, 0)});
  cloud.motion.put(Vec3(0, 0, -1));  // a wall
  cloud.motion.advance(cloud.span(), 0.0, 0.1);
  CHECK(cloud.motion.bound() == 0);
  cloud.motion.advance_one(1, Vec3(0, 0, -3), Vec3(0, 0, -20), 0.1);
  CHECK(cloud.motion.bound() == Approx(2.0));
  VelocitySpan unbounded;
  unbounded.fill(std::numeric_limits<double>::infinity());
  cloud.motion.advance(unbounded, 0.1, 0.1);
  CHECK_FALSE(cloud.motion.bound() < 1e9);

  Cloud broken({Vec3(0, 0, 0), Vec3(1, 0, 0)});
  broken.place[0][1] = std::nan("");
  CHECK_FALSE(broken.look(0.1)[0] < 1e9);  // though the last one is finite
}
