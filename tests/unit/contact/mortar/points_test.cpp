// SPDX-License-Identifier: Apache-2.0
// Rows of nodes of a sharp edge on facets: gaps of planes, forces, derivatives against differences.
#include "brunt/contact/mortar/points.hpp"

#include <catch2/catch.hpp>

#include "brunt/contact/mortar/forces.hpp"
#include "brunt/contact/mortar/patches.hpp"
#include "brunt/contact/mortar/tractions.hpp"
#include "evaluation.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::TwoSurfaces;

namespace {

/// A ridge along y at x = .5 whose sides fall at this slope, under a surface that looks down.
TwoSurfaces ridge_under(double slope, const TwoSurfaces::Place& above, bool triangles) {
  TwoSurfaces two(
      {2, 3, 0.1, 0.9, 0.05, 0.95, true, triangles},
      [&](double x, double y) { return Vec3(x, y + 0.02 * x, -slope * std::abs(x - 0.5)); },
      {3, 2, -0.1, 1.2, -0.1, 1.3, false, triangles}, above);
  two.surfaces.rows = sharp_nodes(two.surfaces.slave, two.x);
  std::vector<std::array<GlobalIndex, 4>> patches;
  for (const FacetNodes& rows : patch_rows(two.surfaces.master, two.x).of_corner)
    patches.push_back({rows[0], rows[1], rows[2], rows[3]});
  two.surfaces.master_patches = patches_of(patches);
  return two;
}

TwoSurfaces wavy(bool triangles) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-0.03, 0.03);
  return ridge_under(
      1.5,
      [&](double x, double y) {
        return Vec3(x + 0.1 * y + number(random), y + number(random),
                    0.05 + 0.1 * std::sin(3 * x + y) + number(random));
      },
      triangles);
}

struct Points {
  MortarTopology topology;
  MortarRows rows;
  MortarSlopes slopes;

  explicit Points(const TwoSurfaces& two) : topology(make_topology(two.surfaces, two.x)) { at(two, two.x); }
  void at(const TwoSurfaces& two, std::span<const Vec3> x) {
    point_rows(two.surfaces, topology, two.candidates, x, rows);
  }
};

}  // namespace

TEST_CASE("Nodes of an edge have the distance of a plane as their gap") {
  const Vec3 normal = Vec3(0.1, -0.2, -1).normalized();
  const TwoSurfaces two = ridge_under(
      1, [&](double x, double y) { return Vec3(x, y, 0.02 - (normal[0] * x + normal[1] * y) / normal[2]); }, false);
  const Points points(two);
  REQUIRE(two.surfaces.rows.size() == 4);
  for (std::size_t row = 0; row < 4; ++row) {
    CHECK((points.rows.normals[row] - normal).norm() < 1e-14);
    const Vec3 from_plane = two.x[static_cast<std::size_t>(two.surfaces.rows[row])] - Vec3(0, 0, 0.02);
    CHECK(points.rows.gaps[row] / points.rows.covered[row] == Approx(normal.dot(from_plane)).epsilon(1e-12));
    double sum = 0;
    for (const double weight : points.rows.weights.row(static_cast<LocalIndex>(row))) sum += weight;
    CHECK(std::abs(sum) < 1e-15);
  }
}

TEST_CASE("No facet is found on the far side, beyond the capture distance, or beside") {
  TwoSurfaces two = ridge_under(
      1, [](double x, double y) { return Vec3(x, y, 0.2); }, false);
  two.surfaces.capture = 0.1;
  CHECK(Points(two).rows.segments == 0);
  two.surfaces.capture = 1;
  CHECK(Points(two).rows.segments == 4);
  for (FacetNodes& facet : two.surfaces.master) std::swap(facet[1], facet[3]);
  CHECK(Points(two).rows.segments == 0);
  const TwoSurfaces beside = ridge_under(
      1, [](double x, double y) { return Vec3(x + 2, y, 0.2); }, false);
  CHECK(Points(beside).rows.segments == 0);
}

TEST_CASE("Derivatives of the rows of an edge: gaps, forces, places that do not move") {
  for (const bool triangles : {false, true}) {
    const TwoSurfaces two = wavy(triangles);
    Points points(two);
    REQUIRE(points.rows.segments == two.surfaces.rows.size());
    const std::size_t nodes = two.x.size();
    const std::vector<double> z = test::some_pressures(two.surfaces.rows.size());
    std::vector<Vec3> tractions, fixed = two.x;
    for (Vec3& y : fixed) y = Vec3(y[1], 0.3 + y[0] * y[2], y[2] - y[0]);
    normal_tractions(points.rows, z, tractions);
    point_rows_and_slopes(two.surfaces, points.topology, two.candidates, two.x, tractions, points.rows, points.slopes,
                          fixed);
    NodeBlocks<Vec3> gradient, of_fixed;
    gap_gradient(points.rows, points.slopes, gradient);
    CHECK(test::difference(test::assembled(gradient, nodes), two.x, [&](const std::vector<Vec3>& x) {
            points.at(two, x);
            return points.rows.gaps;
          }) < 1e-8);
    points.at(two, two.x);
    gaps_at_gradient(points.rows, points.slopes, fixed, of_fixed);
    CHECK(test::difference(test::assembled(of_fixed, nodes), two.x, [&](const std::vector<Vec3>& x) {
            points.at(two, x);
            std::vector<double> gaps;
            gaps_at(points.rows, fixed, gaps);
            return gaps;
          }) < 1e-8);
    points.at(two, two.x);
    TractionSlopes slopes;
    normal_traction_slopes(points.rows, points.slopes, z, slopes);
    add_traction_slopes(points.rows, slopes.by_position, points.slopes.weights);
    CHECK(test::difference(test::assembled(points.slopes.weights, nodes), two.x, [&](const std::vector<Vec3>& x) {
            points.at(two, x);
            std::vector<Vec3> of_rows, forces(nodes, Vec3::Zero());
            normal_tractions(points.rows, z, of_rows);
            add_forces(points.rows, of_rows, forces);
            return test::flat(forces);
          }) < 1e-8);
  }
}

TEST_CASE("The normal is continuous where a node passes from one facet to the next") {
  TwoSurfaces two = ridge_under(
      1, [](double x, double y) { return Vec3(x, y, 0.3 * std::abs(x - 1.0 / 3)); }, false);
  Points points(two);
  const auto normal_at = [&](double shift) {
    std::vector<Vec3> x = two.x;
    for (const LocalIndex row : two.surfaces.rows) x[static_cast<std::size_t>(row)][0] = 1.0 / 3 + shift;
    for (const LocalIndex row : two.surfaces.rows) x[static_cast<std::size_t>(row)][2] = 0;
    points.at(two, x);
    REQUIRE(points.rows.segments == 4);
    return points.rows.normals[1];
  };
  CHECK((normal_at(1e-7) - normal_at(-1e-7)).norm() < 1e-5);
  CHECK((normal_at(0.05) - normal_at(-0.05)).norm() > 0.01);
}
