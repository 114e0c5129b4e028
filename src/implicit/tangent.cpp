// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "implicit/balance.hpp"
#include "implicit/data/measure.hpp"

namespace brunt::implicit {
namespace {

/// A sparse row that is assembled column by column, columns ascending.
class Rows {
 public:
  explicit Rows(const std::vector<GlobalIndex>& row, comm::SparseRows& rows) : rows_(rows) {
    rows_.row = row;
    rows_.begin.assign(1, 0);
    rows_.column.clear();
    rows_.value.clear();
  }
  void push(GlobalIndex column, double value) {
    rows_.column.push_back(column);
    rows_.value.push_back(value);
  }
  void close() { rows_.begin.push_back(static_cast<std::int64_t>(rows_.column.size())); }

 private:
  comm::SparseRows& rows_;
};

/// Terms of contact row by row, those of one entry summed in their order.
class ContactRows {
 public:
  explicit ContactRows(const std::vector<ContactTerm>& terms) : terms_(terms) {}
  /// The next column of this row and its sum; false if there is none before `until`.
  bool next(GlobalIndex row, GlobalIndex until, GlobalIndex& column, double& value) {
    if (at_ == terms_.size() || terms_[at_].row != row || terms_[at_].column >= until) return false;
    column = terms_[at_].column;
    for (value = 0; at_ < terms_.size() && terms_[at_].row == row && terms_[at_].column == column; ++at_)
      value += terms_[at_].value;
    return true;
  }

 private:
  const std::vector<ContactTerm>& terms_;
  std::size_t at_ = 0;
};

/// Factor of a node's rows at walls: without the directions in which friction follows their pressure if it is given.
const Mat3& rows_of(const WallAction& action, FrictionLimit limit) {
  return limit == FrictionLimit::follows ? action.rows : action.free;
}

/// The directions constrained by walls are removed from contact's rows as well.
void take_walls_out(const WallContact& walls, FrictionLimit limit, ContactNodes& nodes) {
  for (std::size_t k = 0; k < nodes.own.size(); ++k) {
    if (nodes.own[k] == no_index) continue;
    const WallAction* action = action_of(walls, static_cast<std::size_t>(nodes.own[k]));
    nodes.rows[k] = action == nullptr ? nodes.free[k] : Mat3(rows_of(*action, limit) * nodes.free[k]);
  }
}

/// Three rows of one node from its blocks, of bodies and inertia, without the directions of supports and walls.
std::vector<Mat3> blocks_of(const Scene& scene, const Solver& solver, FrictionLimit limit, std::size_t r) {
  const NodeRows& nodes = solver.stiffness.rows();
  const Rule& rule = solver.trial.rule;
  const auto i = static_cast<std::size_t>(solver.unknowns.node[r]);
  Mat3 taken = Mat3::Identity(), put_in = Mat3::Zero();
  if (const LocalIndex held = solver.held[i]; held != no_index) {
    taken = nth(scene.model.supports.nodes, held).free;
    put_in = solver.support_stiffness * (Mat3::Identity() - taken);
  }
  if (const WallAction* walls = action_of(solver.walls, r)) {
    taken = rows_of(*walls, limit) * taken;
    put_in += walls->own;
  }
  const bool whole = taken == Mat3::Identity();
  std::vector<Mat3> blocks;
  for (std::int64_t place = nodes.begin[r]; place < nodes.begin[r + 1]; ++place) {
    Mat3 block =
        rule.now * Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(nodes.value.data() + 9 * place);
    const bool own = place == nodes.diagonal[r];
    if (own) block += rule.mass * scene.state.nodes[i].mass * Mat3::Identity();
    if (!whole) block = taken * block;
    if (own && !whole) block += put_in;
    blocks.push_back(block);
  }
  return blocks;
}

/// The whole system: nodes, contact, rigid bodies.
void lay_system(const Scene& scene, Solver& solver, FrictionLimit limit, const std::vector<ContactTerm>& terms) {
  const NodeRows& nodes = solver.stiffness.rows();
  std::vector<GlobalIndex> all = solver.unknowns.row;
  all.insert(all.end(), solver.contact.own_rows.begin(), solver.contact.own_rows.end());
  const std::vector<GlobalIndex> of_bodies = solver.bodies.own_rows();
  all.insert(all.end(), of_bodies.begin(), of_bodies.end());
  Rows rows(all, solver.rows);
  ContactRows contact(terms);
  constexpr GlobalIndex end = std::numeric_limits<GlobalIndex>::max();
  GlobalIndex column = 0;
  double value = 0;
  for (std::size_t r = 0; r < solver.unknowns.node.size(); ++r) {
    const bool carried = solver.bodies.carries(r);
    const std::vector<Mat3> blocks = carried ? std::vector<Mat3>() : blocks_of(scene, solver, limit, r);
    for (int i = 0; i < 3; ++i) {
      const GlobalIndex row = solver.unknowns.row[3 * r + static_cast<std::size_t>(i)];
      for (std::size_t k = 0; k < blocks.size(); ++k)
        for (int j = 0; j < 3; ++j) {
          const GlobalIndex own = 3 * nodes.column[static_cast<std::size_t>(nodes.begin[r]) + k] + j;
          while (contact.next(row, own, column, value)) rows.push(column, value);
          const double sum = contact.next(row, own + 1, column, value) ? value : 0.0;
          rows.push(own, blocks[k](i, j) + sum);
        }
      while (contact.next(row, end, column, value)) rows.push(column, value);
      rows.close();
    }
  }
  for (const GlobalIndex row : std::span(all).subspan(solver.unknowns.row.size())) {
    while (contact.next(row, end, column, value)) rows.push(column, value);
    rows.close();
  }
}

}  // namespace

void assemble_tangent(const Scene& scene, Solver& solver, FrictionLimit limit) {
  std::vector<ContactTerm> terms;
  {
    const Measure timed(solver.work.contact_seconds);
    if (solver.walls.any()) take_walls_out(solver.walls, limit, solver.contact.nodes);
    contact_terms(scene.links.ranks, solver.contact, limit, terms);
  }
  const Measure timed(solver.work.tangent_seconds);
  const force::Motion motion{scene.state.nodes, solver.trial.rule.dt, false};
  solver.stiffness.assemble(scene.model, scene.state, motion, scene.state.history);
  if (solver.bodies.any()) body_terms(scene, solver, limit, terms);
  lay_system(scene, solver, limit, terms);
}

comm::Factorised factorise_tangent(const Scene& scene, Solver& solver) {
  assemble_tangent(scene, solver, FrictionLimit::follows);
  remember_choice(solver.walls);
  const Measure timed(solver.work.factorise_seconds);
  return solver.system.factorise(solver.rows);
}

}  // namespace brunt::implicit
