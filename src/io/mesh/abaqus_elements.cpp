// SPDX-License-Identifier: Apache-2.0
#include "abaqus_elements.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "core/excerpt.hpp"

namespace brunt::io {
namespace {

constexpr std::string_view element_types =
    "C3D4, C3D5, C3D6, C3D8 and their variants (C3D8R, ...), or shells S4, S4R, S3, S3R, STRI3";

/// One element's fields, over one line or several.
struct Row {
  std::vector<std::pair<const DeckLine*, std::string_view>> fields;
  int line = 0;
};

/// Reads from line `at` of the card to the end of an element, and moves `at` to its last line.
Row next_row(const AbaqusDeck& deck, const DeckCard& card, std::size_t corners, std::size_t& at) {
  Row row{.fields = {}, .line = card.data[at].number};
  for (;; ++at) {
    for (const std::string_view field : deck.fields(card.data[at])) row.fields.emplace_back(&card.data[at], field);
    if (row.fields.size() > corners) return row;
    if (at + 1 == card.data.size())
      deck.fail(card.data[at].number,
                fmt::format(
                    "missing node numbers: {} numbers are given; expected the number of an element and of its {} nodes",
                    row.fields.size(), corners));
  }
}

void need_new(const AbaqusDeck& deck, const AbaqusPart& part, std::int64_t number, int line) {
  if (part.element_at.contains(number) || part.other_at.contains(number))
    deck.fail(line, fmt::format("invalid element {}: defined twice; expected each element once", number));
}

AbaqusElement element_in(const AbaqusDeck& deck, const AbaqusPart& part, const Row& row,
                         const AbaqusElementType& type) {
  const int corners = type.corners;
  AbaqusElement element{
      .number = number_in(deck, *row.fields[0].first, row.fields[0].second, "the number of an element"),
      .corners = corners,
      .line = row.line,
      .shell = type.shell};
  const auto count = static_cast<std::size_t>(corners);
  if (row.fields.size() != count + 1)
    deck.fail(row.line, fmt::format("invalid element {} of {} nodes; expected {} nodes for its type", element.number,
                                    row.fields.size() - 1, corners));
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [line, field] = row.fields[k + 1];
    const std::int64_t number = number_in(deck, *line, field, "a node's number");
    const auto found = part.node_at.find(number);
    if (found == part.node_at.end())
      deck.fail(row.line, fmt::format("unknown node {}; expected a node defined above", number));
    element.nodes[k] = found->second;
  }
  return element;
}

/// What may follow the number of nodes: R, I, H, T, P, E, S and their combinations.
bool is_variant(std::string_view letters) {
  return letters.find_first_not_of("RIHTPES") == std::string_view::npos;
}

/// Shells of first order with six degrees of freedom at a node, or five; others are refused in words, or are none.
bool read_shell(AbaqusElementType& type) {
  static const std::set<std::string_view> quadrilaterals{"S4", "S4R", "S4RS", "S4RSW", "S4R5", "S4T", "S4RT"},
      triangles{"S3", "S3R", "S3RS", "S3T", "S3RT", "STRI3"}, second_order{"S8R", "S8R5", "S8RT", "S9R5", "STRI65"};
  type.shell = true;
  if (quadrilaterals.contains(type.name))
    type.corners = 4;
  else if (triangles.contains(type.name))
    type.corners = 3;
  else if (second_order.contains(type.name))
    type.fault =
        fmt::format("invalid element type {}, a shell of second order; expected {}", excerpt(type.name), element_types);
  else
    type.shell = false;
  return type.shell;
}

}  // namespace

AbaqusElementType element_type_of(const DeckCard& card) {
  AbaqusElementType type{.name = compact(card.value("TYPE"))};
  for (const std::string_view passed : {"T2D", "T3D", "CPS", "CPE", "CAX", "SFM3D"})
    if (type.name.starts_with(passed)) return type;
  if (read_shell(type)) return type;
  const std::string_view digits = std::string_view(type.name).substr(std::min<std::size_t>(3, type.name.size()));
  const std::string_view count = digits.substr(0, digits.find_first_not_of("0123456789"));
  const bool solid = type.name.starts_with("C3D");
  const bool first_order = count == "4" || count == "5" || count == "6" || count == "8";
  if (solid && first_order && is_variant(digits.substr(1)))
    type.corners = count[0] - '0';
  else if (solid && first_order)
    type.fault = fmt::format("unknown element type {}; expected {}", excerpt(type.name), element_types);
  else if (solid && !count.empty())
    type.fault = fmt::format("invalid element type {} of second order; expected {}", excerpt(type.name), element_types);
  else
    type.fault = fmt::format("invalid element type '{}': no solid or shell that is read; expected {}",
                             excerpt(card.value("TYPE")), element_types);
  return type;
}

std::vector<std::pair<std::int64_t, int>> other_elements_of(const AbaqusDeck& deck, const DeckCard& card) {
  std::vector<std::pair<std::int64_t, int>> numbers;
  bool goes_on = false;  // how many nodes there are is not known: a line that ends in a comma goes on in the next one
  for (const DeckLine& line : card.data) {
    if (!goes_on)
      numbers.emplace_back(number_in(deck, line, deck.fields(line)[0], "the number of an element"), line.number);
    goes_on = line.text.back() == ',';
  }
  return numbers;
}

void add_abaqus_elements(const AbaqusDeck& deck, const DeckCard& card, AbaqusPart& part, const std::string& dealt,
                         AbaqusSet* set) {
  const AbaqusElementType type = element_type_of(card);
  if (card.data.empty())
    deck.fail(card.line, type.fault.empty() ? "missing data of *ELEMENT; expected at least one element" : type.fault);
  const auto add_to_set = [&](std::int64_t number, int line) {
    if (set != nullptr) set->members.push_back({.first = number, .last = number, .line = line});
  };
  if (type.corners == 0) {
    for (const auto& [number, line] : other_elements_of(deck, card)) {
      need_new(deck, part, number, line);
      part.other_at.emplace(number, part.others.size());
      part.others.push_back({number, type.name, dealt, type.fault, card.line});
      add_to_set(number, line);
    }
    return;
  }
  for (std::size_t at = 0; at < card.data.size(); ++at) {
    const Row row = next_row(deck, card, static_cast<std::size_t>(type.corners), at);
    const AbaqusElement element = element_in(deck, part, row, type);
    need_new(deck, part, element.number, row.line);
    part.element_at.emplace(element.number, static_cast<LocalIndex>(part.elements.size()));
    part.elements.push_back(element);
    part.dealt.push_back(dealt);
    add_to_set(element.number, row.line);
  }
}

}  // namespace brunt::io
