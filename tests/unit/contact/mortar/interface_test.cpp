// SPDX-License-Identifier: Apache-2.0
// Rows of two surfaces: sums, gaps at rims, and all derivatives against central differences.
#include "contact/mortar/interface.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "contact/mortar/forces.hpp"
#include "contact/mortar/tractions.hpp"
#include "evaluation.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::Evaluation;
using test::TwoSurfaces;

namespace {

std::vector<Vec3> forces_at(const TwoSurfaces& two, Evaluation& evaluation, std::span<const Vec3> x,
                            std::span<const double> z) {
  evaluation.move(two, x);
  std::vector<Vec3> tractions, forces(x.size(), Vec3::Zero());
  normal_tractions(evaluation.rows, z, tractions);
  add_forces(evaluation.rows, tractions, forces);
  return forces;
}

double weight_at(const MortarRows& rows, LocalIndex row, LocalIndex node) {
  const auto nodes = rows.weights.nodes.row(row);
  const auto at = std::find(nodes.begin(), nodes.end(), node);
  return at == nodes.end() ? 0 : rows.weights.row(row)[static_cast<std::size_t>(at - nodes.begin())];
}

}  // namespace

TEST_CASE("Weights of a row have sum zero, so that forces have none") {
  for (const Multiplier multiplier : {Multiplier::dual, Multiplier::standard}) {
    TwoSurfaces two = test::wavy_surfaces(1);
    two.surfaces.multiplier = multiplier;
    Evaluation evaluation(two);
    CHECK(evaluation.rows.segments > 12);
    for (LocalIndex row = 0; row < evaluation.rows.weights.nodes.rows(); ++row) {
      double sum = 0;
      for (const double weight : evaluation.rows.weights.row(row)) sum += weight;
      CHECK(std::abs(sum) < 1e-15);
    }
    const auto z = test::some_pressures(two.surfaces.rows.size());
    Vec3 total = Vec3::Zero();
    double size = 0;
    for (const Vec3& force : forces_at(two, evaluation, two.x, z)) {
      total += force;
      size += force.norm();
    }
    CHECK(size > 0.5);
    CHECK(total.norm() < 1e-15 * size);
  }
}

TEST_CASE("Facets at sharp edges have standard multipliers") {
  TwoSurfaces two = test::wavy_surfaces(1);
  const Evaluation dual(two);
  two.surfaces.at_edge.assign(two.surfaces.slave.size(), 1);
  const Evaluation all(two);
  two.surfaces.at_edge.assign(two.surfaces.slave.size(), 0);
  const Evaluation none(two);
  two.surfaces.at_edge.clear();
  two.surfaces.multiplier = Multiplier::standard;
  const Evaluation standard(two);
  CHECK(all.rows.gaps == standard.rows.gaps);
  CHECK(none.rows.gaps == dual.rows.gaps);
  CHECK(dual.rows.gaps != standard.rows.gaps);
}

TEST_CASE("A pressure pushes the slave away from the master") {
  const auto flat = [](double height) { return [height](double x, double y) { return Vec3(x, y, height); }; };
  TwoSurfaces two({3, 3, 0, 1, 0, 1, true, false}, flat(0), {4, 4, 0, 1, 0, 1, false, false}, flat(0.01));
  Evaluation evaluation(two);
  const std::vector<double> z(16, 2.0);
  Vec3 on_slave = Vec3::Zero(), on_master = Vec3::Zero();
  const auto forces = forces_at(two, evaluation, two.x, z);
  for (std::size_t node = 0; node < two.x.size(); ++node) (node < 16 ? on_slave : on_master) += forces[node];
  CHECK((on_slave - Vec3(0, 0, -2)).norm() < 1e-14);
  CHECK((on_master - Vec3(0, 0, 2)).norm() < 1e-14);
  for (std::size_t row = 0; row < 16; ++row) {
    CHECK((evaluation.rows.normals[row] - Vec3(0, 0, -1)).norm() < 1e-15);
    CHECK(evaluation.topology.kappa[row] * evaluation.rows.gaps[row] == Approx(0.01).epsilon(1e-12));
  }
}

TEST_CASE("At rims a uniform gap gives every covered node that gap") {
  for (const bool triangles : {false, true})
    for (const double overhang : {0.37, 0.0, 1e-3, 0.999, 1.5, 2.37}) {
      const double gap = 0.01, facet = 0.25;
      const auto flat = [](double height) { return [height](double x, double y) { return Vec3(x, y, height); }; };
      TwoSurfaces two({4, 2, overhang * facet, 1 + overhang * facet, 0, 0.5, true, triangles}, flat(0),
                      {3, 3, 0, 1, -0.2, 0.7, false, triangles}, flat(gap));
      Evaluation evaluation(two);
      int covered = 0;
      for (std::size_t row = 0; row < two.surfaces.rows.size(); ++row) {
        const double share = evaluation.rows.covered[row];
        if (share == 0) {
          CHECK(evaluation.rows.gaps[row] == 0);
          continue;
        }
        ++covered;
        CHECK(std::abs(evaluation.rows.gaps[row] / share - gap) < 1e-12);
      }
      CHECK(covered == 3 * (5 - static_cast<int>(overhang)));
      // The last row of nodes that is covered carries the moment of its hat: (1 - t)^2 / 2 of a facet's length.
      const double t = overhang - std::floor(overhang);
      if (triangles || t == 0) continue;
      const auto last = static_cast<std::size_t>(4 - static_cast<int>(overhang));
      const double sum =
          evaluation.rows.covered[last] + evaluation.rows.covered[5 + last] + evaluation.rows.covered[10 + last];
      CHECK(sum == Approx(0.5 * facet * (1 - t) * (1 - t) / 2).epsilon(1e-12));
    }
}

TEST_CASE("Surfaces that come nearest at a rim have open gaps") {
  // One facet under a master that ends over it and rises from there: the line through its gaps crosses zero beyond the
  // rim, where nothing is.
  for (const double rim : {0.02, 0.3, 0.45, 0.6}) {
    const TwoSurfaces two(
        {1, 1, 0, 1, 0, 1, true, false}, [](double x, double y) { return Vec3(x, y, 0); },
        {1, 1, -1, rim, -1, 2, false, false}, [rim](double x, double y) { return Vec3(x, y, 0.01 + 0.2 * (rim - x)); });
    Evaluation evaluation(two);
    for (std::size_t row = 0; row < 4; ++row) CHECK(evaluation.rows.gaps[row] > 0.01 * evaluation.rows.covered[row]);
  }
}

TEST_CASE("Dual weights over the slave's nodes are diagonal") {
  // a master that covers all of a wavy slave
  const auto wave = [](double height) {
    return [height](double x, double y) { return Vec3(x, y, height + 0.05 * std::sin(3 * x) * std::cos(2 * y)); };
  };
  const TwoSurfaces two({3, 2, 0, 1, 0, 1, true, false}, wave(0), {3, 4, -0.3, 1.3, -0.3, 1.3, false, false},
                        wave(0.02));
  Evaluation evaluation(two);
  for (LocalIndex row = 0; row < 12; ++row)
    for (LocalIndex node = 0; node < 12; ++node)
      CHECK(weight_at(evaluation.rows, row, node) ==
            (node == row ? evaluation.rows.covered[static_cast<std::size_t>(row)] : 0));
}

TEST_CASE("Far from the origin the gaps keep their digits") {
  TwoSurfaces two = test::wavy_surfaces(3);
  Evaluation here(two);
  std::vector<Vec3> x = two.x;
  for (Vec3& of_node : x) of_node += Vec3(100, -100, 100);
  Evaluation there(two);
  there.move(two, x);
  for (std::size_t row = 0; row < two.surfaces.rows.size(); ++row)
    CHECK(std::abs(here.rows.gaps[row] - there.rows.gaps[row]) < 1e-13);
}

TEST_CASE("The force tangent at fixed pressures and the gap gradient agree with central differences") {
  for (const Multiplier multiplier : {Multiplier::dual, Multiplier::standard})
    for (int kind = 0; kind < 4; ++kind) {
      TwoSurfaces two = test::wavy_surfaces(10 + static_cast<unsigned>(kind), kind % 2 == 1, kind / 2 == 1);
      two.surfaces.multiplier = multiplier;
      for (std::size_t row = 0; row < two.surfaces.rows.size(); ++row) {  // four nodes lie in a symmetry plane
        if (row < 4) two.surfaces.mirrors.values.emplace_back(0.6, 0.8, 0);
        two.surfaces.mirrors.close_row();
      }
      const auto z = test::some_pressures(two.surfaces.rows.size());
      Evaluation evaluation(two), moved(two);
      std::vector<Vec3> tractions;
      normal_tractions(evaluation.rows, z, tractions);
      evaluation.differentiate(two, tractions);
      TractionSlopes traction_slopes;
      normal_traction_slopes(evaluation.rows, evaluation.slopes, z, traction_slopes);
      add_traction_slopes(evaluation.rows, traction_slopes.by_position, evaluation.slopes.weights);
      NodeBlocks<Vec3> gradient;
      gap_gradient(evaluation.rows, evaluation.slopes, gradient);
      std::vector<Vec3> fixed = two.x;  // places of another time
      for (std::size_t node = 0; node < fixed.size(); ++node)
        fixed[node] += 0.02 * Vec3(std::sin(3.0 * static_cast<double>(node)), 0.5, -1);
      MortarSlopes with_fixed;
      mortar_rows_and_slopes(two.surfaces, evaluation.topology, two.candidates, two.x, tractions, *evaluation.scratch,
                             evaluation.rows, with_fixed, fixed);
      NodeBlocks<Vec3> of_fixed;
      gaps_at_gradient(evaluation.rows, with_fixed, fixed, of_fixed);
      const auto fixed_gaps = [&](std::span<const Vec3> x) {
        moved.move(two, x);
        std::vector<double> of_rows;
        gaps_at(moved.rows, fixed, of_rows);
        return of_rows;
      };
      CHECK(test::difference(test::assembled(of_fixed, two.x.size()), two.x, fixed_gaps) < 1e-8);
      const auto covered = [&](std::span<const Vec3> x) {
        moved.move(two, x);
        return moved.rows.covered;
      };
      CHECK(test::difference(test::assembled(with_fixed.covered, two.x.size()), two.x, covered) < 1e-8);
      const auto forces = [&](std::span<const Vec3> x) { return test::flat(forces_at(two, moved, x, z)); };
      const auto gaps = [&](std::span<const Vec3> x) {
        moved.move(two, x);
        return moved.rows.gaps;
      };
      CAPTURE(kind);
      CHECK(test::difference(test::assembled(evaluation.slopes.weights, two.x.size()), two.x, forces) < 1e-8);
      CHECK(test::difference(test::assembled(gradient, two.x.size()), two.x, gaps) < 1e-8);
    }
}

TEST_CASE("A uniform pressure puts on either side the forces that it has there alone") {
  // What a patch test asks of an interface. On general quadrilaterals the rule has an error; the bound is that of M2 in
  // reference-mortar.md, relative to the force of an inner node. On parallelograms there is none.
  for (const Multiplier multiplier : {Multiplier::dual, Multiplier::standard})
    for (const double shift : {0.0, 0.2})
      for (const auto& [n, m] : {std::pair{3, 4}, std::pair{2, 3}, std::pair{4, 7}}) {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> number(-shift, shift);
        const auto place = [&](int cells) {
          return [&, cells](double x, double y) -> Vec3 {
            const auto inner = [&](double a) { return a > 1e-9 && a < 1 - 1e-9; };
            if (!inner(x) || !inner(y)) return {x, y, 0};
            return {x + number(random) / cells, y + number(random) / cells, 0};
          };
        };
        TwoSurfaces two({n, n, 0, 1, 0, 1, true, false}, place(n), {m, m, 0, 1, 0, 1, false, false}, place(m));
        two.surfaces.multiplier = multiplier;
        TwoSurfaces other = two;  // the master as a slave, for int N_C over each of its nodes
        std::swap(other.surfaces.slave, other.surfaces.master);
        const auto slaves = static_cast<std::size_t>((n + 1) * (n + 1));
        other.surfaces.rows.clear();
        for (std::size_t node = slaves; node < two.x.size(); ++node)
          other.surfaces.rows.push_back(static_cast<LocalIndex>(node));
        const MortarTopology alone = make_topology(other.surfaces, two.x);
        Evaluation evaluation(two);
        const auto forces = forces_at(two, evaluation, two.x, std::vector<double>(slaves, 1));
        double worst = 0;
        for (std::size_t node = 0; node < slaves; ++node)
          worst = std::max(worst, std::abs(forces[node][2] + 1 / evaluation.topology.kappa[node]));
        CHECK(worst * n * n < (shift == 0 ? 1e-13 : 2e-6));
        worst = 0;
        for (std::size_t node = slaves; node < two.x.size(); ++node)
          worst = std::max(worst, std::abs(forces[node][2] - 1 / alone.kappa[node - slaves]));
        CHECK(worst * m * m < (shift == 0 ? 1e-13 : 2e-6));
      }
}

TEST_CASE("Conforming surfaces, coincident up to rounding and noise, have bounded slopes") {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const double noise : {0.0, 1e-16, 1e-14, 1e-12, 1e-10, 1e-8}) {
    const auto flat = [&](double x, double y) -> Vec3 {
      return Vec3(x, y, 0) + noise * Vec3(number(random), number(random), number(random));
    };
    for (const bool triangles : {false, true}) {
      const TwoSurfaces two({3, 3, 0, 1, 0, 1, true, triangles}, flat, {3, 3, 0, 1, 0, 1, false, triangles}, flat);
      Evaluation evaluation(two);
      const std::vector<Vec3> tractions(16, Vec3(0.1, 0, -1));
      evaluation.differentiate(two, tractions);
      CHECK(evaluation.rows.segments >= (triangles ? 18 : 9));
      for (std::size_t row = 0; row < 16; ++row) {
        CHECK(evaluation.rows.covered[row] * evaluation.topology.kappa[row] == Approx(1).epsilon(1e-12 + 100 * noise));
        CHECK(std::abs(evaluation.topology.kappa[row] * evaluation.rows.gaps[row]) <= 10 * noise);
      }
      for (const double entry : test::assembled(evaluation.slopes.weights, two.x.size())) CHECK(std::abs(entry) < 1);
    }
  }
}
