// SPDX-License-Identifier: Apache-2.0
// Brackets and quotes of a YAML text, as far as they do not match.
#pragma once
#include <optional>
#include <string>

#include "yaml_explain.hpp"

namespace brunt::scene {

struct BracketFaults {
  std::optional<YamlFault> quote;    ///< open at the end of the text
  std::optional<YamlFault> bracket;  ///< the first that is not closed, closes nothing, or has text behind its end
};

/// Follows strings, comments, block texts and nested brackets; knows nothing of keys and indentation, so that what it
/// finds explains an error of the parser but is none by itself (but for the quote).
BracketFaults scan_brackets(const std::string& text);

}  // namespace brunt::scene
