// SPDX-License-Identifier: Apache-2.0
// The mesh of linear elements as a dense matrix, whose largest eigenvalue is found by another way.
#pragma once
#include "support/simulation.hpp"

namespace brunt::test {

/// M^-1/2 K M^-1/2 of the mesh on one rank.
inline Eigen::MatrixXd dense_mesh(const Simulation& run, const force::LinearElements& linear) {
  const auto n = static_cast<Eigen::Index>(run.nodes());
  AlignedVector<model::NodeLine> nodes(run.state.nodes.begin(), run.state.nodes.end());
  for (model::NodeLine& node : nodes) node.v_late() = Quad{};
  AlignedVector<Quad> force(nodes.size());
  AlignedVector<double> slots(run.scratch.slots.size());
  Eigen::MatrixXd dense(3 * n, 3 * n);
  for (Eigen::Index column = 0; column < 3 * n; ++column) {
    model::NodeLine& node = nodes[static_cast<std::size_t>(column / 3)];
    node.v[column % 3] = 1 / std::sqrt(node.mass);
    force::linear_forces(run.model, linear, {.nodes = nodes, .force = force, .slots = slots});
    node.v[column % 3] = 0;
    for (Eigen::Index row = 0; row < 3 * n; ++row) {
      const auto i = static_cast<std::size_t>(row / 3);
      dense(row, column) = -force[i][row % 3] / std::sqrt(nodes[i].mass);
    }
  }
  return dense;
}

/// 1/(largest stable step) with damping at the half step before: where dt^2/4 (K + 2/dt C) has the eigenvalue 1. It is
/// sought up to `above`.
inline double exact_rate(const Simulation& run, const force::LinearElements& linear, double above) {
  const auto share = [&](double rate) {  // of the step 1/rate in the stable one
    force::LinearElements springs = linear;
    force::include_damping(springs, 1 / rate);
    const Eigen::MatrixXd dense = dense_mesh(run, springs);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (dense + dense.transpose()),
                                                                Eigen::EigenvaluesOnly);
    return 0.25 * solver.eigenvalues().maxCoeff() / (rate * rate);
  };
  // secant in log rate: the share falls with the rate by a power of it between 1 and 2
  double rate = above;
  for (int k = 0; k < 12; ++k) {
    const double now = share(rate);
    rate *= std::sqrt(now);
    if (std::abs(now - 1) < 1e-7) break;
  }
  return rate;
}

}  // namespace brunt::test
