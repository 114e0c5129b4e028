// SPDX-License-Identifier: Apache-2.0
// An Abaqus input file as cards: a keyword, its parameters, and the following lines of data.
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
  int number = 0;  ///< counted over all files in the order of reading: `AbaqusDeck::place` gives file and line
};

struct DeckCard {
  std::string keyword;  ///< in capitals, without the star
  std::map<std::string, std::string>
      parameter;               ///< names in capitals; values without quotes, empty where there is none
  int line = 0;                ///< as of a DeckLine
  std::vector<DeckLine> data;  ///< without comments and blank lines

  [[nodiscard]] bool has(const std::string& name) const { return parameter.contains(name); }
  /// Empty if it is not given.
  [[nodiscard]] std::string value(const std::string& name) const;
};

class AbaqusDeck {
 public:
  /// Reads the file and the files that it includes (*INCLUDE, and INPUT= of *NODE, *ELEMENT, *NSET, *ELSET), relative
  /// to the folder of the including file. Throws InputError if a file cannot be read or includes itself.
  explicit AbaqusDeck(const std::string& path);

  [[nodiscard]] const std::vector<DeckCard>& cards() const { return cards_; }
  [[nodiscard]] std::int64_t integer(const DeckLine& line, std::string_view field, std::string_view what) const;
  [[nodiscard]] double real(const DeckLine& line, std::string_view field, std::string_view what) const;
  /// "FILE:LINE".
  [[nodiscard]] std::string place(int line) const;
  [[noreturn]] void fail(int line, const std::string& what) const;

 private:
  /// Consecutive lines of one file.
  struct Run {
    std::string path;
    int first_number = 0, first_line = 0;
  };

  void read_file(const std::string& path, int depth);
  void add_card(std::string_view text, int line);
  void include(const std::string& from, const std::string& name, int line, int depth);
  void take_inclusion(const std::string& path, int depth);

  std::vector<std::unique_ptr<const std::string>> texts_;  // the cards' lines point into them
  std::vector<Run> runs_;                                  ///< ascending in first_number
  std::vector<std::string> open_;                          ///< files that are being read, the outermost first
  int count_ = 0;                                          ///< lines so far
  int included_ = 0;                                       ///< files so far
  std::vector<DeckCard> cards_;
};

/// The fields between commas, trimmed; an empty last field does not count.
std::vector<std::string_view> fields_of(std::string_view line);

/// Labels do not depend on the case of letters.
std::string in_capitals(std::string_view text);

}  // namespace brunt::io
