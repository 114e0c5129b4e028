// SPDX-License-Identifier: Apache-2.0
// Elements along a Hilbert curve, nodes by first touch, coordinates from a rounded origin.
#include "mesh/canonical.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "hilbert.hpp"

namespace brunt::mesh {
namespace {

struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  [[nodiscard]] double size() const { return (high - low).maxCoeff(); }
};

Box bounding_box(const Mesh& mesh) {
  Box box;
  for (const Block& block : mesh.blocks)
    for (const LocalIndex n : block.nodes) {
      box.low = box.low.cwiseMin(nth(mesh.coordinates, n));
      box.high = box.high.cwiseMax(nth(mesh.coordinates, n));
    }
  return box;
}

/// With |centre| >= 8 sizes and the origin within one size of it, x and the origin are within a factor of two of each
/// other, so x - origin is exact (Sterbenz' lemma), and so is adding it back.
Vec3 rounded_origin(const Box& box) {
  Vec3 origin = Vec3::Zero();
  const double size = box.size();
  if (!(size > 0)) return origin;
  const double spacing = std::exp2(std::ceil(std::log2(size)));
  for (int i = 0; i < 3; ++i) {
    const double centre = 0.5 * (box.low[i] + box.high[i]);
    if (std::abs(centre) >= 8 * size) origin[i] = spacing * std::round(centre / spacing);
  }
  return origin;
}

std::uint64_t curve_position(const Mesh& mesh, const Block& block, LocalIndex e, const Box& box) {
  const int corners = nodes_per_element(block.shape);
  Vec3 centroid = Vec3::Zero();
  for (int k = 0; k < corners; ++k) centroid += (nth(mesh.coordinates, block.element(e)[k]) - box.low) / corners;
  constexpr double cells = std::uint32_t{1} << hilbert_bits;
  const double size = box.size();
  std::array<std::uint32_t, 3> cell{};
  for (int i = 0; i < 3; ++i)
    nth(cell, i) = size > 0 ? static_cast<std::uint32_t>(std::clamp(centroid[i] / size * cells, 0.0, cells - 1)) : 0;
  return hilbert_position(cell);
}

/// Old positions of the block's elements in their new order.
std::vector<LocalIndex> curve_order(const Mesh& mesh, const Block& block, const Box& box) {
  std::vector<std::uint64_t> position(static_cast<std::size_t>(block.count()));
  for (LocalIndex e = 0; e < block.count(); ++e) nth(position, e) = curve_position(mesh, block, e, box);
  std::vector<LocalIndex> order(position.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](LocalIndex a, LocalIndex b) { return nth(position, a) < nth(position, b); });
  return order;
}

Block reordered(const Block& block, const std::vector<LocalIndex>& order) {
  Block result{block.name, block.id, block.shape, {}, {}, block.file_id};
  result.nodes.reserve(block.nodes.size());
  result.element_id.reserve(order.size());
  for (const LocalIndex e : order) {
    const LocalIndex* nodes = block.element(e);
    result.nodes.insert(result.nodes.end(), nodes, nodes + nodes_per_element(block.shape));
    result.element_id.push_back(nth(block.element_id, e));
  }
  return result;
}

template <class T>
std::vector<T> inverse(const std::vector<T>& order) {
  std::vector<T> position(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) nth(position, order[i]) = static_cast<T>(i);
  return position;
}

/// Reorders the elements of each block; side sets follow.
void order_elements(CanonicalMesh& result) {
  Mesh& mesh = result.mesh;
  const Box box = bounding_box(mesh);
  std::vector<std::vector<LocalIndex>> position;
  GlobalIndex first = 0;
  for (Block& block : mesh.blocks) {
    const auto order = curve_order(mesh, block, box);
    auto& input = result.input_element.emplace_back(order.begin(), order.end());
    for (auto& e : input) e += first;
    first += block.count();
    block = reordered(block, order);
    position.push_back(inverse(order));
  }
  for (auto& [name, sides] : mesh.side_sets) {
    for (Side& side : sides) side.element = nth(nth(position, side.block), side.element);
    std::sort(sides.begin(), sides.end());
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  }
}

/// Reorders the nodes by first touch; elements and node sets follow.
void order_nodes(CanonicalMesh& result) {
  Mesh& mesh = result.mesh;
  std::vector<LocalIndex> position(mesh.coordinates.size(), no_index);
  std::vector<Vec3> coordinates;
  std::vector<GlobalIndex> id;
  for (Block& block : mesh.blocks)
    for (LocalIndex& node : block.nodes) {
      const auto old = static_cast<std::size_t>(node);
      if (position[old] == no_index) {
        position[old] = static_cast<LocalIndex>(coordinates.size());
        coordinates.emplace_back(mesh.coordinates[old] - result.origin);
        id.push_back(mesh.node_id[old]);
        result.input_node.push_back(node);
      }
      node = position[old];
    }
  mesh.coordinates = std::move(coordinates);
  mesh.node_id = std::move(id);
  for (auto& [name, nodes] : mesh.node_sets) {
    for (LocalIndex& node : nodes) node = nth(position, node);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
}

}  // namespace

LocalIndex drop_unused_nodes(Mesh& mesh) {
  std::vector<LocalIndex> position(mesh.coordinates.size(), no_index);
  for (const Block& block : mesh.blocks)
    for (const LocalIndex node : block.nodes) nth(position, node) = 0;
  LocalIndex kept = 0;
  for (std::size_t n = 0; n < position.size(); ++n) {
    if (position[n] == no_index) continue;
    nth(mesh.coordinates, kept) = mesh.coordinates[n];
    nth(mesh.node_id, kept) = mesh.node_id[n];
    position[n] = kept++;
  }
  const auto dropped = static_cast<LocalIndex>(position.size()) - kept;
  if (dropped == 0) return 0;
  mesh.coordinates.resize(static_cast<std::size_t>(kept));
  mesh.node_id.resize(static_cast<std::size_t>(kept));
  for (Block& block : mesh.blocks)
    for (LocalIndex& node : block.nodes) node = nth(position, node);
  for (auto& [name, nodes] : mesh.node_sets) {
    for (LocalIndex& node : nodes) node = nth(position, node);
    std::erase(nodes, no_index);
  }
  return dropped;
}

CanonicalMesh canonical_order(Mesh&& mesh) {
  drop_unused_nodes(mesh);
  CanonicalMesh result{std::move(mesh), Vec3::Zero(), {}, {}};
  result.origin = rounded_origin(bounding_box(result.mesh));
  order_elements(result);
  order_nodes(result);
  return result;
}

}  // namespace brunt::mesh
