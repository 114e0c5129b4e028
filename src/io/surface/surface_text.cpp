// SPDX-License-Identifier: Apache-2.0
// Words and numbers of a text in memory (see the header).
#include "surface_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "core/letter_case.hpp"
#include "io/surface/surface_file.hpp"

namespace brunt::io {
namespace {

constexpr std::array<std::string_view, 3> axis_names = {"x", "y", "z"};

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

template <class T>
bool parse(std::string_view word, T& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size();
}

}  // namespace

bool parse_number(std::string_view word, std::int64_t& value) {
  return parse(word, value);
}

bool parse_number(std::string_view word, double& value) {
  return parse(word, value);
}

bool TextCursor::next_line() {
  if (next_ >= text_.size()) {
    at_ = end_ = text_.size();
    return false;
  }
  at_ = next_;
  end_ = std::min(text_.find('\n', at_), text_.size());
  next_ = end_ + 1;
  ++line_;
  return true;
}

bool TextCursor::next_filled_line() {
  while (next_line())
    if (!blank_from(at_)) return true;
  return false;
}

bool TextCursor::blank_from(std::size_t position) const {
  while (position < end_ && is_blank(text_[position])) ++position;
  return position == end_;
}

std::string_view TextCursor::word() {
  const bool obj = syntax_ == LineSyntax::obj;
  for (;;) {
    while (at_ < end_ && is_blank(text_[at_])) ++at_;
    if (at_ == end_) return {};
    if (obj && text_[at_] == '#') {
      skip_line();
      return {};
    }
    if (!obj || text_[at_] != '\\' || !blank_from(at_ + 1)) break;
    if (!next_line()) return {};
  }
  const std::size_t first = at_++;
  while (at_ < end_ && !is_blank(text_[at_]) &&
         !(obj && (text_[at_] == '#' || (text_[at_] == '\\' && blank_from(at_ + 1)))))
    ++at_;
  return text_.substr(first, at_ - first);
}

std::string_view TextCursor::word_anywhere() {
  std::string_view found = word();
  while (found.empty() && next_line()) found = word();
  return found;
}

std::int64_t TextCursor::integer(std::string_view what) {
  const std::string_view found = word();
  if (found.empty()) fail(fmt::format("missing {}; expected an integer", what));
  std::int64_t value = 0;
  if (!parse_number(found, value)) fail(fmt::format("invalid {} '{}'; expected an integer", what, excerpt(found)));
  return value;
}

double TextCursor::real(std::string_view what) {
  const std::string_view found = word();
  if (found.empty()) fail(fmt::format("missing {}; expected a number", what));
  double value = 0;
  if (!parse_number(found, value)) fail(fmt::format("invalid {} '{}'; expected a number", what, excerpt(found)));
  return value;
}

Vec3 TextCursor::point() {
  constexpr std::array<std::string_view, 3> coordinates = {"coordinate x", "coordinate y", "coordinate z"};
  Vec3 x;
  for (int axis = 0; axis < 3; ++axis) {
    x[axis] = real(nth(coordinates, axis));
    if (const std::string fault = coordinate_fault(axis, x[axis]); !fault.empty()) fail(fault);
  }
  return x;
}

void TextCursor::fail(const std::string& fault) const {
  throw InputError(fmt::format("{}:{}: {}", name_, line_, fault));
}

std::string coordinate_fault(int axis, double value) {
  if (std::abs(value) <= largest_coordinate) return {};
  const std::string_view name = nth(axis_names, axis);
  // the sign of a NaN means nothing
  if (std::isnan(value)) return fmt::format("invalid coordinate {}: nan; expected a finite number", name);
  if (std::isinf(value)) return fmt::format("invalid coordinate {}: {}; expected a finite number", name, value);
  return fmt::format("out of range: coordinate {} is {}; expected a magnitude of at most {}", name, value,
                     largest_coordinate);
}

bool is_web_page(std::string_view text) {
  constexpr std::size_t length = 512;  // bytes: the first tags of a page
  const std::string start = lower_case(text.substr(0, length));
  const auto first = start.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != std::string::npos && start[first] == '<' && start.find("<html") != std::string::npos;
}

}  // namespace brunt::io
