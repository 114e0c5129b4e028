// SPDX-License-Identifier: Apache-2.0
// Ties are found once, keep their place against a face that turns, and ask for what has crept back.
#include "contact/anchors/ties.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "contact/data/tolerances.hpp"

using namespace brunt;
using contact::Row;
using contact::Tie;

namespace {

/// Two unit squares side by side in the plane z = 0, the second with the lower key, and slaves around them.
struct TwoSquares {
  std::vector<contact::MasterFace> faces{{.key = 4, .nodes = {1, 2, 5, 4}, .body = 2, .block = 1, .element_depth = 1},
                                         {.key = 9, .nodes = {0, 1, 4, 3}, .body = 2, .block = 1, .element_depth = 1}};
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
    return find_ties(
        candidates, faces, gid, motion, {}, contact::standard_tolerances, [](LocalIndex, LocalIndex) { return true; },
        [](LocalIndex, LocalIndex) {});
  }
  /// The rows of these ties; their arms live as long as this.
  std::vector<Row> rows(const std::vector<Tie>& ties, double recovery = 0.1, double dt = 0.5) {
    contact::TieArms of_before;  // as from another step
    of_before.fill({Mat3::Constant(std::numeric_limits<double>::quiet_NaN()), 1});
    arms.assign(ties.size(), of_before);
    std::vector<Row> made;
    tie_rows(ties, scene(recovery, dt), arms, made);
    return made;
  }
  std::vector<contact::TieArms> arms;
  [[nodiscard]] contact::TieScene scene(double recovery = 0.1, double dt = 0.5) const {
    return {candidates, faces, by_key, gid, motion, recovery, dt};
  }
  /// The point that the weights of a tie name.
  [[nodiscard]] Vec3 named_by(const Tie& tie) const {
    const contact::MasterFace& face = *std::ranges::find(faces, tie.face, &contact::MasterFace::key);
    Vec3 point = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i)
      point += tie.weights[i] * motion[static_cast<std::size_t>(face.nodes[i])].position;
    return point;
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
  CHECK(ties[0].height == 0);
  CHECK(std::abs(ties[0].weights[1] - 0.1) < 1e-12);
  CHECK(std::abs(ties[1].height - 0.2) < 1e-15);
  CHECK(ties[2].face == 4);
  CHECK(ties[3].slave == 110);
  CHECK(ties[3].height == 0);
  CHECK(std::abs(squares.named_by(ties[3]).y() + 0.01) < 1e-15);  // beside the face
  CHECK(find_tie(ties, 107, 2) == &ties[1]);
  CHECK(find_tie(ties, 107, 3) == nullptr);
  CHECK(find_tie(ties, 109, 2) == nullptr);
}

TEST_CASE("only pairs that may be tied are") {
  const TwoSquares squares({{0.2, 0.5, 0}, {1.4, 0.5, 0}});
  const std::vector<Tie> ties = find_ties(
      squares.candidates, squares.faces, squares.gid, squares.motion, {}, contact::standard_tolerances,
      [](LocalIndex slave, LocalIndex face) { return slave == 7 || face == 0; }, [](LocalIndex, LocalIndex) {});
  REQUIRE(ties.size() == 1);
  CHECK(ties[0].slave == 107);
}

TEST_CASE("a tie on a face that turns asks for nothing, and takes back a share of what has crept") {
  TwoSquares squares({{0.2, 0.5, 0}, {0.4, 0.5, 0.2}});
  const std::vector<Tie> ties = squares.ties();
  const Eigen::AngleAxisd turn(1.1, Vec3(1, -2, 3).normalized());
  squares.move(turn, {3, 4, 5});
  std::vector<Row> rows = squares.rows(ties);
  REQUIRE(rows.size() == 2);
  for (const Row& row : rows) {
    CHECK(row.cone == contact::Cone::free);
    CHECK(row.holds);
    CHECK((row.normal - turn * Vec3::UnitZ()).norm() < 1e-14);
    CHECK(std::abs(std::accumulate(row.weights.begin(), row.weights.begin() + row.node_count, 0.0)) < 1e-15);
    CHECK(std::abs(row.gap) + std::abs(row.required) + row.drift.norm() < 1e-14);
  }
  const Vec3 crept(0.01, -0.02, 0.03);
  for (const std::size_t slave : {std::size_t{6}, std::size_t{7}}) squares.motion[slave].position += turn * crept;
  rows = squares.rows(ties, 0.1, 0.5);
  for (const Row& row : rows) {
    CHECK((row.required * row.normal + row.drift + 0.2 * (turn * crept)).norm() < 1e-14);
    CHECK(std::abs(row.normal.dot(row.drift)) < 1e-15);
  }
  CHECK(rows[0].arms.empty());
  CHECK(rows[1].arms.data() == squares.arms[1].data());
}

namespace {

/// A warped face, slaves over it and under it, all of it turned and bent, and the slaves off their places.
TwoSquares bent_squares(std::vector<Tie>& ties) {
  TwoSquares squares({{0.2, 0.3, 0.2}, {0.9, 0.7, -0.1}, {1.6, 0.999, 0.15}});
  squares.motion[4].position.z() += 0.1;
  ties = squares.ties();
  REQUIRE(ties.size() == 3);
  squares.move(Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()), {1, -2, 3});
  for (std::size_t i = 0; i < squares.motion.size(); ++i)
    squares.motion[i].position +=
        0.02 * Vec3(std::sin(3.0 * static_cast<double>(i)), std::cos(5.0 * static_cast<double>(i)),
                    std::sin(7.0 * static_cast<double>(i)));
  return squares;
}

}  // namespace

TEST_CASE("a tie across a gap: a common turn asks for nothing, impulses have no resultant and no moment") {
  std::vector<Tie> ties;
  TwoSquares squares = bent_squares(ties);
  const Vec3 spin(0.3, -1.1, 0.6), speed(2, 1, -4), impulse(0.4, 0.9, -0.7);
  for (const Row& row : squares.rows(ties)) {
    REQUIRE(row.arms.size() == 5);
    const auto place = [&](LocalIndex node) -> const Vec3& {
      return squares.motion[static_cast<std::size_t>(node)].position;
    };
    CHECK(relative_velocity(row, [&](LocalIndex node) { return Vec3(speed + spin.cross(place(node))); }).norm() <
          1e-14);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    double most = 0;
    for (std::size_t i = 0; i < 5; ++i) {
      const Vec3 share = impulse_on_node(row, i, impulse);
      sum += share;
      moment += place(row.nodes[i]).cross(share);
      most = std::max(most, share.norm());
    }
    CHECK(sum.norm() < 1e-15);
    CHECK(moment.norm() < 1e-14);
    CHECK(most <= largest_share(row) * impulse.norm());
  }
}

TEST_CASE("a tie across a gap asks for the rate of what it keeps, by differences") {
  std::vector<Tie> ties;
  TwoSquares squares = bent_squares(ties);
  for (std::size_t t = 0; t < ties.size(); ++t) {
    // no creep: what has crept goes with the mean spin, which is no gradient
    const Row crept = squares.rows(ties)[t];
    Vec3 back = crept.gap * crept.normal;
    back -= 5 * (crept.drift - crept.normal.dot(crept.drift) * crept.normal);  // dt / recovery
    squares.motion[static_cast<std::size_t>(crept.nodes[0])].position -= back;
    const Row row = squares.rows(ties)[t];
    CHECK(std::abs(row.gap) + row.drift.norm() < 1e-13);
    const auto velocity = [](LocalIndex node) {
      return Vec3(Vec3(node % 3, node % 2, 2 - node % 4) - Vec3(0.4, 0.1, 0.9));
    };
    constexpr double h = 1e-6;
    const auto lack = [&](double step) {  // drift and gap after a motion, put together
      TwoSquares moved = squares;
      for (std::size_t i = 0; i < moved.motion.size(); ++i)
        moved.motion[i].position += step * velocity(static_cast<LocalIndex>(i));
      const Row there = moved.rows(ties)[t];
      return Vec3(there.gap * there.normal - 5 * there.drift);
    };
    const Vec3 rate = (lack(h) - lack(-h)) / (2 * h), asked = relative_velocity(row, velocity);
    CAPTURE(t, rate.transpose(), asked.transpose());
    CHECK((rate - asked).norm() < 1e-8 * asked.norm());
  }
}

TEST_CASE("the edge of a wedge looks where its two faces look together") {
  TwoSquares squares({{0.4, 0.5, 0}, {0.6, 0.5, 0}});
  const std::vector<Vec3> facet_area{Vec3(1, 0, -0.3), Vec3(-1, 0, -0.3), Vec3(-1, 0, 0.3)};
  squares.candidates.slave_facets.values = {0, 1, 0, 2};
  squares.candidates.slave_facets.offsets = {0, 2, 4};
  const std::vector<Tie> ties = find_ties(
      squares.candidates, squares.faces, squares.gid, squares.motion, facet_area, contact::standard_tolerances,
      [](LocalIndex, LocalIndex) { return true; }, [](LocalIndex, LocalIndex) {});
  REQUIRE(ties.size() == 1);
  CHECK(ties[0].slave == 106);
}

TEST_CASE("nodes beside the master, and nodes whose faces do not look at it, are not tied") {
  TwoSquares squares(
      {{0.4, 0.5, 0.1}, {0.4, -0.1, 0.1}, {0.4, 0.5, 0.1}, {-0.2, 0.5, 0.05}, {0.4, 0.5, 0.3}, {0.4, -0.3, 0}});
  const std::vector<Vec3> facet_area{Vec3(0.1, 0, -2), Vec3(1, 0, 0)};  // one looks down, one aside
  for (const LocalIndex facet : {0, 0, 1, 0, 0, 0}) {
    squares.candidates.slave_facets.values.push_back(facet);
    squares.candidates.slave_facets.close_row();
  }
  std::vector<LocalIndex> beside;
  const std::vector<Tie> ties = find_ties(
      squares.candidates, squares.faces, squares.gid, squares.motion, facet_area, contact::standard_tolerances,
      [](LocalIndex, LocalIndex) { return true; }, [&](LocalIndex slave, LocalIndex) { beside.push_back(slave); });
  REQUIRE(ties.size() == 1);
  CHECK(ties[0].slave == 106);
  CHECK(beside == std::vector<LocalIndex>{7, 9});  // the others are out of reach, or look elsewhere
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
