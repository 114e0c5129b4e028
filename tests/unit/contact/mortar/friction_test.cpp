// SPDX-License-Identifier: Apache-2.0
// Slip of known motions; tangents of sticking and slipping rows against central differences.
#include "contact/mortar/friction.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "contact/mortar/forces.hpp"
#include "evaluation.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::Evaluation;
using test::TwoSurfaces;

namespace {

TwoSurfaces flat_surfaces() {
  const auto flat = [](double height) { return [height](double x, double y) { return Vec3(x, y, height); }; };
  return {{3, 3, 0, 1, 0, 1, true, false}, flat(0), {4, 5, -1, 2, -1, 2, false, false}, flat(0)};
}

FrictionHistory without_traction(const MortarRows& rows) {
  FrictionHistory history;
  keep_friction(rows, std::vector<Vec3>(rows.gaps.size(), Vec3::Zero()), history);
  return history;
}

}  // namespace

TEST_CASE("A rigid motion of both bodies is no slip; a shift of the slave is") {
  TwoSurfaces two = flat_surfaces();
  Evaluation evaluation(two);
  const FrictionHistory history = without_traction(evaluation.rows);
  std::vector<Vec3> x = two.x, slip;
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vec3& of_node : x) of_node = turn * of_node + Vec3(5, -3, 2);
  evaluation.move(two, x);
  slips(evaluation.rows, x, history, slip);
  for (const Vec3& of_row : slip) CHECK(of_row.norm() < 1e-14);

  x = two.x;
  const Vec3 shift(0.02, -0.01, 0);
  for (std::size_t node = 0; node < 16; ++node) x[node] += shift;
  evaluation.move(two, x);
  slips(evaluation.rows, x, history, slip);
  for (const Vec3& of_row : slip) CHECK((of_row - shift).norm() < 1e-13);
}

TEST_CASE("A node at a rim slips as far as one within") {
  const auto flat = [](double height) { return [height](double x, double y) { return Vec3(x, y, height); }; };
  TwoSurfaces two({3, 3, 0, 1, 0, 1, true, false}, flat(0), {4, 5, -1, 0.8, -1, 2, false, false}, flat(0));
  Evaluation evaluation(two);
  const FrictionHistory history = without_traction(evaluation.rows);
  const Vec3 shift(0.02, -0.01, 0);
  std::vector<Vec3> x = two.x, slip;
  for (std::size_t node = 0; node < 16; ++node) x[node] += shift;
  evaluation.move(two, x);
  slips(evaluation.rows, x, history, slip);
  for (std::size_t row = 0; row < 16; ++row) {
    CHECK(evaluation.rows.covered[row] > 0);
    CHECK((slip[row] - shift).norm() < 1e-13);
  }
}

TEST_CASE("Friction opposes the slip: in proportion where it sticks, by Coulomb's law where it slips") {
  TwoSurfaces two = flat_surfaces();
  Evaluation evaluation(two);
  const FrictionHistory history = without_traction(evaluation.rows);
  std::vector<Vec3> x = two.x, tractions;
  std::vector<FrictionState> states;
  const Vec3 shift(0.02, 0, 0);
  for (std::size_t node = 0; node < 16; ++node) x[node] += shift;
  evaluation.move(two, x);
  std::vector<double> z(16, 2);
  z[3] = 0;
  friction_tractions(evaluation.rows, x, z, {0.5, 10}, history, tractions, states);
  CHECK(states[3] == FrictionState::open);
  CHECK(tractions[3].norm() == 0);
  CHECK(states[0] == FrictionState::stick);
  CHECK((tractions[0] - Vec3(-0.2, 0, -2)).norm() < 1e-12);
  friction_tractions(evaluation.rows, x, z, {0.5, 100}, history, tractions, states);
  CHECK(states[0] == FrictionState::slip);
  CHECK((tractions[0] - Vec3(-1, 0, -2)).norm() < 1e-12);
}

TEST_CASE("The traction of the last step turns with the normal") {
  TwoSurfaces two = flat_surfaces();
  Evaluation evaluation(two);
  FrictionHistory history;
  keep_friction(evaluation.rows, std::vector<Vec3>(16, Vec3(0.3, 0.1, -2)), history);
  CHECK((history.tractions[0] - Vec3(0.3, 0.1, 0)).norm() < 1e-15);
  std::vector<Vec3> x = two.x, tractions;
  const Mat3 turn = Eigen::AngleAxisd(0.4, Vec3(0, 1, 0)).toRotationMatrix();
  for (Vec3& of_node : x) of_node = turn * of_node;
  evaluation.move(two, x);
  std::vector<FrictionState> states;
  const std::vector<double> z(16, 2);
  friction_tractions(evaluation.rows, x, z, {0.5, 10}, history, tractions, states);
  for (const Vec3& of_row : tractions) CHECK((of_row - turn * Vec3(0.3, 0.1, -2)).norm() < 1e-12);
}

TEST_CASE("Tangents of stick and slip, by positions and by pressures, agree with central differences") {
  for (const bool triangles : {false, true})
    for (const Multiplier multiplier : {Multiplier::dual, Multiplier::standard}) {
      TwoSurfaces two = test::wavy_surfaces(30, triangles, triangles);
      two.surfaces.multiplier = multiplier;
      Evaluation evaluation(two), moved(two);
      const std::size_t rows = two.surfaces.rows.size();
      std::mt19937 random(4);
      std::uniform_real_distribution<double> number(-1, 1);
      std::vector<Vec3> old_tractions;
      for (std::size_t row = 0; row < rows; ++row)
        old_tractions.emplace_back(0.5 * number(random), 0.5 * number(random), 0);
      FrictionHistory history;
      keep_friction(evaluation.rows, old_tractions, history);
      for (Vec3& x : two.x) x += 0.01 * Vec3(number(random), number(random), number(random));
      evaluation.move(two, two.x);
      const std::vector<double> z = test::some_pressures(rows);
      const MortarFriction law{0.8, 5};
      std::vector<Vec3> tractions;
      std::vector<FrictionState> states;
      friction_tractions(evaluation.rows, two.x, z, law, history, tractions, states);
      CHECK(std::count(states.begin(), states.end(), FrictionState::stick) > 1);
      CHECK(std::count(states.begin(), states.end(), FrictionState::slip) > 1);
      evaluation.differentiate(two, tractions);
      TractionSlopes slopes;
      friction_traction_slopes(evaluation.rows, evaluation.slopes, two.x, z, law, history, slopes);
      add_traction_slopes(evaluation.rows, slopes.by_position, evaluation.slopes.weights);
      const auto forces_at = [&](std::span<const Vec3> x, std::span<const double> pressures) {
        moved.move(two, x);
        std::vector<Vec3> of_rows, forces(x.size(), Vec3::Zero());
        std::vector<FrictionState> now;
        friction_tractions(moved.rows, x, pressures, law, history, of_rows, now);
        add_forces(moved.rows, of_rows, forces);
        return test::flat(forces);
      };
      const auto forces = [&](std::span<const Vec3> x) { return forces_at(x, z); };
      CHECK(test::difference(test::assembled(evaluation.slopes.weights, two.x.size()), two.x, forces) < 1e-8);

      NodeBlocks<Vec3> columns;
      pressure_columns(evaluation.rows, slopes.by_pressure, columns);
      const std::vector<double> column = test::assembled(columns, two.x.size());
      double worst = 0;
      for (std::size_t row = 0; row < rows; ++row) {
        if (z[row] == 0) continue;
        std::vector<double> more = z, less = z;
        more[row] += 1e-6;
        less[row] -= 1e-6;
        const auto plus = forces_at(two.x, more), minus = forces_at(two.x, less);
        for (std::size_t k = 0; k < plus.size(); ++k)
          worst = std::max(worst, std::abs((plus[k] - minus[k]) / 2e-6 - column[row * plus.size() + k]));
      }
      CHECK(worst < 1e-8 * 0.1);  // columns are weights of about 0.1
    }
}
