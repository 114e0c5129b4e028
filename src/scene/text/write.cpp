// SPDX-License-Identifier: Apache-2.0
#include "scene/text/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "scene/text/overrides.hpp"

namespace brunt::scene {
namespace {

/// In double quotes, with everything escaped that could end or fold the text.
std::string in_quotes(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      quoted += std::string{'\\', c};
    else if (c == '\n')
      quoted += "\\n";
    else if (code < 0x20 || code == 0x7f)
      quoted += fmt::format("\\x{:02x}", code);
    else
      quoted += c;
  }
  return quoted + '"';
}

/// Letters, digits and signs that mean nothing in YAML, also between brackets.
bool is_plain(std::string_view text) {
  const auto harmless = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
           c == '+' || c == '-' || c == '/' || static_cast<unsigned char>(c) >= 0x80;
  };
  const bool dashes = text.find_first_not_of("-.") == std::string_view::npos;  // -, --- and ... are signs of YAML
  return !text.empty() && !dashes && std::ranges::all_of(text, harmless);
}

/// A value in quotes is never a number, so that a plain one stays plain where it can. It was written plainly: only
/// between brackets, or in another line, some of its signs mean something else.
std::string value_text(const Tree& value, bool in_brackets) {
  if (value.kind == Tree::Kind::null) return "~";
  if (value.quoted) return in_quotes(value.text);
  const bool one_line = value.text.find('\n') == std::string::npos && !value.text.empty();
  return is_plain(value.text) || (!in_brackets && one_line) ? value.text : in_quotes(value.text);
}

std::string key_text(const std::string& key) {
  return is_plain(key) ? key : in_quotes(key);
}

constexpr std::size_t long_line = 100;  // letters: what is longer takes a line for each of its pieces

/// In one line.
std::string flow(const Tree& tree, bool in_brackets) {
  if (tree.kind != Tree::Kind::list && tree.kind != Tree::Kind::map) return value_text(tree, in_brackets);
  std::string text;
  for (std::size_t k = 0; k < tree.children.size(); ++k) {
    if (k > 0) text += ", ";
    if (tree.kind == Tree::Kind::map) text += key_text(tree.keys[k]) + ": ";
    text += flow(tree.children[k], true);
  }
  return tree.kind == Tree::Kind::map ? '{' + text + '}' : '[' + text + ']';
}

void append_block(const Tree& tree, std::size_t indent, std::string& text);

/// What stands behind `key:` or `-`, with the end of the line.
void append_child(const Tree& child, std::size_t indent, std::string& text) {
  const std::string line = flow(child, false);
  if (child.children.empty() || line.size() <= long_line) {
    text += ' ' + line + '\n';
  } else {
    text += '\n';
    append_block(child, indent + 2, text);
  }
}

void append_block(const Tree& tree, std::size_t indent, std::string& text) {
  for (std::size_t k = 0; k < tree.children.size(); ++k) {
    text += std::string(indent, ' ') + (tree.kind == Tree::Kind::map ? key_text(tree.keys[k]) + ':' : "-");
    append_child(tree.children[k], indent, text);
  }
}

}  // namespace

std::string as_yaml(const Tree& tree) {
  if (tree.children.empty()) return flow(tree, false) + '\n';
  std::string text;
  append_block(tree, 0, text);
  return text;
}

std::string as_yaml(const std::string& text, const std::string& file_name, std::span<const std::string> overrides) {
  Faults faults;
  Tree tree = parse_yaml(text, file_name, faults);
  if (tree.kind == Tree::Kind::null) return {};
  apply_overrides(tree, overrides, faults);
  return as_yaml(tree);
}

}  // namespace brunt::scene
