// SPDX-License-Identifier: Apache-2.0
// The part of a segment in a cell, against points along it that are judged by planes.
#include "geometry/segment_in_cell.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <random>
#include <vector>

#include "core/cells.hpp"

using namespace brunt;
using namespace brunt::geometry;

namespace {

/// A parallelepiped or tetrahedron, and the planes of its faces by their normals and offsets.
struct Cell {
  std::vector<Vec3> corners;
  std::vector<std::array<Vec3, 2>> planes;  ///< a point of it, outward normal

  [[nodiscard]] bool contains(const Vec3& x) const {
    return std::ranges::all_of(planes, [&](const auto& plane) { return (x - plane[0]).dot(plane[1]) <= 0; });
  }
};

template <class Faces>
void add_planes(Cell& cell, const Faces& faces) {
  for (const auto& face : faces) {
    const auto at = [&](int i) -> const Vec3& {
      return cell.corners[static_cast<std::size_t>(face[static_cast<std::size_t>(i)])];
    };
    cell.planes.push_back({at(0), (at(1) - at(0)).cross(at(2) - at(0)).normalized()});
  }
}

Cell cell_around(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> part(-1, 1);
  const auto vector = [&] { return Vec3(part(random), part(random), part(random)); };
  Mat3 sides = Mat3::Identity() + 0.4 * (Mat3() << vector(), vector(), vector()).finished();
  if (sides.determinant() < 0) sides.col(0) *= -1;
  const Vec3 middle = 0.3 * vector();
  Cell cell;
  if (count == 8) {
    for (const auto& [x, y, z] : cells::hex_corners) cell.corners.push_back(middle + 0.5 * (sides * Vec3(x, y, z)));
    add_planes(cell, cells::hex_faces);
  } else {
    cell.corners = {middle, middle + sides.col(0), middle + sides.col(1), middle + sides.col(2)};
    add_planes(cell, cells::tet_faces);
  }
  return cell;
}

}  // namespace

TEST_CASE("segments in cells: exactly the points between the planes of the faces") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1, 1);
  int crossing = 0;
  for (int k = 0; k < 2000; ++k) {
    const Cell cell = cell_around(random, k % 2 == 0 ? 8 : 4);
    const Segment segment{1.5 * Vec3(part(random), part(random), part(random)),
                          1.5 * Vec3(part(random), part(random), part(random))};
    const Stretch found = part_in_cell(segment, cell.corners);
    crossing += found.is_empty() ? 0 : 1;
    for (int i = 0; i <= 40; ++i) {
      const double at = i / 40.0;
      if (std::abs(at - found.first) < 1e-9 || std::abs(at - found.last) < 1e-9) continue;
      const Vec3 x = (1 - at) * segment.start + at * segment.end;
      CHECK(cell.contains(x) == (found.first < at && at < found.last));
      CHECK(cell.contains(x) != part_in_cell({x, x}, cell.corners).is_empty());
    }
  }
  CHECK(crossing > 300);
}

TEST_CASE("segments in cells: squarely through a thin plate, along a face, and past it") {
  const double thick = 1e-3;
  std::vector<Vec3> plate;
  for (const auto& [x, y, z] : cells::hex_corners) plate.emplace_back(x, y, 0.5 * thick * z);
  const Stretch through = part_in_cell({{0.3, 0.1, -1}, {0.3, 0.1, 1}}, plate);
  CHECK(2 * through.length() == Approx(thick).epsilon(1e-12));
  CHECK(part_in_cell({{-3, 0.2, 0.5 * thick}, {1, 0.2, 0.5 * thick}}, plate).length() == Approx(0.5));
  CHECK(part_in_cell({{-3, 0.2, 0.6 * thick}, {1, 0.2, 0.6 * thick}}, plate).is_empty());
  CHECK(part_in_cell({{-3, 0.2, 0.6 * thick}, {1, 0.2, 0.6 * thick}}, plate, 0.2).length() > 0.45);
}

TEST_CASE("segments in cells: flat and inverted cells, and what is no number, contain nothing") {
  std::vector<Vec3> tet{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Segment inside{{0.1, 0.1, 0.1}, {0.2, 0.1, 0.1}};
  CHECK(part_in_cell(inside, tet).length() == 1);
  const Vec3 none = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  CHECK(part_in_cell({none, none}, tet).is_empty());
  std::swap(tet[0], tet[1]);
  CHECK(part_in_cell(inside, tet).is_empty());
  tet[0] = tet[1];
  CHECK(part_in_cell(inside, tet).is_empty());
}

TEST_CASE("segments in cells: outside a wedge of repeated corners, on the planes of its flat tetrahedra") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(-1, 1);
  for (int k = 0; k < 500; ++k) {
    Mat3 turn;
    for (int i = 0; i < 9; ++i) turn.data()[i] = part(random);
    if (std::abs(turn.determinant()) < 0.1) continue;
    if (turn.determinant() < 0) turn.col(0) *= -1;
    const std::array<Vec3, 6> six{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0),
                                  Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)};
    std::vector<Vec3> wedge;
    for (const std::size_t corner : {0, 1, 2, 2, 3, 4, 5, 5}) wedge.push_back(turn * six[corner]);
    const Vec3 from(2 * part(random), 2 * part(random), 2 * part(random)), to(part(random), part(random), part(random));
    const Stretch found = part_in_cell({turn * from, turn * to}, wedge);
    for (int i = 0; i <= 40; ++i) {
      const double at = i / 40.0;
      const Vec3 x = (1 - at) * from + at * to;
      const bool inside = std::min({x[0], x[1], 1 - x[0] - x[1], x[2], 1 - x[2]}) > 0;
      if (std::abs(at - found.first) < 1e-9 || std::abs(at - found.last) < 1e-9) continue;
      CHECK(inside == (found.first < at && at < found.last));
    }
  }
}
