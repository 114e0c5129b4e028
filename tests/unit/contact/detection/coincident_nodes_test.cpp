// SPDX-License-Identifier: Apache-2.0
// Nodes that lie on each other: where one row holds both, and where it does not.
#include "contact/detection/coincident_nodes.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>

#include "few_faces.hpp"

using namespace brunt;
using namespace brunt::contact;
using support::FewFaces;

namespace {

constexpr double distance = 0.01;

/// Four unit squares around the origin, their outer corners lifted or lowered: a dent (> 0), a blunt corner (< 0).
FewFaces around_a_node(double lift) {
  std::vector<Vec3> points;
  for (const double y : {-1.0, 0.0, 1.0})
    for (const double x : {-1.0, 0.0, 1.0}) points.emplace_back(x, y, lift * std::max(std::abs(x), std::abs(y)));
  return {points, {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}}};
}

RowsToSpare to_spare(FewFaces& scene, const Vec3& position, const std::vector<Vec3>& facet_normal) {
  const NodeMotion node{.position = position};
  std::vector<LocalIndex> near, facets;
  for (std::size_t f = 0; f < scene.faces.size(); ++f) near.push_back(static_cast<LocalIndex>(f));
  for (std::size_t f = 0; f < facet_normal.size(); ++f) facets.push_back(static_cast<LocalIndex>(f));
  const std::vector<FaceReach> reach(scene.faces.size());
  std::vector<CoincidentCandidate> corners;
  for (std::size_t i = 0; i + 1 < scene.motion.size(); ++i) corners.push_back({static_cast<LocalIndex>(i), 0});
  return rows_to_spare({scene.faces, reach, scene.motion, scene.dt, standard_tolerances}, {node, facets, facet_normal},
                       near, corners, distance);
}

/// Does one row hold both, that of the first pass?
bool coincides(FewFaces& scene, const Vec3& position, const std::vector<Vec3>& facet_normal) {
  const RowsToSpare spare = to_spare(scene, position, facet_normal);
  return spare.second && !spare.first;
}

/// Does the row of the other node hold both, in whichever pass it is?
bool is_spared(FewFaces& scene, const Vec3& position, const std::vector<Vec3>& facet_normal) {
  const RowsToSpare spare = to_spare(scene, position, facet_normal);
  return spare.second && spare.first;
}

/// Normals of the three faces of a cube's lowest corner, which stands upright on it.
std::vector<Vec3> standing_corner(double turned) {
  std::vector<Vec3> normals;
  const double low = -1 / std::sqrt(3.0), out = std::sqrt(2.0 / 3);
  for (const double angle : {0.0, 2.0, 4.0}) {
    const double at = turned + angle * std::numbers::pi / 3;
    normals.emplace_back(out * std::cos(at), out * std::sin(at), low);
  }
  return normals;
}

}  // namespace

TEST_CASE("the corner of a block on a node of a flat face, or of an equal block, coincides with it, near enough") {
  FewFaces flat = around_a_node(0), block = support::cube();
  const std::vector<Vec3> corner{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -1)};
  CHECK(coincides(flat, Vec3(0.5 * distance, 0, 0), corner));
  CHECK_FALSE(coincides(flat, Vec3(2 * distance, 0, 0), corner));
  CHECK(coincides(block, Vec3(1, 1, 1 - 1e-6), corner));
  const auto bulged = Eigen::AngleAxisd(0.3, Vec3(1, -1, 0).normalized());
  CHECK(coincides(block, Vec3(1, 1, 1), {bulged * corner[0], bulged * corner[1], corner[2]}));
}

TEST_CASE("corner on corner: they are coincident, however they are turned") {
  FewFaces block = support::cube();
  const Vec3 diagonal = Vec3(1, 1, 1).normalized();
  for (const double turn : {0.0, 0.4, 1.0}) {
    std::vector<Vec3> facets;
    for (const Vec3& axis : {Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1)})
      facets.push_back(Eigen::AngleAxisd(turn, diagonal) * axis);
    CHECK(coincides(block, Vec3(1, 1, 1 + 1e-6), facets));
  }
}

TEST_CASE(
    "nodes of curved faces that fit are coincident; a corner that has pressed a dent, or stands on a face, is none") {
  FewFaces dent = around_a_node(0.3), flat = around_a_node(0);
  std::vector<Vec3> fitting;
  for (const MasterFace& face : dent.faces) {
    std::array<Vec3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = dent.motion[static_cast<std::size_t>(face.nodes[i])].position;
    fitting.push_back(-geometry::area_vector(corners).normalized());
  }
  CHECK(coincides(dent, Vec3(0, 0, 1e-3), fitting));
  for (const double turned : {0.0, 0.2, 0.7}) {
    CAPTURE(turned);
    CHECK_FALSE(coincides(dent, Vec3(0, 0, 1e-3), standing_corner(turned)));
    CHECK_FALSE(coincides(flat, Vec3(0, 0, 1e-3), standing_corner(turned)));
  }
  // three of the dent's sides have a face that lies on them, the fourth looks at one that does not
  fitting.pop_back();
  fitting.push_back(Vec3(0.9, 0, -std::sqrt(1 - 0.81)));
  CHECK_FALSE(coincides(dent, Vec3(0, 0, 1e-3), fitting));
}

TEST_CASE("a mass point on a node of a face is held by its own row: the node of the face has no face of it to meet") {
  FewFaces flat = around_a_node(0);
  CHECK_FALSE(coincides(flat, Vec3(0, 0, 1e-6), {}));
}

TEST_CASE("of a corner, a rim and a flat place the row of the sharper one holds both nodes, two rims keep both rows") {
  FewFaces flat = around_a_node(0), corner = support::cube();
  const double s = std::sqrt(0.5);
  // two squares over each other at right angles, their common edge along y through the origin: a ridge
  FewFaces ridge(
      {{0, -1, 0}, {0, 1, 0}, {1, -1, -1}, {1, 1, -1}, {-1, -1, -1}, {-1, 1, -1}, {0, 0, 0}, {1, 0, -1}, {-1, 0, -1}},
      {{0, 2, 7, 6}, {6, 7, 3, 1}, {0, 6, 8, 4}, {6, 1, 5, 8}});
  const std::vector<Vec3> face{Vec3(0, 0, -1), Vec3(0, 0, -1)};
  const std::vector<Vec3> across{Vec3(0, 0.6, -0.8), Vec3(0, -0.6, -0.8)};
  const std::vector<Vec3> end{Vec3(0, 0.6, -0.8), Vec3(0, -0.6, -0.8), Vec3(1, 0, 0)};
  const std::vector<Vec3> tip = standing_corner(0.3);
  const Vec3 place(0, 0, 1e-6);
  for (const auto& sharp : {across, end, tip}) {
    const RowsToSpare spare = to_spare(flat, place, sharp);
    CHECK((!spare.first && !spare.second));
  }
  CHECK(is_spared(ridge, place, face));
  for (const auto& sharp : {across, end, tip}) {
    const RowsToSpare spare = to_spare(ridge, place, sharp);
    CHECK((!spare.first && !spare.second));
  }
  const Vec3 top(1, 1, 1 + 1e-6);
  CHECK(is_spared(corner, top, {Vec3(-s, 0, -s), Vec3(-s, 0, -s)}));
  CHECK(is_spared(corner, top, {Vec3(0, -s, -s), Vec3(s, 0, -s)}));
  CHECK(coincides(corner, top, tip));
}
