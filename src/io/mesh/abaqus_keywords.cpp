// SPDX-License-Identifier: Apache-2.0
#include "abaqus_keywords.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "abaqus_other_keywords.hpp"
#include "core/excerpt.hpp"

namespace brunt::io {
namespace {

constexpr DeckEffect none = DeckEffect::none, refused = DeckEffect::refused;

DeckKeyword generator(std::string_view name, std::string_view cure) {
  return {.name = name, .effect = refused, .cure = cure};
}

/// Their data are not read.
std::vector<DeckKeyword> sections() {
  return {{.name = "SOLID SECTION",
           .parameters = {{"ELSET"},
                          {"COMPOSITE", none},
                          {"CONTROLS", none},
                          {"LAYUP", none},
                          {"MATERIAL", none},
                          {"NODALTHICKNESS", none},
                          {"OFFSET", none},
                          {"ORDER", none},
                          {"ORIENTATION", none},
                          {"REFNODE", none},
                          {"STACKDIRECTION", none},
                          {"SYMMETRIC", none}}},
          {.name = "SHELL SECTION",
           .parameters = {{"ELSET"},
                          {"COMPOSITE", none},
                          {"CONTROLS", none},
                          {"DENSITY", none},
                          {"LAYUP", none},
                          {"MATERIAL", none},
                          {"NODALTHICKNESS", none},
                          {"OFFSET", none},
                          {"ORIENTATION", none},
                          {"POISSON", none},
                          {"SECTIONINTEGRATION", none},
                          {"SHELLTHICKNESS", none},
                          {"STACKDIRECTION", none},
                          {"SYMMETRIC", none},
                          {"TEMPERATURE", none},
                          {"THICKNESSMODULUS", none}}}};
}

/// Parameters by the Abaqus Keywords Guide of 2024; PASSWORD and INPUT of sets are of it too.
std::vector<DeckKeyword> all_keywords() {
  constexpr std::string_view nodes = "the nodes written out under *NODE",
                             elements = "the elements written out under *ELEMENT",
                             faces = "the faces written out as element sets with S1 to S6";
  return {
      {.name = "NODE", .data = DeckData::needed, .parameters = {{"INPUT"}, {"NSET"}, {"SYSTEM"}}},
      {.name = "ELEMENT",
       .data = DeckData::any,
       .parameters = {{"TYPE"},
                      {"ELSET"},
                      {"INPUT"},
                      {"FILE", refused, elements},
                      {"OFFSET", none},
                      {"SOLIDELEMENTNUMBERING", none}}},
      {.name = "NSET",
       .parameters =
           {{"NSET"}, {"ELSET"}, {"GENERATE"}, {"INSTANCE"}, {"INPUT"}, {"INTERNAL", none}, {"UNSORTED", none}}},
      {.name = "ELSET",
       .data = DeckData::needed,
       .parameters = {{"ELSET"}, {"GENERATE"}, {"INSTANCE"}, {"INPUT"}, {"INTERNAL", none}, {"UNSORTED", none}}},
      {.name = "SURFACE",
       .data = DeckData::needed,
       .parameters = {{"NAME"},
                      {"TYPE"},
                      {"COMBINE", refused, faces},
                      {"CROP", refused, faces},
                      {"TRIM", refused, faces},
                      {"DEFINITION", none},
                      {"FILLETRADIUS", none},
                      {"INTERNAL", none},
                      {"MAXRATIO", none},
                      {"NOOFFSET", none},
                      {"NOTHICK", none},
                      {"PROPERTY", none},
                      {"REGIONTYPE", none},
                      {"SCALETHICK", none}}},
      {.name = "SYSTEM"},
      {.name = "PART", .data = DeckData::none, .parameters = {{"NAME"}}},
      {.name = "END PART", .data = DeckData::none, .parameters = {{"NAME", none}}},
      {.name = "ASSEMBLY", .data = DeckData::none, .parameters = {{"NAME", none}}},
      {.name = "END ASSEMBLY", .data = DeckData::none, .parameters = {{"NAME", none}}},
      {.name = "INSTANCE",
       .parameters = {{"NAME"},
                      {"PART"},
                      {"INSTANCE", refused, "PART=NAME of a part of this file"},
                      {"LIBRARY", refused, "PART=NAME of a part of this file"}}},
      {.name = "END INSTANCE", .data = DeckData::none, .parameters = {{"NAME", none}}},
      {.name = "INCLUDE", .parameters = {{"INPUT"}, {"PASSWORD", refused, "an included file without encryption"}}},
      {.name = "STEP", .any_parameter = true},
      {.name = "END STEP", .data = DeckData::none},
      generator("NGEN", nodes),
      generator("NFILL", nodes),
      generator("NCOPY", nodes),
      generator("NMAP", "the nodes written out under *NODE at their final positions"),
      generator("ELGEN", elements),
      generator("ELCOPY", elements),
      generator("SYMMETRIC MODEL GENERATION", "nodes and elements of the whole model written out"),
      generator("PARAMETER", "numbers in place of the parameters"),
      generator("IMPERFECTION", "the nodes written out under *NODE at their final positions"),
      generator("ADJUST", "the nodes written out under *NODE at their final positions"),
      generator("IMPORT", "the nodes and elements of the imported instance written out"),
  };
}

const DeckKeyword* rule_of(const std::string& name) {
  const auto& all = deck_keywords();
  const auto found = std::ranges::find_if(all, [&](const DeckKeyword& one) { return compact(one.name) == name; });
  return found == all.end() ? nullptr : &*found;
}

std::string names_of(const DeckKeyword& rule) {
  std::string names;
  for (const DeckParameter& one : rule.parameters)
    if (one.effect != refused) names += (names.empty() ? "" : ", ") + std::string(one.name);
  return names.empty() ? "none" : names;
}

void check_parameters(const AbaqusDeck& deck, const DeckCard& card, const DeckKeyword& rule) {
  for (const auto& [name, value] : card.parameter) {
    const auto known = std::ranges::find(rule.parameters, std::string_view(name), &DeckParameter::name);
    if (known == rule.parameters.end()) {
      if (rule.any_parameter) continue;
      deck.fail(card.line, fmt::format("unknown parameter {} of *{}; expected {}, written in full", excerpt(name),
                                       rule.name, names_of(rule)));
    }
    if (known->effect == refused)
      deck.fail(card.line, fmt::format("invalid parameter {} of *{}: it would change the mesh and is not supported; "
                                       "expected {}",
                                       name, rule.name, known->cure));
  }
}

/// Not in the tables: an abbreviation of a keyword that is read would lose its data.
void check_unknown(const AbaqusDeck& deck, const DeckCard& card, const std::string& name,
                   std::vector<std::string>& notes) {
  if (is_other_keyword(name)) return;
  for (const DeckKeyword& one : deck_keywords())
    if (compact(one.name).starts_with(name))
      deck.fail(card.line,
                fmt::format("unknown keyword *{}; expected *{} written in full", excerpt(card.keyword), one.name));
  notes.push_back(fmt::format("{}: unknown keyword *{}: it and its data are not read", deck.place(card.line),
                              excerpt(card.keyword)));
}

}  // namespace

const std::vector<DeckKeyword>& deck_keywords() {
  static const std::vector<DeckKeyword> all = [] {
    std::vector<DeckKeyword> keywords = all_keywords();
    for (const DeckKeyword& section : sections()) keywords.push_back(section);
    return keywords;
  }();
  return all;
}

bool is_read(const AbaqusDeck& deck, const DeckCard& card, std::vector<std::string>& notes) {
  const std::string name = compact(card.keyword);
  const DeckKeyword* const rule = rule_of(name);
  if (rule == nullptr) {
    if (!name.ends_with("SECTION")) check_unknown(deck, card, name, notes);
    return false;
  }
  if (rule->effect == refused)
    deck.fail(card.line, fmt::format("invalid keyword *{}: it would change the mesh and is not supported; expected {}",
                                     rule->name, rule->cure));
  if (!card.fault.empty() && !rule->any_parameter)
    deck.fail(card.line, fmt::format("*{}: {}", rule->name, card.fault));  // with what is expected
  check_parameters(deck, card, *rule);
  if (rule->data == DeckData::none && !card.data.empty())
    deck.fail(card.data[0].number, fmt::format("invalid data of *{}; expected a keyword", rule->name));
  if (rule->data == DeckData::needed && card.data.empty())
    deck.fail(card.line, fmt::format("missing data of *{}; expected at least one line of data", rule->name));
  if (!card.data.empty() && deck.is_unended(card.data.back()))
    deck.fail(card.data.back().number,
              "missing line end: the last line of the file is truncated or has none; expected "
              "a complete line with a line end");
  return true;
}

}  // namespace brunt::io
