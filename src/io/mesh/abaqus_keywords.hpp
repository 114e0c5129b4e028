// SPDX-License-Identifier: Apache-2.0
// What becomes of each keyword of an Abaqus input file and of each of its parameters. src/io/README.md shows the table.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "abaqus_deck.hpp"

namespace brunt::io {

/// read: it defines the mesh. none: it cannot change the mesh. refused: it would change the mesh and is not supported.
enum class DeckEffect { read, none, refused };

struct DeckParameter {
  std::string_view name;
  DeckEffect effect = DeckEffect::read;
  std::string_view cure{};  ///< of a refused one: what is expected
};

enum class DeckData { none, any, needed };

struct DeckKeyword {
  std::string_view name;
  DeckEffect effect = DeckEffect::read;
  std::string_view cure{};  ///< of a refused one: what is expected
  DeckData data = DeckData::any;
  std::vector<DeckParameter> parameters{};
  bool any_parameter = false;  ///< further parameters are without effect
};

/// All keywords that are read or refused.
const std::vector<DeckKeyword>& deck_keywords();

/// Throws InputError for a refused keyword, for a parameter that is unknown or refused, and for data that is missing or
/// not allowed. Adds a note for a keyword that is not in the Abaqus Keywords Guide. False: the card is not read.
bool is_read(const AbaqusDeck& deck, const DeckCard& card, std::vector<std::string>& notes);

}  // namespace brunt::io
