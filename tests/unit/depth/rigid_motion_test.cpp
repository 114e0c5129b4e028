// SPDX-License-Identifier: Apache-2.0
// Rigid motions against each other and against their definitions, with angles from 1e-12 to pi.
#include "depth/rigid_motion.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/random_motion.hpp"

using namespace brunt;
using namespace brunt::depth;
using test::Random;

namespace {

constexpr double pi = std::numbers::pi;

double distance(const RigidMotion& a, const RigidMotion& b) {
  return (a.shift - b.shift).norm() + (rotation_less_identity(a.turn) - rotation_less_identity(b.turn)).norm();
}

/// Angles that break formulas: tiny, moderate, next to pi.
double angle(Random& random, int i) {
  constexpr double decades = 12;
  if (i % 3 == 0) return std::pow(10, -decades * random.uniform());
  if (i % 3 == 1) return pi - std::pow(10, -decades * random.uniform());
  return pi * random.uniform();
}

RigidMotion motion(Random& random, int i) {
  return {rotation_of(angle(random, i) * random.direction()), random.vector()};
}

}  // namespace

TEST_CASE("logarithm and exponential of rotations invert each other near 0 and near pi") {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 w = angle(random, i) * random.direction();
    CHECK((rotation_vector(rotation_of(w)) - w).norm() <= 1e-15 * 4 * w.norm());
  }
  CHECK(rotation_vector(Eigen::Quaterniond::Identity()).norm() == 0);
  const Vec3 tiny(1e-200, 0, 0);
  CHECK((rotation_vector(rotation_of(tiny)) - tiny).norm() == 0);
}

TEST_CASE("R - I keeps its digits for small angles") {
  const Vec3 u = Vec3(1, -2, 2) / 3, y(.3, .2, -.7);
  for (double phi = 1; phi > 1e-100; phi *= 0.01) {
    const Vec3 d = rotation_less_identity(rotation_of(phi * u)) * y;
    CHECK(d.norm() == Approx(2 * std::sin(0.5 * phi) * u.cross(y).norm()).epsilon(1e-14));
  }
}

TEST_CASE("a motion leads from one placement to the other") {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Placement from = random.placement();
    const Vec3 centroid = random.vector(), x = random.vector();
    const RigidMotion m = motion(random, i);
    const Placement to = moved(from, m, centroid);
    // by definition
    const Vec3 y = x - centroid;
    const Vec3 expected = from(x) + from.rotation * (m.shift + rotation_less_identity(m.turn) * y);
    CHECK((to(x) - expected).norm() < 1e-13);
    CHECK((to.rotation * to.rotation.transpose() - Mat3::Identity()).norm() < 1e-14);
    CHECK(distance(motion_between(from, to, centroid), m) < 1e-13);
  }
}

TEST_CASE("motions compose") {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Placement from;
    const Vec3 centroid = random.vector(), x = random.vector();
    const RigidMotion first = motion(random, i), second = motion(random, i / 3);
    const Vec3 once = moved(from, first, centroid)(x), middle = moved(from, first, centroid)(centroid);
    const Vec3 twice = middle + second.shift + (second.turn * (once - middle));
    CHECK((moved(from, compose(first, second), centroid)(x) - twice).norm() < 1e-13);
  }
}

TEST_CASE("the screw has the motion's displacements; points go straight along and round its axis") {
  Random random(4);
  for (int i = 0; i < 3000; ++i) {
    const RigidMotion m = motion(random, i);
    const Screw screw = screw_of(m);
    const Vec3 y = random.vector();
    const Vec3 d = m.shift + rotation_less_identity(m.turn) * y;
    if (screw.angle > 1e-4) {
      const double arm = screw.axis.cross(y - screw.point).norm(), sine = 2 * std::sin(0.5 * screw.angle);
      CHECK(d.norm() == Approx(std::hypot(screw.slide, sine * arm)).epsilon(1e-10));
    }
    const double s = random.uniform();
    const RigidMotion part = along_screw(m, s);
    CHECK(distance(along_screw(m, 1), m) < 1e-14);
    CHECK(distance(along_screw(m, 0), {}) < 1e-15);
    // the same screw again from there on: s + (1 - s) = 1
    const RigidMotion rest = along_screw(m, 1 - s);
    const Vec3 at_part = y + part.shift + rotation_less_identity(part.turn) * y;
    const Vec3 at_end = at_part + rest.shift + rotation_less_identity(rest.turn) * at_part;
    CHECK((at_end - (y + d)).norm() < 1e-12);
    CHECK(rotation_vector(part.turn).norm() == Approx(s * screw.angle).epsilon(1e-12).margin(1e-300));
    CHECK((part.shift + rotation_less_identity(part.turn) * y).norm() <= d.norm() * (1 + 1e-13));
  }
}
