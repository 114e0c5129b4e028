// SPDX-License-Identifier: Apache-2.0
#include "abaqus_sets.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/excerpt.hpp"
#include "core/letter_case.hpp"
#include "io/csv.hpp"

namespace brunt::io {
namespace {

/// The position of the point in INSTANCE.NAME: the first one outside of quotation marks.
std::size_t point_in(std::string_view field) {
  bool quoted = false;
  for (std::size_t at = 0; at < field.size(); ++at) {
    if (field[at] == '"') quoted = !quoted;
    if (field[at] == '.' && !quoted) return at;
  }
  return std::string_view::npos;
}

bool is_number(std::string_view field) {
  return field.find_first_not_of("+0123456789") == std::string_view::npos;
}

/// Keeps the first of equal members, in their order.
void keep_once(std::vector<AbaqusMembers>& members) {
  const auto key = [&](std::size_t k) {
    const AbaqusMembers& one = members[k];
    return std::tuple(one.instance, one.generated, one.first, one.last, one.step);
  };
  std::vector<std::size_t> order(members.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, key);
  std::vector<bool> again(members.size(), false);
  for (std::size_t k = 1; k < order.size(); ++k) again[order[k]] = key(order[k]) == key(order[k - 1]);
  std::size_t at = 0;
  std::erase_if(members, [&](const AbaqusMembers&) { return again[at++]; });
}

/// Sets of sets may name the same members any number of times: the members are made unique before the memory grows, so
/// that it is at most twice that of different members.
void append(std::vector<AbaqusMembers>& to, const std::vector<AbaqusMembers>& more) {
  if (to.size() + more.size() > to.capacity()) {
    keep_once(to);
    to.reserve(2 * (to.size() + more.size()));
  }
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

AbaqusSet& AbaqusSetReader::named(const DeckCard& card, AbaqusSets& sets, const std::string& parameter) const {
  const DeckLabel name = needed_label(deck_, card, parameter);
  const auto found = sets.find(name.key);
  if (found == sets.end()) {
    for (const auto& [key, other] : sets)
      if (other.name == name.shown)
        deck_.fail(card.line,
                   fmt::format("invalid name '{}': another set has the same name with other quotation marks, which "
                               "decide on capitals; expected names that differ",
                               excerpt(name.shown)));
    AbaqusSet& set = sets[name.key];
    set.name = name.shown;
    return set;
  }
  if (found->second.taken_at > 0)
    deck_.fail(card.line, fmt::format("invalid addition to set '{}': another set or surface took its members in {}; "
                                      "expected all of its members before",
                                      excerpt(found->second.name), deck_.place(found->second.taken_at)));
  return found->second;
}

bool AbaqusSetReader::has_instance(const DeckLabel& name) const {
  return std::ranges::any_of(model_.instances, [&](const auto& one) { return one.name.key == name.key; });
}

int AbaqusSetReader::instance_called(const DeckLabel& name, int line) const {
  const auto found = std::ranges::find_if(model_.instances, [&](const auto& one) { return one.name.key == name.key; });
  if (found == model_.instances.end())
    deck_.fail(line, fmt::format("unknown instance '{}'; expected an instance defined above", excerpt(name.shown)));
  return static_cast<int>(found - model_.instances.begin());
}

int AbaqusSetReader::instance_of(const DeckCard& card) const {
  return card.has("INSTANCE") ? instance_called(needed_label(deck_, card, "INSTANCE"), card.line) : -1;
}

void AbaqusSetReader::add_node_set(const DeckCard& card, AbaqusScope& scope) const {
  AbaqusSet& set = named(card, scope.node_sets, "NSET");
  if (!card.has("ELSET")) return add_data(card, scope, set, Kind::nodes);
  if (!card.data.empty() || card.has("GENERATE"))
    deck_.fail(card.line, "invalid *NSET: ELSET excludes data and GENERATE; expected one of them");
  needed_label(deck_, card, "ELSET");
  const AbaqusChoice elements = choice_of({card.parameter.at("ELSET"), card.line}, card.parameter.at("ELSET"),
                                          instance_of(card), scope, Kind::elements);
  append(set.of_elements, elements.members);
}

void AbaqusSetReader::add_element_set(const DeckCard& card, AbaqusScope& scope) const {
  add_data(card, scope, named(card, scope.element_sets, "ELSET"), Kind::elements);
}

void AbaqusSetReader::add_data(const DeckCard& card, AbaqusScope& scope, AbaqusSet& set, Kind kind) const {
  if (card.data.empty())
    deck_.fail(card.line,
               fmt::format("missing data of *{}; expected numbers or names of sets in the next line", card.keyword));
  const int instance = instance_of(card);
  std::set<std::string_view> sets_taken;  // a set named again has no further member
  for (const DeckLine& line : card.data) {
    if (card.has("GENERATE")) {
      set.members.push_back(generated(line, instance));
      continue;
    }
    for (const std::string_view field : deck_.fields(line)) {
      if (!is_number(field) && !sets_taken.insert(field).second) continue;
      const AbaqusChoice choice = choice_of(line, field, instance, scope, kind);
      append(set.members, choice.members);
      append(set.of_elements, choice.of_elements);
    }
  }
}

AbaqusMembers AbaqusSetReader::generated(const DeckLine& line, int instance) const {
  const auto fields = deck_.fields(line);
  if (fields.size() < 2 || fields.size() > 3)
    deck_.fail(line.number, fmt::format("invalid line of {} values with GENERATE; expected first, last and step, or "
                                        "first and last",
                                        fields.size()));
  AbaqusMembers range{.first = number_in(deck_, line, fields[0], "the first number"),
                      .last = number_in(deck_, line, fields[1], "the last number"),
                      .instance = instance,
                      .line = line.number,
                      .generated = true};
  if (fields.size() > 2) range.step = number_in(deck_, line, fields[2], "a step");
  if (range.last < range.first || (range.last - range.first) % range.step != 0)
    deck_.fail(line.number, fmt::format("out of range: GENERATE {}, {}, {}; expected first <= last, and a step that "
                                        "leads from the first to the last number",
                                        range.first, range.last, range.step));
  return range;
}

AbaqusChoice AbaqusSetReader::choice_of(const DeckLine& line, std::string_view field, int instance, AbaqusScope& scope,
                                        Kind kind) const {
  if (field.empty())
    deck_.fail(line.number, "missing entry: a field is empty; expected a number or the name of a set between commas");
  if (is_number(field)) {
    const std::int64_t number = number_in(deck_, line, field, "a number");
    return {.members = {{.first = number, .last = number, .instance = instance, .line = line.number}},
            .of_elements = {}};
  }
  return choice_of_set(line, field, instance, scope, kind);
}

AbaqusChoice AbaqusSetReader::choice_of_set(const DeckLine& line, std::string_view field, int instance,
                                            AbaqusScope& scope, Kind kind) const {
  const auto sets_of = [&](AbaqusScope& of) -> AbaqusSets& {
    return kind == Kind::nodes ? of.node_sets : of.element_sets;
  };
  const std::size_t point = point_in(field);
  AbaqusSets& known = instance < 0 ? sets_of(scope) : sets_of(model_.parts[model_.instances[instance].part]);
  if (const auto found = known.find(label_of(field).key); found != known.end()) {
    if (found->second.taken_at == 0) {  // no member comes to it from now on
      keep_once(found->second.members);
      keep_once(found->second.of_elements);
    }
    found->second.taken_at = line.number;
    AbaqusChoice choice = found->second;
    for (auto* members : {&choice.members, &choice.of_elements})
      for (AbaqusMembers& one : *members)
        if (instance >= 0) one.instance = instance;
    return choice;
  }
  if (instance < 0 && point != std::string_view::npos) {
    const bool digits = is_number(field.substr(0, point)) && is_number(field.substr(point + 1));
    if (digits && !has_instance(label_of(trimmed(field.substr(0, point)))))
      deck_.fail(line.number,
                 fmt::format("invalid value '{}'; expected an integer, or the name of a set", excerpt(field)));
    const int behind = instance_called(label_of(trimmed(field.substr(0, point))), line.number);
    return choice_of(line, trimmed(field.substr(point + 1)), behind, scope, kind);
  }
  deck_.fail(line.number, fmt::format("unknown set '{}'; expected a number, or a set defined above", excerpt(field)));
}

int AbaqusSetReader::face_of(const DeckLine& line, std::string_view field) const {
  static const std::set<std::string> edges{"E1", "E2", "E3", "E4", "END1", "END2"};
  const std::string face = upper_case(field);
  if (face == "SPOS") return AbaqusSurface::top;
  if (face == "SNEG") return AbaqusSurface::bottom;
  if (edges.contains(face)) return AbaqusSurface::edge;
  if (face.size() != 2 || face[0] != 'S' || face[1] < '1' || face[1] > '6')
    deck_.fail(line.number,
               fmt::format("invalid face '{}'; expected S1 to S6, of shells SPOS or SNEG, or none", excerpt(field)));
  return face[1] - '0';
}

void AbaqusSetReader::add_surface(const DeckCard& card, AbaqusScope& scope) const {
  static const std::set<std::string> not_read{"CYLINDER", "REVOLUTION",       "SEGMENTS", "CUTTINGSURFACE",
                                              "USER",     "EULERIANMATERIAL", "XFEM"};
  const std::string type = compact(card.value("TYPE"));
  const DeckLabel name = needed_label(deck_, card, "NAME");
  if (not_read.contains(type)) {
    model_.notes.push_back(fmt::format("{}: surface {} of type {} is not read", deck_.place(card.line),
                                       excerpt(name.shown), excerpt(card.value("TYPE"))));
    return;
  }
  if (card.has("TYPE") && type != "ELEMENT" && type != "NODE")
    deck_.fail(card.line,
               fmt::format("invalid TYPE={} of *SURFACE; expected ELEMENT or NODE", excerpt(card.value("TYPE"))));
  if (std::ranges::any_of(scope.surfaces,
                          [&](const auto& one) { return one.name.key == name.key || one.name.shown == name.shown; }))
    deck_.fail(card.line,
               fmt::format("invalid surface '{}': defined twice; expected each surface once", excerpt(name.shown)));
  AbaqusSurface surface{.name = name, .of_nodes = type == "NODE", .line = card.line, .pieces = {}};
  std::set<std::string_view> lines_taken;
  for (const DeckLine& line : card.data) {
    if (!lines_taken.insert(line.text).second) continue;  // the same faces or nodes again
    const auto fields = deck_.fields(line);
    if (fields.size() > 2)
      deck_.fail(line.number, fmt::format("invalid line of {} entries in *SURFACE; expected a set or number, and a "
                                          "face",
                                          fields.size()));
    AbaqusSurface::Piece piece;
    static_cast<AbaqusChoice&>(piece) =
        choice_of(line, fields[0], -1, scope, surface.of_nodes ? Kind::nodes : Kind::elements);
    piece.line = line.number;
    if (!surface.of_nodes && fields.size() > 1) piece.face = face_of(line, fields[1]);
    surface.pieces.push_back(std::move(piece));
  }
  scope.surfaces.push_back(std::move(surface));
}

}  // namespace brunt::io
