// SPDX-License-Identifier: Apache-2.0
#include "yaml_brackets.hpp"

#include <fmt/format.h>

#include <vector>

namespace brunt::scene {
namespace {

class Scanner {
 public:
  explicit Scanner(const std::string& text) : text_(text) {}

  BracketFaults scan() {
    while (at_ < text_.size() && !found_.quote) {
      const char c = text_[at_];
      if (c == '\n') {
        new_line();
      } else if (is_blank(c)) {
        ++at_;
      } else if (c == '#' && after_blank()) {
        skip_line();
      } else if (token_) {
        start_token(c);
      } else {
        go_on(c);
      }
    }
    if (!open_.empty())
      report(open_.back().line, open_.back().column,
             fmt::format("missing closing bracket for '{}'; expected '{}' at the end of the list or map",
                         open_.back().bracket, partner(open_.back().bracket)));
    return std::move(found_);
  }

 private:
  struct Open {
    char bracket;
    int line, column;
  };

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  static bool is_end(char c) { return is_blank(c) || c == '\n'; }
  static char partner(char bracket) { return bracket == '[' ? ']' : '}'; }
  [[nodiscard]] char next(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\n'; }
  [[nodiscard]] bool after_blank() const { return at_ == 0 || is_end(text_[at_ - 1]); }
  [[nodiscard]] int column() const { return static_cast<int>(at_ - line_start_) + 1; }

  void report(int line, int column, std::string what) {
    if (!found_.bracket) found_.bracket = {line, column, std::move(what)};
  }

  void new_line() {
    ++at_;
    ++line_;
    line_start_ = at_;
    closed_ = '\0';
    if (open_.empty()) token_ = true;
  }
  void skip_line() {
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
  }

  /// At the first character of a key or value.
  void start_token(char c) {
    if (c == '"' || c == '\'') return skip_quoted(c);
    if (c == '[' || c == '{') {
      open_.push_back({c, line_, column()});
      ++at_;
    } else if (c == '&' || c == '!' || c == '*') {
      while (at_ < text_.size() && !is_end(text_[at_]) && !(!open_.empty() && is_flow_end(text_[at_]))) ++at_;
    } else if ((c == '-' || c == '?' || c == ':') && is_end(next(1))) {
      ++at_;
    } else if (open_.empty() && (c == '|' || c == '>')) {
      skip_block_text();
    } else if (is_flow_end(c)) {
      close(c);
    } else {
      token_ = false;
      ++at_;
    }
  }

  /// Within a plain text, or behind a quoted one or a bracket.
  void go_on(char c) {
    const bool colon = c == ':' && (is_end(next(1)) || (!open_.empty() && (closed_ != '\0' || is_flow_end(next(1)))));
    if (colon) {
      token_ = true;
      closed_ = '\0';
      ++at_;
    } else if (!open_.empty() && is_flow_end(c)) {
      close(c);
    } else {
      if (closed_ != '\0') report_text_behind(c);
      ++at_;
    }
  }

  void report_text_behind(char c) {
    const bool quote = closed_ == '"' || closed_ == '\'';
    if (c == ']' || c == '}')
      report(line_, column(),
             fmt::format("invalid closing bracket '{}': no bracket is open; expected one for each opening bracket", c));
    else if (quote)
      report(
          line_, column(),
          fmt::format("invalid text after the closing quote {0}; expected the whole text in quotes, {1}", closed_,
                      closed_ == '\'' ? "with each single quote in it doubled ('')" : "with each quote in it as \\\""));
    else
      report(
          line_, column(),
          fmt::format(
              "invalid text after the closing bracket '{}'; expected quotes around a text that begins with a bracket",
              closed_));
    closed_ = '\0';
  }

  static bool is_flow_end(char c) { return c == ',' || c == ']' || c == '}' || c == '[' || c == '{'; }

  void close(char c) {
    if (c == ',' || c == '[' || c == '{') {
      token_ = true;
      if (c == ',' || open_.empty()) {
        ++at_;
        token_ = c == ',' && !open_.empty();
      }
      closed_ = '\0';
      return;
    }
    ++at_;
    token_ = false;
    if (!open_.empty() && partner(open_.back().bracket) == c) {
      open_.pop_back();
      closed_ = c;
      return;
    }
    --at_;
    if (open_.empty()) {
      report(line_, column(),
             fmt::format("invalid closing bracket '{}': no bracket is open; expected one for each opening bracket", c));
    } else {
      report(line_, column(),
             fmt::format("invalid closing bracket '{}': '{}' of line {} is still open; expected '{}' first", c,
                         open_.back().bracket, open_.back().line, partner(open_.back().bracket)));
      open_.pop_back();
    }
    ++at_;
  }

  void skip_quoted(char quote) {
    // A quote that begins a line may go on a plain text of the line before: it is no fault by itself.
    const bool first_in_line = text_.find_first_not_of(" \t", line_start_) == at_;
    const YamlFault opened{line_, column(),
                           fmt::format("missing closing quote {}; expected {}text{}", quote, quote, quote)};
    for (++at_; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\n') {
        ++line_;
        line_start_ = at_ + 1;
      } else if (quote == '"' && c == '\\') {
        if (next(1) != '\n') ++at_;
      } else if (c == quote) {
        if (quote == '\'' && next(1) == quote) {
          ++at_;
          continue;
        }
        ++at_;
        token_ = false;
        closed_ = quote;
        return;
      }
    }
    if (!first_in_line) found_.quote = opened;
  }

  /// The lines behind | or > that are indented deeper than this one.
  void skip_block_text() {
    const auto indentation = [&](std::size_t from) { return text_.find_first_not_of(' ', from) - from; };
    const std::size_t own = indentation(line_start_);
    skip_line();
    while (at_ < text_.size()) {
      const std::size_t start = at_ + 1, first = text_.find_first_not_of(" \r", start);
      if (first == std::string::npos) {
        at_ = text_.size();
        return;
      }
      if (text_[first] != '\n' && indentation(start) <= own) return;
      ++line_;
      line_start_ = start;
      at_ = start;
      skip_line();
    }
  }

  const std::string& text_;
  std::size_t at_ = 0, line_start_ = 0;
  int line_ = 1;
  bool token_ = true;   ///< a key or value may begin here
  char closed_ = '\0';  ///< the quote or bracket that has just closed a value
  std::vector<Open> open_;
  BracketFaults found_;
};

}  // namespace

BracketFaults scan_brackets(const std::string& text) {
  return Scanner(text).scan();
}

}  // namespace brunt::scene
