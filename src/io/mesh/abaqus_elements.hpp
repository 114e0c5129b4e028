// SPDX-License-Identifier: Apache-2.0
// The data of *ELEMENT cards.
#pragma once
#include "abaqus_parts.hpp"

namespace brunt::io {

/// Of an element card: nodes of a solid element or shell of first order, or 0.
struct AbaqusElementType {
  std::string name;
  int corners = 0;
  bool shell = false;
  std::string fault{};  ///< of an element that is not read; empty for lines and surfaces that mesh generators write
};

AbaqusElementType element_type_of(const DeckCard& card);

/// dealt: key of the card's element set; set: that set, or null.
void add_abaqus_elements(const AbaqusDeck& deck, const DeckCard& card, AbaqusPart& part, const std::string& dealt,
                         AbaqusSet* set);

/// The numbers of elements that are not read, each with the line in which it begins.
std::vector<std::pair<std::int64_t, int>> other_elements_of(const AbaqusDeck& deck, const DeckCard& card);

}  // namespace brunt::io
