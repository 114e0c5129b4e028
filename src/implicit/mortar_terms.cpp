// SPDX-License-Identifier: Apache-2.0
// What mortar contact adds to the matrix of the system.
#include <algorithm>

#include "brunt/contact/mortar/forces.hpp"
#include "brunt/contact/mortar/normals.hpp"
#include "brunt/contact/mortar/tractions.hpp"
#include "brunt/implicit/mortar.hpp"

namespace brunt::implicit {
namespace {

/// Takes terms by node of contact and adds those in this rank's rows, supports taken out.
class Terms {
 public:
  explicit Terms(MortarContact& contact) : contact_(contact) {
    contact_.sums.resize(contact.nodes.gid.size());
    for (BlockRow& row : contact_.sums) row.clear();
    own_multiplier_.assign(contact.z.size(), 0);
    for (const LocalIndex k : contact.own) own_multiplier_[static_cast<std::size_t>(k)] = 1;
  }

  /// - dF_row/dx_column: residuals have the forces with a minus.
  void node_node(LocalIndex row, LocalIndex column, const Mat3& slope) {
    if (mine(row)) contact_.sums[static_cast<std::size_t>(row)].add(gid(column), -(taken(row) * slope));
  }
  void node_multiplier(LocalIndex row, GlobalIndex multiplier, const Vec3& slope) {
    if (!mine(row)) return;
    const Vec3 part = -(taken(row) * slope);
    for (int i = 0; i < 3; ++i) add(3 * gid(row) + i, multiplier, part[i]);
  }
  void multiplier_node(GlobalIndex multiplier, LocalIndex column, const Vec3& slope) {
    if (!mine(multiplier)) return;
    for (int j = 0; j < 3; ++j) add(multiplier, 3 * gid(column) + j, slope[j]);
  }
  void multiplier_multiplier(GlobalIndex row, GlobalIndex column, double slope) {
    if (mine(row)) add(row, column, slope);
  }

  /// All of it, by row and column; of what has multipliers, terms of one place in the order in which they came.
  void write(std::vector<ContactTerm>& terms) {
    terms.clear();
    for (std::size_t node = 0; node < contact_.sums.size(); ++node) write_row(node, terms);
    const auto middle = static_cast<std::ptrdiff_t>(terms.size());
    terms.insert(terms.end(), with_multipliers_.begin(), with_multipliers_.end());
    std::stable_sort(terms.begin() + middle, terms.end(), before);
    std::inplace_merge(terms.begin(), terms.begin() + middle, terms.end(), before);
  }

 private:
  static bool before(const ContactTerm& a, const ContactTerm& b) {
    return a.row < b.row || (a.row == b.row && a.column < b.column);
  }
  void write_row(std::size_t node, std::vector<ContactTerm>& terms) {
    BlockRow& row = contact_.sums[node];
    row.sort();
    for (int i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < row.columns().size(); ++k)
        for (int j = 0; j < 3; ++j)
          terms.push_back({3 * contact_.nodes.gid[node] + i, 3 * row.columns()[k] + j, row.block(k)(i, j)});
  }
  [[nodiscard]] bool mine(LocalIndex node) const {
    return contact_.nodes.own[static_cast<std::size_t>(node)] != no_index;
  }
  [[nodiscard]] bool mine(GlobalIndex multiplier) const {
    return own_multiplier_[static_cast<std::size_t>(multiplier - contact_.interfaces.front().first)] != 0;
  }
  [[nodiscard]] const Mat3& taken(LocalIndex node) const { return contact_.nodes.rows[static_cast<std::size_t>(node)]; }
  [[nodiscard]] GlobalIndex gid(LocalIndex node) const { return contact_.nodes.gid[static_cast<std::size_t>(node)]; }
  void add(GlobalIndex row, GlobalIndex column, double value) { with_multipliers_.push_back({row, column, value}); }

  MortarContact& contact_;
  std::vector<ContactTerm> with_multipliers_;
  std::vector<char> own_multiplier_;
};

void add_patches(const contact::Patches& patches, Terms& terms) {
  for (std::size_t p = 0; p < patches.count; ++p) {
    const contact::Patch& patch = patches.patch[p];
    const std::size_t width = 3 * patch.columns.size();
    for (std::size_t r = 0; r < patch.rows.size(); ++r)
      for (std::size_t c = 0; c < patch.columns.size(); ++c) {
        const double* corner = patch.values.data() + 3 * r * width + 3 * c;
        Mat3 block;
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            block(i, j) = corner[static_cast<std::size_t>(i) * width + static_cast<std::size_t>(j)];
        terms.node_node(patch.rows[r], patch.columns[c], block);
      }
  }
}

/// w_AK dT_A/dx_L of all rows.
void add_traction_slopes(const contact::MortarRows& rows, const contact::NodeBlocks<Mat3>& slopes, Terms& terms) {
  for (LocalIndex row = 0; row < slopes.nodes.rows(); ++row) {
    const std::span<const LocalIndex> nodes = rows.weights.nodes.row(row), by = slopes.nodes.row(row);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (std::size_t l = 0; l < by.size(); ++l)
        terms.node_node(nodes[k], by[l], rows.weights.row(row)[k] * slopes.row(row)[l]);
  }
}

/// Exact multipliers: columns of pressures, and the rows' own equations.
void add_multipliers(const MortarContact& contact, const Interface& face, const contact::NodeBlocks<Vec3>& gradient,
                     const contact::TractionSlopes& tractions, Terms& terms) {
  contact::NodeBlocks<Vec3> columns, of_start;
  if (face.keeps(contact)) contact::gaps_at_gradient(face.rows, face.slopes, contact.nodes.x_before, of_start);
  contact::pressure_columns(face.rows, tractions.by_pressure, columns);
  for (std::size_t row = 0; row < face.count(); ++row) {
    const GlobalIndex multiplier = face.first + static_cast<GlobalIndex>(row);
    const auto index = static_cast<LocalIndex>(row);
    for (std::size_t k = 0; k < columns.nodes.row(index).size(); ++k)
      terms.node_multiplier(columns.nodes.row(index)[k], multiplier, columns.row(index)[k]);
    if (face.active[row] == 0) {
      terms.multiplier_multiplier(multiplier, multiplier, 1 / face.topology.kappa[row]);
      continue;
    }
    const double covered = face.rows.covered[row], rate = -face.stiffness / (face.topology.kappa[row] * covered);
    for (std::size_t k = 0; k < gradient.nodes.row(index).size(); ++k)
      terms.multiplier_node(multiplier, gradient.nodes.row(index)[k], rate * gradient.row(index)[k]);
    const contact::NodeBlocks<Vec3>& area = face.slopes.covered;
    const bool keeps = face.keeps(contact);
    const double by_covered = face.above(row) / covered + (keeps ? face.least_by_covered[row] : 0.0);
    for (std::size_t k = 0; k < area.nodes.row(index).size(); ++k)
      terms.multiplier_node(multiplier, area.nodes.row(index)[k], -rate * by_covered * area.row(index)[k]);
    if (!keeps || face.least_by_start[row] == 0) continue;
    for (std::size_t k = 0; k < of_start.nodes.row(index).size(); ++k)
      terms.multiplier_node(multiplier, of_start.nodes.row(index)[k],
                            -rate * face.least_by_start[row] * of_start.row(index)[k]);
  }
}

void add_contact(MortarContact& contact, Interface& face, Terms& terms) {
  contact::mortar_rows_and_slopes(
      face.surfaces, face.topology, face.search.candidates, contact.nodes.x, face.tractions, *face.scratch, face.rows,
      face.slopes, face.keeps(contact) ? std::span<const Vec3>(contact.nodes.x_before) : std::span<const Vec3>());
  contact::TractionSlopes tractions;
  if (face.friction.coefficient > 0)
    contact::friction_traction_slopes(
        face.rows, face.slopes, contact.nodes.x, face.z, face.friction, face.history, tractions,
        face.at_start ? std::span<const std::uint8_t>(face.active) : std::span<const std::uint8_t>());
  else
    contact::normal_traction_slopes(face.rows, face.slopes, face.z, tractions);
  contact::NodeBlocks<Vec3> gradient;
  contact::gap_gradient(face.rows, face.slopes, gradient);
  if (face.multipliers() == 0)
    contact::add_penalty_slopes(face.rows, gradient, face.slopes, face.stiffness, face.active, tractions);
  else
    add_multipliers(contact, face, gradient, tractions, terms);
  add_patches(face.slopes.weights, terms);
  add_traction_slopes(face.rows, tractions.by_position, terms);
}

void add_tie(MortarContact& contact, Interface& face, Terms& terms) {
  std::vector<Vec3> normals;
  contact::NodeBlocks<Mat3> normal_slopes, gradient;
  contact::nodal_normals(face.surfaces, face.topology, contact.nodes.x, normals, &normal_slopes);
  contact::tie_gradient(face.tie, normals, normal_slopes, gradient);
  for (std::size_t row = 0; row < face.count(); ++row) {
    const auto index = static_cast<LocalIndex>(row);
    const GlobalIndex first = face.first + 3 * static_cast<GlobalIndex>(row);
    const double area = 1 / face.topology.kappa[row];
    const bool covered = face.tie.covered[row] > 0;
    const Mat3& tied = face.tied[row];
    const std::span<const LocalIndex> nodes = face.tie.weights.nodes.row(index);
    for (int c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < nodes.size() && covered; ++k)
        terms.node_multiplier(nodes[k], first + c, face.tie.weights.row(index)[k] * Vec3::Unit(c));
      for (int j = 0; j < 3; ++j)
        if (const double redundant = area * ((c == j ? 1 : 0) - tied(c, j)); redundant != 0)
          terms.multiplier_multiplier(first + c, first + j, redundant);
      for (std::size_t k = 0; k < gradient.nodes.row(index).size(); ++k)
        terms.multiplier_node(first + c, gradient.nodes.row(index)[k],
                              face.stiffness * area * (tied * gradient.row(index)[k]).row(c).transpose());
    }
  }
}

}  // namespace

void contact_terms(MortarContact& contact, std::vector<ContactTerm>& terms) {
  terms.clear();
  if (!contact.any()) return;
  Terms sum(contact);
  for (Interface& face : contact.interfaces)
    if (face.pair.tied)
      add_tie(contact, face, sum);
    else
      add_contact(contact, face, sum);
  sum.write(terms);
}

}  // namespace brunt::implicit
