// SPDX-License-Identifier: Apache-2.0
// Triangles of a mesh of quadrilaterals, with diagonals between nodes of one colour.
#include <numeric>

#include "mesh/shell_bodies.hpp"

namespace brunt::mesh {
namespace {

constexpr std::size_t corners = 4;

/// Nodes of the two ends of an edge have different colours, as in a chessboard. Where that is impossible (an odd number
/// of elements around) some edges have two ends of one colour, and the elements there any diagonal.
std::vector<char> colours(const Mesh& mesh, const Block& block) {
  constexpr char none = 2;
  std::vector<char> colour(mesh.coordinates.size(), none);
  std::vector<std::vector<LocalIndex>> neighbours(mesh.coordinates.size());
  for (LocalIndex e = 0; e < block.count(); ++e)
    for (std::size_t k = 0; k < corners; ++k) {
      const LocalIndex a = block.element(e)[k], b = block.element(e)[(k + 1) % corners];
      nth(neighbours, a).push_back(b);
      nth(neighbours, b).push_back(a);
    }
  std::vector<LocalIndex> front;
  for (const LocalIndex seed : block.nodes) {
    if (nth(colour, seed) != none) continue;
    nth(colour, seed) = 0;
    front = {seed};
    for (std::size_t i = 0; i < front.size(); ++i)
      for (const LocalIndex n : nth(neighbours, front[i]))
        if (nth(colour, n) == none) {
          nth(colour, n) = static_cast<char>(1 - nth(colour, front[i]));
          front.push_back(n);
        }
  }
  return colour;
}

}  // namespace

void split_into_triangles(Mesh& mesh) {
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    Block& block = mesh.blocks[b];
    if (block.shape != Shape::quad4) continue;
    const std::vector<char> colour = colours(mesh, block);
    std::vector<LocalIndex> nodes;
    nodes.reserve(block.nodes.size() / 4 * 6);
    for (LocalIndex e = 0; e < block.count(); ++e) {
      const LocalIndex* n = block.element(e);
      const std::size_t first = nth(colour, n[0]) == 0 && nth(colour, n[2]) == 0 ? 0 : 1;  // an end of the diagonal
      for (const std::size_t next : {first, first + 2})
        for (const std::size_t k : {next, next + 1, next + 2}) nodes.push_back(n[k % corners]);
    }
    block.shape = Shape::tri3;
    block.nodes = std::move(nodes);
    block.element_id.resize(static_cast<std::size_t>(block.count()));
    std::iota(block.element_id.begin(), block.element_id.end(), 1);
    for (auto& [name, sides] : mesh.side_sets) {
      std::vector<Side> split;
      for (const Side& side : sides)
        if (side.block == static_cast<LocalIndex>(b))
          for (const LocalIndex half : {0, 1}) split.push_back({side.block, 2 * side.element + half, side.face});
        else
          split.push_back(side);
      sides = std::move(split);
    }
  }
}

}  // namespace brunt::mesh
