// SPDX-License-Identifier: Apache-2.0
// Explains to the user why a text is not valid YAML.
#pragma once
#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>

namespace brunt::scene {

struct YamlFault {
  int line = 0;      ///< from 1; 0: of the whole text
  int column = 0;    ///< from 1; 0: of the whole line
  std::string what;  ///< "...; expected ..."
};

/// A quote that remains open at the end of the text (the parser takes the rest of the text as its content).
std::optional<YamlFault> unclosed_quote(const std::string& text);

/// The likely cause of a syntax error: brackets, quotes, colons or indentation at the line where the parser stopped.
YamlFault explain(const std::string& text, const YAML::Exception& error);

}  // namespace brunt::scene
