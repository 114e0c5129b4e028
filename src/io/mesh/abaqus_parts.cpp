// SPDX-License-Identifier: Apache-2.0
#include "abaqus_parts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "abaqus_elements.hpp"
#include "abaqus_frame.hpp"
#include "abaqus_keywords.hpp"
#include "abaqus_sets.hpp"
#include "core/excerpt.hpp"

namespace brunt::io {
namespace {

/// Of solids or shells.
bool is_section_of_elements(const DeckCard& card) {
  const std::string word = compact(card.keyword);
  return word == "SOLIDSECTION" || word == "SHELLSECTION";
}

class ModelReader {
 public:
  explicit ModelReader(const AbaqusDeck& deck) : deck_(deck), sets_(deck, model_) { model_.parts.emplace_back(); }

  AbaqusModel read() {
    for (const DeckCard& card : deck_.cards()) {
      if (is_read(deck_, card, model_.notes)) read_card(card);
      if (card.keyword.ends_with(" SECTION") && !is_section_of_elements(card) && card.has("ELSET"))
        part().other_sections.emplace_back(card.label("ELSET").key, card.line);
    }
    if (inside_ != Inside::nothing)
      deck_.fail(opened_at_,
                 "missing end of this part, assembly or instance: the file is truncated; expected *END PART, *END "
                 "ASSEMBLY or *END INSTANCE");
    if (step_at_ > 0) deck_.fail(step_at_, "missing end of this step: the file is truncated; expected *END STEP");
    const AbaqusPart& whole = model_.parts[0];
    if (!whole.elements.empty() || !whole.others.empty()) model_.instances.emplace_back();
    note_open_ends();
    note_unused_parts();
    return std::move(model_);
  }

 private:
  enum class Inside { nothing, part, assembly, instance };

  void read_card(const DeckCard& card) {
    const std::string word = compact(card.keyword);
    if (word == "NSET") return sets_.add_node_set(card, scope());
    if (word == "ELSET") return sets_.add_element_set(card, scope());
    if (word == "SURFACE") return sets_.add_surface(card, scope());
    if (word == "STEP" || word == "ENDSTEP") return step(card, word == "STEP");
    if (step_at_ > 0)
      deck_.fail(card.line, fmt::format("invalid *{} in a step; expected it before *STEP", card.keyword));
    if (word == "PART") return begin(card, Inside::nothing, Inside::part);
    if (word == "ASSEMBLY") return begin(card, Inside::nothing, Inside::assembly);
    if (word == "INSTANCE") return begin(card, Inside::assembly, Inside::instance);
    if (word == "ENDPART") return end(card, Inside::part, Inside::nothing);
    if (word == "ENDASSEMBLY") return end(card, Inside::assembly, Inside::nothing);
    if (word == "ENDINSTANCE") return end(card, Inside::instance, Inside::assembly);
    if (word == "NODE") return inside_ == Inside::assembly ? add_points(card) : add_nodes(card);
    if (word == "ELEMENT") return inside_ == Inside::assembly ? add_masses(card) : add_elements(card);
    if (inside_ == Inside::assembly)
      deck_.fail(card.line,
                 fmt::format("invalid *{} in an assembly; expected it in a part or an instance", card.keyword));
    if (word == "SYSTEM") frame_ = frame_of(deck_, card);
    if (!is_section_of_elements(card)) return;
    home(card).sections.emplace_back(needed_label(deck_, card, "ELSET").key, card.line);
    if (word != "SOLIDSECTION")
      model_.notes.push_back(fmt::format("{}: the data of *{} are not read; the key thickness of the part gives it",
                                         deck_.place(card.line), card.keyword));
  }

  AbaqusPart& part() { return model_.parts[part_]; }

  AbaqusScope& scope() {
    if (inside_ == Inside::part) return part();
    if (inside_ == Inside::instance) return own_part();
    const bool whole = inside_ == Inside::nothing && !assembly_;
    return whole ? static_cast<AbaqusScope&>(model_.parts[0]) : model_.assembly;
  }

  /// Content of an instance is beside that of its part, of which it gets a copy.
  AbaqusPart& own_part() {
    if (part_ > 0) return part();
    AbaqusInstance& instance = model_.instances.back();
    AbaqusPart copy = model_.parts[instance.part];
    copy.name = {};  // no other instance is of it
    part_ = instance.part = model_.parts.size();
    model_.parts.push_back(std::move(copy));
    return part();
  }

  /// The part that nodes, elements and sections are added to.
  AbaqusPart& home(const DeckCard& card) {
    if (inside_ == Inside::instance) return own_part();
    if (inside_ == Inside::nothing && (assembly_ || model_.parts.size() > 1))
      deck_.fail(card.line, fmt::format("invalid *{} outside of parts: the file has parts or an assembly; expected it "
                                        "in a part or an instance",
                                        card.keyword));
    return part();
  }

  AbaqusPart& mesh_part(const DeckCard& card) {
    if (inside_ != Inside::instance) return home(card);
    const AbaqusInstance& instance = model_.instances.back();
    if (part_has_mesh_)
      deck_.fail(card.line, fmt::format("invalid *{} in instance '{}': its part has a mesh; expected the mesh in the "
                                        "part or in the instance",
                                        card.keyword, excerpt(instance.name.shown)));
    return home(card);
  }

  void begin(const DeckCard& card, Inside from, Inside to) {
    if (inside_ != from)
      deck_.fail(card.line,
                 fmt::format("invalid *{} at this place: it is outside of *ASSEMBLY, or another block is still open; "
                             "expected *INSTANCE in *ASSEMBLY, and the *END of other blocks first",
                             card.keyword));
    if (!model_.parts[0].coordinates.empty())
      deck_.fail(card.line, fmt::format("invalid *{}: nodes are defined outside of parts; expected all nodes in parts "
                                        "or instances",
                                        card.keyword));
    if (to == Inside::assembly && std::exchange(assembly_, true))
      deck_.fail(card.line, "invalid second *ASSEMBLY; expected one assembly");
    inside_ = to;
    opened_at_ = card.line;
    frame_ = {};
    if (to == Inside::part) add_part(card);
    if (to == Inside::instance) add_instance(card);
  }

  void end(const DeckCard& card, Inside from, Inside to) {
    if (inside_ != from)
      deck_.fail(card.line,
                 fmt::format("invalid *{} without its beginning; expected the opening keyword above", card.keyword));
    inside_ = to;
    part_ = 0;
    frame_ = {};
  }

  void step(const DeckCard& card, bool begins) {
    if (inside_ != Inside::nothing || (step_at_ > 0) == begins)
      deck_.fail(card.line, fmt::format("invalid *{} at this place; expected *STEP and *END STEP in turn, outside of "
                                        "parts and the assembly",
                                        card.keyword));
    step_at_ = begins ? card.line : 0;
  }

  void add_part(const DeckCard& card) {
    const DeckLabel name = needed_label(deck_, card, "NAME");
    if (std::ranges::any_of(model_.parts, [&](const AbaqusPart& one) { return one.name.key == name.key; }))
      deck_.fail(card.line,
                 fmt::format("invalid part '{}': defined twice; expected each part once", excerpt(name.shown)));
    part_ = model_.parts.size();
    model_.parts.emplace_back().name = name;
  }

  void add_instance(const DeckCard& card) {
    AbaqusInstance instance;
    instance.name = needed_label(deck_, card, "NAME");
    for (const AbaqusInstance& one : model_.instances)
      if (one.name.key == instance.name.key || one.name.shown == instance.name.shown)
        deck_.fail(card.line, fmt::format("invalid instance '{}': defined twice; expected each instance once",
                                          excerpt(instance.name.shown)));
    const DeckLabel wanted = needed_label(deck_, card, "PART");
    const auto found = std::ranges::find_if(
        model_.parts, [&](const AbaqusPart& p) { return !p.name.key.empty() && p.name.key == wanted.key; });
    if (found == model_.parts.end())
      deck_.fail(card.line, fmt::format("invalid instance '{}': unknown part '{}'; expected a part defined above",
                                        excerpt(instance.name.shown), excerpt(wanted.shown)));
    instance.part = static_cast<std::size_t>(found - model_.parts.begin());
    found->is_used = true;
    part_has_mesh_ = !found->coordinates.empty();
    place(instance, card);
    model_.instances.push_back(instance);
  }

  void place(AbaqusInstance& instance, const DeckCard& card) const {
    if (card.data.size() > 2)
      deck_.fail(card.data[2].number,
                 "invalid data of *INSTANCE; expected a line of a translation and a line of a "
                 "rotation");
    if (!card.data.empty()) {
      const auto shift = reals(card.data[0], 3);
      for (std::size_t c = 0; c < shift.size(); ++c) instance.shift[static_cast<int>(c)] = shift[c];
    }
    if (card.data.size() < 2) return;
    const auto turn = reals(card.data[1], 7);
    if (turn.size() < 7)
      deck_.fail(
          card.data[1].number,
          fmt::format("missing numbers of a rotation: {} are given; expected two points of its axis and an angle "
                      "in degrees",
                      turn.size()));
    instance.axis = {Vec3(turn[0], turn[1], turn[2]), Vec3(turn[3], turn[4], turn[5])};
    instance.degrees = turn[6];
    if ((*instance.axis)[0] == (*instance.axis)[1])
      deck_.fail(card.data[1].number, "invalid axis of rotation: its two points coincide; expected different points");
  }

  std::vector<double> reals(const DeckLine& line, std::size_t most) const {
    std::vector<double> values;
    for (const std::string_view field : deck_.fields(line)) values.push_back(deck_.real(line, field, "a number"));
    if (values.size() > most)
      deck_.fail(line.number, fmt::format("invalid line of {} numbers; expected at most {}", values.size(), most));
    return values;
  }

  void add_nodes(const DeckCard& card) {
    constexpr std::size_t most = 7;  // number, coordinates, and a normal, which shells use
    AbaqusPart& to = mesh_part(card);
    const NodeSystem system = node_system_of(deck_, card);
    AbaqusSet* const set = card.has("NSET") ? &sets_.named(card, to.node_sets, "NSET") : nullptr;
    for (const DeckLine& line : card.data) {
      const auto fields = deck_.fields(line);
      if (fields.size() > most)
        deck_.fail(line.number, fmt::format("invalid line of {} values in *NODE; expected the number of a node and its "
                                            "coordinates",
                                            fields.size()));
      const std::int64_t number = number_in(deck_, line, fields[0], "a node's number");
      Vec3 given = Vec3::Zero();
      for (std::size_t c = 0; c < 3 && c + 1 < fields.size(); ++c)
        given[static_cast<int>(c)] = deck_.real(line, fields[c + 1], "a coordinate");
      if (!to.node_at.emplace(number, static_cast<LocalIndex>(to.coordinates.size())).second)
        deck_.fail(line.number, fmt::format("invalid node {}: defined twice; expected each node once", number));
      to.node_number.push_back(number);
      to.coordinates.push_back(frame_.global(cartesian(system, given)));
      if (set != nullptr) set->members.push_back({.first = number, .last = number, .line = line.number});
    }
  }

  void add_elements(const DeckCard& card) {
    AbaqusPart& to = mesh_part(card);
    AbaqusSet* const set = card.has("ELSET") ? &sets_.named(card, to.element_sets, "ELSET") : nullptr;
    add_abaqus_elements(deck_, card, to, card.label("ELSET").key, set);
  }

  /// Nodes of the assembly are points that rigid bodies and loads refer to.
  void add_points(const DeckCard& card) {
    AbaqusSet* const set = card.has("NSET") ? &sets_.named(card, model_.assembly.node_sets, "NSET") : nullptr;
    for (const DeckLine& line : card.data) {
      const std::int64_t number = number_in(deck_, line, deck_.fields(line)[0], "a node's number");
      model_.assembly_nodes.insert(number);
      if (set != nullptr) set->members.push_back({.first = number, .last = number, .line = line.number});
    }
  }

  /// Elements of the assembly are masses, springs and connectors.
  void add_masses(const DeckCard& card) {
    const AbaqusElementType type = element_type_of(card);
    if (type.corners > 0)
      deck_.fail(card.line, fmt::format("invalid solid elements {} in an assembly; expected them in a part or an "
                                        "instance",
                                        type.name));
    AbaqusSet* const set = card.has("ELSET") ? &sets_.named(card, model_.assembly.element_sets, "ELSET") : nullptr;
    for (const auto& [number, line] : other_elements_of(deck_, card)) {
      model_.assembly_elements.insert(number);
      if (set != nullptr) set->members.push_back({.first = number, .last = number, .line = line});
    }
    model_.notes.push_back(
        fmt::format("{}: elements {} of the assembly are not read", deck_.place(card.line), excerpt(type.name)));
  }

  /// Data of a mesh may go on behind the end of a file, included or not. Other files end with *SOLID SECTION, a
  /// material, a step or the end of the assembly: a part of a set cannot be missing there.
  void note_open_ends() {
    std::vector<const DeckEnd*> open;
    for (const DeckEnd& end : deck_.ends()) {
      const std::string word = compact(deck_.cards()[end.card].keyword);
      if (word == "NODE" || word == "ELEMENT" || word == "NSET" || word == "ELSET" || word == "SURFACE")
        open.push_back(&end);
    }
    if (open.empty()) return;
    const DeckEnd& first = *open.front();
    const std::string more = open.size() == 1 ? "" : fmt::format(", nor that of {} more", open.size() - 1);
    model_.notes.push_back(fmt::format("{}: the file ends with *{}: whether it is truncated cannot be checked{}",
                                       deck_.place(first.line), excerpt(deck_.cards()[first.card].keyword), more));
  }

  void note_unused_parts() {
    for (const AbaqusPart& one : model_.parts)
      if (!one.name.key.empty() && !one.is_used && !one.elements.empty())
        model_.notes.push_back(fmt::format("part {} has no instance: its {} elements are not read",
                                           excerpt(one.name.shown), one.elements.size()));
  }

  const AbaqusDeck& deck_;
  AbaqusModel model_;
  AbaqusSetReader sets_;
  Inside inside_ = Inside::nothing;
  std::size_t part_ = 0;
  bool assembly_ = false;       ///< has begun
  bool part_has_mesh_ = false;  ///< of the instance that is open
  int opened_at_ = 0, step_at_ = 0;
  DeckFrame frame_;
};

}  // namespace

AbaqusModel read_abaqus_model(const AbaqusDeck& deck) {
  return ModelReader(deck).read();
}

DeckLabel needed_label(const AbaqusDeck& deck, const DeckCard& card, const std::string& parameter) {
  DeckLabel name = card.label(parameter);
  if (name.key.empty())
    deck.fail(card.line, fmt::format("missing parameter of *{}; expected {}=NAME", card.keyword, parameter));
  return name;
}

std::int64_t number_in(const AbaqusDeck& deck, const DeckLine& line, std::string_view field, std::string_view what) {
  constexpr std::int64_t largest = 999'999'999;  // Abaqus Analysis Guide, "Node definition" and "Element definition"
  const std::int64_t number = deck.integer(line, field, what);
  if (number < 1 || number > largest)
    deck.fail(line.number, fmt::format("out of range: {}; expected {} from 1 to {}", number, what, largest));
  return number;
}

}  // namespace brunt::io
