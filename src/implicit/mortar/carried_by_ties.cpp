// SPDX-License-Identifier: Apache-2.0
// Nodes on walls whose projections, to which they are tied, are constrained by the same walls. Which of two nodes
// depends on the other is a matter of order: all ranks process the same few rows in the same order.
#include <algorithm>
#include <array>
#include <map>

#include "comm/rendezvous.hpp"
#include "implicit/mortar/mortar.hpp"
#include "mortar_shares.hpp"

namespace brunt::implicit {
namespace {

/// Projector onto the common directions of two projectors.
Mat3 common(const Mat3& one, const Mat3& other) {
  return contact::held_by_all(2 * Mat3::Identity() - one - other);
}

using Values = std::array<double, 9>;

Values values_of(const Mat3& matrix) {
  Values values{};
  Eigen::Map<Mat3>(values.data()) = matrix;
  return values;
}

Mat3 matrix_of(const Values& values) {
  return Eigen::Map<const Mat3>(values.data());
}

/// A row whose slave node is constrained by walls along directions along which its projection is constrained.
struct RowTold {
  GlobalIndex interface = 0, place = 0, slave = 0;
  std::array<GlobalIndex, 4> below{};  ///< nodes with a weight in the projection, or -1
  Values slave_free{}, slave_movable{};
  std::array<Values, 4> movable{};  ///< of `below`
};

bool before(const RowTold& a, const RowTold& b) {
  return a.interface < b.interface || (a.interface == b.interface && a.place < b.place);
}

/// Rows of this rank whose wall constraints may be redundant with those of the projection. movable: of slaves; that of
/// `nodes` may be of a previous iterate.
bool stands_on_walls(const ContactNodes& nodes, const Interface& face, std::size_t row, std::span<const Mat3> movable) {
  const auto node = static_cast<std::size_t>(face.surfaces.rows[row]);
  return face.start.tie.covered[row] > 0 && !(nodes.free[node] - movable[node]).isZero();
}

RowTold told(const ContactNodes& nodes, GlobalIndex interface, const Interface& face, std::size_t row) {
  const auto node = static_cast<std::size_t>(face.surfaces.rows[row]);
  RowTold told;
  told.interface = interface;
  told.place = face.numbering.place[row];
  told.slave = nodes.gid[node];
  told.slave_free = values_of(nodes.free[node]);
  told.slave_movable = values_of(nodes.movable[node]);
  const contact::MasterPlace& below = face.start.tie.below[row];
  for (std::size_t c = 0; c < below.nodes.size(); ++c) {
    told.below[c] = -1;
    if (below.nodes[c] == no_index || !contact::has_share(below.weights[c])) continue;
    told.below[c] = nth(nodes.gid, below.nodes[c]);
    told.movable[c] = values_of(nth(nodes.movable, below.nodes[c]));
  }
  return told;
}

/// Collective. In the order of interfaces and rows.
std::vector<RowTold> rows_of_all(const comm::Communicator& ranks, const MortarContact& contact) {
  const ContactNodes& nodes = contact.nodes;
  std::vector<RowTold> mine;
  for (std::size_t k = 0; k < contact.interfaces.size(); ++k) {
    const Interface& face = contact.interfaces[k];
    for (std::size_t row = 0; face.pair.tied && row < face.count(); ++row) {
      if (!stands_on_walls(nodes, face, row, nodes.movable) || face.start.tie.below[row].nodes[0] == no_index) continue;
      const auto node = static_cast<std::size_t>(face.surfaces.rows[row]);
      const Mat3 below = contact::held_by_all(contact::freedom_of(face.start.tie.below[row], nodes.movable));
      if (common(nodes.free[node] - nodes.movable[node], below).isZero()) continue;
      mine.push_back(told(nodes, static_cast<GlobalIndex>(k), face, row));
    }
  }
  std::vector<RowTold> all =
      comm::exchange(ranks, std::vector<std::vector<RowTold>>(static_cast<std::size_t>(ranks.size()), mine)).values;
  std::ranges::sort(all, before);
  return all;
}

/// For each node: redundant directions. A node on which others depend keeps its wall constraints.
std::map<GlobalIndex, Mat3> carried_of(const std::vector<RowTold>& rows) {
  std::map<GlobalIndex, Mat3> carried, movable;
  std::map<GlobalIndex, bool> carries;
  for (const RowTold& row : rows) {
    movable.emplace(row.slave, matrix_of(row.slave_movable));
    for (std::size_t c = 0; c < row.below.size(); ++c)
      if (row.below[c] >= 0) movable.emplace(row.below[c], matrix_of(row.movable[c]));
  }
  for (const RowTold& row : rows) {
    const Mat3 by_walls = matrix_of(row.slave_free) - movable.at(row.slave);
    if (carries[row.slave] || by_walls.isZero()) continue;
    Mat3 freedom = Mat3::Zero();
    for (const GlobalIndex node : row.below)
      if (node >= 0) freedom += movable.at(node);
    const Mat3 both = common(by_walls, contact::held_by_all(freedom));
    if (both.isZero()) continue;
    carried.emplace(row.slave, Mat3::Zero()).first->second += both;
    movable.at(row.slave) += both;
    for (const GlobalIndex node : row.below)
      if (node >= 0) carries[node] = true;
  }
  return carried;
}

}  // namespace

std::vector<Mat3> carried_by_ties(const comm::Communicator& ranks, std::span<const Mat3> movable,
                                  MortarContact& contact) {
  ContactNodes& nodes = contact.nodes;
  std::vector<Mat3> carried(nodes.lasting, Mat3::Zero());
  bool any = false;
  for (const Interface& face : contact.interfaces)
    for (std::size_t row = 0; face.pair.tied && row < face.count(); ++row)
      any = any || stands_on_walls(nodes, face, row, movable);
  if (!ranks.any(any)) return carried;
  share_movable(movable, nodes);
  for (const auto& [node, directions] : carried_of(rows_of_all(ranks, contact)))
    if (const LocalIndex place = nodes.place_of(node); place != no_index && nth(nodes.own, place) != no_index)
      nth(carried, place) = directions;
  return carried;
}

}  // namespace brunt::implicit
