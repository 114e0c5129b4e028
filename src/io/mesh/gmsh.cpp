// SPDX-License-Identifier: Apache-2.0
// From a Gmsh file's elements and groups to blocks and sets.
#include "io/mesh/gmsh.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "core/cells.hpp"
#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "gmsh_sections.hpp"
#include "left_out.hpp"
#include "mesh/topology.hpp"
#include "set_words.hpp"
#include "sound_mesh.hpp"

namespace brunt::io {
namespace {

using mesh::Block;
using mesh::Mesh;
using mesh::Shape;
using mesh::Side;
using FaceKey = std::array<LocalIndex, 4>;

/// Volume elements, or shells, of one physical group (or, without one, of one entity) and one shape.
struct VolumeKey {
  bool grouped;
  std::int64_t number;
  Shape shape;
  auto operator<=>(const VolumeKey&) const = default;
};

VolumeKey volume_of(const GmshElement& element) {
  const bool grouped = element.physical != 0;
  return {grouped, grouped ? element.physical : element.entity, cells::shape_with(element.corners)};
}

std::string group_name(const GmshFile& file, int dimension, std::int64_t number) {
  const auto found = file.name.find({dimension, number});
  return found == file.name.end() ? "" : found->second;
}

/// The surfaces whose elements are shells, by (in a group?, number of the group or entity).
using ShellSurfaces = std::set<std::pair<bool, std::int64_t>>;

std::pair<bool, std::int64_t> group_of(const GmshElement& element) {
  const bool grouped = element.physical != 0;
  return {grouped, grouped ? element.physical : element.entity};
}

/// Physical groups in ascending number first, then entities outside them.
void add_blocks(const GmshFile& file, Mesh& mesh) {
  std::map<VolumeKey, std::size_t> position;
  std::int64_t last_id = 0;
  for (const GmshElement& element : file.elements)
    if (element.dimension == 3 && element.corners > 0) {
      position[volume_of(element)] = 0;
      last_id = std::max(last_id, element.physical);
    }
  std::vector<VolumeKey> order;
  order.reserve(position.size());
  for (const auto& [key, unused] : position) order.push_back(key);
  std::sort(order.begin(), order.end(), [](const VolumeKey& a, const VolumeKey& b) {
    return std::tuple(!a.grouped, a.number, a.shape) < std::tuple(!b.grouped, b.number, b.shape);
  });
  for (const VolumeKey& key : order) {
    position[key] = mesh.blocks.size();
    Block block;
    block.name = key.grouped ? group_name(file, 3, key.number) : fmt::format("volume_{}", key.number);
    block.shape = key.shape;
    const bool second = key.shape == Shape::tet4 && position.count({key.grouped, key.number, Shape::hex8});
    block.id = key.grouped && !second ? key.number : ++last_id;
    if (second) block.name = fmt::format("{}_tet4", block.name.empty() ? std::to_string(key.number) : block.name);
    mesh.blocks.push_back(std::move(block));
  }
  for (const GmshElement& element : file.elements) {
    if (element.dimension != 3 || element.corners == 0) continue;
    Block& block = mesh.blocks[position[volume_of(element)]];
    const auto corners = hex_corners(element.corners);
    for (int k = 0; k < mesh::nodes_per_element(block.shape); ++k)
      block.nodes.push_back(nth(element.nodes, nth(corners, k)));
    block.element_id.push_back(element.number);
  }
}

FaceKey sorted(FaceKey nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

FaceKey surface_nodes(const GmshElement& element) {
  return {element.nodes[0], element.nodes[1], element.nodes[2], element.corners == 4 ? element.nodes[3] : no_index};
}

/// Does b run round the face in the same sense as a? Both have the same nodes.
bool same_sense(const FaceKey& a, const FaceKey& b) {
  const std::size_t count = cells::corner_count(a);
  const auto start = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
  return b[(start + 1) % count] == a[1];
}

/// Of a physical surface; others bound entities and say nothing.
bool is_surface(const GmshElement& element) {
  return element.dimension == 2 && element.physical != 0 && element.corners > 0;
}

/// Blocks of the shells of each surface and shape, in the order of the surfaces; its tops are a side set.
void add_shells(const GmshFile& file, const ShellSurfaces& shells, Mesh& mesh) {
  std::map<std::tuple<std::pair<bool, std::int64_t>, Shape>, std::size_t> position;
  const auto key_of = [](const GmshElement& element) {
    return std::tuple(group_of(element), element.corners == 3 ? Shape::tri3 : Shape::quad4);
  };
  const auto is_shell = [&](const GmshElement& element) {
    return element.dimension == 2 && element.corners > 0 && shells.contains(group_of(element));
  };
  for (const GmshElement& element : file.elements)
    if (is_shell(element)) position[key_of(element)] = 0;
  GlobalIndex last_id = 0;
  for (const Block& block : mesh.blocks) last_id = std::max(last_id, block.id);
  for (const auto& [in_group, number] : shells)
    if (in_group) last_id = std::max(last_id, number);
  for (auto& [key, at] : position) {
    const auto& [surface, shape] = key;
    const auto& [grouped, number] = surface;
    at = mesh.blocks.size();
    Block block;
    block.name = grouped ? group_name(file, 2, number) : fmt::format("surface_{}", number);
    block.shape = shape;
    const bool second = shape == Shape::tri3 && position.contains({surface, Shape::quad4});
    const bool taken = std::ranges::find(mesh.blocks, number, &Block::id) != mesh.blocks.end();
    block.id = grouped && !second && !taken ? number : ++last_id;
    if (second) block.name = fmt::format("{}_tri3", block.name.empty() ? std::to_string(number) : block.name);
    mesh.blocks.push_back(std::move(block));
  }
  for (const GmshElement& element : file.elements) {
    if (!is_shell(element)) continue;
    Block& block = mesh.blocks[position[key_of(element)]];
    block.nodes.insert(block.nodes.end(), element.nodes.begin(), element.nodes.begin() + element.corners);
    block.element_id.push_back(element.number);
  }
}

/// The element side that a surface element lies on, found by its nodes; block -1 where there is none.
class SideFinder {
 public:
  SideFinder(const GmshFile& file, const Mesh& mesh) {
    for (const GmshElement& element : file.elements)
      if (is_surface(element)) sides_[sorted(surface_nodes(element))];
    for (std::size_t b = 0; !sides_.empty() && b < mesh.blocks.size(); ++b) {
      const Block& block = mesh.blocks[b];
      for (LocalIndex e = 0; e < block.count(); ++e)
        for (int f = 0; f < mesh::faces_per_element(block.shape); ++f) {
          const FaceKey nodes = mesh::face_nodes(block.shape, block.element(e), f);
          const auto found = sides_.find(sorted(nodes));
          if (found != sides_.end()) found->second.push_back({nodes, {static_cast<LocalIndex>(b), e, f}});
        }
    }
  }

  [[nodiscard]] Side side_of(const GmshElement& element) const {
    const FaceKey nodes = surface_nodes(element);
    const auto& candidates = sides_.at(sorted(nodes));
    for (const auto& [face, side] : candidates)
      if (same_sense(nodes, face)) return side;
    return candidates.empty() ? Side{-1, 0, 0} : candidates.front().second;
  }

 private:
  std::map<FaceKey, std::vector<std::pair<FaceKey, Side>>> sides_;
};

std::string type_name(const GmshElement& element) {
  if (element.corners == 0) return fmt::format("type {}", element.type);
  return element.corners == 3 ? "triangle" : "quadrilateral";
}

/// Blocks that are no blocks of the mesh, gathered element by element.
class ForeignBlocks {
 public:
  ForeignBlocks(const LineReader& in, const GmshFile& file, const std::map<std::int64_t, std::string>& set_word)
      : in_(in), file_(file), set_word_(set_word) {}

  /// `fault`: why the element cannot be read; empty where it can.
  void add(const GmshElement& element, const std::string& fault) {
    const bool grouped = element.physical != 0;
    const std::int64_t number = grouped ? element.physical : element.entity;
    const auto [found, is_new] =
        at_.try_emplace({element.dimension, grouped, number, type_name(element)}, blocks_.size());
    if (is_new) {
      ForeignBlock& block = blocks_.emplace_back();
      block.name = grouped ? group_name(file_, element.dimension, number) : fmt::format("volume_{}", number);
      block.id = grouped ? number : 0;
      block.type = type_name(element);
      block.dimension = element.dimension;
      if (element.dimension == 2) block.own_sets = set_word_.at(number);
    }
    ForeignBlock& block = blocks_[found->second];
    ++block.count;
    if (block.fault.empty() && !fault.empty()) block.fault = in_.place(element.line) + ": " + fault;
  }

  /// Groups of lines and points are passed over, ignored or not.
  std::vector<ForeignBlock> take() {
    for (const auto& [key, name] : file_.name)
      if (key.first < 2) blocks_.push_back({.name = name, .id = key.second, .dimension = key.first});
    return std::move(blocks_);
  }

 private:
  const LineReader& in_;
  const GmshFile& file_;
  const std::map<std::int64_t, std::string>& set_word_;
  std::vector<ForeignBlock> blocks_;
  std::map<std::tuple<int, bool, std::int64_t, std::string>, std::size_t> at_;
};

/// A surface is of shells if none of its elements is the face of a volume element. Surfaces outside of groups count
/// only in a file that has neither volumes nor groups of surfaces.
ShellSurfaces shell_surfaces(const GmshFile& file, const SideFinder& finder) {
  const auto any = [&](auto&& is) { return std::ranges::any_of(file.elements, is); };
  const bool volumes = any([](const GmshElement&e) { return e.dimension == 3; }), groups = any(is_surface);
  ShellSurfaces shells, faces;
  for (const GmshElement& element : file.elements) {
    if (element.dimension != 2 || element.corners == 0 || (element.physical == 0 && (volumes || groups))) continue;
    const bool on_volume = volumes && finder.side_of(element).block >= 0;
    (on_volume ? faces : shells).insert(group_of(element));
  }
  for (const auto& surface : faces) shells.erase(surface);
  return shells;
}

/// Physical lines are node sets, in files with shells.
void add_lines(const GmshFile& file, Mesh& mesh) {
  std::map<std::int64_t, std::set<LocalIndex>> nodes;
  for (const GmshElement& element : file.elements)
    if (element.dimension == 1) nodes[element.physical].insert(element.nodes.begin(), element.nodes.begin() + 2);
  std::vector<FileSet> sets;
  for (const auto& [number, unused] : nodes) sets.push_back({number, group_name(file, 1, number)});
  const std::vector<std::string> words = set_words("physical curve", sets, mesh.notes);
  for (std::size_t k = 0; k < sets.size(); ++k) {
    const std::set<LocalIndex>& found = nodes.at(sets[k].number);
    if (!mesh.node_sets.try_emplace(words[k], found.begin(), found.end()).second)
      mesh.notes.push_back(
          fmt::format("physical curve {}: it is not read, since a surface has the same name", excerpt(words[k])));
  }
}

/// Words of the physical surfaces that have elements, by their numbers.
std::map<std::int64_t, std::string> surface_words(const GmshFile& file, std::vector<std::string>& notes) {
  std::map<std::int64_t, std::string> word;
  for (const GmshElement& element : file.elements)
    if (element.dimension == 2 && element.physical != 0) word[element.physical] = {};
  std::vector<FileSet> sets;
  for (const auto& [number, unused] : word) sets.push_back({number, group_name(file, 2, number)});
  const std::vector<std::string> words = set_words("physical surface", sets, notes);
  for (std::size_t k = 0; k < sets.size(); ++k) word[sets[k].number] = words[k];
  return word;
}

void add_sets(const LineReader& in, const GmshFile& file, FileContent& content) {
  const SideFinder of_volumes(file, content.mesh);
  const ShellSurfaces shells = shell_surfaces(file, of_volumes);
  add_shells(file, shells, content.mesh);
  const SideFinder finder = shells.empty() ? of_volumes : SideFinder(file, content.mesh);
  const std::map<std::int64_t, std::string> set_word = surface_words(file, content.mesh.notes);
  ForeignBlocks foreign(in, file, set_word);
  const std::string of_order = fmt::format(" (of second order, or not supported); expected {}", gmsh_element_types);
  std::map<std::string, std::set<LocalIndex>> nodes;
  for (const GmshElement& element : file.elements) {
    const bool read = element.corners > 0;
    if (element.dimension < 2) continue;
    if (!read && (element.dimension == 3 || element.physical != 0))
      foreign.add(element, fmt::format("invalid element type {}{}", element.type, of_order));
    if (!is_surface(element)) continue;
    const Side side = finder.side_of(element);
    if (side.block < 0) {
      foreign.add(
          element,
          fmt::format("invalid surface element {}: not a face of a volume element; expected faces of volume elements",
                      element.number));
      continue;
    }
    if (!shells.contains(group_of(element))) foreign.add(element, "");
    const std::string& name = set_word.at(element.physical);
    content.mesh.side_sets[name].push_back(side);
    nodes[name].insert(element.nodes.begin(), element.nodes.begin() + element.corners);
  }
  for (const auto& [name, set] : nodes) content.mesh.node_sets[name].assign(set.begin(), set.end());
  if (!shells.empty()) add_lines(file, content.mesh);
  content.foreign = foreign.take();
}

}  // namespace

Mesh read_gmsh(const std::string& path, const std::vector<std::string>& ignore) {
  LineReader in(path);
  GmshFile file = read_gmsh_sections(in);
  FileContent content;
  content.mesh.coordinates = std::move(file.coordinates);
  content.mesh.node_id.assign(file.node_number.begin(), file.node_number.end());
  add_blocks(file, content.mesh);
  add_sets(in, file, content);
  const bool foreign_volume = std::ranges::any_of(content.foreign, [](const auto& b) { return b.dimension == 3; });
  if (content.mesh.blocks.empty() && !foreign_volume)
    throw InputError(
        path +
        ": missing volume elements and shells; expected tetrahedra, hexahedra, prisms or pyramids, or triangles "
        "or quadrilaterals of shells");
  return leave_out(path, std::move(content), ignore);
}

}  // namespace brunt::io
