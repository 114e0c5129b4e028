// SPDX-License-Identifier: Apache-2.0
#include "implicit/data/unknowns.hpp"

#include <algorithm>

#include "comm/rendezvous.hpp"
#include "core/error.hpp"

namespace brunt::implicit {
namespace {

/// The local indices of the nodes `copy` on their owners. Collective.
std::vector<comm::RemoteSlot> at_owners(const comm::Communicator& ranks, const mesh::LocalMesh& mesh,
                                        std::span<const LocalIndex> copy) {
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<GlobalIndex>> asked(size);
  for (const LocalIndex node : copy) nth(asked, nth(mesh.owner, node)).push_back(nth(mesh.node_gid, node));
  const Ragged<GlobalIndex> questions = comm::exchange(ranks, asked);
  std::vector<std::vector<LocalIndex>> answers(size);
  for (LocalIndex r = 0; r < questions.rows(); ++r)
    for (const GlobalIndex gid : questions.row(r)) {
      const auto found = std::ranges::lower_bound(mesh.node_gid, gid);
      demand(found != mesh.node_gid.end() && *found == gid, "an owner holds its nodes");
      nth(answers, r).push_back(static_cast<LocalIndex>(found - mesh.node_gid.begin()));
    }
  const Ragged<LocalIndex> places = comm::exchange(ranks, answers);
  std::vector<std::size_t> next(size, 0);
  std::vector<comm::RemoteSlot> source;
  for (const LocalIndex node : copy) {
    const Rank owner = nth(mesh.owner, node);
    source.push_back({owner, places.row(owner)[nth(next, owner)++]});
  }
  return source;
}

}  // namespace

Unknowns number_unknowns(const comm::Communicator& ranks, const model::Model& model) {
  const mesh::LocalMesh& mesh = model.mesh;
  Unknowns unknowns;
  unknowns.total = 3 * mesh.global_nodes;
  for (LocalIndex node = 0; node < model.nodes(); ++node) {
    const auto i = static_cast<std::size_t>(node);
    if (mesh.owner[i] != ranks.rank()) {
      unknowns.copy.push_back(node);
      continue;
    }
    unknowns.node.push_back(node);
    for (int c = 0; c < 3; ++c) unknowns.row.push_back(3 * mesh.node_gid[i] + c);
  }
  unknowns.copies = comm::Halo(ranks, model.nodes(), at_owners(ranks, mesh, unknowns.copy));
  unknowns.received.resize(3 * unknowns.copy.size());
  return unknowns;
}

void share(Unknowns& unknowns, std::span<double> nodal) {
  unknowns.copies.forward(nodal, unknowns.received, 3);
  for (std::size_t k = 0; k < unknowns.copy.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c)
      nodal[3 * static_cast<std::size_t>(unknowns.copy[k]) + c] = unknowns.received[3 * k + c];
}

}  // namespace brunt::implicit
