// SPDX-License-Identifier: Apache-2.0
#include "symmetric_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "comm/rendezvous.hpp"
#include "core/cross_matrix.hpp"

namespace brunt::implicit {
namespace {

/// An entry of the tangent, or of a row of S that its owner has not summed yet. `from`: orders the sum.
struct Entry {
  GlobalIndex row = 0, column = 0, from = 0;
  double value = 0;
};
bool ascends(const Entry& a, const Entry& b) {
  return std::tie(a.row, a.column, a.from) < std::tie(b.row, b.column, b.from);
}

/// The unknowns of the system by their numbers: nodes, multipliers, bodies.
struct Numbers {
  GlobalIndex nodes = 0, bodies = 0;  ///< first unknown behind the nodes; first one of bodies
  [[nodiscard]] bool node(GlobalIndex k) const { return k < nodes; }
  [[nodiscard]] bool body(GlobalIndex k) const { return k >= bodies; }
  [[nodiscard]] bool multiplier(GlobalIndex k) const { return !node(k) && !body(k); }
};

/// Transposed entries of the tangent at the owners of their columns, ascending. Rows of nodes that bodies carry, and
/// columns of multipliers in rows of nodes and bodies, are left out: they repeat T and B^t.
std::vector<Entry> transposed(const comm::Communicator& ranks, const Solver& solver, const Numbers& is) {
  const comm::SparseRows& rows = solver.rows;
  std::vector<Entry> entries;
  std::vector<std::vector<Entry>> to_rank(static_cast<std::size_t>(ranks.size()));
  for (std::size_t r = 0; r < rows.row.size(); ++r) {
    const GlobalIndex row = rows.row[r];
    if (is.node(row) && solver.bodies.carries(r / 3)) continue;
    for (auto k = static_cast<std::size_t>(rows.begin[r]); k < static_cast<std::size_t>(rows.begin[r + 1]); ++k) {
      const GlobalIndex column = rows.column[k];
      if (is.multiplier(column) && !is.multiplier(row)) continue;
      const Rank owner = nth(solver.stability.owner_of, column);
      auto& list = owner == ranks.rank() ? entries : nth(to_rank, owner);
      list.push_back({column, row, 0, rows.value[k]});
    }
  }
  if (ranks.size() > 1) {
    const std::vector<Entry> received = comm::exchange(ranks, to_rank).values;
    entries.insert(entries.end(), received.begin(), received.end());
  }
  std::ranges::sort(entries, ascends);
  return entries;
}

/// Sums of entries as rows; each row ascends.
class Writer {
 public:
  Writer(const std::vector<GlobalIndex>& row, const Numbers& is, SymmetricRows& out) : is_(is), out_(out) {
    out_.rows.row = row;
    out_.rows.begin.assign(1, 0);
    out_.scale.assign(row.size(), 0.0);
  }
  /// S_ij = A_ij + A_ji: halves of what both sides have; B is there once.
  void push(GlobalIndex row, GlobalIndex column, double value) {
    const bool once = row == column || is_.multiplier(row) != is_.multiplier(column);
    out_.rows.column.push_back(column);
    out_.rows.value.push_back(once ? value : 0.5 * value);
  }
  void close() { out_.rows.begin.push_back(static_cast<std::int64_t>(out_.rows.column.size())); }

 private:
  const Numbers& is_;
  SymmetricRows& out_;
};

/// Entries of `count` adjacent rows, column by column.
template <int count, class Take>
void by_column(std::span<const Entry> entries, GlobalIndex first_row, const Take& take) {
  std::array<std::size_t, count> next{}, end{};
  std::size_t at = 0;
  for (std::size_t c = 0; c < count; ++c) {
    next[c] = at;
    while (at < entries.size() && entries[at].row == first_row + static_cast<GlobalIndex>(c)) ++at;
    end[c] = at;
  }
  for (;;) {
    GlobalIndex column = std::numeric_limits<GlobalIndex>::max();
    for (std::size_t c = 0; c < count; ++c)
      if (next[c] < end[c]) column = std::min(column, entries[next[c]].column);
    if (column == std::numeric_limits<GlobalIndex>::max()) return;
    Eigen::Matrix<double, count, 1> value = Eigen::Matrix<double, count, 1>::Zero();
    for (std::size_t c = 0; c < count; ++c)
      for (; next[c] < end[c] && entries[next[c]].column == column; ++next[c])
        value[static_cast<int>(c)] += entries[next[c]].value;
    take(column, value);
  }
}

/// `count` rows of S from their entries: projected, with k (1 - P).
template <int count>
void add_rows(std::span<const Entry> entries, GlobalIndex first, const Eigen::Matrix<double, count, count>& admitted,
              double stiffness, std::size_t place, Writer& writer, SymmetricRows& out) {
  using Square = Eigen::Matrix<double, count, count>;
  const Square held = stiffness * (Square::Identity() - admitted);
  std::vector<std::pair<GlobalIndex, Eigen::Matrix<double, count, 1>>> columns;
  by_column<count>(entries, first, [&](GlobalIndex column, const Eigen::Matrix<double, count, 1>& value) {
    columns.emplace_back(column, admitted * value);
  });
  for (GlobalIndex own = first; own < first + count; ++own) {
    const auto found = std::ranges::lower_bound(columns, own, {}, [](const auto& column) { return column.first; });
    const auto entry = found != columns.end() && found->first == own
                           ? found
                           : columns.insert(found, {own, Eigen::Matrix<double, count, 1>::Zero()});
    entry->second += held.col(static_cast<int>(own - first));
    for (int c = 0; c < count; ++c)
      if (own == first + c) out.scale[place + static_cast<std::size_t>(c)] = std::abs(entry->second[c]);
  }
  for (int c = 0; c < count; ++c) {
    for (const auto& [column, value] : columns) writer.push(first + c, column, value[c]);
    writer.close();
  }
}

/// What the entries of a carried node are in the rows of its body.
void carry(const Solver& solver, std::span<const Entry> entries, std::size_t own, std::vector<Entry>& to_root) {
  const RigidBodies::Place& place = solver.bodies.place[own];
  const auto b = static_cast<std::size_t>(place.body);
  const Mat3 by_arc = 1 / solver.bodies.radius[b] * cross_matrix(solver.bodies.trial[b].turn_now * place.arm);
  const GlobalIndex first = solver.bodies.first + static_cast<GlobalIndex>(body_unknowns * b);
  const GlobalIndex row = solver.unknowns.row[3 * own];
  by_column<3>(entries, row, [&](GlobalIndex column, const Vec3& value) {
    const Vec3 moment = -(by_arc.transpose() * value);
    for (int i = 0; i < 3; ++i) {
      to_root.push_back({first + i, column, row, value[i]});
      to_root.push_back({first + 3 + i, column, row, moment[i]});
    }
  });
}

Mat3 admitted_at(const Scene& scene, const Solver& solver, std::size_t own) {
  if (const WallAction* walls = action_of(solver.walls, own)) return walls->free;
  const LocalIndex held = nth(solver.held, solver.unknowns.node[own]);
  return held == no_index ? Mat3(Mat3::Identity()) : nth(scene.model.supports.nodes, held).free;
}

/// Factor of the entry of a multiplier in its own equation. B is the force of a pressure times Interface::by_gap; with
/// this factor a compliant row is the spring that it is.
double of_own(const Interface& face, std::size_t multiplier) {
  return face.multipliers() == 1 && face.iterate.active[multiplier] != 0 ? face.by_gap(multiplier) : 1.0;
}

/// Multipliers in action on this rank.
GlobalIndex multipliers_in_action(const MortarContact& contact) {
  GlobalIndex count = 0;
  for (const Interface& face : contact.interfaces)
    for (std::size_t row = 0; row < face.count(); ++row)
      count += face.pair.tied            ? std::lround(face.start.tied[row].trace())
               : face.multipliers() == 1 ? GlobalIndex{face.iterate.active[row]}
                                         : GlobalIndex{0};
  return count;
}

}  // namespace

std::vector<Rank> owners_of_unknowns(const comm::Communicator& ranks, const comm::SparseRows& rows) {
  std::vector<std::vector<GlobalIndex>> all(static_cast<std::size_t>(ranks.size()), rows.row);
  const Ragged<GlobalIndex> told = comm::exchange(ranks, all);
  std::vector<Rank> owner_of(told.values.size());
  for (LocalIndex r = 0; r < told.rows(); ++r)
    for (const GlobalIndex row : told.row(r)) nth(owner_of, row) = r;
  return owner_of;
}

SymmetricRows symmetric_rows(const Scene& scene, const Solver& solver) {
  const comm::Communicator& ranks = scene.links.ranks;
  const std::size_t nodes = solver.unknowns.node.size(), bodies = solver.bodies.trial.size();
  const auto all = static_cast<GlobalIndex>(solver.stability.owner_of.size());
  const Numbers is{solver.unknowns.total, all - static_cast<GlobalIndex>(body_unknowns * bodies)};
  const std::vector<Entry> entries = transposed(ranks, solver, is);
  SymmetricRows out;
  Writer writer(solver.rows.row, is, out);
  std::vector<std::vector<Entry>> to_rank(static_cast<std::size_t>(ranks.size()));
  const auto rows_of = [&](GlobalIndex first, GlobalIndex count) {
    const auto begin = std::ranges::lower_bound(entries, first, {}, &Entry::row);
    const auto end = std::ranges::lower_bound(begin, entries.end(), first + count, {}, &Entry::row);
    return std::span<const Entry>(begin, end);
  };
  for (std::size_t own = 0; own < nodes; ++own) {
    const GlobalIndex first = solver.unknowns.row[3 * own];
    if (solver.bodies.carries(own)) carry(solver, rows_of(first, 3), own, to_rank.front());
    const std::span<const Entry> of_node = solver.bodies.carries(own) ? std::span<const Entry>() : rows_of(first, 3);
    const Mat3 admitted = solver.bodies.carries(own) ? Mat3(Mat3::Zero()) : admitted_at(scene, solver, own);
    add_rows<3>(of_node, first, admitted, solver.support_stiffness, 3 * own, writer, out);
  }
  for (const Interface& face : solver.contact.interfaces)
    for (std::size_t k = 0; k < face.count() * static_cast<std::size_t>(face.multipliers()); ++k) {
      const auto width = static_cast<std::size_t>(face.multipliers());
      const GlobalIndex row = face.multiplier(k / width, static_cast<int>(k % width));
      for (const Entry& entry : rows_of(row, 1))
        writer.push(row, entry.column, entry.column == row ? of_own(face, k) * entry.value : entry.value);
      writer.close();
    }
  std::vector<Entry> of_bodies = comm::exchange(ranks, to_rank).values;
  if (solver.bodies.rows_here) {
    const std::span<const Entry> own = rows_of(is.bodies, all - is.bodies);
    of_bodies.insert(of_bodies.end(), own.begin(), own.end());
    std::ranges::sort(of_bodies, ascends);
    for (std::size_t b = 0; b < bodies; ++b) {
      const GlobalIndex first = is.bodies + static_cast<GlobalIndex>(body_unknowns * b);
      const auto begin = std::ranges::lower_bound(of_bodies, first, {}, &Entry::row);
      const auto end = std::ranges::lower_bound(of_bodies, first + GlobalIndex{body_unknowns}, {}, &Entry::row);
      Eigen::Matrix<double, 6, 6> admitted = Eigen::Matrix<double, 6, 6>::Zero();
      admitted.topLeftCorner<3, 3>() = scene.model.bodies[b].support.free_shift;
      admitted.bottomRightCorner<3, 3>() = scene.model.bodies[b].support.free_turn;
      add_rows<6>({begin, end}, first, admitted, solver.support_stiffness,
                  solver.rows.row.size() - body_unknowns * (bodies - b), writer, out);
    }
  }
  out.expected = ranks.sum(multipliers_in_action(solver.contact));
  return out;
}

}  // namespace brunt::implicit
