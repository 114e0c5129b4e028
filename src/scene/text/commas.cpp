// SPDX-License-Identifier: Apache-2.0
#include "commas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "core/excerpt.hpp"

namespace brunt::scene {
namespace {

constexpr std::string_view without_comma = "a number has a decimal point and no comma";

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// "7,800" and "200,000,000", but not "0,900" or "1,5": three digits between commas, none leading with 0.
bool has_thousands(std::string_view text) {
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  const std::size_t first = text.find(',') - sign;
  if (first == 0 || first > 3 || text[sign] == '0') return false;
  for (std::size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',', comma + 1)) {
    std::size_t digits = 0;
    while (comma + 1 + digits < text.size() && is_digit(text[comma + 1 + digits])) ++digits;
    if (digits != 3) return false;
  }
  return true;
}

}  // namespace

bool is_number(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return !text.empty() && end == text.data() + text.size();
}

bool comma_in_value(const Key& key, std::string_view expected, IsValue is_value) {
  if (key.tree == nullptr || key.tree->kind != Tree::Kind::value) return false;
  const std::string& text = key.tree->text;
  std::string joined = text, pointed = text;
  std::erase(joined, ',');
  std::ranges::replace(pointed, ',', '.');
  if (joined.size() == text.size() || !(is_value(joined) || is_value(pointed))) return false;
  const bool thousands = has_thousands(text) && is_value(joined), decimal = is_value(pointed);
  std::string write;
  if (thousands || decimal)
    write = fmt::format(": write {}{}{}", thousands ? excerpt(joined) : "", thousands && decimal ? " or " : "",
                        decimal ? excerpt(pointed) : "");
  fault(key, fmt::format("invalid number '{}': {}{}; expected {}", excerpt(text), without_comma, write, expected));
  return true;
}

std::string comma_in_list(const Tree& list, std::size_t size) {
  if (size == 0 || list.children.size() <= size) return {};
  const bool digits = std::all_of(list.children.begin(), list.children.end(), [](const Tree& entry) {
    return entry.kind == Tree::Kind::value && is_number(entry.text) && entry.text.find('.') == std::string::npos;
  });
  return digits ? fmt::format(" (a comma separates the entries of a list: {})", without_comma) : "";
}

bool is_rest_of_number(const Tree& before, std::string_view name) {
  if (before.kind != Tree::Kind::value || before.quoted || before.text.empty()) return false;
  const std::string& text = before.text;
  const bool number = std::ranges::all_of(text, [](char c) { return is_digit(c) || c == ',' || c == '-' || c == '+'; });
  return number && is_digit(text.back()) && !name.empty() && is_digit(name.front());
}

}  // namespace brunt::scene
