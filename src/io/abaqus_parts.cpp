// SPDX-License-Identifier: Apache-2.0
#include "abaqus_parts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

namespace brunt::io {
namespace {

constexpr std::string_view element_types = "C3D4, C3D5, C3D6, C3D8 and their variants (C3D8R, ...)";

/// Of an element card: nodes of a solid element of first order, or 0.
struct ElementType {
  std::string name;
  int corners = 0;
  std::string fault{};  ///< of an element that is not read; empty for lines and surfaces that mesh generators write
};

ElementType type_of(const DeckCard& card) {
  ElementType type{.name = in_capitals(card.value("TYPE"))};
  for (const std::string_view passed : {"T2D", "T3D", "CPS", "CPE", "CAX", "SFM3D"})
    if (type.name.starts_with(passed)) return type;
  const std::string_view digits = std::string_view(type.name).substr(std::min<std::size_t>(3, type.name.size()));
  const std::string_view count = digits.substr(0, digits.find_first_not_of("0123456789"));
  const bool solid = type.name.starts_with("C3D");
  if (solid && (count == "4" || count == "5" || count == "6" || count == "8"))
    type.corners = count[0] - '0';
  else if (solid && !count.empty())
    type.fault = fmt::format("invalid element type {} of second order; expected {}", type.name, element_types);
  else
    type.fault = fmt::format("invalid element type '{}': not a solid; expected {}", card.value("TYPE"), element_types);
  return type;
}

class ModelReader {
 public:
  explicit ModelReader(const AbaqusDeck& deck) : deck_(deck) { model_.parts.emplace_back(); }

  AbaqusModel read() {
    for (const DeckCard& card : deck_.cards()) read_card(card);
    if (inside_ != Inside::nothing)
      deck_.fail(opened_at_,
                 "missing end of this part, assembly or instance: the file is truncated; expected *END PART, *END "
                 "ASSEMBLY or *END INSTANCE");
    if (!model_.parts[0].elements.empty() || !model_.parts[0].others.empty())
      model_.instances.insert(model_.instances.begin(), AbaqusInstance{});
    return std::move(model_);
  }

 private:
  enum class Inside { nothing, part, assembly, instance };

  void read_card(const DeckCard& card) {
    static const std::set<std::string> makers{"NGEN",  "NFILL",  "NCOPY",  "NMAP",
                                              "ELGEN", "ELCOPY", "SYSTEM", "PARAMETER"};
    const std::string& word = card.keyword;
    if (makers.contains(word))
      deck_.fail(card.line, fmt::format("invalid keyword *{}: generated nodes and elements are not supported; expected "
                                        "nodes and elements written out",
                                        word));
    if (word == "PART") return begin(card, Inside::nothing, Inside::part);
    if (word == "ASSEMBLY") return begin(card, Inside::nothing, Inside::assembly);
    if (word == "INSTANCE") return begin(card, Inside::assembly, Inside::instance);
    if (word == "END PART") return end(card, Inside::part, Inside::nothing);
    if (word == "END ASSEMBLY") return end(card, Inside::assembly, Inside::nothing);
    if (word == "END INSTANCE") return end(card, Inside::instance, Inside::assembly);
    const bool in_assembly = inside_ == Inside::assembly || inside_ == Inside::instance;
    if (word == "NSET") return add_to(sets_of(card, scope().node_sets, "NSET"), card, scope().node_sets);
    if (word == "ELSET") return add_to(sets_of(card, scope().element_sets, "ELSET"), card, scope().element_sets);
    if (word == "SURFACE") return add_surface(card);
    if (in_assembly) return;  // its own nodes are points that rigid bodies and loads refer to
    if (word == "NODE") return add_nodes(card);
    if (word == "ELEMENT") return add_elements(card);
    if (word.ends_with(" SECTION") && word != "SOLID SECTION" && card.has("ELSET"))
      part().other_sections.emplace_back(in_capitals(card.value("ELSET")), card.line);
    if (word == "SOLID SECTION") part().sections.emplace_back(in_capitals(card.value("ELSET")), card.line);
  }

  AbaqusPart& part() { return model_.parts[part_]; }
  AbaqusScope& scope() {
    if (inside_ == Inside::part) return part();
    const bool whole = inside_ == Inside::nothing && model_.instances.empty();
    return whole ? static_cast<AbaqusScope&>(model_.parts[0]) : model_.assembly;
  }

  std::string name_of(const DeckCard& card, const std::string& parameter) const {
    std::string name = card.value(parameter);
    if (name.empty())
      deck_.fail(card.line, fmt::format("missing parameter of *{}; expected {}=NAME", card.keyword, parameter));
    return name;
  }

  void begin(const DeckCard& card, Inside from, Inside to) {
    if (inside_ != from)
      deck_.fail(
          card.line,
          fmt::format("invalid *{} at this place: another block is still open; expected its *END first", card.keyword));
    inside_ = to;
    opened_at_ = card.line;
    if (to == Inside::part) {
      part_ = model_.parts.size();
      model_.parts.emplace_back().name = name_of(card, "NAME");
    }
    if (to == Inside::instance) add_instance(card);
  }

  void end(const DeckCard& card, Inside from, Inside to) {
    if (inside_ != from)
      deck_.fail(card.line,
                 fmt::format("invalid *{} without its beginning; expected the opening keyword above", card.keyword));
    inside_ = to;
    part_ = 0;
  }

  void add_instance(const DeckCard& card) {
    AbaqusInstance instance;
    instance.name = name_of(card, "NAME");
    const std::string wanted = in_capitals(name_of(card, "PART"));
    const auto found = std::ranges::find_if(
        model_.parts, [&](const AbaqusPart& p) { return !p.name.empty() && in_capitals(p.name) == wanted; });
    if (found == model_.parts.end())
      deck_.fail(card.line, fmt::format("invalid instance '{}': unknown part '{}'; expected a part defined above",
                                        instance.name, card.value("PART")));
    instance.part = static_cast<std::size_t>(found - model_.parts.begin());
    if (!card.data.empty()) {
      const auto shift = reals(card.data[0], 3);
      instance.shift = Vec3(shift[0], shift[1], shift[2]);
    }
    if (card.data.size() > 1) {
      const auto turn = reals(card.data[1], 7);
      instance.axis = {Vec3(turn[0], turn[1], turn[2]), Vec3(turn[3], turn[4], turn[5])};
      instance.degrees = turn[6];
      if ((*instance.axis)[0] == (*instance.axis)[1])
        deck_.fail(card.data[1].number, "invalid axis of rotation: its two points coincide; expected different points");
    }
    model_.instances.push_back(instance);
  }

  std::vector<double> reals(const DeckLine& line, std::size_t count) const {
    std::vector<double> values;
    for (const std::string_view field : fields_of(line.text)) values.push_back(deck_.real(line, field, "a number"));
    if (values.size() > count)
      deck_.fail(line.number, fmt::format("invalid line of {} numbers; expected at most {}", values.size(), count));
    values.resize(count, 0);
    return values;
  }

  void add_nodes(const DeckCard& card) {
    AbaqusPart& to = part();
    AbaqusSet* const set = card.has("NSET") ? &sets_of(card, to.node_sets, "NSET") : nullptr;
    for (const DeckLine& line : card.data) {
      const auto fields = fields_of(line.text);
      const std::int64_t number = deck_.integer(line, fields[0], "a node's number");
      Vec3 place = Vec3::Zero();
      for (std::size_t c = 0; c < 3 && c + 1 < fields.size(); ++c)
        place[static_cast<int>(c)] = deck_.real(line, fields[c + 1], "a coordinate");
      if (!to.node_at.emplace(number, static_cast<LocalIndex>(to.coordinates.size())).second)
        deck_.fail(line.number, fmt::format("invalid node {}: defined twice; expected each node once", number));
      to.node_number.push_back(number);
      to.coordinates.push_back(place);
      if (set != nullptr) set->members.push_back({"", number});
    }
  }

  void add_elements(const DeckCard& card) {
    AbaqusPart& to = part();
    const ElementType type = type_of(card);
    const int corners = type.corners;
    const std::string dealt = in_capitals(card.value("ELSET"));
    AbaqusSet* const set = dealt.empty() ? nullptr : &sets_of(card, to.element_sets, "ELSET");
    if (corners == 0) return add_others(card, type, dealt, set);
    for (std::size_t i = 0; i < card.data.size(); ++i) {
      std::vector<std::pair<const DeckLine*, std::string_view>> fields;
      const int first_line = card.data[i].number;
      for (;; ++i) {  // goes on in the next line
        for (const std::string_view field : fields_of(card.data[i].text)) fields.emplace_back(&card.data[i], field);
        if (fields.size() > static_cast<std::size_t>(corners)) break;
        if (i + 1 == card.data.size())
          deck_.fail(
              card.data[i].number,
              fmt::format(
                  "missing node numbers: {} numbers are given; expected the number of an element and of its {} nodes",
                  fields.size(), corners));
      }
      AbaqusElement element{.number = deck_.integer(*fields[0].first, fields[0].second, "the number of an element"),
                            .corners = corners,
                            .line = first_line};
      if (fields.size() != static_cast<std::size_t>(corners) + 1)
        deck_.fail(first_line, fmt::format("invalid element {} of {} nodes; expected {} nodes for its type",
                                           element.number, fields.size() - 1, corners));
      for (std::size_t k = 0; k < static_cast<std::size_t>(corners); ++k)
        element.nodes[k] =
            node_at(deck_.integer(*fields[k + 1].first, fields[k + 1].second, "a node's number"), first_line);
      if (to.other_at.contains(element.number) ||
          !to.element_at.emplace(element.number, static_cast<LocalIndex>(to.elements.size())).second)
        deck_.fail(first_line,
                   fmt::format("invalid element {}: defined twice; expected each element once", element.number));
      to.elements.push_back(element);
      to.dealt.push_back(dealt);
      if (set != nullptr) set->members.push_back({"", element.number});
    }
  }

  /// How many nodes such an element has is not known: it goes on in the next line where a line ends in a comma.
  void add_others(const DeckCard& card, const ElementType& type, const std::string& dealt, AbaqusSet* set) {
    AbaqusPart& to = part();
    bool goes_on = false;
    for (const DeckLine& line : card.data) {
      if (!goes_on) {
        const std::int64_t number = deck_.integer(line, fields_of(line.text)[0], "the number of an element");
        if (to.element_at.contains(number) || !to.other_at.emplace(number, to.others.size()).second)
          deck_.fail(line.number, fmt::format("invalid element {}: defined twice; expected each element once", number));
        to.others.push_back({number, type.name, dealt, type.fault, card.line});
        if (set != nullptr) set->members.push_back({"", number});
      }
      goes_on = line.text.back() == ',';
    }
    if (card.data.empty() && !type.fault.empty()) deck_.fail(card.line, type.fault);
  }

  LocalIndex node_at(std::int64_t number, int line) {
    const auto found = part().node_at.find(number);
    if (found == part().node_at.end())
      deck_.fail(line, fmt::format("unknown node {}; expected a node defined above", number));
    return found->second;
  }

  AbaqusSet& sets_of(const DeckCard& card, AbaqusSets& sets, const std::string& parameter) {
    const std::string name = name_of(card, parameter);
    AbaqusSet& set = sets[in_capitals(name)];
    if (set.name.empty()) set.name = name;
    return set;
  }

  void add_to(AbaqusSet& set, const DeckCard& card, const AbaqusSets& known) {
    const std::string instance = in_capitals(card.value("INSTANCE"));
    if (!instance.empty()) need_instance(instance, card.line);
    for (const DeckLine& line : card.data) {
      const auto fields = fields_of(line.text);
      if (card.has("GENERATE")) {
        if (fields.size() < 2) deck_.fail(line.number, "missing values of GENERATE; expected first, last and step");
        const std::int64_t first = deck_.integer(line, fields[0], "a number"),
                           last = deck_.integer(line, fields[1], "a number"),
                           step = fields.size() > 2 ? deck_.integer(line, fields[2], "a step") : 1;
        if (step < 1 || first < 0 || last < first || (last - first) / step >= most_members())
          deck_.fail(
              line.number,
              fmt::format("out of range: GENERATE {}, {}, {}; expected first <= last, step >= 1, and existing numbers",
                          first, last, step));
        for (std::int64_t number = first; number <= last; number += step) set.members.push_back({instance, number});
        continue;
      }
      for (const std::string_view field : fields) {
        const std::vector<AbaqusMember> members = members_of(line, field, instance, known);
        set.members.insert(set.members.end(), members.begin(), members.end());
      }
    }
  }

  /// No set has more than there are nodes and elements.
  [[nodiscard]] std::int64_t most_members() const {
    std::size_t most = 0;
    for (const AbaqusPart& one : model_.parts) most += one.coordinates.size() + one.elements.size();
    return static_cast<std::int64_t>(most);
  }

  void need_instance(const std::string& instance, int line) const {
    const auto is_it = [&](const AbaqusInstance& i) { return in_capitals(i.name) == instance; };
    if (std::ranges::none_of(model_.instances, is_it))
      deck_.fail(line, fmt::format("unknown instance '{}'; expected an instance defined above", instance));
  }

  /// A number, a set, or either of them behind INSTANCE and a point.
  std::vector<AbaqusMember> members_of(const DeckLine& line, std::string_view field, std::string instance,
                                       const AbaqusSets& known) const {
    if (!field.empty() && field.find_first_not_of("0123456789") == std::string_view::npos)
      return {{instance, deck_.integer(line, field, "a number")}};
    const std::string name = in_capitals(field);
    if (const auto set = known.find(name); set != known.end()) return set->second.members;
    const auto point = name.find('.');
    if (point != std::string::npos && instance.empty()) {
      instance = name.substr(0, point);
      need_instance(instance, line.number);
      return members_of(line, field.substr(point + 1), instance, known);
    }
    for (const AbaqusInstance& one : model_.instances) {  // a set of its part
      if (instance.empty() || in_capitals(one.name) != instance) continue;
      const AbaqusPart& part = model_.parts[one.part];
      const AbaqusSets& sets = &known == &model_.assembly.node_sets ? part.node_sets : part.element_sets;
      const auto set = sets.find(name);
      if (set == sets.end()) break;
      std::vector<AbaqusMember> members = set->second.members;
      for (AbaqusMember& member : members) member.instance = instance;
      return members;
    }
    deck_.fail(line.number, fmt::format("unknown set '{}'; expected a number, or a set defined above", field));
  }

  void add_surface(const DeckCard& card) {
    const std::string type = in_capitals(card.value("TYPE"));
    if (!type.empty() && type != "ELEMENT" && type != "NODE") return;  // of analytical rigid bodies, cuts, users
    AbaqusSurface surface{.name = name_of(card, "NAME"), .of_nodes = type == "NODE", .pieces = {}};
    static const std::set<std::string> shell_sides{"SPOS", "SNEG", "E1", "E2", "E3", "E4", "END1", "END2"};
    const AbaqusSets& known = surface.of_nodes ? scope().node_sets : scope().element_sets;
    for (const DeckLine& line : card.data) {
      const auto fields = fields_of(line.text);
      AbaqusSurface::Piece piece{.members = members_of(line, fields[0], "", known), .face = 0, .line = line.number};
      if (!surface.of_nodes && fields.size() > 1) {
        const std::string face = in_capitals(fields[1]);
        if (shell_sides.contains(face))
          piece.face = -1;
        else if (face.size() != 2 || face[0] != 'S' || face[1] < '1' || face[1] > '6')
          deck_.fail(line.number, fmt::format("invalid face '{}'; expected S1 to S6, or none", fields[1]));
        else
          piece.face = face[1] - '0';
      }
      surface.pieces.push_back(std::move(piece));
    }
    scope().surfaces.push_back(std::move(surface));
  }

  const AbaqusDeck& deck_;
  AbaqusModel model_;
  Inside inside_ = Inside::nothing;
  std::size_t part_ = 0;
  int opened_at_ = 0;
};

}  // namespace

AbaqusModel read_abaqus_model(const AbaqusDeck& deck) {
  return ModelReader(deck).read();
}

}  // namespace brunt::io
