// SPDX-License-Identifier: Apache-2.0
// Faces of elements, the outside of a mesh, connected bodies.
#include "mesh/topology.hpp"

#include <algorithm>

#include "core/union_find.hpp"
#include "face_corners.hpp"
#include "mesh/face_rows.hpp"

namespace brunt::mesh {
namespace {

/// Calls visit(face, its side, is it another element's too?) for each face. A shell that covers a solid element shares
/// nothing: it is the exterior.
template <class Visit>
void for_each_keyed_face(const Mesh& mesh, Visit visit) {
  const FaceRows rows(mesh);
  rows.for_each_row([&](std::span<const KeyedFace> row) {
    for (const KeyedFace& face : row) {
      const auto sharers =
          std::ranges::count_if(row, [&](const KeyedFace& other) { return &other != &face && other.same_nodes(face); });
      const Side side = rows.side(face);
      const bool shell = cells::is_surface(nth(mesh.blocks, side.block).shape);
      visit(face, side, sharers >= (shell ? 2 : 1));
    }
  });
}

}  // namespace

std::array<LocalIndex, 4> face_nodes(Shape shape, const LocalIndex* element, int face) {
  return corners_of_face(shape, element, face);
}

std::vector<Side> exterior_sides(const Mesh& mesh) {
  std::vector<Side> exterior;
  for_each_keyed_face(mesh, [&](const KeyedFace&, const Side& side, bool shared) {
    if (!shared) exterior.push_back(side);
  });
  std::sort(exterior.begin(), exterior.end());
  return exterior;
}

std::vector<Side> interior_sides(const Mesh& mesh, std::span<const char> wanted) {
  std::vector<Side> interior;
  for_each_keyed_face(mesh, [&](const KeyedFace& face, const Side& side, bool shared) {
    const auto is_wanted = [&](LocalIndex node) { return node == no_index || nth(wanted, node) != 0; };
    if (shared && std::all_of(face.key.begin(), face.key.end(), is_wanted)) interior.push_back(side);
  });
  std::sort(interior.begin(), interior.end());
  return interior;
}

std::vector<std::int32_t> bodies(const Mesh& mesh) {
  UnionFind joined(mesh.coordinates.size());
  const auto node = [](const LocalIndex* element, int k) { return static_cast<std::size_t>(element[k]); };
  for (const Block& block : mesh.blocks)
    for (LocalIndex e = 0; e < block.count(); ++e)
      for (int k = 1; k < nodes_per_element(block.shape); ++k)
        joined.join(node(block.element(e), 0), node(block.element(e), k));
  std::vector<std::int32_t> number(mesh.coordinates.size(), -1), body;
  std::int32_t count = 0;
  std::size_t elements = 0;
  for (const Block& block : mesh.blocks) elements += static_cast<std::size_t>(block.count());
  body.reserve(elements);
  for (const Block& block : mesh.blocks)
    for (LocalIndex e = 0; e < block.count(); ++e) {
      auto& component = number[joined.first(node(block.element(e), 0))];
      if (component < 0) component = count++;
      body.push_back(component);
    }
  return body;
}

}  // namespace brunt::mesh
