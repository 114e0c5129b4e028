// SPDX-License-Identifier: Apache-2.0
// A scene as plain nested text, each piece with the place it came from: what is left of YAML once it is parsed.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brunt/scene/faults.hpp"

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

/// Parses one YAML document. A key given twice in a map is a fault and its first value stands; broken syntax, tabs as
/// indentation, several documents and an empty text are faults, after which the tree is null.
Tree parse_yaml(const std::string& text, const std::string& file, Faults& faults);

/// Parses the value of an override: one YAML value in which every piece stands at `place`; nothing and a fault if its
/// syntax is broken.
std::optional<Tree> parse_value(const std::string& text, const Place& place, Faults& faults);

}  // namespace brunt::scene
