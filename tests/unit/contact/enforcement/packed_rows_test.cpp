// SPDX-License-Identifier: Apache-2.0
// Rows side by side against the same rows one by one: equal bits for any mixture of rows in a batch.
#include "contact/enforcement/packed_rows.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace brunt;
using namespace brunt::contact;

namespace {

struct Random {
  std::mt19937 generator;
  double number(double low, double high) { return std::uniform_real_distribution<>(low, high)(generator); }
  int whole(int low, int high) { return std::uniform_int_distribution<>(low, high)(generator); }
  Vec3 vector() { return {number(-1, 1), number(-1, 1), number(-1, 1)}; }
};

struct Scene {
  RowMatrix rows;
  std::vector<double> diagonal, compliance;
  std::vector<Vec3> borne, impulses, velocity;

  Scene(Random& random, std::size_t count) {
    for (int n = 0; n < 30; ++n) velocity.push_back(random.vector());
    for (std::size_t q = 0; q < count; ++q) add_row(random);
  }

  void add_row(Random& random) {
    RowLaw law{.normal = random.vector().normalized(),
               .required = random.number(-0.5, 0.5),
               .drift = random.whole(0, 1) == 1 ? Vec3(0.1 * random.vector()) : Vec3::Zero(),
               .noise = 1e-14,
               .share = random.number(1, 2),
               .cone = random.whole(0, 2) == 0 ? Cone::free : Cone::compression,
               .across = static_cast<Across>(random.whole(0, 2)),
               .turns = random.whole(0, 4) == 0};
    law.tilts = !law.turns && random.whole(0, 2) == 0;
    if (law.across == Across::rubs) law.friction = random.number(0, 1);
    if (law.across == Across::rubs && random.whole(0, 1) == 1) law.lagging = random.number(0, 0.2);
    if (random.whole(0, 3) == 0) law.softness = 0.05;
    const int entries = random.whole(1, 5);
    for (int k = 0; k < entries; ++k) {
      const auto point = static_cast<LocalIndex>(random.whole(0, 29));
      if (law.turns)
        rows.add(point, random.number(-1, 1), Arm{0.3 * Mat3(random.vector() * random.vector().transpose()), 0.6});
      else if (law.tilts)
        rows.add(point, random.number(-1, 1), Vec3(0.3 * random.vector()));
      else
        rows.add(point, random.number(-1, 1));
    }
    rows.close_row(law, {});
    diagonal.push_back(random.whole(0, 9) == 0 ? 0.0 : random.number(0.5, 3));
    compliance.push_back(law.softness > 0 ? random.number(0, 0.5) : 0.0);
    borne.push_back(law.softness > 0 ? Vec3(0.1 * random.vector()) : Vec3::Zero());
    impulses.push_back(diagonal.back() > 0 ? random.vector() : Vec3::Zero());
  }
};

/// The iterate of rows one by one.
struct OneByOne {
  const Scene& scene;
  std::vector<Vec3> impulses = scene.impulses, previous = scene.impulses,
                    missing = std::vector<Vec3>(scene.impulses.size(), Vec3::Zero());

  RowsSeen judge(const std::vector<Vec3>& velocity, const FixedUnit* unit) {
    RowsSeen seen;
    for (std::size_t q = 0; q < scene.rows.size(); ++q) {
      const double h = scene.diagonal[q];
      if (!(h > 0)) continue;
      const RowLaw& law = scene.rows.laws[q];
      const auto velocity_of = [&](LocalIndex node) -> const Vec3& { return nth(velocity, node); };
      Vec3 left = missing_rate(law, relative_velocity(scene.rows, q, velocity_of));
      if (law.softness > 0) left += scene.borne[q] - scene.compliance[q] * impulses[q];
      const Vec3 change = impulses[q] - previous[q], a_change = missing[q] - left;
      if (unit != nullptr) {
        seen.change_h_change += unit->of(h * change.squaredNorm());
        seen.change_a_change += unit->of(change.dot(a_change));
        seen.a_change_a_change += unit->of(a_change.squaredNorm() / h);
      }
      missing[q] = left;
      const double step = (admitted(law, impulses[q] + left / h) - impulses[q]).norm();
      const double slope = law.across == Across::rubs ? std::hypot(1.0, law.friction) : law.share;
      const double rise = law.cone == Cone::compression ? std::max(0.0, law.normal.dot(left)) : left.norm();
      seen.residual = std::max(seen.residual, h * step - law.noise);
      seen.energy = std::max(seen.energy, h * step * step);
      seen.impulse = std::max(seen.impulse, slope * impulses[q].norm() + law.lagging);
      seen.rise = std::max(seen.rise, slope * rise / h);
      seen.speed = std::max(seen.speed, nth(velocity, scene.rows.points[scene.rows.begin(q)]).cwiseAbs().maxCoeff());
    }
    return seen;
  }
  void advance(double length) {
    for (std::size_t q = 0; q < scene.rows.size(); ++q) {
      const double h = scene.diagonal[q];
      previous[q] = impulses[q];
      impulses[q] = h > 0 ? admitted(scene.rows.laws[q], impulses[q] + length / h * missing[q]) : Vec3::Zero();
    }
  }
};

bool same(const RowsSeen& a, const RowsSeen& b) {
  return a.residual == b.residual && a.energy == b.energy && a.impulse == b.impulse && a.rise == b.rise &&
         a.speed == b.speed && a.change_h_change == b.change_h_change && a.change_a_change == b.change_a_change &&
         a.a_change_a_change == b.a_change_a_change;
}

}  // namespace

TEST_CASE("rows side by side have the bits of rows one by one", "[law]") {
  Random random{std::mt19937(7)};
  for (const std::size_t count : {0, 1, 3, 4, 7, 8, 9, 40, 333}) {
    const Scene scene(random, count);
    OneByOne alone{scene};
    PackedRows packed;
    packed.lay(scene.rows, scene.diagonal, scene.compliance, scene.borne, scene.impulses);
    std::vector<Vec3> velocity = scene.velocity, impulses = scene.impulses;
    const FixedUnit unit(4.0);
    for (int step = 0; step < 4; ++step) {
      packed.take_velocities(velocity);
      const FixedUnit* sums = step > 0 ? &unit : nullptr;
      CHECK(same(packed.judge(scene.rows, sums), alone.judge(velocity, sums)));
      packed.advance(1 + step, impulses);
      alone.advance(1 + step);
      CHECK(impulses == alone.impulses);
      for (Vec3& v : velocity) v += 0.2 * random.vector();
    }
  }
}

TEST_CASE("a velocity that is not a number makes the residual infinite", "[law]") {
  Random random{std::mt19937(8)};
  Scene scene(random, 20);
  scene.diagonal.assign(20, 1.0);
  PackedRows packed;
  packed.lay(scene.rows, scene.diagonal, scene.compliance, scene.borne, scene.impulses);
  std::vector<Vec3> velocity = scene.velocity;
  nth(velocity, scene.rows.points[5])[1] = std::nan("");
  packed.take_velocities(velocity);
  CHECK(std::isinf(packed.judge(scene.rows, nullptr).residual));
}

TEST_CASE("rows begin again from nothing", "[law]") {
  Random random{std::mt19937(9)};
  const Scene scene(random, 20);
  PackedRows packed;
  packed.lay(scene.rows, scene.diagonal, scene.compliance, scene.borne, scene.impulses);
  packed.take_velocities(scene.velocity);
  packed.reset();
  const FixedUnit unit(4.0);
  const RowsSeen seen = packed.judge(scene.rows, &unit);
  CHECK(seen.change_h_change == 0);
  CHECK(seen.change_a_change == 0);
}
