// SPDX-License-Identifier: Apache-2.0
#include "named_nodes.hpp"

#include <algorithm>

#include "core/sorted.hpp"
#include "mesh/topology.hpp"
#include "scene/build/select.hpp"

namespace brunt::scene {
NamedNodes::NamedNodes(const Input& input, const mesh::CanonicalMesh& whole) : input_(input), whole_(whole) {
  for (const std::size_t part : parts_of_blocks(input, whole.mesh)) part_of_block_.push_back(input.parts[part].name);
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const Vec3& X : whole.mesh.coordinates) {
    low = low.cwiseMin(X);
    high = high.cwiseMax(X);
  }
  on_plane_ = 1e-9 * (high - low).norm();
}

NamedNodes::Nodes NamedNodes::of_part(const std::string& part) const {
  std::vector<char> touched(whole_.mesh.coordinates.size(), 0);
  for (std::size_t b = 0; b < part_of_block_.size(); ++b)
    if (part_of_block_[b] == part)
      for (const LocalIndex node : whole_.mesh.blocks[b].nodes) nth(touched, node) = 1;
  Nodes nodes;
  nodes.reserve(static_cast<std::size_t>(std::ranges::count(touched, 1)));
  for (std::size_t i = 0; i < touched.size(); ++i)
    if (touched[i] != 0) nodes.push_back(static_cast<LocalIndex>(i));
  return nodes;
}

NamedNodes::Nodes NamedNodes::of_sides(const std::vector<mesh::Side>& sides) const {
  Nodes nodes;
  for (const mesh::Side& side : sides) {
    const mesh::Block& block = nth(whole_.mesh.blocks, side.block);
    for (const LocalIndex node : mesh::face_nodes(block.shape, block.element(side.element), side.face))
      if (node != no_index) nodes.push_back(node);
  }
  sort_unique(nodes);
  return nodes;
}

std::optional<NamedNodes::Nodes> NamedNodes::of(const std::string& where) const {
  if (std::ranges::find(part_of_block_, where) != part_of_block_.end()) return of_part(where);
  for (const SetEntry& set : input_.sets)
    if (set.name == where) return of_entry(set);
  return of_mesh_set(where);
}

bool NamedNodes::is_two_sets(const std::string& where) const {
  const bool other = std::ranges::find(part_of_block_, where) != part_of_block_.end() ||
                     std::ranges::find(input_.sets, where, &SetEntry::name) != input_.sets.end();
  const auto set = whole_.mesh.node_sets.find(where);
  const auto sides = whole_.mesh.side_sets.find(where);
  if (other || set == whole_.mesh.node_sets.end() || sides == whole_.mesh.side_sets.end()) return false;
  Nodes nodes = set->second;
  sort_unique(nodes);
  return nodes != of_sides(sides->second);
}

std::optional<NamedNodes::Nodes> NamedNodes::of_mesh_set(const std::string& where) const {
  Nodes nodes;
  if (const auto set = whole_.mesh.node_sets.find(where); set != whole_.mesh.node_sets.end()) {
    nodes = set->second;
    sort_unique(nodes);
    return nodes;
  }
  if (const auto set = whole_.mesh.side_sets.find(where); set != whole_.mesh.side_sets.end())
    return of_sides(set->second);
  return std::nullopt;
}

std::optional<NamedNodes::Nodes> NamedNodes::of_entry(const SetEntry& set) const {
  std::optional<Nodes> nodes;
  if (set.part) {
    if (std::ranges::find(part_of_block_, *set.part) == part_of_block_.end()) return std::nullopt;
    nodes = of_part(*set.part);
  }
  if (set.node_set) {
    const auto found = whole_.mesh.node_sets.find(*set.node_set);
    if (found == whole_.mesh.node_sets.end()) return std::nullopt;
    nodes = found->second;
    sort_unique(*nodes);
  }
  if (set.side_set) {  // a node set may have the same number
    const auto found = whole_.mesh.side_sets.find(*set.side_set);
    if (found == whole_.mesh.side_sets.end()) return std::nullopt;
    nodes = of_sides(found->second);
  }
  if (!set.box) return nodes;
  if (!nodes) {
    nodes.emplace(whole_.mesh.coordinates.size());
    for (std::size_t i = 0; i < nodes->size(); ++i) (*nodes)[i] = static_cast<LocalIndex>(i);
  }
  std::erase_if(*nodes, [&](LocalIndex node) {
    const Vec3 X = nth(whole_.mesh.coordinates, node) + whole_.origin;
    const Vec3 slack = Vec3::Constant(on_plane_);  // so that a box drawn on the nodes holds them
    return ((*set.box)[0] - slack - X).maxCoeff() > 0 || (X - (*set.box)[1] - slack).maxCoeff() > 0;
  });
  return nodes;
}

}  // namespace brunt::scene
