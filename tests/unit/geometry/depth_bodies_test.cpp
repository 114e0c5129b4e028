// SPDX-License-Identifier: Apache-2.0
// The bodies of the tests themselves: counts and volumes that were computed by another program, closed and simple.
#include "support/depth_bodies.hpp"

#include <catch2/catch.hpp>

#include "geometry/triangles/slab_tree.hpp"

using namespace brunt;

TEST_CASE("the six bodies have the triangles and volumes of the table, and do not cross themselves") {
  struct Row {
    const char* name;
    TriangleSurface surface;
    std::size_t triangles;
    double volume;
  };
  const std::vector<Row> table{
      {"L", test::l_shape(), 20, 1.020000},       {"knot", test::knot(), 2880, 10.334392},
      {"pawn", test::pawn(), 304, .598163},       {"hub", test::hub(), 2442, 5.628048},
      {"mallet", test::mallet(), 1692, 1.570142}, {"bumpy sphere", test::bumpy_sphere(), 2880, 14.142815}};
  for (const Row& row : table) {
    INFO(row.name);
    CHECK(row.surface.triangles.size() == row.triangles);
    CHECK(std::abs(test::volume(row.surface) - row.volume) < 6e-7);
    CHECK(geometry::self_crossings(geometry::build_slab_tree(row.surface)).count == 0);
    CHECK(geometry::winding_number(row.surface, row.surface.points[0] + Vec3(50, 0, 0)) == Approx(0).margin(1e-12));
  }
  CHECK((test::volume_centroid(test::pawn()) - Vec3(0, 0, .735006)).norm() < 1e-6);
  CHECK((test::volume_centroid(test::mallet()) - Vec3(0, 0, 3.063899)).norm() < 1e-6);
  CHECK((test::volume_centroid(test::l_shape()) - Vec3(.711765, .711765, .25)).norm() < 1e-6);
}
