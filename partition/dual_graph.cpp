// SPDX-License-Identifier: Apache-2.0
#include "partition/dual_graph.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <vector>

#include "mesh/face_rows.hpp"

namespace brunt::partition {

namespace {

using Edge = std::array<LocalIndex, 2>;

/// The two elements that share a face.
std::vector<Edge> shared_faces(const mesh::Mesh& mesh) {
  const mesh::FaceRows rows(mesh);
  std::vector<Edge> edges;
  edges.reserve(rows.faces() / 2);
  rows.for_each_row([&](std::span<const mesh::KeyedFace> row) {
    for (std::size_t i = 0; i < row.size(); ++i)
      for (std::size_t j = i + 1; j < row.size(); ++j)
        if (row[i].same_nodes(row[j]) && row[i].element != row[j].element)
          edges.push_back({row[i].element, row[j].element});
  });
  return edges;
}

/// Sorts each row; elements that share several faces keep one edge.
void sort_rows(Ragged<LocalIndex>& graph) {
  auto end = graph.values.begin();
  LocalIndex first = 0;
  for (std::size_t e = 0; e + 1 < graph.offsets.size(); ++e) {
    const auto begin = graph.values.begin() + first, last = graph.values.begin() + graph.offsets[e + 1];
    first = graph.offsets[e + 1];
    std::sort(begin, last);
    const auto repeated = std::unique(begin, last);
    end = end == begin ? repeated : std::copy(begin, repeated, end);
    graph.offsets[e + 1] = static_cast<LocalIndex>(end - graph.values.begin());
  }
  graph.values.erase(end, graph.values.end());
}

}  // namespace

Ragged<LocalIndex> dual_graph(const mesh::Mesh& mesh) {
  const std::vector<Edge> edges = shared_faces(mesh);
  Ragged<LocalIndex> graph;
  // counted with an offset of two, so that filling moves the starts to their final positions
  std::vector<LocalIndex>& offsets = graph.offsets;
  offsets.assign(static_cast<std::size_t>(first_of_block(mesh).back()) + 2, 0);
  for (const Edge& edge : edges)
    for (const LocalIndex e : edge) ++offsets[static_cast<std::size_t>(e) + 2];
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  graph.values.resize(static_cast<std::size_t>(offsets.back()));
  const auto add = [&](LocalIndex from, LocalIndex to) {
    nth(graph.values, offsets[static_cast<std::size_t>(from) + 1]++) = to;
  };
  for (const Edge& edge : edges) {
    add(edge[0], edge[1]);
    add(edge[1], edge[0]);
  }
  offsets.pop_back();
  sort_rows(graph);
  return graph;
}

std::vector<LocalIndex> first_of_block(const mesh::Mesh& mesh) {
  std::vector<LocalIndex> first{0};
  for (const mesh::Block& block : mesh.blocks) first.push_back(first.back() + block.count());
  return first;
}

}  // namespace brunt::partition
