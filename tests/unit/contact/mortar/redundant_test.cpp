// SPDX-License-Identifier: Apache-2.0
// Equations that others imply are left out, and no others: rank of what is left against that of a dense matrix.
#include "contact/mortar/redundant.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <numeric>
#include <vector>

#include "contact/mortar/tie.hpp"
#include "evaluation.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::Evaluation;
using test::TwoSurfaces;

namespace {

TwoSurfaces sheets(int slave, int master) {
  const auto flat = [](double x, double y) { return Vec3(x, y, 0); };
  return {{slave, slave, 0, 1, 0, 1, true, false}, flat, {master, master, 0, 1, 0, 1, false, false}, flat};
}

Equations equations_of(const TieStart& start, const std::vector<LocalIndex>& slaves, const Mat3& held) {
  Equations equations;
  equations.weights = &start.weights;
  equations.covered = start.covered;
  equations.slaves = slaves;
  equations.held.assign(slaves.size(), held);
  return equations;
}

/// Takes out of Equations::held what the rows before, preferred ones first, imply.
void leave_out_implied(std::vector<Equations>& all, const std::vector<Mat3>& free) {
  std::vector<GlobalIndex> number(free.size());
  std::iota(number.begin(), number.end(), 0);
  const std::vector<std::uint8_t> shared(free.size(), all.size() > 1 ? 1 : 0);
  Echelon echelon;
  for (const bool preferred : {true, false})
    for (Equations& equations : all)
      for (RowLine& of : lines_to_look_at(equations, {number, free, shared}))
        if ((equations.preferred.empty() || equations.preferred[of.row] != 0) == preferred &&
            !echelon.add(std::move(of.line)))
          equations.held[of.row] -= of.direction * of.direction.transpose();
}

/// Rank of the scalar equations along z over the nodes that are free.
Eigen::Index rank_along_z(const Equations& equations, const std::vector<Mat3>& free) {
  Eigen::MatrixXd G =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(equations.held.size()), static_cast<Eigen::Index>(free.size()));
  for (std::size_t row = 0; row < equations.held.size(); ++row) {
    const auto index = static_cast<LocalIndex>(row);
    const auto nodes = equations.weights->nodes.row(index);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      G(index, nodes[k]) +=
          equations.held[row](2, 2) * equations.weights->row(index)[k] * free[static_cast<std::size_t>(nodes[k])](2, 2);
  }
  Eigen::FullPivLU<Eigen::MatrixXd> lu(G);
  lu.setThreshold(1e-8);
  return lu.rank();
}

double kept_along_z(const Equations& equations) {
  double sum = 0;
  for (const Mat3& held : equations.held) sum += held(2, 2);
  return sum;
}

}  // namespace

TEST_CASE("a driven slave keeps as many equations as the master can follow") {
  const TwoSurfaces two = sheets(5, 2);
  const Evaluation evaluation(two);
  const TieStart start = tie_start(two.surfaces, two.candidates, two.x, evaluation.rows);
  std::vector<Mat3> free(two.x.size(), Mat3::Identity());
  for (std::size_t node = 0; node < 36; ++node) free[node].setZero();
  const Mat3 along_z = Vec3(0, 0, 1).asDiagonal();
  std::vector<Equations> all{equations_of(start, two.surfaces.rows, along_z)};
  const Eigen::Index rank = rank_along_z(all[0], free);
  CHECK(rank == 9);
  leave_out_implied(all, free);
  CHECK(kept_along_z(all[0]) == Approx(static_cast<double>(rank)));
  CHECK(rank_along_z(all[0], free) == rank);
}

TEST_CASE("nothing is left out where the slave is free") {
  const TwoSurfaces two = sheets(5, 2);
  const Evaluation evaluation(two);
  const TieStart start = tie_start(two.surfaces, two.candidates, two.x, evaluation.rows);
  const std::vector<Mat3> free(two.x.size(), Mat3::Identity());
  std::vector<Equations> all{equations_of(start, two.surfaces.rows, Mat3::Identity())};
  leave_out_implied(all, free);
  for (const Mat3& held : all[0].held) CHECK(held.isIdentity(0));
}

TEST_CASE("the same equations twice over shared nodes are kept once, preferred ones first") {
  const TwoSurfaces two = sheets(3, 2);
  const Evaluation evaluation(two);
  const TieStart start = tie_start(two.surfaces, two.candidates, two.x, evaluation.rows);
  const std::vector<Mat3> free(two.x.size(), Mat3::Identity());
  const Mat3 along_z = Vec3(0, 0, 1).asDiagonal();
  std::vector<Equations> all(2, equations_of(start, two.surfaces.rows, along_z));
  leave_out_implied(all, free);
  CHECK(kept_along_z(all[0]) == Approx(16));
  CHECK(kept_along_z(all[1]) == Approx(0).margin(1e-12));
  all = {2, equations_of(start, two.surfaces.rows, along_z)};
  all[0].preferred.assign(16, 0);
  all[1].preferred.assign(16, 1);
  leave_out_implied(all, free);
  CHECK(kept_along_z(all[0]) == Approx(0).margin(1e-12));
  CHECK(kept_along_z(all[1]) == Approx(16));
}

TEST_CASE("an equation of which no node can move is left out, an oblique one of a node that slides is kept") {
  const TwoSurfaces two = sheets(2, 2);
  const Evaluation evaluation(two);
  const TieStart start = tie_start(two.surfaces, two.candidates, two.x, evaluation.rows);
  std::vector<Mat3> free(two.x.size(), Vec3(1, 1, 0).asDiagonal());  // all stand on a floor
  const Vec3 oblique = Vec3(1, 0, 1).normalized();
  std::vector<Equations> all{equations_of(start, two.surfaces.rows, oblique * oblique.transpose())};
  leave_out_implied(all, free);
  for (const Mat3& held : all[0].held) CHECK(held.trace() == Approx(1));
  all = {equations_of(start, two.surfaces.rows, Vec3(0, 0, 1).asDiagonal())};
  leave_out_implied(all, free);
  for (const Mat3& held : all[0].held) CHECK(held.isZero());
}
