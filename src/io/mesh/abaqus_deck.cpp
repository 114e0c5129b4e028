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

#include "abaqus_keywords.hpp"
#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "core/letter_case.hpp"
#include "io/csv.hpp"
#include "io/text_file.hpp"

namespace brunt::io {
namespace {

bool is_quoted(std::string_view text) {
  return text.size() >= 2 && text.front() == '"' && text.back() == '"';
}

/// Words in capitals, separated by one blank.
std::string spaced(std::string_view text) {
  std::string result;
  for (const char c : upper_case(text))
    if (c != ' ' && c != '\t')
      result += c;
    else if (!result.ends_with(' '))
      result += ' ';
  return result;
}

}  // namespace

std::string compact(std::string_view text) {
  std::string result = upper_case(text);
  std::erase_if(result, [](char c) { return c == ' ' || c == '\t'; });
  return result;
}

std::string printable(std::string_view text) {
  std::string result(text);
  std::ranges::replace_if(
      result, [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  return result;
}

DeckLabel label_of(std::string_view text) {
  if (!is_quoted(text)) return {std::string(text), compact(text)};
  const std::string inside(text.substr(1, text.size() - 2));
  return {inside, inside};
}

std::string DeckCard::value(const std::string& name) const {
  return label(name).shown;
}

DeckLabel DeckCard::label(const std::string& name) const {
  const auto found = parameter.find(name);
  return found == parameter.end() ? DeckLabel{} : label_of(found->second);
}

AbaqusDeck::AbaqusDeck(const std::string& path) {
  read_file(path, 0);
}

std::vector<std::string_view> AbaqusDeck::fields(const DeckLine& line) const {
  std::vector<std::string_view> found;
  if (line.text.find('"') == std::string_view::npos) {
    found = comma_fields(line.text);
  } else {
    bool quoted = false;
    std::size_t from = 0;
    for (std::size_t at = 0; at <= line.text.size(); ++at)
      if (at == line.text.size() || (line.text[at] == ',' && !quoted)) {
        found.push_back(trimmed(line.text.substr(from, at - from)));
        from = at + 1;
      } else if (line.text[at] == '"') {
        quoted = !quoted;
      }
    if (quoted)
      fail(line.number, "missing quotation mark: a name in quotation marks has no end; expected '\"' behind it");
  }
  if (found.back().empty()) found.pop_back();
  return found;
}

void AbaqusDeck::read_file(const std::string& path, int depth) {
  const std::string_view text =
      *texts_.emplace_back(std::make_unique<const std::string>(plain_text(read_text(path), path)));
  open_.push_back(std::filesystem::weakly_canonical(path).string());
  runs_.push_back({path, count_ + 1, 1});
  bool goes_on = false;  // a keyword line that ends in a comma
  int line_of_file = 0, last_line = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t begin = from, end = std::min(text.find('\n', from), text.size());
    from = end + 1;
    const std::string_view line = trimmed(text.substr(begin, end - begin));
    ++line_of_file;
    if (count_ == std::numeric_limits<int>::max())
      fail(count_, "out of range: the deck has more than 2^31 lines; expected fewer");
    ++count_;
    if (end == text.size()) unended_.insert(count_);
    if (line.empty() || line.starts_with("**")) continue;
    last_line = count_;
    const bool is_keyword = line.front() == '*' || goes_on;
    goes_on = read_line(line, goes_on);
    if (!is_keyword || goes_on) continue;
    const std::size_t runs = runs_.size();
    take_inclusion(path, depth);
    if (runs_.size() > runs) runs_.push_back({path, count_ + 1, line_of_file + 1});
  }
  if (goes_on)
    fail(count_, fmt::format("missing continuation of *{}: its line ends in a comma, and the file ends here; expected "
                             "the rest of its parameters",
                             excerpt(cards_.back().keyword)));
  if (last_line > 0 && !cards_.empty()) ends_.push_back({last_line, cards_.size() - 1});
  open_.pop_back();
}

bool AbaqusDeck::read_line(std::string_view line, bool goes_on) {
  if (line.front() != '*' && !goes_on) {
    if (cards_.empty()) fail(count_, "invalid data before the first keyword; expected a line that begins with *");
    cards_.back().data.push_back({line, count_});
    return false;
  }
  if (line.front() == '*' && goes_on) {
    cards_.back().fault = "missing continuation: the line ends in a comma; expected more parameters, or no comma";
    goes_on = false;
  }
  if (!goes_on) cards_.push_back({.keyword = {}, .parameter = {}, .line = count_, .data = {}});
  add_card(goes_on ? line : line.substr(1), count_);
  return line.back() == ',';
}

void AbaqusDeck::take_inclusion(const std::string& path, int depth) {
  static constexpr std::array with_data{"NODE", "ELEMENT", "NSET", "ELSET"};
  const DeckCard& card = cards_.back();
  const bool whole = card.keyword == "INCLUDE";
  if (!whole && (std::ranges::find(with_data, card.keyword) == with_data.end() || !card.has("INPUT"))) return;
  std::vector<std::string> notes;
  if (whole) is_read(*this, card, notes);
  const std::string name = card.value("INPUT");
  const int line = card.line;
  if (name.empty()) fail(line, fmt::format("missing file of *{}; expected INPUT=FILE", excerpt(card.keyword)));
  if (whole) cards_.pop_back();  // what the file holds may go on the card before
  include(path, name, line, depth);
}

void AbaqusDeck::include(const std::string& from, const std::string& name, int line, int depth) {
  namespace fs = std::filesystem;
  constexpr int deepest = 32;         // each level is a file within another; Abaqus itself allows 5
  constexpr int most_files = 10'000;  // read one after the other, such as a file for each part of a large assembly
  const std::string path = (fs::path(from).parent_path() / name).lexically_normal().string();
  std::error_code unreadable;
  const std::string named =
      path == name || excerpt(name) != name ? fmt::format("'{}'", excerpt(name)) : fmt::format("'{}' ({})", name, path);
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
  for (const std::string_view field : fields({text, line})) {
    if (card.keyword.empty()) {
      card.keyword = spaced(field);
      if (card.keyword.empty()) break;
      continue;
    }
    const auto equals = field.find('=');
    const std::string name = compact(field.substr(0, equals));
    if (name.empty()) card.fault = "missing name of a parameter: a field is empty; expected NAME=VALUE";
    const std::string_view value = equals == std::string_view::npos ? "" : trimmed(field.substr(equals + 1));
    if (!card.parameter.emplace(name, value).second)
      card.fault = fmt::format("invalid parameter {}: given twice; expected it once", excerpt(name));
  }
  if (card.keyword.empty()) fail(line, "missing keyword after the star; expected *KEYWORD");
}

std::int64_t AbaqusDeck::integer(const DeckLine& line, std::string_view field, std::string_view what) const {
  const std::string_view digits = field.starts_with('+') ? field.substr(1) : field;
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size() ||
      (digits.size() < field.size() && digits[0] == '-'))
    fail(line.number, fmt::format("invalid value '{}'; expected {}", excerpt(field), what));
  return value;
}

double AbaqusDeck::real(const DeckLine& line, std::string_view field, std::string_view what) const {
  if (field.empty()) return 0;  // as Abaqus has it
  const bool plus = field.starts_with('+');
  std::string written(plus ? field.substr(1) : field);
  std::ranges::replace_if(
      written, [](char c) { return c == 'd' || c == 'D'; }, 'e');  // Fortran's exponents
  double value = 0;
  const auto [end, error] = std::from_chars(written.data(), written.data() + written.size(), value);
  if (error != std::errc{} || end != written.data() + written.size() || !std::isfinite(value) ||
      (plus && written.starts_with('-')))
    fail(line.number, fmt::format("invalid value '{}'; expected {}", excerpt(field), what));
  return value;
}

std::string AbaqusDeck::place(int line) const {
  const auto after = std::ranges::upper_bound(runs_, line, {}, &Run::first_number);
  const Run& run = after == runs_.begin() ? *after : *std::prev(after);
  return fmt::format("{}:{}", run.path, run.first_line + line - run.first_number);
}

void AbaqusDeck::fail(int line, const std::string& what) const {
  throw InputError(fmt::format("{}: {}", place(line), printable(what)));
}

}  // namespace brunt::io
