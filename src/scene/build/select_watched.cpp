// SPDX-License-Identifier: Apache-2.0
#include "select_watched.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "scene/build/select.hpp"
#include "scene/text/units.hpp"

namespace brunt::scene {
namespace {

using Nodes = std::vector<LocalIndex>;

Nodes marked(const std::vector<char>& flags) {
  Nodes nodes;
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (flags[i]) nodes.push_back(static_cast<LocalIndex>(i));
  return nodes;
}

/// Calls visit(nodes of an element) for the elements of some parts.
template <class Visit>
void for_elements(const mesh::Mesh& mesh, std::span<const std::string> part_of_block,
                  const std::vector<std::string>& parts, Visit&& visit) {
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    if (std::ranges::find(parts, part_of_block[b]) == parts.end()) continue;
    const mesh::Block& block = mesh.blocks[b];
    const auto corners = static_cast<std::size_t>(mesh::nodes_per_element(block.shape));
    for (LocalIndex e = 0; e < block.count(); ++e) visit(std::span(block.element(e), corners));
  }
}

}  // namespace

void keep_nearest(const Probe& probe, const std::string& set, mesh::CanonicalMesh& whole) {
  const auto found = whole.mesh.node_sets.find(set);
  std::tuple<double, GlobalIndex, LocalIndex> best{std::numeric_limits<double>::infinity(), 0, no_index};
  const auto look = [&](LocalIndex node) {
    const auto i = static_cast<std::size_t>(node);
    const double distance = (whole.mesh.coordinates[i] + whole.origin - probe.point).norm();
    best = std::min(best, std::tuple{distance, whole.mesh.node_id[i], node});
  };
  if (found != whole.mesh.node_sets.end())
    for (const LocalIndex node : found->second) look(node);
  else
    for (std::size_t i = 0; i < whole.mesh.coordinates.size(); ++i) look(static_cast<LocalIndex>(i));
  if (std::get<2>(best) != no_index) whole.mesh.node_sets[set] = {std::get<2>(best)};
}

std::size_t make_section(const Probe& probe, std::size_t entry, std::span<const std::string> part_of_block,
                         double on_plane, mesh::CanonicalMesh& whole) {
  const std::string name = selection_name("probe", entry);
  const std::size_t count = whole.mesh.coordinates.size();
  std::vector<char> behind(count, 0), front(count, 0);
  if (probe.normal.isZero()) {
    for_elements(whole.mesh, part_of_block, probe.parts, [&](auto element) {
      for (const LocalIndex node : element) nth(behind, node) = 1;
    });
    const auto found = whole.mesh.node_sets.find(name);
    if (found == whole.mesh.node_sets.end()) return 0;
    Nodes& nodes = found->second;
    std::erase_if(nodes, [&](LocalIndex node) { return !nth(behind, node); });
    return nodes.size();
  }
  const auto in_front = [&](LocalIndex node) {
    const Vec3 X = nth(whole.mesh.coordinates, node) + whole.origin;
    return (X - probe.point).dot(probe.normal) > on_plane;
  };
  for_elements(whole.mesh, part_of_block, probe.parts, [&](auto element) {
    const auto ahead = std::ranges::count_if(element, in_front);
    if (ahead == 0 || ahead == static_cast<std::ptrdiff_t>(element.size())) return;
    for (const LocalIndex node : element) nth((in_front(node) ? front : behind), node) = 1;
  });
  whole.mesh.node_sets[name] = marked(behind);
  whole.mesh.node_sets[selection_name("front", entry)] = marked(front);
  return whole.mesh.node_sets[name].size();
}

std::vector<std::string> nearest_nodes(const Input& input, const mesh::CanonicalMesh& whole) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < input.probes.size(); ++k) {
    const Probe& probe = input.probes[k];
    if (probe.kind != Probe::Kind::near) continue;
    const auto node = static_cast<std::size_t>(whole.mesh.node_sets.at(selection_name("probe", k)).front());
    const Vec3 X = whole.mesh.coordinates[node] + whole.origin;
    lines.push_back(fmt::format("probe {}: node {} at ({:g}, {:g}, {:g}), at a distance of {} from the given point",
                                probe.name, whole.mesh.node_id[node], X[0], X[1], X[2],
                                with_length((X - probe.point).norm(), input.units)));
  }
  return lines;
}

void make_interface(mesh::CanonicalMesh& whole) {
  std::vector<std::int32_t> first(whole.mesh.coordinates.size(), -1);
  std::vector<char> several(first.size(), 0);
  for (std::size_t b = 0; b < whole.mesh.blocks.size(); ++b)
    for (const LocalIndex node : whole.mesh.blocks[b].nodes) {
      const auto i = static_cast<std::size_t>(node);
      if (first[i] < 0) first[i] = static_cast<std::int32_t>(b);
      if (first[i] != static_cast<std::int32_t>(b)) several[i] = 1;
    }
  whole.mesh.node_sets[interface_set] = marked(several);
}

}  // namespace brunt::scene
