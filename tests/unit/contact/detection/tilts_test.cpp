// SPDX-License-Identifier: Apache-2.0
// Rows with friction across a gap: no moment, and no rate of a common rotation, by the definitions alone.
#include "contact/detection/tilts.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

using namespace brunt;
using namespace brunt::contact;

namespace {

struct Random {
  std::mt19937 generator{5};
  double number(double low, double high) { return std::uniform_real_distribution<>(low, high)(generator); }
  Vec3 vector() { return {number(-1, 1), number(-1, 1), number(-1, 1)}; }
};

/// A node at the height over a place on a face, warped, of four or three corners.
struct NodeOnFace {
  std::vector<NodeMotion> motion;
  Row row;

  NodeOnFace(Random& random, std::int32_t corners, double height) {
    const Vec3 places[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const auto weighted = static_cast<std::size_t>(corners);
    row.key.kind = RowKind::mortar;
    row.nodes[0] = 0;
    row.weights[0] = 1;
    row.node_count = 1;
    motion.resize(1);
    double left = 1;
    Vec3 place = Vec3::Zero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(corners); ++i) {
      const Vec3 corner = places[i] + 0.1 * random.vector();
      motion.push_back({.position = corner});
      const double weight = i + 1 == weighted ? left : 0.3 * left;
      left -= weight;
      place += weight * corner;
      row.nodes[i + 1] = static_cast<LocalIndex>(i + 1);
      row.weights[i + 1] = -weight;
      ++row.node_count;
    }
    row.normal = (Vec3(0, 0, 1) + 0.2 * random.vector()).normalized();
    row.friction = 0.3;
    motion[0].position = place + height * row.normal;
  }
};

Vec3 moment_of(const Row& row, std::span<const NodeMotion> motion, const Vec3& impulse) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < row.points().size(); ++i)
    sum += nth(motion, row.points()[i]).position.cross(impulse_on_node(row, i, impulse));
  return sum;
}

Vec3 force_of(const Row& row, const Vec3& impulse) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < row.points().size(); ++i) sum += impulse_on_node(row, i, impulse);
  return sum;
}

void check(const Row& row, std::span<const NodeMotion> motion, Random& random) {
  REQUIRE(row.tilts.size() == row.points().size());
  const Vec3 impulse = random.vector(), spin = random.vector(), shift = random.vector();
  CHECK(moment_of(row, motion, impulse).norm() < 1e-14);
  CHECK(force_of(row, impulse).norm() < 1e-14);
  const auto rigid = [&](LocalIndex node) -> Vec3 { return shift + spin.cross(nth(motion, node).position); };
  CHECK(relative_velocity(row, rigid).norm() < 1e-14);
  // along the normal nothing changes
  const auto any = [&](LocalIndex node) -> Vec3 {
    return Vec3(std::sin(1.0 + node), std::cos(3.0 * node), 0.3 * node);
  };
  Row bare = row;
  bare.tilts = {};
  CHECK(row.normal.dot(relative_velocity(row, any) - relative_velocity(bare, any)) == Approx(0).margin(1e-15));
  CHECK((relative_velocity(row, any) - relative_velocity(bare, any)).norm() > 1e-4);
}

}  // namespace

TEST_CASE("friction over a face has no moment", "[law]") {
  Random random;
  for (const std::int32_t corners : {3, 4})
    for (const double height : {0.05, -0.02}) {
      NodeOnFace pair(random, corners, height);
      TiltStore store;
      store.start({&pair.row, 1});
      tilt_row(pair.row, {.motion = pair.motion}, store,
               [](std::size_t i) { return i == 0 ? 0.0 : 0.5 + 0.1 * static_cast<double>(i); });
      check(pair.row, pair.motion, random);
    }
}

TEST_CASE("rows without friction, rows of nodes and heights of rounding have no tilts", "[law]") {
  Random random;
  NodeOnFace pair(random, 4, 1e-12);
  TiltStore store;
  store.start({&pair.row, 1});
  tilt_row(pair.row, {.motion = pair.motion, .least = 1e-9}, store, [](std::size_t i) { return i == 0 ? 0.0 : 1.0; });
  CHECK(pair.row.tilts.empty());
  CHECK(has_tilts(pair.row));
  pair.row.friction = 0;
  CHECK_FALSE(has_tilts(pair.row));
  pair.row.friction = 0.3;
  pair.row.key.kind = RowKind::face;
  CHECK_FALSE(has_tilts(pair.row));
}
