// SPDX-License-Identifier: Apache-2.0
// Numbers from lines, with a fault that names the line.
#include "gmsh_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "io/text_file.hpp"

namespace brunt::io {
namespace {

constexpr std::string_view blanks = " \t\r";

template <class T>
bool parsed(std::string_view token, T& value) {
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  return error == std::errc{} && end == token.data() + token.size();
}

}  // namespace

LineReader::LineReader(const std::string& path) : path_(path), text_(plain_text(read_text(path), path)) {}

bool LineReader::next_line() {
  while (next_ < text_.size()) {
    at_ = next_;
    end_ = std::min(text_.find('\n', at_), text_.size());
    next_ = end_ + 1;
    ++line_;
    if (!rest().empty()) return true;
  }
  at_ = end_ = text_.size();
  return false;
}

void LineReader::need_line(std::string_view wanted) {
  if (!next_line()) fail(fmt::format("missing line: the file is truncated; expected {}", wanted));
}

std::string_view LineReader::rest() const {
  const std::string_view line = std::string_view(text_).substr(at_, end_ - at_);
  const auto first = line.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

std::string_view LineReader::token(std::string_view what) {
  const std::string_view line = rest();
  if (line.empty()) fail(fmt::format("missing value at the end of the line; expected {}", what));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  at_ = static_cast<std::size_t>(word.data() - text_.data()) + word.size();
  return word;
}

std::int64_t LineReader::integer(std::string_view what) {
  const std::string_view word = token(what);
  std::int64_t value = 0;
  if (!parsed(word, value)) fail(fmt::format("invalid value '{}'; expected {}", excerpt(word), what));
  return value;
}

double LineReader::real(std::string_view what) {
  const std::string_view word = token(what);
  double value = 0;
  if (!parsed(word, value)) fail(fmt::format("invalid value '{}'; expected {}", excerpt(word), what));
  return value;
}

std::int64_t LineReader::count(std::string_view what) {
  const std::int64_t value = integer(what);
  const auto left = static_cast<std::int64_t>(text_.size() - at_);
  if (value < 0 || value > left)
    fail(fmt::format("out of range: {} is {}; expected no more than the rest of the file can hold", what, value));
  return value;
}

std::string LineReader::quoted(std::string_view what) {
  const std::string_view line = rest();
  const auto close = line.find('"', 1);
  if (line.empty() || line[0] != '"' || close == std::string_view::npos)
    fail(fmt::format("invalid text; expected {} in double quotes", what));
  return std::string(line.substr(1, close - 1));
}

void LineReader::fail_at(int line, const std::string& what) const {
  throw InputError(fmt::format("{}:{}: {}", path_, line, what));
}

}  // namespace brunt::io
