// SPDX-License-Identifier: Apache-2.0
// Nodal normals of known surfaces, in symmetry planes, and their slopes against central differences.
#include "contact/mortar/normals.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "evaluation.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::TwoSurfaces;

TEST_CASE("At a roof's ridge the normal bisects, and in a symmetry plane it lies in it") {
  const auto roof = [](double x, double y) { return Vec3(x, y, -std::abs(x - 0.5)); };
  const auto flat = [](double x, double y) { return Vec3(x, y, 0.1); };
  TwoSurfaces two({2, 1, 0, 1, 0, 1, true, false}, roof, {1, 1, 0, 1, 0, 1, false, false}, flat);
  const MortarTopology topology = make_topology(two.surfaces, two.x);
  std::vector<Vec3> normals;
  nodal_normals(two.surfaces, topology, two.x, normals);
  const double half = std::sqrt(0.5);
  CHECK((normals[1] - Vec3(0, 0, -1)).norm() < 1e-15);
  CHECK((normals[0] - Vec3(half, 0, -half)).norm() < 1e-15);
  two.surfaces.mirrors.values = {Vec3(1, 0, 0)};
  for (int row = 0; row < 6; ++row) two.surfaces.mirrors.close_row();
  nodal_normals(two.surfaces, topology, two.x, normals);
  CHECK((normals[0] - Vec3(0, 0, -1)).norm() < 1e-15);
}

TEST_CASE("Slopes of nodal normals agree with central differences") {
  for (const bool triangles : {false, true}) {
    TwoSurfaces two = test::wavy_surfaces(50, triangles);
    for (std::size_t row = 0; row < two.surfaces.rows.size(); ++row) {
      if (row % 3 == 0) two.surfaces.mirrors.values.emplace_back(1, 0, 0);
      if (row % 6 == 0) two.surfaces.mirrors.values.emplace_back(0.6, 0.8, 0);  // not orthogonal to the first
      two.surfaces.mirrors.close_row();
    }
    const MortarTopology topology = make_topology(two.surfaces, two.x);
    std::vector<Vec3> normals;
    NodeBlocks<Mat3> slopes;
    nodal_normals(two.surfaces, topology, two.x, normals, &slopes);
    for (std::size_t row = 0; row < normals.size(); ++row) {
      CHECK(normals[row].norm() == Approx(1).epsilon(1e-15));
      for (const Vec3& mirror : two.surfaces.mirrors.row(static_cast<LocalIndex>(row)))
        CHECK(std::abs(normals[row].dot(mirror)) < 1e-15);
    }
    const auto function = [&](std::span<const Vec3> x) {
      nodal_normals(two.surfaces, topology, x, normals);
      return test::flat(normals);
    };
    CHECK(test::difference(test::assembled(slopes, two.x.size()), two.x, function) < 1e-8);
  }
}
