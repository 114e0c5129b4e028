// SPDX-License-Identifier: Apache-2.0
#include "abaqus_deck.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>

#include "brunt/core/error.hpp"
#include "brunt/io/csv.hpp"
#include "brunt/io/text_file.hpp"

namespace brunt::io {
namespace {

std::string unquoted(std::string_view text) {
  const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return std::string(quoted ? text.substr(1, text.size() - 2) : text);
}

}  // namespace

std::string in_capitals(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return result;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields = comma_fields(line);
  if (fields.back().empty()) fields.pop_back();
  return fields;
}

std::string DeckCard::value(const std::string& name) const {
  const auto found = parameter.find(name);
  return found == parameter.end() ? "" : found->second;
}

AbaqusDeck::AbaqusDeck(const std::string& path) {
  read_file(path, 0);
}

void AbaqusDeck::read_file(const std::string& path, int depth) {
  const std::string_view text = *texts_.emplace_back(std::make_unique<const std::string>(read_text(path)));
  open_.push_back(std::filesystem::weakly_canonical(path).string());
  runs_.push_back({path, count_ + 1, 1});
  bool goes_on = false;  // a keyword line that ends in a comma
  int line_of_file = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string_view line = trimmed(text.substr(from, end - from));
    from = end + 1;
    ++line_of_file;
    if (count_ == std::numeric_limits<int>::max())
      fail(count_, "out of range: the deck has more than 2^31 lines; expected fewer");
    const int number = ++count_;
    if (line.empty() || line.starts_with("**")) continue;
    if (line.front() == '*' || goes_on) {
      if (!goes_on) cards_.push_back({.keyword = {}, .parameter = {}, .line = number, .data = {}});
      add_card(goes_on ? line : line.substr(1), number);
      goes_on = line.back() == ',';
      if (goes_on) continue;
      const std::size_t runs = runs_.size();
      take_inclusion(path, depth);
      if (runs_.size() > runs) runs_.push_back({path, count_ + 1, line_of_file + 1});
    } else {
      if (cards_.empty()) fail(number, "invalid data before the first keyword; expected a line that begins with *");
      cards_.back().data.push_back({line, number});
    }
  }
  open_.pop_back();
}

void AbaqusDeck::take_inclusion(const std::string& path, int depth) {
  static constexpr std::array with_data{"NODE", "ELEMENT", "NSET", "ELSET"};
  const DeckCard& card = cards_.back();
  const bool whole = card.keyword == "INCLUDE";
  if (!whole && (std::ranges::find(with_data, card.keyword) == with_data.end() || !card.has("INPUT"))) return;
  const std::string name = card.value("INPUT");
  const int line = card.line;
  if (name.empty()) fail(line, fmt::format("missing file of *{}; expected INPUT=FILE", card.keyword));
  if (whole) cards_.pop_back();  // what the file holds may go on the card before
  include(path, name, line, depth);
}

void AbaqusDeck::include(const std::string& from, const std::string& name, int line, int depth) {
  namespace fs = std::filesystem;
  constexpr int deepest = 32;         // each level is a file within another; Abaqus itself allows 5
  constexpr int most_files = 10'000;  // read one after the other, such as a file for each part of a large assembly
  const std::string path = (fs::path(from).parent_path() / name).lexically_normal().string();
  std::error_code unreadable;
  const std::string named = path == name ? fmt::format("'{}'", name) : fmt::format("'{}' ({})", name, path);
  if (!fs::exists(path, unreadable))
    fail(line, fmt::format("cannot read the included file {}: it does not exist; expected an existing file", named));
  if (!fs::is_regular_file(path, unreadable))
    fail(line,
         fmt::format("cannot read the included file {}: it is not a regular file; expected a regular file", named));
  if (std::ranges::find(open_, fs::weakly_canonical(path).string()) != open_.end())
    fail(line, fmt::format("invalid included file {}: it includes itself; expected another file", named));
  if (depth + 1 > deepest)
    fail(line, fmt::format("out of range: more than {} nested included files; expected fewer", deepest));
  if (++included_ > most_files)
    fail(line, fmt::format("out of range: more than {} included files; expected fewer", most_files));
  try {
    read_file(path, depth + 1);
  } catch (const InputError& error) {
    if (runs_.back().path == path || !std::string_view(error.what()).starts_with(path + ": cannot")) throw;
    fail(line, fmt::format("cannot read the included file {}; expected a readable file", named));
  }
}

void AbaqusDeck::add_card(std::string_view text, int line) {
  DeckCard& card = cards_.back();
  for (const std::string_view field : fields_of(text)) {
    if (card.keyword.empty()) {
      card.keyword = in_capitals(field);
      continue;
    }
    const auto equals = field.find('=');
    const std::string name = in_capitals(trimmed(field.substr(0, equals)));
    if (name.empty()) fail(line, fmt::format("missing name of a parameter of *{}; expected NAME=VALUE", card.keyword));
    card.parameter[name] = equals == std::string_view::npos ? "" : unquoted(trimmed(field.substr(equals + 1)));
  }
  if (card.keyword.empty()) fail(line, "missing keyword after the star; expected *KEYWORD");
}

std::int64_t AbaqusDeck::integer(const DeckLine& line, std::string_view field, std::string_view what) const {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size())
    fail(line.number, fmt::format("invalid value '{}'; expected {}", field.substr(0, 40), what));
  return value;
}

double AbaqusDeck::real(const DeckLine& line, std::string_view field, std::string_view what) const {
  if (field.empty()) return 0;  // as Abaqus has it
  std::string written(field.starts_with('+') ? field.substr(1) : field);
  std::ranges::replace_if(
      written, [](char c) { return c == 'd' || c == 'D'; }, 'e');  // Fortran's exponents
  double value = 0;
  const auto [end, error] = std::from_chars(written.data(), written.data() + written.size(), value);
  if (error != std::errc{} || end != written.data() + written.size() || !std::isfinite(value))
    fail(line.number, fmt::format("invalid value '{}'; expected {}", field.substr(0, 40), what));
  return value;
}

std::string AbaqusDeck::place(int line) const {
  const auto after = std::ranges::upper_bound(runs_, line, {}, &Run::first_number);
  const Run& run = after == runs_.begin() ? *after : *std::prev(after);
  return fmt::format("{}:{}", run.path, run.first_line + line - run.first_number);
}

void AbaqusDeck::fail(int line, const std::string& what) const {
  throw InputError(fmt::format("{}: {}", place(line), what));
}

}  // namespace brunt::io
