// SPDX-License-Identifier: Apache-2.0
// Why a text is no YAML, in the words of who wrote it.
#pragma once
#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>

namespace brunt::scene {

struct YamlFault {
  int line = 0;      ///< from 1; 0: of the whole text
  int column = 0;    ///< from 1; 0: of the whole line
  std::string what;  ///< "...; expected: ..."
};

/// A quoted text that the end of the text leaves open (the parser takes the rest of the text for its content).
std::optional<YamlFault> unclosed_quote(const std::string& text);

/// The likely cause of a syntax error: brackets, quotes, colons or indentation at the line that the parser stopped at.
YamlFault explain(const std::string& text, const YAML::Exception& error);

}  // namespace brunt::scene
