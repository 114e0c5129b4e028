// SPDX-License-Identifier: Apache-2.0
// An Abaqus input file as cards: a keyword, its parameters, and the following lines of data.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace brunt::io {

struct DeckLine {
  std::string_view text;
  int number = 0;  ///< counted over all files in the order of reading: `AbaqusDeck::place` gives file and line
};

/// A name of the deck. Names are compared by their keys: without quotation marks in capitals and without blanks, within
/// them as written (Abaqus Analysis Guide, "Input syntax rules").
struct DeckLabel {
  std::string shown;  ///< as written, without quotation marks
  std::string key;
};

struct DeckCard {
  std::string keyword;  ///< in capitals, without the star; words are separated by one blank
  /// Names in capitals and without blanks; values as written, empty where there is none.
  std::map<std::string, std::string> parameter;
  int line = 0;                ///< as of a DeckLine
  std::vector<DeckLine> data;  ///< without comments and blank lines
  std::string fault{};         ///< of its parameters, if the card is read

  [[nodiscard]] bool has(const std::string& name) const { return parameter.contains(name); }
  /// Without quotation marks. Empty if it is not given.
  [[nodiscard]] std::string value(const std::string& name) const;
  [[nodiscard]] DeckLabel label(const std::string& name) const;
};

/// Where a file ends: its last line that is no comment, and the card that this line belongs to.
struct DeckEnd {
  int line = 0;
  std::size_t card = 0;
};

class AbaqusDeck {
 public:
  /// Reads the file and the files that it includes (*INCLUDE, and INPUT= of *NODE, *ELEMENT, *NSET, *ELSET), relative
  /// to the folder of the including file. Throws InputError if a file cannot be read or includes itself.
  explicit AbaqusDeck(const std::string& path);

  [[nodiscard]] const std::vector<DeckCard>& cards() const { return cards_; }
  /// The fields between commas outside of quotation marks, trimmed; an empty last field does not count.
  [[nodiscard]] std::vector<std::string_view> fields(const DeckLine& line) const;
  [[nodiscard]] std::int64_t integer(const DeckLine& line, std::string_view field, std::string_view what) const;
  [[nodiscard]] double real(const DeckLine& line, std::string_view field, std::string_view what) const;
  /// The last line of a file, if it has no line end.
  [[nodiscard]] bool is_unended(const DeckLine& line) const { return unended_.contains(line.number); }
  /// Of the files that have cards or data, in the order in which their reading ended: the main one is the last.
  [[nodiscard]] const std::vector<DeckEnd>& ends() const { return ends_; }
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
  /// One line of a file; true if it is a keyword line that goes on in the next one.
  bool read_line(std::string_view line, bool goes_on);
  void add_card(std::string_view text, int line);
  void include(const std::string& from, const std::string& name, int line, int depth);
  void take_inclusion(const std::string& path, int depth);

  std::vector<std::unique_ptr<const std::string>> texts_;  // the cards' lines point into them
  std::vector<Run> runs_;                                  ///< ascending in first_number
  std::set<int> unended_;
  std::vector<DeckEnd> ends_;
  std::vector<std::string> open_;  ///< files that are being read, the outermost first
  int count_ = 0;                  ///< lines so far
  int included_ = 0;               ///< files so far
  std::vector<DeckCard> cards_;
};

/// text: trimmed, perhaps in quotation marks.
DeckLabel label_of(std::string_view text);

/// In capitals and without blanks: as keywords and names of parameters are compared.
std::string compact(std::string_view text);

/// For messages: with '?' for control characters.
std::string printable(std::string_view text);

}  // namespace brunt::io
