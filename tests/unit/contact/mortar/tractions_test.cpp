// SPDX-License-Identifier: Apache-2.0
// Penalty pressures, and the tangent of the forces that they make, against central differences.
#include "contact/mortar/tractions.hpp"

#include <catch2/catch.hpp>

#include "contact/mortar/forces.hpp"
#include "evaluation.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::Evaluation;
using test::TwoSurfaces;

namespace {

std::vector<double> penalty_forces(const TwoSurfaces& two, Evaluation& evaluation, std::span<const Vec3> x,
                                   double stiffness, std::span<const double> base) {
  evaluation.move(two, x);
  std::vector<double> z;
  std::vector<Vec3> tractions, forces(x.size(), Vec3::Zero());
  penalty_pressures(evaluation.rows, stiffness, base, z);
  normal_tractions(evaluation.rows, z, tractions);
  add_forces(evaluation.rows, tractions, forces);
  return test::flat(forces);
}

}  // namespace

TEST_CASE("A penalty presses in proportion to the penetration, and not where the gap is open") {
  const auto flat = [](double height) { return [height](double x, double y) { return Vec3(x, y, height); }; };
  for (const double gap : {0.01, -0.01}) {
    const TwoSurfaces two({3, 3, 0, 1, 0, 1, true, false}, flat(0), {4, 4, 0, 1, 0, 1, false, false}, flat(gap));
    Evaluation evaluation(two);
    std::vector<double> z;
    penalty_pressures(evaluation.rows, 50, {}, z);
    for (const double of_row : z) CHECK(of_row == Approx(gap > 0 ? 0 : 0.5).epsilon(1e-12));
    const std::vector<double> base(z.size(), 0.7);
    penalty_pressures(evaluation.rows, 50, base, z);
    for (const double of_row : z) CHECK(of_row == Approx(gap > 0 ? 0.2 : 1.2).epsilon(1e-12));
  }
}

TEST_CASE("A penalty is as stiff at a rim, and at the nodes of side faces, as within") {
  const auto flat = [](double height) { return [height](double x, double y) { return Vec3(x, y, height); }; };
  TwoSurfaces two({3, 3, 0, 1, 0, 1, true, false}, flat(0), {4, 4, 0.2, 1.3, 0, 1, false, false}, flat(-0.01));
  for (LocalIndex j = 0; j < 3; ++j) {  // a side face at x = 1, down to two nodes that have rows too
    const LocalIndex a = 4 * j + 3, b = a + 4, below = static_cast<LocalIndex>(two.x.size());
    two.x.push_back(two.x[static_cast<std::size_t>(a)] - Vec3(0, 0, 1));
    two.x.push_back(two.x[static_cast<std::size_t>(b)] - Vec3(0, 0, 1));
    two.surfaces.slave.push_back({a, below, below + 1, b});
    two.candidates.close_row();
  }
  Evaluation evaluation(two);
  std::vector<double> z;
  penalty_pressures(evaluation.rows, 50, {}, z);
  for (std::size_t row = 0; row < z.size(); ++row)
    CHECK(z[row] == Approx(evaluation.rows.covered[row] > 0 ? 0.5 : 0).epsilon(1e-12));
}

TEST_CASE("The tangent of a penalty agrees with central differences") {
  for (const bool triangles : {false, true})
    for (const Multiplier multiplier : {Multiplier::dual, Multiplier::standard}) {
      TwoSurfaces two = test::wavy_surfaces(20, triangles, false);
      two.surfaces.multiplier = multiplier;
      const double stiffness = 30;
      Evaluation evaluation(two), moved(two);
      const std::vector<double> base(two.surfaces.rows.size(), 0.05);
      std::vector<double> z;
      std::vector<Vec3> tractions;
      penalty_pressures(evaluation.rows, stiffness, base, z);
      CHECK(std::count(z.begin(), z.end(), 0.0) > 0);
      CHECK(std::count(z.begin(), z.end(), 0.0) < 10);
      normal_tractions(evaluation.rows, z, tractions);
      evaluation.differentiate(two, tractions);
      NodeBlocks<Vec3> gradient;
      TractionSlopes slopes;
      gap_gradient(evaluation.rows, evaluation.slopes, gradient);
      normal_traction_slopes(evaluation.rows, evaluation.slopes, z, slopes);
      std::vector<std::uint8_t> pressed;
      for (const double of_row : z) pressed.push_back(of_row > 0 ? 1 : 0);
      add_penalty_slopes(evaluation.rows, gradient, evaluation.slopes, stiffness, pressed, slopes);
      add_traction_slopes(evaluation.rows, slopes.by_position, evaluation.slopes.weights);
      const auto forces = [&](std::span<const Vec3> x) { return penalty_forces(two, moved, x, stiffness, base); };
      CHECK(test::difference(test::assembled(evaluation.slopes.weights, two.x.size()), two.x, forces) < 1e-8);
    }
}
