// SPDX-License-Identifier: Apache-2.0
// Surfaces of blocks in triangles: closed, of known volume, on the outer side of warped faces.
#include "app/whole/outer_surface.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "geometry/triangles/closed_surface.hpp"
#include "mesh/primitives.hpp"

using namespace brunt;

namespace {

/// Of a surface that must be closed and without points of no triangle.
double volume_within(const TriangleSurface& surface) {
  const geometry::SurfaceFaults faults = geometry::check_closed(surface);
  CHECK(faults.sound());
  CHECK(faults.unused_points == 0);
  return faults.volume;
}

}  // namespace

TEST_CASE("outer surface: a corner pulled out of its face or pushed into it leaves the larger of two volumes") {
  // The two halves of the face have a mean height of h/3 each where the corner is on the diagonal, and one of them
  // where it is not.
  const int corner = GENERATE(range(0, 8)), along = GENERATE(0, 1, 2);
  const Mat3 turn = GENERATE(Mat3(Mat3::Identity()), Eigen::AngleAxisd(0.8, Vec3(1, -2, 3).normalized()).matrix());
  CAPTURE(corner, along);
  for (const auto& [out, volume] : {std::pair(0.3, 1 + 0.3 / 3), std::pair(-0.3, 1 - 0.3 / 6), std::pair(0.0, 1.0)}) {
    mesh::Mesh mesh = mesh::box("a", {1, 1, 1}, {1, 1, 1});
    Vec3& x = mesh.coordinates[static_cast<std::size_t>(corner)];
    x[along] += x[along] > 0.5 ? out : -out;
    for (Vec3& at : mesh.coordinates) at = turn * at + Vec3(5, -7, 3);
    const TriangleSurface surface = app::outer_surface(mesh, 0);
    CHECK(surface.triangles.size() == 12);
    CHECK(volume_within(surface) == Approx(volume).epsilon(1e-12));
  }
}

TEST_CASE("outer surface: nodes inside are left out, and so are other blocks, also those that share nodes") {
  const mesh::Mesh cube = mesh::box("a", {1, 1, 1}, {3, 3, 3});
  const TriangleSurface whole = app::outer_surface(cube, 0);
  CHECK(whole.points.size() == 64 - 8);
  CHECK(whole.triangles.size() == 108);
  CHECK(volume_within(whole) == Approx(1));

  mesh::Mesh halves = mesh::box("a", {2, 1, 1}, {2, 1, 1});
  mesh::Block second = halves.blocks[0];
  halves.blocks[0].nodes.resize(8);
  second.nodes.erase(second.nodes.begin(), second.nodes.begin() + 8);
  halves.blocks.push_back(second);
  for (Vec3& x : halves.coordinates)
    if (x[0] == 2) x[0] = 5;
  for (const std::size_t block : {std::size_t{0}, std::size_t{1}}) {
    const TriangleSurface half = app::outer_surface(halves, block);
    CHECK(half.points.size() == 8);
    CHECK(volume_within(half) == Approx(block == 0 ? 1.0 : 4.0));
  }
}

TEST_CASE("outer surface: wedges about an axis, and a tetrahedron") {
  mesh::RoundForm quarter;
  quarter.sector = {0, 90};
  const TriangleSurface sector = app::outer_surface(mesh::tube("a", 0, 1, 3, {1, 3, 1}, quarter), 0);
  CHECK(sector.points.size() == 10);
  CHECK(sector.triangles.size() == 2 * 3 + 2 * 5);
  CHECK(volume_within(sector) ==
        Approx(3 * 3 * 0.25));  // three triangles with a side of 1 on either side of 30 degrees

  mesh::Mesh tet;
  tet.coordinates = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}};
  tet.blocks.push_back({.name = "t", .id = 1, .shape = mesh::Shape::tet4, .nodes = {0, 1, 2, 3}, .element_id = {1}});
  CHECK(volume_within(app::outer_surface(tet, 0)) == Approx(1. / 6));
  tet.blocks[0].nodes.clear();
  CHECK(app::outer_surface(tet, 0).triangles.empty());
}
