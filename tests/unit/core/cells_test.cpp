// SPDX-License-Identifier: Apache-2.0
// The tables of corners agree with each other and with the parent cube.
#include "core/cells.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <set>

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
