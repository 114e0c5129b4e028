// SPDX-License-Identifier: Apache-2.0
// Reads the lines of a text file number by number, and knows where it is.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace brunt::io {

class LineReader {
 public:
  explicit LineReader(const std::string& path);

  /// Goes to the next line that is not blank; false at the end of the file.
  bool next_line();
  /// The same, but the end of the file is a fault: `wanted` says what is missing.
  void need_line(std::string_view wanted);

  /// The line from here on, without blanks at its ends.
  [[nodiscard]] std::string_view rest() const;
  /// Next number on this line; a fault if there is none.
  std::int64_t integer(std::string_view what);
  double real(std::string_view what);
  /// Next number that says how many entries follow: a fault if the rest of the file cannot hold so many.
  std::int64_t count(std::string_view what);
  /// A text in quotes.
  std::string quoted(std::string_view what);

  [[nodiscard]] int line() const { return line_; }
  /// "FILE:LINE".
  [[nodiscard]] std::string place(int line) const { return path_ + ":" + std::to_string(line); }
  [[noreturn]] void fail(const std::string& what) const { fail_at(line_, what); }
  [[noreturn]] void fail_at(int line, const std::string& what) const;

 private:
  std::string_view token(std::string_view what);

  std::string path_, text_;
  std::size_t next_ = 0, at_ = 0, end_ = 0;  // start of the next line; position in and end of this one
  int line_ = 0;
};

}  // namespace brunt::io
