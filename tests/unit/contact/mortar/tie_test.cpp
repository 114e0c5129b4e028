// SPDX-License-Identifier: Apache-2.0
// Tied surfaces: no residual under rigid motions, with a gap across them too; the gradient against differences.
#include "brunt/contact/mortar/tie.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "brunt/contact/mortar/normals.hpp"
#include "evaluation.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::Evaluation;
using test::TwoSurfaces;

namespace {

std::vector<double> residuals_at(const TwoSurfaces& two, const MortarTopology& topology, const TieStart& start,
                                 std::span<const Vec3> x) {
  std::vector<Vec3> normals, residuals;
  nodal_normals(two.surfaces, topology, x, normals);
  tie_residuals(start, x, normals, residuals);
  return test::flat(residuals);
}

}  // namespace

TEST_CASE("A tie with a gap across it does not resist rigid motions, and resists all others") {
  const auto flat = [](double height) { return [height](double x, double y) { return Vec3(x, y, height); }; };
  const TwoSurfaces two({3, 3, 0, 1, 0, 1, true, false}, flat(0), {4, 4, 0, 1, 0, 1, false, false}, flat(0.05));
  const Evaluation evaluation(two);
  const TieStart start = tie(evaluation.rows);
  std::vector<Vec3> x = two.x;
  const Mat3 turn = Eigen::AngleAxisd(2.5, Vec3(1, -2, 3).normalized()).toRotationMatrix();
  for (Vec3& of_node : x) of_node = turn * of_node + Vec3(5, -3, 2);
  for (const double residual : residuals_at(two, evaluation.topology, start, x)) CHECK(std::abs(residual) < 1e-13);
  x = two.x;
  const Vec3 shift(0.01, 0.02, 0.03);
  for (std::size_t node = 0; node < 16; ++node) x[node] += shift;
  const auto residuals = residuals_at(two, evaluation.topology, start, x);
  for (std::size_t k = 0; k < residuals.size(); ++k)
    CHECK(residuals[k] == Approx(shift[static_cast<Eigen::Index>(k % 3)]).epsilon(1e-12));
}

TEST_CASE("The gradient of a tie agrees with central differences, and its forces have no sum") {
  const TwoSurfaces two = test::wavy_surfaces(40);
  const Evaluation evaluation(two);
  const TieStart start = tie(evaluation.rows);
  TwoSurfaces moved = two;
  for (std::size_t node = 0; node < moved.x.size(); ++node)
    moved.x[node] +=
        0.02 * Vec3(std::sin(3.0 * static_cast<double>(node)), std::cos(7.0 * static_cast<double>(node)), 0);
  std::vector<Vec3> normals;
  NodeBlocks<Mat3> normal_slopes, gradient;
  nodal_normals(moved.surfaces, evaluation.topology, moved.x, normals, &normal_slopes);
  tie_gradient(start, normals, normal_slopes, gradient);
  const auto residuals = [&](std::span<const Vec3> x) { return residuals_at(moved, evaluation.topology, start, x); };
  CHECK(test::difference(test::assembled(gradient, moved.x.size()), moved.x, residuals) < 1e-8);

  std::vector<Vec3> forces(moved.x.size(), Vec3::Zero());
  add_tie_forces(start, std::vector<Vec3>(moved.surfaces.rows.size(), Vec3(1, 2, 3)), forces);
  Vec3 sum = Vec3::Zero();
  double size = 0;
  for (const Vec3& force : forces) {
    sum += force;
    size += force.norm();
  }
  CHECK(size > 1);
  CHECK(sum.norm() < 1e-15 * size);
}

TEST_CASE("A tie loses multipliers where both sides are held, not where the master is free") {
  const auto flat = [](double height) { return [height](double x, double y) { return Vec3(x, y, height); }; };
  const TwoSurfaces two({3, 3, 0, 1, 0, 1, true, false}, flat(0), {4, 4, 0, 1, 0, 1, false, false}, flat(0));
  const Evaluation evaluation(two);
  TieStart start = tie(evaluation.rows);
  find_places_below(two.surfaces, evaluation.topology, two.candidates, two.x, start);
  const Mat3 across = Vec3(0, 1, 1).asDiagonal();  // held along x
  std::vector<Mat3> free(two.x.size(), Mat3::Identity());
  const auto tied = [&] { return tied_directions(two.surfaces, start, free); };
  for (std::size_t node = 0; node < 16; ++node) free[node].setZero();  // the slave is driven as a whole
  for (const Mat3& of_row : tied()) CHECK(of_row.isIdentity());
  for (std::size_t node = 0; node < two.x.size(); ++node)  // both sides meet a plane of symmetry at x = 0
    free[node] = two.x[node][0] == 0 ? across : Mat3(Mat3::Identity());
  const std::vector<Mat3> at_plane = tied();
  for (std::size_t row = 0; row < 16; ++row)
    CHECK(at_plane[row].isApprox(two.x[row][0] == 0 ? across : Mat3(Mat3::Identity()), 1e-12));
}
