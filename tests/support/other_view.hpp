// SPDX-License-Identifier: Apache-2.0
// The same mesh seen otherwise: turned, mirrored, moved, numbered in another order. No result may depend on it.
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace brunt::test {

struct View {
  std::string name;
  Mat3 turn = Mat3::Identity();  ///< or mirror
  Vec3 move = Vec3::Zero();
  unsigned numbering = 0;       ///< 0: as given; else nodes and elements of each block are shuffled
  bool turns_elements = false;  ///< each element's corners are numbered from another one
  bool swaps_blocks = false;
};

struct Seen {
  mesh::Mesh mesh;
  std::vector<GlobalIndex> node;  ///< in `mesh`, of each node of the mesh given
};

/// Corners of a hexahedron in a frame turned by 90 degrees about z and by 120 about the diagonal; of a tetrahedron
/// cyclic.
inline void turn_element(LocalIndex* nodes, mesh::Shape shape, std::mt19937& random) {
  constexpr std::array<std::size_t, 8> about_z{1, 2, 3, 0, 5, 6, 7, 4}, about_diagonal{0, 3, 7, 4, 1, 2, 6, 5};
  const auto apply = [&](const auto& order) {
    auto old = order;
    for (std::size_t i = 0; i < order.size(); ++i) old[i] = static_cast<std::size_t>(nodes[order[i]]);
    for (std::size_t i = 0; i < order.size(); ++i) nodes[i] = static_cast<LocalIndex>(old[i]);
  };
  for (int k = 0; k < 4; ++k) {
    if (shape == mesh::Shape::tet4)
      random() % 2 == 0 ? apply(std::array<std::size_t, 4>{1, 2, 0, 3}) : apply(std::array<std::size_t, 4>{0, 2, 3, 1});
    else
      random() % 2 == 0 ? apply(about_z) : apply(about_diagonal);
  }
}

inline void mirror_element(LocalIndex* nodes, mesh::Shape shape) {
  std::swap(nodes[1], nodes[shape == mesh::Shape::tet4 ? 2 : 3]);
  if (shape == mesh::Shape::hex8) std::swap(nodes[5], nodes[7]);
}

/// Without its side sets and node sets.
inline Seen see(mesh::Mesh mesh, const View& view) {
  std::mt19937 random(view.numbering);
  Seen seen;
  seen.node.resize(mesh.coordinates.size());
  std::iota(seen.node.begin(), seen.node.end(), GlobalIndex{0});
  if (view.numbering > 0) std::ranges::shuffle(seen.node, random);
  std::vector<Vec3> coordinates(mesh.coordinates.size());
  for (std::size_t n = 0; n < coordinates.size(); ++n)
    coordinates[static_cast<std::size_t>(seen.node[n])] = view.turn * mesh.coordinates[n] + view.move;
  mesh.coordinates = std::move(coordinates);
  for (mesh::Block& block : mesh.blocks) {
    const auto width = static_cast<std::size_t>(mesh::nodes_per_element(block.shape));
    std::vector<LocalIndex> order(static_cast<std::size_t>(block.count())), nodes;
    std::iota(order.begin(), order.end(), 0);
    if (view.numbering > 0) std::ranges::shuffle(order, random);
    for (const LocalIndex e : order) nodes.insert(nodes.end(), block.element(e), block.element(e) + width);
    for (LocalIndex& node : nodes) node = static_cast<LocalIndex>(seen.node[static_cast<std::size_t>(node)]);
    for (std::size_t first = 0; first < nodes.size(); first += width) {
      if (view.turn.determinant() < 0) mirror_element(&nodes[first], block.shape);
      if (view.turns_elements) turn_element(&nodes[first], block.shape, random);
    }
    block.nodes = std::move(nodes);
  }
  if (view.swaps_blocks) std::ranges::reverse(mesh.blocks);
  mesh.side_sets.clear();
  mesh.node_sets.clear();
  seen.mesh = std::move(mesh);
  return seen;
}

}  // namespace brunt::test
