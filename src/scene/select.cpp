// SPDX-License-Identifier: Apache-2.0
#include "brunt/scene/select.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "brunt/core/error.hpp"
#include "brunt/mesh/topology.hpp"
#include "brunt/scene/nearest.hpp"

namespace brunt::scene {
namespace {

using Nodes = std::vector<LocalIndex>;

void sort_unique(Nodes& nodes) {
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

/// The whole mesh with the names that a scene may use for its nodes and sides.
class Selector {
 public:
  Selector(const Input& input, mesh::CanonicalMesh& whole, std::vector<std::string>& faults)
      : input_(input), whole_(whole), faults_(faults) {
    for (const std::size_t part : parts_of_blocks(input, whole.mesh)) part_of_block_.push_back(input.parts[part].name);
    Vec3 low = Vec3::Constant(1e300), high = -low;
    for (const Vec3& X : whole.mesh.coordinates) {
      low = low.cwiseMin(X);
      high = high.cwiseMax(X);
    }
    on_plane_ = 1e-9 * (high - low).norm();
  }

  void add_nodes(const std::string& reserved, const std::string& where, const std::string& key) {
    std::optional<Nodes> found = nodes_of(where);
    if (!found) return unknown(where, key);
    if (found->empty()) faults_.push_back(fmt::format("{}: {}: '{}' selects no node", input_.file, key, where));
    whole_.mesh.node_sets[reserved] = std::move(*found);
  }

  void add_sides(const std::string& reserved, const std::string& where, const std::string& key) {
    std::string name = where;
    for (const SetEntry& set : input_.sets)
      if (set.name == where && set.side_set) name = *set.side_set;
    const auto found = whole_.mesh.side_sets.find(name);
    if (found == whole_.mesh.side_sets.end()) {
      faults_.push_back(fmt::format("{}: {}: no side set '{}'; side sets: {}", input_.file, key, where,
                                    names(whole_.mesh.side_sets)));
      return;
    }
    if (found->second.empty())
      faults_.push_back(fmt::format("{}: {}: side set '{}' has no side", input_.file, key, where));
    whole_.mesh.side_sets[reserved] = found->second;
  }

  void add_plane(const std::string& reserved, const Vec3& point, const Vec3& normal, const std::string& key,
                 bool must_hold) {
    Nodes nodes;
    for (std::size_t i = 0; i < whole_.mesh.coordinates.size(); ++i)
      if (std::abs((whole_.mesh.coordinates[i] - (point - whole_.origin)).dot(normal.normalized())) <= on_plane_)
        nodes.push_back(static_cast<LocalIndex>(i));
    if (nodes.empty() && must_hold)
      faults_.push_back(fmt::format("{}: {}: no node lies in this plane", input_.file, key));
    whole_.mesh.node_sets[reserved] = std::move(nodes);
  }

  /// No body starts on both sides of a wall: its nodes behind would be held there for the whole run. (A body that lies
  /// behind as a whole never meets the wall.)
  void require_one_side(const RigidWall& wall, const std::string& key) {
    const std::vector<std::int32_t> body = mesh::bodies(whole_.mesh);
    std::map<std::int32_t, std::array<double, 2>> range;  // of the height over the wall
    std::size_t element = 0;
    for (const mesh::Block& block : whole_.mesh.blocks)
      for (LocalIndex e = 0; e < block.count(); ++e, ++element)
        for (int c = 0; c < mesh::nodes_per_element(block.shape); ++c) {
          const Vec3& X = whole_.mesh.coordinates[static_cast<std::size_t>(block.element(e)[c])];
          const double height = (X + whole_.origin - wall.point).dot(wall.normal.normalized());
          auto& [lowest, highest] = range.try_emplace(body[element], std::array{height, height}).first->second;
          lowest = std::min(lowest, height);
          highest = std::max(highest, height);
        }
    for (const auto& [number, heights] : range)
      if (heights[0] < -on_plane_ && heights[1] > on_plane_)
        faults_.push_back(
            fmt::format("{}: {}: goes through a body, which reaches {:g} behind the wall; accepted: bodies on one "
                        "side of it",
                        input_.file, key, -heights[0]));
  }

  void add_surface() { whole_.mesh.node_sets[surface_set] = nodes_of_sides(mesh::exterior_sides(whole_.mesh)); }

  void add_node(const std::string& reserved, const std::string& id_text, const std::string& key) {
    for (std::size_t i = 0; i < whole_.mesh.node_id.size(); ++i)
      if (std::to_string(whole_.mesh.node_id[i]) == id_text) {
        whole_.mesh.node_sets[reserved] = {static_cast<LocalIndex>(i)};
        return;
      }
    faults_.push_back(fmt::format("{}: {}: the mesh has no node {}", input_.file, key, id_text));
  }

 private:
  template <class Map>
  static std::string names(const Map& sets) {
    std::string text;
    for (const auto& [name, members] : sets)
      if (name.front() != '@') text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
  }

  void unknown(const std::string& where, const std::string& key) {
    std::string known;
    for (const std::string& part : part_of_block_) known += (known.empty() ? "" : ", ") + part;
    std::string sets;
    for (const SetEntry& set : input_.sets) sets += (sets.empty() ? "" : ", ") + set.name;
    faults_.push_back(fmt::format(
        "{}: {}: no part or set '{}'; parts: {}; sets: {}; of the mesh: node sets: {}; side sets: {}", input_.file, key,
        where, known, sets.empty() ? "none" : sets, names(whole_.mesh.node_sets), names(whole_.mesh.side_sets)));
  }

  Nodes nodes_of_part(const std::string& part) const {
    Nodes nodes;
    for (std::size_t b = 0; b < part_of_block_.size(); ++b)
      if (part_of_block_[b] == part)
        nodes.insert(nodes.end(), whole_.mesh.blocks[b].nodes.begin(), whole_.mesh.blocks[b].nodes.end());
    sort_unique(nodes);
    return nodes;
  }

  Nodes nodes_of_sides(const std::vector<mesh::Side>& sides) const {
    Nodes nodes;
    for (const mesh::Side& side : sides) {
      const mesh::Block& block = whole_.mesh.blocks[static_cast<std::size_t>(side.block)];
      for (const LocalIndex node : mesh::face_nodes(block.shape, block.element(side.element), side.face))
        if (node != no_index) nodes.push_back(node);
    }
    sort_unique(nodes);
    return nodes;
  }

  /// Parts before sets of the scene before sets of the mesh.
  std::optional<Nodes> nodes_of(const std::string& where) const {
    if (std::ranges::find(part_of_block_, where) != part_of_block_.end()) return nodes_of_part(where);
    for (const SetEntry& set : input_.sets)
      if (set.name == where) return nodes_of_entry(set);
    return nodes_of_mesh_set(where);
  }

  std::optional<Nodes> nodes_of_mesh_set(const std::string& where) const {
    Nodes nodes;
    if (const auto set = whole_.mesh.node_sets.find(where); set != whole_.mesh.node_sets.end()) {
      nodes = set->second;
      sort_unique(nodes);
      return nodes;
    }
    if (const auto set = whole_.mesh.side_sets.find(where); set != whole_.mesh.side_sets.end())
      return nodes_of_sides(set->second);
    return std::nullopt;
  }

  std::optional<Nodes> nodes_of_entry(const SetEntry& set) const {
    std::optional<Nodes> nodes;
    if (set.part) {
      if (std::ranges::find(part_of_block_, *set.part) == part_of_block_.end()) return std::nullopt;
      nodes = nodes_of_part(*set.part);
    }
    for (const std::optional<std::string>& name : {set.node_set, set.side_set}) {
      if (!name) continue;
      const std::optional<Nodes> more = nodes_of_mesh_set(*name);
      if (!more) return std::nullopt;
      nodes = nodes ? intersection(*nodes, *more) : *more;
    }
    if (!set.box) return nodes;
    if (!nodes) {
      nodes.emplace(whole_.mesh.coordinates.size());
      for (std::size_t i = 0; i < nodes->size(); ++i) (*nodes)[i] = static_cast<LocalIndex>(i);
    }
    std::erase_if(*nodes, [&](LocalIndex node) {
      const Vec3 X = whole_.mesh.coordinates[static_cast<std::size_t>(node)] + whole_.origin;
      const Vec3 slack = Vec3::Constant(on_plane_);  // so that a box drawn on the nodes holds them
      return ((*set.box)[0] - slack - X).maxCoeff() > 0 || (X - (*set.box)[1] - slack).maxCoeff() > 0;
    });
    return nodes;
  }

  static Nodes intersection(const Nodes& a, const Nodes& b) {
    Nodes both;
    std::ranges::set_intersection(a, b, std::back_inserter(both));
    return both;
  }

  const Input& input_;
  mesh::CanonicalMesh& whole_;
  std::vector<std::string>& faults_;
  std::vector<std::string> part_of_block_;
  double on_plane_ = 0;  // a node this near to a plane lies in it
};

const char* fitting_elements(mesh::Shape shape) {
  return shape == mesh::Shape::hex8 ? "hex8, hex8_full or hex8_bbar" : "tet4";
}

}  // namespace

std::string selection_name(const std::string& kind, std::size_t entry) {
  return fmt::format("@{}:{}", kind, entry);
}

std::vector<std::size_t> parts_of_blocks(const Input& input, const mesh::Mesh& mesh) {
  std::vector<std::string> faults;
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> part_of(mesh.blocks.size(), none);
  std::string known;
  for (const mesh::Block& block : mesh.blocks)
    known +=
        fmt::format("{}{}{}", known.empty() ? "" : ", ", block.id, block.name.empty() ? "" : " (" + block.name + ")");
  for (std::size_t p = 0; p < input.parts.size(); ++p) {
    const Part& part = input.parts[p];
    bool found = false;
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
      const mesh::Block& block = mesh.blocks[b];
      if (block.name != part.block && std::to_string(block.id) != part.block) continue;
      found = true;
      if (part_of[b] != none)
        faults.push_back(fmt::format("{}: parts.{}: block {} already belongs to part '{}'", input.file, part.name,
                                     part.block, input.parts[part_of[b]].name));
      part_of[b] = p;
      if ((part.element == ElementKind::tet4) != (block.shape == mesh::Shape::tet4))
        faults.push_back(fmt::format("{}: parts.{}.element: {} does not fit the block's elements; accepted: {}",
                                     input.file, part.name, element::name_of(part.element),
                                     fitting_elements(block.shape)));
      break;
    }
    if (!found)
      faults.push_back(fmt::format("{}: parts.{}: the mesh has no block '{}'; blocks: {}", input.file, part.name,
                                   part.block, known));
  }
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    if (part_of[b] == none)
      faults.push_back(fmt::format(
          "{}: parts: block {} has no part; give it one", input.file,
          mesh.blocks[b].name.empty() ? std::to_string(mesh.blocks[b].id) : "'" + mesh.blocks[b].name + "'"));
  if (!faults.empty()) throw InputError(std::move(faults));
  return part_of;
}

void select(const Input& input, mesh::CanonicalMesh& whole) {
  std::vector<std::string> faults;
  Selector selector(input, whole, faults);
  const auto each = [](const auto& list, auto&& use) {
    for (std::size_t k = 0; k < list.size(); ++k) use(list[k], k);
  };
  if (!input.contact.empty() || !input.rigid_walls.empty()) selector.add_surface();
  each(input.initial, [&](const InitialMotion& entry, std::size_t k) {
    selector.add_nodes(selection_name("initial", k), entry.where, fmt::format("initial.{}", k));
  });
  each(input.fixed, [&](const Fixed& entry, std::size_t k) {
    selector.add_nodes(selection_name("fixed", k), entry.where, fmt::format("fixed.{}", k));
  });
  each(input.prescribed, [&](const Prescribed& entry, std::size_t k) {
    selector.add_nodes(selection_name("prescribed", k), entry.where, fmt::format("prescribed.{}", k));
  });
  each(input.symmetry, [&](const Symmetry& entry, std::size_t k) {
    selector.add_plane(selection_name("symmetry", k), entry.point, entry.normal, fmt::format("symmetry.{}", k), true);
  });
  each(input.pressure, [&](const Pressure& entry, std::size_t k) {
    selector.add_sides(selection_name("pressure", k), entry.where, fmt::format("pressure.{}", k));
  });
  each(input.rigid_walls, [&](const RigidWall& entry, std::size_t k) {
    selector.add_plane(selection_name("wall", k), entry.point, entry.normal, fmt::format("rigid_walls.{}", k),
                       entry.bilateral);
    selector.require_one_side(entry, fmt::format("rigid_walls.{}", k));
  });
  each(input.probes, [&](const Probe& entry, std::size_t k) {
    const std::string key = fmt::format("probes.{}", k), reserved = selection_name("probe", k);
    if (entry.kind == Probe::Kind::node) selector.add_node(reserved, entry.where, key);
    if (entry.kind == Probe::Kind::set) selector.add_nodes(reserved, entry.where, key);
  });
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace brunt::scene
