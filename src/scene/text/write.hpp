// SPDX-License-Identifier: Apache-2.0
// A scene's tree as YAML: the record of the scene as run, including overrides.
#pragma once
#include <span>
#include <string>

#include "scene/text/tree.hpp"

namespace brunt::scene {

/// YAML that parses to the same tree. Short lists and maps are written on one line in brackets. Comments of the source
/// are lost.
[[nodiscard]] std::string as_yaml(const Tree& tree);

/// The scene of a text after its overrides, as YAML. Empty for an invalid scene.
[[nodiscard]] std::string as_yaml(const std::string& text, const std::string& file_name,
                                  std::span<const std::string> overrides);

}  // namespace brunt::scene
