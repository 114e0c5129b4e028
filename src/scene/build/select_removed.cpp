// SPDX-License-Identifier: Apache-2.0
#include "select_removed.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/excerpt.hpp"
#include "mesh/topology.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/build/select.hpp"

namespace brunt::scene {
namespace {

/// The part to which the selection is restricted: the part of that name, or that of a set with `part`; empty: none.
std::string part_of_selection(const Input& input, const std::string& where) {
  if (std::ranges::find(input.parts, where, &Part::name) != input.parts.end()) return where;
  const auto set = std::ranges::find(input.sets, where, &SetEntry::name);
  return set != input.sets.end() ? set->part.value_or("") : "";
}

bool has_all(std::span<const LocalIndex> set, std::span<const LocalIndex> nodes) {
  return std::ranges::all_of(nodes, [&](LocalIndex node) { return std::ranges::binary_search(set, node); });
}

/// Whether any deformable element of the selection has all its nodes in the set. `nodes` ascending.
bool holds_element(const Input& input, const mesh::Mesh& mesh, std::span<const std::string> part_of_block,
                   const std::string& where, std::span<const LocalIndex> nodes) {
  const std::string part = part_of_selection(input, where);
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const mesh::Block& block = mesh.blocks[b];
    if ((!part.empty() && part_of_block[b] != part) || names_rigid_part(input, part_of_block[b])) continue;
    const auto corners = static_cast<std::size_t>(mesh::nodes_per_element(block.shape));
    for (LocalIndex e = 0; e < block.count(); ++e)
      if (has_all(nodes, {block.element(e), corners})) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> select_removed(const Input& input, mesh::CanonicalMesh& whole) {
  std::vector<std::string> faults, part_of_block;
  const auto erodes = [](const Part& part) { return part.erosion.has_value(); };
  if (input.remove.empty() && std::ranges::none_of(input.parts, erodes)) return faults;
  for (const std::size_t part : parts_of_blocks(input, whole.mesh)) part_of_block.push_back(input.parts[part].name);
  std::vector<char> removed(whole.mesh.coordinates.size(), 0);
  for (std::size_t b = 0; b < whole.mesh.blocks.size(); ++b)
    if (erodes(*std::ranges::find(input.parts, part_of_block[b], &Part::name)))
      for (const GlobalIndex node : whole.mesh.blocks[b].nodes) nth(removed, node) = 1;
  for (std::size_t k = 0; k < input.remove.size(); ++k) {
    const std::string &where = input.remove[k].where, part = fmt::format("remove.{}.part", k);
    const std::string key = input.at(input.places.has(part) ? part : fmt::format("remove.{}.set", k));
    const auto set = whole.mesh.node_sets.find(selection_name("remove", k));
    if (set == whole.mesh.node_sets.end() || set->second.empty()) continue;  // already reported
    if (names_rigid_part(input, where))
      faults.push_back(fmt::format("{}: invalid part '{}': a rigid part is not removed; expected deformable parts", key,
                                   excerpt(where)));
    else if (!holds_element(input, whole.mesh, part_of_block, where, set->second))
      faults.push_back(
          fmt::format("{}: invalid selection: '{}' contains no complete deformable element; expected a set with all "
                      "nodes of at least one element",
                      key, excerpt(where)));
    for (const LocalIndex node : set->second) nth(removed, node) = 1;
  }
  whole.mesh.side_sets[mesh::inner_faces] = mesh::interior_sides(whole.mesh, removed);
  return faults;
}

void build_removals(const Input& input, model::Model& model) {
  for (std::size_t k = 0; k < input.remove.size(); ++k) {
    const Removal& entry = input.remove[k];
    const std::string part = part_of_selection(input, entry.where);
    const std::vector<LocalIndex>& nodes = model.mesh.node_sets.at(selection_name("remove", k));
    model.losses.uncovered.insert(model.losses.uncovered.end(), nodes.begin(), nodes.end());
    model::Removal removal{entry.at, entry.keeps_nodes, {}};
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
      const mesh::LocalBlock& block = model.mesh.blocks[b];
      std::vector<LocalIndex>& elements = removal.elements.emplace_back();
      if ((!part.empty() && model.blocks[b].part != part) || material::is_rigid(model.blocks[b].law)) continue;
      const auto corners = static_cast<std::size_t>(model.blocks[b].corners());
      for (LocalIndex e = 0; e < model.blocks[b].count; ++e)
        if (has_all(nodes, {&block.nodes[static_cast<std::size_t>(e) * corners], corners})) elements.push_back(e);
    }
    model.losses.removals.push_back(std::move(removal));
  }
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    if (model.blocks[b].erosion)
      model.losses.uncovered.insert(model.losses.uncovered.end(), model.mesh.blocks[b].nodes.begin(),
                                    model.mesh.blocks[b].nodes.end());
  std::ranges::stable_sort(model.losses.removals, {}, &model::Removal::at);
  std::ranges::sort(model.losses.uncovered);
  model.losses.uncovered.erase(std::unique(model.losses.uncovered.begin(), model.losses.uncovered.end()),
                               model.losses.uncovered.end());
}

}  // namespace brunt::scene
