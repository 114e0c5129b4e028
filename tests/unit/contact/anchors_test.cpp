// SPDX-License-Identifier: Apache-2.0
// Anchors move with what holds them and are dropped by distance alone.
#include "contact/anchors/anchors.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "contact/anchors/friction.hpp"

using namespace brunt;
using contact::AnchorRecord;
using contact::AnchorScene;
using contact::Row;

namespace {

/// Two unit squares side by side in the plane z = 0, the second with the lower key, and a slave over the first.
struct TwoSquares {
  std::vector<contact::MasterFace> faces{{.key = 9, .nodes = {0, 1, 4, 3}, .body = 2},
                                         {.key = 4, .nodes = {1, 2, 5, 4}, .body = 2}};
  std::vector<LocalIndex> by_key = contact::order_by_key(faces);
  std::vector<contact::NodeMotion> motion;
  std::vector<contact::Wall> walls{{.point = Vec3(0, 0, -3)}, {.point = Vec3(0, 0, -1), .normal = Vec3(0.6, 0, 0.8)}};

  TwoSquares() {
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) motion.push_back({.position = Vec3(i, j, 0)});
    motion.push_back({.position = Vec3(0.95, 0.5, 0)});
  }
  [[nodiscard]] AnchorScene scene() const { return {faces, by_key, motion, walls}; }
  /// With the slave there.
  std::optional<Vec3> slip_at(const AnchorRecord& anchor, const Vec3& slave) {
    motion[6].position = slave;
    return slip(scene(), anchor, row());
  }
  [[nodiscard]] Row row() const {
    return {.key = {.slave = 77, .master = 9},
            .nodes = {6, 3, 0, 1, 4},  // in whatever order
            .weights = {1, -0.025, -0.025, -0.475, -0.475},
            .node_count = 5,
            .master_body = 2,
            .normal = Vec3::UnitZ()};
  }
};

}  // namespace

TEST_CASE("an anchor on a face turns and moves with it, over whichever face its slave lies") {
  TwoSquares squares;
  const AnchorRecord anchor = anchor_of(squares.scene(), squares.row());
  CHECK(anchor.key == contact::AnchorKey{.slave = 77, .master = 2});
  CHECK(anchor.face == 9);
  REQUIRE(slip(squares.scene(), anchor, squares.row()));
  CHECK(slip(squares.scene(), anchor, squares.row())->norm() < 1e-15);
  const Vec3 over_the_next(1.1, 0.5, 0);
  CHECK((*squares.slip_at(anchor, over_the_next) - Vec3(0.15, 0, 0)).norm() < 1e-15);
  const Eigen::AngleAxisd turn(1.0, Vec3(1, 2, 3).normalized());
  for (contact::NodeMotion& node : squares.motion) node.position = turn * node.position + Vec3(5, 6, 7);
  const Vec3 moved = turn * over_the_next + Vec3(5, 6, 7);
  CHECK((*squares.slip_at(anchor, moved) - turn * Vec3(0.15, 0, 0)).norm() < 1e-14);
}

TEST_CASE("an anchor is dropped where it is out of reach, whether its face is known here or not") {
  TwoSquares squares;
  const AnchorRecord anchor = anchor_of(squares.scene(), squares.row());
  CHECK(squares.slip_at(anchor, {1.19, 0.5, 0}));
  CHECK_FALSE(squares.slip_at(anchor, {1.21, 0.5, 0}));  // 0.25 of the edge, capture's share
  AnchorRecord elsewhere = anchor;
  elsewhere.face = 5;
  CHECK_FALSE(squares.slip_at(elsewhere, {0.95, 0.5, 0}));
}

TEST_CASE("an anchor on a wall is in its plane, moves with it, and is never dropped") {
  TwoSquares squares;
  const Vec3 slave = squares.motion[6].position, normal = squares.walls[1].normal;
  Row row{.key = {.kind = contact::RowKind::wall, .slave = 77, .master = 1},
          .nodes = {6},
          .node_count = 1,
          .normal = normal};
  row.gap = (slave - squares.walls[1].point).dot(normal);
  const AnchorRecord anchor = anchor_of(squares.scene(), row);
  CHECK(anchor.key == contact::AnchorKey{.kind = contact::RowKind::wall, .slave = 77, .master = 1});
  CHECK((*slip(squares.scene(), anchor, row) - row.gap * normal).norm() < 1e-15);
  squares.walls[1].point += Vec3(0, 0.1, 0.2);
  squares.motion[6].position += Vec3(10, 0.1, 0.2);
  CHECK((*slip(squares.scene(), anchor, row) - row.gap * normal - Vec3(10, 0, 0)).norm() < 1e-14);
}

TEST_CASE("an edge holds on to the edge that it meets, at the points of both that met at first") {
  TwoSquares squares;
  Row row{.key = {contact::RowKind::edge, 40, 41, 50, 51}};
  row.nodes = {0, 1, 3, 4};
  row.weights = {0.75, 0.25, -0.75, -0.25};
  row.node_count = 4;
  REQUIRE(row.is_edge());
  const AnchorRecord anchor = anchor_of(squares.scene(), row);
  CHECK(anchor.key == contact::AnchorKey{contact::RowKind::edge, 40, 50, 41, 51});
  CHECK((*slip(squares.scene(), anchor, row) - Vec3(0, -1, 0)).norm() < 1e-15);  // as far apart as their edges are
  for (const std::size_t i : {0, 1}) squares.motion[i].position += Vec3(0.1, 0, 0);
  row.weights = {0.65, 0.35, -0.75, -0.25};  // it has slid along itself: now they meet elsewhere
  CHECK((*slip(squares.scene(), anchor, row) - Vec3(0.1, -1, 0)).norm() < 1e-15);
}

TEST_CASE("a node that slides drags its anchor over the face, and loses it at the rim") {
  TwoSquares squares;
  const AnchorRecord anchor = anchor_of(squares.scene(), squares.row());  // at (0.95, 0.5)
  const auto moved = dragged(squares.scene(), anchor, squares.row(), Vec3(-0.125, 0.125, 0));
  REQUIRE(moved);
  CHECK((*slip(squares.scene(), *moved, squares.row()) - Vec3(0.125, -0.125, 0)).norm() < 1e-15);
  CHECK_FALSE(dragged(squares.scene(), anchor, squares.row(), Vec3(0.06, 0, 0)));
  Row at_wall{.key = {.kind = contact::RowKind::wall, .slave = 77, .master = 0}, .nodes = {6}, .node_count = 1};
  at_wall.normal = Vec3::UnitZ();
  const auto on_wall = dragged(squares.scene(), anchor_of(squares.scene(), at_wall), at_wall, Vec3(7, 0, 0));
  REQUIRE(on_wall);
  CHECK((*slip(squares.scene(), *on_wall, at_wall) - Vec3(-7, 0, 0)).norm() < 1e-14);
  const Row edges{.key = {contact::RowKind::edge, 40, 41, 50, 51}};
  CHECK_FALSE(dragged(squares.scene(), anchor, edges, Vec3(0.1, 0, 0)));
}

TEST_CASE("two rows that drag one anchor leave the same one, whichever row comes first") {
  TwoSquares squares;
  std::vector<Row> rows{squares.row(), squares.row()};
  for (Row& row : rows) row.friction = 0.1;
  rows[1].key.master = 4;
  const std::vector<AnchorRecord> before{anchor_of(squares.scene(), squares.row())};
  std::vector<Vec3> impulses(2, Vec3(0.1, 0, 1)),
      slid{Vec3(-0.1, 0, 0), Vec3(-0.2, 0.1, 0)};  // on the limit: both slide
  std::vector<AnchorRecord> one, other;
  write_anchors(rows, impulses, slid, squares.scene(), before, one);
  std::swap(rows[0], rows[1]);
  std::swap(slid[0], slid[1]);
  write_anchors(rows, impulses, slid, squares.scene(), before, other);
  REQUIRE(one.size() == 1);
  REQUIRE(other.size() == 1);
  CHECK(one[0].weights == other[0].weights);
}
