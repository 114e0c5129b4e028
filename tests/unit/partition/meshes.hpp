// SPDX-License-Identifier: Apache-2.0
// Small meshes to split: boxes of hexes, of tets, far from each other or in one.
#pragma once
#include <array>
#include <numeric>
#include <string>

#include "mesh/mesh.hpp"

namespace brunt::partition::test {

/// Adds a block of n[0] x n[1] x n[2] unit cells at (x, 0, 0), each one hex or six tets around the diagonal 0-6.
inline void add_box(mesh::Mesh& mesh, std::array<int, 3> n, double x, mesh::Shape shape, const std::string& name) {
  constexpr std::array<std::array<int, 4>, 6> tets{
      {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}}};
  const auto first = static_cast<LocalIndex>(mesh.coordinates.size());
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {
        mesh.coordinates.emplace_back(x + i, j, k);
        mesh.node_id.push_back(static_cast<GlobalIndex>(mesh.node_id.size()) + 1);
      }
  const auto node = [&](int i, int j, int k) { return first + i + (n[0] + 1) * (j + (n[1] + 1) * k); };
  mesh::Block block;
  block.name = name;
  block.id = static_cast<GlobalIndex>(mesh.blocks.size()) + 1;
  block.shape = shape;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        const std::array<LocalIndex, 8> hex{
            node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
            node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
        if (shape == mesh::Shape::hex8)
          block.nodes.insert(block.nodes.end(), hex.begin(), hex.end());
        else
          for (const auto& tet : tets)
            for (const int corner : tet) block.nodes.push_back(hex[static_cast<std::size_t>(corner)]);
      }
  block.element_id.resize(static_cast<std::size_t>(block.count()));
  std::iota(block.element_id.begin(), block.element_id.end(), 1);
  mesh.blocks.push_back(block);
}

inline mesh::Mesh box(std::array<int, 3> n, mesh::Shape shape = mesh::Shape::hex8) {
  mesh::Mesh mesh;
  add_box(mesh, n, 0.0, shape, "box");
  return mesh;
}

}  // namespace brunt::partition::test
