// SPDX-License-Identifier: Apache-2.0
#include "brunt/implicit/balance.hpp"

namespace brunt::implicit {
namespace {

/// The pattern of the system's rows, from blocks to single rows.
void lay_rows(const Unknowns& unknowns, const NodeRows& nodes, comm::SparseRows& rows) {
  rows.row = unknowns.row;
  rows.begin.assign(1, 0);
  rows.column.clear();
  for (std::size_t r = 0; r < unknowns.node.size(); ++r)
    for (int i = 0; i < 3; ++i) {
      for (std::int64_t k = nodes.begin[r]; k < nodes.begin[r + 1]; ++k)
        for (int j = 0; j < 3; ++j) rows.column.push_back(3 * nodes.column[static_cast<std::size_t>(k)] + j);
      rows.begin.push_back(static_cast<std::int64_t>(rows.column.size()));
    }
  rows.value.resize(rows.column.size());
}

}  // namespace

comm::Factorised factorise_tangent(const Scene& scene, Solver& solver) {
  const Rule& rule = solver.trial.rule;
  const force::Motion motion{scene.state.nodes, rule.dt, false};
  solver.stiffness.assemble(scene.model, scene.state, motion, scene.state.history);
  const NodeRows& nodes = solver.stiffness.rows();
  if (solver.rows.row.empty()) lay_rows(solver.unknowns, nodes, solver.rows);
  for (std::size_t r = 0; r < solver.unknowns.node.size(); ++r) {
    const auto i = static_cast<std::size_t>(solver.unknowns.node[r]);
    const LocalIndex held = solver.held[i];
    const std::int64_t count = nodes.begin[r + 1] - nodes.begin[r];
    const Mat3 free =
        held == no_index ? Mat3(Mat3::Identity()) : scene.model.constrained[static_cast<std::size_t>(held)].free;
    for (std::int64_t k = 0; k < count; ++k) {
      const std::int64_t place = nodes.begin[r] + k;
      Mat3 block =
          rule.now * Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(nodes.value.data() + 9 * place);
      const bool own = place == nodes.diagonal[r];
      if (own) block += rule.mass * scene.state.nodes[i].mass * Mat3::Identity();
      if (held != no_index) block = free * block;
      if (held != no_index && own) block += solver.support_stiffness * (Mat3::Identity() - free);
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
          solver.rows.value[static_cast<std::size_t>(solver.rows.begin[3 * r + static_cast<std::size_t>(row)] + 3 * k +
                                                     column)] = block(row, column);
    }
  }
  return solver.system.factorise(solver.rows);
}

}  // namespace brunt::implicit
