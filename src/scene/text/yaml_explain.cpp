// SPDX-License-Identifier: Apache-2.0
#include "yaml_explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <vector>

#include "core/excerpt.hpp"
#include "core/types.hpp"
#include "yaml_brackets.hpp"

namespace brunt::scene {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

std::size_t indentation(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

bool is_empty(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos || line[first] == '#';
}

/// "density:7800": a key and its value without the blank between them.
std::optional<std::string> joined_value(const std::string& line) {
  static const std::regex joined(R"((?:^|[\s{,-])([A-Za-z_][A-Za-z0-9_]*):([^\s:/\\,\]}'"][^\s,\]}]*))");
  if (line.size() > 1000) return {};  // an expression's recursion grows with the line
  std::smatch found;
  if (!std::regex_search(line, found, joined)) return {};
  return fmt::format("missing space after the colon of '{0}:{1}'; expected {0}: {1}", excerpt(found[1].str()),
                     excerpt(found[2].str()));
}

/// "title: steel: a test": a value with a colon in it.
std::optional<std::string> colon_in_value(const std::string& line, int column) {
  const std::string before = line.substr(0, std::min(line.size(), static_cast<std::size_t>(std::max(column - 1, 0))));
  const std::size_t first = before.find(": ");
  if (first == std::string::npos) return {};
  const std::size_t start = before.find_last_of("{,-", first);
  std::string key = before.substr(start == std::string::npos ? 0 : start + 1, first - (start + 1));
  key.erase(0, key.find_first_not_of(' '));
  std::string value = line.substr(first + 2);
  value.erase(0, value.find_first_not_of(' '));
  value.erase(value.find_last_not_of(" \r") + 1);
  return fmt::format("invalid colon in the value of '{0}'; expected quotes around a text with a colon, {0}: \"{1}\"",
                     excerpt(key), excerpt(value));
}

class Explainer {
 public:
  Explainer(const std::string& text, const YAML::Exception& error) : lines_(lines_of(text)), error_(error) {
    line_ = std::clamp(error.mark.line, 0, static_cast<int>(lines_.size()) - 1);
    above_ = line_ - 1;
    while (above_ >= 0 && is_empty(nth(lines_, above_))) --above_;
  }

  [[nodiscard]] YamlFault fault() const {
    for (const int line : {line_, above_})
      if (line >= 0)
        if (const auto found = joined_value(at(line))) return {line + 1, 0, *found};
    return {line_ + 1, error_.mark.column + 1, cause()};
  }

 private:
  [[nodiscard]] const std::string& at(int line) const { return nth(lines_, line); }

  [[nodiscard]] std::optional<std::string> too_deep() const {
    if (above_ < 0 || indentation(at(line_)) <= indentation(at(above_))) return {};
    return fmt::format(
        "invalid indentation: deeper than line {}, whose key already has a value; expected all keys of a map in one "
        "column",
        above_ + 1);
  }

  [[nodiscard]] std::string cause() const {
    const std::string& said = error_.msg;
    const std::string& line = at(line_);
    const int column = error_.mark.column + 1;
    if (said == "illegal map value") {
      if (const auto found = colon_in_value(line, column)) return *found;
      if (const auto found = too_deep()) return *found;
      return "invalid colon: no key stands before it; expected key: value, and quotes around a text with a colon";
    }
    if (said == "end of map not found" || said == "end of sequence not found") {
      if (const auto found = too_deep()) return *found;
      return "invalid indentation: the line belongs to no map or list above it; expected the entries of a map or list "
             "in one column, each as key: value or - value";
    }
    if (said == "end of map flow not found" || said == "end of sequence flow not found")
      return "missing comma or closing bracket before this column; expected {a: 1, b: 2} or [1, 2]";
    if (said == "illegal block entry")
      return "invalid list entry '- ' at this place; expected each entry on its own line, or [a, b]";
    if (said == "unknown token")
      return fmt::format("invalid first character '{}' of a value; expected quotes around such a text",
                         line.substr(std::min(line.size(), static_cast<std::size_t>(column - 1)), 1));
    if (said.starts_with("the referenced anchor is not defined"))
      return "unknown anchor of an alias ('*'); expected quotes around a text with '*'";
    if (said.starts_with("unknown escape character"))
      return said + ", in double quotes; expected single quotes around a text with backslashes, or \\\\";
    return said + "; expected: YAML 1.2";
  }

  std::vector<std::string> lines_;
  const YAML::Exception& error_;
  int line_ = 0, above_ = -1;
};

}  // namespace

std::optional<YamlFault> unclosed_quote(const std::string& text) {
  return scan_brackets(text).quote;
}

YamlFault explain(const std::string& text, const YAML::Exception& error) {
  if (error.mark.is_null()) return {0, 0, error.msg + "; expected: YAML 1.2"};
  const bool of_brackets = error.msg.find("flow") != std::string::npos || error.msg == "end of map not found" ||
                           error.msg == "illegal map value" || error.msg == "end of sequence not found";
  if (of_brackets)
    if (const std::optional<YamlFault> bracket = scan_brackets(text).bracket)
      if (bracket->line <= error.mark.line + 1) return *bracket;
  return Explainer(text, error).fault();
}

}  // namespace brunt::scene
