// SPDX-License-Identifier: Apache-2.0
// Rows of nodes of a sharp edge on facets: gaps of planes, forces, derivatives against differences.
#include "contact/mortar/points.hpp"

#include <catch2/catch.hpp>

#include "contact/mortar/forces.hpp"
#include "contact/mortar/patches.hpp"
#include "contact/mortar/tractions.hpp"
#include "evaluation.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::TwoSurfaces;

namespace {

/// The patches of the master; its rim at y = mirror is in a plane of symmetry.
void find_patches(TwoSurfaces& two, double mirror = -1) {
  std::vector<std::uint8_t> rims = rims_of(two.surfaces.master, two.x);
  std::vector<PatchNumbers> patches;
  for (const FacetNodes& rows : patch_rows(two.surfaces.master, two.x).of_corner) {
    PatchNumbers& of = patches.emplace_back();
    std::ranges::copy(rows, of.of_corner.begin());
    const FacetNodes& nodes = two.surfaces.master[patches.size() - 1];
    const std::size_t corners = nodes[3] == no_index ? 3 : 4;
    const auto y = [&](std::size_t k) { return two.x[static_cast<std::size_t>(nodes[k % corners])][1]; };
    for (std::size_t k = 0; k < corners; ++k)
      if (y(k) != mirror || y(k + 1) != mirror) of.rims |= rims[patches.size() - 1] & (1 << k);
  }
  two.surfaces.master_patches = patches_of(patches);
}

/// A ridge along y at x = .5 whose sides fall at this slope, under a surface that looks down.
TwoSurfaces ridge_under(double slope, const TwoSurfaces::Place& above, bool triangles) {
  TwoSurfaces two(
      {2, 3, 0.1, 0.9, 0.05, 0.95, true, triangles},
      [&](double x, double y) { return Vec3(x, y + 0.02 * x, -slope * std::abs(x - 0.5)); },
      {3, 2, -0.1, 1.2, -0.1, 1.3, false, triangles}, above);
  two.surfaces.rows = sharp_nodes(two.surfaces.slave, two.x);
  find_patches(two);
  return two;
}

/// with_rim: the surface above ends close to the last node of the ridge.
TwoSurfaces wavy(bool triangles, bool with_rim = false) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-0.03, 0.03);
  return ridge_under(
      1.5,
      [&](double x, double y) {
        return Vec3(x + 0.1 * y + number(random), (with_rim ? 0.75 : 1.0) * y + number(random),
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

TEST_CASE("No line passes between two facets or beside them in a plane of symmetry, however warped they are") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-0.1, 0.1);
  for (const bool triangles : {false, true}) {
    TwoSurfaces two(
        {2, 2000, 0.1, 0.9, 0, 0.95, true, triangles},
        [](double x, double y) { return Vec3(x, y, -1.5 * std::abs(x - 0.5)); },
        {4, 5, -0.2, 1.3, 0, 1.3, false, triangles},
        [&](double x, double y) { return Vec3(x + 0.1 * y, y, 0.3 * y + 0.1 * std::sin(5 * x + y) + number(random)); });
    two.surfaces.rows = sharp_nodes(two.surfaces.slave, two.x);
    find_patches(two, 0);
    for (const LocalIndex row : two.surfaces.rows) {
      if (two.x[static_cast<std::size_t>(row)][1] == 0) two.surfaces.mirrors.values.emplace_back(0, 1, 0);
      two.surfaces.mirrors.close_row();
    }
    const Points points(two);
    CHECK(two.surfaces.rows.size() == 2001);
    CHECK(points.rows.segments == 2001);
    CHECK(points.rows.covered[0] * points.topology.kappa[0] == Approx(1).epsilon(1e-14));
  }
}

TEST_CASE("A row fades out at a rim, and not in a plane of symmetry") {
  TwoSurfaces two = ridge_under(
      1, [](double x, double y) { return Vec3(x, y, 0.1 * x); }, false);
  Points points(two);
  const double width = 1.4 / 2;
  const auto covered_at = [&](double way) {  // of the first node, from the rim at y = -.1
    std::vector<Vec3> x = two.x;
    x[static_cast<std::size_t>(two.surfaces.rows[0])][1] = -0.1 + way * width;
    points.at(two, x);
    return points.rows.covered[0] * points.topology.kappa[0];
  };
  CHECK(covered_at(-1e-3) == 0);
  CHECK(covered_at(1e-3) == Approx(3e-4).epsilon(0.01));
  CHECK(covered_at(0.05) == Approx(0.5).epsilon(1e-12));
  CHECK(covered_at(0.101) == Approx(1).epsilon(1e-14));
  find_patches(two, -0.1);
  CHECK(covered_at(1e-3) == Approx(1).epsilon(1e-14));
}

TEST_CASE("The share of a row is continuous along a rim") {
  for (const bool triangles : {false, true}) {
    TwoSurfaces two = ridge_under(
        1, [](double x, double y) { return Vec3(x, y, 0.1 * x); }, triangles);
    Points points(two);
    std::vector<Vec3> x = two.x;
    double before = -1;
    for (int k = 0; k < 1000; ++k) {
      x[static_cast<std::size_t>(two.surfaces.rows[0])] = Vec3(0.2 + 8e-4 * k, -0.1 + 0.04 * 0.7, 0);
      points.at(two, x);
      const double share = points.rows.covered[0] * points.topology.kappa[0];
      if (k > 0) CHECK(std::abs(share - before) < 0.02);
      before = share;
    }
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
  for (const int kind : {0, 1, 2, 3}) {
    const TwoSurfaces two = wavy(kind % 2 == 1, kind >= 2);
    Points points(two);
    REQUIRE(points.rows.segments == two.surfaces.rows.size());
    const std::size_t last = two.surfaces.rows.size() - 1;
    const double share = points.rows.covered[last] * points.topology.kappa[last];
    CAPTURE(share);
    CHECK((share > 0.1 && share < 0.9) == (kind >= 2));
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

TEST_CASE("Gaps, weights and normals are continuous where a node passes from one facet to the next") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-0.05, 0.05);
  TwoSurfaces two = ridge_under(
      1, [&](double x, double y) { return Vec3(x, y, 0.3 * std::abs(x - 1.0 / 3) + (x > 1 ? 0 : number(random))); },
      false);
  Points points(two);
  const auto at = [&](double shift) {
    std::vector<Vec3> x = two.x;
    for (const LocalIndex row : two.surfaces.rows) x[static_cast<std::size_t>(row)][0] = 1.0 / 3 + shift;
    for (const LocalIndex row : two.surfaces.rows) x[static_cast<std::size_t>(row)][2] = -0.2;
    points.at(two, x);
    REQUIRE(points.rows.segments == 4);
    std::vector<Vec3> forces(two.x.size(), Vec3::Zero());
    add_forces(points.rows, points.rows.normals, forces);
    std::vector<double> all = test::flat(forces);
    all.insert(all.end(), points.rows.gaps.begin(), points.rows.gaps.end());
    return all;
  };
  const auto largest = [](const std::vector<double>& a, const std::vector<double>& b) {
    double difference = 0;
    for (std::size_t k = 0; k < a.size(); ++k) difference = std::max(difference, std::abs(a[k] - b[k]));
    return difference;
  };
  CHECK(largest(at(1e-9), at(-1e-9)) < 1e-8);
  CHECK(largest(at(0.05), at(-0.05)) > 1e-3);
}
