// SPDX-License-Identifier: Apache-2.0
// An Abaqus input file as cards: a keyword, its parameters, and the lines of data that follow.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace brunt::io {

struct DeckLine {
  std::string_view text;
  int number = 0;
};

struct DeckCard {
  std::string keyword;  ///< in capitals, without the star
  std::map<std::string, std::string>
      parameter;  ///< names in capitals; values without quotes, empty where there is none
  int line = 0;
  std::vector<DeckLine> data;  ///< without comments and blank lines

  [[nodiscard]] bool has(const std::string& name) const { return parameter.contains(name); }
  /// Empty where it is not there.
  [[nodiscard]] std::string value(const std::string& name) const;
};

class AbaqusDeck {
 public:
  /// Throws InputError if the file cannot be read.
  explicit AbaqusDeck(const std::string& path);

  [[nodiscard]] const std::vector<DeckCard>& cards() const { return cards_; }
  [[nodiscard]] std::int64_t integer(const DeckLine& line, std::string_view field, std::string_view what) const;
  [[nodiscard]] double real(const DeckLine& line, std::string_view field, std::string_view what) const;
  [[noreturn]] void fail(int line, const std::string& what) const;

 private:
  void add_card(std::string_view text, int line);

  std::string path_;
  std::unique_ptr<const std::string> text_;  // the cards' lines point into it
  std::vector<DeckCard> cards_;
};

/// What stands between commas, without blanks at its ends; an empty last field is none.
std::vector<std::string_view> fields_of(std::string_view line);

/// Labels are the same in capitals and small letters.
std::string in_capitals(std::string_view text);

}  // namespace brunt::io
