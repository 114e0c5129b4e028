// SPDX-License-Identifier: Apache-2.0
// Consistent forces: the gradient of the weighted gaps' work by central differences, without resultant and moment.
#include "contact/mortar/levers.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>

#include "contact/mortar/forces.hpp"
#include "contact/mortar/tractions.hpp"
#include "evaluation.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::Evaluation;
using test::TwoSurfaces;

namespace {

/// Where sides of facets meet, second derivatives jump, and differences err by the step of 1e-6.
constexpr double at_jumps = 1e-6;

/// Wavy surfaces, and two that touch along a part of the square: rims, corners of either over the middle of the other.
std::vector<TwoSurfaces> configurations() {
  std::vector<TwoSurfaces> all;
  for (unsigned seed = 1; seed <= 6; ++seed) all.push_back(test::wavy_surfaces(seed, seed % 2 == 0, seed % 3 == 0));
  const auto bent = [](double depth) {
    return [depth](double x, double y) { return Vec3(x, y, depth + 0.2 * x * x - 0.1 * x * y); };
  };
  for (const double offset : {0.13, 0.37, 0.61})
    all.emplace_back(test::Sheet{4, 3, 0, 1, 0, 1, true, false}, bent(0.02),
                     test::Sheet{3, 5, offset, 1 + offset, -0.4 * offset, 1.01, false, offset > 0.5}, bent(-0.002));
  for (std::size_t k = 1; k < all.size(); k += 2) all[k].surfaces.multiplier = Multiplier::standard;
  return all;
}

/// forces[K] += z_A l_AK over all rows [force].
void add_lever_forces(const NodeBlocks<Vec3>& levers, std::span<const double> z, std::span<Vec3> forces) {
  for (std::size_t row = 0; row < z.size(); ++row) {
    if (z[row] == 0) continue;
    const auto index = static_cast<LocalIndex>(row);
    const std::span<const LocalIndex> nodes = levers.nodes.row(index);
    for (std::size_t k = 0; k < nodes.size(); ++k) nth(forces, nodes[k]) += z[row] * levers.row(index)[k];
  }
}

/// Of the last evaluation, at the pressures z; penalty: their stiffness, or 0.
std::vector<Vec3> forces_of(const TwoSurfaces& two, Evaluation& evaluation, std::span<const double> z, double penalty,
                            NodeBlocks<Vec3>& levers) {
  evaluation.differentiate(two, {});
  NodeBlocks<Vec3> gradient;
  gap_gradient(evaluation.rows, evaluation.slopes, gradient);
  gap_levers(evaluation.rows, gradient, levers);
  if (penalty > 0) add_penalty_levers(evaluation.slopes, penalty, z, levers);
  std::vector<Vec3> tractions, forces(two.x.size(), Vec3::Zero());
  normal_tractions(evaluation.rows, z, tractions);
  add_forces(evaluation.rows, tractions, forces);
  add_lever_forces(levers, z, forces);
  return forces;
}

double work_of_gaps(const Evaluation& evaluation, std::span<const double> z) {
  double work = 0;
  for (std::size_t row = 0; row < z.size(); ++row) work += z[row] * evaluation.rows.gaps[row];
  return work;
}

double energy_of_penalty(const Evaluation& evaluation, double stiffness) {
  double energy = 0;
  for (std::size_t row = 0; row < evaluation.rows.gaps.size(); ++row)
    if (const double gap = evaluation.rows.gaps[row]; gap < 0)
      energy += 0.5 * stiffness * gap * gap / evaluation.rows.covered[row];
  return energy;
}

void check_balance(const std::vector<Vec3>& forces, const std::vector<Vec3>& x) {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  double size = 0;
  for (std::size_t node = 0; node < x.size(); ++node) {
    force += forces[node];
    moment += x[node].cross(forces[node]);
    size += forces[node].norm();
  }
  CHECK(size > 0);
  CHECK(force.norm() < 1e-13 * size);
  CHECK(moment.norm() < 1e-13 * size);
}

}  // namespace

TEST_CASE("Consistent forces are the gradient of the weighted gaps, without a resultant and a moment") {
  for (const TwoSurfaces& two : configurations()) {
    Evaluation evaluation(two), moved(two);
    const std::vector<double> z = test::some_pressures(two.surfaces.rows.size());
    NodeBlocks<Vec3> levers;
    const std::vector<Vec3> forces = forces_of(two, evaluation, z, 0, levers);
    check_balance(forces, two.x);
    const auto work = [&](std::span<const Vec3> x) {
      moved.move(two, x);
      return std::vector<double>{work_of_gaps(moved, z)};
    };
    CHECK(test::difference(test::flat(forces), two.x, work) < at_jumps);
  }
}

TEST_CASE("Consistent forces of a penalty are the gradient of its energy, which a closed path gives back") {
  int pressed = 0;
  for (const TwoSurfaces& two : configurations()) {
    Evaluation evaluation(two), moved(two);
    const double stiffness = 30;
    std::vector<double> z;
    penalty_pressures(evaluation.rows, stiffness, {}, z);
    if (std::ranges::all_of(z, [](double pressure) { return pressure == 0; })) continue;
    NodeBlocks<Vec3> levers;
    std::vector<Vec3> forces = forces_of(two, evaluation, z, stiffness, levers);
    check_balance(forces, two.x);
    for (Vec3& force : forces) force = -force;
    const auto energy = [&](std::span<const Vec3> x) {
      moved.move(two, x);
      return std::vector<double>{energy_of_penalty(moved, stiffness)};
    };
    CHECK(test::difference(test::flat(forces), two.x, energy) < at_jumps);
    ++pressed;
  }
  CHECK(pressed >= 6);
}

TEST_CASE("The tangent of consistent forces is symmetric, and exact where second derivatives do no work") {
  // Sum_K (n . x_K) d2w_AK vanishes where all nodes lie in one plane, and so does G_A.
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  for (const bool triangles : {false, true}) {
    const auto slave = [&](double x, double y) { return Vec3(turn * Vec3(x + 0.07 * y * y, y - 0.05 * x * y, 0)); };
    const auto master = [&](double x, double y) { return Vec3(turn * Vec3(x + 0.21 * y, y - 0.11 * x + 0.04, 0)); };
    const TwoSurfaces two({3, 3, 0, 1, 0, 1, true, triangles}, slave, {4, 5, -0.4, 1.3, -0.2, 1.4, false, false},
                          master);
    Evaluation evaluation(two), moved(two);
    const std::vector<double> z = test::some_pressures(two.surfaces.rows.size());
    std::vector<Vec3> tractions;
    normal_tractions(evaluation.rows, z, tractions);
    mortar_rows_and_slopes(two.surfaces, evaluation.topology, two.candidates, two.x, tractions, *evaluation.scratch,
                           evaluation.rows, evaluation.slopes, {}, tractions);
    TractionSlopes slopes;
    Patches patches;
    lever_patches(evaluation.rows, evaluation.slopes, z, patches);
    normal_traction_slopes(evaluation.rows, evaluation.slopes, z, slopes);
    add_traction_slopes(evaluation.rows, slopes.by_position, evaluation.slopes.weights);
    const std::size_t size = 3 * two.x.size();
    std::vector<double> matrix = test::assembled(evaluation.slopes.weights, two.x.size());
    const std::vector<double> of_levers = test::assembled(patches, two.x.size());
    double largest = 0, skew = 0;
    for (std::size_t k = 0; k < matrix.size(); ++k) {
      matrix[k] += of_levers[k];
      largest = std::max(largest, std::abs(matrix[k]));
    }
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < i; ++j) skew = std::max(skew, std::abs(matrix[i * size + j] - matrix[j * size + i]));
    CHECK(skew < 1e-12 * largest);
    const auto forces = [&](std::span<const Vec3> x) {
      TwoSurfaces there = two;
      there.x.assign(x.begin(), x.end());
      moved.move(there, x);
      NodeBlocks<Vec3> levers;
      return test::flat(forces_of(there, moved, z, 0, levers));
    };
    CHECK(test::difference(matrix, two.x, forces) < 1e-5);
  }
}
