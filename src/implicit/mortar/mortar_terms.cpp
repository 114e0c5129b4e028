// SPDX-License-Identifier: Apache-2.0
// The contribution of mortar contact to the matrix of the system.
#include <algorithm>
#include <array>

#include "comm/rendezvous.hpp"
#include "contact/mortar/forces.hpp"
#include "contact/mortar/levers.hpp"
#include "contact/mortar/tractions.hpp"
#include "implicit/data/nodal.hpp"
#include "implicit/mortar/mortar.hpp"
#include "interface_rows.hpp"
#include "mortar_pieces.hpp"

namespace brunt::implicit {
namespace {

/// A column of a multiplier in the rows of a node.
struct ColumnTold {
  GlobalIndex node = 0, multiplier = 0;
  std::array<double, 3> slope{};
};

/// Adds terms to this rank's rows, projected onto directions free of supports; stores those of other ranks' rows.
class Terms {
 public:
  Terms(const comm::Communicator& ranks, MortarContact& contact) : ranks_(ranks), contact_(contact) {
    contact_.sums.resize(contact.nodes.lasting);
    for (BlockRow& row : contact_.sums) row.clear();
    columns_to_.resize(static_cast<std::size_t>(ranks.size()));
  }

  /// - dF_row/dx_column: residuals contain the forces with a minus. row: a place of a node that this rank owns.
  void node_node(LocalIndex row, GlobalIndex column, const Mat3& slope) {
    nth(contact_.sums, row).add(column, -(taken(row) * slope));
  }
  void node_multiplier(LocalIndex row, GlobalIndex multiplier, const Vec3& slope) {
    const Rank owner = nth(contact_.nodes.source, row).rank;
    if (owner == ranks_.rank())
      add_column(row, multiplier, slope);
    else
      nth(columns_to_, owner).push_back({gid(row), multiplier, {slope[0], slope[1], slope[2]}});
  }
  void multiplier_node(GlobalIndex multiplier, LocalIndex column, const Vec3& slope) {
    for (int j = 0; j < 3; ++j) add(multiplier, 3 * gid(column) + j, slope[j]);
  }
  void multiplier_multiplier(GlobalIndex row, GlobalIndex column, double slope) { add(row, column, slope); }

  /// All terms, by row and column; with multipliers, terms of one entry in the order of their computation. Collective.
  void write(std::vector<ContactTerm>& terms) {
    for (const ColumnTold& column : comm::exchange(ranks_, columns_to_).values)
      add_column(contact_.nodes.place_of(column.node), column.multiplier, Vec3(column.slope.data()));
    terms.clear();
    for (std::size_t node = 0; node < contact_.sums.size(); ++node) write_row(node, terms);
    const auto middle = static_cast<std::ptrdiff_t>(terms.size());
    terms.insert(terms.end(), with_multipliers_.begin(), with_multipliers_.end());
    std::stable_sort(terms.begin() + middle, terms.end(), comes_before);
    std::inplace_merge(terms.begin(), terms.begin() + middle, terms.end(), comes_before);
  }

 private:
  void write_row(std::size_t node, std::vector<ContactTerm>& terms) {
    BlockRow& row = contact_.sums[node];
    row.sort();
    for (int i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < row.columns().size(); ++k)
        for (int j = 0; j < 3; ++j)
          terms.push_back({3 * contact_.nodes.gid[node] + i, 3 * row.columns()[k] + j, row.block(k)(i, j)});
  }
  void add_column(LocalIndex row, GlobalIndex multiplier, const Vec3& slope) {
    const Vec3 part = -(taken(row) * slope);
    for (int i = 0; i < 3; ++i) add(3 * gid(row) + i, multiplier, part[i]);
  }
  [[nodiscard]] const Mat3& taken(LocalIndex node) const { return nth(contact_.nodes.rows, node); }
  [[nodiscard]] GlobalIndex gid(LocalIndex node) const { return nth(contact_.nodes.gid, node); }
  void add(GlobalIndex row, GlobalIndex column, double value) { with_multipliers_.push_back({row, column, value}); }

  const comm::Communicator& ranks_;
  MortarContact& contact_;
  std::vector<ContactTerm> with_multipliers_;
  std::vector<std::vector<ColumnTold>> columns_to_;
};

/// Exact multipliers: columns of pressures, and the rows' own equations.
void add_multipliers(const MortarContact& contact, const Interface& face, const contact::NodeBlocks<Vec3>& gradient,
                     const contact::TractionSlopes& tractions, Terms& terms) {
  contact::NodeBlocks<Vec3> columns, of_start;
  if (face.keeps(contact))
    contact::gaps_at_gradient(face.iterate.rows, face.iterate.slopes, contact.nodes.x_before, of_start);
  contact::pressure_columns(face.iterate.rows, tractions.by_pressure, columns);
  for (std::size_t row = 0; row < face.count(); ++row) {
    const GlobalIndex multiplier = face.multiplier(row);
    const auto index = static_cast<LocalIndex>(row);
    for (std::size_t k = 0; k < columns.nodes.row(index).size(); ++k)
      terms.node_multiplier(columns.nodes.row(index)[k], multiplier, columns.row(index)[k]);
    const std::span<const LocalIndex> turned =
        face.consistent() ? face.iterate.gap_levers.nodes.row(index) : std::span<const LocalIndex>();
    for (std::size_t k = 0; k < turned.size(); ++k)
      terms.node_multiplier(turned[k], multiplier, face.iterate.gap_levers.row(index)[k]);
    if (face.iterate.active[row] == 0) {
      terms.multiplier_multiplier(multiplier, multiplier, 1 / face.topology.kappa[row]);
      continue;
    }
    const double covered = face.iterate.rows.covered[row], fades = face.fades(row);
    const double rate = -face.by_gap(row);
    if (fades > 0) terms.multiplier_multiplier(multiplier, multiplier, -fades / face.topology.kappa[row]);
    for (std::size_t k = 0; k < gradient.nodes.row(index).size(); ++k)
      terms.multiplier_node(multiplier, gradient.nodes.row(index)[k], rate * gradient.row(index)[k]);
    const contact::NodeBlocks<Vec3>& area = face.iterate.slopes.covered;
    const bool keeps = face.keeps(contact);
    const double by_covered = face.above(row) / covered + (keeps ? face.least.by_covered[row] : 0.0);
    const double by_fading = face.fades_by_covered(row) / face.topology.kappa[row] *
                             (face.stiffness * face.above(row) / covered - face.iterate.z[row]);
    for (std::size_t k = 0; k < area.nodes.row(index).size(); ++k)
      terms.multiplier_node(multiplier, area.nodes.row(index)[k], (by_fading - rate * by_covered) * area.row(index)[k]);
    if (!keeps || face.least.by_start[row] == 0) continue;
    for (std::size_t k = 0; k < of_start.nodes.row(index).size(); ++k)
      terms.multiplier_node(multiplier, of_start.nodes.row(index)[k],
                            -rate * face.least.by_start[row] * of_start.row(index)[k]);
  }
}

/// Vectors of this rank's rows, followed by those of the rows beside. Collective.
std::vector<Vec3> with_those_beside(const Interface& face, std::vector<Vec3> all) {
  std::vector<double> own(3 * face.count()), others(3 * face.surfaces.rows_elsewhere.size());
  for (std::size_t row = 0; row < face.count(); ++row) put(all[row], own, row);
  face.numbering.beside.forward(own, others, 3);
  for (std::size_t k = 0; k < others.size(); k += 3) all.emplace_back(&others[k]);
  return all;
}

std::vector<Vec3> tractions_around(const Interface& face) {
  return with_those_beside(face, face.iterate.tractions);
}

/// Consistent rows and the first derivatives of their forces; what second derivatives of weights and
/// normals do is left out. Collective.
void find_consistent_slopes(const MortarContact& contact, Interface& face) {
  std::vector<Vec3> pressures;
  contact::normal_tractions(face.iterate.rows, face.iterate.z, pressures);
  find_slopes_at(face, contact.nodes.x, tractions_around(face), {}, with_those_beside(face, std::move(pressures)));
  contact::lever_patches(face.iterate.rows, face.iterate.slopes, face.iterate.z, face.iterate.lever_patches);
}

/// Derivatives of the rows and of their tractions. Collective.
void find_slopes(MortarContact& contact, Interface& face, FrictionLimit limit, contact::TractionSlopes& tractions,
                 Terms& terms) {
  if (face.consistent())
    find_consistent_slopes(contact, face);
  else
    find_slopes_at(face, contact.nodes.x, tractions_around(face),
                   face.keeps(contact) ? std::span<const Vec3>(contact.nodes.x_before) : std::span<const Vec3>());
  if (face.friction.coefficient > 0)
    contact::friction_traction_slopes(face.iterate.rows, face.iterate.slopes, contact.nodes.x, face.iterate.z,
                                      face.friction, face.history, tractions,
                                      face.start.first_iterate ? std::span<const std::uint8_t>(face.iterate.active)
                                                               : std::span<const std::uint8_t>());
  else
    contact::normal_traction_slopes(face.iterate.rows, face.iterate.slopes, face.iterate.z, tractions);
  if (limit == FrictionLimit::given) tractions.by_pressure = face.iterate.rows.normals;
  contact::NodeBlocks<Vec3> gradient;
  contact::gap_gradient(face.iterate.rows, face.iterate.slopes, gradient);
  if (face.multipliers() == 0)
    contact::add_penalty_slopes(face.iterate.rows, gradient, face.iterate.slopes, face.stiffness, face.iterate.active,
                                tractions);
  else
    add_multipliers(contact, face, gradient, tractions, terms);
  if (face.consistent() && face.multipliers() == 0)
    contact::add_penalty_lever_patches(face.iterate.rows, face.iterate.slopes, gradient, face.iterate.gap_levers,
                                       face.stiffness, face.iterate.z, face.iterate.lever_patches);
}

/// Columns of a tie's multipliers: - the derivatives of its forces.
void add_tie_columns(const Interface& face, std::size_t row, Terms& terms) {
  const auto index = static_cast<LocalIndex>(row);
  const std::span<const LocalIndex> nodes = face.start.tie.weights.nodes.row(index),
                                    turned = face.iterate.levers.nodes.row(index);
  for (int c = 0; c < 3; ++c) {
    const GlobalIndex multiplier = face.multiplier(row, c);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      terms.node_multiplier(nodes[k], multiplier, face.start.tie.weights.row(index)[k] * Vec3::Unit(c));
    for (std::size_t k = 0; k < turned.size(); ++k)
      terms.node_multiplier(turned[k], multiplier, face.iterate.levers.row(index)[k].row(c).transpose());
  }
}

/// The equations of a tied row, whose levers at the iterate are `gradient`.
void add_tie_rows(const Interface& face, std::size_t row, const contact::NodeBlocks<Mat3>& gradient, Terms& terms) {
  const auto index = static_cast<LocalIndex>(row);
  const Mat3& tied = face.start.tied[row];
  const double area = 1 / face.topology.kappa[row];
  for (int c = 0; c < 3; ++c)
    for (int j = 0; j < 3; ++j)
      if (const double redundant = area * ((c == j ? 1 : 0) - tied(c, j)); redundant != 0)
        terms.multiplier_multiplier(face.multiplier(row, c), face.multiplier(row, j), redundant);
  if (face.start.tie.covered[row] == 0) return;
  const Mat3 rate = face.stiffness * area / face.start.tie.covered[row] * tied;
  const auto add = [&](LocalIndex node, const Mat3& slope) {
    for (int c = 0; c < 3; ++c) terms.multiplier_node(face.multiplier(row, c), node, slope.row(c).transpose());
  };
  const std::span<const LocalIndex> nodes = face.start.tie.weights.nodes.row(index), turned = gradient.nodes.row(index);
  for (std::size_t k = 0; k < nodes.size(); ++k) add(nodes[k], face.start.tie.weights.row(index)[k] * rate);
  for (std::size_t k = 0; k < turned.size(); ++k) add(turned[k], rate * gradient.row(index)[k]);
}

/// Collective if there is a gap.
void add_tie(const MortarContact& contact, Interface& face, Terms& terms) {
  const std::span<const Vec3> x = contact.nodes.x;
  contact::NodeBlocks<Mat3> gradient;
  contact::tie_levers(face.start.tie, face.surfaces, face.topology, {}, x, gradient);
  for (std::size_t row = 0; row < face.count(); ++row) {
    add_tie_columns(face, row, terms);
    add_tie_rows(face, row, gradient, terms);
  }
  if (face.start.tie.apart)
    contact::tie_patches(face.start.tie, face.surfaces, face.topology, contact.levers_from(), x, tractions_around(face),
                         face.iterate.slopes.weights);
}

}  // namespace

void contact_terms(const comm::Communicator& ranks, MortarContact& contact, FrictionLimit limit,
                   std::vector<ContactTerm>& terms) {
  terms.clear();
  if (!contact.any()) return;
  Terms sum(ranks, contact);
  std::vector<contact::TractionSlopes> tractions(contact.interfaces.size());
  for (std::size_t k = 0; k < contact.interfaces.size(); ++k)
    if (contact.interfaces[k].pair.tied)
      add_tie(contact, contact.interfaces[k], sum);
    else
      find_slopes(contact, contact.interfaces[k], limit, tractions[k], sum);
  sum_pieces(ranks, contact, tractions,
             [&](LocalIndex row, GlobalIndex column, const Mat3& slope) { sum.node_node(row, column, slope); });
  sum.write(terms);
}

}  // namespace brunt::implicit
