// SPDX-License-Identifier: Apache-2.0
// Forces of contact, summed by the owners of the nodes in an order that does not depend on the ranks: ties first, then
// the other interfaces, each by its rows.
#include <algorithm>
#include <array>

#include "comm/rendezvous.hpp"
#include "mortar_shares.hpp"

namespace brunt::implicit {
namespace {

/// Contribution of one row to one node.
struct Share {
  std::int64_t turn = 0;  ///< number of its interface
  GlobalIndex row = 0;    ///< its place among those of all ranks
  GlobalIndex node = 0;
  std::array<double, 3> force{}, friction{};
};

bool before(const Share& a, const Share& b) {
  return a.turn < b.turn || (a.turn == b.turn && a.row < b.row);
}

void add(const Share& share, ContactNodes& nodes) {
  const auto place = static_cast<std::size_t>(nodes.place_of(share.node));
  nodes.force[place] += Eigen::Map<const Vec3>(share.force.data());
  nodes.friction_force[place] += Eigen::Map<const Vec3>(share.friction.data());
}

/// The moment of a tied row's gap, as forces on the corners of the slave facets.
template <class Take>
void lever_shares_of(const ContactNodes& nodes, const Interface& face, std::size_t row, std::int64_t turn,
                     const Take& take) {
  const auto index = static_cast<LocalIndex>(row);
  const std::span<const LocalIndex> of_row = face.iterate.levers.nodes.row(index);
  for (std::size_t k = 0; k < of_row.size(); ++k) {
    const auto node = static_cast<std::size_t>(of_row[k]);
    Share share{turn, face.numbering.place[row], nodes.gid[node]};
    Eigen::Map<Vec3>(share.force.data()) = face.iterate.levers.row(index)[k].transpose() * face.iterate.tractions[row];
    take(nodes.source[node].rank, share);
  }
}

/// What the motion of nodes changes in the weights and the normal of a row.
template <class Take>
void gap_lever_shares_of(const ContactNodes& nodes, const Interface& face, std::size_t row, std::int64_t turn,
                         const Take& take) {
  const auto index = static_cast<LocalIndex>(row);
  const std::span<const LocalIndex> of_row = face.iterate.gap_levers.nodes.row(index);
  for (std::size_t k = 0; k < of_row.size() && face.iterate.z[row] != 0; ++k) {
    const auto node = static_cast<std::size_t>(of_row[k]);
    Share share{turn, face.numbering.place[row], nodes.gid[node]};
    Eigen::Map<Vec3>(share.force.data()) = face.iterate.z[row] * face.iterate.gap_levers.row(index)[k];
    take(nodes.source[node].rank, share);
  }
}

/// Calls take(owner, share) for each node of each row that has a traction, in the order of the rows.
template <class Take>
void shares_of(const ContactNodes& nodes, const Interface& face, std::int64_t turn, const Take& take) {
  const contact::NodeBlocks<double>& weights = face.pair.tied ? face.start.tie.weights : face.iterate.rows.weights;
  for (std::size_t row = 0; row < face.count(); ++row) {
    const Vec3& traction = face.iterate.tractions[row];
    if (traction.isZero(0)) continue;
    Vec3 tangential = Vec3::Zero();
    if (!face.pair.tied && face.friction.coefficient > 0) {
      const Vec3& n = face.iterate.rows.normals[row];
      tangential = traction - n.dot(traction) * n;
    }
    const std::span<const LocalIndex> of_row = weights.nodes.row(static_cast<LocalIndex>(row));
    for (std::size_t k = 0; k < of_row.size(); ++k) {
      const auto node = static_cast<std::size_t>(of_row[k]);
      const double weight = weights.row(static_cast<LocalIndex>(row))[k];
      Share share{turn, face.numbering.place[row], nodes.gid[node]};
      Eigen::Map<Vec3>(share.force.data()) = weight * traction;
      Eigen::Map<Vec3>(share.friction.data()) = weight * tangential;
      take(nodes.source[node].rank, share);
    }
    if (face.pair.tied) lever_shares_of(nodes, face, row, turn, take);
    if (face.consistent()) gap_lever_shares_of(nodes, face, row, turn, take);
  }
}

}  // namespace

void sum_forces(const comm::Communicator& ranks, MortarContact& contact) {
  ContactNodes& nodes = contact.nodes;
  std::ranges::fill(nodes.force, Vec3(Vec3::Zero()));
  std::ranges::fill(nodes.friction_force, Vec3(Vec3::Zero()));
  std::vector<std::vector<Share>> to_rank(static_cast<std::size_t>(ranks.size()));
  std::vector<Share> own;
  const auto count = static_cast<std::int64_t>(contact.interfaces.size());
  for (const bool tied : {true, false})
    for (std::int64_t k = 0; k < count; ++k) {
      const Interface& face = nth(contact.interfaces, k);
      if (face.pair.tied == tied)
        shares_of(nodes, face, tied ? k : k + count, [&](Rank owner, const Share& share) {
          (owner == ranks.rank() ? own : nth(to_rank, owner)).push_back(share);
        });
    }
  const std::vector<Share> others = comm::exchange(ranks, to_rank).values;
  if (!others.empty()) {
    own.insert(own.end(), others.begin(), others.end());
    std::stable_sort(own.begin(), own.end(), before);
  }
  for (const Share& share : own) add(share, nodes);
}

}  // namespace brunt::implicit
