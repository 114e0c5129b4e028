// SPDX-License-Identifier: Apache-2.0
#include "partition/dual_graph.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "brunt/mesh/topology.hpp"

namespace brunt::partition {

namespace {

struct Face {
  std::array<LocalIndex, 4> nodes;  // ascending, so that both elements write it alike; a triangle starts with no_index
  LocalIndex element = 0;
};

/// Calls visit(face) for each face with at least three distinct nodes, element by element.
template <class Visit>
void for_each_face(const mesh::Mesh& mesh, Visit visit) {
  LocalIndex element = 0;
  for_each_element(mesh, [&](std::span<const LocalIndex> nodes, mesh::Shape shape) {
    for (int f = 0; f < mesh::faces_per_element(shape); ++f) {
      Face face{mesh::face_nodes(shape, nodes.data(), f), element};
      std::ranges::sort(face.nodes);
      if (face.nodes[1] != no_index) visit(face);
    }
    ++element;
  });
}

std::size_t lowest_node(const Face& face) {
  return static_cast<std::size_t>(face.nodes[0] == no_index ? face.nodes[1] : face.nodes[0]);
}

using Edge = std::pair<LocalIndex, LocalIndex>;

/// Faces in rows by their lowest node, where equal ones are found among a dozen.
Ragged<Face> faces_by_lowest_node(const mesh::Mesh& mesh) {
  Ragged<Face> faces;
  faces.offsets.assign(mesh.coordinates.size() + 1, 0);
  for_each_face(mesh, [&](const Face& face) { ++faces.offsets[lowest_node(face) + 1]; });
  std::partial_sum(faces.offsets.begin(), faces.offsets.end(), faces.offsets.begin());
  faces.values.resize(static_cast<std::size_t>(faces.offsets.back()));
  std::vector<LocalIndex> next(faces.offsets.begin(), faces.offsets.end() - 1);
  for_each_face(mesh,
                [&](const Face& face) { faces.values[static_cast<std::size_t>(next[lowest_node(face)]++)] = face; });
  return faces;
}

}  // namespace

Ragged<LocalIndex> dual_graph(const mesh::Mesh& mesh) {
  const Ragged<Face> faces = faces_by_lowest_node(mesh);
  std::vector<Edge> edges;
  for (LocalIndex r = 0; r < faces.rows(); ++r) {
    const std::span<const Face> row = faces.row(r);
    for (std::size_t i = 0; i < row.size(); ++i)
      for (std::size_t j = i + 1; j < row.size(); ++j) {
        if (row[i].nodes != row[j].nodes || row[i].element == row[j].element) continue;
        edges.emplace_back(row[i].element, row[j].element);
        edges.emplace_back(row[j].element, row[i].element);
      }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  Ragged<LocalIndex> graph;
  const LocalIndex elements = first_of_block(mesh).back();
  auto edge = edges.begin();
  for (LocalIndex e = 0; e < elements; ++e) {
    for (; edge != edges.end() && edge->first == e; ++edge) graph.values.push_back(edge->second);
    graph.close_row();
  }
  return graph;
}

std::vector<LocalIndex> first_of_block(const mesh::Mesh& mesh) {
  std::vector<LocalIndex> first{0};
  for (const mesh::Block& block : mesh.blocks) first.push_back(first.back() + block.count());
  return first;
}

}  // namespace brunt::partition
