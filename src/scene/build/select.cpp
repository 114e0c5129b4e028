// SPDX-License-Identifier: Apache-2.0
#include "scene/build/select.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "mesh/topology.hpp"
#include "named_nodes.hpp"
#include "numbered_node.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/text/nearest.hpp"
#include "select_removed.hpp"
#include "select_watched.hpp"

namespace brunt::scene {
namespace {

/// The whole mesh with the names that a scene may use for its nodes and sides.
class Selector {
 public:
  using Nodes = NamedNodes::Nodes;

  Selector(const Input& input, mesh::CanonicalMesh& whole, std::vector<std::string>& faults)
      : input_(input), whole_(whole), faults_(faults), named_(input, whole) {}

  /// A set of the scene that refers to an unknown set of the mesh is reported at its definition, whether used or not.
  void check_definitions() {
    for (const SetEntry& set : input_.sets) {
      const std::string key = fmt::format("sets.{}", set.name);
      const auto& nodes = whole_.mesh.node_sets;
      const auto& sides = whole_.mesh.side_sets;
      if (shadows(set))
        report(key, "invalid name: the mesh has another {} set of this name; expected a different name",
               nodes.contains(set.name) ? "node" : "side");
      if (set.node_set && !nodes.contains(*set.node_set))
        undefined(set.name, key + ".node_set", "node set", *set.node_set, names(nodes), sides.contains(*set.node_set));
      if (set.side_set && !sides.contains(*set.side_set))
        undefined(set.name, key + ".side_set", "side set", *set.side_set, names(sides), nodes.contains(*set.side_set));
    }
  }

  /// Stores the selection of a set of the scene, if any.
  void add_defined(const std::string& reserved, const SetEntry& set) {
    if (std::optional<Nodes> found = named_.of_entry(set)) whole_.mesh.node_sets[reserved] = std::move(*found);
  }

  void add_nodes(const std::string& reserved, const std::string& where, const std::string& key) {
    if (named_.is_two_sets(where)) return two_sets(where, key);
    std::optional<Nodes> found = named_.of(where);
    if (!found) return unknown(where, key);
    if (found->empty())
      report(key, "invalid selection: '{}' contains no node; expected a region with nodes, {}", excerpt(where),
             extent());
    whole_.mesh.node_sets[reserved] = std::move(*found);
  }

  void add_sides(const std::string& reserved, const std::string& where, const std::string& key) {
    std::string name = where;
    for (const SetEntry& set : input_.sets)
      if (set.name == where && set.side_set) name = *set.side_set;
    if (undefined_.contains(where)) return;
    const auto found = whole_.mesh.side_sets.find(name);
    if (found == whole_.mesh.side_sets.end()) {
      std::vector<std::string> known = names(whole_.mesh.side_sets);
      for (const SetEntry& set : input_.sets)
        if (set.side_set) known.push_back(set.name);
      return report(key, "unknown side set '{}'{}", excerpt(where), expected(where, known));
    }
    if (found->second.empty())
      report(key, "invalid side set '{}': it has no face; expected a side set with at least one face", excerpt(where));
    whole_.mesh.side_sets[reserved] = found->second;
  }

  /// Faces over which a total force is distributed: those of a side set, otherwise the exterior ones with all nodes in
  /// the set.
  void add_faces(const std::string& reserved, const std::string& where, const std::string& key) {
    for (const SetEntry& set : input_.sets)
      if (set.name == where && set.side_set) return add_sides(reserved, where, key);
    if (named_.is_two_sets(where)) return two_sets(where, key);
    if (whole_.mesh.side_sets.contains(where)) return add_sides(reserved, where, key);
    const std::optional<Nodes> found = named_.of(where);
    if (!found) return unknown(where, key);
    std::vector<mesh::Side>& sides = whole_.mesh.side_sets[reserved];
    for (const mesh::Side& side : mesh::exterior_sides(whole_.mesh))
      if (std::ranges::all_of(named_.of_sides({side}),
                              [&](LocalIndex n) { return std::ranges::binary_search(*found, n); }))
        sides.push_back(side);
    if (sides.empty())
      report(key,
             "invalid set '{}': it has no exterior face; expected a set with exterior faces, or force: for each node",
             excerpt(where));
  }

  void add_probe(const Probe& probe, std::size_t k) {
    const std::string reserved = selection_name("probe", k), key = fmt::format("probes.{}", k);
    const bool named = !probe.where.empty();
    if (probe.kind == Probe::Kind::node) add_node(reserved, probe.where, key + ".node");
    if (probe.kind == Probe::Kind::set || probe.kind == Probe::Kind::part || (probe.kind == Probe::Kind::near && named))
      add_nodes(reserved, probe.where, input_.places.has(key + ".part") ? key + ".part" : key + ".set");
    if (probe.kind == Probe::Kind::near) keep_nearest(probe, reserved, whole_);
    if (probe.kind != Probe::Kind::section) return;
    if (named) add_nodes(reserved, probe.where, key + ".section.set");
    if (make_section(probe, k, named_.part_of_block(), named_.on_plane(), whole_) > 0) return;
    if (named && whole_.mesh.node_sets.contains(reserved))
      report(key + ".section.set",
             "invalid set '{}': it has no node of the parts; expected a set with nodes of these parts",
             excerpt(probe.where));
    if (!named)
      report(key + ".section",
             "invalid section: the plane intersects no element of the parts; expected a plane through nodes, {}",
             extent());
  }

  /// Rotations and moments need a node of shells. Other nodes of the selection are not affected.
  void require_shells(const std::string& reserved, const std::string& where, const std::string& key) {
    const auto set = whole_.mesh.node_sets.find(reserved);
    if (names_rigid_part(input_, where) || set == whole_.mesh.node_sets.end() || set->second.empty()) return;
    if (turning_.empty()) {
      turning_.resize(whole_.mesh.coordinates.size(), 0);
      for (const mesh::Block& block : whole_.mesh.blocks)
        if (cells::is_surface(block.shape))
          for (const LocalIndex node : block.nodes) nth(turning_, node) = 1;
    }
    if (std::ranges::any_of(set->second, [&](LocalIndex node) { return nth(turning_, node) != 0; })) return;
    report(key, "invalid rotation or moment of '{}': none of its nodes belongs to a shell; expected nodes of shells",
           excerpt(where));
  }

  void add_interface() { make_interface(whole_); }

  void add_bodies() {
    for (std::string& fault : select_bodies(input_, named_.part_of_block(), whole_))
      faults_.push_back(std::move(fault));
  }

  /// parts: only their nodes; empty: all.
  void add_plane(const std::string& reserved, const Vec3& point, const Vec3& normal, const std::string& key,
                 bool must_hold, const std::vector<std::string>& parts = {}) {
    Nodes nodes;
    std::vector<char> counts(whole_.mesh.coordinates.size(), parts.empty() ? 1 : 0);
    for_each_corner([&](std::size_t block, std::size_t /*element*/, LocalIndex node) {
      if (acts_on(parts, block)) nth(counts, node) = 1;
    });
    for (std::size_t i = 0; i < whole_.mesh.coordinates.size(); ++i)
      if (counts[i] != 0 && std::abs((whole_.mesh.coordinates[i] - (point - whole_.origin)).dot(normal.normalized())) <=
                                named_.on_plane())
        nodes.push_back(static_cast<LocalIndex>(i));
    if (nodes.empty() && must_hold)
      report(key, "invalid plane: it contains no node; expected a plane through nodes, {}", extent());
    whole_.mesh.node_sets[reserved] = std::move(nodes);
  }

  /// The region behind a wall is solid. Unless the wall names its parts, no body may start on both sides of it, nor all
  /// bodies behind it.
  void require_in_front(const RigidWall& wall, const std::string& key) {
    const std::vector<std::int32_t> body = mesh::bodies(whole_.mesh);
    std::map<std::int32_t, std::array<double, 2>> range;  // of the height over the wall
    std::map<std::int32_t, std::size_t> block_of;
    for_each_corner([&](std::size_t block, std::size_t element, LocalIndex node) {
      if (!acts_on(wall.parts, block)) return;
      const Vec3& X = nth(whole_.mesh.coordinates, node);
      const double height = (X + whole_.origin - wall.point).dot(wall.normal.normalized());
      block_of.try_emplace(body[element], block);
      auto& [lowest, highest] = range.try_emplace(body[element], std::array{height, height}).first->second;
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    });
    double nearest = -std::numeric_limits<double>::infinity();  // of the highest nodes of all bodies
    for (const auto& [number, heights] : range) {
      nearest = std::max(nearest, heights[1]);
      if (heights[0] < -named_.on_plane() && heights[1] > named_.on_plane())
        report(key,
               "invalid wall: it passes through a body, which extends {:g} behind it; expected each body on one side "
               "of the wall",
               -heights[0]);
    }
    const bool some_in_front = !wall.parts.empty() || range.empty() || nearest > named_.on_plane();
    if (some_in_front && input_.implicit) require_none_behind(range, block_of, key);
    if (some_in_front) return;
    report(key + ".normal",
           "invalid normal: all bodies lie behind the wall (the nearest by {:g}) and never meet it; expected a normal "
           "that points towards the bodies, or rigid_walls[].parts, the parts that the wall acts on",
           std::max(0.0, -nearest));
  }

  /// An implicit step would push bodies behind a wall through it.
  void require_none_behind(const std::map<std::int32_t, std::array<double, 2>>& range,
                           const std::map<std::int32_t, std::size_t>& block_of, const std::string& key) {
    for (const auto& [number, heights] : range) {
      if (heights[1] > named_.on_plane() || heights[0] >= -named_.on_plane()) continue;
      report(
          key,
          "invalid wall: a body of part '{}' lies behind it by up to {:g}, and an implicit step would move it through "
          "the wall; expected bodies in front of the wall, or rigid_walls[].parts, the parts that the wall acts on",
          excerpt(named_.part_of_block()[block_of.at(number)]), -heights[0]);
      return;
    }
  }

  void add_surface() { whole_.mesh.node_sets[surface_set] = named_.of_sides(mesh::exterior_sides(whole_.mesh)); }

  void add_node(const std::string& reserved, const std::string& text, const std::string& key) {
    const NumberedNode found = node_numbered(whole_.mesh, text);
    if (found.fault.empty())
      whole_.mesh.node_sets[reserved] = {found.node};
    else
      report(key, "{}", found.fault);
  }

 private:
  /// visit(block, element, node), elements counted through all blocks as mesh::bodies counts them.
  template <class Visit>
  void for_each_corner(Visit&& visit) const {
    std::size_t element = 0;
    for (std::size_t b = 0; b < whole_.mesh.blocks.size(); ++b) {
      const mesh::Block& block = whole_.mesh.blocks[b];
      for (LocalIndex e = 0; e < block.count(); ++e, ++element)
        for (int c = 0; c < mesh::nodes_per_element(block.shape); ++c) visit(b, element, block.element(e)[c]);
    }
  }
  /// Whether the wall acts on the block's part. Without names it acts on all.
  [[nodiscard]] bool acts_on(const std::vector<std::string>& parts, std::size_t block) const {
    return parts.empty() || std::ranges::find(parts, named_.part_of_block()[block]) != parts.end();
  }

  /// Whether the mesh has a different set of this name. {foot: {node_set: foot}} is the same one.
  [[nodiscard]] bool shadows(const SetEntry& set) const {
    const bool nodes = whole_.mesh.node_sets.contains(set.name), sides = whole_.mesh.side_sets.contains(set.name);
    const bool bare = !set.part && !set.box;
    const bool same_nodes = bare && set.node_set == set.name && !sides && !set.side_set;
    const bool same_sides = bare && set.side_set == set.name && !set.node_set;
    return (nodes || sides) && !same_nodes && !same_sides;
  }

  template <class... Values>
  void report(const std::string& key, fmt::format_string<Values...> what, Values&&... values) {
    faults_.push_back(fmt::format("{}: {}", input_.at(key), fmt::format(what, std::forward<Values>(values)...)));
  }

  template <class Map>
  static std::vector<std::string> names(const Map& sets) {
    std::vector<std::string> known;
    for (const auto& [name, members] : sets)
      if (name.front() != '@') known.push_back(name);
    return known;
  }

  static std::string expected(const std::string& word, const std::vector<std::string>& known) {
    return known.empty() ? "; expected a set of this kind, and the mesh has none"
                         : fmt::format("{}; expected one of {}", did_you_mean(word, known), listed(known));
  }

  void undefined(const std::string& set, const std::string& key, const char* kind, const std::string& word,
                 const std::vector<std::string>& known, bool of_other_kind) {
    undefined_.insert(set);
    const std::string_view other = std::string_view(kind) == "side set" ? "node set" : "side set";
    report(key, "unknown {} '{}' of the mesh{}{}", kind, excerpt(word),
           of_other_kind ? fmt::format(" (it has a {} of that name)", other) : "", expected(word, known));
  }

  void two_sets(const std::string& where, const std::string& key) {
    report(key,
           "invalid set '{0}': the mesh has a node set and a side set of this name, with different nodes; expected an "
           "entry of sets that selects one of them, NAME: {{node_set: '{0}'}} or NAME: {{side_set: '{0}'}}",
           excerpt(where));
  }

  /// The region of the mesh, for messages.
  [[nodiscard]] std::string extent() const {
    Vec3 low = Vec3::Constant(1e300), high = -low;
    for (const Vec3& X : whole_.mesh.coordinates) {
      low = low.cwiseMin(X + whole_.origin);
      high = high.cwiseMax(X + whole_.origin);
    }
    return fmt::format("which lie from ({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g})", low[0], low[1], low[2], high[0],
                       high[1], high[2]);
  }

  void unknown(const std::string& where, const std::string& key) {
    if (undefined_.contains(where)) return;
    std::vector<std::string> known, own;
    for (const std::string& part : named_.part_of_block())
      if (std::ranges::find(known, part) == known.end()) known.push_back(part);
    for (const SetEntry& set : input_.sets) own.push_back(set.name);
    std::vector<std::string> of_mesh = names(whole_.mesh.node_sets);
    for (const std::string& name : names(whole_.mesh.side_sets))
      if (std::ranges::find(of_mesh, name) == of_mesh.end()) of_mesh.push_back(name);
    const auto none = [](const std::vector<std::string>& list) { return list.empty() ? "none" : listed(list); };
    const std::string lists =
        fmt::format("parts: {}; sets: {}; sets of the mesh: {}", none(known), none(own), none(of_mesh));
    for (const auto* list : {&own, &of_mesh}) known.insert(known.end(), list->begin(), list->end());
    report(key, "unknown part or set '{}'{}; expected one of the {}", excerpt(where), did_you_mean(where, known),
           lists);
  }

  const Input& input_;
  mesh::CanonicalMesh& whole_;
  std::vector<std::string>& faults_;
  NamedNodes named_;
  std::vector<char> turning_;        ///< of each node: whether it belongs to a shell; empty until it is asked for
  std::set<std::string> undefined_;  ///< sets of the scene that refer to unknown sets of the mesh
};

/// Key of what an entry selects by: its `part` or its `set`.
std::string selecting_key(const Input& input, const char* list, std::size_t entry) {
  const std::string part = fmt::format("{}.{}.part", list, entry);
  return input.places.has(part) ? part : fmt::format("{}.{}.set", list, entry);
}

}  // namespace

std::string selection_name(const std::string& kind, std::size_t entry) {
  return fmt::format("@{}:{}", kind, entry);
}

void select(const Input& input, mesh::CanonicalMesh& whole) {
  std::vector<std::string> faults;
  Selector selector(input, whole, faults);
  const auto each = [](const auto& list, auto&& use) {
    for (std::size_t k = 0; k < list.size(); ++k) use(list[k], k);
  };
  if (!input.contact.empty() || !input.rigid_walls.empty()) selector.add_surface();
  selector.check_definitions();
  each(input.sets, [&](const SetEntry& set, std::size_t k) { selector.add_defined(selection_name("set", k), set); });
  const auto nodes = [&](const char* list) {
    return [&input, &selector, list](const auto& entry, std::size_t k) {
      selector.add_nodes(selection_name(list, k), entry.where, selecting_key(input, list, k));
    };
  };
  each(input.initial, nodes("initial"));
  each(input.fixed, nodes("fixed"));
  each(input.prescribed, nodes("prescribed"));
  each(input.fixed, [&](const Fixed& entry, std::size_t k) {
    if (std::ranges::find(entry.turns, true) != entry.turns.end())
      selector.require_shells(selection_name("fixed", k), entry.where, fmt::format("fixed.{}.dofs", k));
  });
  each(input.prescribed, [&](const Prescribed& entry, std::size_t k) {
    if (entry.dof >= 3)
      selector.require_shells(selection_name("prescribed", k), entry.where, fmt::format("prescribed.{}.dof", k));
  });
  each(input.remove, nodes("remove"));
  for (std::string& fault : select_removed(input, whole)) faults.push_back(std::move(fault));
  each(input.symmetry, [&](const Symmetry& entry, std::size_t k) {
    selector.add_plane(selection_name("symmetry", k), entry.point, entry.normal, fmt::format("symmetry.{}", k), true);
  });
  each(input.pressure, [&](const Pressure& entry, std::size_t k) {
    selector.add_sides(selection_name("pressure", k), entry.where, fmt::format("pressure.{}.set", k));
  });
  each(input.rigid_walls, [&](const RigidWall& entry, std::size_t k) {
    selector.add_plane(selection_name("wall", k), entry.point, entry.normal, fmt::format("rigid_walls.{}", k),
                       entry.bilateral, entry.parts);
    selector.require_in_front(entry, fmt::format("rigid_walls.{}", k));
  });
  each(input.traction, [&](const DeadLoad& entry, std::size_t k) {
    selector.add_sides(selection_name("traction", k), entry.where, fmt::format("traction.{}.set", k));
  });
  each(input.forces, [&](const DeadLoad& entry, std::size_t k) {
    const std::string reserved = selection_name("forces", k), key = selecting_key(input, "forces", k);
    if (entry.kind == DeadLoad::Kind::total) return selector.add_faces(reserved, entry.where, key);
    selector.add_nodes(reserved, entry.where, key);
    if (entry.moment != Vec3::Zero())
      selector.require_shells(reserved, entry.where, fmt::format("forces.{}.moment", k));
  });
  each(input.probes, [&](const Probe& entry, std::size_t k) { selector.add_probe(entry, k); });
  if (std::ranges::any_of(input.probes, [](const Probe& probe) { return probe.field == "energy"; }))
    selector.add_interface();
  selector.add_bodies();
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace brunt::scene
