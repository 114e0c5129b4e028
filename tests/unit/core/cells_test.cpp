// SPDX-License-Identifier: Apache-2.0
// The tables of corners agree with each other and with the parent cube.
#include "core/cells.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstddef>
#include <set>
#include <vector>

#include "core/types.hpp"

using namespace brunt;

namespace {

Vec3 corner(int c) {
  const auto& sign = cells::hex_corners[static_cast<std::size_t>(c)];
  return {static_cast<double>(sign[0]), static_cast<double>(sign[1]), static_cast<double>(sign[2])};
}

double triple(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.cross(b).dot(c);
}

}  // namespace

TEST_CASE("cells: edges of a hexahedron join corners of the cube that differ in one coordinate, each once") {
  std::set<std::set<int>> edges;
  for (const auto& [a, b] : cells::hex_edges) {
    CHECK((corner(a) - corner(b)).norm() == 2);
    edges.insert({a, b});
  }
  CHECK(edges.size() == 12);
  for (int c = 0; c < 8; ++c) {
    const auto& ends = cells::hex_neighbours[static_cast<std::size_t>(c)];
    for (const int end : ends) CHECK(edges.contains({c, end}));
    CHECK(triple(corner(ends[0]) - corner(c), corner(ends[1]) - corner(c), corner(ends[2]) - corner(c)) == 8);
  }
}

TEST_CASE("cells: faces of a hexahedron are counter-clockwise from outside, and each edge lies in two of them") {
  std::multiset<std::set<int>> edges;
  for (const auto& face : cells::hex_faces) {
    const Vec3 normal = (corner(face[2]) - corner(face[0])).cross(corner(face[3]) - corner(face[1]));
    CHECK(normal.dot(corner(face[0])) == 8);
    CHECK(normal.norm() == 8);
    for (std::size_t i = 0; i < 4; ++i) edges.insert({face[i], face[(i + 1) % 4]});
  }
  CHECK(edges.size() == 24);
  for (const auto& [a, b] : cells::hex_edges) CHECK(edges.count({a, b}) == 2);
}

TEST_CASE("cells: six tetrahedra fill a hexahedron") {
  double volume = 0;
  for (const auto& [a, b, c, d] : cells::hex_tetrahedra) {
    const double six = triple(corner(b) - corner(a), corner(c) - corner(a), corner(d) - corner(a));
    CHECK(six > 0);
    volume += six / 6;
  }
  CHECK(volume == Approx(8));
}

TEST_CASE("cells: a tetrahedron's faces hold its edges, each twice, and look outwards") {
  const std::array<Vec3, 4> x{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  std::multiset<std::set<int>> edges;
  for (const auto& face : cells::tet_faces) {
    const auto at = [&](std::size_t i) -> const Vec3& { return x[static_cast<std::size_t>(face[i])]; };
    CHECK((at(1) - at(0)).cross(at(2) - at(0)).dot(at(0) - Vec3::Constant(0.25)) > 0);
    for (std::size_t i = 0; i < 3; ++i) edges.insert({face[i], face[(i + 1) % 3]});
  }
  for (const auto& [a, b] : cells::tet_edges) CHECK(edges.count({a, b}) == 2);
}

namespace {

/// A reference element: the parent cube, or the tetrahedron between the axes.
std::vector<Vec3> reference(cells::Shape shape) {
  if (shape == cells::Shape::tet4) return {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  std::vector<Vec3> corners;
  for (int c = 0; c < 8; ++c) corners.push_back(corner(c));
  return corners;
}

std::vector<int> corners_of(const cells::Face& face) {
  std::vector<int> corners(face.begin(), face.end());
  std::erase(corners, -1);
  return corners;
}

constexpr std::array shapes{cells::Shape::hex8, cells::Shape::tet4};
constexpr std::array shells{cells::Shape::quad4, cells::Shape::tri3};

}  // namespace

TEST_CASE("cells: in the table of shapes each edge belongs to two faces, and Euler's formula holds") {
  CHECK(cells::table.size() == shapes.size() + shells.size());
  for (const cells::Shape shape : shapes) {
    const cells::Cell& cell = cells::of(shape);
    CAPTURE(cell.name);
    CHECK(cell.dimension == 3);
    CHECK(cell.corners == static_cast<int>(reference(shape).size()));
    CHECK(cell.corners - static_cast<int>(cell.edges.size()) + static_cast<int>(cell.faces.size()) == 2);
    std::multiset<std::set<int>> sides;
    std::set<int> met;
    for (const cells::Face& face : cell.faces) {
      const std::vector<int> corners = corners_of(face);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        sides.insert({corners[i], corners[(i + 1) % corners.size()]});
        met.insert(corners[i]);
      }
    }
    CHECK(sides.size() == 2 * cell.edges.size());
    for (const auto& [a, b] : cell.edges) CHECK(sides.count({a, b}) == 2);
    CHECK(met.size() == static_cast<std::size_t>(cell.corners));
  }
}

TEST_CASE("cells: in the table of shapes normals of faces point outwards, and tetrahedra fill the element") {
  for (const cells::Shape shape : shapes) {
    const cells::Cell& cell = cells::of(shape);
    CAPTURE(cell.name);
    const std::vector<Vec3> x = reference(shape);
    const auto at = [&](int c) -> const Vec3& { return x[static_cast<std::size_t>(c)]; };
    Vec3 centre = Vec3::Zero();
    for (const Vec3& point : x) centre += point / cell.corners;
    double by_faces = 0, by_tetrahedra = 0;
    for (const cells::Face& face : cell.faces) {
      const std::vector<int> c = corners_of(face);
      for (std::size_t i = 2; i < c.size(); ++i) {
        const double six = triple(at(c[0]) - centre, at(c[i - 1]) - centre, at(c[i]) - centre);
        CHECK(six > 0);
        by_faces += six / 6;
      }
    }
    for (const auto& [a, b, c, d] : cell.tetrahedra)
      by_tetrahedra += triple(at(b) - at(a), at(c) - at(a), at(d) - at(a)) / 6;
    CHECK(by_tetrahedra == Approx(by_faces));
  }
}

TEST_CASE("cells: a shell is its own face, and the edges go around it") {
  for (const cells::Shape shape : shells) {
    const cells::Cell& cell = cells::of(shape);
    CAPTURE(cell.name);
    CHECK(cells::is_surface(shape));
    CHECK(cell.dimension == 2);
    CHECK(cell.tetrahedra.empty());
    REQUIRE(cell.faces.size() == 1);
    const std::vector<int> corners = corners_of(cell.faces[0]);
    CHECK(corners.size() == static_cast<std::size_t>(cell.corners));
    REQUIRE(cell.edges.size() == corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
      CHECK(cell.edges[i] == cells::Edge{corners[i], corners[(i + 1) % corners.size()]});
  }
  for (const cells::Shape shape : shapes) CHECK_FALSE(cells::is_surface(shape));
}

TEST_CASE("cells: shapes by number of corners, keys of corners and faces") {
  for (const cells::Shape shape : shapes) CHECK(cells::shape_with(cells::of(shape).corners) == shape);
  for (const int collapsed : {5, 6}) CHECK(cells::shape_with(collapsed) == cells::Shape::hex8);
  CHECK(cells::corner_count(std::array<LocalIndex, 4>{1, 2, 3, no_index}) == 3);
  CHECK(cells::corner_count(std::array<LocalIndex, 4>{1, 2, 3, 4}) == 4);
  // checkpoints contain such keys
  CHECK(cells::key_of(5, 7) == 47);
  CHECK(cells::element_of_key(47) == 5);
  CHECK(cells::element_of_key(cells::key_of(6, 0)) == 6);
  CHECK(cells::key_of_face_corner(47, 3) == 191);
}
