// SPDX-License-Identifier: Apache-2.0
// Faces of elements, the outside of a mesh, connected bodies.
#include "brunt/mesh/topology.hpp"

#include <algorithm>
#include <numeric>

#include "brunt/core/cells.hpp"

namespace brunt::mesh {
namespace {

constexpr std::array<LocalIndex, 4> no_face{no_index, no_index, no_index, no_index};

struct KeyedSide {
  std::array<LocalIndex, 4> key;  // the face's nodes ascending: equal for all elements that share it
  Side side;
};

/// Calls visit(nodes, side) for each face with at least three distinct nodes, by block, element, face.
template <class Visit>
void for_each_face(const Mesh& mesh, Visit visit) {
  for (LocalIndex b = 0; b < static_cast<LocalIndex>(mesh.blocks.size()); ++b) {
    const Block& block = mesh.blocks[static_cast<std::size_t>(b)];
    for (LocalIndex e = 0; e < block.count(); ++e)
      for (int f = 0; f < faces_per_element(block.shape); ++f) {
        const auto nodes = face_nodes(block.shape, block.element(e), f);
        if (nodes[0] != no_index) visit(nodes, Side{b, e, f});
      }
  }
}

LocalIndex lowest_node(const std::array<LocalIndex, 4>& nodes) {
  LocalIndex lowest = std::min({nodes[0], nodes[1], nodes[2]});
  return nodes[3] == no_index ? lowest : std::min(lowest, nodes[3]);
}

/// Faces in rows by their lowest node (a counting sort: linear in the mesh), in order of (block, element, face).
void collect_faces(const Mesh& mesh, std::vector<std::size_t>& row, std::vector<KeyedSide>& faces) {
  row.assign(mesh.coordinates.size() + 1, 0);
  for_each_face(mesh, [&](const auto& nodes, Side) { ++row[static_cast<std::size_t>(lowest_node(nodes)) + 1]; });
  std::partial_sum(row.begin(), row.end(), row.begin());
  faces.resize(row.back());
  std::vector<std::size_t> next(row.begin(), row.end() - 1);
  for_each_face(mesh, [&](std::array<LocalIndex, 4> nodes, Side side) {
    const auto position = next[static_cast<std::size_t>(lowest_node(nodes))]++;
    std::sort(nodes.begin(), nodes.end());
    faces[position] = {nodes, side};
  });
}

/// Calls visit(face, is it another element's too?) for each face.
template <class Visit>
void for_each_keyed_face(const Mesh& mesh, Visit visit) {
  std::vector<std::size_t> row;
  std::vector<KeyedSide> faces;
  collect_faces(mesh, row, faces);
  for (std::size_t r = 0; r + 1 < row.size(); ++r)
    for (std::size_t i = row[r]; i < row[r + 1]; ++i) {
      bool shared = false;
      for (std::size_t j = row[r]; j < row[r + 1] && !shared; ++j) shared = j != i && faces[j].key == faces[i].key;
      visit(faces[i], shared);
    }
}

LocalIndex find_root(std::vector<LocalIndex>& parent, LocalIndex i) {
  while (parent[static_cast<std::size_t>(i)] != i) {
    auto& above = parent[static_cast<std::size_t>(i)];
    above = parent[static_cast<std::size_t>(above)];
    i = above;
  }
  return i;
}

}  // namespace

std::array<LocalIndex, 4> face_nodes(Shape shape, const LocalIndex* element, int face) {
  const auto& corners = shape == Shape::hex8 ? cells::hex_faces[static_cast<std::size_t>(face)]
                                             : cells::tet_faces[static_cast<std::size_t>(face)];
  std::array<LocalIndex, 4> nodes = no_face;
  std::size_t count = 0;
  for (const int corner : corners) {
    if (corner < 0) continue;
    const LocalIndex node = element[corner];
    if (std::find(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(count), node) ==
        nodes.begin() + static_cast<std::ptrdiff_t>(count))
      nodes[count++] = node;
  }
  return count < 3 ? no_face : nodes;
}

std::vector<Side> exterior_sides(const Mesh& mesh) {
  std::vector<Side> exterior;
  for_each_keyed_face(mesh, [&](const KeyedSide& face, bool shared) {
    if (!shared) exterior.push_back(face.side);
  });
  std::sort(exterior.begin(), exterior.end());
  return exterior;
}

std::vector<Side> interior_sides(const Mesh& mesh, std::span<const char> wanted) {
  std::vector<Side> interior;
  for_each_keyed_face(mesh, [&](const KeyedSide& face, bool shared) {
    const auto is_wanted = [&](LocalIndex node) {
      return node == no_index || wanted[static_cast<std::size_t>(node)] != 0;
    };
    if (shared && std::all_of(face.key.begin(), face.key.end(), is_wanted)) interior.push_back(face.side);
  });
  std::sort(interior.begin(), interior.end());
  return interior;
}

std::vector<std::int32_t> bodies(const Mesh& mesh) {
  std::vector<LocalIndex> parent(mesh.coordinates.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const Block& block : mesh.blocks)
    for (LocalIndex e = 0; e < block.count(); ++e)
      for (int k = 1; k < nodes_per_element(block.shape); ++k) {
        const LocalIndex a = find_root(parent, block.element(e)[0]);
        const LocalIndex b = find_root(parent, block.element(e)[k]);
        parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
      }
  std::vector<std::int32_t> number(mesh.coordinates.size(), -1), body;
  std::int32_t count = 0;
  for (const Block& block : mesh.blocks)
    for (LocalIndex e = 0; e < block.count(); ++e) {
      auto& component = number[static_cast<std::size_t>(find_root(parent, block.element(e)[0]))];
      if (component < 0) component = count++;
      body.push_back(component);
    }
  return body;
}

}  // namespace brunt::mesh
