// SPDX-License-Identifier: Apache-2.0
// Unmatched brackets and quotes of a YAML text.
#pragma once
#include <optional>
#include <string>

#include "yaml_explain.hpp"

namespace brunt::scene {

struct BracketFaults {
  std::optional<YamlFault> quote;    ///< open at the end of the text
  std::optional<YamlFault> bracket;  ///< the first that is not closed, closes nothing, or has text behind its end
};

/// Follows strings, comments, block texts and nested brackets, but not keys and indentation: its result explains an
/// error of the parser but is no error by itself (except the quote).
BracketFaults scan_brackets(const std::string& text);

}  // namespace brunt::scene
