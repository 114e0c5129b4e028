// SPDX-License-Identifier: Apache-2.0
// Sets and surfaces of an Abaqus input file, by number, range and name.
#pragma once
#include "abaqus_parts.hpp"

namespace brunt::io {

class AbaqusSetReader {
 public:
  AbaqusSetReader(const AbaqusDeck& deck, AbaqusModel& model) : deck_(deck), model_(model) {}

  /// The set that a parameter names, new or with its members so far. Throws InputError if another set has taken them.
  AbaqusSet& named(const DeckCard& card, AbaqusSets& sets, const std::string& parameter) const;
  void add_node_set(const DeckCard& card, AbaqusScope& scope) const;
  void add_element_set(const DeckCard& card, AbaqusScope& scope) const;
  void add_surface(const DeckCard& card, AbaqusScope& scope) const;

 private:
  enum class Kind { nodes, elements };

  [[nodiscard]] int instance_of(const DeckCard& card) const;
  [[nodiscard]] bool has_instance(const DeckLabel& name) const;
  [[nodiscard]] int instance_called(const DeckLabel& name, int line) const;
  void add_data(const DeckCard& card, AbaqusScope& scope, AbaqusSet& set, Kind kind) const;
  [[nodiscard]] AbaqusMembers generated(const DeckLine& line, int instance) const;
  /// A number, a set, or either of them behind INSTANCE and a point.
  AbaqusChoice choice_of(const DeckLine& line, std::string_view field, int instance, AbaqusScope& scope,
                         Kind kind) const;
  AbaqusChoice choice_of_set(const DeckLine& line, std::string_view field, int instance, AbaqusScope& scope,
                             Kind kind) const;
  [[nodiscard]] int face_of(const DeckLine& line, std::string_view field) const;

  const AbaqusDeck& deck_;
  AbaqusModel& model_;
};

}  // namespace brunt::io
