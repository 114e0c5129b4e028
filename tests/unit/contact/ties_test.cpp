// SPDX-License-Identifier: Apache-2.0
// Ties are found once, keep their place against a face that turns, and ask for what has crept back.
#include "brunt/contact/ties.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

using namespace brunt;
using contact::Row;
using contact::Tie;

namespace {

/// Two unit squares side by side in the plane z = 0, the second with the lower key, and slaves around them.
struct TwoSquares {
  std::vector<contact::MasterFace> faces{{.key = 4, .nodes = {1, 2, 5, 4}, .body = 2, .block = 1, .depth = 1},
                                         {.key = 9, .nodes = {0, 1, 4, 3}, .body = 2, .block = 1, .depth = 1}};
  std::vector<LocalIndex> by_key{0, 1};
  std::vector<contact::NodeMotion> motion;
  std::vector<GlobalIndex> gid;
  contact::Candidates candidates;

  explicit TwoSquares(const std::vector<Vec3>& slaves) {
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) motion.push_back({.position = Vec3(i, j, 0)});
    for (const Vec3& slave : slaves) {
      candidates.slave.push_back(static_cast<LocalIndex>(motion.size()));
      candidates.body.push_back(7);
      candidates.faces.values.insert(candidates.faces.values.end(), {0, 1});
      candidates.faces.close_row();
      motion.push_back({.position = slave});
    }
    gid.resize(motion.size());
    std::iota(gid.begin(), gid.end(), GlobalIndex{100});
  }
  [[nodiscard]] std::vector<Tie> ties() const {
    return find_ties(candidates, faces, gid, motion, {}, [](LocalIndex, LocalIndex) { return true; });
  }
  [[nodiscard]] contact::TieScene scene(double recovery = 0.1, double dt = 0.5) const {
    return {candidates, faces, by_key, gid, motion, recovery, dt};
  }
  void move(const Eigen::AngleAxisd& turn, const Vec3& shift) {
    for (contact::NodeMotion& node : motion) node.position = turn * node.position + shift;
  }
};

}  // namespace

TEST_CASE("each node near a face is tied once: to the nearest, of equals to the lowest key") {
  const TwoSquares squares(
      {{0.2, 0.5, 0}, {0.4, 0.5, 0.2}, {1, 0.5, -0.1}, {0.4, 0.5, 0.3}, {0.4, -0.01, 0}, {0.4, -0.1, 0}});
  const std::vector<Tie> ties = squares.ties();
  REQUIRE(ties.size() == 4);  // the fourth is too far off, the last too far beside: 0.25 and 0.02 of an edge
  CHECK(ties[0].slave == 106);
  CHECK(ties[0].face == 9);
  CHECK(ties[0].offset.norm() < 1e-15);
  CHECK(std::abs(ties[0].weights[1] - 0.1) < 1e-12);
  CHECK((ties[1].offset - Vec3(0, 0, 0.2)).norm() < 1e-15);
  CHECK(ties[2].face == 4);
  CHECK(ties[3].slave == 110);
  CHECK(std::abs(ties[3].offset.norm() - 0.01) < 1e-12);
  CHECK(find_tie(ties, 107, 2) == &ties[1]);
  CHECK(find_tie(ties, 107, 3) == nullptr);
  CHECK(find_tie(ties, 109, 2) == nullptr);
}

TEST_CASE("only pairs that may be tied are") {
  const TwoSquares squares({{0.2, 0.5, 0}, {1.4, 0.5, 0}});
  const std::vector<Tie> ties = find_ties(squares.candidates, squares.faces, squares.gid, squares.motion, {},
                                          [](LocalIndex slave, LocalIndex face) { return slave == 7 || face == 0; });
  REQUIRE(ties.size() == 1);
  CHECK(ties[0].slave == 107);
}

TEST_CASE("a tie on a face that turns asks for nothing, and takes back a share of what has crept") {
  TwoSquares squares({{0.2, 0.5, 0}, {0.4, 0.5, 0.2}});
  const std::vector<Tie> ties = squares.ties();
  const Eigen::AngleAxisd turn(1.1, Vec3(1, -2, 3).normalized());
  squares.move(turn, {3, 4, 5});
  std::vector<Row> rows;
  tie_rows(ties, squares.scene(), rows);
  REQUIRE(rows.size() == 2);
  for (const Row& row : rows) {
    CHECK(row.cone == contact::Cone::free);
    CHECK(std::isinf(row.friction));
    CHECK((row.normal - turn * Vec3::UnitZ()).norm() < 1e-14);
    CHECK(std::abs(std::accumulate(row.weights.begin(), row.weights.begin() + row.node_count, 0.0)) < 1e-15);
    CHECK(std::abs(row.gap) + std::abs(row.required) + row.drift.norm() < 1e-14);
  }
  const Vec3 crept(0.01, -0.02, 0.03);
  for (const std::size_t slave : {std::size_t{6}, std::size_t{7}}) squares.motion[slave].position += turn * crept;
  rows.clear();
  tie_rows(ties, squares.scene(0.1, 0.5), rows);
  for (const Row& row : rows) {
    CHECK((row.required * row.normal + row.drift + 0.2 * (turn * crept)).norm() < 1e-14);
    CHECK(std::abs(row.normal.dot(row.drift)) < 1e-15);
  }
  CHECK(ties[0].flush);
  CHECK_FALSE(ties[1].flush);
}

TEST_CASE("a tie whose face or slave is not in the lists is told") {
  TwoSquares squares({{0.2, 0.5, 0}, {0.4, 0.5, 0.2}});
  const std::vector<Tie> ties = squares.ties();
  CHECK(holds(ties[0], squares.scene()));
  Tie other = ties[0];
  other.face = 5;
  CHECK_FALSE(holds(other, squares.scene()));
  other = ties[0];
  other.slave = 3;
  CHECK_FALSE(holds(other, squares.scene()));
}
