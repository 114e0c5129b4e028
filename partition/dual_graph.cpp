// SPDX-License-Identifier: Apache-2.0
#include "partition/dual_graph.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <vector>

#include "core/cells.hpp"
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

/// Shells that share an edge.
void add_shared_edges(const mesh::Mesh& mesh, std::vector<Edge>& edges) {
  struct Use {
    Edge nodes;  ///< ascending
    LocalIndex element;
  };
  std::vector<Use> uses;
  LocalIndex element = 0;
  for (const mesh::Block& block : mesh.blocks) {
    const bool shell = cells::is_surface(block.shape);
    for (LocalIndex e = 0; e < block.count(); ++e, ++element)
      for (std::size_t k = 0; shell && k < cells::of(block.shape).edges.size(); ++k) {
        const cells::Edge& edge = cells::of(block.shape).edges[k];
        const LocalIndex a = block.element(e)[edge[0]], b = block.element(e)[edge[1]];
        uses.push_back({{std::min(a, b), std::max(a, b)}, element});
      }
  }
  std::ranges::sort(
      uses, [](const Use& a, const Use& b) { return a.nodes != b.nodes ? a.nodes < b.nodes : a.element < b.element; });
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    while (last < uses.size() && uses[last].nodes == uses[first].nodes) ++last;
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t j = i + 1; j < last; ++j)
        if (uses[i].element != uses[j].element) edges.push_back({uses[i].element, uses[j].element});
  }
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
  std::vector<Edge> edges = shared_faces(mesh);
  add_shared_edges(mesh, edges);
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
