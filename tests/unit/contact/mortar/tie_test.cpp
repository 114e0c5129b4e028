// SPDX-License-Identifier: Apache-2.0
// Tied surfaces: no residual under rigid motions, with a gap across them too; the gradient against differences.
#include "contact/mortar/tie.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "evaluation.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::Evaluation;
using test::TwoSurfaces;

namespace {

TieStart tie_of(const TwoSurfaces& two, const Evaluation& evaluation) {
  return tie_start(two.surfaces, two.candidates, two.x, evaluation.rows);
}

std::vector<double> residuals_at(const TwoSurfaces& two, const MortarTopology& topology, const TieStart& start,
                                 std::span<const Vec3> x) {
  std::vector<Vec3> residuals;
  tie_residuals(start, two.surfaces, topology, x, residuals);
  return test::flat(residuals);
}

Mat3 turn_by(double angle) {
  return Eigen::AngleAxisd(angle, Vec3(1, -2, 3).normalized()).toRotationMatrix();
}

/// All nodes moved as one, and each a little by itself.
std::vector<Vec3> moved(std::vector<Vec3> x, const Mat3& turn, double shake) {
  for (std::size_t node = 0; node < x.size(); ++node) {
    const auto k = static_cast<double>(node);
    x[node] = turn * x[node] + Vec3(5, -3, 2) + shake * Vec3(std::sin(3 * k), std::cos(7 * k), std::sin(5 * k));
  }
  return x;
}

std::vector<Vec3> some_tractions(std::size_t rows) {
  std::vector<Vec3> tractions;
  for (std::size_t row = 0; row < rows; ++row) {
    const auto k = static_cast<double>(row);
    tractions.emplace_back(1 + std::sin(k), 2 * std::cos(3 * k), -1 + std::sin(2 * k));
  }
  return tractions;
}

/// forces[K] += (w_AK 1 + lever_AK)^T T_A; T: the tractions on the slave [force/length^2].
void add_tie_forces(const TieStart& start, const NodeBlocks<Mat3>& levers, std::span<const Vec3> tractions,
                    std::span<Vec3> forces) {
  for (std::size_t row = 0; row < tractions.size(); ++row) {
    const auto index = static_cast<LocalIndex>(row);
    const std::span<const LocalIndex> nodes = start.weights.nodes.row(index), turned = levers.nodes.row(index);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      nth(forces, nodes[k]) += start.weights.row(index)[k] * tractions[row];
    for (std::size_t k = 0; k < turned.size(); ++k)
      nth(forces, turned[k]) += levers.row(index)[k].transpose() * tractions[row];
  }
}

/// Forces of a step from x_before to x, or at x alone if x_before is empty.
std::vector<Vec3> forces_of(const TwoSurfaces& two, const MortarTopology& topology, const TieStart& start,
                            std::span<const Vec3> x_before, std::span<const Vec3> x) {
  NodeBlocks<Mat3> levers;
  tie_levers(start, two.surfaces, topology, x_before, x, levers);
  std::vector<Vec3> forces(x.size(), Vec3::Zero());
  add_tie_forces(start, levers, some_tractions(two.surfaces.rows.size()), forces);
  return forces;
}

}  // namespace

TEST_CASE("A tie with a gap across it does not resist rigid motions, and resists all others") {
  const auto flat = [](double height) { return [height](double x, double y) { return Vec3(x, y, height); }; };
  const TwoSurfaces two({3, 3, 0, 1, 0, 1, true, false}, flat(0), {4, 4, 0, 1, 0, 1, false, false}, flat(0.05));
  const Evaluation evaluation(two);
  const TieStart start = tie_of(two, evaluation);
  for (const double residual : residuals_at(two, evaluation.topology, start, moved(two.x, turn_by(2.5), 0)))
    CHECK(std::abs(residual) < 1e-13);
  std::vector<Vec3> x = two.x;
  const Vec3 shift(0.01, 0.02, 0.03);
  for (std::size_t node = 0; node < 16; ++node) x[node] += shift;
  const auto residuals = residuals_at(two, evaluation.topology, start, x);
  for (std::size_t k = 0; k < residuals.size(); ++k)
    CHECK(residuals[k] == Approx(shift[static_cast<Eigen::Index>(k % 3)]).epsilon(1e-12));
}

TEST_CASE("A tie of warped surfaces follows every rotation, about their normals too") {
  for (const bool triangles : {false, true}) {
    const TwoSurfaces two = test::wavy_surfaces(41, triangles, !triangles);
    const Evaluation evaluation(two);
    const TieStart start = tie_of(two, evaluation);
    CHECK(start.apart);
    for (const double angle : {0.0, 0.3, 3.0})
      for (const double residual : residuals_at(two, evaluation.topology, start, moved(two.x, turn_by(angle), 0)))
        CHECK(std::abs(residual) < 1e-14);
  }
}

TEST_CASE("Surfaces that touch have no levers") {
  const auto flat = [](double x, double y) { return Vec3(x, y, 0.3 * x + 0.1 * y); };
  const TwoSurfaces two({3, 3, 0, 1, 0, 1, true, false}, flat, {4, 4, 0, 1, 0, 1, false, false}, flat);
  const Evaluation evaluation(two);
  CHECK(!tie_of(two, evaluation).apart);
}

TEST_CASE("The levers of a tie at x are its gradient, and its patches that of its forces") {
  for (const bool triangles : {false, true})
    for (const bool in_step : {false, true}) {
      const TwoSurfaces two = test::wavy_surfaces(40, triangles);
      const Evaluation evaluation(two);
      const TieStart start = tie_of(two, evaluation);
      const std::vector<Vec3> x = moved(two.x, turn_by(0.4), 0.02),
                              x_before = in_step ? moved(two.x, turn_by(0.1), 0.01) : std::vector<Vec3>();
      NodeBlocks<Mat3> gradient;
      tie_levers(start, two.surfaces, evaluation.topology, {}, x, gradient);
      std::vector<double> matrix = test::assembled(gradient, x.size());
      for (std::size_t row = 0; row < two.surfaces.rows.size(); ++row) {
        const auto nodes = start.weights.nodes.row(static_cast<LocalIndex>(row));
        for (std::size_t k = 0; k < nodes.size(); ++k)
          for (std::size_t c = 0; c < 3; ++c)
            matrix[(3 * row + c) * 3 * x.size() + 3 * static_cast<std::size_t>(nodes[k]) + c] +=
                start.weights.row(static_cast<LocalIndex>(row))[k];
        for (std::size_t k = 0; k < 9 * x.size() && start.covered[row] > 0; ++k)
          matrix[9 * row * x.size() + k] /= start.covered[row];
      }
      const auto residuals = [&](std::span<const Vec3> at) {
        return residuals_at(two, evaluation.topology, start, at);
      };
      CHECK(test::difference(matrix, x, residuals) < 1e-8);

      Patches patches;
      tie_patches(start, two.surfaces, evaluation.topology, x_before, x, some_tractions(two.surfaces.rows.size()),
                  patches);
      const auto forces = [&](std::span<const Vec3> at) {
        return test::flat(forces_of(two, evaluation.topology, start, x_before, at));
      };
      CHECK(test::difference(test::assembled(patches, x.size()), x, forces) < 1e-7);
    }
}

TEST_CASE("Forces of a tie in a step have no sum, no moment beyond its equations, and do their work exactly") {
  for (const bool triangles : {false, true}) {
    const TwoSurfaces two = test::wavy_surfaces(43, triangles);
    const Evaluation evaluation(two);
    const TieStart start = tie_of(two, evaluation);
    // the tie holds at both ends only if the nodes move as one; then nothing is left
    const std::vector<Vec3> x_before = moved(two.x, turn_by(0.2), 0), x = moved(two.x, turn_by(1.1), 0);
    const std::vector<Vec3> forces = forces_of(two, evaluation.topology, start, x_before, x);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    double size = 0, work = 0;
    for (std::size_t node = 0; node < x.size(); ++node) {
      sum += forces[node];
      moment += (0.5 * (x_before[node] + x[node])).cross(forces[node]);
      work += forces[node].dot(x[node] - x_before[node]);
      size += forces[node].norm();
    }
    CHECK(size > 1);
    CHECK(sum.norm() < 1e-14 * size);
    CHECK(moment.norm() < 1e-13 * size);
    CHECK(std::abs(work) < 1e-13 * size);
    // in any other motion the work is that of the tractions on the change of the equations
    const std::vector<Vec3> strained = moved(two.x, turn_by(1.1), 0.05),
                            tractions = some_tractions(two.surfaces.rows.size());
    std::vector<Vec3> left_before, left;
    tie_residuals(start, two.surfaces, evaluation.topology, x_before, left_before);
    tie_residuals(start, two.surfaces, evaluation.topology, strained, left);
    double change = 0;
    work = 0;
    for (std::size_t row = 0; row < left.size(); ++row)
      change += start.covered[row] * tractions[row].dot(left[row] - left_before[row]);
    const std::vector<Vec3> in_step = forces_of(two, evaluation.topology, start, x_before, strained);
    for (std::size_t node = 0; node < x.size(); ++node) work += in_step[node].dot(strained[node] - x_before[node]);
    CHECK(std::abs(change) > 1e-3);
    CHECK(work == Approx(change).epsilon(1e-12));
  }
}

TEST_CASE("A tie loses multipliers where both sides are held, not where the master is free") {
  const auto flat = [](double height) { return [height](double x, double y) { return Vec3(x, y, height); }; };
  const TwoSurfaces two({3, 3, 0, 1, 0, 1, true, false}, flat(0), {4, 4, 0, 1, 0, 1, false, false}, flat(0));
  const Evaluation evaluation(two);
  TieStart start = tie_of(two, evaluation);
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
