// SPDX-License-Identifier: Apache-2.0
// The words of a text in memory, line by line, with faults that name the line. A view: nothing is copied.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "core/types.hpp"

namespace brunt::io {

/// What OBJ adds to plain lines of words: `#` begins a comment, and `\` at the end of a line continues it.
enum class LineSyntax { plain, obj };

class TextCursor {
 public:
  /// `lines`: of the file, before the text. A byte order mark at the beginning of a file is passed over.
  TextCursor(std::string_view text, const std::string& name, LineSyntax syntax = LineSyntax::plain,
             std::int64_t lines = 0)
      : text_(text),
        name_(name),
        syntax_(syntax),
        next_(lines == 0 && text.starts_with("\xEF\xBB\xBF") ? 3 : 0),
        line_(lines) {}

  /// Goes to the next line, blank or not; false at the end of the text.
  bool next_line();
  /// Goes to the next line that is not blank; false at the end of the text.
  bool next_filled_line();
  /// The next word of this line; empty at its end.
  std::string_view word();
  /// The next word, on this line or a later one; empty at the end of the text.
  std::string_view word_anywhere();
  /// The rest of this line is passed over.
  void skip_line() { at_ = end_; }

  /// The next word of this line as a number; `what` names it in a fault.
  std::int64_t integer(std::string_view what);
  double real(std::string_view what);
  /// The next three words as coordinates.
  Vec3 point();

  [[nodiscard]] std::int64_t line() const { return line_; }
  /// The position in the text at which the next line begins.
  [[nodiscard]] std::size_t next() const { return next_; }
  /// Throws InputError "NAME:LINE: FAULT".
  [[noreturn]] void fail(const std::string& fault) const;

 private:
  /// Only blanks follow in this line.
  [[nodiscard]] bool blank_from(std::size_t position) const;

  std::string_view text_;
  const std::string& name_;
  LineSyntax syntax_;
  std::size_t next_;              // start of the next line
  std::size_t at_ = 0, end_ = 0;  // position in this line, and its end
  std::int64_t line_;
};

/// A number as a whole word, a leading + allowed; false if it is none, or out of the range of the type.
bool parse_number(std::string_view word, std::int64_t& value);
bool parse_number(std::string_view word, double& value);

/// What is wrong with a coordinate, as "coordinate x is nan; expected ..."; empty where it is sound. axis: 0, 1, 2.
std::string coordinate_fault(int axis, double value);

/// Does the text begin as a web page does? Downloads that failed are often such.
bool is_web_page(std::string_view text);

}  // namespace brunt::io
