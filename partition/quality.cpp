// SPDX-License-Identifier: Apache-2.0
#include "partition/quality.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "partition/dual_graph.hpp"
#include "partition/sharing.hpp"

namespace brunt::partition {

namespace {

template <class T>
double imbalance(const std::vector<T>& weight, std::span<const Rank> part, int parts) {
  std::vector<double> load(static_cast<std::size_t>(parts), 0.0);
  for (std::size_t e = 0; e < weight.size(); ++e) nth(load, part[e]) += static_cast<double>(weight[e]);
  const double total = std::accumulate(load.begin(), load.end(), 0.0);
  return total > 0.0 ? *std::ranges::max_element(load) * parts / total : 1.0;
}

GlobalIndex cut_edges(const Ragged<LocalIndex>& graph, std::span<const Rank> part) {
  GlobalIndex cut = 0;
  for (LocalIndex e = 0; e < graph.rows(); ++e)
    for (const LocalIndex other : graph.row(e))
      if (other > e && nth(part, other) != nth(part, e)) ++cut;
  return cut;
}

GlobalIndex travelling_forces(const mesh::Mesh& mesh, const Sharing& sharing) {
  std::vector<GlobalIndex> others(mesh.coordinates.size(), 0);  // number of other holders of a node
  for (LocalIndex i = 0; i < sharing.holders.rows(); ++i)
    nth(others, nth(sharing.shared, i)) = static_cast<GlobalIndex>(sharing.holders.row(i).size()) - 1;
  GlobalIndex forces = 0;
  for_each_element(mesh, [&](std::span<const LocalIndex> nodes, mesh::Shape) {
    for (const LocalIndex node : nodes) forces += nth(others, node);
  });
  return forces;
}

std::vector<int> neighbours_of_parts(const Sharing& sharing, int parts) {
  std::set<std::pair<Rank, Rank>> pairs;
  for (LocalIndex i = 0; i < sharing.holders.rows(); ++i)
    for (const Rank a : sharing.holders.row(i))
      for (const Rank b : sharing.holders.row(i))
        if (a != b) pairs.emplace(a, b);
  std::vector<int> neighbours(static_cast<std::size_t>(parts), 0);
  for (const auto& [a, b] : pairs) ++nth(neighbours, a);
  return neighbours;
}

}  // namespace

Quality quality(const mesh::Mesh& mesh, const Ragged<LocalIndex>& graph, const Weights& weights,
                std::span<const Rank> part, int parts) {
  demand(parts >= 1 && part.size() == static_cast<std::size_t>(graph.rows()) && part.size() == weights.cost.size(),
         "each element has a part and a weight");
  const Sharing sharing = share_nodes(mesh, part);
  const std::vector<int> neighbours = neighbours_of_parts(sharing, parts);
  const std::set<Rank> used(part.begin(), part.end());
  Quality q;
  q.parts = parts;
  q.empty_parts = parts - static_cast<int>(used.size());
  q.elements = graph.rows();
  q.contact_faces = std::accumulate(weights.contact_faces.begin(), weights.contact_faces.end(), GlobalIndex{0});
  q.element_imbalance = imbalance(weights.cost, part, parts);
  q.contact_imbalance = imbalance(weights.contact_faces, part, parts);
  q.edge_cut = cut_edges(graph, part);
  q.shared_nodes = static_cast<GlobalIndex>(sharing.shared.size());
  q.corner_forces = travelling_forces(mesh, sharing);
  q.neighbours_max = *std::ranges::max_element(neighbours);
  q.neighbours_mean = std::accumulate(neighbours.begin(), neighbours.end(), 0.0) / parts;
  return q;
}

}  // namespace brunt::partition
