// SPDX-License-Identifier: Apache-2.0
// From an Abaqus file's parts and instances to blocks and sets.
#include "io/mesh/abaqus.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numbers>
#include <set>
#include <span>

#include "abaqus_numbers.hpp"
#include "abaqus_parts.hpp"
#include "core/cells.hpp"
#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "left_out.hpp"
#include "mesh/topology.hpp"
#include "sound_mesh.hpp"

namespace brunt::io {
namespace {

using mesh::Block;
using mesh::Mesh;
using mesh::Shape;
using mesh::Side;

/// Corners of a face as the manual numbers them, from 1 (Abaqus Elements Guide, three-dimensional solid elements).
using FaceCorners = std::array<int, 4>;
constexpr std::array<FaceCorners, 6> hex_sides{
    {{1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1}}};
constexpr std::array<FaceCorners, 5> wedge_sides{{{1, 2, 3}, {4, 6, 5}, {1, 4, 5, 2}, {2, 5, 6, 3}, {3, 6, 4, 1}}};
constexpr std::array<FaceCorners, 5> pyramid_sides{{{1, 2, 3, 4}, {1, 5, 2}, {2, 5, 3}, {3, 5, 4}, {4, 5, 1}}};
constexpr std::array<FaceCorners, 4> tet_sides{{{1, 2, 3}, {1, 4, 2}, {2, 4, 3}, {3, 4, 1}}};

std::span<const FaceCorners> sides_of(int corners) {
  if (corners == 4) return tet_sides;
  if (corners == 5) return pyramid_sides;
  if (corners == 6) return wedge_sides;
  return hex_sides;
}

Shape shape_of(const AbaqusElement& element) {
  if (element.shell) return element.corners == 3 ? Shape::tri3 : Shape::quad4;
  return cells::shape_with(element.corners);
}

/// An instance in the making: where its nodes and elements went.
struct Placed {
  const AbaqusInstance* instance;
  const AbaqusPart* part;
  LocalIndex first_node = 0;
  std::vector<std::pair<LocalIndex, LocalIndex>> element;  ///< block and position, of each of the part
  AbaqusNumbers numbers;
  [[nodiscard]] std::string named(const std::string& name) const {
    return instance->name.shown.empty() ? name : instance->name.shown + '.' + name;
  }
};

class MeshMaker {
 public:
  MeshMaker(const AbaqusDeck& deck, const AbaqusModel& model)
      : deck_(deck), model_(model), assembly_numbers_(model), notes_(model.notes.begin(), model.notes.end()) {}

  FileContent make() {
    for (const AbaqusInstance& instance : model_.instances) place(instance);
    for (Placed& placed : placed_) add_scope(*placed.part, &placed);
    add_scope(model_.assembly, nullptr);
    mesh_.notes.assign(notes_.begin(), notes_.end());
    return {std::move(mesh_), std::move(foreign_), std::move(foreign_sides_)};
  }

 private:
  void place(const AbaqusInstance& instance) {
    const AbaqusPart& part = model_.parts[instance.part];
    Placed placed{&instance, &part, static_cast<LocalIndex>(mesh_.coordinates.size()), {}, AbaqusNumbers(part)};
    const bool alone = model_.instances.size() == 1;
    for (std::size_t n = 0; n < part.coordinates.size(); ++n) {
      mesh_.coordinates.push_back(moved(instance, part.coordinates[n]));
      mesh_.node_id.push_back(alone ? part.node_number[n] : static_cast<GlobalIndex>(mesh_.node_id.size()) + 1);
    }
    add_blocks(placed, alone);
    add_foreign(placed);
    placed_.push_back(std::move(placed));
  }

  static Vec3 moved(const AbaqusInstance& instance, const Vec3& place) {
    Vec3 shifted = place + instance.shift;
    if (!instance.axis) return shifted;
    const auto& [from, to] = *instance.axis;
    return from +
           Eigen::AngleAxisd(instance.degrees * std::numbers::pi / 180, (to - from).normalized()) * (shifted - from);
  }

  /// Where no element of this kind has a section, those of the cards count.
  void name_by_cards(const AbaqusPart& part, bool shell, const std::vector<bool>& taken,
                     std::vector<std::string>& names) const {
    const AbaqusElement* free = nullptr;
    bool any = false;
    for (std::size_t e = 0; e < taken.size(); ++e) {
      if (part.elements[e].shell != shell) continue;
      any = any || taken[e];
      if (!taken[e] && free == nullptr) free = &part.elements[e];
    }
    if (any && free != nullptr)
      deck_.fail(free->line,
                 fmt::format("missing *{} SECTION for element {}; expected a section for each {}, or none at all",
                             shell ? "SHELL" : "SOLID", free->number, shell ? "shell" : "solid element"));
    for (std::size_t e = 0; !any && e < taken.size(); ++e)
      if (part.elements[e].shell == shell) names[e] = part.dealt[e];
  }

  /// The element set that each element's block is of: of a section, or of its card.
  std::vector<std::string> block_names(Placed& placed) {
    const AbaqusPart& part = *placed.part;
    if (part.sections.empty()) return part.dealt;
    std::vector<std::string> names(part.elements.size());
    std::vector<bool> taken(part.elements.size(), false);
    for (const auto& [key, line] : part.sections) {
      const auto found = part.element_sets.find(key);
      if (found == part.element_sets.end())
        deck_.fail(line, fmt::format("unknown element set '{}' of a section; expected an element set of this part",
                                     excerpt(key)));
      for_elements(found->second, placed.named(found->second.name), &placed, [&](Placed*, std::int64_t number, int) {
        const auto solid = part.element_at.find(number);
        if (solid == part.element_at.end()) return;
        const auto e = static_cast<std::size_t>(solid->second);
        if (taken[e] && names[e] != key)
          deck_.fail(line, fmt::format("invalid section: element {} already belongs to another one; expected "
                                       "one section for each element",
                                       number));
        taken[e] = true;
        names[e] = key;
      });
    }
    for (const bool shell : {false, true}) name_by_cards(part, shell, taken, names);
    return names;
  }

  void add_blocks(Placed& placed, bool alone) {
    const AbaqusPart& part = *placed.part;
    const std::vector<std::string> names = block_names(placed);
    std::map<std::pair<std::string, Shape>, LocalIndex> at;
    for (std::size_t e = 0; e < part.elements.size(); ++e) {
      const AbaqusElement& element = part.elements[e];
      const auto [found, is_new] =
          at.try_emplace({names[e], shape_of(element)}, static_cast<LocalIndex>(mesh_.blocks.size()));
      if (is_new) add_block(placed, names[e], shape_of(element));
      Block& block = nth(mesh_.blocks, found->second);
      placed.element.emplace_back(found->second, block.count());
      const auto corners = hex_corners(element.corners);
      for (int k = 0; k < mesh::nodes_per_element(block.shape); ++k)
        block.nodes.push_back(placed.first_node + nth(element.nodes, nth(corners, k)));
      block.element_id.push_back(alone ? element.number : ++elements_);
    }
    for (const auto& [key, b] : at) {  // several shapes: those after the first are told apart
      Block& block = nth(mesh_.blocks, b);
      const bool first = at.lower_bound({key.first, Shape::hex8})->second == b;
      if (!first) block.name += fmt::format("_{}", cells::of(key.second).name);
    }
  }

  /// Elements that are not read, as a block for each set that a section names, else of each card's set, else type.
  void add_foreign(Placed& placed) {
    const AbaqusPart& part = *placed.part;
    std::vector<std::string> names;
    for (const AbaqusOther& other : part.others) names.push_back(other.dealt);
    for (const auto* sections : {&part.sections, &part.other_sections})
      for (const auto& [set, line] : *sections) {
        const auto found = part.element_sets.find(set);
        if (found == part.element_sets.end()) continue;
        for_elements(found->second, placed.named(found->second.name), &placed, [&](Placed*, std::int64_t number, int) {
          if (const auto other = part.other_at.find(number); other != part.other_at.end()) names[other->second] = set;
        });
      }
    std::map<std::pair<std::string, std::string>, std::size_t> at;
    for (std::size_t e = 0; e < part.others.size(); ++e) {
      const AbaqusOther& other = part.others[e];
      const auto [found, is_new] = at.try_emplace({names[e], other.type}, foreign_.size());
      if (is_new) {
        const auto set = part.element_sets.find(names[e]);
        ForeignBlock block{.name = placed.named(set == part.element_sets.end() ? other.type : set->second.name),
                           .type = other.type,
                           .passed = other.fault.empty()};
        if (!block.passed) block.fault = fmt::format("{}: {}", deck_.place(other.line), other.fault);
        foreign_.push_back(std::move(block));
      }
      ++foreign_[found->second].count;
    }
  }

  void add_block(const Placed& placed, const std::string& set, Shape shape) {
    Block block;
    const auto named = placed.part->element_sets.find(set);
    if (named != placed.part->element_sets.end())
      block.name = placed.named(named->second.name);
    else
      block.name = placed.instance->name.shown;
    block.id = static_cast<GlobalIndex>(mesh_.blocks.size()) + 1;
    block.shape = shape;
    mesh_.blocks.push_back(std::move(block));
  }

  /// own: of a part's scope; of the assembly each member says its own. Null: of no instance.
  Placed* placed_of(const AbaqusMembers& members, Placed* own) {
    if (own != nullptr) return own;
    return members.instance < 0 ? nullptr : &nth(placed_, members.instance);
  }

  template <class Visit>
  void for_numbers(const std::vector<AbaqusMembers>& chosen, AbaqusNumbers::Kind kind, const std::string& name,
                   Placed* own, const Visit& visit) {
    for (const AbaqusMembers& members : chosen) {
      Placed* placed = placed_of(members, own);
      AbaqusNumbers& numbers = placed == nullptr ? assembly_numbers_ : placed->numbers;
      for (const std::int64_t number : existing(deck_, members, numbers, kind, name, notes_))
        visit(placed, number, members.line);
    }
  }

  template <class Visit>
  void for_elements(const AbaqusChoice& choice, const std::string& name, Placed* own, const Visit& visit) {
    for_numbers(choice.members, AbaqusNumbers::Kind::element, name, own, visit);
  }

  /// Nodes that are no part of an instance are points of rigid bodies and loads: they are left out.
  void add_nodes(const AbaqusChoice& choice, const std::string& name, Placed* own, std::set<LocalIndex>& nodes) {
    std::size_t points = 0;
    for_numbers(choice.members, AbaqusNumbers::Kind::node, name, own, [&](Placed* placed, std::int64_t number, int) {
      if (placed == nullptr)
        ++points;
      else
        nodes.insert(placed->first_node + placed->part->node_at.at(number));
    });
    for_numbers(choice.of_elements, AbaqusNumbers::Kind::element, name, own,
                [&](Placed* placed, std::int64_t number, int line) {
                  const auto solid = placed == nullptr ? std::unordered_map<std::int64_t, LocalIndex>::const_iterator{}
                                                       : placed->part->element_at.find(number);
                  if (placed == nullptr || solid == placed->part->element_at.end())
                    deck_.fail(line,
                               fmt::format("invalid member of '{}': element {} is not a solid element or shell of "
                                           "first order, so its nodes are not read; expected such elements",
                                           excerpt(name), number));
                  const AbaqusElement& element = nth(placed->part->elements, solid->second);
                  for (int k = 0; k < element.corners; ++k) nodes.insert(placed->first_node + nth(element.nodes, k));
                });
    if (points > 0)
      notes_.insert(fmt::format("node set {}: {} points of the assembly are not read", excerpt(name), points));
  }

  template <class Kept, class Found>
  void keep(std::map<std::string, Kept>& sets, const std::string& name, const Found& found, int line) {
    if (!sets.try_emplace(name, found.begin(), found.end()).second)
      deck_.fail(line, fmt::format("invalid name '{}': two sets or surfaces have it; expected names that differ",
                                   excerpt(name)));
  }

  void add_scope(const AbaqusScope& scope, Placed* own) {
    const auto named = [&](const std::string& name) { return own == nullptr ? name : own->named(name); };
    for (const auto& [key, set] : scope.node_sets) {
      std::set<LocalIndex> nodes;
      add_nodes(set, named(set.name), own, nodes);
      const int line = set.members.empty() ? set.of_elements.front().line : set.members.front().line;
      if (!nodes.empty()) keep(mesh_.node_sets, named(set.name), nodes, line);
    }
    for (const auto& [key, set] : scope.element_sets)
      for_elements(set, named(set.name), own, [](Placed*, std::int64_t, int) {});
    for (const AbaqusSurface& surface : scope.surfaces) add_surface(surface, named(surface.name.shown), own);
  }

  void add_surface(const AbaqusSurface& surface, const std::string& name, Placed* own) {
    std::set<LocalIndex> nodes;
    std::set<Side> sides;
    for (const AbaqusSurface::Piece& piece : surface.pieces) {
      if (surface.of_nodes) {
        add_nodes(piece, name, own, nodes);
        continue;
      }
      for_elements(piece, name, own, [&](Placed* placed, std::int64_t number, int) {
        const bool solid = placed != nullptr && placed->part->element_at.contains(number);
        if (solid)
          add_sides(*placed, placed->part->element_at.at(number), piece, sides);
        else
          ++foreign_sides_[name];
      });
    }
    for (const Side& side : sides) {
      const Block& block = nth(mesh_.blocks, side.block);
      for (const LocalIndex node : mesh::face_nodes(block.shape, block.element(side.element), side.face))
        if (node != no_index) nodes.insert(node);
    }
    if (!sides.empty() || foreign_sides_.contains(name)) keep(mesh_.side_sets, name, sides, surface.line);
    if (nodes.empty()) return;
    if (!surface.of_nodes && mesh_.node_sets.contains(name))
      notes_.insert(
          fmt::format("surface {}: it gives a side set only, since a node set has the same name", excerpt(name)));
    else
      keep(mesh_.node_sets, name, nodes, surface.line);
  }

  /// Found when it is asked for the first time: most surfaces name their faces.
  bool is_exterior(const Side& side) {
    if (exterior_.empty()) exterior_ = mesh::exterior_sides(mesh_);
    return std::ranges::binary_search(exterior_, side);
  }

  /// Without a name the top.
  void add_side_of_shell(const AbaqusElement& element, Side side, const AbaqusSurface::Piece& piece,
                         std::set<Side>& sides) {
    if (piece.face > 0 || piece.face == AbaqusSurface::edge)
      deck_.fail(piece.line, fmt::format("invalid side of element {}: it is a shell, and only its two sides are read; "
                                         "expected SPOS or SNEG",
                                         element.number));
    side.face = piece.face == AbaqusSurface::bottom ? 1 : 0;
    sides.insert(side);
  }

  void add_sides(const Placed& placed, LocalIndex e, const AbaqusSurface::Piece& piece, std::set<Side>& sides) {
    const AbaqusElement& element = nth(placed.part->elements, e);
    const auto [b, position] = nth(placed.element, e);
    const Block& block = nth(mesh_.blocks, b);
    if (element.shell) return add_side_of_shell(element, {b, position, 0}, piece, sides);
    const auto all = sides_of(element.corners);
    if (piece.face < 0)
      deck_.fail(piece.line,
                 fmt::format("invalid side of a shell: element {} is a solid; expected S1 to S6", element.number));
    if (piece.face > static_cast<int>(all.size()))
      deck_.fail(piece.line, fmt::format("invalid face of element {}: it has no S{}; expected a face of its type",
                                         element.number, piece.face));
    std::array<LocalIndex, 4> wanted{no_index, no_index, no_index, no_index};
    if (piece.face > 0) {
      const FaceCorners& corners = nth(all, piece.face - 1);
      for (std::size_t k = 0; k < 4 && corners[k] > 0; ++k)
        wanted[k] = placed.first_node + nth(element.nodes, corners[k] - 1);
      std::ranges::sort(wanted);
    }
    for (int f = 0; f < mesh::faces_per_element(block.shape); ++f) {
      const Side side{b, position, f};
      auto nodes = mesh::face_nodes(block.shape, block.element(position), f);
      std::ranges::sort(nodes);
      if (piece.face > 0 ? nodes == wanted : is_exterior(side)) sides.insert(side);
    }
  }

  const AbaqusDeck& deck_;
  const AbaqusModel& model_;
  Mesh mesh_;
  std::vector<ForeignBlock> foreign_;
  std::map<std::string, GlobalIndex> foreign_sides_;
  std::vector<Placed> placed_;
  AbaqusNumbers assembly_numbers_;
  std::set<std::string> notes_;
  std::vector<Side> exterior_;  ///< ordered
  GlobalIndex elements_ = 0;
};

}  // namespace

Mesh read_abaqus(const std::string& path, const std::vector<std::string>& ignore) {
  const AbaqusDeck deck(path);
  const AbaqusModel model = read_abaqus_model(deck);
  const auto has_elements = [&](const AbaqusInstance& i) { return !model.parts[i.part].elements.empty(); };
  const auto is_refused = [](const AbaqusOther& other) { return !other.fault.empty(); };
  const auto has_refused = [&](const AbaqusInstance& i) {
    return std::ranges::any_of(model.parts[i.part].others, is_refused);
  };
  if (std::ranges::none_of(model.instances, has_elements) && std::ranges::none_of(model.instances, has_refused))
    throw InputError(
        path +
        (model.parts.size() > 1 && model.instances.empty()
             ? ": missing *INSTANCE of the parts; expected an *INSTANCE for each part that is used"
             : ": missing solid elements and shells; expected C3D4, C3D5, C3D6, C3D8, S4, S3 or their variants"));
  return leave_out(path, MeshMaker(deck, model).make(), ignore);
}

}  // namespace brunt::io
