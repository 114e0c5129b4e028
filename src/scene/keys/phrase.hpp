// SPDX-License-Identifier: Apache-2.0
// What the reference says of a value, from the objects by which it is read: its type and range, and its default.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/text/reader.hpp"

namespace brunt::scene {

/// A text that is read as it is: its type in the reference, and what messages expect.
struct Text {
  std::string_view type, expected;
};
inline bool read(const Key& key, std::string& target, const Text& text) {
  return read(key, target, text.expected);
}

/// A list of numbers of this range, one for each entry of an array.
struct Each {
  Range range;
  std::string_view expected;
};
template <std::size_t N>
bool read(const Key& key, std::array<double, N>& target, const Each& each) {
  return read(key, target, each.range, each.expected);
}

/// "`a`, `b`".
std::string quoted_list(const std::vector<std::string>& words);

// Types and ranges. The first argument is an example of the member that the value is read into.
std::string phrase(double, const Range& range);
std::string phrase(GlobalIndex, Count count);
std::string phrase(bool);
std::string phrase(const std::string&, const Text& text);
std::string phrase(const std::string&, Named kind);
std::string phrase(const Vec3&, Vector kind);
std::string phrase_of_list(std::size_t size, const Range& range);
template <std::size_t N>
std::string phrase(const std::array<double, N>&, const Each& each) {
  return phrase_of_list(N, each.range);
}
template <class Value>
std::string phrase(const Value&, const Choices<Value>& choices) {
  std::vector<std::string> words;
  for (const auto& [word, value] : choices.now) words.push_back(word);
  return quoted_list(words);
}
template <class Value, class... How>
std::string phrase(const std::optional<Value>&, const How&... how) {
  return phrase(Value{}, how...);
}

// Defaults, as a scene would give them. The further arguments are those of reading.
/// The shortest decimals: "0.05", "1.0e-3", "100000".
std::string shown(double number);
std::string shown(const Vec3& vector);
template <class... How>
std::string shown(double number, const How&...) {
  return shown(number);
}
template <class... How>
std::string shown(const Vec3& vector, const How&...) {
  return shown(vector);
}
inline std::string shown(bool yes) {
  return yes ? "`true`" : "`false`";
}
inline std::string shown(GlobalIndex number, Count) {
  return std::to_string(number);
}
template <class... How>
std::string shown(const std::string& text, const How&...) {
  return text.empty() ? "none" : "`" + text + "`";
}
template <std::size_t N>
std::string shown(const std::array<double, N>&, const Each&) {
  return "none";
}
template <class Value>
std::string shown(const Value& value, const Choices<Value>& choices) {
  for (const auto& [word, meant] : choices.now)
    if (meant == value) return "`" + word + "`";
  return "none";
}
template <class Value, class... How>
std::string shown(const std::optional<Value>& value, const How&... how) {
  return value ? shown(*value, how...) : "none";
}

}  // namespace brunt::scene
