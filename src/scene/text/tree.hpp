// SPDX-License-Identifier: Apache-2.0
// A scene as nested text in which every piece has its place in the file: the result of parsing YAML.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/text/faults.hpp"

namespace brunt::scene {

struct Tree {
  enum class Kind { null, value, list, map } kind = Kind::null;
  std::string text{};               ///< of a value, as written, without quotes
  bool quoted = false;              ///< a value in quotes is text, never a number
  Place place{};                    ///< of its key, or of itself in a list
  std::vector<Tree> children{};     ///< of a list or a map
  std::vector<std::string> keys{};  ///< of a map: one a child

  [[nodiscard]] const Tree* find(std::string_view key) const;
  [[nodiscard]] Tree* find(std::string_view key);
};

/// Parses one YAML document. If a map has a key twice, this is a fault, and the first value is kept. Invalid syntax,
/// indentation by tabs, several documents and an empty text are faults, and the tree is then null.
Tree parse_yaml(const std::string& text, const std::string& file, Faults& faults);

/// Parses the value of an override: one YAML value in which every piece has the place `place`; empty, with a fault, for
/// invalid syntax.
std::optional<Tree> parse_value(const std::string& text, const Place& place, Faults& faults);

}  // namespace brunt::scene
