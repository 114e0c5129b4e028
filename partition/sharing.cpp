// SPDX-License-Identifier: Apache-2.0
#include "partition/sharing.hpp"

#include <algorithm>
#include <utility>

#include "partition/dual_graph.hpp"

namespace brunt::partition {

Sharing share_nodes(const mesh::Mesh& mesh, std::span<const Rank> part) {
  constexpr Rank nobody = -1;
  Sharing sharing;
  sharing.owner.assign(mesh.coordinates.size(), nobody);
  std::vector<std::pair<LocalIndex, Rank>> holder;  // of shared nodes; most nodes have only an owner
  std::size_t element = 0;
  for_each_element(mesh, [&](std::span<const LocalIndex> nodes, mesh::Shape) {
    const Rank rank = part[element++];
    for (const LocalIndex node : nodes) {
      Rank& owner = nth(sharing.owner, node);
      if (owner == nobody) owner = rank;
      if (owner == rank) continue;
      holder.emplace_back(node, owner);
      holder.emplace_back(node, rank);
    }
  });
  std::ranges::replace(sharing.owner, nobody, 0);

  std::ranges::sort(holder);
  holder.erase(std::unique(holder.begin(), holder.end()), holder.end());
  for (std::size_t i = 0; i < holder.size();) {
    const LocalIndex node = holder[i].first;
    sharing.shared.push_back(node);
    for (; i < holder.size() && holder[i].first == node; ++i) sharing.holders.values.push_back(holder[i].second);
    sharing.holders.close_row();
  }
  return sharing;
}

}  // namespace brunt::partition
